"""The footstep by narrow-groove theory: face and clearance, each with one temperature that its heat balance gives.

Each film is as warm as ``theta = theta_w + heat/(G_w/2 + rho_c |Q|)`` where metal and incoming oil have the same
temperature; both films share the conductance G_w of the metal in equal halves (an assumption). The heat is
proportional to the viscosity, and that falls exponentially: the temperature is closed by Lambert's W, so that one
unknown is left, the flow Q of the clearance towards the rim. The face gap is fed by the same flow.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.face import Face, number, quadrature
from babbitt.kinds.footstep.model import Footstep, LoadReference
from babbitt.kinds.footstep.narrow_groove import NarrowGrooveAnnulus

__all__ = ["ThermalFilms", "ThermalFilmPair"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ThermalFilmPair:
    """Both films at one flow towards the rim; arrays or numbers, SI."""

    flow: Array
    annulus_pressure: Array
    annulus_temperature: Array
    face_pressure: Array
    face_temperature: Array

    @property
    def residual(self) -> Array:
        """Pressure of the rim by the clearance less that by the face gap, Pa."""
        return self.annulus_pressure - self.face_pressure


@dataclass(frozen=True)
class ThermalFilms:
    """Balance of the footstep in the flow of the clearance towards the rim."""

    footstep: Footstep
    annulus: NarrowGrooveAnnulus = field(init=False)
    face: Face = field(init=False)
    shear: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "annulus", NarrowGrooveAnnulus(self.footstep))
        object.__setattr__(self, "face", Face(self.footstep))
        object.__setattr__(self, "shear", self.face.shear_power(1.0, self.footstep.angular_speed))

    def temperature(self, heat: Array, flow: Array) -> Array:
        """Temperature, K, of a film with a heat over mu, m³/s², and a flow, m³/s."""
        from scipy.special import lambertw

        oil, wall = self.footstep.oil, self.footstep.wall
        if wall is None:
            return np.full_like(flow, oil.temperature)
        metal, stream = 0.5 * wall.conductance, oil.heat_capacity * np.abs(flow)
        capacity = np.maximum(metal + stream, 1e-12)  # neither metal nor flow: as hot as can be
        # The metal takes what lies above its own temperature, the oil what lies above that of the inlet.
        start = (metal * wall.temperature + stream * oil.temperature) / capacity
        viscosity = oil.viscosity * np.exp(-oil.exponent * (start - oil.temperature))
        rise = viscosity * heat / capacity
        if oil.exponent:
            rise = np.real(lambertw(oil.exponent * rise)) / oil.exponent
        return np.asarray(start + rise)

    def viscosity(self, temperature: Array) -> Array:
        """Pa s at a temperature in K."""
        oil = self.footstep.oil
        return np.asarray(oil.viscosity * np.exp(-oil.exponent * (temperature - oil.temperature)))

    def state(self, flow: Array) -> ThermalFilmPair:
        """Both films at flows towards the rim in m³/s."""
        step = self.footstep
        warm = self.temperature(self.annulus.heat(flow), flow)
        rise = self.viscosity(warm) * self.annulus.pressure_rise(flow)
        drag = 6.0 * step.kappa / math.pi  # (p1 - p2)/(mu Q) of the face gap
        face_warm = self.temperature(self.shear + drag * flow**2, flow)
        face_pressure = step.supply_pressure + drag * self.viscosity(face_warm) * flow
        return ThermalFilmPair(flow, step.ambient_pressure + rise, warm, face_pressure, face_warm)

    def residual(self, flow: Array) -> Array:
        """Pressure of the rim by the clearance less that by the face gap, Pa."""
        return self.state(flow).residual

    def film_slopes(self, flow: float, warm: Array) -> tuple[Array, Array]:
        """Slopes of both balances at temperatures of clearance and face gap, for the stability of a state.

        Parameters
        ----------
        flow : float
            Towards the rim, m³/s.
        warm : ndarray, shape (2,)
            Temperatures of clearance and face gap, K.

        Returns
        -------
        pressures : ndarray, shape (3,)
            d(pressure of the rim by the clearance less that by the face gap) by flow and by each temperature.
        heats : ndarray, shape (2, 2)
            d(viscous heat less what metal and oil take), W, of each film by flow and by its own temperature.
        """
        oil, wall = self.footstep.oil, self.footstep.wall
        metal = 0.0 if wall is None else 0.5 * wall.conductance
        drag = 6.0 * self.footstep.kappa / math.pi
        viscosity = self.viscosity(warm)
        rise = float(self.annulus.pressure_rise(number(flow)))
        pressures = np.array(
            (
                -viscosity[0] / self.annulus.conductance - drag * viscosity[1],
                -oil.exponent * viscosity[0] * rise,
                oil.exponent * viscosity[1] * drag * flow,
            )
        )
        step = 1e-6 * max(abs(flow), 1e-3 * abs(self.annulus.dragged_flow), 1e-12)
        less, more = (float(self.annulus.heat(number(flow + sign * step))) for sign in (-1.0, 1.0))
        heat = np.array((float(self.annulus.heat(number(flow))), self.shear + drag * flow**2))
        by_flow = viscosity * np.array(((more - less) / (2.0 * step), 2.0 * drag * flow))
        by_flow -= oil.heat_capacity * math.copysign(1.0, flow) * (warm - oil.temperature)
        by_warmth = -oil.exponent * viscosity * heat - metal - oil.heat_capacity * abs(flow)
        return pressures, np.column_stack((by_flow, by_warmth))

    def of(self, footstep: Footstep) -> ThermalFilms:
        """The same model of another footstep."""
        return ThermalFilms(footstep)

    def load_and_residual(self, unknown: float) -> tuple[float, float]:
        """Axial load in N, and residual in Pa, at a flow towards the rim in m³/s."""
        at = self.state(number(unknown))
        return self.load(at), float(at.residual)

    def friction_power(self, at: ThermalFilmPair) -> float:
        """Power that turns the heel, W."""
        cylinder = float(self.viscosity(at.annulus_temperature)) * float(self.annulus.wall_power(at.flow))
        return cylinder + float(self.viscosity(at.face_temperature)) * self.shear

    def edge_pressure(self, at: ThermalFilmPair) -> float:
        """p3 at the edge of the recess, Pa."""
        part, step = self.footstep.geometry, self.footstep
        inner = math.log(part.recess_radius / part.bore_radius) / part.recess_depth**3 / step.kappa
        return step.supply_pressure + (float(at.face_pressure) - step.supply_pressure) * inner

    def load(self, at: ThermalFilmPair) -> float:
        """Axial load in N; one viscosity in the face gap."""
        part, step = self.footstep.geometry, self.footstep
        nodes, weights = quadrature(40)
        width = part.radius - part.recess_radius
        radius = part.recess_radius + width * nodes
        drop = step.supply_pressure - float(at.face_pressure)
        pressure = step.supply_pressure - drop * self.face.resistance_to(radius) / step.kappa
        recess = math.pi * (part.recess_radius**2 - part.bore_radius**2)
        load = 2.0 * math.pi * width * float(weights @ (pressure * radius))
        load += 0.5 * recess * (step.supply_pressure + self.edge_pressure(at))
        if step.options.load_reference is LoadReference.GAUGE:
            load -= math.pi * (part.radius**2 - part.bore_radius**2) * step.ambient_pressure
        return load
