"""Many grooved round bearings at once, over all cores: sweeps, tolerance studies, tables."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds._structs import CLEARANCE, END, LAND_COLUMNS, START
from babbitt.reynolds.bore import check_lands
from babbitt.reynolds.lands._equilibrium import CONVERGED
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._integrals import (
    IMBALANCE,
    INFLOW,
    JOURNAL_TORQUE,
    OUTFLOW,
    SIDE_FLOW,
    SIDE_INFLOW,
    TOTALS,
)
from babbitt.reynolds.lands._lane_equilibrium import HEAD, find_equilibria
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import ENGINEERING, Cavitation, Land, Resolution

__all__ = ["BatchSolution", "solve_batch"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class BatchSolution:
    """Equilibria of a batch; every array has the bearings as its first axis.

    Attributes
    ----------
    solved : ndarray of bool, shape (bearings,)
        Read this first.
    position : ndarray, shape (bearings, 2)
        m.
    eccentricity_ratio, minimum_film_thickness : ndarray, shape (bearings,)
        1 and m.
    maximum_pressure : ndarray, shape (bearings,)
        Highest gauge pressure on the lines, Pa.
    friction_torque : ndarray, shape (bearings,)
        On the journal, against the rotation, N m.
    side_flow : ndarray, shape (bearings,)
        What leaves by both sides of all lands, m3/s.
    supply_flow : ndarray, shape (bearings, lands)
        What the groove before each land adds: what it sends into the land less what it gets from the land before
        it, m3/s.
    side_inflow, inlet_flow : ndarray, shape (bearings,)
        What the sides draw in, and what enters all lands from their grooves, m3/s.
    mass_balance_error : ndarray, shape (bearings,)
        Over the flow that enters the lands.
    force : ndarray, shape (bearings, 2)
        Of the film on the journal, N.
    stiffness, damping : ndarray, shape (bearings, 2, 2)
        N/m and N s/m.
    iterations : ndarray of int, shape (bearings,)

    Notes
    -----
    An unsolved bearing has no pressure, torque and flows (NaN); its other numbers are those of the end of its
    search.
    """

    solved: NDArray[np.bool_]
    position: Array
    eccentricity_ratio: Array
    minimum_film_thickness: Array
    maximum_pressure: Array
    friction_torque: Array
    side_flow: Array
    supply_flow: Array
    side_inflow: Array
    inlet_flow: Array
    mass_balance_error: Array
    force: Array
    stiffness: Array
    damping: Array
    iterations: NDArray[np.int64]

    def __repr__(self) -> str:
        shapes = [f"{one.name} {getattr(self, one.name).shape}" for one in fields(self)]
        half = (len(shapes) + 1) // 2
        return (
            f"{len(self.solved)} bearings, {np.count_nonzero(self.solved)} solved\n"
            f"  {', '.join(shapes[:half])},\n  {', '.join(shapes[half:])}"
        )


def solve_batch(
    diameter: ArrayLike,
    width: ArrayLike,
    clearance: ArrayLike,
    viscosity: ArrayLike,
    angular_speed: ArrayLike,
    load: ArrayLike,
    lands: tuple[Land, ...],
    cavitation: Cavitation = Cavitation.MASS_CONSERVING,
    resolution: Resolution = ENGINEERING,
    *,
    max_steps: int = 80,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> BatchSolution:
    """Find the equilibria of many bearings that share the layout of their grooves.

    Parameters
    ----------
    diameter, width, clearance, viscosity, angular_speed : array_like
        SI, scalars or arrays that broadcast to one shape (bearings,). The speed is positive (counter-clockwise).
    load : array_like, shape (bearings, 2) or (2,)
        N.
    lands : tuple of Land
        Angles, common to all; round (no clearance, centre or profile of their own), from grooves full of oil at
        ambient pressure.
    cavitation : Cavitation
    resolution : Resolution
    max_steps : int
    workers : int, optional
        Threads; by default as many as there are cores. The answer does not depend on it; in the last digits it
        depends on the neighbours, with which a bearing is solved side by side.
    progress : callable, optional
        Called with how many bearings are done, and how many there are.

    Returns
    -------
    BatchSolution

    Raises
    ------
    InputError
        E101 for lands that are not round, grooves under pressure or not full, values that are not positive, or a
        load without both components.
    """
    check_lands(lands, 0.0)
    if any(land.clearance is not None or land.centre != (0.0, 0.0) or land.profile for land in lands):
        raise InputError("E101", "a batch takes round lands only; solve lobes and measured bores one by one.")
    if any(land.start_pressure > 0.0 or land.end_pressure > 0.0 or land.start_fill < 1.0 for land in lands):
        raise InputError(
            "E101", "a batch takes grooves full of oil at ambient pressure only; solve others one by one "
            "(the pressure of a groove acts on the journal, too)."
        )  # fmt: skip
    if cavitation is Cavitation.HALF_SOMMERFELD:
        raise InputError("E101", "a batch has no half-Sommerfeld condition; solve such films one by one.")
    force = np.atleast_2d(np.asarray(load, dtype=float))
    if force.ndim != 2 or force.shape[1] != 2:
        raise InputError(
            "E101", f"load has shape {np.shape(load)}; it must be (2,) or (bearings, 2): both components, in N."
        )
    values = [np.asarray(v, dtype=float) for v in (diameter, width, clearance, viscosity, angular_speed)]
    count = np.broadcast_shapes(*(v.shape for v in values), force.shape[:1])[0]
    d, b, c, eta, omega = (np.broadcast_to(v, (count,)) for v in values)
    if not all(np.all(np.isfinite(v) & (v > 0.0)) for v in values) or not np.all(np.isfinite(force)):
        raise InputError(
            "E101", "diameter, width, clearance, viscosity and angular_speed must be positive, load finite."
        )
    pressure = eta * omega * (0.5 * d / c) ** 2
    unit = pressure * 0.5 * d * b
    table = np.zeros((len(lands), LAND_COLUMNS))
    for row, land in zip(table, lands, strict=True):
        row[START], row[END], row[CLEARANCE] = land.start_angle, land.end_angle, 1.0
    wanted = np.broadcast_to(force, (count, 2)) / unit[:, None]
    found = np.empty((count, HEAD + RESULT_SIZE))
    totals = np.full((count, len(lands), TOTALS), np.nan)
    found[:, HEAD - 1] = np.nan
    wanted, kappa = np.ascontiguousarray(wanted), (d / b) ** 2 / 12.0
    axial = kernel_operator(resolution.axial_unknowns)
    chunk = max(8, min(64, count // 16))  # of the count alone: neighbours tell in the last digits

    def settle(first: int) -> None:
        find_equilibria(
            axial, table, kappa,
            cavitation is Cavitation.MASS_CONSERVING, resolution.coarse_intervals, resolution.intervals, wanted,
            resolution.tolerance, max_steps, first, min(first + chunk, count), found, totals,
        )  # fmt: skip

    tell = progress or (lambda done, of: None)
    settle(0)  # compiles, where that is still to be done, before the threads start
    tell(min(chunk, count), count)
    firsts = range(chunk, count, chunk)
    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        for first, _ in zip(firsts, pool.map(settle, firsts), strict=True):
            tell(min(first + chunk, count), count)
    before = _lands_before(lands)
    flow, torque = omega * 0.5 * d * c * b, eta * omega * (0.5 * d) ** 3 * b / c
    per_length = (unit / c)[:, None, None]
    entering = totals[:, :, INFLOW].sum(axis=1)
    return BatchSolution(
        solved=found[:, 2] == CONVERGED,
        position=found[:, :2] * c[:, None],
        eccentricity_ratio=np.hypot(found[:, 0], found[:, 1]),
        minimum_film_thickness=found[:, 4] * c,
        maximum_pressure=found[:, 5] * pressure,
        friction_torque=totals[:, :, JOURNAL_TORQUE].sum(axis=1) * torque,
        side_flow=totals[:, :, SIDE_FLOW].sum(axis=1) * flow,
        supply_flow=(totals[:, :, INFLOW] - totals[:, before, OUTFLOW]) * flow[:, None],
        side_inflow=totals[:, :, SIDE_INFLOW].sum(axis=1) * flow,
        inlet_flow=entering * flow,
        mass_balance_error=np.abs(totals[:, :, IMBALANCE]).sum(axis=1) / np.maximum(np.abs(entering), 1e-300),
        force=found[:, HEAD : HEAD + 2] * unit[:, None],
        stiffness=found[:, HEAD + 2 : HEAD + 6].reshape(count, 2, 2) * per_length,
        damping=found[:, HEAD + 6 :].reshape(count, 2, 2) * (per_length / omega[:, None, None]),
        iterations=found[:, 3].astype(np.int64),
    )


def _lands_before(lands: tuple[Land, ...]) -> list[int]:
    """For each land the number of the one that the journal leaves before it enters it."""
    order = sorted(range(len(lands)), key=lambda number: lands[number].start_angle % (2.0 * math.pi))
    before = dict(zip(order[1:] + order[:1], order, strict=True))
    return [before[number] for number in range(len(lands))]
