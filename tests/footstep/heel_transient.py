"""A grooved heel in time, by the study's equations: pressures in balance, heat carried along the groove.

Nothing of the product's rule of stability stands here: the reciprocal viscosity phi = mu0/mu of the groove is
marched on nodes (upwind, exact for the straight profile of the steady state), the clearance holds oil of one
temperature, and at every instant the groove flow is that which balances the rim with the temperatures as they
are.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from babbitt.kinds.footstep.face import number
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.superposition import GroovedFootstep

NODES = 60
"""Along the groove."""


@dataclass
class HeelInTime:
    """State of groove and clearance; positive flow: towards the rim."""

    footstep: Footstep
    flow: float
    phi: np.ndarray
    clearance_temperature: float
    largest_step: float = 0.05
    model: GroovedFootstep = field(init=False)

    def __post_init__(self):
        self.model = GroovedFootstep(self.footstep)
        part = self.footstep.geometry
        self.clearance_volume = 2.0 * math.pi * part.radius * part.length * self.footstep.clearance

    @classmethod
    def at(cls, footstep, state, warmer=0.0, nodes=NODES):
        """Start from a steady state whose groove feeds the rim, its rise of temperature changed by a share."""
        oil = footstep.oil
        end = math.exp(oil.exponent * (state.groove_temperature - oil.temperature))
        rise = np.log(np.linspace(1.0, end, nodes + 1)) * (1.0 + warmer)
        clearance = oil.temperature + (state.rim_temperature - oil.temperature) * (1.0 + warmer)
        return cls(footstep, state.groove_flow, np.exp(rise), clearance)

    def balance(self):
        """Set the groove flow that balances the rim now: the residual falls with it, whatever the temperatures."""
        step, oil, channel = self.footstep, self.footstep.oil, self.model.channel
        ratio = self.phi[1:] / self.phi[:-1] - 1.0
        mean = (
            np.where(np.abs(ratio) < 1e-9, 1.0, np.log1p(ratio) / np.where(ratio == 0.0, 1.0, ratio))
            / self.phi[:-1]
        )
        along = oil.viscosity * channel.length * float(mean.mean()) / channel.depth**3
        slit = self.model.slit / oil.at(self.clearance_temperature)
        drag = 6.0 * channel.speed * channel.depth

        def ends(flow):
            rim = step.ambient_pressure + (drag - 12.0 * flow / channel.width) * along
            return rim, float(self.model.face.flow(number(rim)))

        flow = self.flow
        for _ in range(60):
            rim, face = ends(flow)
            slope = -12.0 * along / channel.width
            face_slope = (ends(flow * (1.0 + 1e-6) + 1e-16)[1] - face) / (flow * 1e-6 + 1e-16)
            change = (slit * (rim - step.ambient_pressure) - flow - face) / (slit * slope - 1.0 - face_slope)
            flow -= change
            if abs(change) < 1e-12 * abs(flow) + 1e-20:
                break
        else:
            raise AssertionError("the balance of the rim was not found")
        self.flow = flow
        self.rim_pressure, self.face_flow = ends(flow)
        self.face_temperature = float(
            self.model.face.outlet_temperature(number(self.face_flow), number(self.rim_pressure))
        )

    def march(self, span, until=lambda heel: False):
        """Go on for a time in s, or until something is so; give the time."""
        oil, channel = self.footstep.oil, self.model.channel
        time, spacing = 0.0, channel.length / (self.phi.size - 1)
        while time < span:
            self.balance()
            if until(self):
                break
            q = self.flow / channel.width
            n = 6.0 * (channel.speed * channel.depth - 2.0 * q)
            m3 = n * n + 12.0 * (channel.depth * channel.speed) ** 2
            source = oil.exponent * oil.viscosity * m3 / (12.0 * oil.heat_capacity * channel.depth**4)
            speed, out = q / channel.depth, max(self.face_flow, 0.0)
            into = max(self.flow, 0.0) + out
            dt = min(
                0.5 * spacing / abs(speed), 0.1 * self.clearance_volume / into, self.largest_step, span - time
            )
            hot = oil.temperature + math.log(self.phi[-1]) / oil.exponent
            if q > 0.0:
                mixed = (self.flow * hot + out * self.face_temperature) / into
                self.phi[1:] += dt * (source - speed * np.diff(self.phi) / spacing)
            else:
                mixed = self.face_temperature
                self.phi[-1] = math.exp(oil.exponent * (mixed - oil.temperature))
                self.phi[:-1] += dt * (source - speed * np.diff(self.phi) / spacing)
            self.clearance_temperature += dt * into / self.clearance_volume * (mixed - self.clearance_temperature)
            time += dt
        return time
