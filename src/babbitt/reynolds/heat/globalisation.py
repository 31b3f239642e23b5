"""Films with their own temperatures that the ordinary search loses: other ways to the same equilibrium position.

The place that is found meets the same tolerances; only the way there is another one, and a slower one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.anderson import AndersonOptions, FixedPointStatus, fixed_point
from babbitt.numerics.damped_newton import halved_for_room
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.heat._heat_walls import MOST_RISE
from babbitt.reynolds.heat.heat_model import FilmHeat
from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
from babbitt.reynolds.heat.thermal_passes import (
    MAX_STALLED_PASSES,
    ROUNDS,
    SETTLED,
    ThermalEquilibrium,
    attempt,
    continued,
    find_thermal_equilibrium,
    fresh_ring,
)
from babbitt.reynolds.lands._equilibrium import CONTACT, CONVERGED, NO_FILM, THINNEST, TOO_MANY_STEPS
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.surface_equilibrium import line_density

__all__ = ["stabilised", "accelerated_equilibrium", "recovered"]

Array = NDArray[np.float64]

STEPS, NEAR = 100, 1e-2
"""Steps to the place of a film of one temperature on one grid, and the residual force over load that ends them."""
SWEEPS = 20
"""Of the energy equation in a pass."""
MIXED = AndersonOptions(most_evaluations=100, memory=9, damping=0.3, astray=5.0)
"""How passes are combined."""
SHRINK = 0.6
"""Share of the least gap that a step of the journal leaves."""
GAP_IN_KELVIN = 50.0
"""Change of all temperatures that counts as much as a journal that moves by the least gap."""


def recovered(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution,
    lost: ThermalEquilibrium, share: float,
) -> ThermalEquilibrium:  # fmt: skip
    """The equilibrium after all, or where a search ended.

    A film that was thrown about under its whole load goes on, with passes that remember each other. What else was
    lost is sought under a load that grows from a ``share`` of it, and at last from where the film of one
    temperature, that of fresh oil, carries the load.
    """
    found = _gone_on(film, heat, scales, load, resolution, lost)
    if found.status != CONVERGED and share < 1.0:
        lost = attempt(film, heat, scales, load, resolution, share)
        found = _gone_on(film, heat, scales, load, resolution, lost)
    if found.status == CONVERGED:
        return found
    force = load * scales.force
    one = solve_journal(
        film, (float(force[0]), float(force[1])), replace(resolution, tolerance=NEAR), max_steps=STEPS
    )
    if not one.outcome.solved:
        return lost
    at, gap = one.position / scales.length, one.minimum_film_thickness / scales.length
    thermal = _ring_at(film, heat, scales, at, gap, resolution)
    found = stabilised(
        find_thermal_equilibrium(thermal, load, at, resolution.tolerance, SETTLED), resolution, SETTLED
    )
    return found if found.status == CONVERGED else lost


def _gone_on(
    film: JournalFilm,
    heat: FilmHeat,
    scales: Scales,
    load: Array,
    resolution: Resolution,
    lost: ThermalEquilibrium,
) -> ThermalEquilibrium:
    """Where passes that remember each other bring a film that was thrown about under its whole load."""
    if not _is_thrown_about(lost) or lost.load is None or not np.array_equal(lost.load, load):
        return lost
    thermal = continued(_ring_at(film, heat, scales, lost.position, lost.gap, resolution), lost.thermal)
    return accelerated_equilibrium(thermal, load, lost.position, resolution.tolerance, SETTLED)


def _is_thrown_about(found: ThermalEquilibrium) -> bool:
    return found.status == TOO_MANY_STEPS and found.gap > THINNEST


def stabilised(found: ThermalEquilibrium, resolution: Resolution, settled: float) -> ThermalEquilibrium:
    """Let a film that passes threw about converge after all, on the same lines."""
    if found.load is None or not _is_thrown_about(found):
        return found
    return accelerated_equilibrium(found.thermal, found.load, found.position, resolution.tolerance, settled)


def _ring_at(
    film: JournalFilm, heat: FilmHeat, scales: Scales, at: Array, gap: float, resolution: Resolution
) -> ThermalFilmState:
    return fresh_ring(film, heat, scales, 2 * resolution.intervals, resolution, line_density(film, at, gap))


def accelerated_equilibrium(
    thermal: ThermalFilmState, load: Array | None, at: Array, tolerance: float, settled: float
) -> ThermalEquilibrium:
    """Let film, temperature and journal (where there is a load) converge by passes that remember each other.

    A pass is a map of temperatures, walls and journal. Anderson's combination of the last ones also calms waves
    that run through the film from pass to pass, as where hot oil flows back before the inlet.
    """
    gap = thermal.sample.gap(at)
    passes = _Passes(thermal, load, 0.0 if load is None else tolerance * math.hypot(*load) + 1e-13, settled)
    weights = np.concatenate((_scale(thermal), np.full(2, GAP_IN_KELVIN / gap)))
    start = np.concatenate((_packed(thermal), at))
    found = fixed_point(passes.residual, passes.settled, start, MIXED, passes.bounded, weights)
    at = found.state[-2:]
    gap = thermal.sample.gap(at)
    if found.status is FixedPointStatus.LOST:
        return ThermalEquilibrium(thermal, at, NO_FILM, found.evaluations, gap)
    status = CONVERGED if found.converged else TOO_MANY_STEPS
    return ThermalEquilibrium(thermal, at, status, found.evaluations, gap, load, mixed=found.converged)


@dataclass(eq=False)
class _Passes:
    """Passes as a map of the state: temperatures (``_packed``), then the place of the journal."""

    thermal: ThermalFilmState
    load: Array | None
    floor: float
    change_at_rest: float
    calm: int = 0
    at_rest: bool = False

    def residual(self, state: Array) -> Array | None:
        """What a pass changes; None where the film is none, or does not answer to the journal."""
        thermal, at = self.thermal, state[-2:]
        _unpack(thermal, state[:-2])
        thermal.relaxation = 1.0
        changed, change = thermal.advance(at, SWEEPS, ROUNDS)
        left = np.zeros(2) if self.load is None else thermal.sample.force + self.load
        size = math.hypot(*left)
        if not (math.isfinite(size) and math.isfinite(change)):
            return None
        rests = change < self.change_at_rest and size <= self.floor
        self.calm += rests
        self.at_rest = rests and (changed == 0 or self.calm > MAX_STALLED_PASSES)
        try:
            step = np.linalg.solve(thermal.sample.stiffness, left) if size > 0.0 else left
        except np.linalg.LinAlgError:
            return None
        return np.concatenate((_packed(thermal) - state[:-2], step))

    def settled(self, state: Array, residual: Array) -> bool:
        """Whether the last pass found the film at rest."""
        return self.at_rest

    def bounded(self, state: Array, move: Array) -> Array | None:
        """The move with a bound on the temperatures, halved for the gap; None where no gap is left."""

        def gap(place: Array) -> float:
            return self.thermal.sample.gap(place[-2:])

        move = move * min(1.0, MOST_RISE / max(float(np.abs(move[:-2]).max()), 1e-300))
        taken = halved_for_room(gap, state, move, max(SHRINK * gap(state), CONTACT))
        return None if taken is None else taken[0]


def _packed(thermal: ThermalFilmState) -> Array:
    """Temperatures of film, supplies and walls, K."""
    walls = thermal.walls
    return np.concatenate((thermal.temperature.ravel(), thermal.groove, walls.harmonics, walls.journal[:1]))


def _scale(thermal: ThermalFilmState) -> Array:
    """Weights of ``_packed``: the film counts by its root mean square."""
    film = np.full(thermal.temperature.size, thermal.temperature.size**-0.5)
    return np.concatenate((film, np.ones(thermal.groove.size + thermal.walls.harmonics.size + 1)))


def _unpack(thermal: ThermalFilmState, packed: Array) -> None:
    walls, film, supplies = thermal.walls, thermal.temperature.size, thermal.groove.size
    thermal.temperature[:] = packed[:film].reshape(thermal.temperature.shape)
    thermal.groove[:] = packed[film : film + supplies]
    walls.harmonics[:] = packed[film + supplies : -1]
    walls.journal[0] = packed[-1]
    walls.bush[:] = walls.ambient + walls.synthesis @ walls.harmonics
