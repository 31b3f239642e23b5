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

POINTS, THRESHOLDS = 41, 9
"""Of the sweeps over load and speed, and of the threshold; odd, so that the operating point is one of them."""

DEAR_POINTS, DEAR_THRESHOLDS = 17, 5
"""The same for dear films."""

DEAR = 1500
"""Grid points of a film that differs across the width beyond which sweeps take fewer points on a draft grid."""

SLOW = 4500
"""Grid points of a film beyond which sweeps take seconds."""

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
    """The case as the sweeps solve it: a dear film takes a draft grid."""
    return replace(case, accuracy=Accuracy.DRAFT) if is_dear(state) else case


def is_dear(state: FilmState) -> bool:
    """Whether each point of a sweep costs ten times as much as that of a film fed by grooves alone."""
    return bool(state.solution.film.is_surface and state.solution.pressure.size > DEAR)


def is_slow(state: FilmState) -> bool:
    """Whether sweeps of this film take seconds."""
    return bool(state.solution.pressure.size > SLOW)


def over_load(case: FilmCase, state: FilmState) -> Swept:
    """Equilibria over the load, in N."""
    from babbitt.film.solve import solve_journal

    film, grid = state.solution.film, at_draft(case, state).accuracy.resolution
    loads = spread(state.load, LOAD_SPAN, _either(state, POINTS, DEAR_POINTS))
    return _solved(loads, [solve_journal(film, load_vector(case, float(load)), grid) for load in loads])


def over_speed(case: FilmCase, state: FilmState) -> Swept:
    """Equilibria over the speed at the same load, in rad/s."""
    speeds = spread(abs(state.solution.film.angular_speed), SPEED_SPAN, _either(state, POINTS, DEAR_POINTS))
    drafted = at_draft(case, state)
    return _solved(speeds, [at_speed(drafted, state, float(speed)) for speed in speeds])


def thresholds(case: FilmCase, state: FilmState) -> tuple[Array, Array]:
    """Loads in N, and the speed in rad/s at which the rotor begins to whirl under each.

    Zero where it whirls however slow, infinite where it runs stable however fast, as far as the search looks;
    not a number without a film.
    """
    drafted = at_draft(case, state)
    loads = spread(state.load, THRESHOLD_SPAN, _either(state, THRESHOLDS, DEAR_THRESHOLDS))
    found = []
    for load in loads:
        mass = case.rotor_mass if case.rotor_mass is not None else float(load) / STANDARD_GRAVITY
        speed = threshold_speed(drafted, replace(state, load=float(load)), mass)
        found.append(_without_threshold(drafted, state, float(load), mass) if speed is None else speed)
    return loads, np.array(found)


def _without_threshold(case: FilmCase, state: FilmState, load: float, mass: float) -> float:
    from babbitt.film.stability import critical_mass

    film = at_speed(case, replace(state, load=load), abs(state.solution.film.angular_speed))
    if not film.outcome.solved:
        return math.nan
    return math.inf if critical_mass(film.stiffness, film.damping) > mass else 0.0


def spread(centre: float, span: tuple[float, float], count: int) -> Array:
    """Geometric points about a centre, which is one of them.

    >>> spread(2.0, (0.5, 4.0), 5).round(3).tolist()
    [1.0, 1.414, 2.0, 4.0, 8.0]
    """
    half = count // 2 + 1
    low = np.geomspace(span[0] * centre, centre, half)
    return np.concatenate([low, np.geomspace(centre, span[1] * centre, half)[1:]])


def _either(state: FilmState, cheap: int, dear: int) -> int:
    return dear if is_dear(state) else cheap


def _solved(points: Array, films: list[FilmSolution]) -> Swept:
    there = [place for place, film in enumerate(films) if film.outcome.solved]
    return Swept(points[there], tuple(films[place] for place in there))
