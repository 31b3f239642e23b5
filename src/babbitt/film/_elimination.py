"""Kernels: the pressure of a land and its two adjoints, by elimination from line to line.

Rows, divided by sqrt(w_j), with u = sqrt(w) p and sigma = sqrt(w) s, s = 1 - liquid fraction:

    sqrt(w_j) (Q_i - Q_i-1 + S_i) + T_i (u_i - u_i+1)_j - T_i-1 (u_i-1 - u_i)_j
        + kappa H_i (K~ (u_i - p_side sqrt(w)))_j = 0,        kappa = (D/B)^2 / 12.

A dry node (p = 0) of the Reynolds condition loses its row and its column. A dry node of the mass-conserving condition
keeps its row; its column carries sigma, transported downstream: -(Q_i + S_i) here and +Q_i in the next line.

Either way the matrix is block tridiagonal with diagonal coupling, and  S_i = D_i - L_i S_i-1^-1 U_i.
Lines that are full across the width, counted from the start of the land, are diagonal in the modes of K~ and cost O(m);
from the first line with a dry node on, blocks are inverted. The adjoints A^T l = -d(F)/du use the same factors.
"""

from __future__ import annotations

from babbitt.film._structs import END_PRESSURE, START_PRESSURE, compiled


@compiled
def count_wet(lines, m):
    """Count the wet nodes of every line; returns the index of the first unknown line with a dry node, or n."""
    n = lines.wet.shape[0] - 1
    broken = n
    for i in range(n - 1, 0, -1):
        count = 0
        for j in range(m):
            if lines.wet[i, j]:
                count += 1
        lines.wet_count[i] = count
        if count < m:
            broken = i
    lines.wet_count[0] = lines.wet_count[n] = m
    return broken


@compiled
def solve_land(axial, land, grid, film, lines, kappa, side_pressure, conserving, nodal_from):
    """Solve for pressure (or void) and the adjoints of both force components, with the wet set as it stands.

    Lines are treated in modes up to the line before the first one with a dry node, but at most to nodal_from - 1.
    """
    m = len(axial.size)
    n = film.conductance.size
    broken = count_wet(lines, m)
    broken = min(broken, max(nodal_from, 1))
    full = broken - 1  # lines 1..full are full
    sweep_full_lines(axial, land, grid, film, lines, kappa, side_pressure, full)
    if broken < n:
        if full > 0:
            full_line_to_nodes(axial, lines, full)
        for i in range(broken, n):
            if lines.wet_count[i] == 0 and not conserving:
                lines.lower[i, :] = 0.0
                lines.upper[i, :] = 0.0
            else:
                sweep_broken_line(axial, land, grid, film, lines, kappa, side_pressure, conserving, i)
        for i in range(n - 1, max(full, 1) - 1, -1):
            if lines.wet_count[i] == 0 and not conserving:
                lines.solution[i, :, :] = 0.0
            else:
                back_substitute(lines, i, n, m)
        if full > 0:
            rotate(axial.modes_transposed, lines.solution[full], lines.modal[full], m)
    elif full > 0:
        for r in range(3):
            for k in range(m):
                lines.modal[full, r, k] = lines.pivot[full, k] * lines.swept[full, r, k]
    for i in range(full - 1, 0, -1):
        t = film.conductance[i]
        for r in range(3):
            for k in range(m):
                lines.modal[i, r, k] = lines.pivot[i, k] * (lines.swept[i, r, k] + t * lines.modal[i + 1, r, k])
    for i in range(1, full + 1):
        rotate(axial.modes, lines.modal[i], lines.solution[i], m)
    for j in range(m):
        lines.solution[0, 0, j] = axial.root_weights[j] * land[START_PRESSURE]
        lines.solution[n, 0, j] = axial.root_weights[j] * land[END_PRESSURE]


@compiled
def sweep_full_lines(axial, land, grid, film, lines, kappa, side_pressure, full):
    """Forward elimination of the lines 1..full in modal coordinates."""
    m = len(axial.size)
    n = film.conductance.size
    for i in range(1, full + 1):
        t0, t1 = film.conductance[i - 1], film.conductance[i]
        stretch = kappa * film.cubed[i]
        source = film.couette[i - 1] - film.couette[i] - film.squeeze[i]
        if i == 1:
            source += t0 * land[START_PRESSURE]
        if i == n - 1:
            source += t1 * land[END_PRESSURE]
        ox, oy = grid.weight_x[i], grid.weight_y[i]
        for k in range(m):
            axial_term = stretch * axial.eigenvalues[k]
            q = axial.mode_weights[k]
            d = t0 + t1 + axial_term
            f = 0.0
            if i > 1:
                f = t0 * lines.pivot[i - 1, k]
                d -= t0 * f
            lines.pivot[i, k] = 1.0 / d
            lines.swept[i, 0, k] = q * (source + axial_term * side_pressure) + f * lines.swept[i - 1, 0, k]
            lines.swept[i, 1, k] = -q * ox + f * lines.swept[i - 1, 1, k]
            lines.swept[i, 2, k] = -q * oy + f * lines.swept[i - 1, 2, k]


@compiled
def full_line_to_nodes(axial, lines, i):
    """Express the factor and the right-hand sides of the last full line in nodes."""
    m = len(axial.size)
    for a in range(m):
        for b in range(m):
            total = 0.0
            for k in range(m):
                total += axial.modes[a, k] * lines.pivot[i, k] * axial.modes[b, k]
            lines.inverse[i, a, b] = total
    for r in range(3):
        for k in range(m):
            lines.modal[i, r, k] = lines.swept[i, r, k]
    rotate(axial.modes, lines.modal[i], lines.swept[i], m)


@compiled
def rotate(matrix, vectors, result, m):
    """result[r] = matrix @ vectors[r] for the pressure and both adjoints."""
    for a in range(m):
        r0, r1, r2 = 0.0, 0.0, 0.0
        for k in range(m):
            r0 += matrix[a, k] * vectors[0, k]
            r1 += matrix[a, k] * vectors[1, k]
            r2 += matrix[a, k] * vectors[2, k]
        result[0, a], result[1, a], result[2, a] = r0, r1, r2


@compiled
def sweep_broken_line(axial, land, grid, film, lines, kappa, side_pressure, conserving, i):
    """Forward elimination of one line in nodal coordinates: block, its inverse, right-hand sides."""
    m = len(axial.size)
    n = film.conductance.size
    wet, block, swept = lines.wet, lines.inverse[i], lines.swept[i]
    t0, t1 = film.conductance[i - 1], film.conductance[i]
    stretch = kappa * film.cubed[i]
    source = film.couette[i - 1] - film.couette[i] - film.squeeze[i]
    void_here = -(film.couette[i] + film.squeeze[i])
    for a in range(m):
        here, before = wet[i, a], wet[i - 1, a]
        lower, upper = 0.0, 0.0
        if i > 1:
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
            right = q * source + stretch * axial.load[a] * side_pressure
            if i == 1:
                right += q * (t0 * land[START_PRESSURE] if here else film.inlet[0] - film.couette[0])
            if i == n - 1:
                right += q * t1 * land[END_PRESSURE]
        swept[0, a] = right
        swept[1, a] = -q * grid.weight_x[i] if here else 0.0
        swept[2, a] = -q * grid.weight_y[i] if here else 0.0
        for b in range(m):
            entry = 0.0
            if wet[i, b] and row_counts:
                entry = stretch * axial.stiffness[a, b]
                if a == b:
                    entry += t0 + t1 + lines.ending[i, a]
            elif a == b:
                entry = void_here if conserving else 1.0
            block[a, b] = entry
    if i > 1 and (conserving or lines.wet_count[i - 1] > 0):
        before_inverse, before_swept = lines.inverse[i - 1], lines.swept[i - 1]
        for a in range(m):
            r0, r1, r2 = 0.0, 0.0, 0.0
            for b in range(m):
                entry = before_inverse[a, b]
                block[a, b] -= lines.lower[i, a] * entry * lines.upper[i, b]
                r0 += entry * before_swept[0, b]
                r1 += before_inverse[b, a] * before_swept[1, b]
                r2 += before_inverse[b, a] * before_swept[2, b]
            swept[0, a] -= lines.lower[i, a] * r0
            swept[1, a] -= lines.upper[i, a] * r1
            swept[2, a] -= lines.upper[i, a] * r2
    if lines.wet_count[i] > 0:
        invert(block, m)
    else:
        for a in range(m):
            block[a, a] = 1.0 / block[a, a]


@compiled
def invert(block, m):
    """Inverse in place, Gauss-Jordan without pivoting (wet rows are diagonally heavy, dry columns diagonal)."""
    for k in range(m):
        pivot = 1.0 / block[k, k]
        block[k, k] = 1.0
        for b in range(m):
            block[k, b] *= pivot
        for a in range(m):
            if a != k:
                factor = block[a, k]
                block[a, k] = 0.0
                for b in range(m):
                    block[a, b] -= factor * block[k, b]


@compiled
def back_substitute(lines, i, n, m):
    """Solution of one line in nodal coordinates from the line behind it."""
    inverse, swept, solution = lines.inverse[i], lines.swept[i], lines.solution[i]
    if i < n - 1:
        for b in range(m):
            swept[0, b] -= lines.upper[i + 1, b] * lines.solution[i + 1, 0, b]
            swept[1, b] -= lines.lower[i + 1, b] * lines.solution[i + 1, 1, b]
            swept[2, b] -= lines.lower[i + 1, b] * lines.solution[i + 1, 2, b]
    for a in range(m):
        r0, r1, r2 = 0.0, 0.0, 0.0
        for b in range(m):
            r0 += inverse[a, b] * swept[0, b]
            r1 += inverse[b, a] * swept[1, b]
            r2 += inverse[b, a] * swept[2, b]
        solution[0, a], solution[1, a], solution[2, a] = r0, r1, r2
