"""When the journal whirls in its film: critical mass, whirl frequency, threshold speed of the rotor."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.journal.film.isothermal import FilmState, following, known_bore, load_found
from babbitt.kinds.journal.film.load_slope import with_known_slope
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of, pushes_off
from babbitt.kinds.journal.film.unloaded import is_unloaded
from babbitt.reynolds.equilibrium.cavitating_film import coefficients_over_speed
from babbitt.reynolds.frame import LoadFrame, rounded
from babbitt.reynolds.stability.rotor import RIGID, stable_masses_of_rotor
from babbitt.reynolds.stability.whirl_limits import (
    ElasticWhirl,
    Threshold,
    Whirl,
    crossing,
    rotor_mass,
    stability_excess,
)

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.elastic_film import KnownBore
    from babbitt.reynolds.model import JournalFilm
    from babbitt.reynolds.solution import FilmSolution

BLUR = 1e-3
"""Logarithm of the reserve that counts as none in a bore that gives way: the coefficients there are differences of
the load that hold to 1 %, and one node of the film that ruptures or not is worth as much."""
CLOSENESS = 1e-4
"""Share of the least gap to which film and displacement of the bore agree at another speed."""


def whirl_of(case: FilmCase, state: FilmState) -> Whirl:
    """Stability at the operating point, and the speed at which the rotor begins to whirl.

    The coefficients of `state` are those of a quick motion: temperatures, if the film has its own, are frozen.
    The threshold keeps load, viscosity and clearance of the operating point.
    Without a mass of the rotor, the load is taken as its weight.
    """
    from babbitt.reynolds.stability.routh import whirl_frequency

    stiffness, damping = state.solution.stiffness, state.solution.damping
    mass = mass_of_rotor(case, 0.0 if is_unloaded(case, state) else state.load)
    shaft = case.shaft_stiffness
    return Whirl(
        stable_masses_of_rotor(stiffness, damping),
        whirl_frequency(stiffness, damping) / abs(case.journal_speed),
        mass,
        threshold_of_journal(case, rotor_threshold(case, state, mass)),
        None
        if shaft is None
        else ElasticWhirl(
            stable_masses_of_rotor(stiffness, damping, shaft),
            threshold_of_journal(case, rotor_threshold(case, state, mass, shaft)),
        ),
    )


def threshold_of_journal(case: FilmCase, found: Threshold) -> Threshold:
    """The threshold at the speed of the journal, beside that of a bearing that turns; none where it turns back."""
    if found.speed is None:
        return found
    speed = found.speed - case.rotation.sense * case.bearing_speed
    return Threshold(speed if speed > 0.0 else None)


def mass_of_rotor(case: FilmCase, load: float) -> float:
    """Mass of the rotor in kg: that of the case, or the one whose weight is the load in N."""
    return rotor_mass(case.rotor_mass, load)


def at_speed(case: FilmCase, state: FilmState, speed: float, bore: KnownBore | None = None) -> FilmSolution:
    """The film under the same load in the direction found, with the same oil, at another speed in rad/s.

    `bore` is what films at other speeds tell of one that gives way.
    """
    film = replace(state.solution.film, angular_speed=case.rotation.sense * speed)
    load = load_found(state)

    def settle(one: JournalFilm) -> FilmSolution:
        return converged_film(one, load, case.accuracy.resolution, place_of(state.solution))

    if not case.bearing.compliance:
        return settle(film)
    from babbitt.kinds.journal.film.elastic_film import displacement_under, elastic_film
    from babbitt.reynolds.deformation.compliance import as_field

    own = displacement_under(case.bearing.compliance, state.solution)
    given = replace(film, displacement=as_field(np.asarray(film.displacement) - own))
    follow = following(load, case.accuracy.resolution, settle, 1)  # the displacement is known nearly
    found = elastic_film(given, case.bearing.compliance, follow, CLOSENESS, own, bore)
    return replace(found.solution, outcome=found.outcome)


def _reserve_at(case: FilmCase, state: FilmState, mass: float, shaft_stiffness: float) -> Callable[[float], float]:
    """Reserve of a mass in kg over the hydrodynamic speed in rad/s; no number where no film is found."""
    film = replace(state.solution.film, angular_speed=case.rotation.sense * abs(state.solution.film.angular_speed))
    bore, grid = known_bore(case), case.accuracy.resolution
    frame = LoadFrame.of(film, load_found(state))
    quick = None if bore is not None else coefficients_over_speed(frame.film, frame.load, grid)

    def reserve(speed: float) -> float:
        found = None if quick is None else quick(rounded(speed))
        if found is not None and not pushes_off(found[0]):
            return stable_masses_of_rotor(*found, shaft_stiffness).reserve(mass)
        solved = with_known_slope(case, at_speed(case, state, speed, bore))
        if not solved.outcome.solved:
            return math.nan
        return stable_masses_of_rotor(solved.stiffness, solved.damping, shaft_stiffness).reserve(mass)

    return reserve


def rotor_threshold(case: FilmCase, state: FilmState, mass: float, shaft_stiffness: float = RIGID) -> Threshold:
    """Hydrodynamic speed in rad/s above which a rotor whirls, nearest to that here.

    There is none where the film carries nothing: no load holds the journal at another place at another speed. None
    is looked for where the case does not ask.
    """
    if not (case.limiting_speeds and case.whirl_speed) or is_unloaded(case, state):
        return Threshold()

    gives_way = bool(case.bearing.compliance)
    here = abs(state.solution.film.angular_speed)
    own = stable_masses_of_rotor(state.solution.stiffness, state.solution.damping, shaft_stiffness).reserve(mass)
    at = _reserve_at(case, state, mass, shaft_stiffness)

    @cache
    def reserve(speed: float) -> float:
        if gives_way and state.thermal is None and speed == here:
            return own  # that of the same film, its bore counted
        return at(speed)

    # films of one viscosity tell how the reserve changes with the speed, the film itself how large it is here
    share = _ratio(own, reserve(here)) if state.thermal is not None else 1.0
    blur = BLUR if gives_way else 0.0
    return crossing(lambda speed: stability_excess(share * reserve(speed)), here, blur)


def _ratio(own: float, other: float) -> float:
    """Ratio of two reserves, 1 where one of them has no size."""
    return own / other if 0.0 < own < math.inf and 0.0 < other < math.inf else 1.0
