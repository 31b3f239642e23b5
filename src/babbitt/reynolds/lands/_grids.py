"""Kernels: lines of a land, graded where the film is thin, and the film coefficients on them.

Exact-flux finite volumes. Between two lines the circumferential flux q of
    q = h/2 - h^3/12 dp/dtheta
is taken constant, so that the pressure drop integrates exactly (J_k = int h^-k d theta over the interval):
    q_i = Q_i + T_i (p_i - p_i+1),   T_i = 1/(12 J_3),   Q_i = J_2/(2 J_3).
Integrals by two Gauss points. The scheme is nodally exact where no oil leaves sideways, second order otherwise.
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds._structs import (
    CENTRE_X,
    CENTRE_Y,
    CLEARANCE,
    END,
    START,
    START_PRESSURE,
    Film,
    Grid,
    Lines,
)

GAUSS = 0.5 / math.sqrt(3.0)  # distance of a Gauss point from the middle, in intervals
NEAR, FAR = 0.5 + GAUSS, 0.5 - GAUSS  # value of the hat function at the nearer and the farther Gauss point


@compiled
def new_grid(lands, n, m):
    """Grid of several lands with n intervals each, not filled yet, all nodes wet."""
    node, cell = (lands, n + 1), (lands, n)
    return Grid(
        np.empty(node), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell),
        np.empty(cell), np.empty(cell), np.empty(node), np.empty(node), np.ones((lands, n + 1, m), np.bool_),
        np.zeros((lands, n + 1, m)),
    )  # fmt: skip


@compiled
def new_film(n):
    """Film coefficients of n intervals, not filled yet."""
    node, cell = n + 1, n
    return Film(
        np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell),
        np.empty(node), np.empty(node), np.empty(node), np.empty(node), np.empty(3),
    )  # fmt: skip


@compiled
def new_lines(n, m):
    """Workspace of a land with n intervals and m axial unknowns."""
    return Lines(
        np.zeros(n + 1, np.int64), np.ones((n + 1, m)), np.ones((n + 1, m)), np.full((n + 1, m), 0.5),
        np.zeros((n + 1, 3, m)), np.empty((n + 1, m)),
        np.empty((n + 1, m, m)), np.zeros((n + 1, m)), np.zeros((n + 1, m)),
        np.zeros((n + 1, 3, m)), np.empty((n + 1, 3, m)),
    )  # fmt: skip


@inlined
def intervals_of(bearing, n):
    """Intervals of every land for n over half a turn: a land that is longer gets more in proportion."""
    longest = math.pi
    for k in range(bearing.lands.shape[0]):
        longest = max(longest, bearing.lands[k, END] - bearing.lands[k, START])
    return math.ceil(n * longest / math.pi - 1e-9)


@inlined
def profile_at(bearing, k, theta):
    """Departure of the bore from its circle at an angle: linear between equally spaced samples of the land."""
    last = bearing.profiles.shape[1] - 1
    if last < 1:
        return 0.0
    start, end = bearing.lands[k, START], bearing.lands[k, END]
    place = (theta - start) / (end - start) * last
    s = min(max(int(place), 0), last - 1)
    return bearing.profiles[k, s] + (place - s) * (bearing.profiles[k, s + 1] - bearing.profiles[k, s])


@compiled
def uniform_lines(bearing, grid):
    """Equally spaced lines over every land."""
    n = grid.step.shape[1]
    for k in range(bearing.lands.shape[0]):
        start, end = bearing.lands[k, START], bearing.lands[k, END]
        for i in range(n + 1):
            grid.theta[k, i] = start + (end - start) * i / n
    fill_grid(bearing, grid)


@inner
def graded_lines(bearing, coarse, x, y, grid):
    """Lines with a density proportional to crowding * h^-exponent, both known on the intervals of a coarse grid.

    The deeper the journal, the larger the exponent; the crowding draws lines to the rupture. The cumulated
    density is linear over a coarse interval and is inverted exactly. A fine node is wet if one of the coarse nodes
    beside it is: too many wet nodes cost one update of the wet set, too few cost one update a line.
    """
    cells, n, m = coarse.step.shape[1], grid.step.shape[1], grid.wet.shape[2]
    depth = min(max(0.0, 1.0 - smallest_gap(coarse, x, y)), 1.0)
    exponent = 0.8 * depth**4
    density = np.empty(cells)
    for k in range(bearing.lands.shape[0]):
        total = 0.0
        for i in range(cells):
            h = coarse.gap_a[k, i] - x * coarse.cos_a[k, i] - y * coarse.sin_a[k, i]
            h += coarse.gap_b[k, i] - x * coarse.cos_b[k, i] - y * coarse.sin_b[k, i]
            density[i] = max(0.5 * h, 1e-6) ** -exponent
            if bearing.crowding != 1.0:
                for j in range(m):
                    if coarse.wet[k, i, j] != coarse.wet[k, i + 1, j]:
                        density[i] *= bearing.crowding
                        break
            total += density[i] * coarse.step[k, i]
        c, passed = 0, 0.0
        for i in range(n + 1):
            wanted = total * i / n
            while c < cells - 1 and passed + density[c] * coarse.step[k, c] < wanted:
                passed += density[c] * coarse.step[k, c]
                c += 1
            grid.theta[k, i] = coarse.theta[k, c] + (wanted - passed) / density[c]
            before, behind = max(c, 1), min(c + 1, cells - 1)  # the edges of the land tell nothing
            for j in range(m):
                grid.wet[k, i, j] = coarse.wet[k, before, j] or coarse.wet[k, behind, j]
        grid.wet[k, 0, :] = grid.wet[k, n, :] = True
        grid.theta[k, 0], grid.theta[k, n] = bearing.lands[k, START], bearing.lands[k, END]
    fill_grid(bearing, grid)


@inner
def fill_grid(bearing, grid):
    """Steps, trigonometry, gap of the centred journal and load weights of the lines already placed."""
    n = grid.step.shape[1]
    grid.weight_x[:] = 0.0
    grid.weight_y[:] = 0.0
    for k in range(bearing.lands.shape[0]):
        clearance = bearing.lands[k, CLEARANCE]
        centre_x, centre_y = bearing.lands[k, CENTRE_X], bearing.lands[k, CENTRE_Y]
        for i in range(n):
            step = grid.theta[k, i + 1] - grid.theta[k, i]
            middle = 0.5 * (grid.theta[k, i] + grid.theta[k, i + 1])
            offset = GAUSS * step
            # from the middle to the Gauss points by the addition theorem; the series is exact below 0.2 rad
            c, s = math.cos(middle), math.sin(middle)
            d2 = offset * offset
            cd = 1.0 - d2 * (0.5 - d2 * (1.0 / 24.0 - d2 * (1.0 / 720.0 - d2 * (1.0 / 40320.0 - d2 / 3628800.0))))
            sd = offset * (1.0 - d2 * (1.0 / 6.0 - d2 * (1.0 / 120.0 - d2 * (1.0 / 5040.0 - d2 / 362880.0))))
            ca, cb = c * cd + s * sd, c * cd - s * sd
            sa, sb = s * cd - c * sd, s * cd + c * sd
            grid.step[k, i] = step
            grid.cos_a[k, i], grid.cos_b[k, i], grid.sin_a[k, i], grid.sin_b[k, i] = ca, cb, sa, sb
            gap_a = clearance + centre_x * ca + centre_y * sa
            gap_b = clearance + centre_x * cb + centre_y * sb
            if bearing.profiles.shape[1] > 1:
                gap_a += profile_at(bearing, k, middle - offset)
                gap_b += profile_at(bearing, k, middle + offset)
            grid.gap_a[k, i], grid.gap_b[k, i] = gap_a, gap_b
            half = 0.5 * step
            grid.weight_x[k, i] += half * (NEAR * ca + FAR * cb)
            grid.weight_y[k, i] += half * (NEAR * sa + FAR * sb)
            grid.weight_x[k, i + 1] += half * (FAR * ca + NEAR * cb)
            grid.weight_y[k, i + 1] += half * (FAR * sa + NEAR * sb)


@inlined
def smallest_gap(grid, x, y):
    """Smallest gap at the Gauss points of all lands."""
    smallest = np.inf
    for k in range(grid.step.shape[0]):
        for i in range(grid.step.shape[1]):
            a = grid.gap_a[k, i] - x * grid.cos_a[k, i] - y * grid.sin_a[k, i]
            b = grid.gap_b[k, i] - x * grid.cos_b[k, i] - y * grid.sin_b[k, i]
            smallest = min(smallest, min(a, b))
    return smallest


@inlined
def film_coefficients(bearing, grid, k, x, y, x_rate, y_rate, film):
    """Coefficients of the film at a journal position and velocity, on land k."""
    n, speed = film.conductance.size, bearing.speed
    film.cubed[:] = 0.0
    film.cubed_x[:] = 0.0
    film.cubed_y[:] = 0.0
    for i in range(n):
        half = 0.5 * grid.step[k, i]
        ca, sa, cb, sb = grid.cos_a[k, i], grid.sin_a[k, i], grid.cos_b[k, i], grid.sin_b[k, i]
        ha = grid.gap_a[k, i] - x * ca - y * sa
        hb = grid.gap_b[k, i] - x * cb - y * sb
        va, vb = 1.0 / ha, 1.0 / hb
        a2, b2 = va * va, vb * vb
        a3, b3 = a2 * va, b2 * vb
        a4, b4 = a2 * a2, b2 * b2
        per_j3 = 1.0 / (a3 + b3)  # the factor step/2 of the integrals is put in where it does not cancel
        conductance = per_j3 / (12.0 * half)
        couette = 0.5 * speed * (a2 + b2) * per_j3
        # dh/dx = -cos: dJ2 = 2 int cos/h^3, dJ3 = 3 int cos/h^4
        j3_x = 3.0 * (ca * a4 + cb * b4) * per_j3
        j3_y = 3.0 * (sa * a4 + sb * b4) * per_j3
        film.conductance[i] = conductance
        film.conductance_x[i] = -conductance * j3_x
        film.conductance_y[i] = -conductance * j3_y
        film.couette[i] = couette
        film.couette_x[i] = speed * (ca * a3 + cb * b3) * per_j3 - couette * j3_x
        film.couette_y[i] = speed * (sa * a3 + sb * b3) * per_j3 - couette * j3_y
        ha2, hb2 = half * ha * ha, half * hb * hb
        film.cubed[i] += NEAR * ha2 * ha + FAR * hb2 * hb
        film.cubed[i + 1] += FAR * ha2 * ha + NEAR * hb2 * hb
        film.cubed_x[i] -= 3.0 * (NEAR * ha2 * ca + FAR * hb2 * cb)
        film.cubed_x[i + 1] -= 3.0 * (FAR * ha2 * ca + NEAR * hb2 * cb)
        film.cubed_y[i] -= 3.0 * (NEAR * ha2 * sa + FAR * hb2 * sb)
        film.cubed_y[i + 1] -= 3.0 * (FAR * ha2 * sa + NEAR * hb2 * sb)
    for i in range(n + 1):
        film.squeeze[i] = -(x_rate * grid.weight_x[k, i] + y_rate * grid.weight_y[k, i])
    inlet_flux(bearing, grid, k, x, y, film)
    # In a gap that converges while it opens, h/2 at the groove is more than a full first line gets, which would
    # be full if dry and dry if full: no film at all. A journal at rest never has that.
    pressure = bearing.lands[k, START_PRESSURE]
    full = film.couette[0] + film.conductance[0] * pressure
    if film.inlet[0] > full:
        film.inlet[0] = full
        film.inlet[1] = film.couette_x[0] + film.conductance_x[0] * pressure
        film.inlet[2] = film.couette_y[0] + film.conductance_y[0] * pressure


@inlined
def growth_to_rupture(gap, rise, resistance):
    """Growth of the gap from a flooded line to where the film ruptures, and its derivatives in gap and rise.

    A supply at pressure p_s before a diverging gap h_0 + g t keeps the film full up to the length l with
    p_s = 3 mu r^2 g l^2 / h_0^3 at unit speed (first order in l). ``rise`` is g times the interval s;
    ``resistance`` is 3 mu r^2 s over p_s. Returns g l. Where this is more than ``rise``, the next line receives
    more than its gap carries, and is filled: held back to ``rise`` it would stay dry, whatever the pressure.
    """
    growth = math.sqrt(gap**3 * rise / resistance)
    return growth, 1.5 * growth / gap, 0.5 * growth / rise


@inlined
def inlet_flux(bearing, grid, k, x, y, film):
    """Flux that enters a line which ruptures inside its first interval, and its derivatives.

    What a flooded groove sends off, (h_0 + g l) / 2 (``growth_to_rupture``); h_0/2 for p_s = 0. The face value Q_0
    there would make the whole mass-conserving solution first order.
    """
    speed, pressure, step = bearing.speed, bearing.lands[k, START_PRESSURE], grid.step[k, 0]
    c, s = math.cos(grid.theta[k, 0]), math.sin(grid.theta[k, 0])
    middle_gap = 0.5 * (grid.gap_a[k, 0] + grid.gap_b[k, 0])
    growth = (grid.gap_b[k, 0] - grid.gap_a[k, 0]) / (2.0 * GAUSS * step)
    gap = middle_gap - 0.5 * growth * step - x * c - y * s
    slope = growth + x * s - y * c
    extra, by_gap, by_rise = 0.0, 0.0, 0.0
    if pressure > 0.0 and slope > 1e-12 and speed > 0.0:
        extra, by_gap, by_rise = growth_to_rupture(gap, slope * step, 3.0 * step * speed / pressure)
    film.inlet[0] = 0.5 * speed * (gap + extra)
    film.inlet[1] = 0.5 * speed * (-c - by_gap * c + by_rise * step * s)
    film.inlet[2] = 0.5 * speed * (-s - by_gap * s - by_rise * step * c)
