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

from babbitt.film._structs import (
    CENTRE_X,
    CENTRE_Y,
    CLEARANCE,
    END,
    START,
    START_PRESSURE,
    Film,
    Grid,
    Lines,
    compiled,
)

GAUSS = 0.5 / math.sqrt(3.0)  # distance of a Gauss point from the middle, in intervals
NEAR, FAR = 0.5 + GAUSS, 0.5 - GAUSS  # value of the hat function at the nearer and the farther Gauss point


@compiled
def new_grids(lands, n):
    """Grids of several lands with n intervals each, not filled yet: every array has a leading axis of lands."""
    node, cell = (lands, n + 1), (lands, n)
    return Grid(
        np.empty(node), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell),
        np.empty(cell), np.empty(cell), np.empty(node), np.empty(node),
    )  # fmt: skip


@compiled
def grid_of(grids, k):
    """Grid of land k."""
    return Grid(
        grids.theta[k], grids.step[k], grids.cos_a[k], grids.sin_a[k], grids.cos_b[k], grids.sin_b[k],
        grids.gap_a[k], grids.gap_b[k], grids.weight_x[k], grids.weight_y[k],
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
    """Fully wet lines of a land with n intervals and m axial unknowns."""
    return Lines(
        np.ones((n + 1, m), np.bool_), np.zeros(n + 1, np.int64), np.zeros((n + 1, m)), np.zeros((n + 1, 3, m)),
        np.empty((n + 1, m)), np.empty((n + 1, m, m)),
        np.zeros((n + 1, m)), np.zeros((n + 1, m)), np.zeros((n + 1, 3, m)), np.empty((n + 1, 3, m)),
    )  # fmt: skip


@compiled
def lines_with(lines, wet):
    """The same workspace with another wet set."""
    return Lines(
        wet, lines.wet_count, lines.ending, lines.solution, lines.pivot, lines.inverse, lines.lower, lines.upper, lines.swept,
        lines.modal,
    )  # fmt: skip


@compiled
def profile_at(land, profile, theta):
    """Departure of the bore from its circle at an angle: linear between equally spaced samples of the land."""
    last = profile.shape[0] - 1
    if last < 1:
        return 0.0
    place = (theta - land[START]) / (land[END] - land[START]) * last
    k = min(max(int(place), 0), last - 1)
    return profile[k] + (place - k) * (profile[k + 1] - profile[k])


@compiled
def uniform_lines(land, grid):
    """Equally spaced lines over the land."""
    n = grid.step.size
    for i in range(n + 1):
        grid.theta[i] = land[START] + (land[END] - land[START]) * i / n


@compiled
def graded_lines(land, coarse, x, y, exponent, crowd, grid):
    """Lines with a density proportional to crowd * h^-exponent, both known on the intervals of a coarse grid.

    ``crowd`` (one number per coarse interval) draws lines to the rupture. The cumulated density is linear
    over a coarse interval and is inverted exactly.
    """
    cells, n = coarse.step.size, grid.step.size
    total = 0.0
    density = np.empty(cells)
    for k in range(cells):
        h = 0.5 * (coarse.gap_a[k] + coarse.gap_b[k])
        h -= 0.5 * (x * (coarse.cos_a[k] + coarse.cos_b[k]) + y * (coarse.sin_a[k] + coarse.sin_b[k]))
        density[k] = crowd[k] * max(h, 1e-6) ** (-exponent)
        total += density[k] * coarse.step[k]
    k, passed = 0, 0.0
    for i in range(n + 1):
        wanted = total * i / n
        while k < cells - 1 and passed + density[k] * coarse.step[k] < wanted:
            passed += density[k] * coarse.step[k]
            k += 1
        grid.theta[i] = coarse.theta[k] + (wanted - passed) / density[k]
    grid.theta[0], grid.theta[n] = land[START], land[END]


@compiled
def fill_grid(land, profile, grid):
    """Steps, trigonometry, gap of the centred journal and load weights of the lines already placed."""
    n = grid.step.size
    for i in range(n):
        step = grid.theta[i + 1] - grid.theta[i]
        grid.step[i] = step
        # cosine and sine at the middle, then by addition theorem to the Gauss points (offset below 0.1 rad)
        middle = 0.5 * (grid.theta[i] + grid.theta[i + 1])
        c, s = math.cos(middle), math.sin(middle)
        offset = GAUSS * step
        cd, sd = math.cos(offset), math.sin(offset)
        grid.cos_a[i], grid.cos_b[i] = c * cd + s * sd, c * cd - s * sd
        grid.sin_a[i], grid.sin_b[i] = s * cd - c * sd, s * cd + c * sd
        grid.gap_a[i] = land[CLEARANCE] + land[CENTRE_X] * grid.cos_a[i] + land[CENTRE_Y] * grid.sin_a[i]
        grid.gap_b[i] = land[CLEARANCE] + land[CENTRE_X] * grid.cos_b[i] + land[CENTRE_Y] * grid.sin_b[i]
        if profile.size > 1:
            grid.gap_a[i] += profile_at(land, profile, middle - offset)
            grid.gap_b[i] += profile_at(land, profile, middle + offset)
    grid.weight_x[:] = 0.0
    grid.weight_y[:] = 0.0
    for i in range(n):
        half = 0.5 * grid.step[i]
        grid.weight_x[i] += half * (NEAR * grid.cos_a[i] + FAR * grid.cos_b[i])
        grid.weight_y[i] += half * (NEAR * grid.sin_a[i] + FAR * grid.sin_b[i])
        grid.weight_x[i + 1] += half * (FAR * grid.cos_a[i] + NEAR * grid.cos_b[i])
        grid.weight_y[i + 1] += half * (FAR * grid.sin_a[i] + NEAR * grid.sin_b[i])


@compiled
def smallest_gap(grid, x, y):
    """Smallest gap at the Gauss points of a land."""
    smallest = np.inf
    for i in range(grid.step.size):
        a = grid.gap_a[i] - x * grid.cos_a[i] - y * grid.sin_a[i]
        b = grid.gap_b[i] - x * grid.cos_b[i] - y * grid.sin_b[i]
        smallest = min(smallest, min(a, b))
    return smallest


@compiled
def film_coefficients(land, grid, speed, x, y, x_rate, y_rate, film):
    """Coefficients of the film at a journal position and velocity; ``speed`` is 1, or 0 for a journal at rest."""
    n = grid.step.size
    film.cubed[:] = 0.0
    film.cubed_x[:] = 0.0
    film.cubed_y[:] = 0.0
    for i in range(n):
        half = 0.5 * grid.step[i]
        ca, sa, cb, sb = grid.cos_a[i], grid.sin_a[i], grid.cos_b[i], grid.sin_b[i]
        ha = grid.gap_a[i] - x * ca - y * sa
        hb = grid.gap_b[i] - x * cb - y * sb
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
        film.squeeze[i] = -(x_rate * grid.weight_x[i] + y_rate * grid.weight_y[i])
    inlet_flux(land, grid, speed, x, y, film)


@compiled
def inlet_flux(land, grid, speed, x, y, film):
    """Flux that enters a line which ruptures inside its first interval, and its derivatives.

    A flooded groove at pressure p_s before a diverging gap h_0 + g t keeps the film full up to the length
    l with p_s = 3 g l^2 / h_0^3 (first order in l), and sends off q = (h_0 + g l) / 2. For p_s = 0 that is h_0/2;
    the face value Q_0 there would make the whole mass-conserving solution first order.
    """
    c, s = math.cos(grid.theta[0]), math.sin(grid.theta[0])
    middle_gap = 0.5 * (grid.gap_a[0] + grid.gap_b[0])
    growth = (grid.gap_b[0] - grid.gap_a[0]) / (2.0 * GAUSS * grid.step[0])
    gap = middle_gap - 0.5 * growth * grid.step[0] - x * c - y * s
    slope = growth + x * s - y * c
    film.inlet[0] = 0.5 * gap * speed
    film.inlet[1] = -0.5 * c * speed
    film.inlet[2] = -0.5 * s * speed
    pressure = land[START_PRESSURE]
    if pressure > 0.0 and slope > 1e-12 and speed > 0.0:
        # growth of the gap up to the rupture: g l = sqrt(p_s h0^3 g / 3), p_s counted for unit speed
        extra = math.sqrt(pressure / speed * gap**3 * slope / 3.0)
        if extra > slope * grid.step[0]:
            extra = slope * grid.step[0]
            film.inlet[1] += 0.5 * speed * s * grid.step[0]
            film.inlet[2] -= 0.5 * speed * c * grid.step[0]
        else:
            film.inlet[1] += 0.25 * speed * extra * (-3.0 * c / gap + s / slope)
            film.inlet[2] += 0.25 * speed * extra * (-3.0 * s / gap - c / slope)
        film.inlet[0] += 0.5 * speed * extra
