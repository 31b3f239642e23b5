"""Kernels: the journal among pads.

It moves in a convex potential (every pad load grows with the way towards its pivot), by Newton with the condensed
stiffnesses and a search along the step for the place where the force no longer opposes it.
"""

from __future__ import annotations

import math

from babbitt.reynolds._compiling import compiled, inlined
from babbitt.reynolds.lands._grids import new_film, new_lines
from babbitt.reynolds.tilting_pads._limits import changed_status, pad_near_limit, settle_at_limit
from babbitt.reynolds.tilting_pads._place import (
    TIGHT,
    all_found,
    any_pad_is,
    copy_status,
    drop_limits,
    longest_step,
    place_all,
)
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, MOST_FILMS, pad_grid

CONVERGED, TOO_MANY_STEPS, CLOSED, STUCK, LIMIT, WORK, TOUCH = 0, 1, 2, 3, 4, 5, 6

LOOSE = 3e-2  # moment over the lever of the pivot over the load, on the way
OVERSHOOT = 0.7  # share of the driving force that may oppose a step behind it
UNEVEN = 0.1  # the same where a pad gains or loses its load on the way
INDIFFERENT = 1e-6  # of the trace: stiffness of a direction that no pad stiffens
MOST_BARRED = 12  # steps on end that an edge, which a flexure presses on the journal, cuts short
MOST_HELD = 20  # times that a pad is held at its limit
SHORTEST = 1e-12  # step of the journal at which a search along it is stuck


@inlined
def allowed_moment(places, residual):
    """Moment over load of a pad at which its load, corrected to first order, errs by less than the residual."""
    loads = 1e-300
    for k in range(places.force.shape[0]):
        loads += abs(places.force[k, 0])
    return min(max(math.sqrt(0.003 * residual / loads), TIGHT), LOOSE)


@compiled
def find_pads(axial, pads, intervals, load_x, load_y, x, y, tolerance, max_steps, places, total):
    """Journal and pads in equilibrium: x, y, status, steps, whether a direction is indifferent, and the grid.

    ``total`` gets the force of the films and the condensed stiffness (F 2, K 4).
    """
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    load = math.hypot(load_x, load_y)
    floor = tolerance * load + 1e-13
    tilts, tight, held, barred = LOOSE, False, 0, 0
    statuses = places.status.copy()
    if not place_all(axial, pads, grid, film, lines, x, y, tilts, places, total):
        return x, y, CLOSED, 0, False, grid
    status, steps = TOO_MANY_STEPS, 0
    while steps < max_steps and places.films[0] <= MOST_FILMS:
        steps += 1
        rx, ry = total[0] + load_x, total[1] + load_y
        size = math.hypot(rx, ry)
        if size <= floor:
            if tilts == TIGHT:
                status = settled_status(places)
                break
            tilts = TIGHT
            place_all(axial, pads, grid, film, lines, x, y, tilts, places, total)
            continue
        tilts = TIGHT if tight else allowed_moment(places, size)
        dx, dy = journal_step(total, rx, ry)
        share = longest_step(pads, places, dx, dy)
        drive = rx * dx + ry * dy
        copy_status(places, statuses)
        changed, closed = -1, False
        while True:
            new_x, new_y = x + share * dx, y + share * dy
            is_open = place_all(axial, pads, grid, film, lines, new_x, new_y, tilts, places, total)
            opposed = -((total[0] + load_x) * dx + (total[1] + load_y) * dy)
            changed = changed_status(pads, places.status, statuses, -1)
            closed = closed or not is_open
            if is_open and opposed <= (OVERSHOOT if changed < 0 else UNEVEN) * drive:
                break
            if share < 0.1 and not tight:  # loose tilts may hide what the force does
                tight, tilts = True, TIGHT
                new_x, new_y = x, y
                place_all(axial, pads, grid, film, lines, x, y, tilts, places, total)
                break
            if share * math.hypot(dx, dy) < SHORTEST:
                break
            share *= min(max(drive / (drive + opposed), 0.1), 0.7) if is_open else 0.5
        x, y = new_x, new_y
        barred = barred + 1 if closed else 0
        if barred > MOST_BARRED:
            status = TOUCH
            break
        if share * math.hypot(dx, dy) >= SHORTEST:
            continue
        held += 1
        if changed < 0:
            changed = pad_near_limit(axial, pads, grid, film, lines, x, y, places)
        if changed < 0 or held > MOST_HELD:
            status = STUCK
            break
        x, y, limit = settle_at_limit(
            axial, pads, grid, film, lines, changed, load_x, load_y, x, y, 0.1 * floor, places, total
        )
        if limit:
            status = LIMIT
            break
    if status in (STUCK, TOO_MANY_STEPS) and places.films[0] > MOST_FILMS:
        status = WORK
    indifferent = is_indifferent(total)
    drop_limits(pads, places, total)
    return x, y, status, steps, indifferent, grid


@inlined
def settled_status(places):
    """How a search ended whose force vanishes."""
    if not all_found(places):
        return STUCK
    return LIMIT if any_pad_is(places, AT_LIMIT) else CONVERGED


@inlined
def is_indifferent(total):
    """Whether no pad stiffens one of the directions of the journal."""
    trace = total[2] + total[5]
    return total[2] * total[5] - total[3] * total[4] <= INDIFFERENT * trace * trace


@inlined
def journal_step(total, rx, ry):
    """Newton step under a residual force, or one along it where no pad carries or Newton would lead against it."""
    kxx, kxy, kyx, kyy = total[2], total[3], total[4], total[5]
    soft = INDIFFERENT * (kxx + kyy)
    det = (kxx + soft) * (kyy + soft) - kxy * kyx
    if soft > 0.0 and det > 0.0:
        dx, dy = ((kyy + soft) * rx - kxy * ry) / det, ((kxx + soft) * ry - kyx * rx) / det
        if rx * dx + ry * dy > 0.0:
            return dx, dy
    size = math.hypot(rx, ry)
    return 0.5 * rx / size, 0.5 * ry / size
