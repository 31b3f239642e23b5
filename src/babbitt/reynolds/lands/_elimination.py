"""Kernels: the pressure of a land and its two adjoints, by elimination from line to line.

Rows, divided by sqrt(w_j), with u = sqrt(w) p and sigma = sqrt(w) s, s = 1 - liquid fraction:

    sqrt(w_j) (Q_i - Q_i-1 + S_i) + T_i (u_i - u_i+1)_j - T_i-1 (u_i-1 - u_i)_j
        + kappa H_i (K~ (u_i - p_side sqrt(w)))_j = 0,        kappa = (D/B)^2 / 12.

A dry node (p = 0) of the Reynolds condition loses its row and its column. A dry node of the mass-conserving
condition keeps its row; its column carries sigma, transported downstream: -(Q_i + S_i) here and +Q_i in the
next line.

Either way the matrix is block tridiagonal with diagonal coupling, and  S_i = D_i - L_i S_i-1^-1 U_i.
Lines that are full across the width, counted from the start of the land, are diagonal in the modes of K~ and cost
O(m); from the first line with a dry node on, blocks are inverted. The adjoints A^T l = dF/du use the same
factors.
"""

from __future__ import annotations

from babbitt.reynolds._compiling import inlined, spliced
from babbitt.reynolds._structs import END_PRESSURE, START_PRESSURE
from babbitt.reynolds.lands._endings import apply_ends


@inlined
def count_wet(grid, k, lines, m):
    """Count the wet nodes of every line; returns the index of the first unknown line with a dry node, or n."""
    n = grid.wet.shape[1] - 1
    broken = n
    for i in range(n - 1, 0, -1):
        count = 0
        for j in range(m):
            if grid.wet[k, i, j]:
                count += 1
        lines.wet_count[i] = count
        if count < m:
            broken = i
    lines.wet_count[0] = lines.wet_count[n] = m
    return broken


@spliced
def solve_land(axial, bearing, grid, k, film, lines, nodal_from):
    """Solve land k for pressure (or void) and the adjoints of both force components; the wet set stands.

    Lines are treated in modes up to the line before the first one with a dry node, but at most to nodal_from - 1;
    below n it says that from there on the film ends between lines (``_endings``).
    """
    m = len(axial.size)
    n = film.conductance.size
    solution, modal = lines.solution, lines.modal
    broken = min(count_wet(grid, k, lines, m), max(nodal_from, 1))
    full = broken - 1  # lines 1..full are full
    sweep_full_lines(axial, bearing, grid, k, film, lines, full)
    if broken < n:
        if full > 0:
            full_line_to_nodes(axial, lines, full)
        sweep_broken_lines(axial, bearing, grid, k, film, lines, broken, nodal_from < n)
        back_substitute(lines, max(full, 1), n, m, bearing.conserving)
        if full > 0:
            rotate(axial.modes_transposed, solution, modal, full, full, m)
    elif full > 0:
        for e in range(m):
            for r in range(3):
                modal[full, r, e] = lines.pivot[full, e] * lines.swept[full, r, e]
    for i in range(full - 1, 0, -1):
        t = film.conductance[i]
        for e in range(m):
            pivot = lines.pivot[i, e]
            for r in range(3):
                modal[i, r, e] = pivot * (lines.swept[i, r, e] + t * modal[i + 1, r, e])
    rotate(axial.modes, modal, solution, 1, full, m)
    for j in range(m):
        solution[0, 0, j] = axial.root_weights[j] * bearing.lands[k, START_PRESSURE]
        solution[n, 0, j] = axial.root_weights[j] * bearing.lands[k, END_PRESSURE]


@inlined
def sweep_full_lines(axial, bearing, grid, k, film, lines, full):
    """Forward elimination of the lines 1..full in modal coordinates."""
    m = len(axial.size)
    n = film.conductance.size
    swept, pivot = lines.swept, lines.pivot
    for i in range(1, full + 1):
        t0, t1 = film.conductance[i - 1], film.conductance[i]
        stretch = bearing.kappa * film.cubed[i]
        source = film.couette[i - 1] - film.couette[i] - film.squeeze[i]
        if i == 1:
            source += t0 * bearing.lands[k, START_PRESSURE]
        if i == n - 1:
            source += t1 * bearing.lands[k, END_PRESSURE]
        ox, oy = grid.weight_x[k, i], grid.weight_y[k, i]
        for e in range(m):
            axial_term = stretch * axial.eigenvalues[e]
            q = axial.mode_weights[e]
            y0, y1, y2 = q * (source + axial_term * bearing.side_pressure), -q * ox, -q * oy
            d = t0 + t1 + axial_term
            if i > 1:
                f = t0 * pivot[i - 1, e]
                d -= t0 * f
                y0 += f * swept[i - 1, 0, e]
                y1 += f * swept[i - 1, 1, e]
                y2 += f * swept[i - 1, 2, e]
            pivot[i, e] = 1.0 / d
            swept[i, 0, e], swept[i, 1, e], swept[i, 2, e] = y0, y1, y2


@inlined
def full_line_to_nodes(axial, lines, i):
    """Express the factor and the right-hand sides of the last full line in nodes."""
    m = len(axial.size)
    for a in range(m):
        for b in range(m):
            total = 0.0
            for e in range(m):
                total += axial.modes[a, e] * lines.pivot[i, e] * axial.modes[b, e]
            lines.inverse[i, a, b] = total
    for r in range(3):
        for e in range(m):
            lines.modal[i, r, e] = lines.swept[i, r, e]
    rotate(axial.modes, lines.modal, lines.swept, i, i, m)


@inlined
def rotate(matrix, vectors, result, first, last, m):
    """Lines first..last of ``result`` = matrix times those of ``vectors``, for the pressure and both adjoints."""
    for i in range(first, last + 1):
        for a in range(m):
            r0, r1, r2 = 0.0, 0.0, 0.0
            for b in range(m):
                entry = matrix[a, b]
                r0 += entry * vectors[i, 0, b]
                r1 += entry * vectors[i, 1, b]
                r2 += entry * vectors[i, 2, b]
            result[i, 0, a], result[i, 1, a], result[i, 2, a] = r0, r1, r2


@inlined
def sweep_broken_lines(axial, bearing, grid, k, film, lines, broken, between):
    """Forward elimination in nodal coordinates from the first broken line on."""
    m = len(axial.size)
    n = film.conductance.size
    conserving, wet = bearing.conserving, grid.wet
    inverse, swept = lines.inverse, lines.swept
    for i in range(broken, n):
        if lines.wet_count[i] == 0 and not conserving:
            for a in range(m):
                lines.lower[i, a], lines.upper[i, a] = 0.0, 0.0
            continue
        if lines.wet_count[i] == 0:
            sweep_dry_line(axial, bearing, grid, k, film, lines, i)
            continue
        t0, t1 = film.conductance[i - 1], film.conductance[i]
        stretch = bearing.kappa * film.cubed[i]
        source = film.couette[i - 1] - film.couette[i] - film.squeeze[i]
        void_here = -(film.couette[i] + film.squeeze[i]) if conserving else 1.0
        for a in range(m):
            here, before = wet[k, i, a], wet[k, i - 1, a]
            lower, upper = 0.0, 0.0
            if conserving:
                lower = -t0 if before else film.couette[i - 1]
                upper = -t0 if here else 0.0
            elif here and before:
                lower = upper = -t0
            lines.lower[i, a], lines.upper[i, a] = lower, upper
            q = axial.root_weights[a]
            row_counts = here or conserving
            right = 0.0
            if row_counts:
                right = q * source + stretch * axial.load[a] * bearing.side_pressure
                if i == 1:
                    inlet = t0 * bearing.lands[k, START_PRESSURE] if here else film.inlet[0] - film.couette[0]
                    right += q * inlet
                if i == n - 1:
                    right += q * t1 * bearing.lands[k, END_PRESSURE]
            swept[i, 0, a] = right
            swept[i, 1, a] = -q * grid.weight_x[k, i] if here else 0.0
            swept[i, 2, a] = -q * grid.weight_y[k, i] if here else 0.0
            for b in range(m):
                inverse[i, a, b] = stretch * axial.stiffness[a, b] if row_counts and wet[k, i, b] else 0.0
            inverse[i, a, a] = inverse[i, a, a] + t0 + t1 if here else void_here
        if between:
            apply_ends(axial, film, lines, i, stretch, conserving, wet[k, i])
        if i > 1 and (conserving or lines.wet_count[i - 1] > 0):
            for a in range(m):
                r0, r1, r2 = 0.0, 0.0, 0.0
                lower, upper = lines.lower[i, a], lines.upper[i, a]
                for b in range(m):
                    entry, mirrored = inverse[i - 1, a, b], inverse[i - 1, b, a]
                    inverse[i, a, b] -= lower * entry * lines.upper[i, b]
                    r0 += entry * swept[i - 1, 0, b]
                    r1 += mirrored * swept[i - 1, 1, b]
                    r2 += mirrored * swept[i - 1, 2, b]
                swept[i, 0, a] -= lower * r0
                swept[i, 1, a] -= upper * r1
                swept[i, 2, a] -= upper * r2
        invert(inverse, i, m)


@inlined
def sweep_dry_line(axial, bearing, grid, k, film, lines, i):
    """Forward elimination of a line without pressure: every column transports its void."""
    m = len(axial.size)
    n = film.conductance.size
    inverse, swept = lines.inverse, lines.swept
    t0, arriving = film.conductance[i - 1], film.couette[i - 1]
    source = arriving - film.couette[i] - film.squeeze[i]
    if i == 1:
        source += film.inlet[0] - film.couette[0]
    if i == n - 1:
        source += film.conductance[i] * bearing.lands[k, END_PRESSURE]
    side = bearing.kappa * film.cubed[i] * bearing.side_pressure
    pivot = -1.0 / (film.couette[i] + film.squeeze[i])
    for a in range(m):
        lower = -t0 if grid.wet[k, i - 1, a] else arriving
        lines.lower[i, a], lines.upper[i, a] = lower, 0.0
        right = axial.root_weights[a] * source + axial.load[a] * side
        if i > 1 and lines.wet_count[i - 1] == 0:
            right -= lower * inverse[i - 1, a, a] * swept[i - 1, 0, a]
        elif i > 1:
            for b in range(m):
                right -= lower * inverse[i - 1, a, b] * swept[i - 1, 0, b]
        swept[i, 0, a], swept[i, 1, a], swept[i, 2, a] = right, 0.0, 0.0
        for b in range(m):
            inverse[i, a, b] = pivot if a == b else 0.0


@inlined
def invert(blocks, i, m):
    """Invert block i in place, Gauss-Jordan without pivoting (wet rows are heavy there, dry columns diagonal)."""
    for c in range(m):
        pivot = 1.0 / blocks[i, c, c]
        blocks[i, c, c] = 1.0
        for b in range(m):
            blocks[i, c, b] *= pivot
        for a in range(m):
            if a != c:
                factor = blocks[i, a, c]
                blocks[i, a, c] = 0.0
                for b in range(m):
                    blocks[i, a, b] -= factor * blocks[i, c, b]


@inlined
def back_substitute(lines, first, n, m, conserving):
    """Solution in nodal coordinates from the last line back to ``first``."""
    inverse, swept, solution = lines.inverse, lines.swept, lines.solution
    for i in range(n - 1, first - 1, -1):
        if lines.wet_count[i] == 0 and not conserving:
            for r in range(3):
                for a in range(m):
                    solution[i, r, a] = 0.0
            continue
        if i < n - 1:
            for b in range(m):
                swept[i, 0, b] -= lines.upper[i + 1, b] * solution[i + 1, 0, b]
                swept[i, 1, b] -= lines.lower[i + 1, b] * solution[i + 1, 1, b]
                swept[i, 2, b] -= lines.lower[i + 1, b] * solution[i + 1, 2, b]
        if lines.wet_count[i] == 0:
            for r in range(3):
                for a in range(m):
                    solution[i, r, a] = inverse[i, a, a] * swept[i, r, a]
            continue
        for a in range(m):
            r0, r1, r2 = 0.0, 0.0, 0.0
            for b in range(m):
                r0 += inverse[i, a, b] * swept[i, 0, b]
                r1 += inverse[i, b, a] * swept[i, 1, b]
                r2 += inverse[i, b, a] * swept[i, 2, b]
            solution[i, 0, a], solution[i, 1, a], solution[i, 2, a] = r0, r1, r2
