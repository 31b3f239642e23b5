"""The doors of tilting pads with their temperatures.

A pass finds journal and pads in equilibrium at the viscosity as it is, then the temperatures that belong to these
films, exactly but for the pads behind them, which answer by turns, and for bending and growth. Viscosities follow
by a share of the way. See ``pad_films`` for a pass.
"""

from __future__ import annotations

import math
import time
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads._pads import CLOSED
from babbitt.reynolds.tilting_pads.model import TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_films import PadFilms
from babbitt.reynolds.tilting_pads.pad_heat import PadHeat
from babbitt.reynolds.tilting_pads.solve import OUTCOMES, PadScales, groove_force
from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution
from babbitt.reynolds.tilting_pads.thermal_pad_states import Settled, thermal_solution

__all__ = ["THERMAL_PADS", "find_thermal_tilting_pads", "thermal_tilting_pads_at"]

Array = NDArray[np.float64]

THERMAL_PADS = Resolution(4, 48)
"""Usual grid: temperatures within 0.2 K of finer ones."""
RELAXATIONS = (0.8, 0.4, 0.2)
"""Shares of a new viscosity that a pass takes, in one attempt after the other."""
SETTLED, SHAPED = 0.01, 3e-4
"""Largest change of temperature in a pass, K, and of a pad's shape over the smallest gap, at which they rest."""
MOST_PASSES = 60
LOOSE = 1e-3
"""Residual force over load in passes whose temperatures change by a kelvin; less in proportion."""
MOST_STEPS = 100
"""Of the journal in one pass."""
ENDS = (Outcome.CONVERGED, Outcome.PAD_AT_LIMIT, Outcome.OUTSIDE_CLEARANCE)
"""What smaller steps would not change."""


def find_thermal_tilting_pads(
    bearing: TiltingPadBearing,
    load: tuple[float, float],
    heat: PadHeat,
    resolution: Resolution = THERMAL_PADS,
    *,
    start: tuple[float, float] = (0.0, 0.0),
) -> ThermalTiltingPadSolution:
    """Find where pads with their own temperatures carry a load.

    Parameters
    ----------
    bearing : TiltingPadBearing
        ``viscosity`` is the unit of the calculation only; take that of the fresh oil.
    load : tuple of float
        Force on the journal, N.
    heat : PadHeat
    resolution : Resolution
        ``axial_unknowns`` and ``intervals`` of every pad, ``tolerance`` of the force.
    start : tuple of float
        Where the search begins, m.

    Returns
    -------
    ThermalTiltingPadSolution
        Always; ``outcome`` says whether it is an equilibrium.

    Raises
    ------
    InputError
        E101 if the load is not finite, or a pad has a viscosity of its own.
    """
    if not all(math.isfinite(part) for part in load):
        raise InputError("E101", f"load is {load}; both components must be finite, in N.")
    begun, scales = time.perf_counter(), PadScales(bearing)
    wanted = (np.asarray(load) + groove_force(bearing)) * scales.sense / scales.force
    at = np.asarray(start) * scales.sense / scales.length
    return thermal_solution(search(bearing, heat, resolution, wanted, at), begun)


def thermal_tilting_pads_at(
    bearing: TiltingPadBearing, position: tuple[float, float], heat: PadHeat, resolution: Resolution = THERMAL_PADS
) -> ThermalTiltingPadSolution:
    """Temperatures, tilts and films of pads around a journal at a prescribed position, m.

    Returns
    -------
    ThermalTiltingPadSolution
        With `Outcome.OUTSIDE_CLEARANCE` where the journal would touch a pad.
    """
    begun, scales = time.perf_counter(), PadScales(bearing)
    at = np.asarray(position) * scales.sense / scales.length
    return thermal_solution(search(bearing, heat, resolution, None, at), begun)


def search(
    bearing: TiltingPadBearing, heat: PadHeat, resolution: Resolution, load: Array | None, at: Array
) -> Settled:
    """Attempts with ever smaller steps of the viscosity; without a load the journal stands."""
    passes = 0
    for part in RELAXATIONS:
        settled = settle(PadFilms.of(bearing, heat, resolution), load, at, part)
        passes += settled.passes
        if settled.outcome in ENDS:
            break
    return replace(settled, passes=passes)


def settle(films: PadFilms, load: Array | None, at: Array, part: float) -> Settled:
    """Passes until temperatures, shapes and journal rest."""
    tolerance, calm = LOOSE, False
    for passes in range(1, MOST_PASSES + 1):
        films.prepare(part)
        if load is None:
            placement = films.place(at)
        else:
            placement = films.carry(load, at, max(films.resolution.tolerance, tolerance), MOST_STEPS)
            at = placement.at
        if placement.status == CLOSED:
            return Settled(films, placement, Outcome.OUTSIDE_CLEARANCE, passes)
        change = films.heat_up(placement)
        if not math.isfinite(change):
            break
        shaped = films.deform(placement.grid)
        rests = change < SETTLED and shaped < SHAPED
        if rests and calm:
            return Settled(films, placement, OUTCOMES.get(placement.status, Outcome.NOT_CONVERGED), passes)
        calm, tolerance = rests, 0.0 if rests else LOOSE * min(change, 1.0)
    return Settled(films, placement, Outcome.NOT_CONVERGED, passes)
