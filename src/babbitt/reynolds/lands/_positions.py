"""Kernels: the film at a prescribed position, and equilibrium where the film starts at the widest gap."""

from __future__ import annotations

import math

from babbitt.reynolds._compiling import compiled, spliced
from babbitt.reynolds.lands._equilibrium import CONVERGED, NO_FILM, THINNEST, TOO_MANY_STEPS, evaluate, settle
from babbitt.reynolds.lands._grids import (
    graded_lines,
    intervals_of,
    new_film,
    new_grid,
    new_lines,
    smallest_gap,
    uniform_lines,
)

MOST_FILMS = 200
"""Films at one position. (Callers write int(): for a constant the compiler would make a second kernel.)"""


@spliced
def find_wet_set(axial, bearing, grid, film, lines, x, y, x_rate, y_rate, max_steps, result):
    """Repeat the film at one position until no node changes; returns the number of solutions, or -1."""
    for step in range(1, max_steps + 1):
        if evaluate(axial, bearing, grid, film, lines, x, y, x_rate, y_rate, bool(0), result) == 0:
            return step
    return -1


@compiled
def film_at(axial, bearing, n_coarse, n_fine, x, y, x_rate, y_rate, max_steps, result):
    """Film at a position and velocity on graded lines: returns status, steps, gap, grid; fills ``result``."""
    m, count = len(axial.size), bearing.lands.shape[0]
    n_coarse, n_fine = intervals_of(bearing, n_coarse), intervals_of(bearing, n_fine)
    n = n_coarse
    grid = new_grid(count, n, m)
    uniform_lines(bearing, grid)
    gap = smallest_gap(grid, x, y)
    total = 0
    finer = grid
    while gap > 0.0:
        film, lines = new_film(n), new_lines(n, m)
        finer = new_grid(count, n, m)
        graded_lines(bearing, grid, x, y, finer)
        gap = smallest_gap(finer, x, y)
        if not gap > 0.0:
            break
        steps = find_wet_set(axial, bearing, finer, film, lines, x, y, x_rate, y_rate, max_steps, result)
        if steps < 0:
            return TOO_MANY_STEPS, total + max_steps, gap, finer
        total += steps
        if n == n_fine:
            if bearing.smooth:
                evaluate(axial, bearing, finer, film, lines, x, y, x_rate, y_rate, bearing.smooth, result)
            return CONVERGED, total, gap, finer
        grid = finer
        n = min(4 * n, n_fine)
    return NO_FILM, total, gap, finer


@compiled
def find_near(axial, bearing, n_coarse, n_fine, load_x, load_y, x, y, tolerance, max_steps, result):
    """Equilibrium from a position close to it, on lines drawn there: x, y, status, steps, gap, grid."""
    status, total, gap, grid = film_at(axial, bearing, n_coarse, n_fine, x, y, 0.0, 0.0, int(MOST_FILMS), result)
    if status != CONVERGED:
        return x, y, status, total, gap, grid
    n, m = grid.step.shape[1], len(axial.size)
    film, lines = new_film(n), new_lines(n, m)
    x, y, status, steps, gap = settle(
        axial, bearing, grid, film, lines, load_x, load_y, x, y, tolerance, max_steps, bool(0), result
    )
    if gap < THINNEST:
        status = NO_FILM
    if bearing.smooth and status == CONVERGED:
        evaluate(axial, bearing, grid, film, lines, x, y, 0.0, 0.0, bearing.smooth, result)
    return x, y, status, total + steps, gap, grid


@compiled
def find_depth(axial, bearing, n_coarse, n_fine, load, tolerance, max_steps, result):
    """Eccentricity ratio at which a round bore, its film starting at the widest gap, carries ``load``.

    The journal stands on +x, the land runs from -pi to pi. Newton on ln |F| against logit(eps), nearly straight at
    both ends; the derivative is the first column of K. Returns eps, status, steps, smallest gap, grid.
    """
    logit, total = 0.0, 0
    for n in (n_coarse, n_fine):
        bar = 1e-3 if n != n_fine else tolerance
        for _ in range(max_steps):
            eps = 1.0 / (1.0 + math.exp(-logit))
            status, steps, gap, grid = film_at(
                axial, bearing, n_coarse, n, eps, 0.0, 0.0, 0.0, int(MOST_FILMS), result
            )
            total += steps
            if status != CONVERGED:
                return eps, status, total, gap, grid
            force = math.hypot(result[0], result[1])
            if abs(force - load) <= bar * load:
                break
            slope = -(result[0] * result[2] + result[1] * result[4]) / force  # d|F|/d eps
            change = math.log(load / force) * force / (slope * eps * (1.0 - eps))
            logit += min(max(change, -2.0), 2.0)
        else:
            return eps, TOO_MANY_STEPS, total, gap, grid
    return eps, CONVERGED, total, gap, grid
