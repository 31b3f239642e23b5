"""Clearances at which the picture changes: where the face gap runs dry, and where the steady states vanish."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from babbitt.kinds.footstep.eccentric import leak_factor
from babbitt.kinds.footstep.face import number
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.states import crossings, has_steady_state
from babbitt.kinds.footstep.superposition import GrooveChannel, GroovedFootstep

__all__ = ["CriticalClearance", "critical_clearances", "fold_clearance", "at_clearance"]


SMALLEST = 0.02
"""Of the clearance of the case, down to which a fold is sought."""


@dataclass(frozen=True)
class CriticalClearance:
    """Where no oil passes the face gap: the rim has the pressure of the recess.

    Attributes
    ----------
    clearance : float
        delta_cr, m. It does not depend on the face gap.
    groove_flow : float
        m³/s.
    temperature : float
        Of the oil at the end of the groove, K.
    """

    clearance: float
    groove_flow: float
    temperature: float


def at_clearance(footstep: Footstep, clearance: float) -> Footstep:
    """The same footstep with another clearance; eccentricity over clearance and tilt over clearance stay."""
    tilt = footstep.tilt * clearance / footstep.clearance
    return replace(footstep, clearance=clearance, tilt=tilt)


def critical_clearances(footstep: Footstep) -> tuple[CriticalClearance, ...]:
    """Clearances with Q2 = 0 by superposition (K1), the hot one first; none if the groove never reaches p2."""
    channel = GrooveChannel(footstep)
    flows = channel.largest_flow * np.union1d(np.geomspace(1e-6, 1.0, 600), np.linspace(0.0, 1.0, 601)[1:])

    def excess(flow: np.ndarray) -> np.ndarray:
        return channel.end(flow)[0] - footstep.supply_pressure

    part, oil = footstep.geometry, footstep.oil
    leak = leak_factor(*footstep.end_eccentricities)
    found = []
    for root in crossings(excess, flows, excess(flows), 1e-20):
        temperature = float(channel.end(number(root))[1])
        slit = math.pi * part.radius * leak * (footstep.supply_pressure - footstep.ambient_pressure)
        cube = 6.0 * oil.at(temperature) * part.length * root / slit
        found.append(CriticalClearance(cube ** (1.0 / 3.0), root, temperature))
    return tuple(found)


def fold_clearance(footstep: Footstep, tolerance: float = 1e-10) -> float | None:
    """Smallest clearance, m, at which the grooved heel has a steady state at its face gap, by superposition.

    Parameters
    ----------
    footstep : Footstep
        Its clearance is where the search begins.
    tolerance : float
        m.

    Returns
    -------
    float or None
        None where states exist down to a fiftieth of the clearance, as for a viscosity that does not change.
    """

    def exists(clearance: float) -> bool:
        return has_steady_state(GroovedFootstep(at_clearance(footstep, clearance)))

    high = footstep.clearance
    while not exists(high):
        high *= 2.0
        if high > 1e3 * footstep.clearance:
            return None
    low = high
    while exists(low):
        high, low = low, 0.87 * low
        if low < SMALLEST * footstep.clearance:
            return None
    while high - low > tolerance:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if exists(middle) else (middle, high)
    return high
