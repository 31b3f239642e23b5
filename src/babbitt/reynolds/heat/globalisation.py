"""Films with their own temperatures that the ordinary search loses: other ways to the same place of rest.

The place that is found meets the same tolerances; only the way there is another one, and a slower one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

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
    fresh_ring,
    rest,
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
MEMORY, MIXED, MOST_MIXED = 10, 0.3, 100
"""Passes that are combined, share of the residual that the next takes, and how many there may be."""
ASTRAY, LEAST_MIXED, SAME = 5.0, 0.05, 1e-6
"""Residual over the least one from which the passes begin anew; share of the residual then, at least; residuals
that differ by less are one."""
SHRINK = 0.6
"""Share of the least gap that a step of the journal leaves."""
GAP_IN_KELVIN = 50.0
"""Change of all temperatures that counts as much as a journal that moves by the least gap."""


def recovered(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution,
    lost: ThermalEquilibrium, share: float,
) -> ThermalEquilibrium:  # fmt: skip
    """Where the film rests after all, or where a search ended.

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
    warm = _ring_at(film, heat, scales, at, gap, resolution)
    found = stabilised(rest(warm, load, at, resolution.tolerance, SETTLED), resolution, SETTLED)
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
    warm = continued(_ring_at(film, heat, scales, lost.position, lost.gap, resolution), lost.warm)
    return accelerated_equilibrium(warm, load, lost.position, resolution.tolerance, SETTLED)


def _is_thrown_about(found: ThermalEquilibrium) -> bool:
    return found.status == TOO_MANY_STEPS and found.gap > THINNEST


def stabilised(found: ThermalEquilibrium, resolution: Resolution, settled: float) -> ThermalEquilibrium:
    """Let a film that passes threw about come to rest after all, on the same lines."""
    if found.load is None or not _is_thrown_about(found):
        return found
    return accelerated_equilibrium(found.warm, found.load, found.position, resolution.tolerance, settled)


def _ring_at(
    film: JournalFilm, heat: FilmHeat, scales: Scales, at: Array, gap: float, resolution: Resolution
) -> ThermalFilmState:
    return fresh_ring(film, heat, scales, 2 * resolution.intervals, resolution, line_density(film, at, gap))


def accelerated_equilibrium(
    warm: ThermalFilmState, load: Array | None, at: Array, tolerance: float, settled: float
) -> ThermalEquilibrium:
    """Let film, temperature and journal (where there is a load) come to rest by Anderson's mixing of the passes.

    A pass is a map G of temperatures, walls and journal; its residual f = G(x) - x. Of the last passes that
    combination is taken whose residual is least in the linear picture,

        gamma = argmin |f - dF gamma|,   x' = x + b f - (dX + b dF) gamma,

    which also calms waves that run through the film from pass to pass, as where hot oil flows back before the
    inlet.
    Source: D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547-560;
    H. F. Walker, P. Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011)
    1715-1735.
    """
    floor, calm = 0.0 if load is None else tolerance * math.hypot(*load) + 1e-13, 0
    gap = warm.sample.gap(at)
    mixing = Mixing(np.concatenate((_scale(warm), np.full(2, GAP_IN_KELVIN / gap))))
    for passes in range(1, MOST_MIXED + 1):
        before = np.concatenate((_packed(warm), at))
        warm.relaxation = 1.0
        changed, change = warm.advance(at, SWEEPS, ROUNDS)
        left = np.zeros(2) if load is None else warm.sample.force + load
        size = math.hypot(*left)
        if not (math.isfinite(size) and math.isfinite(change)):
            return ThermalEquilibrium(warm, at, NO_FILM, passes, gap)
        if change < settled and size <= floor:
            calm += 1
            if changed == 0 or calm > MAX_STALLED_PASSES:
                return ThermalEquilibrium(warm, at, CONVERGED, passes, gap, load, mixed=True)
        try:
            step = np.linalg.solve(warm.sample.stiffness, left) if size > 0.0 else left
        except np.linalg.LinAlgError:  # no film that answers to the journal
            return ThermalEquilibrium(warm, at, NO_FILM, passes, gap)
        start, move = mixing.move(before, np.concatenate((_packed(warm), at + step)))
        move *= min(1.0, MOST_RISE / max(float(np.abs(move[:-2]).max()), 1e-300))
        at, gap = start[-2:], warm.sample.gap(start[-2:])
        new_gap, halvings = warm.sample.gap(at + move[-2:]), 0
        while not new_gap > SHRINK * gap and halvings < 60:
            move, halvings = 0.5 * move, halvings + 1
            new_gap = warm.sample.gap(at + move[-2:])
        if not new_gap > CONTACT:
            return ThermalEquilibrium(warm, at, NO_FILM, passes, gap)
        _unpack(warm, start[:-2] + move[:-2])
        at, gap = at + move[-2:], new_gap
    return ThermalEquilibrium(warm, at, TOO_MANY_STEPS, MOST_MIXED, gap, load)


@dataclass
class Mixing:
    """Anderson's combination of passes, begun anew from the best of them when it goes astray.

    Attributes
    ----------
    scale : ndarray
        Weights of the state in the norm of residuals.
    share : float
        Of the residual that the next state takes.
    """

    scale: Array
    share: float = MIXED
    states: list[Array] = field(default_factory=list)
    residuals: list[Array] = field(default_factory=list)
    best: float = math.inf

    def move(self, before: Array, after: Array) -> tuple[Array, Array]:
        """State to go on from, and the move from there, after a pass from ``before`` to ``after``."""
        norm = self.norm(after - before)
        if norm > ASTRAY * self.best:
            least = min(range(len(self.states)), key=lambda one: self.norm(self.residuals[one]))
            self.states, self.residuals = [self.states[least]], [self.residuals[least]]
            self.share, self.best = max(0.5 * self.share, LEAST_MIXED), self.norm(self.residuals[0])
            return self.states[0], self.share * self.residuals[0]
        self.best = min(self.best, norm)
        self.states = [*self.states, before][-MEMORY:]
        self.residuals = [*self.residuals, after - before][-MEMORY:]
        last = self.residuals[-1]
        if len(self.states) == 1:
            return before, self.share * last
        steps, gains = np.diff(np.array(self.states), axis=0), np.diff(np.array(self.residuals), axis=0)
        # a few long vectors: threads of a BLAS would wait for each other longer than they work, einsum has none
        weighted = gains * self.scale**2
        normal, right = np.einsum("ik,jk->ij", weighted, gains), np.einsum("ik,k->i", weighted, last)
        part = np.linalg.lstsq(normal, right, rcond=SAME**2)[0]
        return before, self.share * last - np.einsum("ik,i->k", steps + self.share * gains, part)

    def norm(self, residual: Array) -> float:
        """Weighted size of a residual."""
        return float(np.linalg.norm(residual * self.scale))


def _packed(warm: ThermalFilmState) -> Array:
    """Temperatures of film, supplies and walls, K."""
    walls = warm.walls
    return np.concatenate((warm.temperature.ravel(), warm.groove, walls.harmonics, walls.journal[:1]))


def _scale(warm: ThermalFilmState) -> Array:
    """Weights of ``_packed``: the film counts by its root mean square."""
    film = np.full(warm.temperature.size, warm.temperature.size**-0.5)
    return np.concatenate((film, np.ones(warm.groove.size + warm.walls.harmonics.size + 1)))


def _unpack(warm: ThermalFilmState, packed: Array) -> None:
    walls, film, supplies = warm.walls, warm.temperature.size, warm.groove.size
    warm.temperature[:] = packed[:film].reshape(warm.temperature.shape)
    warm.groove[:] = packed[film : film + supplies]
    walls.harmonics[:] = packed[film + supplies : -1]
    walls.journal[0] = packed[-1]
    walls.bush[:] = walls.ambient + walls.synthesis @ walls.harmonics
