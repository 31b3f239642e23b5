"""Passes of Reynolds equation, energy equation and walls, until film, temperature and journal rest."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.heat.heat_model import FilmHeat
from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
from babbitt.reynolds.lands._equilibrium import (
    CONTACT,
    CONVERGED,
    CYCLING,
    NO_FILM,
    THINNEST,
    TOO_MANY_STEPS,
    damped_step,
)
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.mesh_lines import Density
from babbitt.reynolds.surface.surface_equilibrium import Effort, SurfaceState, line_density
from babbitt.reynolds.surface.surface_equilibrium import rest as carry
from babbitt.reynolds.surface.unwrapped_mesh import build_ring

__all__ = ["ThermalEquilibrium", "attempt", "cold_start", "continued", "fresh_ring", "rest"]

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
MOST_PASSES = 120
NEARER, IN_VAIN = 0.8, 40
"""Share of the least distance from rest that counts as nearer, and passes in a row that bring the film no nearer,
after which it counts as thrown about."""
MAX_STALLED_PASSES = 4
"""Passes at rest after which nodes that change sides for ever are let be."""
MAX_CONTACT_PASSES = 12
"""Passes in a row with a gap that counts as none, after which the film is given up."""
ACTIVE_SET_ROUNDS, ROUNDS = 8, 8
"""Pass from which on the wet set is let settle at every position, and in how many rounds."""


@dataclass(frozen=True, eq=False)
class ThermalEquilibrium:
    """Where a search ended; ``mixed`` where only passes that remember each other brought the film to rest."""

    warm: ThermalFilmState
    position: Array
    status: int
    passes: int
    gap: float
    load: Array | None = None
    mixed: bool = False


def attempt(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution, share: float
) -> ThermalEquilibrium:
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


def cold_start(sample: SurfaceState, load: Array) -> Array:
    """Where a film of fresh oil carries the load, or a part of it that leaves the film thick."""
    part = min(1.0, COLD_LOAD / max(math.hypot(*load), 1e-300))
    at, _, _, gap = carry(sample, part * load, np.zeros(2), COLDLY_CARRIED, 30, False)
    return at if gap > 0.0 else np.zeros(2)


def fresh_ring(
    film: JournalFilm, heat: FilmHeat, scales: Scales, per_turn: int, resolution: Resolution,
    density: Density | None,
) -> ThermalFilmState:  # fmt: skip
    """Ring at the supply temperature."""
    ring = build_ring(film, scales.pressure, per_turn, resolution.axial_unknowns, density)
    warm = ThermalFilmState.of(SurfaceState.of(ring, Effort(math.inf)), heat, film, scales.rate)
    warm.density = density
    return warm


def continued(warm: ThermalFilmState, before: ThermalFilmState) -> ThermalFilmState:
    """Take over wet set and temperatures of a ring with the same columns."""
    warm.sample.start_from(before.sample)
    warm.start_from(before)
    return warm


def rest(warm: ThermalFilmState, load: Array, at: Array, tolerance: float, settled: float) -> ThermalEquilibrium:
    """Let film, temperature and journal come to rest on one ring."""
    size_of_load = math.hypot(*load)
    floor = tolerance * size_of_load + 1e-13
    step_time, last, calm, sunk = 0.0, 0.0, 0, 0
    nearest, reached = math.inf, 0
    gap = warm.sample.gap(at)
    if not gap > 0.0:
        return ThermalEquilibrium(warm, at, NO_FILM, 0, gap)
    for passes in range(1, MOST_PASSES + 1):
        changed, change = warm.advance(at, SWEEPS, 1 if 1 < passes < ACTIVE_SET_ROUNDS else ROUNDS)
        sample = warm.sample
        residual = sample.force + load
        size = math.hypot(*residual)
        if not (math.isfinite(size) and math.isfinite(change)):
            return ThermalEquilibrium(warm, at, NO_FILM, passes, gap)
        if change < settled and (size <= floor or (passes > CYCLING and size <= 1e-4 * size_of_load)):
            calm += 1
            if changed == 0 or calm > MAX_STALLED_PASSES:
                return ThermalEquilibrium(warm, at, CONVERGED, passes, gap, load)
        off = max(change / settled, size / floor)
        if off < NEARER * nearest:
            nearest, reached = off, passes
        elif passes - reached > IN_VAIN:
            return ThermalEquilibrium(warm, at, TOO_MANY_STEPS, passes, gap, load)
        flat = np.concatenate((sample.force, sample.stiffness.ravel(), sample.damping.ravel()))
        dx, dy, step_time = damped_step(flat, residual[0], residual[1], size, last, size_of_load, gap, step_time)
        move, last, halvings = np.array([dx, dy]), size, 0
        new_gap = sample.gap(at + move)
        while not new_gap > 0.4 * gap and halvings < 60:
            move, halvings = 0.5 * move, halvings + 1
            new_gap = sample.gap(at + move)
        if not new_gap > CONTACT:
            return ThermalEquilibrium(warm, at, NO_FILM, passes, gap)
        at, gap = at + move, new_gap
        sunk = sunk + 1 if gap < THINNEST else 0
        if sunk > MAX_CONTACT_PASSES:
            return ThermalEquilibrium(warm, at, NO_FILM, passes, gap)
    return ThermalEquilibrium(warm, at, TOO_MANY_STEPS, MOST_PASSES, gap, load)
