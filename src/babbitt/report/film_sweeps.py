"""The same film under other loads and at other speeds, clearance and viscosity of the operating point kept."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from babbitt.bearings.layout import load_vector
from babbitt.bearings.model import Accuracy, FilmCase
from babbitt.bearings.warm_film import FilmState, film_at_temperature
from babbitt.bearings.whirl import STANDARD_GRAVITY, at_speed, threshold_speed
from babbitt.report.drawing import Array
from babbitt.results import Result

if TYPE_CHECKING:
    from babbitt.film.solution import FilmSolution

LOADS, SPEEDS, THRESHOLDS = 41, 41, 9
"""Points of each sweep, odd, so that the operating point is one of them."""

LOAD_SPAN, SPEED_SPAN, THRESHOLD_SPAN = (0.02, 8.0), (0.25, 2.5), (0.2, 5.0)
"""Ends of the sweeps over the operating point."""


@dataclass(frozen=True, eq=False)
class Swept:
    """Points of a sweep and the film at each; points without an equilibrium are left out."""

    points: Array
    films: tuple[FilmSolution, ...]


def state_of(case: FilmCase, result: Result) -> FilmState:
    """The film of a solved result, from its effective temperature."""
    return film_at_temperature(result.values["effective_temperature"], case)


def at_draft(case: FilmCase, state: FilmState) -> FilmCase:
    """The case as the sweeps solve it: films that differ across the width take a draft grid, they cost ten times as
    much as others."""
    return replace(case, accuracy=Accuracy.DRAFT) if state.solution.film.differs_across_width else case


def whole_width(state: FilmState) -> bool:
    """Whether the film has no symmetry about the mid-plane, which makes every point several times dearer again."""
    return bool(state.solution.axial_positions[0] < 0.0)


def over_load(case: FilmCase, state: FilmState) -> Swept:
    """Equilibria over the load, in N."""
    from babbitt.film.solve import solve_journal

    film, grid = state.solution.film, at_draft(case, state).accuracy.resolution
    loads = spread(state.load, LOAD_SPAN, LOADS)
    return _solved(loads, [solve_journal(film, load_vector(case, float(load)), grid) for load in loads])


def over_speed(case: FilmCase, state: FilmState) -> Swept:
    """Equilibria over the speed at the same load, in rad/s."""
    speeds = spread(abs(state.solution.film.angular_speed), SPEED_SPAN, SPEEDS)
    drafted = at_draft(case, state)
    return _solved(speeds, [at_speed(drafted, state, float(speed)) for speed in speeds])


def thresholds(case: FilmCase, state: FilmState) -> tuple[Array, Array]:
    """Loads in N, and the speed in rad/s at which the rotor begins to whirl under each; not a number where no speed in
    sight changes what it does."""
    drafted = at_draft(case, state)
    loads = spread(state.load, THRESHOLD_SPAN, THRESHOLDS)
    found = []
    for load in loads:
        mass = case.rotor_mass if case.rotor_mass is not None else float(load) / STANDARD_GRAVITY
        speed = threshold_speed(drafted, replace(state, load=float(load)), mass)
        found.append(math.nan if speed is None else speed)
    return loads, np.array(found)


def spread(centre: float, span: tuple[float, float], count: int) -> Array:
    """Geometric points about a centre, which is one of them.

    >>> spread(2.0, (0.5, 4.0), 5).round(3).tolist()
    [1.0, 1.414, 2.0, 4.0, 8.0]
    """
    half = count // 2 + 1
    low = np.geomspace(span[0] * centre, centre, half)
    return np.concatenate([low, np.geomspace(centre, span[1] * centre, half)[1:]])


def _solved(points: Array, films: list[FilmSolution]) -> Swept:
    there = [place for place, film in enumerate(films) if film.outcome.solved]
    return Swept(points[there], tuple(films[place] for place in there))
