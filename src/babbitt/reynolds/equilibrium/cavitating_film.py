"""Films with a condition of rupture: equilibrium from a start, and the film at a position, in SI.

Inside everything is dimensionless and the journal turns counter-clockwise; a clockwise journal is solved in the
mirror (theta -> -theta). Lengths c, pressures mu omega (R/c)^2, forces mu omega (R/c)^2 R B, flows omega R c B,
torques mu omega R^3 B / c.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds._structs import LAND_COLUMNS, Axial, Bearing, Grid
from babbitt.reynolds.lands._equilibrium import CONVERGED, NO_FILM, TOO_MANY_STEPS, find_equilibrium
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._grids import new_film
from babbitt.reynolds.lands._integrals import (
    BEARING_TORQUE,
    IMBALANCE,
    INFLOW,
    JOURNAL_TORQUE,
    OUTFLOW,
    SIDE_FLOW,
    SIDE_INFLOW,
    STREAMER_TORQUE,
    TOTALS,
    integrate,
)
from babbitt.reynolds.lands._positions import film_at, find_depth, find_near
from babbitt.reynolds.lands.axial import even_axial_operator
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.lands.profiles import common_profiles
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.solution import FilmSolution

__all__ = ["Coefficients", "cavitating_film_at", "coefficients_over_speed", "equilibrium_from"]

Array = NDArray[np.float64]
Coefficients = tuple[Array, Array]
"""Stiffness in N/m and damping in N s/m, shape (2, 2) each."""

SLIGHT = 0.25
"""By which the void of single nodes beside the edge of a streamer may lie outside 0 to 1, on any grid.

The elements of the width let a full node send oil to its neighbours with either sign. Of 1829 random films with
cavities below ambient, whose sides draw oil in, the void of 34 lies outside by more than 0.05, of one by 0.197.
"""


def equilibrium_from(
    film: JournalFilm, load: tuple[float, float], resolution: Resolution, max_steps: int,
    start: tuple[float, float] | None,
) -> FilmSolution:  # fmt: skip
    """Equilibrium from a position close to it, m; None: from the middle, under a growing load."""
    begun = time.perf_counter()
    scales = Scales.of(film, abs(film.angular_speed))
    wanted = np.asarray(load) * scales.sense / scales.force
    at = None if start is None else np.asarray(start) * scales.sense / scales.length
    if film.is_surface:
        from babbitt.reynolds.surface.surface_equilibrium import (
            find_surface_equilibrium,
            find_surface_equilibrium_near,
        )
        from babbitt.reynolds.surface.surface_solution import mirrored, ring_solution

        seen = mirrored(film) if film.angular_speed < 0.0 else film
        settled = (
            find_surface_equilibrium(seen, scales.pressure, wanted, resolution, max_steps)
            if at is None
            else find_surface_equilibrium_near(seen, scales.pressure, wanted, resolution, max_steps, at)
        )
        return ring_solution(film, scales, settled, begun)
    bearing, axial = kernel_bearing(film, scales), kernel_operator(resolution.axial_unknowns)
    if film.film_start is FilmStart.WIDEST_GAP:
        return widest_gap_equilibrium(film, scales, bearing, axial, wanted, resolution, max_steps, begun)
    result, standing = np.zeros(RESULT_SIZE), groove_force(bearing)
    pushed = wanted + standing
    find, (x, y) = (find_equilibrium, (0.0, 0.0)) if at is None else (find_near, at)
    x, y, status, steps, gap, grid = find(
        axial, bearing, resolution.coarse_intervals, resolution.intervals, pushed[0], pushed[1], x, y,
        resolution.tolerance, max_steps, result,
    )  # fmt: skip
    result[:2] += standing
    at = np.array([x, y])
    return assemble(film, scales, bearing, axial, grid, at, np.zeros(2), result, status, steps, gap, 0.0, begun)


def coefficients_over_speed(
    film: JournalFilm, load: tuple[float, float], resolution: Resolution, max_steps: int = 80
) -> Callable[[float], Coefficients | None] | None:
    """Coefficients of a film in equilibrium over its speed in rad/s, those of `equilibrium_from` without the rest.

    None where a film is not one whose lands are the same at every speed but for their unit: plain, fed and vented
    without pressure. At a speed where no equilibrium is found there are no coefficients.
    """
    plain = film.is_plain and film.film_start is FilmStart.GROOVE and not film.is_surface
    if not plain or film.cavitation is Cavitation.HALF_SOMMERFELD or film.cavitation_pressure != 0.0:
        return None
    bearing = kernel_bearing(film, Scales.of(film, abs(film.angular_speed)))
    axial = kernel_operator(resolution.axial_unknowns)
    turn = math.copysign(1.0, film.angular_speed)
    mirrored = np.array([[1.0, turn], [turn, 1.0]])

    def at(speed: float) -> Coefficients | None:
        scales, result = Scales.of(film, speed), np.zeros(RESULT_SIZE)
        _, _, status, _, _, _ = find_equilibrium(
            axial, bearing, resolution.coarse_intervals, resolution.intervals, load[0] / scales.force,
            turn * load[1] / scales.force, 0.0, 0.0, resolution.tolerance, max_steps, result,
        )  # fmt: skip
        if status != CONVERGED or not np.isfinite(result).all():
            return None
        unit = mirrored * (scales.force / scales.length)
        return result[2:6].reshape(2, 2) * unit, result[6:].reshape(2, 2) * (unit / scales.rate)

    return at


def cavitating_film_at(
    film: JournalFilm, position: tuple[float, float], velocity: tuple[float, float], resolution: Resolution
) -> FilmSolution:
    """Film with a condition of rupture at a position (m) and velocity (m/s) of the journal.

    Raises
    ------
    InputError
        E101 if neither rotation nor velocity drive the film, or a mass-conserving film is only squeezed.
    """
    begun = time.perf_counter()
    rate = abs(film.angular_speed) or math.hypot(*velocity) / film.clearance
    if rate == 0.0:
        raise InputError("E101", "angular_speed and velocity are both zero; nothing drives the film.")
    if film.angular_speed == 0.0 and film.cavitation is Cavitation.MASS_CONSERVING:
        raise InputError("E101", "a film that is only squeezed has no steady void; choose Cavitation.REYNOLDS.")
    scales = Scales.of(film, rate)
    at = np.asarray(position) * scales.sense / scales.length
    moving = np.asarray(velocity) * scales.sense / (scales.length * scales.rate)
    if film.is_surface:
        return _ring_at(film, scales, at, moving, resolution, begun)
    bearing, axial = kernel_bearing(film, scales), kernel_operator(resolution.axial_unknowns)
    turn = 0.0
    if film.film_start is FilmStart.WIDEST_GAP:
        turn = math.atan2(at[1], at[0])
        at, moving = rotate(at, -turn), rotate(moving, -turn)
    result = np.zeros(RESULT_SIZE)
    status, steps, gap, grid = film_at(
        axial, bearing, resolution.coarse_intervals, resolution.intervals, at[0], at[1], moving[0], moving[1], 200,
        result,
    )  # fmt: skip
    if film.film_start is FilmStart.WIDEST_GAP:
        turn_with_journal(result, at[0])
    elif status == TOO_MANY_STEPS:  # lines that share their modes flicker as one; nodes seldom do
        return _ring_at(film, scales, at, moving, resolution, begun)
    result[:2] += groove_force(bearing)
    return assemble(film, scales, bearing, axial, grid, at, moving, result, status, steps, gap, turn, begun)


def _ring_at(
    film: JournalFilm, scales: Scales, at: Array, moving: Array, resolution: Resolution, begun: float
) -> FilmSolution:
    """Film at a dimensionless position and velocity, node by node."""
    from babbitt.reynolds.surface.surface_equilibrium import ring_at
    from babbitt.reynolds.surface.surface_solution import mirrored, ring_solution

    seen = mirrored(film) if film.angular_speed < 0.0 else film
    return ring_solution(film, scales, ring_at(seen, scales.pressure, at, moving, resolution), begun)


def widest_gap_equilibrium(
    film: JournalFilm, scales: Scales, bearing: Bearing, axial: Axial, wanted: Array, resolution: Resolution,
    max_steps: int, begun: float,
) -> FilmSolution:  # fmt: skip
    """Equilibrium of a round bore whose film starts at the widest gap: the depth first, the direction follows."""
    result = np.zeros(RESULT_SIZE)
    size = math.hypot(wanted[0], wanted[1])
    eps, status, steps, gap, grid = find_depth(
        axial,
        bearing,
        resolution.coarse_intervals,
        resolution.intervals,
        size,
        resolution.tolerance,
        max_steps,
        result,
    )
    turn_with_journal(result, eps)
    turn = math.atan2(-wanted[1], -wanted[0]) - math.atan2(result[1], result[0])
    at = np.array([eps, 0.0])
    return assemble(film, scales, bearing, axial, grid, at, np.zeros(2), result, status, steps, gap, turn, begun)


def turn_with_journal(result: Array, eps: float) -> None:
    """Second column of K where the film start follows the journal: dF/dy = (z x F) / eps."""
    if eps > 0.0:
        result[3], result[5] = result[1] / eps, -result[0] / eps


def rotate(vector: Array, angle: float) -> Array:
    """Turn a vector counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def kernel_bearing(film: JournalFilm, scales: Scales) -> Bearing:
    """Lands and conditions in the units of the kernels."""
    lands = np.zeros((len(film.lands), LAND_COLUMNS))
    for row, land in zip(lands, film.lands, strict=True):
        fill_land(row, film, land, scales)
    turn = int(scales.sense[1])
    return Bearing(
        lands=lands,
        profiles=common_profiles([land.profile[::turn] for land in film.lands]) / scales.length,
        kappa=(film.diameter / film.width) ** 2 / 12.0,
        speed=1.0 if film.angular_speed else 0.0,
        side_pressure=-film.cavitation_pressure / scales.pressure,
        conserving=film.cavitation is Cavitation.MASS_CONSERVING,
        smooth=True,
        crowding=1.0,
    )


def fill_land(row: Array, film: JournalFilm, land: Land, scales: Scales) -> None:
    """One row of the land table, mirrored for a clockwise journal."""
    angles, pressures = (land.start_angle, land.end_angle), (land.start_pressure, land.end_pressure)
    if scales.sense[1] < 0.0:
        angles, pressures = (-angles[1], -angles[0]), pressures[::-1]
    if film.film_start is FilmStart.WIDEST_GAP:
        angles = (-math.pi, math.pi)
    clearance = film.clearance if land.clearance is None else land.clearance
    row[:2] = angles
    row[2] = clearance / scales.length
    row[3:5] = np.asarray(land.centre) * scales.sense / scales.length
    row[5:] = (np.asarray(pressures) - film.cavitation_pressure) / scales.pressure


def groove_force(bearing: Bearing) -> Array:
    """Force of the oil standing in the grooves, between the end of one land and the start of the next."""
    total = np.zeros(2)
    turn = 2.0 * math.pi
    lands = sorted(bearing.lands.tolist(), key=lambda land: land[0] % turn)
    for land, following in zip(lands, (*lands[1:], lands[0]), strict=True):
        gauge = 0.5 * (land[6] + following[5]) - bearing.side_pressure
        extent = (following[0] - land[1]) % turn
        if gauge > 0.0 and extent < turn - 1e-9:
            end = land[1] + extent
            total -= gauge * np.array([math.sin(end) - math.sin(land[1]), math.cos(land[1]) - math.cos(end)])
    return total


def assemble(
    film: JournalFilm, scales: Scales, bearing: Bearing, axial: Axial, grid: Grid, at: Array, moving: Array,
    result: Array, status: int, steps: int, gap: float, turn: float, begun: float,
) -> FilmSolution:  # fmt: skip
    """Integrals of the converged film, everything in SI and in the fixed frame."""
    count, n, m = grid.step.shape[0], grid.step.shape[1], len(axial.size)
    pressure, void = np.zeros((count, n + 1, m + 1)), np.zeros((count, n + 1, m + 1))
    totals = np.zeros((count, TOTALS))
    if status != NO_FILM:
        integrate(axial, bearing, grid, new_film(n), at[0], at[1], moving[0], moving[1], pressure,
                  void, totals)  # fmt: skip
    c, s = math.cos(turn), math.sin(turn)
    frame = scales.sense[:, None] * np.array([[c, -s], [s, c]])
    stiffness_unit = scales.force / scales.length
    outcome = {CONVERGED: Outcome.CONVERGED, NO_FILM: Outcome.OVERLOADED}.get(status, Outcome.NOT_CONVERGED)
    if outcome is Outcome.CONVERGED and not np.isfinite(result).all():
        outcome = Outcome.NOT_CONVERGED  # a gap of some nanometres may leave no number for the stiffness
    sums = totals.sum(axis=0).tolist()
    return FilmSolution(
        film=film,
        outcome=outcome,
        position=frame @ at * scales.length,
        force=frame @ result[:2] * scales.force,
        stiffness=frame @ result[2:6].reshape(2, 2) @ frame.T * stiffness_unit,
        damping=frame @ result[6:].reshape(2, 2) @ frame.T * (stiffness_unit / scales.rate),
        minimum_film_thickness=gap * scales.length,
        angles=scales.sense[1] * (grid.theta + turn),
        axial_positions=even_axial_operator(m).nodes * (0.5 * film.width),
        pressure=pressure * scales.pressure + film.cavitation_pressure,
        void=_without_slight_excess(void),
        supply_flow=supply_flows(film, totals) * scales.flow,
        inflow=totals[:, INFLOW] * scales.flow,
        outflow=totals[:, OUTFLOW] * scales.flow,
        side_flow=totals[:, SIDE_FLOW] * scales.flow,
        end_flows=np.full(2, 0.5 * sums[SIDE_FLOW] * scales.flow),
        side_inflow=sums[SIDE_INFLOW] * scales.flow,
        friction_torque=sums[JOURNAL_TORQUE] * scales.torque,
        streamer_torque=sums[STREAMER_TORQUE] * scales.torque,
        bearing_torque=sums[BEARING_TORQUE] * scales.torque,
        mass_balance_error=float(np.abs(totals[:, IMBALANCE]).sum() / max(abs(sums[INFLOW]), 1e-300)),
        iterations=steps,
        wall_time=time.perf_counter() - begun,
    )


def _without_slight_excess(void: Array) -> Array:
    """Void within 0 to 1 where it lies outside by `SLIGHT` or less; a gross fault stays to be seen."""
    if void.min() >= 0.0 and void.max() <= 1.0:
        return void
    bounded = np.clip(void, 0.0, 1.0)
    return np.where(np.abs(void - bounded) <= SLIGHT, bounded, void)


def supply_flows(film: JournalFilm, totals: Array) -> Array:
    """What each groove adds: what it sends into the land behind it less what it gets from the land before it."""
    order = film.land_order
    following = order[1:] + order[:1]
    if film.angular_speed < 0.0:
        return np.asarray(totals[order, INFLOW] - totals[following, OUTFLOW])
    return np.asarray(totals[following, INFLOW] - totals[order, OUTFLOW])
