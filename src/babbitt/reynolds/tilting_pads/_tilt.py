"""Kernels: the tilt at which the film of a pad makes no moment about its pivot.

It is found by Newton between two bounds, from the side on which the trailing edge is closer: there the moment
falls with the tilt, which is the stable one of two roots. Of a free pad a point where the moment still turns it
that way, where the film is dry, or where the moment rises lies left of it, any other right. On a flexure the sign
of the moment alone decides: it turns the pad back at contact of either edge, and a root lies between. Every
moment belongs to a wet set that does not change any more, found from a wet film at first.
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds._structs import CLEARANCE, END, START, Bearing
from babbitt.reynolds.lands._equilibrium import answer_land
from babbitt.reynolds.lands._grids import film_coefficients, new_film, new_grid, new_lines, uniform_lines
from babbitt.reynolds.tilting_pads._turbulent_pads import turbulent_coefficients

LOADED, UNLOADED, AT_LIMIT, NO_FILM, NOT_FOUND = 0, 1, 2, 3, 4

MOST_UPDATES = 60  # of the wet set at one place
MOST_TILTS = 80  # films in the search of a tilt
MOST_FILMS = 60000  # in all: then no more tilts are sought
FOLD_WIDTH = 3e-5  # of the clearance: bounds of a tilt that never turned back; the fold is then within 1e-9 in e
ROOT_WIDTH = 1e-13  # of the clearance: bounds of a tilt that cannot come closer
EDGE_WIDTH = 1e-4  # of the clearance: tilt at which a flexure presses an edge on the journal
ROOT_MOMENT = 1e-6  # moment over the load at bounds that close, for nodes that change between wet and dry there
TILT_ON_FLEXURE = 1e-12  # of the clearance: tilt up to which the moment of a flexure is not resolved
TOWARDS_CONTACT = 0.8  # share of the way to contact in one step of the tilt
DRY_LOAD = 1e-12  # load of a film that is as good as dry
ON_THE_WAY, AT_FOLD = 1e-3, 1e-8  # moment over the lever of the pivot over the load, in the search of a fold


@compiled
def pad_grid(pads, intervals, m):
    """Equally spaced lines of all pads."""
    grid = new_grid(pads.kappa.size, intervals, m)
    uniform_lines(pads.bearing, grid)
    return grid


@inlined
def pad_land(pads, k):
    """Pad k as a land of its own."""
    b = pads.bearing
    return Bearing(
        b.lands, b.profiles, pads.kappa[k], b.speed, b.side_pressure, b.conserving, b.smooth, b.crowding
    )


@inlined
def pad_coefficients(pads, grid, k, e, eta, film):
    """Coefficients of the film of pad k at (e, eta), turbulent or of a viscosity that differs from interval to
    interval."""
    if pads.turbulence.shape[1] > 0:
        turbulent_coefficients(pads.turbulence[k], grid, k, e, eta, film)
        return
    film_coefficients(pad_land(pads, k), grid, k, e, eta, 0.0, 0.0, film)
    if pads.fluidity.shape[1] == 0:
        return
    n = film.conductance.size
    before = pads.fluidity[k, 0]
    for i in range(n + 1):
        behind = pads.fluidity[k, min(i, n - 1)]
        mean = 0.5 * (before + behind)
        film.cubed[i] *= mean
        film.cubed_x[i] *= mean
        film.cubed_y[i] *= mean
        before = behind
        if i == n:
            break
        film.conductance[i] *= behind
        film.conductance_x[i] *= behind
        film.conductance_y[i] *= behind
        film.couette[i] *= pads.drag[k, i]
        film.couette_x[i] *= pads.drag[k, i]
        film.couette_y[i] *= pads.drag[k, i]


@inner
def pad_film(axial, pads, grid, k, film, lines, e, eta, wet, smooth, places):
    """Film of pad k at (e, eta), its answers filled in; returns whether its wet set does not change any more."""
    own, answer = pad_land(pads, k), places.answers[k]
    pad_coefficients(pads, grid, k, e, eta, film)
    if wet:
        grid.wet[k] = True
    converged = False
    for _ in range(MOST_UPDATES):
        answer[:] = 0.0
        places.films[0] += 1
        if answer_land(axial, own, grid, k, film, lines, smooth, answer) == 0:
            converged = True
            break
    for c in range(answer.size):
        answer[c] *= pads.weight[k]
    return converged


@inlined
def tilt_bounds(grid, k, e):
    """Places eta between which the gap of pad k is open; the first above the second where none is."""
    least, most = -np.inf, np.inf
    for i in range(grid.step.shape[1]):
        for c, s, gap in (
            (grid.cos_a[k, i], grid.sin_a[k, i], grid.gap_a[k, i]),
            (grid.cos_b[k, i], grid.sin_b[k, i], grid.gap_b[k, i]),
        ):
            h = gap - e * c
            if s > 0.0:
                most = min(most, h / s)
            elif s < 0.0:
                least = max(least, h / s)
            if h <= 0.0 and abs(s) < 1e-3:
                return 0.0, -1.0
    return least, most


@inlined
def diverging_tilt(e, start):
    """Place eta below which a pad with e < 0 has its widest gap behind its leading edge, at ``start`` from the
    pivot.

    The film of a plain pad then begins inside of it and turns it back whatever it does: no stable tilt lies there.
    """
    return -e * math.tan(min(-start, 1.5)) if e < 0.0 else -np.inf


@inlined
def first_tilt(e, clearance, start, end):
    """Place eta where a search begins that knows no better: a fit to pads of 60 to 80 degrees."""
    depth = min(max(e / clearance, 0.02), 0.98)
    offset = start / (start - end) - 0.5
    guess = 0.62 * math.sqrt(depth * (1.0 - depth)) + 2.5 * max(offset, 0.0) * (1.0 - depth)
    return max(guess * clearance, 1.8 * diverging_tilt(e, start))


@inner
def find_tilt(axial, pads, grid, k, film, lines, e, origin, guess, tolerance, places):
    """Place eta of pad k at which the film makes no moment, for ``origin`` the eta of the flexure without
    moment.

    Returns eta and the status; ``guess`` nan: none. Unloaded pads get eta = 0.
    """
    clearance, spring = pads.bearing.lands[k, CLEARANCE], pads.rotational[k]
    answer = places.answers[k]
    if spring == 0.0 and (e <= places.unloaded_below[k] or (pads.centred[k] and e <= 0.0)):
        answer[:] = 0.0
        return 0.0, UNLOADED
    if places.films[0] > MOST_FILMS:
        answer[:] = 0.0
        return 0.0, NOT_FOUND
    least, most = tilt_bounds(grid, k, e)
    if not least < most:
        answer[:] = 0.0
        return 0.0, NO_FILM
    start, end = pads.bearing.lands[k, START], pads.bearing.lands[k, END]
    left, right = least, most
    if spring == 0.0 and pads.plain[k]:
        left = max(least, diverging_tilt(e, start))
    known = not math.isnan(guess)
    eta = guess if known else first_tilt(e, clearance, start, end)
    eta = min(max(eta, left + 0.02 * (most - left)), most - 0.1 * (most - max(left, 0.0)))
    turned, unloaded, wet, slow, last = False, False, not known, 0, np.inf
    for _ in range(MOST_TILTS):
        if not pad_film(axial, pads, grid, k, film, lines, e, eta, wet, bool(0), places):
            if not wet:  # once more from a wet film
                wet = True
                continue
            eta = eta - 1e-7 * (right - left)  # a tie that changes sides for ever: beside it
            continue
        wet = False
        moment = answer[1] - spring * (eta - origin)
        slope = -answer[5] - spring
        load = -answer[0]
        dry = load <= DRY_LOAD * pads.weight[k] and spring == 0.0
        size = abs(moment)
        unresolved = TILT_ON_FLEXURE * spring * clearance
        if slope < 0.0 and not dry and size <= tolerance * load + unresolved:
            return eta, LOADED
        if moment > 0.0 or (spring == 0.0 and (dry or slope >= 0.0)):
            left = eta
            turned = turned or (moment > 0.0 and not dry)
        else:
            right = eta
        width = right - left
        if not turned and spring == 0.0 and width < FOLD_WIDTH * clearance:
            unloaded = True
            break
        if spring > 0.0 and width < EDGE_WIDTH * clearance and (left == least or right == most):
            break
        if width < ROOT_WIDTH * clearance:
            if size <= ROOT_MOMENT * load + unresolved:
                return eta, LOADED
            break
        slow = slow + 1 if size > 0.5 * last else 0
        last = size
        step = -moment / slope if slope < 0.0 and not dry else np.inf
        step = min(step, TOWARDS_CONTACT * (most - eta))
        step = max(step, TOWARDS_CONTACT * (least - eta))
        new = eta + step
        if slope >= 0.0 or dry or slow > 3 or not left < new < right:
            new = 0.5 * (left + right)
            slow = 0
        eta = new
    answer[:] = 0.0
    if spring > 0.0 and (left == least or right == most):  # the flexure presses an edge on the journal
        return 0.0, NO_FILM
    if not unloaded:
        return 0.0, NOT_FOUND
    places.unloaded_below[k] = max(places.unloaded_below[k], e)
    return 0.0, UNLOADED


@compiled
def find_fold(axial, pads, intervals, k, loaded, lowest, width, places):
    """Smallest e at which pad k, free to tilt, has an equilibrium, by bisection between two e.

    Returns e, the load there, and eta; minus infinity where the pad carries still at ``lowest``, nan where a
    tilt is not found or the pad does not carry at ``loaded``.
    """
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    eta, status = find_tilt(axial, pads, grid, k, film, lines, lowest, 0.0, np.nan, ON_THE_WAY, places)
    if status == LOADED:
        return -np.inf, -places.answers[k, 0], eta
    if status == NOT_FOUND:
        return np.nan, np.nan, np.nan
    best, status = find_tilt(axial, pads, grid, k, film, lines, loaded, 0.0, np.nan, ON_THE_WAY, places)
    if status != LOADED:
        return np.nan, np.nan, np.nan
    low, high, load, guess = lowest, loaded, -places.answers[k, 0], best
    while high - low > width:
        e = 0.5 * (low + high)
        eta, status = find_tilt(axial, pads, grid, k, film, lines, e, 0.0, guess, AT_FOLD, places)
        if status == LOADED:
            high, load, best, guess = e, -places.answers[k, 0], eta, eta
        elif status == NOT_FOUND:
            return np.nan, np.nan, np.nan
        else:
            low = e
    return high, load, best
