"""Kernels for lines that differ across the width: pockets, holes, tilt, axial viscosity, full rings.

Same equations as ``_elimination`` and ``_forces``; here the gap is known at every quadrature point of the width,
nodes may be held at a pressure (grooves, pockets, side edges), and the first line may follow the last (cyclic).
Row of node j:

    sum_q w_q [Q_i - Q_i-1 + S_i + T_i (p_i - p_i+1) - T_i-1 (p_i-1 - p_i)]_q
        + kappa sum_q D_qj w_q H_iq sum_k D_qk p_k = 0          (q: quadrature points that fall on node j)

with D the derivative at the points and w their share of the width; the metric (``_surface_film``) is in the
coefficients. p is the reduced pressure where viscosity grows with pressure. Motions d change the gap by
dh = -shape_d lever_d.
"""

from __future__ import annotations

import numpy as np
from numpy import int64

from babbitt.reynolds._compiling import inlined, inner, spliced

FIVE, SEVEN = (0,) * 5, (0,) * 7
"""As long as half of a symmetric bearing has nodes on the usual grid, without and with pressure in its grooves:
the compiler unrolls loops over them."""

LOSS = 1e-13
"""Share of its oil that a streamer of a closed ring loses from line to line.

Streamers that no supply reaches could circle with any amount of oil; this lets them run dry, as time would.
"""


@inner
def couple_lines(surface, film, work):
    """Kind of every node, and the diagonal coupling between each line and the line before it."""
    lines, nodes = surface.held.shape[0], surface.nodes
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


@inner
def fill_lines(surface, film, work):
    """Diagonal block and right-hand sides (pressure, adjoints) of every line, into ``inverse`` and ``swept``."""
    lines, nodes = surface.held.shape[0], surface.nodes
    motions = surface.motions
    block, right = work.inverse, work.swept
    block[:] = 0.0
    right[:] = 0.0
    uniform = across_at_unit_gap(surface)
    for i in range(lines):
        before = (i - 1) % lines
        interval = (i - 1) % surface.step.size
        active = False
        for a in range(nodes):
            if work.counts[i, a]:
                active = True
        if active and even(surface, film, i):
            stretch = surface.kappa * film.cubed[i, 0]
            for a in range(nodes):
                if work.counts[i, a]:
                    for b in range(nodes):
                        block[i, a, b] = stretch * uniform[a, b] if work.holds[i, b] else 0.0
        elif active:
            for q in range(surface.points):
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
            if surface.held[before, a]:
                if not work.holds[i, a]:
                    entering = film.inlet[interval, a]  # a ruptured line takes from a held node what fits
                entering *= surface.held_fill[before, a]
            right[0, i, a] = entering - film.couette[i, a] - film.squeeze[i, a]
            if work.wet[i, a]:
                block[i, a, a] += film.conductance[interval, a] + film.conductance[i, a] + work.ending[i, a]
                for d in range(motions):
                    right[1 + d, i, a] = -film.load[d, i, a] * work.stiffening[i, a]
            else:
                loss = LOSS * film.couette[i, a] if surface.cyclic else 0.0
                block[i, a, a] = -(film.couette[i, a] + film.squeeze[i, a] + loss)
                right[0, i, a] -= loss


@inner
def across_at_unit_gap(surface):
    """Flow across of every node for the pressure of every other where int h^3 is one all over the width."""
    nodes = surface.nodes
    operator = np.zeros((nodes, nodes))
    for q in range(surface.points):
        for a in range(nodes):
            for b in range(nodes):
                operator[a, b] += surface.share[q] * surface.slope[q, a] * surface.slope[q, b]
    return operator


@inlined
def even(surface, film, i):
    """Whether int h^3 of a line is the same all over the width."""
    unequal = 0
    for q in range(1, surface.points):
        unequal += film.cubed[i, q] != film.cubed[i, 0]
    return unequal == 0


@spliced
def solve_surface(surface, film, work):
    """Pressure (or void) and the adjoints of the forces, with the wet set as it stands.

    A ring is solved by a border: line 0 is unknown, all others answer to it. With B the block tridiagonal matrix
    of the lines 1.., c and r the coupling column and row of line 0, V = B^-1 c and G = D_0 - r V

        z = G^-1 (b_0 - r B^-1 b),   u = B^-1 b - V z;    zeta = G^-T (g_0 - V^T g),   B^-T (g - r^T zeta).
    """
    couple_lines(surface, film, work)
    fill_lines(surface, film, work)
    none, one, count = int64(0), int64(1), 1 + surface.motions  # plain 0 and 1 would be types of their own
    if surface.cyclic:
        factor_lines(surface, work, work.counts[0])
        sweep_lines(surface, work, work.counts[0], none, one)
        factor_border(surface, work)
        add_border(surface, work)
        bind_adjoints(surface, work)
        sweep_lines(surface, work, work.counts[0], one, count)
    elif surface.nodes == len(FIVE):
        factor_lines(surface, work, FIVE)
        sweep_lines(surface, work, FIVE, none, count)
    elif surface.nodes == len(SEVEN):
        factor_lines(surface, work, SEVEN)
        sweep_lines(surface, work, SEVEN, none, count)
    else:
        factor_lines(surface, work, work.counts[0])
        sweep_lines(surface, work, work.counts[0], none, count)


@inner
def factor_lines(surface, work, across):
    """Blocks S_i = D_i - L_i S_i-1^-1 U_i of the lines (from line 1 in a ring), inverted in place.

    ``across`` is as long as there are nodes across the width: of `FIVE` and `SEVEN` the compiler knows it.
    """
    lines, nodes = work.wet.shape[0], len(across)
    first = 1 if surface.cyclic else 0
    block = work.inverse
    for i in range(first, lines):
        if i > first:
            for a in range(nodes):
                low = work.lower[i, a]
                if low != 0.0:
                    for b in range(nodes):
                        block[i, a, b] -= low * block[i - 1, a, b] * work.upper[i, b]
        invert_line(block, i, nodes)


@inlined
def invert_line(blocks, i, m):
    """Inverse of block i in place, Gauss-Jordan without pivoting; rows of identity cost nothing."""
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


@inner
def sweep_lines(surface, work, across, begin, end):
    """Right-hand sides from ``begin`` on (0 the pressure, then adjoints): forward, and back to the first line."""
    lines, nodes = work.wet.shape[0], len(across)
    first = 1 if surface.cyclic else 0
    inverse, swept, solution = work.inverse, work.swept, work.solution
    for i in range(first + 1, lines):
        for r in range(begin, end):
            for a in range(nodes):
                link = work.lower[i, a] if r == 0 else work.upper[i, a]
                if link != 0.0:
                    total = 0.0
                    for b in range(nodes):
                        total += (inverse[i - 1, a, b] if r == 0 else inverse[i - 1, b, a]) * swept[r, i - 1, b]
                    swept[r, i, a] -= link * total
    for i in range(lines - 1, first - 1, -1):
        for r in range(begin, end):
            if i < lines - 1:
                for b in range(nodes):
                    link = work.upper[i + 1, b] if r == 0 else work.lower[i + 1, b]
                    swept[r, i, b] -= link * solution[r, i + 1, b]
            for a in range(nodes):
                total = 0.0
                for b in range(nodes):
                    total += (inverse[i, a, b] if r == 0 else inverse[i, b, a]) * swept[r, i, b]
                solution[r, i, a] = total


@inner
def multiply(left, right, product, size):
    """Product of two square matrices, into ``product``."""
    for a in range(size):
        for b in range(size):
            product[a, b] = 0.0
        for c in range(size):
            factor = left[a, c]
            if factor != 0.0:
                for b in range(size):
                    product[a, b] += factor * right[c, b]


@inner
def factor_border(surface, work):
    """Into ``border`` V, the answer of all lines to line 0; the inverse of G in place of the block of line 0."""
    lines, nodes = work.wet.shape[0], surface.nodes
    last, v, carried = lines - 1, work.border, np.empty((nodes, nodes))
    v[:] = 0.0
    for a in range(nodes):  # column of line 0: rows of line 1 and of the last line
        v[1, a, a] += work.lower[1, a]
        v[last, a, a] += work.upper[0, a]
    for i in range(2, lines):
        multiply(work.inverse[i - 1], v[i - 1], carried, nodes)
        for a in range(nodes):
            for b in range(nodes):
                v[i, a, b] -= work.lower[i, a] * carried[a, b]
    for i in range(last, 0, -1):
        if i < last:
            for a in range(nodes):
                for b in range(nodes):
                    v[i, a, b] -= work.upper[i + 1, a] * v[i + 1, a, b]
        multiply(work.inverse[i], v[i], carried, nodes)
        for a in range(nodes):
            for b in range(nodes):
                v[i, a, b] = carried[a, b]
    for a in range(nodes):
        for b in range(nodes):
            work.inverse[0, a, b] -= work.upper[1, a] * v[1, a, b] + work.lower[0, a] * v[last, a, b]
    invert_line(work.inverse, 0, nodes)


@inner
def add_border(surface, work):
    """Pressure of line 0, and what the other lines answer to it."""
    lines, nodes = work.wet.shape[0], surface.nodes
    right, u = work.swept[0, 0], work.solution[0]
    for a in range(nodes):
        right[a] -= work.upper[1, a] * u[1, a] + work.lower[0, a] * u[lines - 1, a]
    for a in range(nodes):
        total = 0.0
        for b in range(nodes):
            total += work.inverse[0, a, b] * right[b]
        u[0, a] = total
    for i in range(1, lines):
        for a in range(nodes):
            for b in range(nodes):
                u[i, a] -= work.border[i, a, b] * u[0, b]


@inner
def bind_adjoints(surface, work):
    """Adjoints of line 0, and the right-hand sides of the other lines less their answer to it."""
    lines, nodes = work.wet.shape[0], surface.nodes
    for r in range(1, 1 + surface.motions):
        right, zeta = work.swept[r], work.solution[r, 0]
        for i in range(1, lines):
            for a in range(nodes):
                if right[i, a] != 0.0:
                    for b in range(nodes):
                        right[0, b] -= work.border[i, a, b] * right[i, a]
        for a in range(nodes):
            total = 0.0
            for b in range(nodes):
                total += work.inverse[0, b, a] * right[0, b]
            zeta[a] = total
        for a in range(nodes):
            right[1, a] -= work.upper[1, a] * zeta[a]
            right[lines - 1, a] -= work.lower[0, a] * zeta[a]
