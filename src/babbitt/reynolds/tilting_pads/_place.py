"""Kernels: a pad for a place of the journal, its film and its elastic pivot in series."""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds._structs import CLEARANCE
from babbitt.reynolds.lands._equilibrium import THINNEST
from babbitt.reynolds.lands._grids import new_film, new_lines
from babbitt.reynolds.tilting_pads._pivot_curve import is_elastic, pivot_curve
from babbitt.reynolds.tilting_pads._structs import PadPlaces, Pads
from babbitt.reynolds.tilting_pads._tilt import (
    AT_LIMIT,
    LOADED,
    NO_FILM,
    NOT_FOUND,
    UNLOADED,
    find_tilt,
    pad_film,
    pad_grid,
    tilt_bounds,
)

TIGHT = 1e-8  # moment over the lever of the pivot over the load, at last
MOST_PIVOTS = 60  # tilts in the search of the displacement of a pivot
TOWARDS_PIVOT = 0.7  # share of the gap at a pivot in one step of the journal
PIVOT_WIDTH = 1e-12  # of the clearance: bounds of e that cannot come closer
CONTACT_WIDTH = 1e-4  # the same where there is no film at the upper one
SAME_LOAD = 1e-5  # of the load: what the loads at such bounds may differ without being two branches


def new_places(pads: Pads) -> PadPlaces:
    """Places of all pads: unknown."""
    count = pads.kappa.size
    return PadPlaces(
        radial=np.zeros(count), along=np.full(count, np.nan), follows=np.zeros(count),
        status=np.full(count, UNLOADED), unloaded_below=np.full(count, -np.inf), answers=np.zeros((count, 10)),
        force=np.zeros((count, 2)), stiffness=np.zeros((count, 4)), gain=np.ones(count), rigid=np.zeros(count),
        fold=np.full(count, np.nan), need=np.zeros(count), least=np.zeros(count), films=np.zeros(1, np.int64),
    )  # fmt: skip


@inlined
def condensed_slope(answer, spring):
    """Growth dW/de of the load of a pad that tilts as it must, and how its eta follows."""
    across = answer[5] + spring
    if across == 0.0:
        return answer[2], 0.0
    return answer[2] - answer[3] * answer[4] / across, -answer[4] / across


@inlined
def load_on_pivot(curve, loads, displacements, way, most):
    """Load below ``most`` under which a pivot gives way by ``way``, by bisection."""
    low, high = 0.0, most
    while high - low > 1e-14 * most:
        load = 0.5 * (low + high)
        if pivot_curve(curve, loads, displacements, load)[0] < way:
            low = load
        else:
            high = load
    return high


@inner
def tilt_pad(axial, pads, grid, k, film, lines, e, origin, tolerance, places):
    """Pad k tilts as it must at e: status, load, its growth with e, and the last step of the tilt, not taken."""
    spring, answer = pads.rotational[k], places.answers[k]
    guess = np.nan
    if places.status[k] == LOADED:
        guess = places.along[k] + places.follows[k] * (e - places.radial[k])
    eta, status = find_tilt(axial, pads, grid, k, film, lines, e, origin, guess, tolerance, places)
    if status == NO_FILM and not math.isnan(guess):  # an edge touches: the pad may fall to another tilt
        eta, status = find_tilt(axial, pads, grid, k, film, lines, e, origin, np.nan, tolerance, places)
    if status != LOADED:
        return status, 0.0, 0.0, 0.0
    slope, follows = condensed_slope(answer, spring)
    across = (answer[1] - spring * (eta - origin)) / (answer[5] + spring)
    places.radial[k], places.along[k], places.follows[k], places.status[k] = e, eta, follows, status
    return status, -answer[0] + answer[3] * across, slope, across


@inner
def settle_pivot(axial, pads, grid, k, film, lines, at, origin, tolerance, places):
    """Pad k on an elastic pivot, e + u(W) = at: what `tilt_pad` says of it, and e.

    Where the pad unloads at a load that gives way too far it is at its limit: its fold and its least load are kept
    in ``places``. A load that jumps from one tilt to another is treated alike.
    """
    curve, loads, displacements = pads.curves[k], pads.loads[k], pads.displacements[k]
    clearance = pads.bearing.lands[k, CLEARANCE]
    low, high, lower, least = -np.inf, at + PIVOT_WIDTH * clearance, 0.0, 0.0
    e = min(at, 0.8 * clearance)
    if places.status[k] == LOADED:
        e = min(places.radial[k] + places.gain[k] * (at - places.rigid[k]), at)
    status, load, slope, across, touches = NOT_FOUND, 0.0, 0.0, 0.0, False
    for _ in range(MOST_PIVOTS):
        status, load, slope, across = tilt_pad(axial, pads, grid, k, film, lines, e, origin, tolerance, places)
        if status == NOT_FOUND:
            if e < (1.0 - THINNEST) * clearance:
                break
            status = NO_FILM
        u, flexible = pivot_curve(curve, loads, displacements, load)
        miss = e + u - at
        if status != NO_FILM and abs(miss) <= 0.01 * tolerance:
            return status, load, slope, across, e
        if status == NO_FILM or miss > 0.0:
            high, least, touches = e, -places.answers[k, 0], status == NO_FILM  # not corrected: it is singular
        else:
            low, lower = e, load
        if high - low < (CONTACT_WIDTH if touches else PIVOT_WIDTH) * clearance:
            if status == LOADED and least > 0.0 and abs(least - lower) <= SAME_LOAD * least:
                return status, load, slope, across, e
            if tolerance <= TIGHT or pads.rotational[k] > 0.0:
                places.least[k] = least
                places.fold[k] = high if lower == 0.0 else np.nan
            return AT_LIMIT if least > 0.0 else NO_FILM, 0.0, 0.0, 0.0, high
        new = np.nan
        if status == LOADED:
            new = e - miss / (1.0 + flexible * slope)
        if not low < new < high:
            if low > -np.inf:
                new = 0.5 * (low + high)
            elif status == NO_FILM:
                new = e - 0.5 * clearance
            else:
                new = e - 0.5 * max(miss, 1e-3)
        e = new
    return status if status == NO_FILM else NOT_FOUND, 0.0, 0.0, 0.0, e


@inlined
def stands_at_limit(pads, k, at, places):
    """Whether a free pad on an elastic pivot stands at its fold, where that is known."""
    if pads.rotational[k] > 0.0 or not at > places.fold[k]:
        return False
    u, _ = pivot_curve(pads.curves[k], pads.loads[k], pads.displacements[k], places.least[k])
    return at < places.fold[k] + u


@inner
def place_pad(axial, pads, grid, k, film, lines, x, y, tolerance, places):
    """Tilt and pivot of pad k for a journal at (x, y): fills its places, push and condensed stiffness."""
    c, s, spring = pads.cosine[k], pads.sine[k], pads.rotational[k]
    at = pads.offset[k] + x * c + y * s  # e with a rigid pivot
    origin = y * c - x * s + pads.neutral[k]
    elastic = is_elastic(pads.curves[k], pads.displacements[k])
    status, load, slope, across, e = AT_LIMIT, 0.0, 0.0, 0.0, places.fold[k]
    if not elastic:
        e = at
        status, load, slope, across = tilt_pad(axial, pads, grid, k, film, lines, e, origin, tolerance, places)
    elif not stands_at_limit(pads, k, at, places):
        status, load, slope, across, e = settle_pivot(
            axial, pads, grid, k, film, lines, at, origin, tolerance, places
        )
        if status == AT_LIMIT and spring == 0.0 and tolerance > TIGHT:  # a loose tilt carries beyond its fold
            status, load, slope, across, e = settle_pivot(
                axial, pads, grid, k, film, lines, at, origin, TIGHT, places
            )
    places.rigid[k], places.status[k] = at, status
    if status == LOADED:
        push_of_film(pads, k, load, slope, e - at, places.along[k] + across - origin, places)
        return
    places.radial[k], places.along[k], places.follows[k], places.gain[k] = e, 0.0, 0.0, 1.0
    places.answers[k] = 0.0
    places.force[k] = 0.0
    places.stiffness[k] = 0.0
    if status == AT_LIMIT:
        push_at_limit(pads, k, at - e, places)


@inlined
def push_of_film(pads, k, load, slope, moved, turned, places):
    """Push and stiffness of a pad whose film carries ``load``, its pivot ``moved`` and its flexure ``turned``."""
    spring = pads.rotational[k]
    u, flexible = pivot_curve(pads.curves[k], pads.loads[k], pads.displacements[k], load)
    gain = 1.0 / (1.0 + flexible * slope)
    elastic = is_elastic(pads.curves[k], pads.displacements[k])
    places.force[k, 0] = -load + slope * gain * (moved + u) if elastic else -load
    places.force[k, 1] = spring * turned
    support_stiffness(places.answers[k], flexible, spring, places.stiffness[k])
    places.gain[k] = gain


@inlined
def push_at_limit(pads, k, way, places):
    """The pivot of a pad at its limit, given way by ``way``, pushes alone.

    So the push grows from nothing to the least load of the film without a jump, and the potential of the journal
    stays convex.
    """
    curve, loads, displacements = pads.curves[k], pads.loads[k], pads.displacements[k]
    need = load_on_pivot(curve, loads, displacements, way, places.least[k])
    _, flexible = pivot_curve(curve, loads, displacements, need)
    places.need[k] = need
    places.force[k, 0] = -need
    places.stiffness[k, 0] = 1.0 / flexible if flexible > 0.0 else 0.0
    places.gain[k] = 0.0


@inlined
def drop_limits(pads, places, total):
    """Takes the pushes of pads at their limits, which no film gives, out of ``total``."""
    for k in range(pads.kappa.size):
        if places.status[k] == AT_LIMIT:
            total[0] -= places.force[k, 0] * pads.cosine[k] - places.force[k, 1] * pads.sine[k]
            total[1] -= places.force[k, 0] * pads.sine[k] + places.force[k, 1] * pads.cosine[k]
            places.force[k] = 0.0


@inlined
def support_stiffness(answer, flexible, spring, stiffness):
    """Stiffness of a pad against the journal, K (A^-1) diag(1, spring), of film and support in series.

    A d(xi, eta) = diag(1, spring) d(n, tau) with A = (1 + u' K_xixi, u' K_xieta; K_etaxi, K_etaeta + spring).
    """
    a, b = 1.0 + flexible * answer[2], flexible * answer[3]
    c, d = answer[4], answer[5] + spring
    det = a * d - b * c
    if det == 0.0:
        stiffness[:] = 0.0
        return
    xx, xy, yx, yy = d / det, -b * spring / det, -c / det, a * spring / det
    stiffness[0] = answer[2] * xx + answer[3] * yx
    stiffness[1] = answer[2] * xy + answer[3] * yy
    stiffness[2] = answer[4] * xx + answer[5] * yx
    stiffness[3] = answer[4] * xy + answer[5] * yy


@inner
def place_all(axial, pads, grid, film, lines, x, y, tolerance, places, total):
    """All pads for a journal at (x, y): fills ``total[:6]`` (F 2, K 4); returns whether every pad has a film."""
    open_gap = True
    for k in range(pads.kappa.size):
        place_pad(axial, pads, grid, k, film, lines, x, y, tolerance, places)
        open_gap = open_gap and places.status[k] != NO_FILM
    add_pushes(pads, places, total)
    return open_gap


@inlined
def add_pushes(pads, places, total):
    """Force and stiffness of all pads, ``total[:6]``."""
    total[:6] = 0.0
    for k in range(pads.kappa.size):
        c, s = pads.cosine[k], pads.sine[k]
        n, t = places.force[k, 0], places.force[k, 1]
        total[0] += n * c - t * s
        total[1] += n * s + t * c
        stiffness = places.stiffness[k]
        nn, nt, tn, tt = stiffness[0], stiffness[1], stiffness[2], stiffness[3]
        total[2] += nn * c * c - (nt + tn) * c * s + tt * s * s
        total[3] += (nn - tt) * c * s + nt * c * c - tn * s * s
        total[4] += (nn - tt) * c * s + tn * c * c - nt * s * s
        total[5] += nn * s * s + (nt + tn) * c * s + tt * c * c


@inlined
def longest_step(pads, places, dx, dy):
    """Share of a step of the journal that closes no pivot gap by more than ``TOWARDS_PIVOT`` of it."""
    share = 1.0
    for k in range(pads.kappa.size):
        gap = pads.bearing.lands[k, CLEARANCE] - places.radial[k]
        closes = (dx * pads.cosine[k] + dy * pads.sine[k]) * places.gain[k]
        if closes > TOWARDS_PIVOT * gap:
            share = min(share, TOWARDS_PIVOT * gap / closes)
    return share


@inner
def any_pad_is(places, status):
    """Whether one of the pads has this status."""
    found = False
    for k in range(places.status.size):
        found = found or places.status[k] == status
    return found


@inner
def copy_status(places, statuses):
    """Keep the status of every pad in ``statuses``. (An assignment of whole arrays takes seconds to compile.)"""
    for k in range(statuses.size):
        statuses[k] = places.status[k]


@inlined
def all_found(places):
    """Whether every search of a tilt and a pivot has ended."""
    return not any_pad_is(places, NOT_FOUND)


@compiled
def pads_at(axial, pads, intervals, x, y, places, total):
    """Pads for a journal at (x, y): whether every pad has a film, whether all were found, and the grid.

    Fills ``total`` (F 2, K 4).
    """
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    is_open = place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    drop_limits(pads, places, total)
    return is_open, all_found(places), grid


@compiled
def hold_pads(axial, pads, grid, x, y, radial, along, places, total):
    """Pads held at (e, eta), whether they balance there or not: fills ``places`` and ``total`` (F 2, K 4).

    Returns the least way of an edge to contact, as a tilt over the clearance; negative where a gap is closed or a
    wet set goes on changing.
    """
    film, lines = new_film(grid.step.shape[1]), new_lines(grid.step.shape[1], len(axial.size))
    room = np.inf
    for k in range(pads.kappa.size):
        e, eta, clearance = radial[k], along[k], pads.bearing.lands[k, CLEARANCE]
        least, most = tilt_bounds(grid, k, e)
        room = min(room, min(eta - least, most - eta) / clearance)
        if not room > 0.0 or not pad_film(axial, pads, grid, k, film, lines, e, eta, True, bool(0), places):
            return -1.0
        c, s = pads.cosine[k], pads.sine[k]
        places.rigid[k] = pads.offset[k] + x * c + y * s
        slope, places.follows[k] = condensed_slope(places.answers[k], pads.rotational[k])
        places.radial[k], places.along[k], places.status[k] = e, eta, LOADED
        turned = eta - (y * c - x * s + pads.neutral[k])
        push_of_film(pads, k, -places.answers[k, 0], slope, e - places.rigid[k], turned, places)
    add_pushes(pads, places, total)
    return room
