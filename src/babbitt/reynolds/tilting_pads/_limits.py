"""Kernels: pads on rigid pivots at the limit of what they can carry.

A pad whose pivot stands behind the middle unloads through a fold: at its limit it carries a least load or nothing.
(On an elastic pivot the push does not jump: ``_place``.)
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import inlined, inner, spliced
from babbitt.reynolds.tilting_pads._pivot_curve import is_elastic
from babbitt.reynolds.tilting_pads._place import TIGHT, all_found, copy_status, longest_step, place_all, place_pad
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, LOADED, NOT_FOUND

NEAR_LIMIT = 1e-8  # of the clearance: where a pad at its limit is taken to carry
ALONG_LIMIT = 1e-9  # of the clearance: where a second pad gains or loses its load, along one at its limit
MOST_ALONG = 60  # steps along a pad at its limit


@inlined
def has_jumped(pads, k, before, behind):
    """Whether pad k carries in one of two states only, both found, and its push jumps between them."""
    if before == NOT_FOUND or behind == NOT_FOUND or is_elastic(pads.curves[k], pads.displacements[k]):
        return False
    return (before == LOADED) != (behind == LOADED)


@inlined
def changed_status(pads, before, behind, but):
    """First pad, ``but`` one, that gains or loses its load between two states, or -1."""
    for k in range(before.size):
        if k != but and has_jumped(pads, k, before[k], behind[k]):
            return k
    return -1


@spliced
def hold_at_limit(axial, pads, grid, film, lines, k, load_x, load_y, x, y, floor, places, total):
    """Journal that keeps pad k at its limit, in equilibrium along it: x, y, and a second pad at its limit or -1.

    At the limit a pad carries what it can or nothing. Along tau the others decide, where a second one may gain or
    lose its load, too; that minimises the same convex potential on its edge. ``x``, ``y`` is where pad k just
    carries.
    """
    c, s = pads.cosine[k], pads.sine[k]
    at, left, right = 0.0, -np.inf, np.inf
    before, behind = places.status.copy(), places.status.copy()
    for _ in range(MOST_ALONG):
        place_all(axial, pads, grid, film, lines, x - s * at, y + c * at, TIGHT, places, total)
        along = c * (total[1] + load_y) - s * (total[0] + load_x)
        stiff = total[2] * s * s - (total[3] + total[4]) * c * s + total[5] * c * c
        if abs(along) <= floor:
            break
        if along > 0.0:
            left = at
            copy_status(places, before)
        else:
            right = at
            copy_status(places, behind)
        if right - left < ALONG_LIMIT:
            return x - s * at, y + c * at, changed_status(pads, before, behind, k)
        step = along / stiff if stiff > 0.0 else math.copysign(0.1, along)
        step *= longest_step(pads, places, -s * step, c * step)
        new = at + step
        if not left < new < right:
            new = 0.5 * (left + right)
        at = new
    return x - s * at, y + c * at, -1


@inner
def load_at_limit(axial, pads, grid, film, lines, k, x, y, places):
    """Load of pad k at its limit, for a journal ``NEAR_LIMIT`` of it: it grows with the root of the distance."""
    near = -places.force[k, 0]
    way = 3.0 * NEAR_LIMIT
    place_pad(axial, pads, grid, k, film, lines, x + way * pads.cosine[k], y + way * pads.sine[k], TIGHT, places)
    far = -places.force[k, 0]
    place_pad(axial, pads, grid, k, film, lines, x, y, TIGHT, places)
    return max(2.0 * near - far, 0.0)


@inlined
def way_from_limit(need, near, limit):
    """How far to move from ``NEAR_LIMIT`` of a limit for the load that a pad needs."""
    if need <= limit:
        return -2.0 * NEAR_LIMIT
    return (min((need - limit) / max(near - limit, 1e-300), 10.0) ** 2 - 1.0) * NEAR_LIMIT


@spliced
def needs_at_limit(axial, pads, grid, film, lines, first, second, load_x, load_y, x, y, places, total):
    """What one or two pads at their limits would have to carry, and what they carry at least, into ``places``.

    Returns a place beside the limits where the pads carry what they should, if they can.
    """
    c, s = pads.cosine[first], pads.sine[first]
    if second < 0:
        place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
        near = -places.force[first, 0]
        places.need[first] = (total[0] + load_x) * c + (total[1] + load_y) * s + near
        places.least[first] = load_at_limit(axial, pads, grid, film, lines, first, x, y, places)
        way = way_from_limit(places.need[first], near, places.least[first])
        return x + way * c, y + way * s
    c2, s2 = pads.cosine[second], pads.sine[second]
    share = NEAR_LIMIT / max(1.0 + c * c2 + s * s2, 1e-3)
    x, y = x + share * (c + c2), y + share * (s + s2)  # both carry
    place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    near, near_2 = -places.force[first, 0], -places.force[second, 0]
    rx = total[0] + load_x + near * c + near_2 * c2
    ry = total[1] + load_y + near * s + near_2 * s2
    det = c * s2 - s * c2
    places.need[first], places.need[second] = (rx * s2 - ry * c2) / det, (ry * c - rx * s) / det
    places.least[first] = load_at_limit(axial, pads, grid, film, lines, first, x, y, places)
    places.least[second] = load_at_limit(axial, pads, grid, film, lines, second, x, y, places)
    way = way_from_limit(places.need[first], near, places.least[first])
    way_2 = way_from_limit(places.need[second], near_2, places.least[second])
    return x + (way * s2 - way_2 * s) / det, y + (way_2 * c - way * c2) / det


@inlined
def needs_too_little(k, places):
    """Whether a pad would have to carry less than it can; so would one that is not there, -1."""
    return k < 0 or 0.0 < places.need[k] < places.least[k]


@spliced
def pad_near_limit(axial, pads, grid, film, lines, x, y, places):
    """First pad that gains or loses its load within ``NEAR_LIMIT`` of a place of the journal, or -1."""
    for k in range(pads.kappa.size):
        before = places.status[k]
        way = -NEAR_LIMIT if before == LOADED else NEAR_LIMIT
        place_pad(
            axial, pads, grid, k, film, lines, x + way * pads.cosine[k], y + way * pads.sine[k], TIGHT, places
        )
        if has_jumped(pads, k, before, places.status[k]):
            return k
    return -1


@spliced
def settle_at_limit(axial, pads, grid, film, lines, changed, load_x, load_y, x, y, floor, places, total):
    """Journal at the limit of one pad, ``changed``, or of two: x, y, and whether no equilibrium exists there.

    Pads that would have to carry less than they can are marked. Where a tilt was not found nothing is claimed.
    """
    c, s = pads.cosine[changed], pads.sine[changed]
    x, y, second = hold_at_limit(
        axial, pads, grid, film, lines, changed, load_x, load_y, x + NEAR_LIMIT * c, y + NEAR_LIMIT * s, floor,
        places, total,
    )  # fmt: skip
    x, y = needs_at_limit(axial, pads, grid, film, lines, changed, second, load_x, load_y, x, y, places, total)
    place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    limit = all_found(places) and needs_too_little(changed, places) and needs_too_little(second, places)
    if limit:
        places.status[changed] = AT_LIMIT
        if second >= 0:
            places.status[second] = AT_LIMIT
    return x, y, limit
