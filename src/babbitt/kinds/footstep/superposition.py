"""The study's own equations, corrected: an adiabatic groove beside a full slit, and all their steady states.

Source: A. S. Kirichenko, Problems of Tribology, 2011 (footstep of a three-screw pump). Corrected are: N in place
of L in the pressure of the groove (the print has the wrong unit), the gap of the recess in the outlet temperature
of the face, the missing speed in the friction power of the smooth heel, the land width in the friction of the
lands.

Symbols of the kernels: Q_k groove flow towards the rim and q = Q_k/(z_n a), U wall speed along the groove, h_k
depth, l length of the groove, N = 6 (U h_k - 2 q), M3 = N² + 12 (h_k U)², M4 = 12 q rho_c h_k³, R = Q_l - Q_k -
Q2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.eccentric import leak_factor, mean_inverse_gap
from babbitt.kinds.footstep.face import Face, log_growth, number
from babbitt.kinds.footstep.model import BackflowViscosity, Footstep, FrictionViscosity

__all__ = ["GrooveChannel", "GroovedFootstep", "SmoothFootstep"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class GrooveChannel:
    """Thin film along the groove, its smooth wall moving with U, no heat to the walls (G1 to G5)."""

    footstep: Footstep
    speed: float = field(init=False)
    length: float = field(init=False)
    width: float = field(init=False)

    def __post_init__(self) -> None:
        step = self.footstep
        assert step.groove is not None, "a smooth heel has no groove"
        groove = step.groove
        object.__setattr__(
            self, "speed", step.groove_speed * step.geometry.radius * math.cos(groove.angle)
        )  # U along the groove
        object.__setattr__(self, "length", step.geometry.length / math.sin(groove.angle))
        object.__setattr__(self, "width", groove.starts * groove.groove_width)

    @property
    def depth(self) -> float:
        """h_k, m."""
        assert self.footstep.groove is not None
        return self.footstep.groove.depth

    @property
    def largest_flow(self) -> float:
        """Q_k,max in m³/s: the groove drags it without any rise of pressure (G5)."""
        return 0.5 * self.width * self.speed * self.depth

    @property
    def dead_end_rise(self) -> float:
        """Rise of pressure, Pa, of a groove without flow whose oil stays cold: 6 mu0 U l/h_k²."""
        return 6.0 * self.footstep.oil.viscosity * self.speed * self.length / self.depth**2

    def end(self, flow: Array) -> tuple[Array, Array]:
        """Pressure, Pa, and temperature, K, at the rim end of the groove for a flow in m³/s (G3, G4)."""
        oil, step = self.footstep.oil, self.footstep
        q = flow / self.width
        n = 6.0 * (self.speed * self.depth - 2.0 * q)
        m3 = n * n + 12.0 * (self.depth * self.speed) ** 2
        m4 = 12.0 * oil.heat_capacity * self.depth**3 * q
        rise = log_growth(oil.exponent, oil.viscosity * self.length * m3 / m4)
        pressure = step.ambient_pressure + n * m4 / (self.depth**3 * m3) * rise
        if step.options.entry_loss:
            pressure = pressure - 0.5 * step.options.entry_loss * oil.density * (q / self.depth) ** 2
        return pressure, oil.temperature + rise


@dataclass(frozen=True)
class Balance:
    """Everything at the rim for one groove flow; arrays or numbers, SI."""

    groove_flow: Array
    rim_pressure: Array
    groove_temperature: Array
    face_flow: Array
    face_temperature: Array
    rim_temperature: Array
    leakage: Array

    @property
    def residual(self) -> Array:
        """R = Q_l - Q_k - Q2, m³/s: what leaves the rim less what comes."""
        return self.leakage - self.groove_flow - self.face_flow


def slit_conductance(footstep: Footstep) -> float:
    """Q_l mu_c/(p1 - p_a) in m³ (C1), with the leak factor of an eccentric or tilted heel."""
    part = footstep.geometry
    plane = math.pi * part.radius * footstep.clearance**3 / (6.0 * part.length)
    return plane * leak_factor(*footstep.end_eccentricities)


@dataclass(frozen=True)
class GroovedFootstep:
    """Balance of the grooved heel in its one unknown, the groove flow (B2)."""

    footstep: Footstep
    channel: GrooveChannel = field(init=False)
    face: Face = field(init=False)
    slit: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "channel", GrooveChannel(self.footstep))
        object.__setattr__(self, "face", Face(self.footstep))
        object.__setattr__(self, "slit", slit_conductance(self.footstep))

    def balance(self, groove_flow: Array) -> Balance:
        """Pressures, temperatures and flows for groove flows in m³/s."""
        step, oil = self.footstep, self.footstep.oil
        pressure, hot = self.channel.end(groove_flow)
        hot_viscosity: Array | float = 0.0
        if step.options.backflow_viscosity is BackflowViscosity.GROOVE:
            hot_viscosity = oil.viscosity * np.exp(-oil.exponent * (hot - oil.temperature))
        face_flow = self.face.flow(pressure, hot_viscosity)
        outlet = self.face.outlet_temperature(face_flow, pressure)
        inward = np.maximum(face_flow, 0.0)
        mixed = (hot * groove_flow + outlet * inward) / (groove_flow + inward)
        viscosity = oil.viscosity * np.exp(-oil.exponent * (mixed - oil.temperature))
        leakage = self.slit * (pressure - step.ambient_pressure) / viscosity
        return Balance(groove_flow, pressure, hot, face_flow, outlet, mixed, leakage)

    def residual(self, groove_flow: Array) -> Array:
        """R in m³/s."""
        return self.balance(groove_flow).residual

    def of(self, footstep: Footstep) -> GroovedFootstep:
        """The same model of another footstep."""
        return GroovedFootstep(footstep)

    def load_at(self, unknown: float) -> float:
        """Axial load in N at a value of the unknown."""
        return self.load(self.balance(number(unknown)))

    def load_and_residual(self, unknown: float) -> tuple[float, float]:
        """Axial load in N and R in m³/s at a value of the unknown."""
        at = self.balance(number(unknown))
        return self.load(at), float(at.residual)

    def friction_power(self, at: Balance) -> float:
        """Friction power in W (P1, P3, P4)."""
        step, oil = self.footstep, self.footstep.oil
        groove, part = step.groove, step.geometry
        assert groove is not None
        hot, mixed, outlet = (float(t) for t in (at.groove_temperature, at.rim_temperature, at.face_temperature))
        if step.options.friction_viscosity is FrictionViscosity.MEAN:
            viscosity = 0.5 * (oil.viscosity + oil.at(hot))
        else:
            viscosity = oil.at(mixed)
        length = self.channel.length * groove.starts
        over_gap = groove.land_width * mean_inverse_gap(step)
        over_gap += groove.groove_width * mean_inverse_gap(step, groove.depth)
        cylinder = viscosity * length * over_gap * (step.groove_speed * part.radius) ** 2
        inner = hot if self._feeds_hot(at) else outlet
        face_viscosity = oil.at(inner) if self._feeds_hot(at) else oil.at(0.5 * (oil.temperature + outlet))
        return cylinder + self.face.shear_power(face_viscosity, step.groove_speed)

    def _feeds_hot(self, at: Balance) -> bool:
        """Whether the rim feeds the recess with the oil of the groove."""
        return (
            float(at.face_flow) < 0.0
            and self.footstep.options.backflow_viscosity is BackflowViscosity.GROOVE
        )  # fmt: skip

    def load(self, at: Balance) -> float:
        """Axial load in N."""
        hot = self.footstep.oil.at(float(at.groove_temperature))
        return self.face.load(float(at.face_flow), float(at.rim_pressure), hot)


@dataclass(frozen=True)
class SmoothFootstep:
    """Balance of the smooth heel in its one unknown, the pressure of the rim (S1)."""

    footstep: Footstep
    face: Face = field(init=False)
    slit: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "face", Face(self.footstep))
        object.__setattr__(self, "slit", slit_conductance(self.footstep))

    def balance(self, rim_pressure: Array) -> Balance:
        """Flows and temperatures at a pressure of the rim in Pa; the groove flow is zero."""
        step, oil = self.footstep, self.footstep.oil
        face_flow = self.face.flow(rim_pressure)
        outlet = self.face.outlet_temperature(face_flow, rim_pressure)
        viscosity = oil.viscosity * np.exp(-oil.exponent * (outlet - oil.temperature))
        leakage = self.slit * (rim_pressure - step.ambient_pressure) / viscosity
        none = np.zeros_like(rim_pressure)
        return Balance(none, rim_pressure, outlet, face_flow, outlet, outlet, leakage)

    def residual(self, rim_pressure: Array) -> Array:
        """Leakage less the flow of the face, m³/s; it rises with the pressure of the rim."""
        return self.balance(rim_pressure).residual

    def of(self, footstep: Footstep) -> SmoothFootstep:
        """The same model of another footstep."""
        return SmoothFootstep(footstep)

    def load_and_residual(self, unknown: float) -> tuple[float, float]:
        """Axial load in N and R in m³/s at a value of the unknown."""
        at = self.balance(number(unknown))
        return self.load(at), float(at.residual)

    def friction_power(self, at: Balance) -> float:
        """Friction power in W (P2, P3, P4)."""
        step, oil, part = self.footstep, self.footstep.oil, self.footstep.geometry
        outlet = float(at.face_temperature)
        cylinder = 2.0 * math.pi * part.radius * part.length * mean_inverse_gap(step)
        power = oil.at(outlet) * cylinder * (step.groove_speed * part.radius) ** 2
        return power + self.face.shear_power(oil.at(0.5 * (oil.temperature + outlet)), step.groove_speed)

    def load(self, at: Balance) -> float:
        """Axial load in N."""
        return self.face.load(float(at.face_flow), float(at.rim_pressure), self.footstep.oil.viscosity)
