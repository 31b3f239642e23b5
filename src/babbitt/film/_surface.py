"""Kernels for lines that differ across the width: pockets, holes, tilt, steps, viscosity along the axis, full rings.

Same equations as ``_elimination`` and ``_forces``; here the gap is known at every quadrature point of the width, nodes may
be held at a pressure (grooves, pockets, side edges), and the first line may follow the last (cyclic). Row of node j:

    sum_q w_q [Q_i - Q_i-1 + S_i + T_i (p_i - p_i+1) - T_i-1 (p_i-1 - p_i)]_q
        + kappa sum_q D_qj w_q H_iq sum_k D_qk p_k = 0          (q: quadrature points that fall on node j)

with D the derivative at the points and w their share of the width. Journal motions d: x, y and, on request, the tilts,
dh = -shape_d, with shapes cos, sin, zeta cos, zeta sin.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import bool_, float64, int64
from numpy.typing import NDArray

from babbitt.film._grids import FAR, GAUSS, NEAR
from babbitt.film._structs import compiled, inlined

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
        np.empty((d, n, nodes)), np.empty((d, lines, points)), np.empty((lines, nodes)), np.empty((d, lines, nodes)),
        np.empty((n, nodes)), np.empty((d, n, nodes)),
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


@compiled
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


@compiled
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


@compiled
def couple_lines(surface, film, work):
    """Kind of every node, and the diagonal coupling between each line and the line before it."""
    lines, nodes = surface.held.shape
    for i in range(lines):
        for j in range(nodes):
            held, wet = surface.held[i, j], work.wet[i, j]
            work.holds[i, j] = held or wet
            work.counts[i, j] = not held and (wet or surface.conserving)
    for i in range(lines):
        before, interval = (i - 1) % lines, (i - 1) % surface.step.size
        for j in range(nodes):
            t = film.conductance[interval, j]
            lower, upper = 0.0, 0.0
            if work.counts[i, j]:
                if not work.holds[before, j]:
                    lower = film.couette[interval, j]
                elif work.wet[i, j] or not surface.held[before, j]:
                    lower = -t
            if work.counts[before, j] and work.holds[i, j]:
                upper = -t
            work.lower[i, j], work.upper[i, j] = lower, upper


@compiled
def fill_lines(surface, film, work):
    """Diagonal block and right-hand sides (pressure, adjoints) of every line, into ``inverse`` and ``swept``."""
    lines, nodes = surface.held.shape
    block, right = work.inverse, work.swept
    block[:] = 0.0
    right[:] = 0.0
    for i in range(lines):
        before = (i - 1) % lines
        interval = (i - 1) % surface.step.size
        active = False
        for a in range(nodes):
            if work.counts[i, a]:
                active = True
        if active:
            for q in range(surface.zeta.size):
                conduct = surface.kappa * surface.share[q] * film.cubed[i, q]
                for a in range(nodes):
                    part = conduct * surface.slope[q, a]
                    if work.counts[i, a] and part != 0.0:
                        for b in range(nodes):
                            if work.holds[i, b]:
                                block[i, a, b] += part * surface.slope[q, b]
        for a in range(nodes):
            if not work.counts[i, a]:
                block[i, a, a] = 1.0
                right[0, i, a] = surface.held_pressure[i, a] if surface.held[i, a] else 0.0
                continue
            entering = film.couette[interval, a]
            if surface.held[before, a] and not work.holds[i, a]:
                entering = film.inlet[interval, a]  # a ruptured line takes from a held node what the gap lets in
            right[0, i, a] = entering - film.couette[i, a] - film.squeeze[i, a]
            if work.wet[i, a]:
                block[i, a, a] += film.conductance[interval, a] + film.conductance[i, a] + work.ending[i, a]
                for d in range(surface.motions):
                    right[1 + d, i, a] = -film.load[d, i, a]
            else:
                block[i, a, a] = -(film.couette[i, a] + film.squeeze[i, a])


@compiled
def solve_surface(surface, film, work):
    """Pressure (or void) and the adjoints of the forces, with the wet set as it stands."""
    couple_lines(surface, film, work)
    fill_lines(surface, film, work)
    eliminate(surface, work)
    if surface.cyclic:
        close_ring(surface, film, work)
    else:
        back_sweep(surface, work, 0)


@compiled
def eliminate(surface, work):
    """Forward sweep over the lines (from line 1 in a ring): S_i = D_i - L_i S_i-1^-1 U_i, inverted in place."""
    lines, nodes = work.wet.shape
    first = 1 if surface.cyclic else 0
    block, right = work.inverse, work.swept
    motions = right.shape[0] - 1
    for i in range(first, lines):
        if i > first:
            for a in range(nodes):
                low, up = work.lower[i, a], work.upper[i, a]
                if low != 0.0:
                    total = 0.0
                    for b in range(nodes):
                        block[i, a, b] -= low * block[i - 1, a, b] * work.upper[i, b]
                        total += block[i - 1, a, b] * right[0, i - 1, b]
                    right[0, i, a] -= low * total
                if up != 0.0:
                    for d in range(1, 1 + motions):
                        total = 0.0
                        for b in range(nodes):
                            total += block[i - 1, b, a] * right[d, i - 1, b]
                        right[d, i, a] -= up * total
        invert_line(block, i)


@inlined
def invert_line(blocks, i):
    """Inverse of block i in place, Gauss-Jordan without pivoting; rows of identity cost nothing."""
    m = blocks.shape[1]
    for c in range(m):
        pivot = 1.0 / blocks[i, c, c]
        blocks[i, c, c] = 1.0
        for b in range(m):
            blocks[i, c, b] *= pivot
        for a in range(m):
            factor = blocks[i, a, c]
            if a != c and factor != 0.0:
                blocks[i, a, c] = 0.0
                for b in range(m):
                    blocks[i, a, b] -= factor * blocks[i, c, b]


@compiled
def back_sweep(surface, work, first):
    """Back substitution of all right-hand sides from the last line to ``first``."""
    lines, nodes = surface.held.shape
    inverse, swept, solution = work.inverse, work.swept, work.solution
    for i in range(lines - 1, first - 1, -1):
        for r in range(1 + surface.motions):
            if i < lines - 1:
                for b in range(nodes):
                    link = work.upper[i + 1, b] if r == 0 else work.lower[i + 1, b]
                    swept[r, i, b] -= link * solution[r, i + 1, b]
            for a in range(nodes):
                total = 0.0
                for b in range(nodes):
                    total += (inverse[i, a, b] if r == 0 else inverse[i, b, a]) * swept[r, i, b]
                solution[r, i, a] = total


@compiled
def close_ring(surface, film, work):
    """Solve the cyclic system by a border: line 0 is unknown, all others answer to it.

    With B the block tridiagonal matrix of the lines 1.., c and r the coupling column and row of line 0,
    V = B^-1 c:   (D_0 - r V) z = b_0 - r B^-1 b,  u = B^-1 b - V z; the adjoint uses the transposes.
    """
    lines, nodes = surface.held.shape
    last = lines - 1
    back_sweep(surface, work, 1)  # B^-1 b and B^-T g
    v = work.border
    v[:] = 0.0
    for a in range(nodes):  # column of line 0: rows of line 1 and of the last line
        v[1, a, a] += work.lower[1, a]
        v[last, a, a] += work.upper[0, a]
    for i in range(2, lines):
        carried = work.inverse[i - 1] @ v[i - 1]
        for a in range(nodes):
            for b in range(nodes):
                v[i, a, b] -= work.lower[i, a] * carried[a, b]
    for i in range(last, 0, -1):
        if i < last:
            for a in range(nodes):
                for b in range(nodes):
                    v[i, a, b] -= work.upper[i + 1, a] * v[i + 1, a, b]
        v[i] = work.inverse[i] @ v[i]
    schur, right = work.inverse[0], work.swept[:, 0, :].copy()
    for a in range(nodes):
        for b in range(nodes):
            schur[a, b] -= work.upper[1, a] * v[1, a, b] + work.lower[0, a] * v[last, a, b]
    invert_line(work.inverse, 0)
    # pressure
    for a in range(nodes):
        right[0, a] -= work.upper[1, a] * work.solution[0, 1, a] + work.lower[0, a] * work.solution[0, last, a]
    ring = schur @ right[0]
    work.solution[0, 0, :] = ring
    for i in range(1, lines):
        work.solution[0, i, :] -= v[i] @ ring
    # adjoints: zeta = G^-T (g_0 - V^T g), then B^-T (g - r^T zeta)
    for d in range(surface.motions):
        for i in range(1, lines):
            for a in range(nodes):
                g = -film.load[d, i, a] if work.counts[i, a] and work.wet[i, a] else 0.0
                for b in range(nodes):
                    right[1 + d, b] -= v[i, a, b] * g
        work.solution[1 + d, 0, :] = schur.T @ right[1 + d]
    for i in range(1, lines):
        for d in range(surface.motions):
            for a in range(nodes):
                g = -film.load[d, i, a] if work.counts[i, a] and work.wet[i, a] else 0.0
                if i == 1:
                    g -= work.upper[1, a] * work.solution[1 + d, 0, a]
                if i == last:
                    g -= work.lower[0, a] * work.solution[1 + d, 0, a]
                if i > 1:
                    total = 0.0
                    for b in range(nodes):
                        total += work.inverse[i - 1, b, a] * work.swept[1 + d, i - 1, b]
                    g -= work.upper[i, a] * total
                work.swept[1 + d, i, a] = g
    for i in range(last, 0, -1):
        for d in range(surface.motions):
            if i < last:
                for b in range(nodes):
                    work.swept[1 + d, i, b] -= work.lower[i + 1, b] * work.solution[1 + d, i + 1, b]
            work.solution[1 + d, i, :] = work.inverse[i].T @ work.swept[1 + d, i]
