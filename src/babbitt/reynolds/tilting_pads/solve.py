"""The door of the isothermal engine: pads in SI to kernels and back."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds._structs import LAND_COLUMNS, Axial, Bearing, Grid
from babbitt.reynolds.lands._grids import new_film
from babbitt.reynolds.lands._integrals import (
    BEARING_TORQUE,
    INFLOW,
    JOURNAL_TORQUE,
    OUTFLOW,
    SIDE_FLOW,
    TOTALS,
    integrate,
)
from babbitt.reynolds.lands.axial import even_axial_operator
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.lands.profiles import common_profiles
from babbitt.reynolds.model import ENGINEERING, Resolution
from babbitt.reynolds.tilting_pads._pads import CLOSED, CONVERGED, LIMIT, TOUCH, WORK, find_pads
from babbitt.reynolds.tilting_pads._pivot_curve import CURVE_COLUMNS
from babbitt.reynolds.tilting_pads._place import new_places, pads_at, smooth_answers
from babbitt.reynolds.tilting_pads._structs import PadPlaces, Pads
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, LOADED, find_fold
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import stiffness_of
from babbitt.reynolds.tilting_pads.solution import PadPosition, PadState, PadStatus, TiltingPadSolution

__all__ = ["Fold", "PadScales", "fold_of", "kernel_pads", "solve_tilting_pads", "tilting_pads_at"]

Array = NDArray[np.float64]

LOWEST = -0.6
"""Eccentricity ratio at the pivot down to which a fold is sought."""


OUTCOMES = {
    CONVERGED: Outcome.CONVERGED, CLOSED: Outcome.OUTSIDE_CLEARANCE, LIMIT: Outcome.PAD_AT_LIMIT,
    WORK: Outcome.WORK_BOUND, TOUCH: Outcome.OVERLOADED,
}  # fmt: skip


def no_total() -> Array:
    """What `find_pads` fills: force (2), stiffness (4)."""
    return np.zeros(6)


class PadScales:
    """Units of the dimensionless bearing: those of its first pad.

    Attributes
    ----------
    length, pressure, force, torque, flow : float
        c_p of the first pad, mu omega (R/c_p)^2, mu omega (R/c_p)^2 R L, mu omega R^3 L/c_p, omega R c_p L.
    rate : float
        rad/s.
    sense : ndarray, shape (2,)
        What mirrors a vector into the counter-clockwise world and back.
    """

    def __init__(self, bearing: TiltingPadBearing) -> None:
        radius, width = bearing.radius, bearing.width
        self.length = bearing.pads[0].clearance
        self.rate = abs(bearing.angular_speed)
        self.pressure = bearing.viscosity * self.rate * (radius / self.length) ** 2
        self.force = self.pressure * radius * width
        self.torque = bearing.viscosity * self.rate * radius**3 * width / self.length
        self.flow = self.rate * radius * self.length * width
        self.sense = np.array([1.0, bearing.sense])


def kernel_pads(bearing: TiltingPadBearing, scales: PadScales) -> Pads:
    """Pads in the frames and units of the kernels."""
    count = len(bearing.pads)
    lands, curves = np.zeros((count, LAND_COLUMNS)), np.zeros((count, CURVE_COLUMNS))
    profiles = common_profiles([pad.profile[:: int(bearing.sense)] for pad in bearing.pads]) / scales.length
    points = max(len(pad.pivot.curve().loads) for pad in bearing.pads)
    loads, displacements = np.zeros((count, points)), np.zeros((count, points))
    kappa, weight, angle, offset, rotational, neutral = np.zeros((6, count))
    plain, centred = np.zeros((2, count), dtype=bool)
    for k, pad in enumerate(bearing.pads):
        width = bearing.width if pad.width is None else pad.width
        thickness = 1.0 if pad.viscosity is None else pad.viscosity / bearing.viscosity
        kappa[k] = (bearing.diameter / width) ** 2 / 12.0
        weight[k] = thickness * width / bearing.width
        angle[k] = bearing.sense * pad.pivot_angle
        lands[k, :2] = -pad.pivot_fraction * pad.extent, (1.0 - pad.pivot_fraction) * pad.extent
        lands[k, 2] = pad.clearance / scales.length
        lands[k, 5:] = bearing.groove_pressure / (scales.pressure * thickness)
        offset[k] = (pad.clearance - pad.assembled_clearance) / scales.length
        rotational[k] = tangential_spring(bearing, pad) * scales.length / scales.force
        neutral[k] = bearing.sense * bearing.lever(pad) * pad.rest_tilt / scales.length
        fill_curve(pad, scales, curves[k], loads[k], displacements[k])
        plain[k] = not pad.profile and bearing.groove_pressure == 0.0
        centred[k] = plain[k] and abs(pad.pivot_fraction - 0.5) < 1e-12
    return Pads(
        Bearing(lands, profiles, math.nan, 1.0, 0.0, False, True, 1.0), kappa, weight, np.cos(angle),
        np.sin(angle), offset, rotational, neutral, curves, loads, displacements, centred, plain,
        np.ones((count, 0)), np.ones((count, 0)),
    )  # fmt: skip


def tangential_spring(bearing: TiltingPadBearing, pad: TiltingPad) -> float:
    """Stiffness against eta, N/m: of the flexure at the lever of the pivot, in series with the tangential one."""
    flexure = pad.rotational_stiffness / bearing.lever(pad) ** 2
    return flexure / (1.0 + flexure / pad.tangential_stiffness)


def fill_curve(pad: TiltingPad, scales: PadScales, row: Array, loads: Array, displacements: Array) -> None:
    """Displacement of a pivot in the units of the kernels."""
    curve = pad.pivot.curve()
    row[:] = curve.columns(scales.force, scales.length)
    if curve.loads:
        given = len(curve.loads)
        loads[:given] = np.asarray(curve.loads) / scales.force
        displacements[:given] = np.asarray(curve.displacements) / scales.length
        slope = (displacements[given - 1] - displacements[given - 2]) / (loads[given - 1] - loads[given - 2])
        for place in range(given, loads.size):  # the last piece goes on
            loads[place] = 2.0 * loads[place - 1]
            displacements[place] = displacements[place - 1] + slope * (loads[place] - loads[place - 1])


def solve_tilting_pads(
    bearing: TiltingPadBearing,
    load: tuple[float, float],
    resolution: Resolution = ENGINEERING,
    *,
    start: tuple[float, float] = (0.0, 0.0),
    max_steps: int = 100,
) -> TiltingPadSolution:
    """Find where pads carry a load.

    Parameters
    ----------
    bearing : TiltingPadBearing
    load : tuple of float
        Force on the journal, N: (0, -W) hangs a weight W on it.
    resolution : Resolution
        ``axial_unknowns`` and ``intervals`` of every pad, ``tolerance`` of the force.
    start : tuple of float
        Where the search begins, m. The answer of rigid pads does not depend on it.
    max_steps : int

    Returns
    -------
    TiltingPadSolution
        Always; ``outcome`` says whether it is an equilibrium. `Outcome.OVERLOADED`: an edge that a flexure presses
        on the journal bars the way, or a pivot carries more than its law knows.

    Raises
    ------
    InputError
        E101 if the load is not finite.
    """
    if not all(math.isfinite(part) for part in load):
        raise InputError("E101", f"load is {load}; both components must be finite, in N.")
    begun = time.perf_counter()
    scales = PadScales(bearing)
    pads, axial = kernel_pads(bearing, scales), kernel_operator(resolution.axial_unknowns)
    wanted = (np.asarray(load) + groove_force(bearing)) * scales.sense / scales.force
    at = np.asarray(start) * scales.sense / scales.length
    places, total = new_places(pads), no_total()
    x, y, status, steps, indifferent, grid = find_pads(
        axial, pads, resolution.intervals, wanted[0], wanted[1], at[0], at[1], resolution.tolerance, max_steps,
        places, total,
    )  # fmt: skip
    outcome = OUTCOMES.get(status, Outcome.NOT_CONVERGED)
    residual = math.hypot(total[0] + wanted[0], total[1] + wanted[1])
    return assembled(
        bearing, scales, axial, pads, grid, places, np.array([x, y]), total, outcome, residual,
        bool(indifferent), steps, begun,
    )  # fmt: skip


def tilting_pads_at(
    bearing: TiltingPadBearing, position: tuple[float, float], resolution: Resolution = ENGINEERING
) -> TiltingPadSolution:
    """Tilts, pivots and films of pads around a journal at a prescribed position, m.

    Returns
    -------
    TiltingPadSolution
        With `Outcome.OUTSIDE_CLEARANCE` where the journal would touch a pad, `Outcome.PAD_AT_LIMIT` where a pad
        on an elastic pivot would have to carry less than it can.
    """
    begun = time.perf_counter()
    scales = PadScales(bearing)
    pads, axial = kernel_pads(bearing, scales), kernel_operator(resolution.axial_unknowns)
    at = np.asarray(position) * scales.sense / scales.length
    places, total = new_places(pads), no_total()
    is_open, is_found, grid = pads_at(axial, pads, resolution.intervals, at[0], at[1], places, total)
    outcome = Outcome.CONVERGED if is_found else Outcome.NOT_CONVERGED
    if is_found and AT_LIMIT in places.status:
        outcome = Outcome.PAD_AT_LIMIT
    if not is_open:
        outcome = Outcome.OUTSIDE_CLEARANCE
    return assembled(bearing, scales, axial, pads, grid, places, at, total, outcome, 0.0, False, 0, begun)


def assembled(
    bearing: TiltingPadBearing, scales: PadScales, axial: Axial, pads: Pads, grid: Grid, places: PadPlaces,
    at: Array, total: Array, outcome: Outcome, residual: float, indifferent: bool, steps: int, begun: float,
) -> TiltingPadSolution:  # fmt: skip
    """Everything in SI and in the fixed frame."""
    smooth_answers(axial, pads, grid, places)
    limit = int(np.argmax(places.status == AT_LIMIT)) if outcome is Outcome.PAD_AT_LIMIT else None
    states = tuple(
        loaded_state(bearing, scales, axial, pads, grid, places, at, k)
        if places.status[k] == LOADED
        else unloaded_state(bearing, scales, axial, pads, grid, places, k)
        for k in range(len(bearing.pads))
    )
    if any(math.isnan(state.pivot_stiffness) for state in states):  # no law of its pivot holds there
        outcome = Outcome.OVERLOADED
    return TiltingPadSolution(
        bearing=bearing,
        outcome=outcome,
        position=at * scales.sense * scales.length,
        force=total[:2] * scales.sense * scales.force + groove_force(bearing),
        pads=states,
        residual=residual * scales.force,
        indifferent=indifferent,
        limit_pad=limit,
        limit_loads=() if limit is None else limit_loads(scales, places, limit),
        iterations=steps,
        films=int(places.films[0]),
        wall_time=time.perf_counter() - begun,
    )


def limit_loads(scales: PadScales, places: PadPlaces, k: int) -> tuple[float, float]:
    """What a pad at its limit would have to carry, and the least that it can, N."""
    return float(places.need[k]) * scales.force, float(places.least[k]) * scales.force


def loaded_state(
    bearing: TiltingPadBearing, scales: PadScales, axial: Axial, pads: Pads, grid: Grid, places: PadPlaces,
    at: Array, k: int,
) -> PadState:  # fmt: skip
    """A pad that carries."""
    pad, sense = bearing.pads[k], bearing.sense
    n, m = grid.step.shape[1], len(axial.size)
    pressure, void, totals = np.zeros((1, n + 1, m + 1)), np.zeros((1, n + 1, m + 1)), np.zeros((1, TOTALS))
    own = one_pad(grid, k)
    lands = pads.bearing._replace(
        lands=pads.bearing.lands[k : k + 1], profiles=pads.bearing.profiles[k : k + 1], kappa=pads.kappa[k]
    )
    e, eta = places.radial[k], places.along[k]
    integrate(axial, lands, own, new_film(n), e, eta, 0.0, 0.0, pressure, void, totals)
    gap_a = own.gap_a[0] - e * own.cos_a[0] - eta * own.sin_a[0]
    gap_b = own.gap_b[0] - e * own.cos_b[0] - eta * own.sin_b[0]
    answer = places.answers[k]
    unit = scales.force / scales.length
    mirror = np.array([[1.0, sense], [sense, 1.0]])
    width = (bearing.width if pad.width is None else pad.width) / bearing.width
    thickness = pads.weight[k] / width
    load = float(-answer[0] * scales.force)
    force = answer[:2] * scales.sense * scales.force
    displacement = max(0.0, float(places.rigid[k] - e)) * scales.length
    across = 0.0 if math.isinf(pad.tangential_stiffness) else float(-force[1] / pad.tangential_stiffness)
    along = sense * eta * scales.length
    journal = float((at * scales.sense * scales.length) @ pad.tangent())
    return PadState(
        status=PadStatus.LOADED if load > 0.0 else PadStatus.UNLOADED,
        position=PadPosition((along - journal + across) / bearing.lever(pad), displacement, across),
        radial=float(e - pads.offset[k]) * scales.length,
        tangential=along,
        eccentricity_ratio=float(e / pads.bearing.lands[k, 2]),
        load=load,
        force=force,
        stiffness=answer[2:6].reshape(2, 2) * mirror * unit,
        damping=answer[6:].reshape(2, 2) * mirror * (unit / scales.rate),
        pivot_stiffness=stiffness_of(pad.pivot, load),
        minimum_film_thickness=float(min(gap_a.min(), gap_b.min())) * scales.length,
        maximum_pressure=float(pressure.max()) * scales.pressure * thickness,
        inflow=totals[0, INFLOW] * scales.flow * width,
        outflow=totals[0, OUTFLOW] * scales.flow * width,
        side_flow=totals[0, SIDE_FLOW] * scales.flow * width,
        friction_torque=totals[0, JOURNAL_TORQUE] * scales.torque * pads.weight[k],
        shear_torque=totals[0, BEARING_TORQUE] * scales.torque * pads.weight[k],
        angles=sense * own.theta[0] + pad.pivot_angle,
        axial_positions=even_axial_operator(m).nodes * (0.5 * width * bearing.width),
        pressure=pressure[0] * scales.pressure * thickness,
        void=void[0],
    )


def one_pad(grid: Grid, k: int) -> Grid:
    """Grid of pad k alone."""
    parts: dict[str, Any] = {name: part[k : k + 1] for name, part in grid._asdict().items()}
    return Grid(**parts)


def unloaded_state(
    bearing: TiltingPadBearing, scales: PadScales, axial: Axial, pads: Pads, grid: Grid, places: PadPlaces, k: int
) -> PadState:
    """A pad that does not carry, or is at its limit, concentric with its bore (eta = 0).

    Its narrowest place passes its drag flow, half the speed times the gap; elsewhere the same oil fills a part
    of the gap and shears there, as the streamers of a ruptured film do.
    """
    pad, sense = bearing.pads[k], bearing.sense
    m = len(axial.size)
    width = bearing.width if pad.width is None else pad.width
    viscosity = bearing.viscosity if pad.viscosity is None else pad.viscosity
    e = float(places.radial[k])
    gap = (0.5 * (grid.gap_a[k] + grid.gap_b[k]) - 0.5 * e * (grid.cos_a[k] + grid.cos_b[k])) * scales.length
    narrowest = float(gap.min())
    speed = abs(bearing.angular_speed) * bearing.radius
    flow = 0.5 * speed * width * max(narrowest, 0.0)
    closed = narrowest <= 0.0
    shear = math.nan if closed else float((grid.step[k] * narrowest / gap**2).sum())
    torque = viscosity * speed * bearing.radius**2 * width * shear
    on_lines = np.interp(grid.theta[k], 0.5 * (grid.theta[k, 1:] + grid.theta[k, :-1]), gap)
    void = np.repeat(1.0 - narrowest / np.maximum(on_lines, 1e-300)[:, None], m + 1, axis=1)
    zero = np.zeros((2, 2))
    return PadState(
        status=PadStatus.AT_LIMIT if places.status[k] == AT_LIMIT else PadStatus.UNLOADED,
        position=PadPosition(math.nan, max(0.0, float(places.rigid[k]) - e) * scales.length),
        radial=(e - float(pads.offset[k])) * scales.length,
        tangential=0.0,
        eccentricity_ratio=e * scales.length / pad.clearance,
        load=0.0,
        force=np.zeros(2),
        stiffness=zero,
        damping=zero,
        pivot_stiffness=stiffness_of(pad.pivot, 0.0),
        minimum_film_thickness=narrowest,
        maximum_pressure=0.0,
        inflow=flow,
        outflow=flow,
        side_flow=0.0,
        friction_torque=torque,
        shear_torque=torque,
        angles=sense * grid.theta[k] + pad.pivot_angle,
        axial_positions=even_axial_operator(m).nodes * (0.5 * width),
        pressure=np.zeros((grid.theta.shape[1], m + 1)),
        void=np.clip(void, 0.0, 1.0),
    )


def groove_force(bearing: TiltingPadBearing) -> Array:
    """Force of the oil between the pads on the journal, N."""
    total = np.zeros(2)
    if bearing.groove_pressure == 0.0:
        return total
    turn = 2.0 * math.pi
    edges = sorted((bearing.edges(pad) for pad in bearing.pads), key=lambda edge: edge[0] % turn)
    for (_, end), (start, _) in zip(edges, [*edges[1:], edges[0]], strict=True):
        until = end + (start - end) % turn
        total -= [math.sin(until) - math.sin(end), math.cos(end) - math.cos(until)]
    return total * bearing.groove_pressure * bearing.radius * bearing.width


@dataclass(frozen=True)
class Fold:
    """Where a pad unloads.

    Attributes
    ----------
    outcome : Outcome
        Read this first: not converged where a tilt was not found on the way, or the pad carries nowhere; the
        numbers are nan.
    eccentricity_ratio : float
        eps_p below which the pad has no equilibrium; minus infinity where it carries down to `LOWEST`.
    load : float
        That it carries there, N: 0 for a centred pivot.
    tangential : float
        eta there, m.
    """

    outcome: Outcome
    eccentricity_ratio: float
    load: float
    tangential: float


def fold_of(bearing: TiltingPadBearing, number: int, resolution: Resolution = ENGINEERING) -> Fold:
    """The eccentricity ratio at which a pad without flexure unloads, and its least load.

    A centred pivot unloads at zero without load. Behind the middle two equilibria meet at a load that is
    finite, and below there is none: found by bisection to 1e-6 of c_p.

    Raises
    ------
    InputError
        E101 for a pad on a flexure, which has an equilibrium everywhere.
    """
    pad = bearing.pads[number]
    if pad.rotational_stiffness > 0.0:
        raise InputError("E101", "a pad on a flexure has no fold; ask for pads that are free to tilt.")
    scales = PadScales(bearing)
    pads, axial = kernel_pads(bearing, scales), kernel_operator(resolution.axial_unknowns)
    if pads.centred[number]:
        return Fold(Outcome.CONVERGED, 0.0, 0.0, 0.0)
    clearance = pads.bearing.lands[number, 2]
    e, load, eta = find_fold(
        axial, pads, resolution.intervals, number, 0.9 * clearance, LOWEST * clearance, 1e-6, new_places(pads)
    )
    outcome = Outcome.NOT_CONVERGED if math.isnan(e) else Outcome.CONVERGED
    return Fold(outcome, e / clearance, load * scales.force, bearing.sense * eta * scales.length)
