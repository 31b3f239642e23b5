"""Films with their own temperatures that the ordinary search loses: other ways to the same place of rest.

The place that is found meets the same tolerances; only the way there is another one, and a slower one.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.film._equilibrium import CONTACT, CONVERGED, NO_FILM, THINNEST, TOO_MANY_STEPS
from babbitt.film._heat_walls import MOST_RISE
from babbitt.film.general import line_density, rest_ring
from babbitt.film.heat import FilmHeat
from babbitt.film.model import JournalFilm, Resolution
from babbitt.film.ring_solution import mirrored
from babbitt.film.scales import Scales
from babbitt.film.thermal import (
    ROUNDS,
    SETTLED,
    STUBBORN,
    WarmRest,
    answer,
    continued,
    fresh_ring,
    rest,
    solve_thermal_journal,
)
from babbitt.film.thermal_solution import ThermalFilm
from babbitt.film.warm_ring import WarmRing

__all__ = ["Place", "mixed_rest", "recovered", "thermal_journal_near"]

Array = NDArray[np.float64]
Place = tuple[float, float, float]
"""x and y of the journal and its least gap, in clearances."""

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
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution, lost: WarmRest
) -> WarmRest:
    """Where the film rests after all, or where the ordinary search ended (``lost``).

    A film that was thrown about under its whole load goes on, with passes that remember each other. What else was
    lost starts anew where the film of one temperature, that of fresh oil, carries the load.
    """
    if _is_thrown_about(lost) and lost.load is not None and np.array_equal(lost.load, load):
        warm = continued(_ring_at(film, heat, scales, lost.position, lost.gap, resolution), lost.warm)
        found = mixed_rest(warm, load, lost.position, resolution.tolerance, SETTLED)
        if found.status == CONVERGED:
            return found
    cold = rest_ring(film, scales.pressure, load, replace(resolution, tolerance=NEAR), STEPS)
    if cold.status != CONVERGED:
        return lost
    warm = _ring_at(film, heat, scales, cold.position, cold.gap, resolution)
    found = rest(warm, load, cold.position, resolution.tolerance, SETTLED)
    if _is_thrown_about(found):
        found = mixed_rest(warm, load, found.position, resolution.tolerance, SETTLED)
    return found if found.status == CONVERGED else lost


def _is_thrown_about(found: WarmRest) -> bool:
    return found.status == TOO_MANY_STEPS and found.gap > THINNEST


def thermal_journal_near(
    film: JournalFilm,
    heat: FilmHeat,
    load: tuple[float, float],
    place: Place,
    resolution: Resolution,
    settled: float,
) -> ThermalFilm:
    """Film that carries a load, on lines drawn for a given place and sought from there.

    For films that are compared with each other: on lines drawn anew for every one of them the answer jumps by the
    error of the grid, on these it changes as smoothly as the film.

    Parameters
    ----------
    film, heat, load, resolution
        As `babbitt.film.thermal.solve_thermal_journal` takes them.
    place : tuple of float
        x and y of the journal and its least gap, in clearances.
    settled : float
        Change of temperature in a pass, K, at which film and temperature rest beside each other.

    Returns
    -------
    ThermalFilm
        That of the ordinary search where none is found from there.
    """
    begun = time.perf_counter()
    scales = Scales.of(film, abs(film.angular_speed))
    seen = mirrored(film) if film.angular_speed < 0.0 else film
    at, force = np.array(place[:2]) * scales.sense, np.asarray(load) * scales.sense / scales.force
    warm = _ring_at(seen, heat, scales, at, place[2], resolution)
    found = rest(warm, force, at, resolution.tolerance, settled)
    if _is_thrown_about(found):
        found = mixed_rest(warm, force, found.position, resolution.tolerance, settled)
    if found.status != CONVERGED:
        return solve_thermal_journal(film, heat, load, resolution)
    return answer(film, seen, scales, found, begun)


def _ring_at(
    film: JournalFilm, heat: FilmHeat, scales: Scales, at: Array, gap: float, resolution: Resolution
) -> WarmRing:
    return fresh_ring(film, heat, scales, 2 * resolution.intervals, resolution, line_density(film, at, gap))


def mixed_rest(warm: WarmRing, load: Array | None, at: Array, tolerance: float, settled: float) -> WarmRest:
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
            return WarmRest(warm, at, NO_FILM, passes, gap)
        if change < settled and size <= floor:
            calm += 1
            if changed == 0 or calm > STUBBORN:
                return WarmRest(warm, at, CONVERGED, passes, gap, load)
        step = np.linalg.solve(warm.sample.stiffness, left) if size > 0.0 else left
        start, move = mixing.move(before, np.concatenate((_packed(warm), at + step)))
        move *= min(1.0, MOST_RISE / max(float(np.abs(move[:-2]).max()), 1e-300))
        at, gap = start[-2:], warm.sample.gap(start[-2:])
        new_gap, halvings = warm.sample.gap(at + move[-2:]), 0
        while not new_gap > SHRINK * gap and halvings < 60:
            move, halvings = 0.5 * move, halvings + 1
            new_gap = warm.sample.gap(at + move[-2:])
        if not new_gap > CONTACT:
            return WarmRest(warm, at, NO_FILM, passes, gap)
        _unpack(warm, start[:-2] + move[:-2])
        at, gap = at + move[-2:], new_gap
    return WarmRest(warm, at, TOO_MANY_STEPS, MOST_MIXED, gap, load)


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


def _packed(warm: WarmRing) -> Array:
    """Temperatures of film, supplies and walls, K."""
    walls = warm.walls
    return np.concatenate((warm.temperature.ravel(), warm.groove, walls.harmonics, walls.journal[:1]))


def _scale(warm: WarmRing) -> Array:
    """Weights of ``_packed``: the film counts by its root mean square."""
    film = np.full(warm.temperature.size, warm.temperature.size**-0.5)
    return np.concatenate((film, np.ones(warm.groove.size + warm.walls.harmonics.size + 1)))


def _unpack(warm: WarmRing, packed: Array) -> None:
    walls, film, supplies = warm.walls, warm.temperature.size, warm.groove.size
    warm.temperature[:] = packed[:film].reshape(warm.temperature.shape)
    warm.groove[:] = packed[film : film + supplies]
    walls.harmonics[:] = packed[film + supplies : -1]
    walls.journal[0] = packed[-1]
    walls.bush[:] = walls.ambient + walls.synthesis @ walls.harmonics
