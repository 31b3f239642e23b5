"""Curves of a film: locus of the journal, coefficients over speed and load number."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.core.quantities import AXES, QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.journal.film.field import clearance_outline
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.report.plots import plain_ticks
from babbitt.kinds.journal.study.film_points import FilmPoints
from babbitt.report.drawing import GREY, INK, PALE, Array, Sheet, arrow, axis_label, mark, mathematics

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LABEL = (0.27, 0.11)
"""Room that the name of a load takes, as shares of half the width and height of the picture."""

OFFSET = 0.07
"""Distance of a name from its place, as a share of half the width of the picture."""

ROOM_FOR_A_NAME = 0.13
"""Room to the right of the curves for each name that stands in a line there, as a share of their length."""
LINES: dict[str, dict[str, Any]] = {
    "xx": {"color": INK, "linestyle": "-"},
    "yy": {"color": INK, "linestyle": (0, (6, 1.5))},
    "xy": {"color": GREY, "linestyle": "-"},
    "yx": {"color": GREY, "linestyle": (0, (6, 1.5))},
}
"""Direct coefficients in ink, cross-coupled ones in grey; the second of each pair dashed."""


def locus(case: FilmCase, state: FilmState, by_load: FilmPoints, by_speed: FilmPoints) -> Figure:
    """Journal centre over the load and over the speed, inside the room that the bore leaves it."""
    from matplotlib.ticker import MaxNLocator

    figure, ((panel,),) = Sheet(81.0, 67.0, left=11.0, bottom=9.5).panels()
    panel.set_aspect("equal")
    film = state.solution.film
    directions = np.linspace(0.0, 2.0 * math.pi, 361)
    room = clearance_outline(film, directions) / film.clearance
    panel.plot(room * np.cos(directions), room * np.sin(directions), color=INK, linewidth=0.8)
    panel.plot([0.0], [0.0], "+", color=GREY, markersize=6, markeredgewidth=0.8)
    centres, others = by_load.position / film.clearance, by_speed.position / film.clearance
    panel.plot(centres[:, 0], centres[:, 1], color=INK)
    panel.plot(others[:, 0], others[:, 1], color=PALE, linewidth=4.0, zorder=1.5, solid_capstyle="butt")
    here = state.solution.position / film.clearance
    reach = 1.04 * float(np.abs(np.concatenate((room * np.cos(directions), room * np.sin(directions)))).max())
    _tick_loads(panel, by_load.loads / state.load, centres, reach, room)
    mark(panel, here[0], here[1])
    tail = -0.3 * math.cos(case.load_angle), -0.3 * math.sin(case.load_angle)
    arrow(panel, (0.2 * tail[0], 0.2 * tail[1]), tail, colour=GREY)
    panel.annotate("load", tail, xytext=(3, 0), textcoords="offset points", fontsize=7, color="0.3", va="center")
    panel.set(xlim=(-reach, reach), ylim=(-reach, reach), xlabel="$x/c$", ylabel="$y/c$")
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_major_locator(MaxNLocator(5))
        axis.set_major_formatter("{x:g}")
    return figure


def _tick_loads(panel: Axes, shares: Array, centres: Array, reach: float, room: Array) -> None:
    """Name some loads along the locus, as multiples of that of the operating point, inside the bore."""
    last: Array | None = None
    for wanted in (1.0, 8.0, 4.0, 2.0, 0.5, 0.25, 0.1, 0.02):
        if not shares.min() * 0.999 <= wanted <= shares.max() * 1.001:
            continue
        at = np.array([np.interp(math.log(wanted), np.log(shares), column) for column in centres.T])
        if last is not None and (np.abs(last - at) < np.multiply(LABEL, reach)).all(axis=1).any():
            continue  # its name would lie on another
        last = at[None, :] if last is None else np.concatenate((last, at[None, :]))
        if wanted != 1.0:
            panel.plot(*at, "o", markersize=2.6, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.7)
        aside = _aside(shares, centres, wanted)
        if _beyond(room, at + OFFSET * reach * aside, aside, reach) > max(
            _beyond(room, at - OFFSET * reach * aside, -aside, reach), 0.0
        ):
            aside = -aside
        text = "$F$" if wanted == 1.0 else f"{wanted:g} $F$"
        panel.annotate(
            text, tuple(at), xytext=tuple(5.5 * aside), textcoords="offset points", fontsize=7, va="center",
            ha="left" if aside[0] > 0.0 else "right", bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.3},
        )  # fmt: skip


def _beyond(room: Array, at: Array, aside: Array, reach: float) -> float:
    """How far a name beside a place lies beyond the bore, over the clearance; negative inside."""
    width, height = np.multiply(LABEL, reach)
    corners = at + np.array([(math.copysign(width, aside[0]), up * 0.5 * height) for up in (-1.0, 1.0)])
    directions = np.linspace(0.0, 2.0 * math.pi, room.size)
    free = np.interp(np.arctan2(corners[:, 1], corners[:, 0]) % (2.0 * math.pi), directions, room)
    return float((np.hypot(*corners.T) - free).max())


def _aside(shares: Array, centres: Array, share: float) -> Array:
    """Direction across the locus at a load, to the right of the picture."""
    place = int(np.clip(np.searchsorted(shares, share), 1, shares.size - 2))
    along = centres[place + 1] - centres[place - 1]
    across = np.array([-along[1], along[0]]) / max(math.hypot(*along), 1e-12)
    return np.asarray(across if across[0] > 0.0 else -across)


def coefficients(state: FilmState, result: Result, by_speed: FilmPoints) -> Figure:
    """Stiffness and damping over the speed, and without dimension over the load number."""
    figure, axes = Sheet(166.0, 94.0, 2, 2, across=15.0, between=11.0).panels()
    film, load = state.solution.film, state.load
    rpm = QUANTITIES["angular_speed"].display.scale
    units = film.clearance / load, film.clearance * by_speed.speeds / load
    for column, (name, symbol) in enumerate((("stiffness", "K"), ("damping", "C"))):
        shown = QUANTITIES[name]
        values: Array = getattr(by_speed, name)
        here = result.arrays[name]
        top, bottom = axes[0][column], axes[1][column]
        _family(top, rpm * by_speed.speeds, values * shown.display.scale, symbol)
        unit = np.broadcast_to(units[column], by_speed.speeds.shape)[:, None, None]
        _family(bottom, by_speed.sommerfeld_number, values * unit, symbol)
        own = units[0] if column == 0 else film.clearance * abs(film.angular_speed) / load
        for place, axis in enumerate(AXES):
            value = here[place // 2][place % 2]
            mark_small(top, rpm * abs(film.angular_speed), value * shown.display.scale, axis)
            mark_small(bottom, state.solution.sommerfeld_number, value * own, axis)
        top.set(xlabel="$N$ in rpm", ylabel=axis_label(shown))
        bottom.set(xlabel=axis_label(QUANTITIES["sommerfeld_number"]),
                   ylabel="$K\\,c/F$" if column == 0 else "$C\\,c\\,ω/F$")  # fmt: skip
    return figure


def _family(panel: Axes, x: Array, values: Array, symbol: str) -> None:
    """Four coefficients over one abscissa, linear above zero and below, each named at its right end."""
    order = np.argsort(x)
    x = x[order]
    panel.set_xscale("log")
    panel.axhline(0.0, color=PALE, linewidth=0.5, zorder=0)
    ends = []
    for place, axis in enumerate(AXES):
        curve = values[order, place // 2, place % 2]
        panel.plot(x, curve, **LINES[axis])
        ends.append((float(curve[-1]), axis))
    low, high = _focus(values)
    panel.set_ylim(low, high)
    apart = 0.08 * (high - low)
    groups = _grouped([(min(max(value, low), high), axis) for value, axis in sorted(ends)], 0.25 * apart)
    names = max(len(axes) for _, axes in groups)
    panel.set_xlim(x[0], x[-1] * (x[-1] / x[0]) ** (ROOM_FOR_A_NAME * names))
    plain_ticks(panel.xaxis)
    for level, (_, axes) in zip(_spaced([value for value, _ in groups], apart), groups, strict=True):
        panel.annotate(
            ", ".join(mathematics(f"{symbol}_{axis}") for axis in axes), (x[-1], level), xytext=(2, 0),
            textcoords="offset points", fontsize=7, va="center", color=str(LINES[axes[0]]["color"]),
            annotation_clip=False,
        )  # fmt: skip


def _grouped(ends: list[tuple[float, str]], near: float) -> list[tuple[float, list[str]]]:
    """Curves that end at the same place share a name."""
    groups: list[tuple[float, list[str]]] = []
    for value, axis in ends:
        if groups and value - groups[-1][0] < near and LINES[axis]["color"] == LINES[groups[-1][1][0]]["color"]:
            groups[-1][1].append(axis)
        else:
            groups.append((value, [axis]))
    return groups


def _spaced(values: list[float], apart: float) -> list[float]:
    """Ascending places at least so far apart, each as near its value as its neighbours allow.

    >>> _spaced([0.0, 0.1, 5.0], 1.0)
    [-0.45, 0.55, 5.0]
    """
    blocks: list[list[float]] = []
    for value in values:
        blocks.append([value])
        while len(blocks) > 1 and _low(blocks[-1], apart) - _high(blocks[-2], apart) < apart:
            blocks[-2:] = [blocks[-2] + blocks[-1]]
    return [round(_low(block, apart) + place * apart, 12) for block in blocks for place in range(len(block))]


def _low(block: list[float], apart: float) -> float:
    return sum(block) / len(block) - 0.5 * apart * (len(block) - 1)


def _high(block: list[float], apart: float) -> float:
    return sum(block) / len(block) + 0.5 * apart * (len(block) - 1)


def _focus(values: Array) -> tuple[float, float]:
    """Range that shows the curves without letting one steep end flatten all the others."""
    low, high = float(values.min()), float(values.max())
    largest = np.sort(np.abs(values).max(axis=(1, 2)))
    cut = 4.0 * float(np.median(largest))
    if largest[-1] > 2.0 * cut:  # a curve that hardly leaves the range is better seen whole
        low, high = max(low, -cut), min(high, cut)
    room = 0.06 * (high - low)
    return min(low, 0.0) - room, high + room


def mark_small(panel: Axes, x: float, y: float, axis: str) -> None:
    """The operating point on one of several curves."""
    low, high = panel.get_ylim()
    if low <= y <= high:
        panel.plot([x], [y], "o", color=LINES[axis]["color"], markersize=3.2, zorder=5)
