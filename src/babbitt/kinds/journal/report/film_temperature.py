"""Figures of a thermal film: temperature over the bore, through film and bush, along the middle, heat split."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.film.field import FilmField, supply_patches
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.temperature_field import (
    bush_temperature,
    centre_line,
    temperature_over,
    temperature_through,
)
from babbitt.kinds.journal.report import film_maps
from babbitt.report import shading
from babbitt.report.drawing import GREY, INK, Array, Sheet, arrow
from babbitt.report.us_words import numbers_in_us_units
from babbitt.reynolds.heat.heat_model import BushRing
from babbitt.reynolds.heat.thermal_solution import ThermalFilm

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

FILM_AS_DRAWN = 0.16
"""Thickness of the film as drawn, in radii of the bore."""
NOTHING = 1e-6
"""Share of the heat below which a path counts as taking none."""
PLACES, DEPTHS = 361, 24
"""Around the bore and into bush and housing, of the drawing through both."""


def unrolled(case: FilmCase, thermal: ThermalFilm, field: FilmField) -> Figure:
    """Mean temperature across the gap over angle and width, and across the gap in the middle of the width."""
    figure, axes = Sheet(166.0, 92.0, 2, 1, left=12.0, between=7.0).panels(sharex=True)
    figure.subplots_adjust(top=1.0 - 6.0 / 92.0, right=1.0 - 17.0 / 166.0)
    top, bottom = axes[0][0], axes[1][0]
    degrees, place = np.degrees(field.theta), thermal.hot_spot[1]
    shown = temperature_over(thermal, field) - ZERO_CELSIUS
    through = temperature_through(thermal, field.theta, place) - ZERO_CELSIUS
    scale = shading.levels_of(np.concatenate((shown.ravel(), through.ravel())))
    _over_bore(top, case, thermal, field, scale)
    across = np.concatenate(([0.0], thermal.layers, [1.0]))
    lines = shading.shaded(bottom, degrees, across, through, scale)
    bottom.clabel(lines, np.asarray(lines.levels)[::2], fontsize=6, fmt="%g", inline_spacing=2)
    _cover_grooves(bottom, thermal, field, place)
    bottom.set_ylabel("bush ←  $y/h$  → journal")
    bottom.set_ylim(0.0, 1.0)
    bottom.set_yticks([0.0, 0.5, 1.0])
    _hot_spot(top, bottom, thermal, field)
    film_maps.degrees(top, field)
    bottom.set_xlabel("θ in °, counter-clockwise from $+x$")
    film_maps.says(bottom, f"temperature in °C, across the gap {describe_place(thermal)}")
    film_maps.rotation(top, case)
    shading.bar(figure, (top, bottom), scale, "temperature in °C")
    return figure


def temperature_map(panel: Axes, case: FilmCase, thermal: ThermalFilm, field: FilmField) -> None:
    """Mean temperature across the gap over the unrolled bore, on axes that are given."""
    _over_bore(panel, case, thermal, field, shading.levels_of(temperature_over(thermal, field) - ZERO_CELSIUS))
    film_maps.degrees(panel, field)


def _over_bore(panel: Axes, case: FilmCase, thermal: ThermalFilm, field: FilmField, scale: shading.Scale) -> None:
    shown = temperature_over(thermal, field) - ZERO_CELSIUS
    lines = shading.shaded(panel, np.degrees(field.theta), film_maps.across(field.z), shown, scale)
    film_maps.level_names(panel, lines, thermal.film.film, field)
    film_maps.dress(panel, case, thermal.film, field)
    panel.set_ylabel(f"$z$ in {film_maps.LENGTH.display.label}")
    film_maps.says(panel, "temperature in °C, mean across the gap")


def describe_place(thermal: ThermalFilm) -> str:
    """Where along the width the cut through the hottest place lies, in words."""
    place = thermal.hot_spot[1]
    middle = thermal.axial_positions.size == 1 or place == thermal.axial_positions[
        int(np.abs(thermal.axial_positions).argmin())
    ]  # fmt: skip
    sides = "z = ±" if thermal.axial_positions[0] >= -1e-12 else "z = "
    return "in the middle of the width" if middle else f"at {sides}{1e3 * place:.0f} mm, where it is hottest"


def _hot_spot(top: Axes, bottom: Axes, thermal: ThermalFilm, field: FilmField) -> None:
    line, column, layer = np.unravel_index(int(thermal.temperature.argmax()), thermal.temperature.shape)
    angle = field.theta[0] + (thermal.film.angles.ravel()[line] - field.theta[0]) % (2.0 * math.pi)
    said = numbers_in_us_units(f"{thermal.maximum_temperature - ZERO_CELSIUS:.1f}", "°C")
    shading.point(bottom, math.degrees(angle), thermal.layers[layer], said)
    if thermal.axial_positions.size > 1:
        shading.point(
            top, math.degrees(angle), float(film_maps.across(thermal.axial_positions)[column]), f"hottest {said}"
        )


def _cover_grooves(panel: Axes, thermal: ThermalFilm, field: FilmField, place: float) -> None:
    """Supplies at a place of the width, in which there is no gap, with their mixing temperature."""
    for patch, mixed in zip(supply_patches(thermal.film.film), thermal.groove_temperatures, strict=True):
        if not patch.z[0] <= place <= patch.z[1]:
            continue
        first = field.theta[0] + (patch.theta[0] - field.theta[0]) % (2.0 * math.pi)
        for start in (first, first - 2.0 * math.pi):
            panel.axvspan(
                *np.degrees((start, start + patch.theta[1] - patch.theta[0])), facecolor="white", edgecolor=INK,
                linewidth=0.6, zorder=4,
            )  # fmt: skip
        middle = math.degrees(first + 0.5 * (patch.theta[1] - patch.theta[0]))
        panel.annotate(
            numbers_in_us_units(f"{mixed - ZERO_CELSIUS:.1f}", "°C"), (middle, 0.5), fontsize=7, ha="center",
            va="center", rotation=90, zorder=5, annotation_clip=True,
        )  # fmt: skip


def through(case: FilmCase, thermal: ThermalFilm, bush: BushRing | None) -> Figure:
    """Film and bush along the shaft, each with its temperature; the film is drawn thick."""
    from matplotlib.patches import Circle

    figure, ((panel,),) = Sheet(81.0, 90.0, left=2.0, bottom=8.0).panels()
    panel.set_aspect("equal")
    panel.axis("off")
    theta = np.linspace(0.0, 2.0 * math.pi, PLACES)
    inside = temperature_through(thermal, theta, thermal.hot_spot[1]) - ZERO_CELSIUS
    radii = 1.0 - FILM_AS_DRAWN * np.concatenate(([0.0], thermal.layers, [1.0]))
    reach = 1.12
    shades, levels = shading.levels_of(inside)
    if bush is not None:
        real = np.unique(np.concatenate([np.linspace(a, b, DEPTHS) for a, b in _pairs(bush.radii)]))
        outer = bush_temperature(bush, thermal, theta, real) - ZERO_CELSIUS
        shades, levels = shading.levels_of(np.concatenate((inside, outer), axis=1))
        _ring(panel, theta, real / bush.radii[0], outer, shades, levels)
        for edge in bush.radii[1:]:
            panel.add_patch(Circle((0.0, 0.0), edge / bush.radii[0], fill=False, linewidth=0.5, edgecolor=INK))
        reach = 1.06 * bush.radii[-1] / bush.radii[0]
    drawn = _ring(panel, theta, radii, inside, shades, levels)
    panel.add_patch(Circle((0.0, 0.0), 1.0, fill=False, linewidth=0.9, edgecolor=INK))
    panel.add_patch(Circle((0.0, 0.0), radii[-1], facecolor="0.97", linewidth=0.9, edgecolor=INK))
    _inner_words(panel, case, thermal, radii[-1])
    _supplies(panel, thermal, thermal.hot_spot[1])
    _spot(panel, thermal)
    panel.set(xlim=(-reach, reach), ylim=(-reach, reach))
    bar = figure.colorbar(drawn, ax=panel, orientation="horizontal", fraction=0.05, pad=0.02, aspect=32)
    bar.set_label("temperature in °C")
    bar.outline.set_linewidth(0.4)
    return figure


def _pairs(radii: tuple[float, ...]) -> list[tuple[float, float]]:
    return list(pairwise(radii))


def _ring(
    panel: Axes, theta: Array, radii: Array, shown: Array, shades: list[str],
    levels: Array,
) -> ScalarMappable:  # fmt: skip
    x, y = np.outer(np.cos(theta), radii), np.outer(np.sin(theta), radii)
    drawn = panel.contourf(x, y, shown, levels=levels, colors=shades, extend="both")
    panel.contour(x, y, shown, levels=levels, colors="0.25", linewidths=0.25)
    return drawn


def _inner_words(panel: Axes, case: FilmCase, thermal: ThermalFilm, radius: float) -> None:
    panel.annotate(
        f"journal\n{thermal.journal_temperature - ZERO_CELSIUS:.1f} °C", (0.0, 0.25 * radius), ha="center",
        va="center", fontsize=7.5,
    )  # fmt: skip
    c, s = math.cos(case.load_angle), math.sin(case.load_angle)
    arrow(panel, (0.85 * radius * c, 0.85 * radius * s), (0.3 * radius * c, 0.3 * radius * s))
    away = case.load_angle + math.pi
    angles = away + case.rotation.sense * np.linspace(-0.5, 0.5, 25)
    panel.plot(0.82 * radius * np.cos(angles), 0.82 * radius * np.sin(angles), color=INK, linewidth=0.7)
    tip, tail = ((0.82 * radius * math.cos(a), 0.82 * radius * math.sin(a)) for a in (angles[-1], angles[-4]))
    arrow(panel, tip, tail, size=6.0)


def _supplies(panel: Axes, thermal: ThermalFilm, place: float) -> None:
    """Supplies at a place of the width as notches."""
    for patch in supply_patches(thermal.film.film):
        if patch.z[0] <= place <= patch.z[1]:
            angles = np.linspace(*patch.theta, 30)
            ends = (1.0 - FILM_AS_DRAWN, 1.1)
            x = np.concatenate((ends[0] * np.cos(angles), ends[1] * np.cos(angles[::-1])))
            y = np.concatenate((ends[0] * np.sin(angles), ends[1] * np.sin(angles[::-1])))
            panel.fill(x, y, facecolor="white", edgecolor=INK, linewidth=0.6, zorder=4)


def _spot(panel: Axes, thermal: ThermalFilm) -> None:
    line, _, layer = np.unravel_index(int(thermal.temperature.argmax()), thermal.temperature.shape)
    angle, out = thermal.film.angles.ravel()[line], 1.0 - FILM_AS_DRAWN * thermal.layers[layer]
    c, s = math.cos(angle), math.sin(angle)
    panel.plot([out * c], [out * s], "+", color=INK, markersize=7, markeredgewidth=1.0, zorder=6)
    panel.annotate(
        f"{thermal.maximum_temperature - ZERO_CELSIUS:.1f} °C", (out * c, out * s), xytext=(14 * c, 14 * s),
        textcoords="offset points", fontsize=7.5, ha="center", va="center", zorder=6,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8},
    )  # fmt: skip


def along(case: FilmCase, thermal: ThermalFilm, field: FilmField) -> Figure:
    """Pressure and temperatures along the middle of the width, grooves shown."""
    figure, axes = Sheet(166.0, 78.0, 2, 1, between=6.0).panels(sharex=True)
    figure.subplots_adjust(top=1.0 - 6.0 / 78.0)
    upper, lower = axes[0][0], axes[1][0]
    line = centre_line(thermal, field)
    places = np.degrees(line.theta)
    upper.plot(places, 1e-6 * line.pressure, color=INK)
    upper.set_ylabel("$p$ in MPa")
    for values, how, name in (
        (line.highest, "-", "hottest across the gap"),
        (line.mean, "--", "mean across the gap"),
        (line.bush, ":", "bore"),
    ):
        lower.plot(places, values - ZERO_CELSIUS, how, color=INK, label=name)
    lower.axhline(thermal.journal_temperature - ZERO_CELSIUS, color=GREY, linewidth=0.7, label="journal")
    lower.axhline(thermal.supply_temperature - ZERO_CELSIUS, color=GREY, linewidth=0.7, linestyle=(0, (1, 3)),
                  label="fresh oil")  # fmt: skip
    lower.margins(y=0.08)
    lower.set_ylabel("$T$ in °C")
    lower.legend(frameon=False, fontsize=7, ncols=5, loc="lower left", bbox_to_anchor=(0.0, 1.0), borderpad=0.0)
    for patch in supply_patches(thermal.film.film):
        if patch.z[0] <= 0.0 <= patch.z[1]:
            first = field.theta[0] + (patch.theta[0] - field.theta[0]) % (2.0 * math.pi)
            for start in (first, first - 2.0 * math.pi):
                for panel in (upper, lower):
                    panel.axvspan(*np.degrees((start, start + patch.theta[1] - patch.theta[0])), color="0.9",
                                  zorder=0)  # fmt: skip
    film_maps.degrees(upper, field)
    film_maps.rotation(upper, case)
    film_maps.load_line(upper, case)
    lower.axvline(math.degrees(case.load_angle), color=GREY, linewidth=0.8, linestyle=(0, (6, 2, 1, 2)))
    lower.set_xlabel("θ in °, counter-clockwise from $+x$")
    return figure


def split(thermal: ThermalFilm) -> Figure:
    """Where the heat goes, as shares of what is generated in the film."""
    figure, ((panel,),) = Sheet(81.0, 34.0, left=16.0).panels()
    heat = thermal.heat
    least = NOTHING * heat.dissipation
    taken = (("oil", heat.oil), ("bush", heat.bush), ("journal", heat.journal))
    rows = [(name, power if abs(power) > least else 0.0) for name, power in taken]
    shares = [100.0 * power / heat.dissipation for _, power in rows]
    places = np.arange(len(rows))[::-1]
    panel.barh(places, shares, color="0.72", edgecolor=INK, linewidth=0.6, height=0.6)
    panel.set_yticks(places, [name for name, _ in rows])
    panel.set_xlim(min(0.0, 1.25 * min(shares)), 1.32 * max(shares))
    panel.axvline(0.0, color=INK, linewidth=0.5)
    if 0.0 <= min(shares) <= max(shares) <= 100.0:  # what stands beside the bars is no share
        panel.set_xticks(range(0, 101, 20))
    for place, share, (_, power) in zip(places, shares, rows, strict=True):
        panel.annotate(
            f"{1e-3 * power:.3g} kW", (max(share, 0.0), place), xytext=(3, 0), textcoords="offset points",
            fontsize=7.5, va="center",
        )  # fmt: skip
    panel.set_xlabel(f"share of {1e-3 * heat.dissipation:.3g} kW in %")
    return figure
