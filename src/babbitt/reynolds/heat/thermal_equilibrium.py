"""The door of the thermal film: where the journal rests when the oil heats itself.

Every step is one pass of Reynolds equation, energy equation and walls (``warm_ring``), and one Newton step of the
journal on the stiffness at frozen temperatures; on a coarse ring first, then on the fine one. At the end the film
rests and the energy equation alone is solved until heat closes to round-off.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.heat.heat_model import THERMAL_ENGINEERING, FilmHeat
from babbitt.reynolds.heat.thermal_film_state import WarmRing
from babbitt.reynolds.heat.thermal_solution import ThermalFilm, thermal_film
from babbitt.reynolds.lands._equilibrium import (
    CONTACT,
    CONVERGED,
    CYCLING,
    MODERATE_LOAD,
    NO_FILM,
    THINNEST,
    TOO_MANY_STEPS,
    damped_step,
)
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.stability.load_slope import RestingNodes
from babbitt.reynolds.surface.mesh_lines import Density
from babbitt.reynolds.surface.surface_equilibrium import Effort, Sample, SettledRing, line_density
from babbitt.reynolds.surface.surface_equilibrium import rest as carry
from babbitt.reynolds.surface.surface_solution import (
    couette_shear,
    mirrored,
    slope_torque,
    solution_of,
    streamer_shear,
    supply_order,
)
from babbitt.reynolds.surface.unwrapped_mesh import build_ring

__all__ = ["solve_thermal_journal", "thermal_film_at"]

Array = NDArray[np.float64]

SWEEPS = 3
"""Of the energy equation in a pass, before the walls answer; one more follows them."""
COARSE, COARSELY_SETTLED = 1e-2, 2.0
"""Residual force over load, and change of temperature in a pass (K), at which a coarse ring has done its part."""
SETTLED = 5e-2
"""Change of temperature in a pass, K, at which film and temperature rest beside each other."""
COLD_LOAD = 2.0
"""Dimensionless load up to which the journal starts where a film of fresh oil carries it: a centred one leaks
nothing and would have no bound to its temperature."""
COLDLY_CARRIED = 0.2
"""Residual force over load of this start: the first heat moves the journal by more."""
CLOSING, CLOSED, OPEN = 400, 1e-8, 1e-4
"""Rounds that close the heat balance at most, the change of temperature in K at which they end, and that from
which the film counts as not converged."""
POLISH, POLISHED, NEARLY, MISSED = 8, 1e-9, 1e-5, 1e-4
"""Last steps of the journal at frozen temperatures, at most, the residual force over load that ends them, that
from which one step does, and that with which the film has not converged."""
THICK = 0.3
"""Gap, in clearances, down to which lines may stand as for a journal at the usual place."""
USUAL_PLACE, USUAL_ATTITUDE = 0.6, math.radians(45.0)
"""Of the journal: relative eccentricity, and angle ahead of the load."""
USUAL_ROUNDS = 1
"""Updates of the wet set there before the film tells how warm it gets."""
MOST_PASSES = 120
NEARER, IN_VAIN = 0.8, 40
"""Share of the least distance from rest that counts as nearer, and passes in a row that bring the film no nearer,
after which it counts as thrown about."""
STUBBORN = 4
"""Passes at rest after which nodes that change sides for ever are let be."""
SUNK = 12
"""Passes in a row with a gap that counts as none, after which the film is given up."""
PATIENT_FROM, ROUNDS = 8, 8
"""Pass from which on the wet set is let settle at every position, and in how many rounds."""


@dataclass(frozen=True, eq=False)
class WarmRest:
    """Where a search ended; ``mixed`` where only passes that remember each other brought the film to rest."""

    warm: WarmRing
    position: Array
    status: int
    passes: int
    gap: float
    load: Array | None = None
    mixed: bool = False


@dataclass(frozen=True, eq=False)
class Posed:
    """A film in the frame of its load and as it is solved, turning forwards, with its dimensionless load."""

    frame: LoadFrame
    seen: JournalFilm
    scales: Scales
    load: Array


def solve_thermal_journal(
    film: JournalFilm, heat: FilmHeat, load: tuple[float, float], resolution: Resolution = THERMAL_ENGINEERING
) -> ThermalFilm:
    """Find where a film with its own temperatures carries a load.

    Parameters
    ----------
    film : JournalFilm
        ``viscosity`` is the unit of the calculation only; take that of the fresh oil.
    heat : FilmHeat
    load : tuple of float
        Force on the journal, N.
    resolution : Resolution

    Returns
    -------
    ThermalFilm
        Always; its film says whether it is an equilibrium.

    Raises
    ------
    InputError
        E101 if the load is zero or not finite, the journal stands still, the film does not conserve oil, or
        viscosity under pressure is asked for.
    """
    begun, asked = time.perf_counter(), posed(film, load)
    found = search(asked.seen, heat, asked.scales, asked.load, resolution)
    return answer(asked.frame, asked.seen, asked.scales, found, begun)


def posed(film: JournalFilm, load: tuple[float, float]) -> Posed:
    """A film under a load, N, as it is solved; raises as `solve_thermal_journal`."""
    if not all(math.isfinite(part) for part in load):
        raise InputError("E101", f"load is {load}; both components must be finite, in N.")
    if not any(load):
        raise InputError("E101", f"load is {load}; without load a film need not hold the journal anywhere, nor "
                         "carry its heat off. Give a load, or a position to thermal_film_at.")  # fmt: skip
    if film.cavitation is not Cavitation.MASS_CONSERVING:
        raise InputError("E101", f"cavitation is {film.cavitation.name.lower()}; oil that comes from nowhere, "
                         "where a film forms anew, has no temperature. Choose mass_conserving.")  # fmt: skip
    turning_forwards(film)  # refuses what is no thermal film
    frame = LoadFrame.of(film, load)
    seen, scales = turning_forwards(frame.film)
    return Posed(frame, seen, scales, np.asarray(frame.load) * scales.sense / scales.force)


def turning_forwards(film: JournalFilm) -> tuple[JournalFilm, Scales]:
    """A film as it is solved, and its scales; raises if it is not sheared or knows viscosity under pressure."""
    if film.pressure_viscosity is not None:
        raise InputError(
            "E101", "pressure_viscosity is given; a film with its own temperatures does not count it."
        )
    if film.angular_speed == 0.0:
        raise InputError("E101", "angular_speed is zero; a film at rest makes no heat and carries no steady load.")
    return mirrored(film) if film.angular_speed < 0.0 else film, Scales.of(film, abs(film.angular_speed))


def thermal_film_at(
    film: JournalFilm,
    heat: FilmHeat,
    position: tuple[float, float],
    resolution: Resolution = THERMAL_ENGINEERING,
    settled: float = SETTLED,
) -> ThermalFilm:
    """Film with its own temperatures at a prescribed position (m) of the journal; see `solve_thermal_journal`.

    ``settled`` is the change of temperature in a pass, K, at which film and temperature rest beside each other.

    Raises
    ------
    InputError
        E101 if the journal stands still or viscosity under pressure is asked for.
    """
    begun = time.perf_counter()
    turning_forwards(film)  # refuses what is no thermal film
    frame = LoadFrame.of(film, position)
    seen, scales = turning_forwards(frame.film)
    at = np.asarray(frame.load) * scales.sense / scales.length
    warm = fresh_ring(seen, heat, scales, 2 * resolution.intervals, resolution, None)
    gap = warm.sample.gap(at)
    if not gap > 0.0:
        return answer(frame, seen, scales, WarmRest(warm, at, NO_FILM, 0, gap), begun)
    status, passes = TOO_MANY_STEPS, 0
    while passes < MOST_PASSES and status != CONVERGED:
        passes += 1
        changed, change = warm.advance(at, SWEEPS)
        if changed == 0 and change < settled:
            status = CONVERGED
    found = WarmRest(warm, at, status, passes, gap)
    if status != CONVERGED:
        from babbitt.reynolds.heat.globalisation import mixed_rest

        found = mixed_rest(warm, None, at, resolution.tolerance, settled)
    return answer(frame, seen, scales, found, begun)


def search(film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution) -> WarmRest:
    """On the fine ring at once where the film stays thick, else after a coarse one; then with a growing load."""
    size = math.hypot(*load)
    found = on_usual_lines(film, heat, scales, load, resolution) if size <= COLD_LOAD else None
    if found is not None and found.status == CONVERGED and found.gap > THICK:
        return found
    found, share = attempt(film, heat, scales, load, resolution, 1.0), 0.1 * MODERATE_LOAD / max(size, 1e-300)
    if found.status != CONVERGED:
        from babbitt.reynolds.heat.globalisation import recovered

        found = recovered(film, heat, scales, load, resolution, found, min(share, 1.0))
    return replace(found, status=NO_FILM) if found.gap < THINNEST else found


def on_usual_lines(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution
) -> WarmRest | None:
    """Equilibrium on the fine ring at once; None where the film is thin already at the temperature guessed.

    Lines crowd a little where a film of usual thickness would be thin.
    """
    along, across = USUAL_PLACE * load / max(math.hypot(*load), 1e-300), np.array([-1.0, 1.0])
    usual = math.cos(USUAL_ATTITUDE) * along + math.sin(USUAL_ATTITUDE) * across * along[::-1]
    density = line_density(film, usual, 1.0 - USUAL_PLACE)
    warm = fresh_ring(film, heat, scales, 2 * resolution.intervals, resolution, density)
    for _ in range(USUAL_ROUNDS):
        warm.sample.evaluate(usual)
    thinner = warm.guess(usual)
    at, _, _, gap = carry(warm.sample, load / thinner, usual, COLDLY_CARRIED, 30, False)
    return rest(warm, load, at, resolution.tolerance, SETTLED) if gap > THICK else None


def attempt(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution, share: float
) -> WarmRest:
    """Coarse rings under a growing load, then the fine ring."""
    per_turn, total = 2 * resolution.intervals, 0
    warm = fresh_ring(film, heat, scales, per_turn // 2, resolution, None)
    at = cold_start(warm.sample, share * load)
    while True:
        found = rest(warm, share * load, at, COARSE, COARSELY_SETTLED)
        total += found.passes
        if found.status != CONVERGED:
            return replace(found, passes=total)
        at, density = found.position, line_density(film, found.position, found.gap)
        if share == 1.0:
            break
        share = min(1.0, 3.0 * share)
        warm = continued(fresh_ring(film, heat, scales, per_turn // 2, resolution, density), warm)
    warm = continued(fresh_ring(film, heat, scales, per_turn, resolution, density), warm)
    found = rest(warm, load, at, resolution.tolerance, SETTLED)
    return replace(found, passes=total + found.passes)


def cold_start(sample: Sample, load: Array) -> Array:
    """Where a film of fresh oil carries the load, or a part of it that leaves the film thick."""
    part = min(1.0, COLD_LOAD / max(math.hypot(*load), 1e-300))
    at, _, _, gap = carry(sample, part * load, np.zeros(2), COLDLY_CARRIED, 30, False)
    return at if gap > 0.0 else np.zeros(2)


def fresh_ring(
    film: JournalFilm, heat: FilmHeat, scales: Scales, per_turn: int, resolution: Resolution,
    density: Density | None,
) -> WarmRing:  # fmt: skip
    """Ring at the supply temperature."""
    ring = build_ring(film, scales.pressure, per_turn, resolution.axial_unknowns, density)
    warm = WarmRing.of(Sample.of(ring, Effort(math.inf)), heat, film, scales.rate)
    warm.density = density
    return warm


def continued(warm: WarmRing, before: WarmRing) -> WarmRing:
    """Take over wet set and temperatures of a ring with the same columns."""
    warm.sample.start_from(before.sample)
    warm.start_from(before)
    return warm


def rest(warm: WarmRing, load: Array, at: Array, tolerance: float, settled: float) -> WarmRest:
    """Let film, temperature and journal come to rest on one ring."""
    size_of_load = math.hypot(*load)
    floor = tolerance * size_of_load + 1e-13
    step_time, last, calm, sunk = 0.0, 0.0, 0, 0
    nearest, reached = math.inf, 0
    gap = warm.sample.gap(at)
    if not gap > 0.0:
        return WarmRest(warm, at, NO_FILM, 0, gap)
    for passes in range(1, MOST_PASSES + 1):
        changed, change = warm.advance(at, SWEEPS, 1 if 1 < passes < PATIENT_FROM else ROUNDS)
        sample = warm.sample
        residual = sample.force + load
        size = math.hypot(*residual)
        if not (math.isfinite(size) and math.isfinite(change)):
            return WarmRest(warm, at, NO_FILM, passes, gap)
        if change < settled and (size <= floor or (passes > CYCLING and size <= 1e-4 * size_of_load)):
            calm += 1
            if changed == 0 or calm > STUBBORN:
                return WarmRest(warm, at, CONVERGED, passes, gap, load)
        off = max(change / settled, size / floor)
        if off < NEARER * nearest:
            nearest, reached = off, passes
        elif passes - reached > IN_VAIN:
            return WarmRest(warm, at, TOO_MANY_STEPS, passes, gap, load)
        flat = np.concatenate((sample.force, sample.stiffness.ravel(), sample.damping.ravel()))
        dx, dy, step_time = damped_step(flat, residual[0], residual[1], size, last, size_of_load, gap, step_time)
        move, last, halvings = np.array([dx, dy]), size, 0
        new_gap = sample.gap(at + move)
        while not new_gap > 0.4 * gap and halvings < 60:
            move, halvings = 0.5 * move, halvings + 1
            new_gap = sample.gap(at + move)
        if not new_gap > CONTACT:
            return WarmRest(warm, at, NO_FILM, passes, gap)
        at, gap = at + move, new_gap
        sunk = sunk + 1 if gap < THINNEST else 0
        if sunk > SUNK:
            return WarmRest(warm, at, NO_FILM, passes, gap)
    return WarmRest(warm, at, TOO_MANY_STEPS, MOST_PASSES, gap, load)


def polished(found: WarmRest) -> WarmRest:
    """Let the film carry the load exactly, its temperatures as they are: Newton steps from the last pass.

    The film is left with the coefficients of its answer (``smooth``); a step from ``NEARLY`` there is the last.
    Where the load is missed by more than ``MISSED`` at the end, the film has not converged.
    """
    sample, at, load, smooth = found.warm.sample, found.position, found.load, False
    whole = 0.0 if load is None else math.hypot(*load)
    for _ in range(POLISH):
        residual = np.zeros(2) if load is None else sample.force + load
        size = math.hypot(*residual)
        if size <= POLISHED * whole + 1e-14:
            break
        at, smooth = at + np.linalg.solve(sample.stiffness, residual), size <= NEARLY * whole
        sample.evaluate(at, smooth=smooth)
    gap = sample.gap(at)
    if not gap > CONTACT:
        at, gap, smooth = found.position, found.gap, False
    if not smooth:
        sample.evaluate(at, smooth=True)
    missed = load is not None and not math.hypot(*(sample.force + load)) <= MISSED * whole + 1e-14
    return replace(found, position=at, gap=gap, status=TOO_MANY_STEPS if missed else found.status)


def answer(frame: LoadFrame, seen: JournalFilm, scales: Scales, found: WarmRest, begun: float) -> ThermalFilm:
    """Close the heat balance, solve for the coefficients; everything in SI and in the frame as given."""
    warm = found.warm
    if found.status == CONVERGED:
        found = polished(found)
    if found.status == CONVERGED:
        warm.gather(found.position)
        if not warm.close(CLOSING, CLOSED) < OPEN:
            found = replace(found, status=TOO_MANY_STEPS)
    settled = SettledRing(seen, warm.sample, found.position, found.status, found.passes, found.gap)
    surface = warm.sample.ring.surface
    viscosity = warm.flows.shear_viscosity[: surface.step.size][:, warm.columns.column[surface.node]]
    streamers = streamer_shear(settled, couette_shear(settled, viscosity))
    torques = warm.friction, warm.friction - 2.0 * slope_torque(settled), streamers
    solution = solution_of(frame.film, scales, settled, torques, begun)
    thermal = thermal_film(solution, scales, warm, supply_order(frame.film, seen))
    return turned_back(frame, replace(thermal, nodes=RestingNodes(settled, frame, scales)))


def turned_back(frame: LoadFrame, found: ThermalFilm) -> ThermalFilm:
    """A thermal film that was solved in the frame of its load, in that in which it was given."""
    order = frame.supplies(found.groove_temperatures.size)
    return replace(
        found,
        film=frame.back(found.film),
        groove_temperatures=found.groove_temperatures[order],
        fresh_flow=found.fresh_flow[order],
        returned_flow=found.returned_flow[order],
    )
