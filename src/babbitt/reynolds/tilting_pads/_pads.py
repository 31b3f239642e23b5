"""Kernels: the journal among pads.

It moves in a convex potential (every pad load grows with the way towards its pivot), by Newton with the condensed
stiffnesses and a search along the step for the place where the force no longer opposes it.
"""

from __future__ import annotations

import math

from babbitt.reynolds._compiling import compiled, inlined
from babbitt.reynolds.lands._grids import new_film, new_lines
from babbitt.reynolds.tilting_pads._limits import (
    NEAR_LIMIT,
    changed_status,
    hold_at_limit,
    needs_at_limit,
    pad_near_limit,
)
from babbitt.reynolds.tilting_pads._place import TIGHT, all_found, longest_step, place_all
from babbitt.reynolds.tilting_pads._tilt import pad_grid

CONVERGED, TOO_MANY_STEPS, CLOSED, STUCK, LIMIT = 0, 1, 2, 3, 4

LOOSE = 3e-2  # moment over the lever of the pivot over the load, on the way
OVERSHOOT = 0.7  # share of the driving force that may oppose a step behind it
UNEVEN = 0.1  # the same where a pad gains or loses its load on the way
INDIFFERENT = 1e-6  # of the trace: stiffness of a direction that no pad stiffens
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

    ``total`` gets the force of the films and the condensed stiffness (F 2, K 4), and of two pads at their limits
    number, what it would have to carry and what it carries at least (2 x 3; -1 where there is none).
    """
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    load = math.hypot(load_x, load_y)
    floor = tolerance * load + 1e-13
    tilts, tight, held = LOOSE, False, 0
    statuses = places.status.copy()
    total[6] = -1.0
    if not place_all(axial, pads, grid, film, lines, x, y, tilts, places, total):
        return x, y, CLOSED, 0, False, grid
    status, indifferent, steps = TOO_MANY_STEPS, False, 0
    while steps < max_steps:
        steps += 1
        rx, ry = total[0] + load_x, total[1] + load_y
        size = math.hypot(rx, ry)
        if size <= floor:
            if tilts == TIGHT:
                status = CONVERGED if all_found(places) else STUCK
                break
            tilts = TIGHT
            place_all(axial, pads, grid, film, lines, x, y, tilts, places, total)
            continue
        tilts = TIGHT if tight else allowed_moment(places, size)
        dx, dy, indifferent = journal_step(total, rx, ry)
        share = longest_step(pads, places, dx, dy)
        drive = rx * dx + ry * dy
        statuses[:] = places.status
        changed = -1
        while True:
            new_x, new_y = x + share * dx, y + share * dy
            is_open = place_all(axial, pads, grid, film, lines, new_x, new_y, tilts, places, total)
            opposed = -((total[0] + load_x) * dx + (total[1] + load_y) * dy)
            changed = changed_status(places.status, statuses, -1)
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
        if share * math.hypot(dx, dy) >= SHORTEST:
            continue
        held += 1
        if changed < 0:
            changed = pad_near_limit(axial, pads, grid, film, lines, x, y, places)
        if changed < 0 or held > MOST_HELD:
            status = STUCK
            break
        c, s = pads.cosine[changed], pads.sine[changed]
        x, y, second = hold_at_limit(
            axial, pads, grid, film, lines, changed, load_x, load_y, x + NEAR_LIMIT * c, y + NEAR_LIMIT * s,
            0.1 * floor, places, total,
        )  # fmt: skip
        x, y = needs_at_limit(axial, pads, grid, film, lines, changed, second, load_x, load_y, x, y, places, total)
        if 0.0 < total[7] < total[8] and (second < 0 or 0.0 < total[10] < total[11]):
            status = LIMIT
            break
        total[6] = -1.0
        place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    return x, y, status, steps, indifferent, grid


@inlined
def journal_step(total, rx, ry):
    """Newton step under a residual force, and whether no pad stiffens one of its directions."""
    kxx, kxy, kyx, kyy = total[2], total[3], total[4], total[5]
    trace = kxx + kyy
    soft = INDIFFERENT * trace
    indifferent = kxx * kyy - kxy * kyx <= soft * trace
    det = (kxx + soft) * (kyy + soft) - kxy * kyx
    if trace > 0.0 and det > 0.0:
        return ((kyy + soft) * rx - kxy * ry) / det, ((kxx + soft) * ry - kyx * rx) / det, indifferent
    size = math.hypot(rx, ry)  # no pad carries: towards those that should
    return 0.5 * rx / size, 0.5 * ry / size, True
