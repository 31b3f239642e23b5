"""Kernels: the journal finds the place where the film carries the load.

Newton with the exact linearised film, one update of the wet set per step. Far from the answer the step is damped
by pseudo-time: (C/dt + K) d = F + W is the motion of an overdamped journal and C is known anyway. Heavy loads are
approached in steps of four, with the lines graded anew at every step.
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import compiled, inner, spliced
from babbitt.reynolds.lands._elimination import count_wet, solve_land
from babbitt.reynolds.lands._endings import add_ends, find_ends
from babbitt.reynolds.lands._forces import add_forces, update_active_set
from babbitt.reynolds.lands._grids import (
    film_coefficients,
    graded_lines,
    intervals_of,
    new_film,
    new_grid,
    new_lines,
    smallest_gap,
    uniform_lines,
)

CONVERGED, TOO_MANY_STEPS, NO_FILM = 0, 1, 2
MODERATE_LOAD = 6.0  # dimensionless load up to which the centred journal is a good start
LIGHT_LOAD = 0.02  # where an attempt in small steps begins
PATIENCE = 40  # updates of the wet set before a patient step
PATIENT_STEPS = 6  # patient steps before the lines are graded anew: a grid blind to the thin film never settles
THINNEST = 1e-3  # of the clearance: a film that settles below, or ends there unsettled, is overloaded
CONTACT = 1e-6  # of the clearance: where a search gives up
LONGEST = 300  # steps of an attempt on coarse grids
COARSE = 1e-2  # of the load: residual at which a coarse grid has done its part, settled wet set or not
CROWD = 16  # one node in so many may change sides in a step; with more the journal waits for the wet set
CYCLING = 30  # steps after which a node that changes sides for ever is let be, if the load is carried within 1e-4


@spliced
def answer_land(axial, bearing, grid, k, film, lines, smooth, result):
    """Add force, stiffness and damping of a land to ``result``, the coefficients of its film known, as `evaluate`
    does of all; returns how many nodes changed.

    Spliced: called, its tuples take a fifth of the time of a small grid.
    """
    m, n = len(axial.size), film.conductance.size
    first = n
    if smooth:
        count_wet(grid, k, lines, m)
        first = find_ends(axial, bearing, grid, k, film, lines)
    solve_land(axial, bearing, grid, k, film, lines, first)
    for i in range(n + 1):
        for j in range(m):
            if smooth:
                lines.solution[i, 0, j] = grid.value[k, i, j]
            else:
                grid.value[k, i, j] = lines.solution[i, 0, j]
    add_forces(axial, bearing, grid, k, film, lines, result)
    if smooth:
        add_ends(axial, grid, k, film, lines, first, result)
        return 0
    return update_active_set(axial, bearing, grid, k, film, lines)


@compiled
def evaluate(axial, bearing, grid, film, lines, x, y, x_rate, y_rate, smooth, result):
    """Force, stiffness and damping of all lands at a position; returns how many nodes changed between wet and dry.

    The force belongs to the wet set found so far; it is exact when nothing changed.

    Between two lines the rupture moves without the wet set noticing, and the adjoints end on a line: stiffness and
    damping are the exact derivatives of the discrete film, but jump by a per cent when a node changes sides.
    With ``smooth`` a film that has settled on this grid keeps its pressure, and the adjoints end where it does
    (``_endings``). (Callers write bool(0): for the literal False the compiler would make a second kernel.)
    """
    result[:] = 0.0
    changed = 0
    m, n = len(axial.size), film.conductance.size
    for k in range(bearing.lands.shape[0]):  # the steps of `answer_land`, whose tuples would take a tenth of it
        film_coefficients(bearing, grid, k, x, y, x_rate, y_rate, film)
        first = n
        if smooth:
            count_wet(grid, k, lines, m)
            first = find_ends(axial, bearing, grid, k, film, lines)
        solve_land(axial, bearing, grid, k, film, lines, first)
        for i in range(n + 1):
            for j in range(m):
                if smooth:
                    lines.solution[i, 0, j] = grid.value[k, i, j]
                else:
                    grid.value[k, i, j] = lines.solution[i, 0, j]
        add_forces(axial, bearing, grid, k, film, lines, result)
        if smooth:
            add_ends(axial, grid, k, film, lines, first, result)
        else:
            changed += update_active_set(axial, bearing, grid, k, film, lines)
    return changed


@compiled
def damped_step(result, rx, ry, size, last_size, load, gap, step_time):
    """Step of the journal under the residual force r: (C/dt + K) d = r, plain Newton below a tenth of the load.

    The first dt moves the journal by half the gap; then dt grows as the residual falls. Returns dx, dy, dt.
    """
    kxx, kxy, kyx, kyy = result[2], result[3], result[4], result[5]
    if result[6] + result[9] <= 1e-12 * load:  # no film at all (a bore that diverges everywhere): follow the load
        return 0.5 * gap * rx / size, 0.5 * gap * ry / size, step_time
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
    det = kxx * kyy - kxy * kyx
    if det == 0.0:
        det = 1e-300
    return (kyy * rx - kxy * ry) / det, (kxx * ry - kyx * rx) / det, step_time


@inner
def settle(axial, bearing, grid, film, lines, load_x, load_y, x, y, tolerance, max_steps, patient, result):
    """Move the journal from (x, y) until the film on this grid carries the load.

    One update of the wet set per step is fast but can lose the film on the way; ``patient`` finds the wet set
    anew, from all wet, before every step.
    """
    load = math.hypot(load_x, load_y)
    floor = tolerance * load + 1e-13
    step_time, last_size, calm = 0.0, 0.0, 0
    held = False
    shrink = 0.6 if patient else 0.25  # of the smallest gap in one step
    gap = smallest_gap(grid, x, y)
    if not gap > 0.0:
        return x, y, NO_FILM, 0, gap
    for step in range(1, max_steps + 1):
        if patient:
            grid.wet[:] = True
        # a calm journal waits for a Reynolds film, which on fine lines may still recede, one line after the other
        waits = grid.wet.shape[1] if calm > 0 and not bearing.conserving else 1
        for _ in range(PATIENCE if patient else waits):
            changed = evaluate(axial, bearing, grid, film, lines, x, y, 0.0, 0.0, bool(0), result)
            if changed == 0:
                break
        held = changed * CROWD > grid.wet.size and not held
        if held:
            continue
        rx, ry = result[0] + load_x, result[1] + load_y
        size = math.hypot(rx, ry)
        if not size < np.inf:
            return x, y, NO_FILM, step, gap
        if size <= floor or (step > CYCLING and size <= 1e-4 * load):
            calm += 1
            if changed == 0 or calm > 4 or tolerance >= COARSE:  # ties may change sides for ever
                return x, y, CONVERGED, step, gap
        dx, dy, step_time = damped_step(result, rx, ry, size, last_size, load, gap, step_time)
        if not math.isfinite(dx + dy):
            return x, y, NO_FILM, step, gap
        last_size = size
        new_gap = smallest_gap(grid, x + dx, y + dy)
        halvings = 0
        while not new_gap > shrink * gap and halvings < 60:
            dx, dy, halvings = 0.5 * dx, 0.5 * dy, halvings + 1
            new_gap = smallest_gap(grid, x + dx, y + dy)
        if not new_gap > CONTACT:
            return x, y, NO_FILM, step, gap
        x, y, gap = x + dx, y + dy, new_gap
    return x, y, TOO_MANY_STEPS, max_steps, gap


@spliced
def approach(axial, bearing, n_coarse, load_x, load_y, x, y, max_steps, patient, first, factor, result):
    """Equilibrium on a coarse grid, load raised from ``first`` by ``factor``: x, y, status, steps, grid."""
    m, count = len(axial.size), bearing.lands.shape[0]
    coarse, other = new_grid(count, n_coarse, m), new_grid(count, n_coarse, m)
    film, lines = new_film(n_coarse), new_lines(n_coarse, m)
    uniform_lines(bearing, coarse)
    load = math.hypot(load_x, load_y)
    share = min(1.0, first / max(load, 1e-300))
    total, gap, status = 0, np.inf, CONVERGED
    steps_per_grid = PATIENT_STEPS if patient else max_steps
    for _ in range(60):
        last_gap = gap
        x, y, status, steps, gap = settle(
            axial,
            bearing,
            coarse,
            film,
            lines,
            share * load_x,
            share * load_y,
            x,
            y,
            COARSE,
            steps_per_grid,
            patient,
            result,
        )
        total += steps
        settled = status == CONVERGED
        if max(gap, last_gap) < THINNEST:  # no way back from there is known
            status = NO_FILM
        if status == NO_FILM or not (settled or patient) or total > LONGEST:
            break
        if settled and (share == 1.0 and (gap > 0.2 or abs(gap - last_gap) < 0.1 * gap)):
            break
        graded_lines(bearing, coarse, x, y, other)
        coarse, other = other, coarse
        if settled and share < 1.0:
            growth = min(factor, 1.0 / share)
            share = min(1.0, share * growth)
            radius = math.hypot(x, y)
            if 0.0 < radius < 1.0:  # (1 - eps) falls with the root of the load
                stretch = (1.0 - (1.0 - radius) * growth**-0.5) / radius
                if smallest_gap(coarse, x * stretch, y * stretch) > 0.25 * gap:
                    x, y = x * stretch, y * stretch
    return x, y, status, total, coarse


@compiled
def find_equilibrium(axial, bearing, n_coarse, n_fine, load_x, load_y, x, y, tolerance, max_steps, result):
    """Equilibrium on graded lines: returns x, y, status, steps, smallest gap and the grid; fills ``result``.

    Numbers of intervals are those of lands up to half a turn (``intervals_of``).

    A fast attempt first; if it loses the film, one that searches on the fine grid, for a coarse one may be blind
    to a thin film beside a groove; then two patient ones, with large steps of the load and with small.
    """
    n_coarse, n_fine = intervals_of(bearing, n_coarse), intervals_of(bearing, n_fine)
    fine = new_grid(bearing.lands.shape[0], n_fine, len(axial.size))
    film, lines = new_film(n_fine), new_lines(n_fine, len(axial.size))
    status, total, gap, x0, y0 = NO_FILM, 0, 0.0, x, y
    for attempt in range(4):
        first, factor = (LIGHT_LOAD, 1.5) if attempt == 3 else (MODERATE_LOAD, 4.0)
        n_search, patient = n_fine if attempt % 2 == 1 else n_coarse, attempt > 1
        x, y, status, steps, coarse = approach(
            axial, bearing, n_search, load_x, load_y, x0, y0, max_steps, patient, first, factor, result
        )
        total += steps
        if status == CONVERGED:
            graded_lines(bearing, coarse, x, y, fine)
            x, y, status, steps, gap = settle(
                axial, bearing, fine, film, lines, load_x, load_y, x, y, tolerance, max_steps, patient, result
            )
            total += steps
        if status == CONVERGED:
            break
    if gap < THINNEST:
        status = NO_FILM
    if bearing.smooth and status == CONVERGED:
        evaluate(axial, bearing, fine, film, lines, x, y, 0.0, 0.0, bearing.smooth, result)
    return x, y, status, total, gap, fine
