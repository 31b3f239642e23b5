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
from babbitt.reynolds.lands._equilibrium import THINNEST
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads._pads import CLOSED, CONVERGED, LIMIT
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales
from babbitt.reynolds.tilting_pads.model import TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_films import PadFilms
from babbitt.reynolds.tilting_pads.pad_heat import THERMAL_PADS, PadHeat
from babbitt.reynolds.tilting_pads.solve import OUTCOMES, groove_force, without_light_pads
from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution
from babbitt.reynolds.tilting_pads.thermal_pad_states import Settled, thermal_solution
from babbitt.reynolds.tilting_pads.thermal_returning_pads import returning_pads

__all__ = ["find_thermal_tilting_pads", "thermal_pads_with_light_ones", "thermal_tilting_pads_at"]

Array = NDArray[np.float64]

RELAXATIONS = (0.8, 0.4, 0.2)
"""Shares of a new viscosity that a pass takes, in one attempt after the other."""
SETTLED, SHAPED = 5e-3, 3e-4
"""Largest change of temperature in a pass, K, and of a pad's shape over the smallest gap, when converged."""
MOST_PASSES, GROWING_PASSES = 100, 40
"""Of an attempt, and of one with a little more growth."""
LOOSE, FINE = 1e-2, 1e-4
"""Residual force over load in the first pass, and behind one whose temperatures change by a kelvin or more; less
in proportion."""
THINNING = 0.04
"""Share by which oils thin in a kelvin, about: viscosities that differ from those of the temperatures count as
changes of temperature."""
SMALL_CHANGE = 15.0
"""Change of temperature in a pass, K, behind which the journal needs no search."""
PATIENT, SWING = 25, 0.3
"""Passes from which on temperatures may swing, and by how much, K."""
CAREFUL = 0.4
"""Share of a new viscosity in passes with growth that failed before."""
FIRST_SHARE, LEAST_SHARE = 0.25, 0.02
"""Of the growth: the first step, and that at which no more is tried."""
MOST_STEPS = 100
"""Of the journal in one pass."""
NEARER, IN_VAIN = 0.7, 10
"""Share of the least change of temperature that counts as nearer, and passes in a row that bring it no nearer,
after which an attempt is given up."""
HELD = 6
"""Passes in a row with a pad at its limit, behind which temperatures may change by `SWING`: each takes thousands
of films."""
BOUNCES = 4
"""Times that a pad comes to its limit in an attempt, loaded in between, behind which the attempt ends: steps as
large as these lead from the temperatures of either state to the other."""
MOST_FILMS = 40_000
"""Solutions of the film of a pad in one attempt: about 0.3 s."""
MOST_GROWING_FILMS = 60_000
"""The same of all steps of growth, about 0.6 s: behind them the share at which a film was found is not refined."""
ENDS = (Outcome.CONVERGED, Outcome.PAD_AT_LIMIT, Outcome.OUTSIDE_CLEARANCE)
"""What smaller steps would not change, unless a pad bounced into its limit."""
DECIDED = (*ENDS, Outcome.NO_CLEARANCE)
"""What counts more than a pad that bounced with larger steps."""
CLOSING = (Outcome.NOT_CONVERGED, Outcome.OUTSIDE_CLEARANCE)
"""How a step of growth ends behind which no film exists: gaps shrink from pass to pass, or a pad is touched."""
LEAST_TAKEN = 0.1
"""Share of an assembled clearance that all growth takes below which it closes none: of 82 random bearings that it
closes it is 0.44 or more. A step that fails sooner, as where wet sets of a pad without load flip, has not
converged: of one such bearing it is 0.04."""


def find_thermal_tilting_pads(
    bearing: TiltingPadBearing,
    load: tuple[float, float],
    heat: PadHeat,
    resolution: Resolution = THERMAL_PADS,
    *,
    start: tuple[float, float] = (0.0, 0.0),
    without: tuple[int, ...] = (),
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
    without : tuple of int
        Pads that are taken not to carry, as of `solve.solve_tilting_pads`; those that would at the temperatures
        found are ``light``.

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
    settled = search(bearing, heat, resolution, wanted, at, without)
    return replace(thermal_solution(settled, begun), light=returning_pads(settled, wanted))


def thermal_pads_with_light_ones(
    bearing: TiltingPadBearing, load: tuple[float, float], heat: PadHeat, resolution: Resolution, share: float
) -> ThermalTiltingPadSolution:
    """`find_thermal_tilting_pads`, with pads that have no equilibrium about a fold of no more than a share of the
    load left without any (`solve.without_light_pads`).

    At the temperatures of that state such a pad must not carry more than the share as soon as it comes back.
    """

    def solve(without: tuple[int, ...], start: tuple[float, float]) -> ThermalTiltingPadSolution:
        return find_thermal_tilting_pads(bearing, load, heat, resolution, start=start, without=without)

    most = share * math.hypot(*load)
    first, found, _ = without_light_pads(solve, most)
    is_little = all(one.returning <= most and one.need <= most and not one.least > most for one in found.light)
    return found if found.outcome.solved and is_little else first


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
    bearing: TiltingPadBearing, heat: PadHeat, resolution: Resolution, load: Array | None, at: Array,
    without: tuple[int, ...] = (),
) -> Settled:  # fmt: skip
    """Attempts with ever smaller steps of the viscosity, or with more and more growth; without a load the journal
    stands."""
    passes, bounced = 0, None
    for part in RELAXATIONS:
        settled = settle(PadFilms.of(bearing, heat, resolution, without), load, at, part)
        passes += settled.passes
        if is_end(settled):
            break
        bounced = settled if settled.bounces else bounced
        if heat.growth is not None:
            settled = grow(settled, load, at)
            passes = settled.passes
            break
    return replace(behind_bounces(settled, bounced), passes=passes)


def is_end(settled: Settled) -> bool:
    """Whether smaller steps would not change how an attempt ended."""
    return settled.outcome in ENDS and not settled.bounces


def behind_bounces(last: Settled, bounced: Settled | None) -> Settled:
    """The last attempt, or one whose pad bounced into its limit where smaller steps found nothing else."""
    return last if bounced is None or last.outcome in DECIDED else bounced


def grow(failed: Settled, load: Array | None, at: Array) -> Settled:
    """From a bearing that does not grow to as much of its growth as leaves a film.

    Growth feeds itself: less clearance, more heat. There may be a share of it behind which no film exists: then
    the clearance closes. Where steps end otherwise, at a bound on work or a pad at its limit, that is the outcome.
    """
    films, passes = failed.films, failed.passes
    best, bounced = failed, None
    for part in RELAXATIONS:
        cold = PadFilms.of(films.bearing, films.heat, films.resolution, films.without)
        cold.share = 0.0
        best = settle(cold, load, at, part)
        passes += best.passes
        if is_end(best):
            break
        bounced = best if best.bounces else bounced
    best = behind_bounces(best, bounced)
    share, step, last, work = 0.0, FIRST_SHARE, best, 0
    while best.outcome.solved and share < 1.0 and step >= LEAST_SHARE and work <= MOST_GROWING_FILMS:
        trial = best.films.copied()
        trial.share, work = min(share + step, 1.0), work - trial.solved
        found = settle(trial, load, best.placement.at, CAREFUL, GROWING_PASSES)
        passes, work = passes + found.passes, work + trial.solved
        if found.outcome.solved:
            best, share, step = found, trial.share, 1.5 * step
        else:
            step, last = 0.5 * step, found
    if last.outcome.solved and share < 1.0:
        best = replace(best, outcome=Outcome.WORK_BOUND)
    elif best.outcome.solved and share < 1.0:
        closes = last.outcome in CLOSING and not taken(best.films) < LEAST_TAKEN * share
        best = replace(best, outcome=Outcome.NO_CLEARANCE) if closes else last
    return replace(best, passes=passes)


def taken(films: PadFilms) -> float:
    """Largest share of an assembled clearance that growth has taken."""
    clearances = np.array([pad.assembled_clearance for pad in films.bearing.pads])
    return float((films.grown * films.scales.length / clearances).max())


def settle(films: PadFilms, load: Array | None, at: Array, part: float, most: int = MOST_PASSES) -> Settled:
    """Passes until temperatures, shapes and journal converge.

    Where the end of a film jumps from node to node for ever, temperatures next to it swing; they are let be once
    they only swing, by less than `SWING`. So are they where a pad stays at its limit. A pad that comes to its
    limit again and again ends the attempt there.
    """
    tolerance, change, rises = LOOSE, math.inf, np.zeros_like(films.films.temperature)
    nearest, reached, held, bounces, near = math.inf, 0, 0, 0, False
    for passes in range(1, most + 1):
        before = films.films.temperature.copy()
        asked = max(films.resolution.tolerance, tolerance)
        if load is None or not near:
            behind = films.prepare(part)
            placement = films.place(at) if load is None else films.carry(load, at, asked, MOST_STEPS)
            warmed = films.heat_up(placement)
        else:
            behind, placement, warmed = films.follow(load, placement, asked, MOST_STEPS, part)
        at = placement.at
        if placement.status == CLOSED:
            return Settled(films, placement, Outcome.OUTSIDE_CLEARANCE, passes)
        if films.solved > MOST_FILMS:
            return Settled(films, placement, Outcome.WORK_BOUND, passes)
        change = max(warmed, behind / THINNING)
        near = change < SMALL_CHANGE and placement.status == CONVERGED
        if not math.isfinite(change) or films.gap() < THINNEST:
            break
        shaped, last = films.deform(placement.grid), rises
        rises = films.films.temperature - before
        swings = passes > PATIENT and float(np.vdot(rises, last)) < 0.0
        bounces += placement.status == LIMIT and held == 0
        held = held + 1 if placement.status == LIMIT else 0
        if change < (SWING if swings or held >= HELD else SETTLED) and shaped < SHAPED:
            return Settled(films, placement, OUTCOMES.get(placement.status, Outcome.NOT_CONVERGED), passes)
        if held and bounces >= BOUNCES:
            return Settled(films, placement, Outcome.PAD_AT_LIMIT, passes, bounces=True)
        tolerance = FINE * min(change, 1.0)
        if change < NEARER * nearest:
            nearest, reached = change, passes
        elif nearest > SWING and passes - reached > IN_VAIN:
            break
    return Settled(films, placement, Outcome.NOT_CONVERGED, passes)
