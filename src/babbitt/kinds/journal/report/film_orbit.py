"""The orbit of a journal under a changing load, and the film over one cycle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.journal.film.field import clearance_outline
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.report.drawing import GREY, INK, Array, Sheet, axis_label, mark

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NAMED = 4
"""Instants of the cycle that are named along the orbit."""


def orbit(state: FilmState, result: Result) -> Figure:
    """Orbit inside the room that the bore leaves; film thickness and load over the angle turned."""
    turned, _, _, fx, fy, thickness, _ = np.array(result.arrays["orbit"]).T
    figure, axes = Sheet(166.0, 80.0, 2, 2, left=11.0, bottom=9.5, across=17.0, between=5.0).panels()
    whole = axes[0][0].get_gridspec()[:, 0]
    for panel in axes[:, 0]:
        panel.remove()
    orbit_in_clearance(figure.add_subplot(whole), state, result)
    above, below = axes[:, 1]
    cycle = math.degrees(turned[-1] + turned[1])
    degrees = np.append(np.degrees(turned), cycle)
    shown = (("minimum_film_thickness", thickness, above), ("load", np.hypot(fx, fy), below))
    for name, values, panel in shown:
        quantity = QUANTITIES[name]
        panel.plot(degrees, quantity.display.scale * np.append(values, values[0]), color=INK)
        panel.set(ylabel=axis_label(quantity), xlim=(0.0, cycle))
        panel.set_ylim(bottom=0.0)
        panel.set_xticks(np.linspace(0.0, cycle, 5))
        panel.xaxis.set_major_formatter("{x:g}")
    above.tick_params(labelbottom=False)
    below.set_xlabel("angle turned by the journal in °")
    thinnest = int(np.argmin(thickness))
    mark(above, degrees[thinnest], QUANTITIES["minimum_film_thickness"].display.scale * thickness[thinnest])
    return figure


def orbit_in_clearance(panel: Axes, state: FilmState, result: Result) -> None:
    """Orbit inside the room that the bore leaves, on axes that are given."""
    turned, x, y = np.array(result.arrays["orbit"]).T[:3]
    _orbit(panel, state, turned, np.array([x, y]) / state.solution.film.clearance)


def _orbit(panel: Axes, state: FilmState, turned: Array, place: Array) -> None:
    from matplotlib.ticker import MaxNLocator

    panel.set_aspect("equal")
    directions = np.linspace(0.0, 2.0 * math.pi, 361)
    film = state.solution.film
    room = clearance_outline(film, directions) / film.clearance
    panel.plot(room * np.cos(directions), room * np.sin(directions), color=INK, linewidth=0.8)
    panel.plot([0.0], [0.0], "+", color=GREY, markersize=6, markeredgewidth=0.8)
    panel.plot(*np.concatenate((place, place[:, :1]), axis=1), color=INK)
    rest = state.solution.position / film.clearance
    panel.plot(*rest, "x", color=GREY, markersize=5, markeredgewidth=0.9)
    middle = place.mean(axis=1)
    for instant in np.arange(NAMED) * (turned.size // NAMED):
        at = place[:, instant]
        panel.plot(*at, "o", markersize=2.6, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.7)
        away = at - middle
        away = away / max(float(np.hypot(*away)), 1e-12)
        panel.annotate(
            f"{math.degrees(turned[instant]):.0f}°", tuple(at), xytext=tuple(12.0 * away), textcoords="offset "
            "points",
            fontsize=7, ha="center", va="center",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.3},
        )  # fmt: skip
    reach = 1.04 * float(room[np.isfinite(room)].max())
    panel.set(xlim=(-reach, reach), ylim=(-reach, reach), xlabel="$x/c$", ylabel="$y/c$")
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_major_locator(MaxNLocator(5))
        axis.set_major_formatter("{x:g}")
