"""Pads of a thrust bearing seen along the shaft: loads as lengths, pressure as contours."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.thrust.peak import between_nodes
from babbitt.kinds.thrust.sharing import Share
from babbitt.report import shading
from babbitt.report.drawing import GREY, INK, Array, Sheet
from babbitt.report.us_words import numbers_in_us_units

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RING = 0.55
"""Radius of the ring from which loads are drawn, over the largest load."""


def pads_polar(share: Share, dynamic: Array | None) -> Figure:
    """Loads of the pads outward from a ring; with dynamic bounds as bars about them."""
    figure, ((panel,),) = Sheet(81.0, 76.0, left=3.0, bottom=3.0).panels(subplot_kw={"projection": "polar"})
    bearing, loads = share.bearing, share.loads / 1e3
    largest = float((loads if dynamic is None else loads + dynamic / 1e3).max())
    base = RING * largest
    width = 0.82 * bearing.pad.extent
    panel.bar(bearing.angles, loads, width=width, bottom=base, facecolor="0.85", edgecolor=INK, linewidth=0.7)
    if dynamic is not None:
        for angle, load, moved in zip(bearing.angles, loads, dynamic / 1e3, strict=True):
            panel.plot([angle, angle], [base + load - moved, base + load + moved], color=INK, linewidth=1.6)
            for end in (load - moved, load + moved):
                span = np.linspace(-0.25, 0.25, 9) * width + angle
                panel.plot(span, np.full(9, base + end), color=INK, linewidth=0.9)
    around = np.linspace(0.0, math.tau, 181)
    panel.plot(around, np.full(181, base + share.mean_load / 1e3), color=GREY, linewidth=0.7)
    panel.plot(around, np.full(181, base), color=INK, linewidth=0.7)
    for number, angle in enumerate(bearing.angles, start=1):
        # one above the other, since side by side they read as one number on the horizontal
        place, ink = (angle, 0.73 * base), {"ha": "center", "textcoords": "offset points"}
        panel.annotate(f"{number}", place, xytext=(0, 0.5), va="bottom", fontsize=7, **ink)
        panel.annotate(
            numbers_in_us_units(f"{loads[number - 1]:.3g}", "kN"),
            place,
            xytext=(0, -0.5),
            va="top",
            fontsize=6,
            color="0.3",
            **ink,
        )
    panel.annotate("kN", (0.0, 0.0), ha="center", va="center", fontsize=6, color="0.3")
    turn = bearing.sense * np.linspace(0.3, 1.2, 30) + math.pi / 2
    panel.plot(turn, np.full(30, 0.36 * base), color=INK, linewidth=0.8)
    panel.annotate(
        "",
        (turn[-1], 0.36 * base),
        xytext=(turn[-3], 0.36 * base),
        arrowprops={"arrowstyle": "-|>", "linewidth": 0.8, "mutation_scale": 7.0, "color": INK},
    )
    if bearing.tilt.offset > 0.0:
        at = bearing.tilt.direction
        edge = 1.10 * (base + largest)
        panel.plot([at, at], [base, edge], color=INK, linestyle=":", linewidth=0.8, zorder=1)
        panel.annotate(
            "closest",
            (at, edge),
            ha="center",
            va="center",
            fontsize=6,
            color="0.3",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
        )
    panel.set_ylim(0.0, 1.14 * (base + largest))
    panel.axis("off")
    return figure


def pad_pressure(share: Share) -> Figure:
    """Contours of pressure on the pad that carries most, in the plane of the pad."""
    state = share.states[int(share.loads.argmax())]
    pad, film = state.pad, state.film
    figure, ((panel,),) = Sheet(81.0, 70.0, left=2.0, bottom=2.0).panels()
    panel.set_aspect("equal")
    panel.axis("off")
    sense = share.bearing.sense
    turned = film.theta[:, None] - 0.5 * pad.extent + math.pi / 2
    radius, pressure = between_nodes(film.radius, state.pressure() / 1e6)
    radius = 1e3 * radius[None, :]
    x, y = sense * radius * np.cos(turned), radius * np.sin(turned)
    levels = np.linspace(0.0, float(pressure.max()), 9)[1:-1]
    lines = panel.contour(x, y, pressure, levels=levels, colors="0.25", linewidths=0.6)
    panel.clabel(lines, fmt=lambda value: numbers_in_us_units(f"{value:.2g}", "MPa"), fontsize=6, inline_spacing=2)
    for edge in ((x[0], y[0]), (x[-1], y[-1]), (x[:, 0], y[:, 0]), (x[:, -1], y[:, -1])):
        panel.plot(*edge, color=INK, linewidth=0.9)
    i, j = np.unravel_index(int(pressure.argmax()), pressure.shape)
    panel.plot(x[i, j], y[i, j], "+", color=INK, markersize=6)
    angle = pad.pivot_angle - 0.5 * pad.extent + math.pi / 2
    panel.plot(
        sense * 1e3 * pad.pivot_radius * math.cos(angle),
        1e3 * pad.pivot_radius * math.sin(angle),
        "o",
        color=INK,
        markerfacecolor="white",
        markersize=4,
    )
    for side, text in ((0, "leading"), (-1, "trailing")):
        k = pressure.shape[1] // 2
        ha = "left" if x[side, k] > 0.0 else "right"
        offset = 5 if ha == "left" else -5
        panel.annotate(
            text,
            (x[side, k], y[side, k]),
            xytext=(offset, 0),
            textcoords="offset points",
            fontsize=7,
            ha=ha,
            va="center",
        )
    panel.annotate(
        f"largest {state.maximum_pressure / 1e6:.3g} MPa",
        (0.0, float(y.min())),
        xytext=(0, -4),
        textcoords="offset points",
        fontsize=7,
        ha="center",
        va="top",
    )
    panel.margins(0.16, 0.14)
    panel.set_ylim(float(y.min()) - 16.0 * (float(y.max()) - float(y.min())) / 100.0, None)
    return figure


def pad_temperature(share: Share) -> Figure:
    """Temperature across the gap along the hottest pad, on its hottest radius."""
    state = max(share.states, key=lambda one: 0.0 if one.heat is None else one.heat.maximum)
    heat, film = state.heat, state.film
    assert heat is not None
    figure, ((panel,),) = Sheet(81.0, 52.0, left=11.0).panels()
    _, column, _ = np.unravel_index(int(heat.temperature.argmax()), heat.temperature.shape)
    celsius = heat.temperature[:, column] - ZERO_CELSIUS
    across = np.concatenate(([0.0], heat.layers, [1.0]))
    shown = np.concatenate((celsius[:, :1], celsius, celsius[:, -1:]), axis=1)
    degrees = np.degrees(film.theta)
    lines = shading.shaded(panel, degrees, across, shown)
    panel.clabel(
        lines,
        np.asarray(lines.levels)[::2],
        fontsize=6,
        fmt=lambda value: numbers_in_us_units(f"{value:g}", "°C"),
        inline_spacing=2,
    )
    line, layer = np.unravel_index(int(shown.argmax()), shown.shape)
    said = numbers_in_us_units(f"{heat.maximum - ZERO_CELSIUS:.1f}", "°C")
    shading.point(panel, float(degrees[line]), float(across[layer]), said)
    panel.set_xlabel("angle from the leading edge in °")
    panel.set_ylabel("pad  ←  $y/h$  →  collar")
    panel.set_ylim(0.0, 1.0)
    panel.set_yticks([0.0, 0.5, 1.0])
    return figure
