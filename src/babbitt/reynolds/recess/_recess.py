"""Kernels: how the film answers to the pressure of each recess, with the factors of the last ``solve_surface``.

For a standing wet set the film is linear: psi_k is the pressure for unit pressure on recess k and zero on all
others. Reynolds condition only, whose matrix A is symmetric; then with R the rows of all nodes and a the motions

    dq_k/dp_j = psi_k^T A psi_j,    dq_k/da = psi_k^T dR/da,    dF/dp_k = -load^T psi_k = (dq_k/da')^T.

The psi cost one back substitution each; nothing is factored anew.
"""

from __future__ import annotations

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner


@compiled
def unit_responses(surface, film, work, recess, psi, conductance, opening, area):
    """Fill psi (n, lines, nodes), dq/dp (n, n), dq/da (n, motions) and dF/dp (motions, n).

    ``recess`` says which recess holds a node, negative elsewhere.
    """
    for k in range(psi.shape[0]):
        sweep(surface, work, recess, psi, k)
    contract(surface, film, work, psi, conductance, opening, area)


@inner
def sweep(surface, work, recess, psi, k):
    """Pressure for unit pressure on recess k, into psi[k]."""
    lines, nodes = recess.shape
    first = 1 if surface.cyclic else 0
    inverse = work.inverse
    for i in range(lines):
        for a in range(nodes):
            psi[k, i, a] = 1.0 if recess[i, a] == k else 0.0
    started = False
    carried = np.zeros(nodes)
    for i in range(first, lines):
        if started:
            apply_inverse(inverse, i - 1, psi[k, i - 1], carried)
            for a in range(nodes):
                psi[k, i, a] -= work.lower[i, a] * carried[a]
        else:
            for a in range(nodes):
                started = started or psi[k, i, a] != 0.0
    for i in range(lines - 1, first - 1, -1):
        if i < lines - 1:
            for a in range(nodes):
                psi[k, i, a] -= work.upper[i + 1, a] * psi[k, i + 1, a]
        apply_inverse(inverse, i, psi[k, i], carried)
        psi[k, i] = carried
    if surface.cyclic:
        last = lines - 1
        right = psi[k, 0].copy()
        for a in range(nodes):
            right[a] -= work.upper[1, a] * psi[k, 1, a] + work.lower[0, a] * psi[k, last, a]
        apply_inverse(inverse, 0, right, carried)
        psi[k, 0] = carried
        for i in range(1, lines):
            for a in range(nodes):
                total = 0.0
                for b in range(nodes):
                    total += work.border[i, a, b] * carried[b]
                psi[k, i, a] -= total
    for i in range(lines):
        for a in range(nodes):
            if not work.holds[i, a]:
                psi[k, i, a] = 0.0


@inlined
def apply_inverse(inverse, i, vector, result):
    """Product of the inverse block i with a vector."""
    nodes = vector.size
    for a in range(nodes):
        total = 0.0
        for b in range(nodes):
            total += inverse[i, a, b] * vector[b]
        result[a] = total


@inner
def contract(surface, film, work, psi, conductance, opening, area):  # noqa: C901 - one pass over lines and points
    """Fill the small matrices from the unit responses."""
    count, lines, nodes = psi.shape
    motions, points = surface.lever.shape
    conductance[:] = 0.0
    opening[:] = 0.0
    area[:] = 0.0
    slopes = np.zeros(count)
    for i in range(lines):
        for q in range(points):
            gradient = 0.0
            for b in range(nodes):
                gradient += surface.slope[q, b] * work.pressure[i, b]
            share = surface.kappa * surface.share[q]
            active = False
            for k in range(count):
                total = 0.0
                for b in range(nodes):
                    total += surface.slope[q, b] * psi[k, i, b]
                slopes[k] = total
                active = active or total != 0.0
            if not active:
                continue
            for k in range(count):
                for j in range(k + 1):
                    conductance[k, j] += share * film.cubed[i, q] * slopes[k] * slopes[j]
                for d in range(motions):
                    opening[k, d] += share * film.cubed_d[d, i, q] * gradient * slopes[k]
        for a in range(nodes):
            for k in range(count):
                for d in range(motions):
                    area[d, k] -= film.load[d, i, a] * psi[k, i, a]
    for i in range(surface.step.size):
        after = (i + 1) % lines
        for a in range(nodes):
            drop = work.pressure[i, a] - work.pressure[after, a]
            for k in range(count):
                own = psi[k, i, a] - psi[k, after, a]
                if own == 0.0:
                    continue
                for j in range(k + 1):
                    conductance[k, j] += film.conductance[i, a] * own * (psi[j, i, a] - psi[j, after, a])
                for d in range(motions):
                    flux = work.fill[i, a] * film.couette_d[d, i, a] + drop * film.conductance_d[d, i, a]
                    opening[k, d] += own * flux
    for k in range(count):
        for j in range(k):
            conductance[j, k] = conductance[k, j]
