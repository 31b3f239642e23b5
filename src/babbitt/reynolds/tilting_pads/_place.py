"""Kernels: a pad for a place of the journal, its film and its elastic pivot in series."""

from __future__ import annotations

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds._structs import CLEARANCE
from babbitt.reynolds.lands._grids import new_film, new_lines
from babbitt.reynolds.tilting_pads._pivot_curve import is_elastic, pivot_curve
from babbitt.reynolds.tilting_pads._structs import PadPlaces
from babbitt.reynolds.tilting_pads._tilt import (
    AT_LIMIT,
    LOADED,
    NO_FILM,
    NOT_FOUND,
    UNLOADED,
    find_tilt,
    pad_film,
    pad_grid,
)

TIGHT = 1e-8  # moment over the lever of the pivot over the load, at last
MOST_PIVOTS = 60  # tilts in the search of the displacement of a pivot
TOWARDS_PIVOT = 0.7  # share of the gap at a pivot in one step of the journal


@compiled
def new_places(pads):
    """Places of all pads: unknown."""
    count = pads.kappa.size
    return PadPlaces(
        np.zeros(count), np.full(count, np.nan), np.zeros(count), np.full(count, UNLOADED), np.full(count,
        -np.inf), np.zeros((count, 10)), np.zeros((count, 2)), np.zeros((count, 4)), np.ones(count),
        np.zeros(count), np.zeros(1, np.int64),
    )  # fmt: skip


@inlined
def condensed_slope(answer, spring):
    """Growth dW/de of the load of a pad that tilts as it must, and how its eta follows."""
    across = answer[5] + spring
    if across == 0.0:
        return answer[2], 0.0
    return answer[2] - answer[3] * answer[4] / across, -answer[4] / across


@inner
def place_pad(axial, pads, grid, k, film, lines, x, y, tolerance, places):
    """Tilt and pivot of pad k for a journal at (x, y): fills its places, push and condensed stiffness."""
    c, s, spring = pads.cosine[k], pads.sine[k], pads.rotational[k]
    at = pads.offset[k] + x * c + y * s  # e with a rigid pivot
    origin = y * c - x * s + pads.neutral[k]
    answer = places.answers[k]
    elastic = is_elastic(pads.curves[k], pads.displacements[k])
    low, high = -np.inf, at
    e = at
    if elastic:
        e = min(e, 0.8 * pads.bearing.lands[k, CLEARANCE])
        if places.status[k] == LOADED:
            e = min(places.radial[k] + places.gain[k] * (at - places.rigid[k]), at)
    places.rigid[k] = at
    eta, status, load, across, slope, follows, u, flexible = 0.0, UNLOADED, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    found = False
    for _ in range(MOST_PIVOTS):
        guess = np.nan
        if places.status[k] == LOADED:
            guess = places.along[k] + places.follows[k] * (e - places.radial[k])
        eta, status = find_tilt(axial, pads, grid, k, film, lines, e, origin, guess, tolerance, places)
        load, slope, follows = 0.0, 0.0, 0.0
        if status == LOADED:
            slope, follows = condensed_slope(answer, spring)
            across = (answer[1] - spring * (eta - origin)) / (answer[5] + spring)  # the last step, not taken
            load = -answer[0] + answer[3] * across
            places.radial[k], places.along[k], places.follows[k], places.status[k] = e, eta, follows, status
        if not elastic:
            found = True
            break
        u, flexible = pivot_curve(pads.curves[k], pads.loads[k], pads.displacements[k], load)
        miss = e + u - at
        if status == NO_FILM or miss > 0.0:
            high = e
        else:
            low = e
        if status != NO_FILM and abs(miss) <= 0.01 * tolerance:
            found = True
            break
        if high - low < 1e-12:
            status, found = AT_LIMIT, True
            break
        new = np.nan
        if status == LOADED:
            new = e - miss / (1.0 + flexible * slope)
        if not low < new < high:
            if low > -np.inf:
                new = 0.5 * (low + high)
            else:
                new = (
                    e - 0.5 * pads.bearing.lands[k, CLEARANCE] if status == NO_FILM else e - 0.5 * max(miss, 1e-3)
                )
        e = new
    if not found:
        status = NOT_FOUND
    places.radial[k], places.along[k], places.follows[k], places.status[k] = e, eta, follows, status
    if status != LOADED:
        answer[:] = 0.0
        places.force[k] = 0.0
        places.stiffness[k] = 0.0
        places.gain[k] = 1.0
        return
    gain = 1.0 / (1.0 + flexible * slope)
    places.force[k, 0] = -load + slope * gain * (e + u - at) if elastic else -load
    places.force[k, 1] = spring * (eta + across - origin)
    support_stiffness(answer, flexible, spring, places.stiffness[k])
    places.gain[k] = gain


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
    total[:6] = 0.0
    open_gap = True
    for k in range(pads.kappa.size):
        place_pad(axial, pads, grid, k, film, lines, x, y, tolerance, places)
        open_gap = open_gap and places.status[k] != NO_FILM
        c, s = pads.cosine[k], pads.sine[k]
        n, t = places.force[k, 0], places.force[k, 1]
        total[0] += n * c - t * s
        total[1] += n * s + t * c
        nn, nt, tn, tt = places.stiffness[k]
        total[2] += nn * c * c - (nt + tn) * c * s + tt * s * s
        total[3] += (nn - tt) * c * s + nt * c * c - tn * s * s
        total[4] += (nn - tt) * c * s + tn * c * c - nt * s * s
        total[5] += nn * s * s + (nt + tn) * c * s + tt * c * c
    return open_gap


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


@inlined
def all_found(places):
    """Whether every search of a tilt and a pivot has ended."""
    return not np.any(places.status == NOT_FOUND)


@compiled
def pads_at(axial, pads, intervals, x, y, places, total):
    """Pads for a journal at (x, y): whether every pad has a film, whether all were found, and the grid.

    Fills ``total`` (F 2, K 4).
    """
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    is_open = place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    return is_open, all_found(places), grid


@compiled
def smooth_answers(axial, pads, grid, places):
    """Films of settled pads once more, stiffness and damping freed from the steps of the grid (``_endings``)."""
    n, m = grid.step.shape[1], len(axial.size)
    film, lines = new_film(n), new_lines(n, m)
    for k in range(pads.kappa.size):
        if places.status[k] == LOADED:
            pad_film(
                axial, pads, grid, k, film, lines, places.radial[k], places.along[k], bool(0),
                pads.bearing.smooth, places,
            )  # fmt: skip
