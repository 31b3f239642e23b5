"""When the journal whirls in its film: critical mass, whirl frequency, threshold speed of the rotor."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from babbitt.bearings.model import FilmCase
from babbitt.bearings.rotor import RIGID, critical_mass_of_rotor
from babbitt.bearings.settling import place_of, settled_film
from babbitt.bearings.warm_film import FilmState
from babbitt.design.roots import find_root

if TYPE_CHECKING:
    from babbitt.film.solution import FilmSolution

STANDARD_GRAVITY = 9.80665
"""m/s²."""

FASTEST = 10.0
"""The threshold is sought up to this many times the speed, and down to its inverse."""

SPEED_TOLERANCE = 1e-4
"""Relative, of a speed sought: a tenth of what the grid leaves open."""
SEARCH_STEP = 1.25
"""Ratio of the speeds at which the search looks."""


@dataclass(frozen=True)
class Whirl:
    """Stability of a rotor in this film: kg, ratio to the speed, rad/s.

    `threshold_speed` is None where no speed within the search changes what the journal does. Without `elastic` the
    rotor is rigid; with it, the same for the shaft as stiff as the case says.
    """

    critical_mass: float
    frequency_ratio: float
    rotor_mass: float
    threshold_speed: float | None
    elastic: ElasticWhirl | None = None


@dataclass(frozen=True)
class ElasticWhirl:
    """Critical mass in kg and threshold speed in rad/s of a rotor on its elastic shaft."""

    critical_mass: float
    threshold_speed: float | None


def whirl_of(case: FilmCase, state: FilmState) -> Whirl:
    """Stability at the operating point, and the speed at which the rotor begins to whirl.

    The coefficients of `state` are those of a quick motion: temperatures, if the film has its own, are frozen.
    The threshold keeps load, viscosity and clearance of the operating point. Without a mass of the rotor, the
    load is taken as its weight.
    """
    from babbitt.film.stability import whirl_frequency

    stiffness, damping = state.solution.stiffness, state.solution.damping
    speed = abs(state.solution.film.angular_speed)
    mass, shaft = mass_of_rotor(case, state.load), case.shaft_stiffness
    return Whirl(
        critical_mass_of_rotor(stiffness, damping),
        whirl_frequency(stiffness, damping) / speed,
        mass,
        threshold_speed(case, state, mass),
        None
        if shaft is None
        else ElasticWhirl(
            critical_mass_of_rotor(stiffness, damping, shaft), threshold_speed(case, state, mass, shaft)
        ),
    )


def mass_of_rotor(case: FilmCase, load: float) -> float:
    """Mass of the rotor in kg: that of the case, or the one whose weight is the load in N."""
    return case.rotor_mass if case.rotor_mass is not None else load / STANDARD_GRAVITY


def at_speed(case: FilmCase, state: FilmState, speed: float) -> FilmSolution:
    """The film under the same load in the direction found, with the same oil, at another speed in rad/s."""
    film = replace(state.solution.film, angular_speed=case.rotation.sense * speed)
    share = -state.load / math.hypot(*state.solution.force)
    load = share * float(state.solution.force[0]), share * float(state.solution.force[1])
    return settled_film(film, load, case.accuracy.resolution, place_of(state.solution))


def threshold_speed(case: FilmCase, state: FilmState, mass: float, shaft_stiffness: float = RIGID) -> float | None:
    """Speed in rad/s above which a rotor whirls, nearest to the operating speed; None if none is in sight."""

    def excess(speed: float) -> float:
        found = at_speed(case, state, speed)
        if not found.outcome.solved:
            return math.nan
        critical = critical_mass_of_rotor(found.stiffness, found.damping, shaft_stiffness)
        return (
            math.atan(math.log(critical / mass))
            if 0.0 < critical < math.inf
            else math.copysign(2.0, critical - mass)
        )

    return crossing(excess, abs(state.solution.film.angular_speed))


def crossing(excess: Callable[[float], float], speed: float) -> float | None:
    """Speed at which a function turns from positive to negative: above a stable speed, below an unstable one.

    None where there is none in sight, or the function has no value on the way.
    """
    here = excess(speed)
    if math.isnan(here):
        return None
    step = SEARCH_STEP if here > 0.0 else 1.0 / SEARCH_STEP
    near = speed
    while 1.0 / FASTEST <= near * step / speed <= FASTEST:
        far = near * step
        there = excess(far)
        if math.isnan(there):
            return None
        if here * there <= 0.0:
            root = find_root(excess, min(near, far), max(near, far), relative=SPEED_TOLERANCE)
            return root.value if root.converged else None
        near, here = far, there
    return None
