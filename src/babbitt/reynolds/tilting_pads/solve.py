"""The door of the isothermal engine: pads in SI to kernels and back."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds._structs import Axial, Grid
from babbitt.reynolds.lands._integrals import (
    BEARING_TORQUE,
    INFLOW,
    JOURNAL_TORQUE,
    OUTFLOW,
    SIDE_FLOW,
    TOTALS,
)
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import ENGINEERING, Resolution
from babbitt.reynolds.tilting_pads._pad_fields import finish_pads
from babbitt.reynolds.tilting_pads._pads import CLOSED, CONVERGED, LIMIT, TOUCH, WORK
from babbitt.reynolds.tilting_pads._place import new_places, pads_at
from babbitt.reynolds.tilting_pads._structs import PadPlaces, Pads
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, LOADED, find_fold
from babbitt.reynolds.tilting_pads.flexible_pads import with_bending
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales
from babbitt.reynolds.tilting_pads.load_path import journal_among_pads
from babbitt.reynolds.tilting_pads.model import TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import stiffness_of
from babbitt.reynolds.tilting_pads.solution import (
    FilmLines,
    LightPad,
    PadPosition,
    PadState,
    PadStatus,
    TiltingPadSolution,
)

__all__ = [
    "Fold",
    "fold_of",
    "solve_tilting_pads",
    "solve_with_light_pads",
    "tilting_pads_at",
    "without_light_pads",
]

Array = NDArray[np.float64]
S = TypeVar("S", bound=TiltingPadSolution)

LOWEST = -0.6
"""Eccentricity ratio at the pivot down to which a fold is sought."""


OUTCOMES = {
    CONVERGED: Outcome.CONVERGED, CLOSED: Outcome.OUTSIDE_CLEARANCE, LIMIT: Outcome.PAD_AT_LIMIT,
    WORK: Outcome.WORK_BOUND, TOUCH: Outcome.OVERLOADED,
}  # fmt: skip


STATUSES = {LOADED: PadStatus.LOADED, AT_LIMIT: PadStatus.AT_LIMIT}


def no_total() -> Array:
    """What `find_pads` fills: force (2), stiffness (4)."""
    return np.zeros(6)


def solve_tilting_pads(
    bearing: TiltingPadBearing,
    load: tuple[float, float],
    resolution: Resolution = ENGINEERING,
    *,
    start: tuple[float, float] = (0.0, 0.0),
    max_steps: int = 100,
    without: tuple[int, ...] = (),
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
    without : tuple of int
        Pads that are taken not to carry, wherever the journal stands; pads on flexures carry all the same.

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

    def stiff(bent: TiltingPadBearing, near: tuple[float, float]) -> TiltingPadSolution:
        return stiff_pads_under(bent, load, resolution, near, max_steps, without)

    return with_bending(bearing, start, stiff)


def solve_with_light_pads(
    bearing: TiltingPadBearing, load: tuple[float, float], resolution: Resolution, share: float
) -> TiltingPadSolution:
    """`solve_tilting_pads`, with pads that have no equilibrium about a fold of little load left without any."""

    def solve(without: tuple[int, ...], start: tuple[float, float]) -> TiltingPadSolution:
        return solve_tilting_pads(bearing, load, resolution, start=start, without=without)

    first, found, light = without_light_pads(solve, share * math.hypot(*load))
    return replace(found, light=light) if found.outcome.solved else first


def without_light_pads(
    solve: Callable[[tuple[int, ...], tuple[float, float]], S], most: float
) -> tuple[S, S, tuple[LightPad, ...]]:
    """Films with pads that have no equilibrium about a fold of little load left without any.

    Where a pad would have to carry less than it can, it carries in turn nothing and the load of its fold. If that
    is no more than ``most`` (N), films are sought with the pad unloaded; otherwise there are none.

    Parameters
    ----------
    solve : callable
        Solution without the pads of given numbers, from a place of the journal in m on.
    most : float

    Returns
    -------
    tuple
        The films with all pads, those without the light ones, which may be the same, and what these pads would
        have to carry.
    """
    first = found = solve((), (0.0, 0.0))
    light: dict[int, LightPad] = {}
    while found.outcome is Outcome.PAD_AT_LIMIT and found.limit_pad is not None:
        number, (need, least) = found.limit_pad, found.limit_loads
        if number in light or not least <= most:
            return first, first, ()
        light[number] = LightPad(number, need, least)
        found = solve(tuple(light), (float(found.position[0]), float(found.position[1])))
    return first, found, tuple(light.values())


def stiff_pads_under(
    bearing: TiltingPadBearing,
    load: tuple[float, float],
    resolution: Resolution,
    start: tuple[float, float],
    max_steps: int,
    without: tuple[int, ...] = (),
) -> TiltingPadSolution:
    """Pads whose bores stay as they are under a load."""
    begun = time.perf_counter()
    (scales, pads), axial = bearing.prepared, kernel_operator(resolution.axial_unknowns)
    wanted = (np.asarray(load) + groove_force(bearing)) * scales.sense / scales.force
    at = np.asarray(start) * scales.sense / scales.length
    places, total = new_places(pads), no_total()
    for number in without:
        places.unloaded_below[number] = math.inf
    found = journal_among_pads(
        axial, pads, resolution.intervals, wanted, at, resolution.tolerance, max_steps, places, total
    )
    outcome = OUTCOMES.get(found.status, Outcome.NOT_CONVERGED)
    residual = math.hypot(total[0] + wanted[0], total[1] + wanted[1])
    return assembled(
        bearing, scales, axial, pads, found.grid, places, found.at, total, outcome, residual, found.indifferent,
        found.steps, begun,
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

    def stiff(bent: TiltingPadBearing, near: tuple[float, float]) -> TiltingPadSolution:
        return stiff_pads_at(bent, near, resolution)

    return with_bending(bearing, position, stiff)


def stiff_pads_at(
    bearing: TiltingPadBearing, position: tuple[float, float], resolution: Resolution
) -> TiltingPadSolution:
    """Pads whose bores stay as they are around a journal at a position."""
    begun = time.perf_counter()
    (scales, pads), axial = bearing.prepared, kernel_operator(resolution.axial_unknowns)
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
    position = at * scales.sense * scales.length
    states = pad_states(bearing, scales, axial, pads, grid, places, position)
    limit = int(np.argmax(places.status == AT_LIMIT)) if outcome is Outcome.PAD_AT_LIMIT else None
    if any(math.isnan(state.pivot_stiffness) for state in states):  # no law of its pivot holds there
        outcome = Outcome.OVERLOADED
    return TiltingPadSolution(
        bearing=bearing,
        outcome=outcome,
        position=position,
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


def pad_states(
    bearing: TiltingPadBearing,
    scales: PadScales,
    axial: Axial,
    pads: Pads,
    grid: Grid,
    places: PadPlaces,
    position: Array,
) -> tuple[PadState, ...]:
    """Every pad with its film; those that do not carry are concentric with their bores (eta = 0)."""
    count, n, m = len(bearing.pads), grid.step.shape[1], len(axial.size)
    pressure, void = np.zeros((count, n + 1, m + 1)), np.zeros((count, n + 1, m + 1))
    totals, narrowest = np.zeros((count, TOTALS)), np.zeros(count)
    finish_pads(axial, pads, grid, places, pressure, void, totals, narrowest)
    widths, weights = [bearing.width_of(pad) for pad in bearing.pads], pads.weight.tolist()
    shares = zip(weights, widths, strict=True)
    units = tuple(scales.pressure * weight * bearing.width / width for weight, width in shares)
    lines = FilmLines(bearing, grid.theta, pressure, void, units)
    answers = places.answers * scales.answers
    push, turn = answers[:, 0].tolist(), answers[:, 1].tolist()
    radial, along, rigid, offset, gap = (
        part.tolist() for part in (places.radial, places.along, places.rigid, pads.offset, narrowest)
    )
    x, y = position.tolist()
    states = []
    for k, (pad, code, film) in enumerate(zip(bearing.pads, places.status.tolist(), totals.tolist(), strict=True)):
        load, across = 0.0 - push[k], 0.0 - turn[k] / pad.tangential_stiffness
        tangential = bearing.sense * along[k] * scales.length
        status, tilt = STATUSES.get(code, PadStatus.UNLOADED), math.nan
        if status is PadStatus.LOADED:
            moved = y * math.cos(pad.pivot_angle) - x * math.sin(pad.pivot_angle)
            tilt = (tangential - moved + across) / bearing.lever(pad)
            if not load > 0.0:
                status = PadStatus.UNLOADED
        flow, torque = scales.flow * widths[k] / bearing.width, scales.torque * weights[k]
        states.append(PadState(
            number=k,
            status=status,
            position=PadPosition(tilt, max(0.0, rigid[k] - radial[k]) * scales.length, across),
            radial=(radial[k] - offset[k]) * scales.length,
            tangential=tangential,
            eccentricity_ratio=radial[k] * scales.length / pad.clearance,
            load=load,
            force=answers[k, :2],
            stiffness=answers[k, 2:6].reshape(2, 2),
            damping=answers[k, 6:].reshape(2, 2),
            pivot_stiffness=stiffness_of(pad.pivot, load),
            minimum_film_thickness=gap[k] * scales.length,
            inflow=film[INFLOW] * flow,
            outflow=film[OUTFLOW] * flow,
            side_flow=film[SIDE_FLOW] * flow,
            friction_torque=film[JOURNAL_TORQUE] * torque,
            shear_torque=film[BEARING_TORQUE] * torque,
            lines=lines,
        ))  # fmt: skip
    return tuple(states)


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
    (scales, pads), axial = bearing.prepared, kernel_operator(resolution.axial_unknowns)
    if pads.centred[number]:
        return Fold(Outcome.CONVERGED, 0.0, 0.0, 0.0)
    clearance = pads.bearing.lands[number, 2]
    e, load, eta = find_fold(
        axial, pads, resolution.intervals, number, 0.9 * clearance, LOWEST * clearance, 1e-6, new_places(pads)
    )
    outcome = Outcome.NOT_CONVERGED if math.isnan(e) else Outcome.CONVERGED
    return Fold(outcome, e / clearance, load * scales.force, bearing.sense * eta * scales.length)
