"""Kernels: the journal finds the place where the film carries the load.

Newton with the exact linearised film, one update of the wet set per step. Far from the answer the step is damped
by pseudo-time: (C/dt + K) d = F + W is the motion of an overdamped journal and C is known anyway. Heavy loads are
approached in steps of four, with the lines graded anew at every step.
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.film._elimination import solve_land
from babbitt.film._forces import RESULT_SIZE, add_forces, end_at_rupture, update_wet_set
from babbitt.film._grids import (
    fill_grid,
    film_coefficients,
    graded_lines,
    grid_of,
    lines_with,
    new_film,
    new_grids,
    new_lines,
    smallest_gap,
    uniform_lines,
)
from babbitt.film._structs import compiled

CONVERGED, TOO_MANY_STEPS, NO_FILM = 0, 1, 2
MODERATE_LOAD = 6.0  # dimensionless load up to which the centred journal is a good start
HISTORY = 5  # what a settle reports: x, y, status, steps, smallest gap


@compiled
def evaluate(axial, bearing, grids, wet, film, lines, x, y, x_rate, y_rate, result):
    """Force, stiffness and damping of all lands at a position; returns how many nodes changed between wet and dry.

    The force belongs to the wet set found so far; it is exact when nothing changed.
    """
    kappa = bearing.diameter_to_width**2 / 12.0
    result[:] = 0.0
    changed = 0
    for k in range(bearing.lands.shape[0]):
        land, grid, own = bearing.lands[k], grid_of(grids, k), lines_with(lines, wet[k])
        film_coefficients(land, grid, bearing.speed, x, y, x_rate, y_rate, film)
        solve_land(axial, land, grid, film, own, kappa, bearing.side_pressure, bearing.conserving, grid.step.size)
        add_forces(axial, land, grid, film, own, kappa, bearing.side_pressure, bearing.conserving, result)
        changed += update_wet_set(axial, film, own, kappa, bearing.side_pressure, bearing.conserving)
    return changed


@compiled
def smooth_coefficients(axial, bearing, grids, wet, film, lines, x, y, result):
    """Force, stiffness and damping at a settled position, the adjoints ending where the film does.

    Between two grid lines the rupture moves without the wet set noticing, and the adjoints of ``evaluate`` end on a
    line: their coefficients jump by a per cent when a node changes sides. Here they end at the rupture itself.
    """
    kappa = bearing.diameter_to_width**2 / 12.0
    result[:] = 0.0
    n = film.conductance.size
    for k in range(bearing.lands.shape[0]):
        land, grid, own = bearing.lands[k], grid_of(grids, k), lines_with(lines, wet[k])
        film_coefficients(land, grid, bearing.speed, x, y, 0.0, 0.0, film)
        solve_land(axial, land, grid, film, own, kappa, bearing.side_pressure, bearing.conserving, n)
        pressure = own.solution[:, 0, :].copy()
        first = end_at_rupture(axial, film, own, bearing.conserving)
        solve_land(axial, land, grid, film, own, kappa, bearing.side_pressure, bearing.conserving, first)
        own.ending[:] = 0.0
        own.solution[:, 0, :] = pressure
        add_forces(axial, land, grid, film, own, kappa, bearing.side_pressure, bearing.conserving, result)


@compiled
def film_thickness_minimum(grids, x, y):
    """Smallest gap over all lands."""
    smallest = np.inf
    for k in range(grids.step.shape[0]):
        smallest = min(smallest, smallest_gap(grid_of(grids, k), x, y))
    return smallest


@compiled
def settle(axial, bearing, grids, wet, film, lines, load_x, load_y, x, y, tolerance, max_steps, result):
    """Move the journal from (x, y) until the film on these grids carries the load."""
    load = math.hypot(load_x, load_y)
    floor = tolerance * load + 1e-13
    step_time, last_size, calm = 0.0, 0.0, 0
    gap = film_thickness_minimum(grids, x, y)
    if not gap > 0.0:
        return x, y, NO_FILM, 0, gap
    for step in range(1, max_steps + 1):
        changed = evaluate(axial, bearing, grids, wet, film, lines, x, y, 0.0, 0.0, result)
        rx, ry = result[0] + load_x, result[1] + load_y
        size = math.hypot(rx, ry)
        if not size < np.inf:
            return x, y, NO_FILM, step, gap
        if size <= floor:
            calm += 1
            if changed == 0 or calm > 4:  # ties may change sides for ever
                return x, y, CONVERGED, step, gap
        kxx, kxy, kyx, kyy = result[2], result[3], result[4], result[5]
        if size > 0.1 * load and load > 0.0:
            cxx, cxy, cyx, cyy = result[6], result[7], result[8], result[9]
            if step_time == 0.0:
                det = cxx * cyy - cxy * cyx
                speed = math.hypot(cyy * rx - cxy * ry, cxx * ry - cyx * rx) / max(abs(det), 1e-300)
                step_time = 0.5 * gap / max(speed, 1e-300)
            else:
                step_time *= min(max(2.0 * last_size / size, 0.2), 8.0)
            kxx += cxx / step_time
            kxy += cxy / step_time
            kyx += cyx / step_time
            kyy += cyy / step_time
        last_size = size
        det = kxx * kyy - kxy * kyx
        if det == 0.0:
            return x, y, TOO_MANY_STEPS, step, gap
        dx, dy = (kyy * rx - kxy * ry) / det, (kxx * ry - kyx * rx) / det
        new_gap = film_thickness_minimum(grids, x + dx, y + dy)
        halvings = 0
        while not new_gap > 0.25 * gap and halvings < 60:
            dx, dy, halvings = 0.5 * dx, 0.5 * dy, halvings + 1
            new_gap = film_thickness_minimum(grids, x + dx, y + dy)
        x, y, gap = x + dx, y + dy, new_gap
    return x, y, TOO_MANY_STEPS, max_steps, gap


@compiled
def grade(bearing, coarse, coarse_wet, x, y, fine, fine_wet):
    """Lines of ``fine`` from the gap at (x, y) and the wet set on ``coarse``; prolongs the wet set by OR."""
    cells = coarse.step.shape[1]
    n = fine.step.shape[1]
    m = coarse_wet.shape[2]
    crowd = np.empty(cells)
    depth = max(0.0, 1.0 - film_thickness_minimum(coarse, x, y))
    exponent = 0.8 * min(depth, 1.0) ** 4
    for k in range(bearing.lands.shape[0]):
        land, old, new = bearing.lands[k], grid_of(coarse, k), grid_of(fine, k)
        for i in range(cells):
            crowd[i] = 1.0
            for j in range(m):
                if coarse_wet[k, i, j] != coarse_wet[k, i + 1, j]:
                    crowd[i] = bearing.crowding
        graded_lines(land, old, x, y, exponent, crowd, new)
        fill_grid(land, bearing.profiles[k], new)
        c = 0
        for i in range(n + 1):
            while c < cells - 1 and old.theta[c + 1] < new.theta[i]:
                c += 1
            for j in range(m):
                fine_wet[k, i, j] = coarse_wet[k, c, j] or coarse_wet[k, c + 1, j]


@compiled
def find_equilibrium(axial, bearing, n_coarse, n_fine, load_x, load_y, x, y, tolerance, max_steps):
    """Equilibrium on graded lines: returns x, y, status, steps, smallest gap, the result vector, grids and wet set."""
    m, count = len(axial.size), bearing.lands.shape[0]
    result = np.zeros(RESULT_SIZE)
    coarse, coarse_wet = new_grids(count, n_coarse), np.ones((count, n_coarse + 1, m), np.bool_)
    other, other_wet = new_grids(count, n_coarse), np.ones((count, n_coarse + 1, m), np.bool_)
    fine, fine_wet = new_grids(count, n_fine), np.ones((count, n_fine + 1, m), np.bool_)
    film, lines = new_film(n_fine), new_lines(n_fine, m)
    coarse_film, coarse_lines = new_film(n_coarse), new_lines(n_coarse, m)
    for k in range(count):
        uniform_lines(bearing.lands[k], grid_of(coarse, k))
        fill_grid(bearing.lands[k], bearing.profiles[k], grid_of(coarse, k))
    load = math.hypot(load_x, load_y)
    share = min(1.0, MODERATE_LOAD / max(load, 1e-300))
    total, gap, status = 0, np.inf, CONVERGED
    for _ in range(40):
        last_gap = gap
        x, y, status, steps, gap = settle(
            axial, bearing, coarse, coarse_wet, coarse_film, coarse_lines, share * load_x, share * load_y, x, y,
            1e-3, max_steps, result,
        )  # fmt: skip
        total += steps
        if status == NO_FILM:
            break
        if share == 1.0 and (gap > 0.2 or abs(gap - last_gap) < 0.1 * gap):
            break
        grade(bearing, coarse, coarse_wet, x, y, other, other_wet)
        coarse, coarse_wet, other, other_wet = other, other_wet, coarse, coarse_wet
        if share < 1.0:
            growth = min(4.0, 1.0 / share)
            share = min(1.0, share * growth)
            pull = growth**-0.5  # (1 - eps) falls with the root of the load
            radius = math.hypot(x, y)
            if 0.0 < radius < 1.0:
                stretch = (1.0 - (1.0 - radius) * pull) / radius
                if film_thickness_minimum(coarse, x * stretch, y * stretch) > 0.25 * gap:
                    x, y = x * stretch, y * stretch
    if status != NO_FILM:
        grade(bearing, coarse, coarse_wet, x, y, fine, fine_wet)
        x, y, status, steps, gap = settle(
            axial, bearing, fine, fine_wet, film, lines, load_x, load_y, x, y, tolerance, max_steps, result
        )
        total += steps
        if bearing.smooth and status == CONVERGED:
            smooth_coefficients(axial, bearing, fine, fine_wet, film, lines, x, y, result)
    return x, y, status, total, gap, result, fine, fine_wet
