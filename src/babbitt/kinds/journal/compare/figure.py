"""The figure of `babbitt compare`: results of every method for one bearing, and temperatures around the bore."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.film.field import field_of
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.temperature_field import centre_line
from babbitt.kinds.journal.report import film_maps
from babbitt.report.drawing import (
    GREY,
    INK,
    Array,
    Sheet,
    axis_label,
    mathematics,
)
from babbitt.study.comparison import Comparison, Variant

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["comparison_figure", "is_shown"]

SHOWN = ("minimum_film_thickness", "friction_power", "total_flow")
TEMPERATURES = ("effective_temperature", "outlet_temperature", "maximum_bush_temperature", "maximum_temperature")
MARKS = {"effective_temperature": "|", "outlet_temperature": ">", "maximum_bush_temperature": "s",
         "maximum_temperature": "o"}  # fmt: skip
LINES = ("-", "--", ":", "-.")
NAMES_IN_A_ROW = 3
"""Of the legend of temperatures around the bore."""


def comparison_figure(comparison: Comparison) -> Figure:
    """Film, power, flow and temperatures by every method; below, temperatures around a journal where one of them
    finds these."""
    solved = [one for one in comparison.methods if is_shown(one)]
    named = [name for name in SHOWN if any(name in one.result.values for one in solved)]
    around = any(_has_own_temperatures(one) for one in solved)
    lines = max(0, math.ceil(len(solved) / NAMES_IN_A_ROW) - 2)  # of the legend below, beyond two
    between = 17.0 + 4.2 * lines
    rows, height = (2, 112.0 + 4.2 * lines) if around else (1, 60.0)
    figure, axes = Sheet(166.0, height, rows, len(named) + 1, left=29.0, across=5.0, between=between).panels()
    figure.subplots_adjust(top=1.0 - 7.0 / height)
    for panel, name in zip(axes[0], named, strict=False):
        _bars(panel, solved, name)
    _temperatures(axes[0][-1], solved)
    for panel in axes[0][1:]:
        panel.set_yticklabels([])
    if around:
        for panel in axes[1][1:]:
            panel.remove()
        below = axes[1][0]
        place, right = below.get_position(), axes[0][-1].get_position()
        below.set_position((12.0 / 166.0, place.y0, right.x1 - 12.0 / 166.0, place.height))
        _around(below, solved)
    return figure


def _is_film(variant: Variant) -> bool:
    return isinstance(variant.solution.problem, FilmCase)


def _has_own_temperatures(variant: Variant) -> bool:
    return _is_film(variant) and variant.solution.problem.heat is not None


def is_shown(variant: Variant) -> bool:
    """Whether a variant is a method of its own that has found a film with a temperature; hydrostatic bearings and
    footsteps are compared in the table alone."""
    result = variant.result
    solved = variant.is_method and result.outcome.solved
    return solved and "effective_temperature" in result.values


def _bars(panel: Axes, variants: Sequence[Variant], name: str) -> None:
    quantity = QUANTITIES[name]
    places = np.arange(len(variants))[::-1]
    values = [one.result.values.get(name, math.nan) for one in variants]
    shown = [quantity.shown(value) for value in values]
    panel.barh(places, shown, color="0.75", edgecolor=INK, linewidth=0.5, height=0.6)
    for place, value, length in zip(places, values, shown, strict=True):
        if not math.isnan(value):
            panel.annotate(quantity.format(value), (length, place), xytext=(2, 0), textcoords="offset points",
                           fontsize=7, va="center", annotation_clip=False)  # fmt: skip
    panel.set_yticks(places, [one.label for one in variants])
    panel.set_ylim(places[-1] - 0.5, places[0] + 0.5)  # a method without the quantity keeps its row
    panel.set_xlim(0.0, 1.28 * np.nanmax(shown))
    panel.set_xlabel(axis_label(quantity))


def _temperatures(panel: Axes, variants: Sequence[Variant]) -> None:
    places = np.arange(len(variants))[::-1]
    for name in TEMPERATURES:
        at = [
            one.result.values[name] - ZERO_CELSIUS if name in one.result.values else math.nan for one in variants
        ]
        panel.plot(at, places, MARKS[name], color=INK, markersize=4.5, fillstyle="none", markeredgewidth=0.9,
                   label=mathematics(QUANTITIES[name].symbol))  # fmt: skip
    panel.set_yticks(places, [])
    panel.set_ylim(places[-1] - 0.5, places[0] + 0.5)
    panel.grid(axis="y", linewidth=0.3, color="0.85")
    panel.set_xlabel("temperatures in °C")
    panel.legend(frameon=False, fontsize=7, ncols=4, loc="lower right", bbox_to_anchor=(1.05, 0.98), borderpad=0.0,
                 handletextpad=0.0, columnspacing=0.4)  # fmt: skip


def _around(panel: Axes, variants: Sequence[Variant]) -> None:
    """Temperature along the middle of the width: of the bore, of a film of one dimension, or the single one of a
    method."""
    field, level, curve = None, 0, 0
    first = next(one.solution.problem for one in variants if _is_film(one))
    start = math.degrees(first.load_angle) - 180.0
    for one in variants:
        if "film_temperature" in one.result.arrays:
            places, film = _around_from(start, one.result)
            panel.plot(places, film, LINES[level % len(LINES)], color=GREY, label=one.label)
            level += 1
        elif _has_own_temperatures(one):
            thermal = one.solution.state.thermal
            field = field_of(thermal.film, one.solution.problem.load_angle - math.pi)
            line = centre_line(thermal, field)
            places = np.degrees(line.theta)
            panel.plot(places, line.highest - ZERO_CELSIUS, LINES[curve % len(LINES)], color=INK,
                       label=f"{one.label}, hottest across the gap")  # fmt: skip
            curve += 1
        else:
            panel.axhline(
                one.result.values["effective_temperature"] - ZERO_CELSIUS, color=GREY, linewidth=0.9,
                linestyle=LINES[level % len(LINES)], label=f"{one.label}, $T_\\mathrm{{eff}}$",
            )  # fmt: skip
            level += 1
    if field is not None:
        film_maps.degrees(panel, field)
    panel.set_xlabel("θ in °, counter-clockwise from $+x$")
    panel.set_ylabel("$T$ in °C, middle of the width")
    panel.legend(frameon=False, fontsize=7, ncols=NAMES_IN_A_ROW, loc="lower left", bbox_to_anchor=(0.0, 1.0),
                 borderpad=0.0)  # fmt: skip


def _around_from(start: float, result: Result) -> tuple[Array, Array]:
    """Directions in degrees from `start` on, and temperatures in degC, of a film of one dimension."""
    directions = np.degrees(result.arrays["film_direction"][0])
    places = start + np.remainder(directions - start, 360.0)
    order = np.argsort(places)
    return places[order], np.asarray(result.arrays["film_temperature"][0])[order] - ZERO_CELSIUS
