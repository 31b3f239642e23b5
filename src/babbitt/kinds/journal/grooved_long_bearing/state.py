"""A film of one or two segments in equilibrium, and what follows from it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.grooved_long_bearing.model import SegmentFilm
from babbitt.kinds.journal.grooved_long_bearing.pressure import Gap, Grid, Segment

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SegmentState:
    """One segment in equilibrium, SI.

    `pressure_start` and `pressure_end` in Pa, `friction_power` A and `heat` in W, temperatures in K, `flow` in
    m³/s.
    """

    segment: Segment
    viscosity: float
    flow: float
    friction_power: float
    heat: float
    pressure_start: float
    pressure_end: float
    inlet_temperature: float
    mean_temperature: float
    outlet_temperature: float


@dataclass(frozen=True, eq=False)
class SegmentFilmState:
    """A film of one or two segments in equilibrium, SI; arrays over the nodes of `grid`.

    `short_of_oil` tells whether the blind groove had too little oil to close its continuity (its pressure is
    then 0); `residuals` holds the last changes of temperature (K) and displacement (m).
    """

    film: SegmentFilm
    eccentricity_ratio: float
    grid: Grid
    film_thickness: Array
    film_pressure: Array
    segments: tuple[SegmentState, ...]
    groove_pressure: float
    short_of_oil: bool
    iterations: int
    converged: bool
    residuals: tuple[float, float]

    @property
    def load_along(self) -> float:
        """Load along the eccentricity, N."""
        return load_of(self.film, self.grid, self.film_pressure)[0]

    @property
    def load_across(self) -> float:
        """Load normal to the eccentricity, N."""
        return load_of(self.film, self.grid, self.film_pressure)[1]

    @property
    def load(self) -> float:
        """Resultant in N."""
        return math.hypot(*load_of(self.film, self.grid, self.film_pressure))

    @property
    def specific_load(self) -> float:
        """Load over D L, Pa."""
        return self.load / (self.film.diameter * self.film.width)

    @property
    def attitude_angle(self) -> float:
        """From the load to the narrowest gap, rad."""
        return attitude_of(self.film, self.grid, self.film_pressure)

    @property
    def groove_angle_from_load(self) -> float:
        """Of the groove from the load line with the rotation, rad, within -pi to pi; NaN without a groove."""
        return groove_angle_from_load(self.film, self.grid, self.film_pressure)

    @property
    def friction_power(self) -> float:
        """Of all segments, W."""
        return sum(one.friction_power for one in self.segments)

    @property
    def outlet_temperature(self) -> float:
        """Of the last segment, K; what leaves in a groove is apart from it (`groove_warm_flow`)."""
        return self.segments[-1].outlet_temperature

    @property
    def groove_side_flow(self) -> float:
        """Q1 - Q2: what leaves at the ends of the groove; negative: what it must be given. 0 without groove."""
        return self.segments[0].flow - self.segments[-1].flow

    @property
    def groove_warm_flow(self) -> float:
        """Oil of the first segment that fresh oil replaces in the groove and that leaves there, m³/s."""
        first, last = self.segments[0], self.segments[-1]
        cold = first.inlet_temperature
        warmed, kept = first.outlet_temperature - cold, last.inlet_temperature - cold
        going_on = last.flow * kept / warmed if warmed > 0.0 else last.flow
        return max(first.flow - going_on, 0.0) if last is not first else 0.0

    @property
    def groove_heat(self) -> float:
        """Heat that this oil takes with it, W: part of that of the first segment."""
        first = self.segments[0]
        return first.heat * self.groove_warm_flow / first.flow

    @property
    def film_temperature(self) -> Array:
        """Temperature at the nodes, K, as the oil of each segment takes up heat on its way.

        The heat balance of the segment up to each place, with the viscosity of its mean temperature:
        ``T = T_in + [A(θ) - Q (p - p_start)]/(ρ c Q)``. Its end has the outlet temperature; behind a rupture no
        heat is generated. A groove has the temperature of the oil that leaves it with the film.
        """
        gap = Gap.of(self.grid, self.film_thickness / self.film.clearance)
        found = np.full(self.grid.angles.size, self.segments[-1].inlet_temperature)
        for one in self.segments:
            first, last = one.segment.first, one.segment.last
            inside = slice(first, last + 1)
            once, twice = (power[inside] - power[first] for power in (gap.once, gap.twice))
            scale = one.viscosity * self.film.surface_speed**2 * self.film.radius * self.film.width
            work = one.flow * (self.film_pressure[inside] - one.pressure_start)
            heat = scale / self.film.clearance * (4.0 * once + 0.5 * one.segment.constant * twice) - work
            capacity = float(self.film.lubricant.volumetric_heat_capacity(one.mean_temperature))
            local = one.inlet_temperature + heat / (capacity * one.flow)
            ended = self.grid.angles[inside] >= one.segment.end
            found[inside] = np.where(ended, one.outlet_temperature, local)
        return found

    def width_of_narrow_zone(self, factor: float = 1.1) -> float:
        """Angle over which the film is thinner than `factor` times its thinnest, rad."""
        thin = self.film_thickness < factor * float(self.film_thickness.min())
        return float(self.grid.weights[thin].sum())


def load_of(film: SegmentFilm, grid: Grid, pressure: Array) -> tuple[float, float]:
    """Load along the eccentricity and normal to it, N, of a pressure in Pa at the nodes."""
    area, weighted = film.radius * film.width, grid.weights * pressure
    return -area * float(weighted @ grid.cosine), area * float(weighted @ grid.sine)


def attitude_of(film: SegmentFilm, grid: Grid, pressure: Array) -> float:
    """Angle in rad from the load to the narrowest gap; pressure in Pa at the nodes."""
    along, across = load_of(film, grid, pressure)
    return math.atan2(across, along)


def groove_angle_from_load(film: SegmentFilm, grid: Grid, pressure: Array) -> float:
    """Angle in rad from the load line to the groove, within -pi to pi; NaN without one. Pressure in Pa."""
    if film.groove is None:
        return math.nan
    return math.remainder(film.groove.angle + attitude_of(film, grid, pressure) - math.pi, 2.0 * math.pi)
