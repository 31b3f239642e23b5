"""Kernels: the films of several bearings side by side (``_lanes``), as ``_grids``, ``_elimination``, ``_endings``
and ``_forces`` solve one at a time.

All lanes treat a line alike: in modes where it is full in every lane, as a block where a node is dry in one. Lanes
that do not need it find zeros there. Grooves and sides are at ambient pressure and the journal does not move, so
that pressures of grooves, sides and squeezed oil do not occur.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy import bool_
from numpy.typing import NDArray

from babbitt.reynolds._compiling import inlined, inner, spliced
from babbitt.reynolds._lanes import LANES, any_of, get, lent, maximum, minimum, put, where
from babbitt.reynolds._structs import Array, Film, Grid
from babbitt.reynolds.lands._forces import TIE
from babbitt.reynolds.lands._grids import FAR, NEAR

# rows of the numbers of every lane
KAPPA, LOAD_X, LOAD_Y, X, Y, GAP, MOVE_X, MOVE_Y, NEW_X, NEW_Y, NEW_GAP = range(11)
SHARE, LAST_GAP, STEP_TIME, LAST_SIZE, CHANGED, NUMBERS = range(11, 17)


class LaneLines(NamedTuple):
    """Workspace of a land; in full lines the answers stand in modes, in others on nodes."""

    answer: (
        Array  # right-hand sides after the forward sweep, then u or sigma and both adjoints: (n + 1, 3, m, LANES)
    )
    pivot: Array  # inverse modal pivots, (n + 1, m, LANES)
    inverse: Array  # inverse of the block of a line, (n + 1, m, m, LANES)
    before: Array  # the ends of the film (``_endings``), (n + 1, m, LANES)
    behind: Array
    fill: Array
    turned: Array  # two lines on their way between modes and nodes, (2, 3, m, LANES)
    some_wet: NDArray[bool_]  # whether any lane has a wet node on the line, (n + 1,)


@inner
def lane_grid(lands, n, m):
    """Grid of several lands in lanes, not filled yet; wet nodes hold 1, dry ones 0."""
    node, cell = (lands, n + 1, LANES), (lands, n, LANES)
    wet: Any = np.ones((lands, n + 1, m, LANES))  # masks of numbers, where a grid of one bearing has truths
    return Grid(
        np.zeros(node), np.ones(cell), np.ones(cell), np.zeros(cell), np.ones(cell), np.zeros(cell),
        np.ones(cell), np.ones(cell), np.zeros(node), np.zeros(node), wet, np.zeros((lands, n + 1, m, LANES)),
    )  # fmt: skip


@inner
def lane_film(n):
    """Film coefficients of n intervals in lanes, not filled yet."""
    node, cell = (n + 1, LANES), (n, LANES)
    return Film(
        np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell), np.empty(cell),
        np.empty(node), np.empty(node), np.empty(node), np.empty((0, LANES)), np.empty((3, LANES)),
    )  # fmt: skip


@inner
def lane_lines(n, m):
    """Workspace of a land with n intervals and m axial unknowns, in lanes."""
    node = (n + 1, m, LANES)
    return LaneLines(
        np.zeros((n + 1, 3, m, LANES)), np.ones(node), np.zeros((n + 1, m, m, LANES)), np.ones(node),
        np.ones(node), np.full(node, 0.5), np.zeros((2, 3, m, LANES)), np.ones(n + 1, np.bool_),
    )  # fmt: skip


@inlined
def lane_gap(grid, x, y):
    """Smallest gap at the Gauss points of all lands."""
    gap_a, cos_a, sin_a, gap_b, cos_b = (
        lent(grid.gap_a),
        lent(grid.cos_a),
        lent(grid.sin_a),
        lent(grid.gap_b),
        lent(grid.cos_b),
    )
    sin_b = lent(grid.sin_b)
    smallest = x * 0.0 + np.inf
    for k in range(grid.step.shape[0]):
        for i in range(grid.step.shape[1]):
            place = (k, i)
            a = get(gap_a, place) - x * get(cos_a, place) - y * get(sin_a, place)
            b = get(gap_b, place) - x * get(cos_b, place) - y * get(sin_b, place)
            smallest = minimum(smallest, minimum(a, b))
    return smallest


@inlined
def lane_coefficients(grid, k, x, y, film):
    """Coefficients of the films at the positions of the journals, on land k."""
    step, cos_a, sin_a, cos_b, sin_b = (
        lent(grid.step),
        lent(grid.cos_a),
        lent(grid.sin_a),
        lent(grid.cos_b),
        lent(grid.sin_b),
    )
    gap_a, gap_b = lent(grid.gap_a), lent(grid.gap_b)
    conductance, conductance_x, conductance_y, couette, couette_x = (
        lent(film.conductance),
        lent(film.conductance_x),
        lent(film.conductance_y),
        lent(film.couette),
        lent(film.couette_x),
    )
    couette_y, cubed, cubed_x, cubed_y = (
        lent(film.couette_y),
        lent(film.cubed),
        lent(film.cubed_x),
        lent(film.cubed_y),
    )
    n = grid.step.shape[1]
    zero = x * 0.0
    h0, h0_x, h0_y = zero, zero, zero  # what the interval before adds to its second line
    for i in range(n):
        place = (k, i)
        half = 0.5 * get(step, place)
        ca, sa = get(cos_a, place), get(sin_a, place)
        cb, sb = get(cos_b, place), get(sin_b, place)
        ha = get(gap_a, place) - x * ca - y * sa
        hb = get(gap_b, place) - x * cb - y * sb
        per_both = 1.0 / (ha * hb)  # one division in place of two
        va, vb = hb * per_both, ha * per_both
        a2, b2 = va * va, vb * vb
        a3, b3 = a2 * va, b2 * vb
        t = 1.0 / (12.0 * half * (a3 + b3))
        per_j3 = 12.0 * half * t
        q = 0.5 * (a2 + b2) * per_j3
        a4, b4 = a2 * a2 * per_j3, b2 * b2 * per_j3
        j3_x, j3_y = 3.0 * (ca * a4 + cb * b4), 3.0 * (sa * a4 + sb * b4)
        put(conductance, (i,), t)
        put(conductance_x, (i,), -t * j3_x)
        put(conductance_y, (i,), -t * j3_y)
        put(couette, (i,), q)
        put(couette_x, (i,), (ca * a3 + cb * b3) * per_j3 - q * j3_x)
        put(couette_y, (i,), (sa * a3 + sb * b3) * per_j3 - q * j3_y)
        ha2, hb2 = half * ha * ha, half * hb * hb
        ha3, hb3 = ha2 * ha, hb2 * hb
        xa, xb, ya, yb = -3.0 * ha2 * ca, -3.0 * hb2 * cb, -3.0 * ha2 * sa, -3.0 * hb2 * sb
        put(cubed, (i,), h0 + NEAR * ha3 + FAR * hb3)
        put(cubed_x, (i,), h0_x + NEAR * xa + FAR * xb)
        put(cubed_y, (i,), h0_y + NEAR * ya + FAR * yb)
        h0 = FAR * ha3 + NEAR * hb3
        h0_x, h0_y = FAR * xa + NEAR * xb, FAR * ya + NEAR * yb
    put(cubed, (n,), h0)
    put(cubed_x, (n,), h0_x)
    put(cubed_y, (n,), h0_y)


@inlined
def find_broken(conserving, grid, k, lines):
    """Find the first unknown line that is not full in every lane, or n; notes on which lines any lane is wet."""
    wet = lent(grid.wet)
    some_wet = lines.some_wet
    n, m = grid.step.shape[1], grid.wet.shape[2]
    broken = n
    for i in range(n - 1, 0, -1):
        fewest = most = get(wet, (k, i, 0))
        for j in range(1, m):
            here = get(wet, (k, i, j))
            fewest, most = minimum(fewest, here), maximum(most, here)
        some_wet[i] = any_of(most > 0.5)
        if any_of(fewest < 0.5):
            broken = i
    return broken


@inlined
def sweep_full(axial, kappa, grid, k, film, lines, full):
    """Forward elimination of the lines 1..full in modes."""
    weight_x, weight_y = lent(grid.weight_x), lent(grid.weight_y)
    conductance, cubed, couette = lent(film.conductance), lent(film.cubed), lent(film.couette)
    pivot, answer = lent(lines.pivot), lent(lines.answer)
    mode_weights, eigenvalues = axial.mode_weights, axial.eigenvalues
    m = len(axial.size)
    for i in range(1, full + 1):
        t0, t1 = get(conductance, (i - 1,)), get(conductance, (i,))
        stretch = kappa * get(cubed, (i,))
        source = get(couette, (i - 1,)) - get(couette, (i,))
        ox, oy = get(weight_x, (k, i)), get(weight_y, (k, i))
        for e in range(m):
            q = mode_weights[e]
            # line 0 holds zeros and pivots of one
            f = t0 * get(pivot, (i - 1, e)) if i > 1 else t0 * 0.0
            put(pivot, (i, e), 1.0 / (t0 + t1 + stretch * eigenvalues[e] - t0 * f))
            put(answer, (i, 0, e), q * source + f * get(answer, (i - 1, 0, e)))
            put(answer, (i, 1, e), f * get(answer, (i - 1, 1, e)) - q * ox)
            put(answer, (i, 2, e), f * get(answer, (i - 1, 2, e)) - q * oy)


@spliced
def turn(matrix, vectors, i, r, result, to, m):
    """Row (to, r) of ``result`` = matrix times row (i, r) of ``vectors``."""
    for a in range(m):
        total = matrix[a, 0] * get(vectors, (i, r, 0))
        for b in range(1, m):
            total = total + matrix[a, b] * get(vectors, (i, r, b))
        put(result, (to, r, a), total)


@spliced
def lower_of(conserving, t0, arriving, here, before):
    """Entry of a node's row for the same node of the line before."""
    if conserving:
        return where(before > 0.5, -t0, arriving)
    return -t0 * here * before


@spliced
def upper_of(conserving, t0, here, before):
    """Entry, in the row of the line before, for a node of this line."""
    if conserving:
        return -t0 * here
    return -t0 * here * before


@inlined
def sweep_blocks(axial, conserving, kappa, grid, k, film, lines, broken, ends):
    """Forward elimination on nodes from the first broken line on; ``ends``: as ``apply_ends`` of one bearing."""
    answer, inverse, turned = lent(lines.answer), lent(lines.inverse), lent(lines.turned)
    wet, weight_x, weight_y = lent(grid.wet), lent(grid.weight_x), lent(grid.weight_y)
    conductance, couette, inlet, cubed = (
        lent(film.conductance),
        lent(film.couette),
        lent(film.inlet),
        lent(film.cubed),
    )
    some_wet, before_of, behind_of, fill_of, pivot = (
        lines.some_wet,
        lent(lines.before),
        lent(lines.behind),
        lent(lines.fill),
        lent(lines.pivot),
    )
    root_weights, stiffness, modes = axial.root_weights, axial.stiffness, axial.modes
    m = len(axial.size)
    n = grid.step.shape[1]
    if 1 < broken < n:
        full_line_to_nodes(modes, answer, pivot, inverse, turned, broken - 1, m)
    for i in range(broken, n):
        t0, t1 = get(conductance, (i - 1,)), get(conductance, (i,))
        arriving, leaving = get(couette, (i - 1,)), get(couette, (i,))
        source = arriving - leaving
        if not some_wet[i]:
            if conserving:
                sweep_dry(
                    root_weights, wet, k, inlet, answer, inverse, turned, some_wet, i, t0, arriving, leaving,
                    i == broken, m,
                )  # fmt: skip
            continue
        stretch = kappa * get(cubed, (i,))
        ox, oy = get(weight_x, (k, i)), get(weight_y, (k, i))
        for a in range(m):
            here = get(wet, (k, i, a))
            q = root_weights[a]
            right = q * source
            if conserving:
                if i == 1:
                    right = where(here > 0.5, right, q * (get(inlet, (0,)) - leaving))
            else:
                right = right * here
            put(turned, (0, 0, a), right)
            put(turned, (0, 1, a), -q * ox * here)
            put(turned, (0, 2, a), -q * oy * here)
            row = stretch if conserving else stretch * here
            for b in range(m):
                put(inverse, (i, a, b), row * stiffness[a, b] * get(wet, (k, i, b)))
            dry = -leaving if conserving else 1.0 + t0 * 0.0
            put(inverse, (i, a, a), where(here > 0.5, get(inverse, (i, a, a)) + t0 + t1, dry))
        if ends:
            lane_ends(
                stiffness, conserving, wet, k, before_of, behind_of, fill_of, inverse, turned, i,
                t0, t1, stretch, m,
            )  # fmt: skip
        if i > 1 and (conserving or some_wet[i - 1] or i == broken):
            couple(conserving, wet, k, answer, inverse, turned, i, t0, arriving, i == broken, m)
        for r in range(3):
            for a in range(m):
                put(answer, (i, r, a), get(turned, (0, r, a)))
        lane_invert(inverse, i, m)


@spliced
def full_line_to_nodes(modes, answer, pivot, inverse, turned, i, m):
    """The factor of the last full line on nodes, and, in row 1 of ``turned``, its right-hand sides."""
    for a in range(m):
        for b in range(m):
            total = get(pivot, (i, 0)) * (modes[a, 0] * modes[b, 0])
            for e in range(1, m):
                total = total + modes[a, e] * modes[b, e] * get(pivot, (i, e))
            put(inverse, (i, a, b), total)
    for r in range(3):
        turn(modes, answer, i, r, turned, 1, m)


@spliced
def couple(conserving, wet, k, answer, inverse, turned, i, t0, arriving, from_modes, m):
    """Take the line before out of the block and the right-hand sides of line i."""
    for a in range(m):
        here, before = get(wet, (k, i, a)), get(wet, (k, i - 1, a))
        lower, upper = lower_of(conserving, t0, arriving, here, before), upper_of(conserving, t0, here, before)
        r0, r1, r2 = t0 * 0.0, t0 * 0.0, t0 * 0.0
        for b in range(m):
            entry, mirrored = get(inverse, (i - 1, a, b)), get(inverse, (i - 1, b, a))
            other = upper_of(conserving, t0, get(wet, (k, i, b)), get(wet, (k, i - 1, b)))
            put(inverse, (i, a, b), get(inverse, (i, a, b)) - lower * entry * other)
            if from_modes:
                y0, y1, y2 = get(turned, (1, 0, b)), get(turned, (1, 1, b)), get(turned, (1, 2, b))
            else:
                y0, y1, y2 = get(answer, (i - 1, 0, b)), get(answer, (i - 1, 1, b)), get(answer, (i - 1, 2, b))
            r0 = r0 + entry * y0
            r1 = r1 + mirrored * y1
            r2 = r2 + mirrored * y2
        put(turned, (0, 0, a), get(turned, (0, 0, a)) - lower * r0)
        put(turned, (0, 1, a), get(turned, (0, 1, a)) - upper * r1)
        put(turned, (0, 2, a), get(turned, (0, 2, a)) - upper * r2)


@spliced
def sweep_dry(
    root_weights, wet, k, inlet, answer, inverse, turned, some_wet, i, t0, arriving, leaving, from_modes, m
):
    """Forward elimination of a line without pressure in any lane: every column transports its void."""
    source = arriving - leaving if i > 1 else get(inlet, (0,)) - leaving
    pivot = -1.0 / leaving
    for a in range(m):
        lower = where(get(wet, (k, i - 1, a)) > 0.5, -t0, arriving)
        right = root_weights[a] * source
        if i > 1 and not some_wet[i - 1]:
            right = right - lower * get(inverse, (i - 1, a, a)) * get(answer, (i - 1, 0, a))
        elif i > 1:
            for b in range(m):
                before = get(turned, (1, 0, b)) if from_modes else get(answer, (i - 1, 0, b))
                right = right - lower * get(inverse, (i - 1, a, b)) * before
        put(answer, (i, 0, a), right)
        put(answer, (i, 1, a), 0.0)
        put(answer, (i, 2, a), 0.0)
        for b in range(m):
            put(inverse, (i, a, b), 0.0)
        put(inverse, (i, a, a), pivot)


@spliced
def lane_invert(blocks, i, m):
    """Invert block i of every lane in place, Gauss-Jordan without pivoting."""
    for c in range(m):
        pivot = 1.0 / get(blocks, (i, c, c))
        put(blocks, (i, c, c), 1.0)
        for b in range(m):
            put(blocks, (i, c, b), get(blocks, (i, c, b)) * pivot)
        for a in range(m):
            if a != c:
                factor = get(blocks, (i, a, c))
                put(blocks, (i, a, c), 0.0)
                for b in range(m):
                    put(blocks, (i, a, b), get(blocks, (i, a, b)) - factor * get(blocks, (i, c, b)))


@inlined
def back_blocks(axial, conserving, grid, k, film, lines, broken):
    """Answers on nodes from the last line back to the first broken one."""
    answer, inverse, turned = lent(lines.answer), lent(lines.inverse), lent(lines.turned)
    wet = lent(grid.wet)
    conductance, couette = lent(film.conductance), lent(film.couette)
    some_wet = lines.some_wet
    m = len(axial.size)
    n = grid.step.shape[1]
    for i in range(n - 1, broken - 1, -1):
        holds = some_wet[i]
        if not holds and not conserving:
            for r in range(3):
                for a in range(m):
                    put(answer, (i, r, a), 0.0)
            continue
        t, arriving = get(conductance, (i,)), get(couette, (i,))
        for b in range(m):
            y0, y1, y2 = get(answer, (i, 0, b)), get(answer, (i, 1, b)), get(answer, (i, 2, b))
            if i < n - 1:
                here, before = get(wet, (k, i + 1, b)), get(wet, (k, i, b))
                lower, upper = (
                    lower_of(conserving, t, arriving, here, before),
                    upper_of(conserving, t, here, before),
                )
                y0 = y0 - upper * get(answer, (i + 1, 0, b))
                y1 = y1 - lower * get(answer, (i + 1, 1, b))
                y2 = y2 - lower * get(answer, (i + 1, 2, b))
            if holds:
                put(turned, (0, 0, b), y0)
                put(turned, (0, 1, b), y1)
                put(turned, (0, 2, b), y2)
            else:
                own = get(inverse, (i, b, b))
                put(answer, (i, 0, b), own * y0)
                put(answer, (i, 1, b), own * y1)
                put(answer, (i, 2, b), own * y2)
        if holds:
            for a in range(m):
                r0, r1, r2 = t * 0.0, t * 0.0, t * 0.0
                for b in range(m):
                    entry, mirrored = get(inverse, (i, a, b)), get(inverse, (i, b, a))
                    r0 = r0 + entry * get(turned, (0, 0, b))
                    r1 = r1 + mirrored * get(turned, (0, 1, b))
                    r2 = r2 + mirrored * get(turned, (0, 2, b))
                put(answer, (i, 0, a), r0)
                put(answer, (i, 1, a), r1)
                put(answer, (i, 2, a), r2)


@inlined
def back_full(axial, conserving, grid, k, film, lines, full):
    """Answers in modes from line ``full`` back to the first."""
    answer, turned = lent(lines.answer), lent(lines.turned)
    wet = lent(grid.wet)
    conductance, couette = lent(film.conductance), lent(film.couette)
    pivot = lent(lines.pivot)
    modes_transposed = axial.modes_transposed
    m = len(axial.size)
    n = grid.step.shape[1]
    behind = full + 1
    t, arriving = get(conductance, (full,)), get(couette, (full,))
    for a in range(m):
        if behind < n:
            here, before = get(wet, (k, behind, a)), get(wet, (k, full, a))
            lower, upper = lower_of(conserving, t, arriving, here, before), upper_of(conserving, t, here, before)
            put(turned, (1, 0, a), -upper * get(answer, (behind, 0, a)))
            put(turned, (1, 1, a), -lower * get(answer, (behind, 1, a)))
            put(turned, (1, 2, a), -lower * get(answer, (behind, 2, a)))
        else:
            for r in range(3):
                put(turned, (1, r, a), 0.0)
    for r in range(3):
        turn(modes_transposed, turned, 1, r, turned, 0, m)
        for e in range(m):
            put(answer, (full, r, e), get(pivot, (full, e)) * (get(answer, (full, r, e)) + get(turned, (0, r, e))))
    for i in range(full - 1, 0, -1):
        t = get(conductance, (i,))
        for e in range(m):
            own = get(pivot, (i, e))
            for r in range(3):
                put(answer, (i, r, e), own * (get(answer, (i, r, e)) + t * get(answer, (i + 1, r, e))))


@inlined
def keep_pressure(axial, grid, k, lines, full, smooth):
    """Write the solution to the grid, or, where the film has settled (``smooth``), take it from there."""
    answer = lent(lines.answer)
    value = lent(grid.value)
    modes = axial.modes
    m = len(axial.size)
    n = grid.step.shape[1]
    for i in range(1, n):
        for a in range(m):
            if i > full and smooth:
                put(answer, (i, 0, a), get(value, (k, i, a)))
            elif i > full:
                put(value, (k, i, a), get(answer, (i, 0, a)))
            else:
                total = get(answer, (i, 0, 0)) * 0.0
                if smooth:
                    for b in range(m):
                        total = total + modes[b, a] * get(value, (k, i, b))
                    put(answer, (i, 0, a), total)
                else:
                    for e in range(m):
                        total = total + modes[a, e] * get(answer, (i, 0, e))
                    put(value, (k, i, a), total)


@inlined
def lane_forces(axial, conserving, kappa, grid, k, film, lines, full, result):
    """Add force, stiffness and damping of land k to ``result``, (10, LANES), as ``add_forces`` of one bearing."""
    stiffness = axial.stiffness
    answer, turned = lent(lines.answer), lent(lines.turned)
    wet, weight_x, weight_y = lent(grid.wet), lent(grid.weight_x), lent(grid.weight_y)
    inlet, couette_x, couette_y, conductance_x, conductance_y = (
        lent(film.inlet),
        lent(film.couette_x),
        lent(film.couette_y),
        lent(film.conductance_x),
        lent(film.conductance_y),
    )
    cubed_x, cubed_y = lent(film.cubed_x), lent(film.cubed_y)
    some_wet = lines.some_wet
    mode_weights, modes, root_weights, eigenvalues = (
        axial.mode_weights,
        axial.modes,
        axial.root_weights,
        axial.eigenvalues,
    )
    m = len(axial.size)
    n = grid.step.shape[1]
    zero = kappa * 0.0
    fx, fy = zero, zero
    kxx, kxy, kyx, kyy = zero, zero, zero, zero
    cxx, cxy, cyx, cyy = zero, zero, zero, zero
    for i in range(n):
        wet_here, wet_behind = i <= full or some_wet[i], i + 1 == n or some_wet[i + 1]
        if not (conserving or wet_here or wet_behind):
            continue
        # the flux of the interval behind line i
        ax, ay, bx, by = zero, zero, zero, zero
        if i < full:
            for e in range(m):
                q = mode_weights[e]
                rise = get(answer, (i, 0, e)) - get(answer, (i + 1, 0, e))
                lx = get(answer, (i, 1, e)) - get(answer, (i + 1, 1, e))
                ly = get(answer, (i, 2, e)) - get(answer, (i + 1, 2, e))
                ax = ax + q * lx
                ay = ay + q * ly
                bx = bx + lx * rise
                by = by + ly * rise
        else:
            for r in range(3):
                if i == full:
                    turn(modes, answer, i, r, turned, 0, m)  # line 0 holds zeros
                else:
                    for j in range(m):
                        put(turned, (0, r, j), get(answer, (i, r, j)))
            inlet_x, inlet_y = zero, zero
            for j in range(m):
                q = root_weights[j]
                here, behind = get(wet, (k, i, j)), get(wet, (k, i + 1, j))
                up, down = get(turned, (0, 0, j)), get(answer, (i + 1, 0, j)) * behind
                lx = get(turned, (0, 1, j)) - get(answer, (i + 1, 1, j))
                ly = get(turned, (0, 2, j)) - get(answer, (i + 1, 2, j))
                if conserving and i == 0:
                    inlet_x = inlet_x + q * lx * (1.0 - behind)
                    inlet_y = inlet_y + q * ly * (1.0 - behind)
                    lx, ly = lx * behind, ly * behind
                liquid = q - (1.0 - here) * up  # sqrt(w) times the liquid fraction
                ax = ax + liquid * lx
                ay = ay + liquid * ly
                bx = bx + lx * (up * here - down)
                by = by + ly * (up * here - down)
            if conserving and i == 0:
                kxx = kxx + inlet_x * get(inlet, (1,))
                kxy = kxy + inlet_x * get(inlet, (2,))
                kyx = kyx + inlet_y * get(inlet, (1,))
                kyy = kyy + inlet_y * get(inlet, (2,))
        q_x, q_y = get(couette_x, (i,)), get(couette_y, (i,))
        t_x, t_y = get(conductance_x, (i,)), get(conductance_y, (i,))
        kxx = kxx + ax * q_x + bx * t_x
        kxy = kxy + ax * q_y + bx * t_y
        kyx = kyx + ay * q_x + by * t_x
        kyy = kyy + ay * q_y + by * t_y
        if i == 0 or not (conserving or wet_here):
            continue
        # the line itself: pressure, axial flow, squeeze
        mean, ex, ey, sx, sy = zero, zero, zero, zero, zero
        for j in range(m):
            u, lx, ly = get(answer, (i, 0, j)), get(answer, (i, 1, j)), get(answer, (i, 2, j))
            if i <= full:
                q = mode_weights[j]
                row = eigenvalues[j] * u
                mean = mean + q * u
                sx = sx + q * lx
                sy = sy + q * ly
            else:
                q, here = root_weights[j], get(wet, (k, i, j))
                row = zero
                for b in range(m):
                    row = row + stiffness[j, b] * (get(answer, (i, 0, b)) * get(wet, (k, i, b)))
                mean = mean + q * (u * here)
                liquid = q - (1.0 - here) * u
                sx = sx + liquid * lx
                sy = sy + liquid * ly
            ex = ex + lx * row
            ey = ey + ly * row
        ox, oy = get(weight_x, (k, i)), get(weight_y, (k, i))
        h_x, h_y = kappa * get(cubed_x, (i,)), kappa * get(cubed_y, (i,))
        fx = fx - ox * mean
        fy = fy - oy * mean
        kxx = kxx + ex * h_x
        kxy = kxy + ex * h_y
        kyx = kyx + ey * h_x
        kyy = kyy + ey * h_y
        cxx = cxx - sx * ox
        cxy = cxy - sx * oy
        cyx = cyx - sy * ox
        cyy = cyy - sy * oy
    put(result, (0,), get(result, (0,)) + fx)
    put(result, (1,), get(result, (1,)) + fy)
    put(result, (2,), get(result, (2,)) + kxx)
    put(result, (3,), get(result, (3,)) + kxy)
    put(result, (4,), get(result, (4,)) + kyx)
    put(result, (5,), get(result, (5,)) + kyy)
    put(result, (6,), get(result, (6,)) + cxx)
    put(result, (7,), get(result, (7,)) + cxy)
    put(result, (8,), get(result, (8,)) + cyx)
    put(result, (9,), get(result, (9,)) + cyy)


@inlined
def lane_update(axial, conserving, kappa, grid, k, film, lines, full):
    """One step of the wet sets, as ``update_active_set`` of one bearing: how many nodes changed, in every lane."""
    wet, value = lent(grid.wet), lent(grid.value)
    couette, cubed, conductance = lent(film.couette), lent(film.cubed), lent(film.conductance)
    some_wet = lines.some_wet
    root_weights, stiffness = axial.root_weights, axial.stiffness
    m = len(axial.size)
    changed = kappa * 0.0
    for i in range(1, grid.step.shape[1]):
        surplus, stretch = kappa * 0.0, kappa * 0.0
        t0, t1 = surplus, surplus
        by_row = i > full and not conserving
        if by_row:
            surplus = get(couette, (i,)) - get(couette, (i - 1,))
            stretch = kappa * get(cubed, (i,))
            t0, t1 = get(conductance, (i - 1,)), get(conductance, (i,))
        for j in range(m):
            here, test = get(wet, (k, i, j)), get(value, (k, i, j))
            if by_row:
                row = root_weights[j] * surplus
                row = row - t0 * get(value, (k, i - 1, j)) - t1 * get(value, (k, i + 1, j))
                if some_wet[i]:
                    for b in range(m):
                        row = row + stretch * stiffness[j, b] * get(value, (k, i, b))
                test = where(here > 0.5, test, row)
            change = where(test < -TIE, 1.0, 0.0)
            changed = changed + change
            put(wet, (k, i, j), here + change * (1.0 - 2.0 * here))
    return changed


@spliced
def lane_reach(pressure, surplus):
    """Intervals from the last wet node to the end of the film."""
    return where(surplus > 0.0, 0.5 + minimum(maximum(pressure / surplus, 0.0), 1.0), 1.0)


@inlined
def find_lane_ends(axial, conserving, grid, k, film, lines, broken):
    """Fill ``before``, ``behind``, ``fill`` of the nodes on lines that matter; returns the first such line."""
    couette, conductance, value = lent(film.couette), lent(film.conductance), lent(grid.value)
    wet = lent(grid.wet)
    behind_of, fill_of, before_of = lent(lines.behind), lent(lines.fill), lent(lines.before)
    root_weights = axial.root_weights
    m = len(axial.size)
    n = grid.step.shape[1]
    first = max(broken - 1, 1)
    if not conserving:
        surplus = (get(couette, (1,)) - get(couette, (0,))) / get(conductance, (0,))
        for j in range(m):
            before = lane_reach(get(value, (k, 1, j)) / root_weights[j], surplus)
            if any_of((before < 1.0) & (get(wet, (k, 1, j)) > 0.5)):
                first = 1
    for i in range(first, n):
        behind_surplus = (get(couette, (min(i + 1, n - 1),)) - get(couette, (min(i, n - 2),))) / get(
            conductance, (i,)
        )
        t0 = get(conductance, (i - 1,))
        arriving = get(couette, (i - 1,))
        before_surplus = (get(couette, (max(i - 1, 1),)) - get(couette, (max(i - 2, 0),))) / t0
        for j in range(m):
            here = get(wet, (k, i, j)) > 0.5
            dry_before, dry_behind = get(wet, (k, i - 1, j)) < 0.5, get(wet, (k, i + 1, j)) < 0.5
            pressure = get(value, (k, i, j)) / root_weights[j]
            behind = lane_reach(pressure, behind_surplus)
            behind = where(here & dry_behind, behind, 1.0) if i < n - 1 else where(here, minimum(behind, 1.0), 1.0)
            put(behind_of, (i, j), behind)
            if conserving:
                filled = t0 * get(value, (k, i, j))
                whole = filled + arriving * get(value, (k, i - 1, j))
                fill = where(whole > 0.0, minimum(maximum(filled / whole, 0.0), 1.0), 0.5)
                put(fill_of, (i, j), where(here & dry_before, fill, 0.5))
            else:
                before = lane_reach(pressure, before_surplus)
                before = where(here & dry_before, before, 1.0) if i > 1 else where(here, minimum(before, 1.0), 1.0)
                put(before_of, (i, j), before)
    return first


@spliced
def lane_ends(
    stiffness, conserving, wet, k, before_of, behind_of, fill_of, inverse, turned, i, t0, t1, stretch, m
):
    """Put the ends of the film into the block and the adjoint right-hand sides of line i."""
    for b in range(m):
        before, behind, fill = get(before_of, (i, b)), get(behind_of, (i, b)), get(fill_of, (i, b))
        own = t0 * (1.0 / before - 1.0) + t1 * (1.0 / behind - 1.0)
        put(inverse, (i, b, b), get(inverse, (i, b, b)) + own)
        extent = 0.5 * (before + behind) + fill - 0.5
        put(turned, (0, 1, b), get(turned, (0, 1, b)) * extent)
        put(turned, (0, 2, b), get(turned, (0, 2, b)) * extent)
        change = (extent - 1.0) * stretch
        for a in range(m):
            entry = change * stiffness[a, b]
            if not conserving:
                entry = entry * get(wet, (k, i, a))
            put(inverse, (i, a, b), get(inverse, (i, a, b)) + entry)


@inlined
def add_lane_ends(axial, grid, k, film, lines, first, result):
    """Add to K and C what the ends of the film change, as ``add_ends`` of one bearing."""
    value, weight_x, weight_y = lent(grid.value), lent(grid.weight_x), lent(grid.weight_y)
    couette_x, couette_y, conductance_x, conductance_y = (
        lent(film.couette_x),
        lent(film.couette_y),
        lent(film.conductance_x),
        lent(film.conductance_y),
    )
    before_of, behind_of, fill_of, answer = (
        lent(lines.before),
        lent(lines.behind),
        lent(lines.fill),
        lent(lines.answer),
    )
    root_weights = axial.root_weights
    m = len(axial.size)
    n = grid.step.shape[1]
    for i in range(first, n):
        ahead, past = (i + 1 if i < n - 1 else i - 1), (i - 2 if i > 1 else i)
        # two intervals on either side that tell the slope of Q
        q_x = (ahead - i) * (get(couette_x, (ahead,)) - get(couette_x, (i,)))
        q_y = (ahead - i) * (get(couette_y, (ahead,)) - get(couette_y, (i,)))
        p_x = (i - 1 - past) * (get(couette_x, (past,)) - get(couette_x, (i - 1,)))
        p_y = (i - 1 - past) * (get(couette_y, (past,)) - get(couette_y, (i - 1,)))
        for j in range(m):
            before, behind, fill = get(before_of, (i, j)), get(behind_of, (i, j)), get(fill_of, (i, j))
            q, u = root_weights[j], get(value, (k, i, j))
            along, thin = 0.5 * q * (behind - 1.0), u * (1.0 / behind - 1.0)
            along_p, thin_p = 0.5 * q * (before - 1.0), u * (1.0 / before - 1.0)
            flux_x = along * q_x + thin * get(conductance_x, (i,))
            flux_y = along * q_y + thin * get(conductance_y, (i,))
            flux_x = flux_x + thin_p * get(conductance_x, (i - 1,)) - along_p * p_x
            flux_y = flux_y + thin_p * get(conductance_y, (i - 1,)) - along_p * p_y
            volume = q * (0.5 * (before + behind) - 1.0)
            closes = (fill < 0.5) | (fill > 0.5)
            volume = volume - where(closes, 0.5 * get(value, (k, i - 1, j)), 0.0)
            lx, ly = get(answer, (i, 1, j)), get(answer, (i, 2, j))
            ox, oy = volume * get(weight_x, (k, i)), volume * get(weight_y, (k, i))
            put(result, (2,), get(result, (2,)) + lx * flux_x)
            put(result, (3,), get(result, (3,)) + lx * flux_y)
            put(result, (4,), get(result, (4,)) + ly * flux_x)
            put(result, (5,), get(result, (5,)) + ly * flux_y)
            put(result, (6,), get(result, (6,)) - lx * ox)
            put(result, (7,), get(result, (7,)) - lx * oy)
            put(result, (8,), get(result, (8,)) - ly * ox)
            put(result, (9,), get(result, (9,)) - ly * oy)


@inner
def lane_evaluate(axial, conserving, grid, edges, film, lines, numbers, smooth, result):
    """Force, stiffness and damping of every lane at its position, as ``evaluate`` of one bearing.

    ``edges`` (lands, 3, LANES): flux into a line ruptured at its start for the journal in the origin, and its
    derivatives. Reads the rows KAPPA, X, Y of ``numbers``; fills ``result`` (10, LANES) and the row CHANGED.
    """
    ratio, jx, jy = get(numbers, (KAPPA,)), get(numbers, (X,)), get(numbers, (Y,))
    total = ratio * 0.0
    for row in range(result.shape[0]):
        put(result, (row,), 0.0)
    for k in range(grid.step.shape[0]):
        lane_coefficients(grid, k, jx, jy, film)
        by_x, by_y = get(edges, (k, 1)), get(edges, (k, 2))
        put(film.inlet, (0,), get(edges, (k, 0)) + by_x * jx + by_y * jy)
        put(film.inlet, (1,), by_x)
        put(film.inlet, (2,), by_y)
        broken = find_broken(conserving, grid, k, lines)
        if smooth:
            broken = find_lane_ends(axial, conserving, grid, k, film, lines, broken)
        sweep_full(axial, ratio, grid, k, film, lines, broken - 1)
        sweep_blocks(axial, conserving, ratio, grid, k, film, lines, broken, smooth)
        back_blocks(axial, conserving, grid, k, film, lines, broken)
        if broken > 1:
            back_full(axial, conserving, grid, k, film, lines, broken - 1)
        keep_pressure(axial, grid, k, lines, broken - 1, smooth)
        lane_forces(axial, conserving, ratio, grid, k, film, lines, broken - 1, result)
        if smooth:
            add_lane_ends(axial, grid, k, film, lines, broken, result)
        else:
            total = total + lane_update(axial, conserving, ratio, grid, k, film, lines, broken - 1)
    put(numbers, (CHANGED,), total)
