"""The figure of `babbitt compare`: results of every method for one bearing, and temperatures around the bore."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.language import translated
from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.film.field import field_of
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.temperature_field import centre_line
from babbitt.kinds.journal.report import film_maps
from babbitt.report.comparison_figure import ABOVE, ACROSS, LEFT, draw_methods, drawn_names, is_shown
from babbitt.report.drawing import GREY, INK, Array, Sheet
from babbitt.study.comparison import Comparison, Variant

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["comparison_figure"]

LINES = ("-", "--", ":", "-.")
NAMES_IN_A_ROW = 3
"""Of the legend of temperatures around the bore."""


def comparison_figure(comparison: Comparison) -> Figure:
    """Film, power, flow and temperatures by every method; below, temperatures around a journal where one of them
    finds these."""
    solved = [one for one in comparison.methods if is_shown(one)]
    around = any(_has_own_temperatures(one) for one in solved)
    lines = max(0, math.ceil(len(solved) / NAMES_IN_A_ROW) - 2)  # of the legend below, beyond two
    between = 17.0 + 4.2 * lines
    rows, height = (2, 112.0 + 4.2 * lines) if around else (1, 60.0)
    sheet = Sheet(166.0, height, rows, len(drawn_names(solved)) + 1, left=LEFT, across=ACROSS, between=between)
    figure, axes = sheet.panels()
    figure.subplots_adjust(top=1.0 - ABOVE / height)
    draw_methods(axes[0], solved)
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


def _around(panel: Axes, variants: Sequence[Variant]) -> None:
    """Temperature along the middle of the width: of the bore, of a film of one dimension, or the single one of a
    method."""
    field, level, curve = None, 0, 0
    first = next(one.solution.problem for one in variants if _is_film(one))
    start = math.degrees(first.load_angle) - 180.0
    for one in variants:
        if "film_temperature" in one.result.arrays:
            places, film = _around_from(start, one.result)
            panel.plot(places, film, LINES[level % len(LINES)], color=GREY, label=translated(one.label))
            level += 1
        elif _has_own_temperatures(one):
            thermal = one.solution.state.thermal
            field = field_of(thermal.film, one.solution.problem.load_angle - math.pi)
            line = centre_line(thermal, field)
            places = np.degrees(line.theta)
            named = translated("{label}, hottest across the gap", label=translated(one.label))
            panel.plot(places, line.highest - ZERO_CELSIUS, LINES[curve % len(LINES)], color=INK, label=named)
            curve += 1
        else:
            panel.axhline(
                one.result.values["effective_temperature"] - ZERO_CELSIUS, color=GREY, linewidth=0.9,
                linestyle=LINES[level % len(LINES)], label=f"{translated(one.label)}, $T_\\mathrm{{eff}}$",
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
