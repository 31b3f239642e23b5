"""Static locus: equilibrium positions over the load and over the speed, with coefficients."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.study.film_points import FilmPoints, ProgressCallback, film_points, no_progress

if TYPE_CHECKING:
    from collections.abc import Iterable

    from babbitt.kinds.journal.film.isothermal import FilmState

__all__ = ["LOAD_SPAN", "SPEED_SPAN", "locus_over_load", "locus_over_speed", "spread"]

Array = NDArray[np.float64]

POINTS, DEAR_POINTS = 41, 25
"""Of a locus, and of one whose film differs across the width; odd, so that the operating point is one of them."""

LOAD_SPAN, SPEED_SPAN = (0.02, 8.0), (0.25, 2.5)
"""Ends over the operating point, where none are given."""


def locus_over_load(
    case: FilmCase, state: FilmState, loads: Iterable[float] | None = None, watch: ProgressCallback = no_progress
) -> FilmPoints:
    """Equilibria over the load, everything else as at the operating point.

    Parameters
    ----------
    case : FilmCase
    state : FilmState
        Its film at the operating point, whose speed, clearance, viscosity and supply pressures are kept.
    loads : iterable of float, optional
        N. From a fiftieth to eight times the load of the operating point where none are given.
    watch : ProgressCallback

    Returns
    -------
    FilmPoints
        Points without an equilibrium are left out.
    """
    film = state.solution.film
    taken = spread(state.load, LOAD_SPAN, count_for(state)) if loads is None else np.array(list(loads))
    return film_points(case, state, taken, abs(film.angular_speed), watch).converged()


def locus_over_speed(
    case: FilmCase, state: FilmState, speeds: Iterable[float] | None = None, watch: ProgressCallback = no_progress
) -> FilmPoints:
    """Equilibria over the speed under the same load; parameters as for `locus_over_load`, speeds in rad/s.

    From a quarter to two and a half times the speed of the operating point where none are given.
    """
    film = state.solution.film
    here = abs(film.angular_speed)
    taken = spread(here, SPEED_SPAN, count_for(state)) if speeds is None else np.array(list(speeds))
    return film_points(case, state, state.load, taken, watch).converged()


def count_for(state: FilmState) -> int:
    """How many points a locus takes."""
    return DEAR_POINTS if state.solution.film.is_surface else POINTS


def spread(centre: float, span: tuple[float, float], count: int) -> Array:
    """Geometric points about a centre, which is one of them.

    >>> spread(2.0, (0.5, 4.0), 5).round(3).tolist()
    [1.0, 1.414, 2.0, 4.0, 8.0]
    """
    half = count // 2 + 1
    low = np.geomspace(span[0] * centre, centre, half)
    return np.concatenate([low, np.geomspace(centre, span[1] * centre, half)[1:]])
