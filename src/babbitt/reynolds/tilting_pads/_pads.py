"""Kernels: the tilt of a pad, its elastic pivot, and the journal among pads.

The tilt at which the film makes no moment is found by Newton between two bounds, from the side on which the
trailing edge is closer: there the moment falls with the tilt, which is the stable one of two roots. A point
where the moment still turns the pad that way, where the film is dry, or where the moment rises lies left of it,
any other right. Every moment belongs to a wet set that does not change any more, found from a wet film at first.

The journal then moves in a convex potential (every pad load grows with the way towards its pivot), by Newton
with the condensed stiffnesses and a search along the step for the place where the force no longer opposes it.
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds._structs import CLEARANCE, END, START, Bearing
from babbitt.reynolds.lands._equilibrium import evaluate_land
from babbitt.reynolds.lands._grids import new_film, new_grid, new_lines, uniform_lines
from babbitt.reynolds.tilting_pads._structs import (
    COMPLIANCE,
    EXPONENT,
    FACTOR,
    LINE,
    LINE_SLOPE,
    PadPlaces,
)

LOADED, UNLOADED, AT_LIMIT, NO_FILM = 0, 1, 2, 3
CONVERGED, TOO_MANY_STEPS, CLOSED, STUCK, LIMIT = 0, 1, 2, 3, 4

MOST_UPDATES = 60  # of the wet set at one place
MOST_TILTS = 80  # films in the search of a tilt
FOLD_WIDTH = 3e-5  # of the clearance: bounds of a tilt that never turned back; the fold is then within 1e-9 in e
ROOT_WIDTH = 1e-13  # of the clearance: bounds of a tilt that cannot come closer
TOWARDS_CONTACT = 0.8  # share of the way to contact in one step of the tilt
NOTHING = 1e-12  # load of a film that is as good as dry
LOOSE, CLOSER, TIGHT = 3e-2, 1e-3, 1e-8  # moment over the lever of the pivot over the load, on the way and at last
TOWARDS_PIVOT = 0.7  # share of the gap at a pivot in one step of the journal
OVERSHOOT = 0.7  # share of the driving force that may oppose a step behind it
INDIFFERENT = 1e-6  # of the trace: stiffness of a direction that no pad stiffens
UNEVEN = 0.1  # the same where a pad gains or loses its load on the way
BESIDE = 1e-8  # of the clearance: where a pad at its limit is taken to carry
SIDEWAYS = 1e-9  # of the clearance: where a second pad jumps, along one at its limit
MOST_HELD, MOST_ALONG = 20, 60  # times that a pad is held at its limit, and steps along it
SHORTEST = 1e-12  # step of the journal at which a search along it is stuck


@compiled
def new_places(pads):
    """Places of all pads: unknown."""
    count = pads.kappa.size
    return PadPlaces(
        np.zeros(count), np.full(count, np.nan), np.zeros(count), np.full(count, UNLOADED), np.full(count,
        -np.inf), np.zeros((count, 10)), np.zeros((count, 2)), np.zeros((count, 4)), np.ones(count),
        np.zeros(count), np.zeros(1, np.int64),
    )  # fmt: skip


@compiled
def pad_grid(pads, intervals, m):
    """Equally spaced lines of all pads."""
    grid = new_grid(pads.kappa.size, intervals, m)
    uniform_lines(pads.bearing, grid)
    return grid


@inner
def pad_film(axial, pads, grid, k, film, lines, e, eta, wet, smooth, places):
    """Film of pad k at (e, eta) with a wet set that has settled; returns whether it has. Fills its answers."""
    b = pads.bearing
    own = Bearing(b.lands, b.profiles, pads.kappa[k], b.speed, b.side_pressure, b.conserving, b.smooth, b.crowding)
    answer = places.answers[k]
    if wet:
        grid.wet[k] = True
    settled = False
    for _ in range(MOST_UPDATES):
        answer[:] = 0.0
        places.films[0] += 1
        if evaluate_land(axial, own, grid, k, film, lines, e, eta, 0.0, 0.0, smooth, answer) == 0:
            settled = True
            break
    answer *= pads.weight[k]
    return settled


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

    The film then begins inside of the pad and turns it back whatever it does: no stable tilt lies there.
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
    if spring == 0.0 and (e <= places.dead[k] or (pads.centred[k] and e <= 0.0)):
        answer[:] = 0.0
        return 0.0, UNLOADED
    least, most = tilt_bounds(grid, k, e)
    if not least < most:
        answer[:] = 0.0
        return 0.0, NO_FILM
    start, end = pads.bearing.lands[k, START], pads.bearing.lands[k, END]
    left, right = least, most
    if spring == 0.0:
        left = max(least, diverging_tilt(e, start))
    known = not math.isnan(guess)
    eta = guess if known else first_tilt(e, clearance, start, end)
    eta = min(max(eta, left + 0.02 * (most - left)), most - 0.1 * (most - max(left, 0.0)))
    turned, wet, slow, last = False, not known, 0, np.inf
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
        dry = load <= NOTHING * pads.weight[k] and spring == 0.0
        size = abs(moment)
        if slope < 0.0 and not dry and size <= tolerance * load + (1e-15 if spring > 0.0 else 0.0):
            return eta, LOADED
        if moment > 0.0 or dry or slope >= 0.0:
            left = eta
            turned = turned or (moment > 0.0 and not dry)
        else:
            right = eta
        width = right - left
        if not turned and spring == 0.0 and width < FOLD_WIDTH * clearance:
            break
        if width < ROOT_WIDTH * clearance:
            return eta, LOADED
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
    places.dead[k] = max(places.dead[k], e)
    return 0.0, UNLOADED


@inlined
def pivot_curve(pads, k, load):
    """Displacement of pivot k under a load, and its slope."""
    curve = pads.curves[k]
    if load <= 0.0:
        return 0.0, 0.0
    u = load * curve[COMPLIANCE]
    slope = curve[COMPLIANCE]
    if curve[FACTOR] > 0.0:
        part = curve[FACTOR] * load ** curve[EXPONENT]
        u += part
        slope += curve[EXPONENT] * part / load
    if curve[LINE_SLOPE] > 0.0:
        bent = curve[LINE] - curve[LINE_SLOPE] * math.log(load)
        u += load * bent
        slope += bent - curve[LINE_SLOPE]
    points = pads.loads.shape[1]
    if points > 1:
        s = 1
        while s < points - 1 and pads.loads[k, s] < load:
            s += 1
        rise = pads.displacements[k, s] - pads.displacements[k, s - 1]
        if rise > 0.0:
            part = rise / (pads.loads[k, s] - pads.loads[k, s - 1])
            u += pads.displacements[k, s - 1] + (load - pads.loads[k, s - 1]) * part
            slope += part
    return u, slope


@inlined
def is_elastic(pads, k):
    """Whether pivot k gives way."""
    curve = pads.curves[k]
    elastic = curve[FACTOR] > 0.0 or curve[LINE_SLOPE] > 0.0 or curve[COMPLIANCE] > 0.0
    return elastic or (pads.loads.shape[1] > 1 and pads.displacements[k, 1] > 0.0)


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
    elastic = is_elastic(pads, k)
    low, high = -np.inf, at
    e = at
    if elastic:
        e = min(e, 0.8 * pads.bearing.lands[k, CLEARANCE])
        if places.status[k] == LOADED:
            e = min(places.radial[k] + places.gain[k] * (at - places.rigid[k]), at)
    places.rigid[k] = at
    eta, status, load, across, slope, follows, u, flexible = 0.0, UNLOADED, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for _ in range(60):
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
            break
        u, flexible = pivot_curve(pads, k, load)
        miss = e + u - at
        if status == NO_FILM or miss > 0.0:
            high = e
        else:
            low = e
        if status != NO_FILM and abs(miss) <= 0.01 * tolerance:
            break
        if high - low < 1e-12:
            status = AT_LIMIT
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
    places.radial[k], places.along[k], places.follows[k], places.status[k] = e, eta, follows, status
    if status != LOADED:
        answer[:] = 0.0
        places.push[k] = 0.0
        places.stiffness[k] = 0.0
        places.gain[k] = 1.0
        return
    gain = 1.0 / (1.0 + flexible * slope)
    places.push[k, 0] = -load + slope * gain * (e + u - at) if elastic else -load
    places.push[k, 1] = spring * (eta + across - origin)
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
        n, t = places.push[k, 0], places.push[k, 1]
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
def allowed_moment(places, residual):
    """Moment over load of a pad at which its load, corrected to first order, errs by less than the residual."""
    loads = 1e-300
    for k in range(places.push.shape[0]):
        loads += abs(places.push[k, 0])
    return min(max(math.sqrt(0.003 * residual / loads), TIGHT), LOOSE)


@inlined
def changed_status(before, behind, but):
    """First pad, ``but`` one, that carries in one of two states only, or -1."""
    for k in range(before.size):
        if k != but and (before[k] == LOADED) != (behind[k] == LOADED):
            return k
    return -1


@inner
def hold_at_limit(axial, pads, grid, film, lines, k, load_x, load_y, x, y, floor, places, total):
    """Journal that keeps pad k at its limit and rests along the pad: x, y, and a second pad at its limit or -1.

    At the limit a pad carries what it can or nothing. Along tau the others decide, where a second one may jump as
    well; that minimises the same convex potential on its edge. ``x``, ``y`` is where pad k just carries.
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
            before[:] = places.status
        else:
            right = at
            behind[:] = places.status
        if right - left < SIDEWAYS:
            return x - s * at, y + c * at, changed_status(before, behind, k)
        step = along / stiff if stiff > 0.0 else math.copysign(0.1, along)
        step *= longest_step(pads, places, -s * step, c * step)
        new = at + step
        if not left < new < right:
            new = 0.5 * (left + right)
        at = new
    return x - s * at, y + c * at, -1


@inner
def load_at_limit(axial, pads, grid, film, lines, k, x, y, places):
    """Load of pad k at its limit, for a journal ``BESIDE`` of it: the load grows with the root of the distance."""
    near = -places.push[k, 0]
    way = 3.0 * BESIDE
    place_pad(axial, pads, grid, k, film, lines, x + way * pads.cosine[k], y + way * pads.sine[k], TIGHT, places)
    far = -places.push[k, 0]
    place_pad(axial, pads, grid, k, film, lines, x, y, TIGHT, places)
    return max(2.0 * near - far, 0.0)


@inlined
def way_from_limit(need, near, limit):
    """How far to move from ``BESIDE`` of a limit for the load that a pad needs."""
    if need <= limit:
        return -2.0 * BESIDE
    return (min((need - limit) / max(near - limit, 1e-300), 10.0) ** 2 - 1.0) * BESIDE


@inner
def needs_at_limit(axial, pads, grid, film, lines, first, second, load_x, load_y, x, y, places, total):
    """What one or two pads at their limits would have to carry, and what they carry at least: fills ``total[6:]``.

    Returns a place beside the limits where the pads carry what they should, if they can.
    """
    c, s = pads.cosine[first], pads.sine[first]
    if second < 0:
        place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
        near = -places.push[first, 0]
        need = (total[0] + load_x) * c + (total[1] + load_y) * s + near
        limit = load_at_limit(axial, pads, grid, film, lines, first, x, y, places)
        total[6], total[7], total[8], total[9] = first, need, limit, -1.0
        way = way_from_limit(need, near, limit)
        return x + way * c, y + way * s
    c2, s2 = pads.cosine[second], pads.sine[second]
    share = BESIDE / max(1.0 + c * c2 + s * s2, 1e-3)
    x, y = x + share * (c + c2), y + share * (s + s2)  # both carry
    place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    near, near_2 = -places.push[first, 0], -places.push[second, 0]
    rx = total[0] + load_x + near * c + near_2 * c2
    ry = total[1] + load_y + near * s + near_2 * s2
    det = c * s2 - s * c2
    need, need_2 = (rx * s2 - ry * c2) / det, (ry * c - rx * s) / det
    limit = load_at_limit(axial, pads, grid, film, lines, first, x, y, places)
    limit_2 = load_at_limit(axial, pads, grid, film, lines, second, x, y, places)
    total[6], total[7], total[8], total[9], total[10], total[11] = first, need, limit, second, need_2, limit_2
    way, way_2 = way_from_limit(need, near, limit), way_from_limit(need_2, near_2, limit_2)
    return x + (way * s2 - way_2 * s) / det, y + (way_2 * c - way * c2) / det


@inner
def pad_beside_limit(axial, pads, grid, film, lines, x, y, places):
    """First pad that gains or loses its load within ``BESIDE`` of a place of the journal, or -1."""
    for k in range(pads.kappa.size):
        carries = places.status[k] == LOADED
        way = -BESIDE if carries else BESIDE
        place_pad(
            axial, pads, grid, k, film, lines, x + way * pads.cosine[k], y + way * pads.sine[k], TIGHT, places
        )
        if (places.status[k] == LOADED) != carries:
            return k
    return -1


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
                status = CONVERGED
                break
            tilts = TIGHT
            place_all(axial, pads, grid, film, lines, x, y, tilts, places, total)
            continue
        tilts = TIGHT if tight else allowed_moment(places, size)
        dx, dy, indifferent = journal_step(total, rx, ry)
        share = longest_step(pads, places, dx, dy)
        drive = rx * dx + ry * dy
        statuses[:] = places.status
        jumped = -1
        while True:
            new_x, new_y = x + share * dx, y + share * dy
            is_open = place_all(axial, pads, grid, film, lines, new_x, new_y, tilts, places, total)
            opposed = -((total[0] + load_x) * dx + (total[1] + load_y) * dy)
            jumped = changed_status(places.status, statuses, -1)
            if is_open and opposed <= (OVERSHOOT if jumped < 0 else UNEVEN) * drive:
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
        if jumped < 0:
            jumped = pad_beside_limit(axial, pads, grid, film, lines, x, y, places)
        if jumped < 0 or held > MOST_HELD:
            status = STUCK
            break
        c, s = pads.cosine[jumped], pads.sine[jumped]
        x, y, second = hold_at_limit(
            axial, pads, grid, film, lines, jumped, load_x, load_y, x + BESIDE * c, y + BESIDE * s, 0.1 * floor,
            places, total,
        )  # fmt: skip
        x, y = needs_at_limit(axial, pads, grid, film, lines, jumped, second, load_x, load_y, x, y, places, total)
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


@compiled
def pads_at(axial, pads, intervals, x, y, places, total):
    """Pads for a journal at (x, y): whether every pad has a film, and the grid; fills ``total`` (F 2, K 4)."""
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    is_open = place_all(axial, pads, grid, film, lines, x, y, TIGHT, places, total)
    return is_open, grid


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


@compiled
def find_fold(axial, pads, intervals, k, loaded, lowest, width, places):
    """Smallest e at which pad k, free to tilt, has an equilibrium, by bisection between two e.

    Returns e, the load there, and eta; minus infinity where the pad carries still at ``lowest``.
    """
    grid = pad_grid(pads, intervals, len(axial.size))
    film, lines = new_film(intervals), new_lines(intervals, len(axial.size))
    eta, status = find_tilt(axial, pads, grid, k, film, lines, lowest, 0.0, np.nan, CLOSER, places)
    if status == LOADED:
        return -np.inf, -places.answers[k, 0], eta
    low, high, load, best, guess = lowest, loaded, 0.0, 0.0, np.nan
    while high - low > width:
        e = 0.5 * (low + high)
        eta, status = find_tilt(axial, pads, grid, k, film, lines, e, 0.0, guess, 1e-5, places)
        if status == LOADED:
            high, load, best, guess = e, -places.answers[k, 0], eta, eta
        else:
            low = e
    return high, load, best
