"""When the journal of a hydrostatic or hybrid bearing whirls."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.answer import Answer, answer
from babbitt.kinds.hydrostatic.impedance import impedance
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.state import SearchOutcome
from babbitt.reynolds.stability.rotor import RIGID, stable_masses_of_rotor
from babbitt.reynolds.stability.routh import whirl_frequency
from babbitt.reynolds.stability.whirl_limits import (
    ElasticWhirl,
    Threshold,
    Whirl,
    crossing,
    rotor_mass,
    stability_excess,
)

__all__ = ["coefficients_on_threshold", "whirl_of"]

Array = NDArray[np.float64]

MOST_ROUNDS, FREQUENCY_TOLERANCE = 40, 1e-6
"""Rounds between whirl frequency and the coefficients at it, and what of the frequency they may still move."""


def whirl_of(case: HydrostaticCase, found: Answer) -> Whirl | None:
    """Stability of a rotor at the state of a journal bearing, and the speed at which it begins to whirl.

    Compressible oil in the recesses makes stiffness and damping depend on frequency: those at the frequency of
    the whirl itself decide. The threshold keeps load, viscosity and supply. None for pads, for a journal at rest,
    which cannot whirl, and where the coefficients at the whirl frequency are not found.
    """
    if not case.is_journal or case.duty.angular_speed == 0.0:
        return None
    film = coefficients_on_threshold(case, found)
    if film is None:
        return None
    load, shaft = float(np.hypot(*found.response.force)), case.shaft_stiffness
    mass = rotor_mass(case.rotor_mass, load)
    elastic = None
    if shaft is not None:
        own = stable_masses_of_rotor(*film, shaft_stiffness=shaft)
        elastic = ElasticWhirl(own, rotor_threshold(case, found, mass, shaft))
    return Whirl(
        stable_masses_of_rotor(*film),
        whirl_frequency(*film) / abs(case.duty.angular_speed),
        mass,
        rotor_threshold(case, found, mass),
        elastic,
    )


def coefficients_on_threshold(case: HydrostaticCase, found: Answer) -> tuple[Array, Array] | None:
    """Stiffness and damping at the frequency of the whirl that they allow; None where no frequency agrees.

    The limit of slow motion where the film cannot whirl.
    """
    frequency = 0.0
    for _ in range(MOST_ROUNDS):
        film = impedance(found.response, found.network, case.compressibility, frequency)
        own = whirl_frequency(*film)
        if abs(own - frequency) <= FREQUENCY_TOLERANCE * own:
            return film
        frequency = own
    return None


def rotor_threshold(case: HydrostaticCase, found: Answer, mass: float, shaft: float = RIGID) -> Threshold:
    """Speed in rad/s above which a rotor whirls, nearest to the operating speed."""
    force = found.response.force
    sense = math.copysign(1.0, case.duty.angular_speed)
    under = replace(
        case.duty,
        load=float(np.hypot(*force)),
        load_angle=math.atan2(-float(force[1]), -float(force[0])),
        position=(0.0, 0.0),
    )

    def excess(speed: float) -> float:
        other = replace(case, duty=replace(under, angular_speed=sense * speed))
        state = answer(other)
        film = coefficients_on_threshold(other, state) if state.ending is SearchOutcome.SOLVED else None
        if film is None:
            return math.nan
        return stability_excess(stable_masses_of_rotor(*film, shaft_stiffness=shaft).reserve(mass))

    return crossing(excess, abs(case.duty.angular_speed))
