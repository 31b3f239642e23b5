"""Narrow-groove theory of the clearance: grooves and lands as one film, with the heat that the metal takes.

Many narrow grooves make one film with a preferred direction: the pressure gradient along the groove is the same
in groove and land, the flow across is the same in both, and the mean gradient around the heel vanishes (J. H.
Vohr and C. Y. Chow, Journal of Basic Engineering 87 (1965) 568-578; E. A. Muijderman, Spiral Groove Bearings,
1966). Everything per mu: flow that the groove drags does not depend on the viscosity, pressures and powers are
proportional to it.

Symbols of the kernels: gamma share of grooves, h_r = delta over lands, h_g = delta + h_k over grooves, V = omega0
r1, S2 = gamma/h_g² + (1-gamma)/h_r², S3 = gamma/h_g³ + (1-gamma)/h_r³, G = (dp/dz)/mu.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.face import quadrature
from babbitt.kinds.footstep.model import Footstep

__all__ = ["NarrowGrooveAnnulus"]

Array = NDArray[np.float64]
AROUND, ALONG = 96, 12
"""Points around and along an eccentric or tilted heel."""


@dataclass(frozen=True)
class NarrowGrooveAnnulus:
    """Flow and friction of the clearance; eccentric and tilted heels by their local film thickness.

    Parameters
    ----------
    footstep : Footstep
        Without groove: the plain clearance.
    """

    footstep: Footstep
    gamma: float = field(init=False)
    depth: float = field(init=False)
    sine: float = field(init=False)
    cosine: float = field(init=False)

    def __post_init__(self) -> None:
        groove = self.footstep.groove
        values = (
            {"gamma": 0.0, "depth": 0.0, "sine": 1.0, "cosine": 0.0}
            if groove is None
            else {
                "gamma": groove.groove_share,
                "depth": groove.depth,
                "sine": math.sin(groove.angle),
                "cosine": math.cos(groove.angle),
            }
        )
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @property
    def speed(self) -> float:
        """V = omega0 r1, m/s."""
        return self.footstep.angular_speed * self.footstep.geometry.radius

    @cached_property
    def thickness(self) -> Array:
        """Film over the lands, m, around (rows) and along the heel (columns, at Gauss points from the rim)."""
        rim, outer = self.footstep.end_eccentricities
        delta = self.footstep.clearance
        if rim == outer == 0.0:
            return np.full((1, 1), delta)
        cosine = np.cos(2.0 * math.pi * np.arange(AROUND) / AROUND)[:, None]
        if rim == outer:
            return delta * (1.0 - rim * cosine)
        along = quadrature(ALONG)[0][None, :]
        return np.asarray(delta * (1.0 - (rim + (outer - rim) * along) * cosine))

    @cached_property
    def _weights(self) -> Array:
        """Weights of the columns of `thickness`."""
        columns = self.thickness.shape[1]
        return np.ones(1) if columns == 1 else quadrature(columns)[1]

    def _moments(self) -> tuple[Array, Array, Array, Array]:
        """h over land, over groove, S2 and S3."""
        land = self.thickness
        groove = land + self.depth
        share, rest = self.gamma, 1.0 - self.gamma
        return land, groove, share / groove**2 + rest / land**2, share / groove**3 + rest / land**3

    @cached_property
    def _local(self) -> tuple[Array, Array]:
        """Dragged flow, m²/s, and conductance times mu, m³, per length around the heel: q = q0 - g G."""
        land, groove, s2, s3 = self._moments()
        share, rest = self.gamma, 1.0 - self.gamma
        dragged = 0.5 * self.speed * self.sine * self.cosine * (share * groove + rest * land - s2 / s3)
        mean_cube = share * groove**3 + rest * land**3
        conductance = (mean_cube * self.sine**2 + self.cosine**2 / s3) / 12.0
        return dragged, conductance

    @cached_property
    def _strips(self) -> tuple[Array, Array]:
        """Around the heel: dragged flow times resistance, m⁻², and resistance, m⁻³, both means along it."""
        dragged, conductance = self._local
        return (dragged / conductance) @ self._weights, (1.0 / conductance) @ self._weights

    @cached_property
    def dragged_flow(self) -> float:
        """Q0 in m³/s: flow towards the rim without a difference of pressure."""
        pumped, resistance = self._strips
        return 2.0 * math.pi * self.footstep.geometry.radius * float(np.mean(pumped / resistance))

    @cached_property
    def conductance(self) -> float:
        """G mu in m³: what a difference of pressure takes from the flow, times the viscosity."""
        part = self.footstep.geometry
        return 2.0 * math.pi * part.radius / part.length * float(np.mean(1.0 / self._strips[1]))

    def pressure_rise(self, flow: Array) -> Array:
        """(p1 - p_a)/mu in 1/s for a flow towards the rim in m³/s."""
        return np.asarray((self.dragged_flow - flow) / self.conductance)

    @cached_property
    def _power_terms(self) -> tuple[float, float]:
        """Wall power over mu, m³/s², without a rise of pressure, and what a rise over mu adds, m³/s."""
        # The power is linear in the rise; a rise of the size to come keeps the difference above round-off.
        rise = self.speed * self.footstep.geometry.length / self.footstep.clearance**2
        at_rest, driven = self._wall_power(0.0), self._wall_power(rise)
        return at_rest, (driven - at_rest) / rise

    def _wall_power(self, rise: float) -> float:
        """Power of the wall over mu for a rise of pressure over mu."""
        part, speed = self.footstep.geometry, self.speed
        land, groove, s2, s3 = self._moments()
        dragged, conductance = self._local
        pumped, resistance = self._strips
        # One flow along each strip; where the film is thinner the gradient is steeper.
        strip_flow = (pumped - rise / part.length) / resistance
        gradient = (dragged - strip_flow[:, None]) / conductance
        along, across = speed * self.cosine, speed * self.sine
        flow_across = (0.5 * across * s2 + gradient * self.cosine / 12.0) / s3
        total = np.zeros_like(land)
        for share, film in ((self.gamma, groove), (1.0 - self.gamma, land)):
            gradient_across = 12.0 * (0.5 * across * film - flow_across) / film**3
            pressure_part = along * gradient * self.sine + across * gradient_across
            total += share * (speed**2 / film + 0.5 * film * pressure_part)
        return 2.0 * math.pi * part.radius * part.length * float(np.mean(total @ self._weights))

    def wall_power(self, flow: Array) -> Array:
        """Power of the turning wall over mu, m³/s², for a flow towards the rim."""
        first, second = self._power_terms
        return np.asarray(first + second * self.pressure_rise(flow))

    def heat(self, flow: Array) -> Array:
        """Viscous heat over mu, m³/s²: power of the wall less that which the flow takes to higher pressure."""
        return np.asarray(self.wall_power(flow) - flow * self.pressure_rise(flow))
