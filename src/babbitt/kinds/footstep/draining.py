"""A groove that drains the rim: where it cannot hold back the pressure there, oil leaves through it to ambient.

The equations of the groove (G1, G2) hold for a flow of either sign; with the oil coming from the rim they
integrate from there. With ``q < 0``, ``M4 = 12 |q| rho_c h_k³`` and mu_c the viscosity at the rim
    p1 = p_a + N M4/(alpha h_k³ M3) ln(1 + mu_c alpha M3 l/M4)

The face alone feeds the rim, so that everything follows from its pressure: Q2, theta = theta1'', Q_l, and ``Q_k
= Q_l - Q2``. What remains is that the groove takes this flow at this pressure. The groove takes nothing where
the rim has the pressure of the smooth heel; with a viscosity that falls there is a state at some lower pressure,
always.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.face import log_growth, number
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.superposition import Balance, GroovedFootstep, SmoothFootstep, slit_conductance
from babbitt.numerics.roots import bracketed_root

__all__ = ["DrainedFootstep", "cold_groove_drains"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class DrainedFootstep:
    """Balance of a heel whose groove drains the rim, in the pressure of the rim."""

    footstep: Footstep
    heel: GroovedFootstep = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "heel", GroovedFootstep(self.footstep))

    def balance(self, rim_pressure: Array) -> Balance:
        """Flows and temperatures at a pressure of the rim, Pa; that of the groove at its outer end."""
        step, oil, channel = self.footstep, self.footstep.oil, self.heel.channel
        face_flow = self.heel.face.flow(rim_pressure)
        warm = self.heel.face.outlet_temperature(face_flow, rim_pressure)
        viscosity = oil.viscosity * np.exp(-oil.exponent * (warm - oil.temperature))
        leakage = self.heel.slit * (rim_pressure - step.ambient_pressure) / viscosity
        groove = leakage - face_flow
        m3, m4 = self._heating(groove)
        rise = log_growth(oil.exponent, viscosity * channel.length * m3 / m4)
        return Balance(groove, rim_pressure, warm + rise, face_flow, warm, warm, leakage)

    def _heating(self, groove_flow: Array) -> tuple[Array, Array]:
        """M3 and M4 of the groove, with the amount of its flow."""
        channel, oil = self.heel.channel, self.footstep.oil
        q = groove_flow / channel.width
        n = 6.0 * (channel.speed * channel.depth - 2.0 * q)
        m4 = 12.0 * oil.heat_capacity * channel.depth**3 * np.maximum(np.abs(q), 1e-300)
        return n * n + 12.0 * (channel.depth * channel.speed) ** 2, m4

    def residual(self, rim_pressure: Array) -> Array:
        """Pressure at which the groove takes what is left over at the rim, less that of the rim, Pa."""
        return self._defect(self.balance(rim_pressure))

    def _defect(self, at: Balance) -> Array:
        """`residual` of a balance."""
        channel = self.heel.channel
        q = at.groove_flow / channel.width
        n = 6.0 * (channel.speed * channel.depth - 2.0 * q)
        m3, m4 = self._heating(at.groove_flow)
        rise = at.groove_temperature - at.rim_temperature
        held = self.footstep.ambient_pressure + n * m4 / (channel.depth**3 * m3) * rise
        return np.asarray(held - at.rim_pressure)

    def of(self, footstep: Footstep) -> DrainedFootstep:
        """The same model of another footstep."""
        return DrainedFootstep(footstep)

    def load(self, at: Balance) -> float:
        """Axial load in N."""
        return self.heel.load(at)

    def load_and_residual(self, unknown: float) -> tuple[float, float]:
        """Axial load in N, and residual in Pa, at a pressure of the rim."""
        at = self.balance(number(unknown))
        return self.load(at), float(self._defect(at))

    def friction_power(self, at: Balance) -> float:
        """Friction power in W (P1, P3, P4)."""
        return self.heel.friction_power(at)

    def pressures(self, samples: int) -> Array:
        """Pressures of the rim from ambient to that of the smooth heel, Pa, finer towards the latter."""
        step = self.footstep
        smooth = SmoothFootstep(replace(step, groove=None))
        top = bracketed_root(
            lambda p: float(smooth.residual(number(p))), step.ambient_pressure, step.supply_pressure, 1e-7
        )
        span = top - step.ambient_pressure
        below = np.union1d(np.geomspace(1e-9, 1.0, samples), np.linspace(0.0, 1.0, samples + 1)[1:])
        return np.asarray(top - span * below[::-1])


def cold_groove_drains(footstep: Footstep) -> bool:
    """Whether the groove, all oil at the temperature of the inlet, cannot hold back the rim of the smooth heel."""
    heel, oil = GroovedFootstep(footstep), footstep.oil
    leak = slit_conductance(footstep) / oil.viscosity
    face = np.pi / (6.0 * oil.viscosity * footstep.kappa)
    smooth = face / (leak + face) * (footstep.supply_pressure - footstep.ambient_pressure)
    return bool(smooth > heel.channel.dead_end_rise)
