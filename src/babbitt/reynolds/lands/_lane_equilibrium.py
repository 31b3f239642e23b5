"""Kernels: the equilibria of many bearings, several side by side (``_lanes``).

Every lane goes through the fast attempt of ``find_equilibrium`` at its own pace: one evaluation moves all lanes of
a pool on by a step, and a lane that has settled hands over to the next pool and takes the next bearing. A pool for
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
from babbitt.reynolds._lanes import LANES, get, put
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
from babbitt.reynolds.lands._lane_films import (
    CHANGED,
    GAP,
    KAPPA,
    LAST_GAP,
    LAST_SIZE,
    LOAD_X,
    LOAD_Y,
    MOVE_X,
    MOVE_Y,
    NEW_GAP,
    NEW_X,
    NEW_Y,
    NUMBERS,
    SHARE,
    STEP_TIME,
    LaneLines,
    X,
    Y,
    lane_evaluate,
    lane_film,
    lane_gap,
    lane_grid,
    lane_lines,
)

HEAD = 6  # x, y, status, steps, smallest gap, highest pressure; the result vector follows
RUNNING, EMPTY = -1, -2  # further states of a lane


# rows of the counts of every lane: bearing, state, steps on this grid and on those before, looks at the film of
# this step, steps since the load is carried, whether the journal waits for the wet set
BEARING, STATE, STEPS, TOTAL, LOOKS, CALM, HELD, COUNTS = range(8)


class Pool(NamedTuple):
    """Lanes on grids of one size. Functions that run once a lane take its arrays: the tuple would cost more."""

    grid: Grid
    edges: Array  # flux into a line that ruptures at its start, and its derivatives, (lands, 3, LANES)
    film: Film
    lines: LaneLines
    result: Array  # (10, LANES)
    numbers: Array  # (NUMBERS, LANES)
    counts: NDArray[int64]  # (COUNTS, LANES)


@inner
def new_pool(lands, n, m):
    """Pool of empty lanes."""
    numbers, counts = np.ones((NUMBERS, LANES)), np.zeros((COUNTS, LANES), np.int64)
    numbers[X : Y + 1] = 0.0
    counts[STATE] = EMPTY
    edges, result = np.zeros((lands, 3, LANES)), np.zeros((RESULT_SIZE, LANES))
    return Pool(lane_grid(lands, n, m), edges, lane_film(n), lane_lines(n, m), result, numbers, counts)


@inner
def lane_with(counts, state):
    """A lane in this state, or -1."""
    for lane in range(LANES):
        if counts[STATE, lane] == state:
            return lane
    return -1


@inner
def insert(bearing, grid, film, own, edges, lane):
    """Set a lane to the lines of a bearing."""
    step, cos_a, cos_b, sin_a, sin_b = own.step, own.cos_a, own.cos_b, own.sin_a, own.sin_b
    gap_a, gap_b, theta, weight_x, weight_y = own.gap_a, own.gap_b, own.theta, own.weight_x, own.weight_y
    wet, value = own.wet, own.value
    for k in range(step.shape[0]):
        for i in range(step.shape[1]):
            step[k, i, lane] = grid.step[k, i]
            cos_a[k, i, lane], sin_a[k, i, lane] = grid.cos_a[k, i], grid.sin_a[k, i]
            cos_b[k, i, lane], sin_b[k, i, lane] = grid.cos_b[k, i], grid.sin_b[k, i]
            gap_a[k, i, lane], gap_b[k, i, lane] = grid.gap_a[k, i], grid.gap_b[k, i]
        for i in range(theta.shape[1]):
            theta[k, i, lane] = grid.theta[k, i]
            weight_x[k, i, lane], weight_y[k, i, lane] = grid.weight_x[k, i], grid.weight_y[k, i]
            for j in range(wet.shape[2]):
                wet[k, i, j, lane] = 1.0 if grid.wet[k, i, j] else 0.0
                value[k, i, j, lane] = grid.value[k, i, j]
        inlet_flux(bearing, grid, k, 0.0, 0.0, film)
        for row in range(3):
            edges[k, row, lane] = film.inlet[row]


@inner
def extract(own, lane, grid):
    """Lines of one lane."""
    step, cos_a, cos_b, sin_a, sin_b = own.step, own.cos_a, own.cos_b, own.sin_a, own.sin_b
    gap_a, gap_b, theta, weight_x, weight_y = own.gap_a, own.gap_b, own.theta, own.weight_x, own.weight_y
    wet, value = own.wet, own.value
    for k in range(step.shape[0]):
        for i in range(step.shape[1]):
            grid.step[k, i] = step[k, i, lane]
            grid.cos_a[k, i], grid.sin_a[k, i] = cos_a[k, i, lane], sin_a[k, i, lane]
            grid.cos_b[k, i], grid.sin_b[k, i] = cos_b[k, i, lane], sin_b[k, i, lane]
            grid.gap_a[k, i], grid.gap_b[k, i] = gap_a[k, i, lane], gap_b[k, i, lane]
        for i in range(theta.shape[1]):
            grid.theta[k, i] = theta[k, i, lane]
            grid.weight_x[k, i], grid.weight_y[k, i] = weight_x[k, i, lane], weight_y[k, i, lane]
            for j in range(wet.shape[2]):
                grid.wet[k, i, j] = wet[k, i, j, lane] > 0.5
                grid.value[k, i, j] = value[k, i, j, lane]


@inner
def begin(numbers, counts, lane, x, y, gap):
    """Start the search of a lane whose lines are set."""
    numbers[X, lane], numbers[Y, lane], numbers[GAP, lane] = x, y, gap
    numbers[STEP_TIME, lane], numbers[LAST_SIZE, lane] = 0.0, 0.0
    counts[STEPS, lane], counts[LOOKS, lane], counts[CALM, lane], counts[HELD, lane] = 0, 0, 0, 0
    counts[STATE, lane] = RUNNING if gap > 0.0 else NO_FILM


@inner
def judge(results, numbers, counts, lane, nodes, most_looks, tolerance, max_steps, result):
    """What ``settle`` does of one bearing between an evaluation and the next; True where the journal is to move.

    ``nodes`` and ``most_looks``: of the grid of the lane, and at the film of a calm step.
    """
    changed = numbers[CHANGED, lane]
    counts[LOOKS, lane] += 1
    if changed > 0 and counts[CALM, lane] > 0 and counts[LOOKS, lane] < most_looks:
        return False
    counts[LOOKS, lane] = 0
    counts[STEPS, lane] += 1
    step = counts[STEPS, lane]
    held = changed * CROWD > nodes and counts[HELD, lane] == 0
    counts[HELD, lane] = 1 if held else 0
    if held:
        if step >= max_steps:
            counts[STATE, lane] = TOO_MANY_STEPS
        return False
    load_x, load_y = numbers[SHARE, lane] * numbers[LOAD_X, lane], numbers[SHARE, lane] * numbers[LOAD_Y, lane]
    load = math.hypot(load_x, load_y)
    for row in range(RESULT_SIZE):
        result[row] = results[row, lane]
    rx, ry = result[0] + load_x, result[1] + load_y
    size = math.hypot(rx, ry)
    if not size < np.inf:
        counts[STATE, lane] = NO_FILM
        return False
    if size <= tolerance * load + 1e-13 or (step > CYCLING and size <= 1e-4 * load):
        counts[CALM, lane] += 1
        if changed == 0 or counts[CALM, lane] > 4 or tolerance >= COARSE:
            counts[STATE, lane] = CONVERGED
            return False
    dx, dy, numbers[STEP_TIME, lane] = damped_step(
        result, rx, ry, size, numbers[LAST_SIZE, lane], load, numbers[GAP, lane], numbers[STEP_TIME, lane]
    )
    if not math.isfinite(dx + dy):
        counts[STATE, lane] = NO_FILM
        return False
    numbers[LAST_SIZE, lane] = size
    numbers[MOVE_X, lane], numbers[MOVE_Y, lane] = dx, dy
    return True


@inner
def advance(axial, conserving, pool, tolerance, max_steps, scratch):
    """Evaluate the films of a pool once and move its journals on."""
    grid, numbers, counts, result = pool.grid, pool.numbers, pool.counts, pool.result
    nodes, most_looks = grid.wet.size // LANES, 1 if conserving else grid.wet.shape[1]
    lane_evaluate(axial, conserving, grid, pool.edges, pool.film, pool.lines, numbers, bool(0), result)
    moves = 0
    for lane in range(LANES):
        numbers[MOVE_X, lane], numbers[MOVE_Y, lane] = 0.0, 0.0
        if counts[STATE, lane] == RUNNING and judge(
            result, numbers, counts, lane, nodes, most_looks, tolerance, max_steps, scratch
        ):
            moves += 1
    if moves == 0:
        return
    for halvings in range(61):
        new_x, new_y = get(numbers, (X,)) + get(numbers, (MOVE_X,)), get(numbers, (Y,)) + get(numbers, (MOVE_Y,))
        put(numbers, (NEW_X,), new_x)
        put(numbers, (NEW_Y,), new_y)
        put(numbers, (NEW_GAP,), lane_gap(grid, new_x, new_y))
        again = False
        for lane in range(LANES):
            moving = numbers[MOVE_X, lane] != 0.0 or numbers[MOVE_Y, lane] != 0.0
            if moving and not numbers[NEW_GAP, lane] > 0.25 * numbers[GAP, lane] and halvings < 60:
                numbers[MOVE_X, lane] *= 0.5
                numbers[MOVE_Y, lane] *= 0.5
                again = True
        if not again:
            break
    for lane in range(LANES):
        if numbers[MOVE_X, lane] == 0.0 and numbers[MOVE_Y, lane] == 0.0:
            continue
        if not numbers[NEW_GAP, lane] > CONTACT:
            counts[STATE, lane] = NO_FILM
            continue
        numbers[X, lane], numbers[Y, lane] = numbers[NEW_X, lane], numbers[NEW_Y, lane]
        numbers[GAP, lane] = numbers[NEW_GAP, lane]
        if counts[STEPS, lane] >= max_steps:
            counts[STATE, lane] = TOO_MANY_STEPS


@inner
def draw_anew(bearing, own, edges, numbers, counts, lane, coarse, other, film):
    """What ``approach`` does between two coarse grids; True where the lane is ready for the fine grid."""
    gap, last_gap, share = numbers[GAP, lane], numbers[LAST_GAP, lane], numbers[SHARE, lane]
    counts[TOTAL, lane] += counts[STEPS, lane]
    if counts[STATE, lane] != CONVERGED or max(gap, last_gap) < THINNEST or counts[TOTAL, lane] > LONGEST:
        counts[STATE, lane] = NO_FILM
        return False
    x, y = numbers[X, lane], numbers[Y, lane]
    extract(own, lane, coarse)
    if share == 1.0 and (gap > 0.2 or abs(gap - last_gap) < 0.1 * gap):
        return True
    graded_lines(bearing, coarse, x, y, other)
    if share < 1.0:
        growth = min(4.0, 1.0 / share)
        numbers[SHARE, lane] = min(1.0, share * growth)
        radius = math.hypot(x, y)
        if 0.0 < radius < 1.0:
            stretch = (1.0 - (1.0 - radius) * growth**-0.5) / radius
            if smallest_gap(other, x * stretch, y * stretch) > 0.25 * gap:
                x, y = x * stretch, y * stretch
    numbers[LAST_GAP, lane] = gap
    insert(bearing, other, film, own, edges, lane)
    begin(numbers, counts, lane, x, y, smallest_gap(other, x, y))
    return False


@inner
def assign(numbers, counts, lane, number, kappa, load_x, load_y, share, last_gap, total):
    """Give a lane a bearing."""
    counts[BEARING, lane], counts[TOTAL, lane] = number, total
    numbers[KAPPA, lane], numbers[LOAD_X, lane], numbers[LOAD_Y, lane] = kappa, load_x, load_y
    numbers[SHARE, lane], numbers[LAST_GAP, lane] = share, last_gap


@compiled
def find_equilibria(
    axial,
    lands,
    kappa,
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
    """Equilibria of bearings first..last - 1 that share ``lands``, (lands, columns); found (bearings, HEAD + 10).

    Pressures, flows and torques (``totals``, (bearings, lands, TOTALS)) of those that settle only.
    """
    m, count = len(axial.size), lands.shape[0]
    profiles = np.zeros((count, 0))
    scratch = np.zeros(RESULT_SIZE)
    model = Bearing(lands, profiles, kappa[first], 1.0, 0.0, conserving, True, 1.0)
    nc, nf = intervals_of(model, n_coarse), intervals_of(model, n_fine)
    search, settling, last_look = new_pool(count, nc, m), new_pool(count, nf, m), new_pool(count, nf, m)
    coarse, other, fine = new_grid(count, nc, m), new_grid(count, nc, m), new_grid(count, nf, m)
    film_c, film_f = new_film(nc), new_film(nf)
    start = new_grid(count, nc, m)
    uniform_lines(model, start)
    start_gap = smallest_gap(start, 0.0, 0.0)
    pressure = np.zeros((count, nf + 1, m + 1))
    void = np.zeros_like(pressure)
    following = first
    while True:
        # settled films to the last look, and from there to the answers
        for lane in range(LANES):
            if settling.counts[STATE, lane] == EMPTY or settling.counts[STATE, lane] == RUNNING:
                continue
            b = settling.counts[BEARING, lane]
            if settling.counts[STATE, lane] != CONVERGED or settling.numbers[GAP, lane] < THINNEST:
                found[b, 2] = RUNNING
                settling.counts[STATE, lane] = EMPTY
                continue
            free = lane_with(last_look.counts, EMPTY)
            bearing = Bearing(lands, profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
            extract(settling.grid, lane, fine)
            insert(bearing, fine, film_f, last_look.grid, last_look.edges, free)
            assign(last_look.numbers, last_look.counts, free, b, kappa[b], load[b, 0], load[b, 1], 1.0, np.inf, 0)
            x, y = settling.numbers[X, lane], settling.numbers[Y, lane]
            begin(last_look.numbers, last_look.counts, free, x, y, settling.numbers[GAP, lane])
            found[b, 3] = settling.counts[TOTAL, lane] + settling.counts[STEPS, lane]
            settling.counts[STATE, lane] = EMPTY
            if lane_with(last_look.counts, EMPTY) < 0:
                look(axial, lands, profiles, conserving, last_look, fine, film_f, pressure, void, found, totals)
        # searches that are done to fine grids
        for lane in range(LANES):
            if search.counts[STATE, lane] == EMPTY or search.counts[STATE, lane] == RUNNING:
                continue
            b = search.counts[BEARING, lane]
            free = lane_with(settling.counts, EMPTY)
            if free < 0:
                break
            bearing = Bearing(lands, profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
            if draw_anew(
                bearing, search.grid, search.edges, search.numbers, search.counts, lane, coarse, other, film_c
            ):
                x, y = search.numbers[X, lane], search.numbers[Y, lane]
                graded_lines(bearing, coarse, x, y, fine)
                insert(bearing, fine, film_f, settling.grid, settling.edges, free)
                assign(
                    settling.numbers, settling.counts, free, b, kappa[b], load[b, 0], load[b, 1], 1.0, np.inf,
                    search.counts[TOTAL, lane],
                )  # fmt: skip
                begin(settling.numbers, settling.counts, free, x, y, smallest_gap(fine, x, y))
                search.counts[STATE, lane] = EMPTY
            elif search.counts[STATE, lane] == NO_FILM:
                found[b, 2] = RUNNING
                search.counts[STATE, lane] = EMPTY
        # new bearings to free lanes
        for lane in range(LANES):
            if search.counts[STATE, lane] == EMPTY and following < last:
                b = following
                following += 1
                insert(model, start, film_c, search.grid, search.edges, lane)
                share = min(1.0, MODERATE_LOAD / max(math.hypot(load[b, 0], load[b, 1]), 1e-300))
                assign(search.numbers, search.counts, lane, b, kappa[b], load[b, 0], load[b, 1], share, np.inf, 0)
                begin(search.numbers, search.counts, lane, 0.0, 0.0, start_gap)
        searching, full = lane_with(search.counts, RUNNING) >= 0, lane_with(settling.counts, EMPTY) < 0
        if lane_with(settling.counts, RUNNING) >= 0 and (full or not searching):
            advance(axial, conserving, settling, tolerance, max_steps, scratch)
        elif searching:
            advance(axial, conserving, search, COARSE, max_steps, scratch)
        elif (
            following == last and lane_with(search.counts, NO_FILM) < 0 and lane_with(settling.counts, NO_FILM) < 0
        ):
            break
    look(axial, lands, profiles, conserving, last_look, fine, film_f, pressure, void, found, totals)
    for b in range(first, last):
        if found[b, 2] != RUNNING:
            continue
        bearing = Bearing(lands, profiles, kappa[b], 1.0, 0.0, conserving, True, 1.0)
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
    numbers, counts, result = pool.numbers, pool.counts, pool.result
    lane_evaluate(axial, conserving, pool.grid, pool.edges, pool.film, pool.lines, numbers, bool(1), result)
    for lane in range(LANES):
        if counts[STATE, lane] == EMPTY:
            continue
        b, x, y = counts[BEARING, lane], numbers[X, lane], numbers[Y, lane]
        found[b, 0], found[b, 1], found[b, 2], found[b, 4] = x, y, CONVERGED, numbers[GAP, lane]
        for row in range(RESULT_SIZE):
            found[b, HEAD + row] = result[row, lane]
        bearing = Bearing(lands, profiles, numbers[KAPPA, lane], 1.0, 0.0, conserving, True, 1.0)
        extract(pool.grid, lane, fine)
        integrate(axial, bearing, fine, film, x, y, 0.0, 0.0, pressure, void, totals[b])
        found[b, 5] = pressure.max()
        counts[STATE, lane] = EMPTY
