"""A long film in equilibrium, and what follows from its fields."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilm
from babbitt.kinds.journal.infinitely_long_bearing.network import Temperatures
from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, Pressure, circle
from babbitt.kinds.journal.infinitely_long_bearing.walls import Sectors, flow_of, flow_spread

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LongFilmState:
    """A long film in equilibrium, SI.

    `pressure`, `sectors` and `temperatures` hold arrays over the angle from the widest gap; loads are those along
    the eccentricity and normal to it. `residual` is the last change of temperature in K.
    """

    film: LongFilm
    gap: Gap
    viscosity: Array
    pressure: Pressure
    sectors: Sectors
    temperatures: Temperatures
    load_along: float
    load_across: float
    iterations: int
    converged: bool
    residual: float

    @property
    def eccentricity_ratio(self) -> float:
        """e/c."""
        return self.gap.eccentricity_ratio

    @property
    def load(self) -> float:
        """Resultant in N."""
        return math.hypot(self.load_along, self.load_across)

    @property
    def attitude_angle(self) -> float:
        """From the load to the narrowest gap, rad."""
        return math.atan2(self.load_across, self.load_along)

    @property
    def film_thickness(self) -> Array:
        """At the nodes, m."""
        return self.film.clearance * self.gap.nodes

    @property
    def film_pressure(self) -> Array:
        """At the nodes, Pa."""
        return self.pressure.nodes * (self.film.surface_speed * self.film.radius / self.film.clearance**2)

    @property
    def flow(self) -> float:
        """Circumferential flow in m³/s; its mean over the full film where it is not conserved."""
        full = self.pressure.full
        return float(flow_of(self.film, self.pressure) @ full) / float(full.sum())

    @property
    def flow_spread(self) -> float:
        """``(max Q - min Q)/mean Q`` of the local flow over the full film."""
        return flow_spread(self.pressure)

    @property
    def heat_source(self) -> float:
        """Friction power less flow work, W: what oil and walls carry away."""
        return float(self.sectors.source.sum())

    @property
    def friction_power(self) -> float:
        """Of the journal, W: its friction torque times its speed.

        It is the `heat_source` wherever the flow is the same in every section. Where the discretisation does not
        conserve the flow, the flow work does not cancel around the film and the two differ.
        """
        return float(self.sectors.friction.sum())

    @property
    def friction_torque(self) -> float:
        """On the journal, N m."""
        return self.friction_power / self.film.angular_speed

    @property
    def rupture_temperature(self) -> float:
        """Where the film breaks, K."""
        angles = circle(self.film.cells, self.film.start)[0]
        return float(np.interp(self.pressure.rupture_angle, angles, self.temperatures.film))

    @property
    def energy_balance_error(self) -> float:
        """What oil, housing and shaft do not take of the heat, over the heat."""
        t = self.temperatures
        return (self.heat_source - t.to_oil - t.to_housing - t.to_shaft) / self.heat_source
