"""Kernels: nodes, gaps and film coefficients of a film that differs across the width (see ``_surface``)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import bool_, float64, int64
from numpy.typing import NDArray

from babbitt.film._compiling import compiled, inner
from babbitt.film._grids import FAR, GAUSS, NEAR

Array = NDArray[float64]


class Surface(NamedTuple):
    """Nodes of one unrolled film, what is held there, and the gap of the centred journal. a, b: Gauss points."""

    step: Array  # (n,)
    trigonometry: Array  # cos_a, sin_a, cos_b, sin_b of every interval, (4, n)
    gap_a: Array  # (n, points)
    gap_b: Array
    viscosity: Array  # over the reference viscosity, (n, points)
    zeta: Array  # of the points, (points,)
    share: Array  # w_q, summing to 1, (points,)
    node: NDArray[int64]  # node on which a point falls, (points,)
    slope: Array  # D, (points, nodes)
    held: NDArray[bool_]  # nodes at given pressure, (lines, nodes); n + 1 lines, or n when cyclic
    held_pressure: Array  # (lines, nodes)
    motions: int  # 2, or 4 with tilts
    cyclic: bool
    reference: float  # pressure from which forces count: ambient above cavitation
    kappa: float
    speed: float
    conserving: bool


class SurfaceFilm(NamedTuple):
    """Coefficients on a surface and their derivatives with respect to the motions."""

    conductance: Array  # (n, nodes), summed over points with their share
    couette: Array  # (n, nodes)
    cubed: Array  # H_iq, (lines, points)
    conductance_d: Array  # (motions, n, nodes)
    couette_d: Array
    cubed_d: Array  # (motions, lines, points)
    squeeze: Array  # (lines, nodes)
    load: Array  # sum_q w_q int shape_d phi_i, (motions, lines, nodes)
    inlet: Array  # flux into a line that ruptures right behind a held node, (n, nodes)
    inlet_d: Array  # (motions, n, nodes)


class SurfaceWork(NamedTuple):
    """Wet set, solutions (pressure or void, then one adjoint per motion) and the factor of every line."""

    wet: NDArray[bool_]  # (lines, nodes)
    solution: Array  # (1 + motions, lines, nodes)
    swept: Array
    inverse: Array  # (lines, nodes, nodes)
    holds: NDArray[bool_]  # whether the column of a node stands for a pressure, (lines, nodes)
    counts: NDArray[bool_]  # whether the row of a node is a balance of flow, (lines, nodes)
    lower: Array  # (lines, nodes)
    upper: Array
    ending: Array
    pressure: Array  # zero at dry nodes, (lines, nodes)
    fill: Array  # liquid fraction, (lines, nodes)
    row: Array  # balance of every node: what flows off less what arrives, (lines, nodes)
    border: Array  # response to the values on line 0, (lines, nodes, nodes); cyclic only


@compiled
def new_surface_film(surface):
    """Coefficients for a surface, not filled yet."""
    n, lines = surface.step.size, surface.held.shape[0]
    nodes, points, d = surface.held.shape[1], surface.zeta.size, surface.motions
    return SurfaceFilm(
        np.empty((n, nodes)), np.empty((n, nodes)), np.empty((lines, points)), np.empty((d, n, nodes)),
        np.empty((d, n, nodes)), np.empty((d, lines, points)), np.empty((lines, nodes)),
        np.empty((d, lines, nodes)), np.empty((n, nodes)), np.empty((d, n, nodes)),
    )  # fmt: skip


@compiled
def new_surface_work(surface):
    """Workspace for a surface, all nodes wet."""
    lines, nodes = surface.held.shape
    d = 1 + surface.motions
    return SurfaceWork(
        np.ones((lines, nodes), np.bool_), np.zeros((d, lines, nodes)), np.zeros((d, lines, nodes)),
        np.zeros((lines, nodes, nodes)), np.ones((lines, nodes), np.bool_), np.ones((lines, nodes), np.bool_),
        np.zeros((lines, nodes)), np.zeros((lines, nodes)),
        np.zeros((lines, nodes)), np.zeros((lines, nodes)), np.ones((lines, nodes)), np.zeros((lines, nodes)),
        np.zeros((lines if surface.cyclic else 1, nodes, nodes)),
    )  # fmt: skip


@inner
def tilted_position(surface, at, q):
    """Where the journal axis is at a point of the width."""
    if surface.motions == 4:
        return at[0] + at[2] * surface.zeta[q], at[1] + at[3] * surface.zeta[q]
    return at[0], at[1]


@compiled
def smallest_surface_gap(surface, at):
    """Smallest gap at the Gauss points."""
    smallest = np.inf
    trig = surface.trigonometry
    for q in range(surface.zeta.size):
        x, y = tilted_position(surface, at, q)
        for i in range(surface.step.size):
            a = surface.gap_a[i, q] - x * trig[0, i] - y * trig[1, i]
            b = surface.gap_b[i, q] - x * trig[2, i] - y * trig[3, i]
            smallest = min(smallest, min(a, b))
    return smallest


@inner
def surface_coefficients(surface, at, rate, film):
    """Fill the coefficients of the film at a position and velocity."""
    n, lines = surface.step.size, surface.held.shape[0]
    for array in (film.conductance, film.couette, film.cubed, film.squeeze, film.inlet):
        array[:] = 0.0
    for array in (film.conductance_d, film.couette_d, film.cubed_d, film.load, film.inlet_d):
        array[:] = 0.0
    trig = surface.trigonometry
    for q in range(surface.zeta.size):
        j, share = surface.node[q], surface.share[q]
        x, y = tilted_position(surface, at, q)
        for i in range(n):
            half, after = 0.5 * surface.step[i], (i + 1) % lines
            ha = surface.gap_a[i, q] - x * trig[0, i] - y * trig[1, i]
            hb = surface.gap_b[i, q] - x * trig[2, i] - y * trig[3, i]
            viscosity = surface.viscosity[i, q]
            a2, b2 = 1.0 / (ha * ha), 1.0 / (hb * hb)
            j3 = a2 / ha + b2 / hb
            t = share / (12.0 * half * viscosity * j3)
            mean = 0.5 * surface.speed * (a2 + b2) / j3
            film.conductance[i, j] += t
            film.couette[i, j] += share * mean
            ha2, hb2 = half * ha * ha / viscosity, half * hb * hb / viscosity
            film.cubed[i, q] += NEAR * ha2 * ha + FAR * hb2 * hb
            film.cubed[after, q] += FAR * ha2 * ha + NEAR * hb2 * hb
            gap = ha - NEAR_END * (hb - ha)  # at the line where the interval begins
            film.inlet[i, j] += share * 0.5 * surface.speed * gap
            for d in range(surface.motions):
                lever = surface.zeta[q] if d > 1 else 1.0
                sa, sb = trig[d % 2, i] * lever, trig[2 + d % 2, i] * lever
                j3_d = 3.0 * (sa * a2 * a2 + sb * b2 * b2) / j3
                film.conductance_d[d, i, j] -= t * j3_d
                film.couette_d[d, i, j] += share * (
                    surface.speed * (sa * a2 / ha + sb * b2 / hb) / j3 - mean * j3_d
                )
                film.cubed_d[d, i, q] -= 3.0 * (NEAR * ha2 * sa + FAR * hb2 * sb)
                film.cubed_d[d, after, q] -= 3.0 * (FAR * ha2 * sa + NEAR * hb2 * sb)
                film.inlet_d[d, i, j] -= share * 0.5 * surface.speed * (sa - NEAR_END * (sb - sa))
                here, there = share * half * (NEAR * sa + FAR * sb), share * half * (FAR * sa + NEAR * sb)
                film.load[d, i, j] += here
                film.load[d, after, j] += there
                film.squeeze[i, j] -= rate[d] * here
                film.squeeze[after, j] -= rate[d] * there


NEAR_END = (0.5 - GAUSS) / (2.0 * GAUSS)  # from Gauss point a back to the line, in distances of the Gauss points
