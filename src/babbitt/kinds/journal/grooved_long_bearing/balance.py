"""Flow and heat of both segments at given mean temperatures, and the pressure of the groove between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.design.oil import properties_at
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentFilm
from babbitt.kinds.journal.grooved_long_bearing.pressure import Gap, Grid, Segment, between, to_rupture
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentState
from babbitt.numerics.roots import bracketed_root

Array = NDArray[np.float64]


def segments_of(
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


def pressure_of(film: SegmentFilm, grid: Grid, segments: tuple[SegmentState, ...], in_groove: float) -> Array:
    """Pressure at all nodes in Pa; that of the groove over its arc."""
    pressure = np.zeros(grid.angles.size)
    if len(segments) == 2:
        pressure[grid.before : grid.behind + 1] = in_groove
    for one in segments:
        unit = one.viscosity * film.surface_speed * film.radius / film.clearance**2
        pressure[one.segment.first : one.segment.last + 1] = unit * one.segment.pressure
    return pressure
