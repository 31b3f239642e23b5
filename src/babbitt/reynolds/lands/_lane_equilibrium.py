"""Kernels: the equilibria of many bearings, several side by side (``_lanes``).

Every lane goes through the fast attempt of ``find_equilibrium`` at its own pace: one evaluation moves all lanes of a
pool on by a step, and a lane that has settled hands over to the next pool and takes the next bearing. A pool for
coarse grids, one for fine grids, one for the last look at settled films. What the fast attempt does not solve is
solved alone.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy import int64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inner
from babbitt.reynolds._lanes import LANES, put
from babbitt.reynolds._structs import Array, Bearing, Film, Grid
from babbitt.reynolds.lands._equilibrium import (
    COARSE,
    CONTACT,
    CONVERGED,
    CROWD,
    CYCLING,
    LONGEST,
    MODERATE_LOAD,
    NO_FILM,
    THINNEST,
    TOO_MANY_STEPS,
    damped_step,
    find_equilibrium,
)
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._grids import (
    graded_lines,
    inlet_flux,
    intervals_of,
    new_film,
    new_grid,
    smallest_gap,
    uniform_lines,
)
from babbitt.reynolds.lands._integrals import integrate
from babbitt.reynolds.lands._lane_films import LaneLines, lane_evaluate, lane_film, lane_gap, lane_grid, lane_lines

HEAD = 6  # x, y, status, steps, smallest gap, highest pressure; the result vector follows
RUNNING, EMPTY = -1, -2  # further states of a lane


class Pool(NamedTuple):
    """Lanes on grids of one size; what has no shape has one number for every lane."""

    grid: Grid
    edges: Array  # flux into a line that ruptures at its start, and its derivatives, (lands, 3, LANES)
    film: Film
    lines: LaneLines
    result: Array  # (10, LANES)
    changed: Array
    kappa: Array
    load_x: Array
    load_y: Array
    x: Array
    y: Array
    gap: Array
    move_x: Array
    move_y: Array
    new_gap: Array
    share: Array  # of the load
    last_gap: Array  # on the grid before
    step_time: Array
    last_size: Array
    bearing: NDArray[int64]
    status: NDArray[int64]
    steps: NDArray[int64]  # on this grid
    total: NDArray[int64]  # on those before
    looks: NDArray[int64]  # at the film of this step
    calm: NDArray[int64]
    held: NDArray[int64]


@inner
def new_pool(lands, n, m):
    """Pool of empty lanes."""
    return Pool(
        lane_grid(lands, n, m), np.zeros((lands, 3, LANES)), lane_film(n), lane_lines(n, m), np.zeros((RESULT_SIZE, LANES)),
        np.zeros(LANES), np.ones(LANES), np.zeros(LANES), np.zeros(LANES), np.zeros(LANES), np.zeros(LANES),
        np.ones(LANES), np.zeros(LANES), np.zeros(LANES), np.ones(LANES), np.ones(LANES), np.zeros(LANES),
        np.zeros(LANES), np.zeros(LANES), np.zeros(LANES, np.int64), np.full(LANES, EMPTY), np.zeros(LANES, np.int64),
        np.zeros(LANES, np.int64), np.zeros(LANES, np.int64), np.zeros(LANES, np.int64), np.zeros(LANES, np.int64),
    )  # fmt: skip


@inner
def lane_with(pool, status):
    """A lane in this state, or -1."""
    for lane in range(LANES):
        if pool.status[lane] == status:
            return lane
    return -1


@inner
def insert(bearing, grid, film, pool, lane):
    """Set a lane to the lines of a bearing."""
    own = pool.grid
    for k in range(grid.step.shape[0]):
        for i in range(grid.step.shape[1]):
            own.step[k, i, lane] = grid.step[k, i]
            own.cos_a[k, i, lane], own.sin_a[k, i, lane] = grid.cos_a[k, i], grid.sin_a[k, i]
            own.cos_b[k, i, lane], own.sin_b[k, i, lane] = grid.cos_b[k, i], grid.sin_b[k, i]
            own.gap_a[k, i, lane], own.gap_b[k, i, lane] = grid.gap_a[k, i], grid.gap_b[k, i]
        for i in range(grid.theta.shape[1]):
            own.theta[k, i, lane] = grid.theta[k, i]
            own.weight_x[k, i, lane], own.weight_y[k, i, lane] = grid.weight_x[k, i], grid.weight_y[k, i]
            for j in range(grid.wet.shape[2]):
                own.wet[k, i, j, lane] = 1.0 if grid.wet[k, i, j] else 0.0
                own.value[k, i, j, lane] = grid.value[k, i, j]
        inlet_flux(bearing, grid, k, 0.0, 0.0, film)
        for row in range(3):
            pool.edges[k, row, lane] = film.inlet[row]


@inner
def extract(pool, lane, grid):
    """Lines of one lane."""
    own = pool.grid
    for k in range(grid.step.shape[0]):
        for i in range(grid.step.shape[1]):
            grid.step[k, i] = own.step[k, i, lane]
            grid.cos_a[k, i], grid.sin_a[k, i] = own.cos_a[k, i, lane], own.sin_a[k, i, lane]
            grid.cos_b[k, i], grid.sin_b[k, i] = own.cos_b[k, i, lane], own.sin_b[k, i, lane]
            grid.gap_a[k, i], grid.gap_b[k, i] = own.gap_a[k, i, lane], own.gap_b[k, i, lane]
        for i in range(grid.theta.shape[1]):
            grid.theta[k, i] = own.theta[k, i, lane]
            grid.weight_x[k, i], grid.weight_y[k, i] = own.weight_x[k, i, lane], own.weight_y[k, i, lane]
            for j in range(grid.wet.shape[2]):
                grid.wet[k, i, j] = own.wet[k, i, j, lane] > 0.5
                grid.value[k, i, j] = own.value[k, i, j, lane]


@inner
def begin(pool, lane, number, kappa, load_x, load_y, x, y, gap):
    """Start the search of a lane whose lines are set."""
    pool.bearing[lane], pool.kappa[lane] = number, kappa
    pool.load_x[lane], pool.load_y[lane] = load_x, load_y
    pool.x[lane], pool.y[lane], pool.gap[lane] = x, y, gap
    pool.step_time[lane], pool.last_size[lane] = 0.0, 0.0
    pool.steps[lane], pool.looks[lane], pool.calm[lane], pool.held[lane] = 0, 0, 0, 0
    pool.status[lane] = RUNNING if gap > 0.0 else NO_FILM


@inner
def judge(pool, lane, conserving, tolerance, max_steps, result):
    """What ``settle`` does of one bearing between an evaluation and the next; True where the journal is to move."""
    wet = pool.grid.wet.size // LANES
    calm = pool.calm[lane]
    changed = pool.changed[lane]
    pool.looks[lane] += 1
    waits = pool.grid.wet.shape[1] if calm > 0 and not conserving else 1
    if changed > 0 and pool.looks[lane] < waits:
        return False
    pool.looks[lane] = 0
    pool.steps[lane] += 1
    step = pool.steps[lane]
    held = changed * CROWD > wet and pool.held[lane] == 0
    pool.held[lane] = 1 if held else 0
    if held:
        if step >= max_steps:
            pool.status[lane] = TOO_MANY_STEPS
        return False
    load_x, load_y = pool.share[lane] * pool.load_x[lane], pool.share[lane] * pool.load_y[lane]
    load = math.hypot(load_x, load_y)
    for row in range(RESULT_SIZE):
        result[row] = pool.result[row, lane]
    rx, ry = result[0] + load_x, result[1] + load_y
    size = math.hypot(rx, ry)
    if not size < np.inf:
        pool.status[lane] = NO_FILM
        return False
    if size <= tolerance * load + 1e-13 or (step > CYCLING and size <= 1e-4 * load):
        pool.calm[lane] = calm + 1
        if changed == 0 or calm + 1 > 4 or tolerance >= COARSE:
            pool.status[lane] = CONVERGED
            return False
    dx, dy, pool.step_time[lane] = damped_step(
        result, rx, ry, size, pool.last_size[lane], load, pool.gap[lane], pool.step_time[lane]
    )
    if not math.isfinite(dx + dy):
        pool.status[lane] = NO_FILM
        return False
    pool.last_size[lane] = size
    pool.move_x[lane], pool.move_y[lane] = dx, dy
    return True


@inner
def advance(axial, conserving, pool, tolerance, max_steps, scratch):
    """Evaluate the films of a pool once and move its journals on."""
    grid = pool.grid
    lane_evaluate(
        axial, conserving, pool.kappa, grid, pool.edges, pool.film, pool.lines, pool.x, pool.y, bool(0), pool.result,
        pool.changed,
    )  # fmt: skip
    moves = 0
    for lane in range(LANES):
        pool.move_x[lane], pool.move_y[lane] = 0.0, 0.0
        if pool.status[lane] == RUNNING and judge(pool, lane, conserving, tolerance, max_steps, scratch):
            moves += 1
    if moves == 0:
        return
    for halvings in range(61):
        for lane in range(LANES):
            scratch[lane] = pool.x[lane] + pool.move_x[lane]
            pool.changed[lane] = pool.y[lane] + pool.move_y[lane]
        put(pool.new_gap, (0,), lane_gap(grid, scratch, pool.changed))
        again = False
        for lane in range(LANES):
            if pool.move_x[lane] != 0.0 or pool.move_y[lane] != 0.0:
                if not pool.new_gap[lane] > 0.25 * pool.gap[lane] and halvings < 60:
                    pool.move_x[lane] *= 0.5
                    pool.move_y[lane] *= 0.5
                    again = True
        if not again:
            break
    for lane in range(LANES):
        if pool.move_x[lane] == 0.0 and pool.move_y[lane] == 0.0:
            continue
        if not pool.new_gap[lane] > CONTACT:
            pool.status[lane] = NO_FILM
            continue
        pool.x[lane] += pool.move_x[lane]
        pool.y[lane] += pool.move_y[lane]
        pool.gap[lane] = pool.new_gap[lane]
        if pool.steps[lane] >= max_steps:
            pool.status[lane] = TOO_MANY_STEPS


@inner
def draw_anew(bearing, pool, lane, coarse, other, film):
    """What ``approach`` does between two coarse grids; True where the lane is ready for the fine grid."""
    gap, last_gap, share = pool.gap[lane], pool.last_gap[lane], pool.share[lane]
    pool.total[lane] += pool.steps[lane]
    if pool.status[lane] != CONVERGED or max(gap, last_gap) < THINNEST or pool.total[lane] > LONGEST:
        pool.status[lane] = NO_FILM
        return False
    if share == 1.0 and (gap > 0.2 or abs(gap - last_gap) < 0.1 * gap):
        return True
    x, y = pool.x[lane], pool.y[lane]
    extract(pool, lane, coarse)
    graded_lines(bearing, coarse, x, y, other)
    if share < 1.0:
        growth = min(4.0, 1.0 / share)
        pool.share[lane] = min(1.0, share * growth)
        radius = math.hypot(x, y)
        if 0.0 < radius < 1.0:
            stretch = (1.0 - (1.0 - radius) * growth**-0.5) / radius
            if smallest_gap(other, x * stretch, y * stretch) > 0.25 * gap:
                x, y = x * stretch, y * stretch
    pool.last_gap[lane] = gap
    insert(bearing, other, film, pool, lane)
    begin(
        pool, lane, pool.bearing[lane], pool.kappa[lane], pool.load_x[lane], pool.load_y[lane], x, y,
        smallest_gap(other, x, y),
    )  # fmt: skip
    return False


@compiled
def find_equilibria(
    axial,
    lands,
    kappa,
    side_pressure,
    conserving,
    n_coarse,
    n_fine,
    load,
    tolerance,
    max_steps,
    first,
    last,
    found,
    totals,
):
    """Equilibria of bearings first..last - 1; lands (bearings, lands, columns), found (bearings, HEAD + 10).

    Pressures, flows and torques (``totals``, (bearings, lands, TOTALS)) of those that settle only.
    """
    m, count = len(axial.size), lands.shape[1]
    profiles = np.zeros((count, 0))
    scratch = np.zeros(RESULT_SIZE)
    model = Bearing(lands[first], profiles, kappa[first], 1.0, 0.0, conserving, True, 1.0)
    nc, nf = intervals_of(model, n_coarse), intervals_of(model, n_fine)
    search, settling, last_look = new_pool(count, nc, m), new_pool(count, nf, m), new_pool(count, nf, m)
    coarse, other, fine = new_grid(count, nc, m), new_grid(count, nc, m), new_grid(count, nf, m)
    film_c, film_f = new_film(nc), new_film(nf)
    pressure = np.zeros((count, nf + 1, m + 1))
    void = np.zeros_like(pressure)
    following = first
    while True:
        # settled films to the last look, and from there to the answers
        for lane in range(LANES):
            if settling.status[lane] == EMPTY or settling.status[lane] == RUNNING:
                continue
            b = settling.bearing[lane]
            if settling.status[lane] != CONVERGED or settling.gap[lane] < THINNEST:
                found[b, 2] = RUNNING
                settling.status[lane] = EMPTY
                continue
            free = lane_with(last_look, EMPTY)
            bearing = Bearing(lands[b], profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
            extract(settling, lane, fine)
            insert(bearing, fine, film_f, last_look, free)
            begin(
                last_look, free, b, kappa[b], load[b, 0], load[b, 1], settling.x[lane], settling.y[lane],
                settling.gap[lane],
            )  # fmt: skip
            found[b, 3] = settling.total[lane] + settling.steps[lane]
            settling.status[lane] = EMPTY
            if lane_with(last_look, EMPTY) < 0:
                look(axial, lands, profiles, conserving, last_look, fine, film_f, pressure, void, found, totals)
        # searches that are done to fine grids
        for lane in range(LANES):
            if search.status[lane] == EMPTY or search.status[lane] == RUNNING:
                continue
            b = search.bearing[lane]
            free = lane_with(settling, EMPTY)
            if free < 0:
                break
            bearing = Bearing(lands[b], profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
            if draw_anew(bearing, search, lane, coarse, other, film_c):
                extract(search, lane, coarse)
                x, y = search.x[lane], search.y[lane]
                graded_lines(bearing, coarse, x, y, fine)
                insert(bearing, fine, film_f, settling, free)
                settling.total[free] = search.total[lane]
                begin(settling, free, b, kappa[b], load[b, 0], load[b, 1], x, y, smallest_gap(fine, x, y))
                search.status[lane] = EMPTY
            elif search.status[lane] == NO_FILM:
                found[b, 2] = RUNNING
                search.status[lane] = EMPTY
        # new bearings to free lanes
        for lane in range(LANES):
            if search.status[lane] == EMPTY and following < last:
                b = following
                following += 1
                bearing = Bearing(lands[b], profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
                coarse.wet[:] = True
                uniform_lines(bearing, coarse)
                insert(bearing, coarse, film_c, search, lane)
                search.total[lane], search.last_gap[lane] = 0, np.inf
                search.share[lane] = min(1.0, MODERATE_LOAD / max(math.hypot(load[b, 0], load[b, 1]), 1e-300))
                begin(search, lane, b, kappa[b], load[b, 0], load[b, 1], 0.0, 0.0, smallest_gap(coarse, 0.0, 0.0))
        searching, full = lane_with(search, RUNNING) >= 0, lane_with(settling, EMPTY) < 0
        if lane_with(settling, RUNNING) >= 0 and (full or not searching):
            advance(axial, conserving, settling, tolerance, max_steps, scratch)
        elif searching:
            advance(axial, conserving, search, COARSE, max_steps, scratch)
        elif following == last and lane_with(search, NO_FILM) < 0 and lane_with(settling, NO_FILM) < 0:
            break
    look(axial, lands, profiles, conserving, last_look, fine, film_f, pressure, void, found, totals)
    for b in range(first, last):
        if found[b, 2] != RUNNING:
            continue
        bearing = Bearing(lands[b], profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
        x, y, status, steps, gap, grid = find_equilibrium(
            axial, bearing, n_coarse, n_fine, load[b, 0], load[b, 1], 0.0, 0.0, tolerance, max_steps, scratch
        )
        found[b, 0], found[b, 1], found[b, 2], found[b, 3], found[b, 4] = x, y, status, steps, gap
        found[b, HEAD:] = scratch
        if status == CONVERGED:
            integrate(axial, bearing, grid, film_f, x, y, 0.0, 0.0, pressure, void, totals[b])
            found[b, 5] = pressure.max()


@inner
def look(axial, lands, profiles, conserving, pool, fine, film, pressure, void, found, totals):
    """Coefficients freed from the steps of the grid, flows and torque of all lanes of settled films."""
    lane_evaluate(
        axial, conserving, pool.kappa, pool.grid, pool.edges, pool.film, pool.lines, pool.x, pool.y, bool(1),
        pool.result, pool.changed,
    )  # fmt: skip
    for lane in range(LANES):
        if pool.status[lane] == EMPTY:
            continue
        b = pool.bearing[lane]
        found[b, 0], found[b, 1], found[b, 2] = pool.x[lane], pool.y[lane], CONVERGED
        found[b, 4] = pool.gap[lane]
        for row in range(RESULT_SIZE):
            found[b, HEAD + row] = pool.result[row, lane]
        bearing = Bearing(lands[b], profiles, pool.kappa[lane], 1.0, 0.0, conserving, True, 1.0)
        extract(pool, lane, fine)
        integrate(axial, bearing, fine, film, pool.x[lane], pool.y[lane], 0.0, 0.0, pressure, void, totals[b])
        found[b, 5] = pressure.max()
        pool.status[lane] = EMPTY
