"""When the journal whirls in its film: critical mass, whirl frequency, threshold speed of the rotor."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.journal.film.isothermal import FilmState, following
from babbitt.kinds.journal.film.load_slope import with_bore
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of
from babbitt.kinds.journal.film.unloaded import is_unloaded
from babbitt.reynolds.stability.rotor import RIGID, stable_masses_of_rotor
from babbitt.reynolds.stability.whirl_limits import ElasticWhirl, Whirl, crossing, rotor_mass, stability_excess

if TYPE_CHECKING:
    from babbitt.reynolds.model import JournalFilm
    from babbitt.reynolds.solution import FilmSolution


def whirl_of(case: FilmCase, state: FilmState) -> Whirl:
    """Stability at the operating point, and the speed at which the rotor begins to whirl.

    The coefficients of `state` are those of a quick motion: temperatures, if the film has its own, are frozen.
    The threshold keeps load, viscosity and clearance of the operating point; it is None, too, where the case does
    not ask for it. Without a mass of the rotor, the load is taken as its weight.
    """
    from babbitt.reynolds.stability.routh import whirl_frequency

    stiffness, damping = state.solution.stiffness, state.solution.damping
    mass = mass_of_rotor(case, 0.0 if is_unloaded(case, state) else state.load)
    shaft = case.shaft_stiffness
    return Whirl(
        stable_masses_of_rotor(stiffness, damping),
        whirl_frequency(stiffness, damping) / abs(case.journal_speed),
        mass,
        journal_speed_at(case, threshold_speed(case, state, mass)),
        None
        if shaft is None
        else ElasticWhirl(
            stable_masses_of_rotor(stiffness, damping, shaft),
            journal_speed_at(case, threshold_speed(case, state, mass, shaft)),
        ),
    )


def journal_speed_at(case: FilmCase, hydrodynamic_speed: float | None) -> float | None:
    """Speed of the journal in rad/s at which film and bearing turn so fast together; None where it turns back."""
    if hydrodynamic_speed is None:
        return None
    speed = hydrodynamic_speed - case.rotation.sense * case.bearing_speed
    return speed if speed > 0.0 else None


def mass_of_rotor(case: FilmCase, load: float) -> float:
    """Mass of the rotor in kg: that of the case, or the one whose weight is the load in N."""
    return rotor_mass(case.rotor_mass, load)


def at_speed(case: FilmCase, state: FilmState, speed: float) -> FilmSolution:
    """The film under the same load in the direction found, with the same oil, at another speed in rad/s."""
    film = replace(state.solution.film, angular_speed=case.rotation.sense * speed)
    share = -state.load / math.hypot(*state.solution.force)
    load = share * float(state.solution.force[0]), share * float(state.solution.force[1])

    def settle(one: JournalFilm) -> FilmSolution:
        return converged_film(one, load, case.accuracy.resolution, place_of(state.solution))

    if not case.bearing.compliance:
        return settle(film)
    from babbitt.kinds.journal.film.elastic_film import displacement_under, elastic_film
    from babbitt.reynolds.deformation.compliance import as_field

    own = displacement_under(case.bearing.compliance, state.solution)
    given = replace(film, displacement=as_field(np.asarray(film.displacement) - own))
    follow = following(load, case.accuracy.resolution, settle, 1)  # the displacement is known nearly
    found = elastic_film(given, case.bearing.compliance, follow, start=own)
    return replace(found.solution, outcome=found.outcome)


def threshold_speed(case: FilmCase, state: FilmState, mass: float, shaft_stiffness: float = RIGID) -> float | None:
    """Hydrodynamic speed in rad/s above which a rotor whirls, nearest to that here; None if none is in sight.

    Nor is one where the film carries nothing: no load holds the journal at another place at another speed. None
    is looked for where the case does not ask.
    """
    if not case.limiting_speeds or is_unloaded(case, state):
        return None

    @cache
    def reserve(speed: float) -> float:
        found = with_bore(case, at_speed(case, state, speed))
        if not found.outcome.solved:
            return math.nan
        return stable_masses_of_rotor(found.stiffness, found.damping, shaft_stiffness).reserve(mass)

    here = abs(state.solution.film.angular_speed)
    # films of one viscosity tell how the reserve changes with the speed, the film itself how large it is here
    own = stable_masses_of_rotor(state.solution.stiffness, state.solution.damping, shaft_stiffness).reserve(mass)
    share = _ratio(own, reserve(here)) if state.thermal is not None else 1.0
    return crossing(lambda speed: stability_excess(share * reserve(speed)), here)


def _ratio(own: float, other: float) -> float:
    """Ratio of two reserves, 1 where one of them has no size."""
    return own / other if 0.0 < own < math.inf and 0.0 < other < math.inf else 1.0
