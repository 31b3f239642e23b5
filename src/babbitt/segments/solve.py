"""Both segments, the groove between them and the compliant wall in equilibrium."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.design.heat_balance import NoFilmError
from babbitt.design.oil import properties_at
from babbitt.design.roots import bracketed_root, find_root
from babbitt.notices import InputError
from babbitt.results import Outcome
from babbitt.segments.model import GrooveKind, SegmentFilm
from babbitt.segments.pressure import Gap, Grid, Segment, between, to_rupture

Array = NDArray[np.float64]

FIRST_RISE = 5.0
"""K above the supply at which the iteration starts."""

RELAXATION = 0.5
TEMPERATURE_TOLERANCE, DISPLACEMENT_TOLERANCE = 1e-4, 1e-5
"""In K, and over the clearance."""

FRACTION, LEAST_FRACTION = 0.3, 0.02
"""Of the thinnest film, what a step may move the wall; taken back by a tenth whenever the wall overshoots."""

MOST_ITERATIONS = 4000
GREATEST_ECCENTRICITY = 0.995
SCAN = tuple(np.concatenate((np.arange(0.02, 0.9, 0.04), np.arange(0.9, 0.996, 0.01))).tolist())
BEYOND_CONTACT = tuple(np.arange(1.0, 1.2001, 0.01).tolist())
"""Eccentricity ratios that only a compliant wall allows."""


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
        return -self._force(self.grid.cosine)

    @property
    def load_across(self) -> float:
        """Load normal to the eccentricity, N."""
        return self._force(self.grid.sine)

    def _force(self, direction: Array) -> float:
        return self.film.radius * self.film.width * float(self.grid.weights @ (self.film_pressure * direction))

    @property
    def load(self) -> float:
        """Resultant in N."""
        return math.hypot(self.load_along, self.load_across)

    @property
    def specific_load(self) -> float:
        """Load over D L, Pa."""
        return self.load / (self.film.diameter * self.film.width)

    @property
    def attitude_angle(self) -> float:
        """From the load to the narrowest gap, rad."""
        return math.atan2(self.load_across, self.load_along)

    @property
    def friction_power(self) -> float:
        """Of all segments, W."""
        return sum(one.friction_power for one in self.segments)

    @property
    def outlet_temperature(self) -> float:
        """Of the last segment, K."""
        return self.segments[-1].outlet_temperature

    @property
    def groove_side_flow(self) -> float:
        """Q1 - Q2: what leaves at the ends of the groove; negative: what it must be given. 0 without groove."""
        return self.segments[0].flow - self.segments[-1].flow

    def width_of_narrow_zone(self, factor: float = 1.1) -> float:
        """Angle over which the film is thinner than `factor` times its thinnest, rad."""
        thin = self.film_thickness < factor * float(self.film_thickness.min())
        return float(self.grid.weights[thin].sum())


def film_at_eccentricity(
    film: SegmentFilm, eccentricity_ratio: float, start: SegmentFilmState | None = None
) -> SegmentFilmState:
    """The film in thermal (and elastic) equilibrium at an eccentricity ratio; ignored where a profile is given.

    Parameters
    ----------
    film : SegmentFilm
    eccentricity_ratio : float
        From 0; below 1 for a rigid film.
    start : SegmentFilmState, optional
        A neighbouring answer to start from.

    Raises
    ------
    InputError
        E003 for an eccentricity outside its bounds.
    NoFilmError
        NOT_CONVERGED where the film has no rupture point or the iteration breaks down, NO_LUBRICANT_DATA.
    """
    if not film.profile and not (0.0 <= eccentricity_ratio < (1.0 if film.compliance == 0.0 else math.inf)):
        raise InputError(
            "E003", f"eccentricity_ratio must lie from 0 to below 1 for a rigid film, given {eccentricity_ratio!r}"
        )
    grid = Grid.of(film)
    rigid = _rigid(film, grid, eccentricity_ratio)
    count = 1 if film.groove is None else 2
    means = np.full(count, film.supply_temperature + FIRST_RISE)
    displaced = np.zeros(grid.angles.size)
    if start is not None:
        means = np.array([one.mean_temperature for one in start.segments])
        displaced = film.compliance * start.film_pressure
    fraction, worst, gap = FRACTION, math.inf, None
    for iteration in range(1, MOST_ITERATIONS + 1):
        if gap is None or film.compliance:
            thickness = rigid + displaced / film.clearance
            if not thickness.min() > 0.0:
                raise NoFilmError(Outcome.NOT_CONVERGED)
            gap = Gap.of(grid, thickness)
        segments, groove_pressure, short = _segments(film, grid, gap, means)
        pressure = _pressure(film, grid, segments, groove_pressure)
        change = np.array([one.mean_temperature for one in segments]) - means
        strain = film.compliance * pressure - displaced
        off, bent = float(np.abs(change).max()), float(np.abs(strain).max())
        done = off < TEMPERATURE_TOLERANCE and bent < DISPLACEMENT_TOLERANCE * film.clearance
        if done or iteration == MOST_ITERATIONS:
            thick = film.clearance * gap.thickness
            return SegmentFilmState(
                film, eccentricity_ratio, grid, thick, pressure, segments, groove_pressure, short,
                iteration, done, (off, bent),
            )  # fmt: skip
        means = means + RELAXATION * change
        if film.compliance:
            fraction = max(LEAST_FRACTION, 0.9 * fraction) if bent > worst else fraction
            worst = bent
            room = (
                film.clearance * float(gap.thickness.min()) / max(film.compliance * float(pressure.max()), 1e-300)
            )
            displaced = displaced + min(RELAXATION, fraction * room) * strain
    raise AssertionError("unreachable")


def film_under_load(film: SegmentFilm, load: float) -> SegmentFilmState:
    """The film that carries a load, with the least eccentricity that does.

    The load passes a maximum as the film heats up: the eccentricity is raised to the first film that carries it,
    then bisected, never bracketed from above.

    Raises
    ------
    NoFilmError
        OVERLOADED with the largest load reached, NOT_CONVERGED, NO_LUBRICANT_DATA.
    """
    if not 0.0 < load < math.inf:
        raise InputError("E003", f"load must be above 0, given {load!r}")
    best, below = 0.0, 1e-6
    state: SegmentFilmState | None = None
    for eccentricity in (*SCAN, *(BEYOND_CONTACT if film.compliance else ())):
        try:
            state = film_at_eccentricity(film, eccentricity, state)
        except NoFilmError:
            break
        if not state.converged:
            break
        best = max(best, state.load)
        if state.load >= load:
            return _between(film, load, below, state)
        below = eccentricity
    raise NoFilmError(Outcome.OVERLOADED, best)


def _between(film: SegmentFilm, load: float, below: float, above: SegmentFilmState) -> SegmentFilmState:
    """The film that carries a load between an eccentricity that does not and a state that does."""

    def excess(eccentricity: float) -> float:
        return film_at_eccentricity(film, eccentricity, above).load - load

    root = find_root(excess, below, above.eccentricity_ratio, 1e-9)
    return film_at_eccentricity(film, root.value, above)


def _rigid(film: SegmentFilm, grid: Grid, eccentricity_ratio: float) -> Array:
    if not film.profile:
        return np.asarray(1.0 + eccentricity_ratio * grid.cosine)
    angles, thickness = np.array(film.profile).T
    return np.asarray(np.interp(grid.angles, angles, thickness, period=2.0 * math.pi) / film.clearance)


def _segments(
    film: SegmentFilm, grid: Grid, gap: Gap, means: Array
) -> tuple[tuple[SegmentState, ...], float, bool]:
    """Segments at given mean temperatures, the pressure of the groove and whether it is short of oil."""
    end = grid.angles.size - 1
    viscosity, capacity = [], []
    for mean in means:
        _, eta, heat_capacity = properties_at(film.lubricant, float(mean))
        viscosity.append(eta)
        capacity.append(heat_capacity)
    unit = [eta * film.surface_speed * film.radius / film.clearance**2 for eta in viscosity]
    if film.groove is None:
        only = _ruptured(gap, grid, 0, end, 0.0)
        return (
            (_warmed(film, only, unit[0], viscosity[0], capacity[0], 0.0, 0.0, film.supply_temperature),),
            0.0,
            False,
        )

    def first(pressure: float) -> Segment:
        found = between(gap, grid, 0, grid.before, pressure / unit[0])
        return found if found is not None else _ruptured(gap, grid, 0, grid.before, 0.0)

    def second(pressure: float) -> Segment:
        return _ruptured(gap, grid, grid.behind, end, pressure / unit[1])

    groove, short = film.groove, False
    pressure = groove.pressure
    if groove.kind is GrooveKind.BLIND:
        pressure, short = _blind_pressure(gap, grid, unit)
    before, behind = first(pressure), second(pressure)
    at_groove = 0.0 if before.ruptures else pressure
    leading = _warmed(film, before, unit[0], viscosity[0], capacity[0], 0.0, at_groove, film.supply_temperature)
    inlet = leading.outlet_temperature
    if groove.kind is GrooveKind.THROUGH:
        fresh = max(groove.mixing_factor, 1.0 - before.flow / behind.flow)
        inlet = fresh * film.supply_temperature + (1.0 - fresh) * inlet
    trailing = _warmed(film, behind, unit[1], viscosity[1], capacity[1], pressure, 0.0, inlet)
    return (leading, trailing), pressure, short


def _blind_pressure(gap: Gap, grid: Grid, unit: list[float]) -> tuple[float, bool]:
    """Pressure in Pa at which as much oil enters a blind groove as leaves it; 0 where more could leave."""
    end = grid.angles.size - 1

    def excess(pressure: float) -> float:
        entering = between(gap, grid, 0, grid.before, pressure / unit[0])
        if entering is None:
            entering = _ruptured(gap, grid, 0, grid.before, 0.0)
        leaving = to_rupture(gap, grid, grid.behind, end, pressure / unit[1])
        thick = float(gap.thickness[-1]) if leaving is None else -leaving.constant / 6.0
        return entering.flow - 0.5 * thick

    if excess(0.0) <= 0.0:
        return 0.0, True
    highest = 6.0 * float(gap.twice[grid.before]) * unit[0]  # no oil enters any more
    return bracketed_root(excess, 0.0, highest, relative=1e-12), False


def _ruptured(gap: Gap, grid: Grid, first: int, last: int, at_start: float) -> Segment:
    found = to_rupture(gap, grid, first, last, at_start)
    if found is None:
        raise NoFilmError(Outcome.NOT_CONVERGED)
    return found


def _warmed(
    film: SegmentFilm, segment: Segment, unit: float, viscosity: float, capacity: float,
    before: float, behind: float, inlet: float,
) -> SegmentState:  # fmt: skip
    """Heat balance of one segment between the pressures (Pa) at its ends: all heat leaves with the oil."""
    speed = film.surface_speed
    flow = speed * film.clearance * film.width * segment.flow
    power = unit * film.clearance * speed * film.width * segment.friction
    heat = power - flow * (behind - before)
    if not flow > 0.0:
        raise NoFilmError(Outcome.NOT_CONVERGED)
    outlet = inlet + heat / (capacity * flow)
    return SegmentState(
        segment, viscosity, flow, power, heat, before, behind, inlet, 0.5 * (inlet + outlet), outlet
    )


def _pressure(film: SegmentFilm, grid: Grid, segments: tuple[SegmentState, ...], in_groove: float) -> Array:
    pressure = np.zeros(grid.angles.size)
    if len(segments) == 2:
        pressure[grid.before : grid.behind + 1] = in_groove
    for one in segments:
        unit = one.viscosity * film.surface_speed * film.radius / film.clearance**2
        pressure[one.segment.first : one.segment.last + 1] = unit * one.segment.pressure
    return pressure
