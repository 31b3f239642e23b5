"""What a steady state of a footstep is: its name, its stability, and everything a designer asks of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.picklable_error import PicklableError

__all__ = ["Method", "NoSteadyStateError", "StateName", "SteadyState"]


class Method(Enum):
    """By which equations a footstep is computed."""

    SUPERPOSITION = "superposition"
    NARROW_GROOVE = "narrow_groove"


class StateName(Enum):
    """Which of several steady states."""

    SMOOTH = "smooth"
    HOT = "hot"
    COLD = "cold"
    MIDDLE = "middle"
    ONLY = "grooved"
    FOLD = "fold"
    DRAINING = "draining"


class NoSteadyStateError(PicklableError):
    """At every flow of a groove that feeds the rim, the rim receives more oil than the clearance can carry away.

    Attributes
    ----------
    largest_residual : float
        Largest outflow less inflow of the rim, m³/s; negative.
    groove_flow, rim_pressure : float
        Where that is: m³/s and Pa.
    failure : Notice
        The same as a clause.
    """

    def __init__(self, largest_residual: float, groove_flow: float, rim_pressure: float) -> None:
        self.failure = Notice("S020", "nearest", {
            "groove_flow": groove_flow, "rim_pressure": rim_pressure, "too_much": -largest_residual,
        })  # fmt: skip
        super().__init__(self.failure.message)
        self.largest_residual, self.groove_flow, self.rim_pressure = largest_residual, groove_flow, rim_pressure


@dataclass(frozen=True)
class SteadyState:
    """One steady state; SI, absolute pressures and temperatures.

    Attributes
    ----------
    name : StateName
    stable : bool
        Whether every small disturbance of the oil's temperature decays, with pressures in balance.
    loop_gain : float
        Share of a small lasting disturbance of temperature that comes back through viscosity and flow.
    rim_pressure : float
        p1.
    face_flow, leakage, groove_flow : float
        Q2 from recess to rim, Q_l to ambient, Q_k towards the rim; by narrow-groove theory the leakage is the net
        flow of the clearance and the groove flow is not a number, since both are one film.
    rim_temperature, face_temperature, groove_temperature : float
        theta, theta1'', theta1'; by narrow-groove theory the films have one temperature each: the first is that of
        the clearance, the second that of the face, the third is not a number.
    load, friction_power : float
    axial_stiffness, axial_damping : float
        K = -dT/dh and D = -dT/dh', h the face gap.
    load_over_clearance : float
        dT/ddelta, N/m.
    side_force : float
        Of the pressure of the leakage, along the eccentricity, towards larger eccentricity.
    residual : float
        Relative error of the balance.
    """

    name: StateName
    stable: bool
    loop_gain: float
    rim_pressure: float
    face_flow: float
    leakage: float
    groove_flow: float
    rim_temperature: float
    face_temperature: float
    groove_temperature: float
    load: float
    friction_power: float
    axial_stiffness: float
    axial_damping: float
    load_over_clearance: float
    side_force: float
    residual: float

    @property
    def maximum_temperature(self) -> float:
        """Hottest mean temperature of a film, K."""
        return float(np.nanmax((self.rim_temperature, self.face_temperature, self.groove_temperature)))
