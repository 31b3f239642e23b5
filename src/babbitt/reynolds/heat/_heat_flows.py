"""Kernels: flows and heat of a film with variable viscosity across the gap, from the Reynolds solution.

Cells lie around the lines, one per column of the width (all nodes of a line together, or each node its own), and
are cut into layers across the gap, eta = 0 on the bush and 1 on the journal. Layers share the flows of the
Reynolds solution, so that no oil is lost: with J_n(eta) = int_0^eta eta'^n / mu d eta' and J_n = J_n(1)

    u = (U / J_0) J_0(eta) + h^2 dp/dx [J_1(eta) - (J_1/J_0) J_0(eta)],
    mean flow  C U h - F h^3 dp/dx,   C = 1 - J_1/J_0,   F = J_2 - J_1^2/J_0.

Dimensionless as ``_surface_film``; heat is dissipation times mu omega R^2 / (rho c c^2), temperature times flow.
Source: Dowson, A generalized Reynolds equation for fluid-film lubrication, Int. J. Mech. Sci. 4 (1962) 159-170.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import float64, int64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inlined
from babbitt.reynolds.oil._turbulent_oil import stirred
from babbitt.reynolds.surface._surface_film import gap_at

Array = NDArray[float64]


class Columns(NamedTuple):
    """How nodes gather to columns, and the layers."""

    column: NDArray[int64]  # of every node, (nodes,)
    supply: NDArray[int64]  # supply that a cell belongs to, or -1, (lines, columns)
    side: NDArray[int64]  # 1 where a node lies on a side edge, (nodes,)
    layers: tuple[int, ...] | NDArray[int64]  # as many zeros as layers; the usual number is known to the compiler
    layer: Array  # their thickness, (layers,), summing to 1
    size: Array  # share of the width of every column, (columns,)


class Flows(NamedTuple):
    """Flows and heat of the cells, from the Reynolds solution."""

    shear: Array  # flow by shear through every interval, (n, columns)
    pressure: Array  # flow by pressure, (n, columns)
    axial: Array  # to the next column, (lines, columns)
    leak: Array  # out over the sides, (lines, columns)
    heat: Array  # dissipation, (lines, columns)
    gap: Array  # (lines, columns)
    fill: Array  # (lines, columns)
    stir: Array  # turbulent over laminar shear, (lines, columns)
    shear_profile: Array  # share of the layers in the flow by shear, (n, columns, layers)
    pressure_profile: Array  # share of the layers in the flow by pressure
    stress: Array  # shear stress over that of the surface speed at unit flow by pressure: slope, (n, columns)
    balance: Array  # J_1/J_0: where the flow by pressure has no stress, (n, columns)
    shear_viscosity: Array  # 1/J_0, (n, columns)


@compiled
def new_flows(lines, n, columns, layers):
    """Flows of a film, not filled yet."""
    cell, between = (lines, columns), (n, columns)
    return Flows(
        np.zeros(between), np.zeros(between), np.zeros(cell), np.zeros(cell), np.zeros(cell), np.zeros(cell),
        np.zeros(cell), np.ones(cell), np.zeros((n, columns, layers)), np.zeros((n, columns, layers)),
        np.zeros(between), np.zeros(between), np.zeros(between),
    )  # fmt: skip


@compiled
def spread_viscosity(surface, columns, viscosity, flows):
    """Effective viscosity and drag of every interval from the viscosity (lines, columns, layers), in place."""
    n, layers = surface.step.size, len(columns.layers)
    lines = viscosity.shape[0]
    effective, drag = np.empty(columns.size.size), np.empty(columns.size.size)
    fluid = np.empty(layers)
    for i in range(n):
        after = (i + 1) % lines
        for c in range(columns.size.size):
            j0, j1, j2, low = 0.0, 0.0, 0.0, 0.0
            for k in range(layers):
                fluid[k] = 2.0 / (viscosity[i, c, k] + viscosity[after, c, k])
                high = low + columns.layer[k]
                j0 += fluid[k] * (high - low)
                j1 += fluid[k] * 0.5 * (high * high - low * low)
                j2 += fluid[k] * (high * high * high - low * low * low) * (1.0 / 3.0)
                low = high
            level = 1.0 / j0
            balance = j1 * level
            steeper = 1.0 / (j2 - j1 * balance)
            effective[c], drag[c] = steeper * (1.0 / 12.0), 2.0 * (1.0 - balance)
            flows.shear_viscosity[i, c], flows.balance[i, c] = level, balance
            flows.stress[i, c] = -steeper
            # profiles: the mean over a layer of J_0(eta) / J_0 and J_1(eta) - (J_1/J_0) J_0(eta), by Simpson
            s0, s1, low, total_s, total_p = 0.0, 0.0, 0.0, 0.0, 0.0
            for k in range(layers):
                d = columns.layer[k]
                mean0 = s0 + fluid[k] * 0.5 * d
                mean1 = s1 + fluid[k] * d * (0.5 * low + d * (1.0 / 6.0))
                flows.shear_profile[i, c, k] = d * mean0
                flows.pressure_profile[i, c, k] = d * (balance * mean0 - mean1)
                total_s += flows.shear_profile[i, c, k]
                total_p += flows.pressure_profile[i, c, k]
                s0 += fluid[k] * d
                s1 += fluid[k] * d * (low + 0.5 * d)
                low += d
            total_s, total_p = 1.0 / total_s, 1.0 / total_p
            for k in range(layers):
                flows.shear_profile[i, c, k] *= total_s
                flows.pressure_profile[i, c, k] *= total_p
        for q in range(surface.points):
            c = columns.column[surface.node[q]]
            if surface.viscosity[i, q] < 1e9:  # grooves are plugged
                surface.viscosity[i, q], surface.drag[i, q] = effective[c], drag[c]


@compiled
def gather_flows(surface, film, work, at, columns, flows):
    """Flows, gaps and dissipation of the cells; returns dissipation and friction power of the whole film, and the
    one viscosity that would be sheared with the same power.

    Dissipation of an interval with Q its flux by shear, T its conductance, j_n = int h^-n over it, f and g the
    effective viscosity and drag:   shear + 3 f g^2 (j_1 - j_2^2/j_3) + T (p - p')^2,   and along the line p^T K p;
    friction power, from the stress on the journal: shear + 3 f g^2 (j_1 - j_2^2/j_3) - Q (p - p').
    Their difference is the work of the flow, which vanishes but for supplies under pressure. That of shear is
    U^2 int dx / (J_0 h), where 1/J_0 is the viscosity of the layers in series.
    """
    for array in (flows.shear, flows.pressure, flows.axial, flows.leak, flows.heat, flows.gap, flows.fill):
        array[:] = 0.0
    warmth = np.zeros(surface.held.shape)
    mean_gaps(surface, at, columns, flows)
    friction, viscosity = shear_intervals(surface, work, at, columns, flows, warmth)
    friction -= flow_between_lines(surface, film, work, columns, flows, warmth)
    flow_across(surface, film, work, columns, flows, warmth)
    return flows.heat.sum(), friction, viscosity


@inlined
def mean_gaps(surface, at, columns, flows):
    """Gap of every cell: the mean over the points of the width at the two Gauss points beside its line."""
    lines = surface.held.shape[0]
    weight = np.zeros((lines, columns.size.size))
    for i in range(surface.step.size):
        after = i + 1 if i + 1 < lines else 0
        for q in range(surface.points):
            c, share = columns.column[surface.node[q]], surface.share[q]
            ha, hb = gap_at(surface, at, i, q)
            flows.gap[i, c] += share * ha
            flows.gap[after, c] += share * hb
            weight[i, c] += share
            weight[after, c] += share
    for i in range(lines):
        for c in range(columns.size.size):
            flows.gap[i, c] /= weight[i, c]


@inlined
def shear_intervals(surface, work, at, columns, flows, warmth):
    """Heat by shear of the intervals, half to each line beside; its power, and the viscosity that has it."""
    lines, turbulent = surface.held.shape[0], surface.turbulence.size > 0
    friction, drawn, unit = 0.0, 0.0, 0.0
    for i in range(surface.step.size):
        after = i + 1 if i + 1 < lines else 0
        flows.stir[i] = 0.0
        for q in range(surface.points):
            j = surface.node[q]
            c, share = columns.column[j], surface.share[q]
            ha, hb = gap_at(surface, at, i, q)
            stir_a, stir_b = 1.0, 1.0
            if turbulent:
                stir_a, stir_b = stirring(surface, i, q, ha), stirring(surface, i, q, hb)
            flows.stir[i, c] += share * stir_a / columns.size[c]
            plugged = surface.viscosity[i, q] > 1e9 or (
                surface.held[i, j] and surface.held[after, j] and columns.side[j] == 0
            )
            if plugged:
                continue
            half, speed = 0.5 * surface.step[i], surface.speed * surface.radius[q]
            a, b = 1.0 / ha, 1.0 / hb
            j1 = half * (a + b)
            churned = half * (a * stir_a + b * stir_b)
            one = share * speed * speed * churned * max(work.fill[i, j], 0.0)  # see ``liquid``
            sheared = one * flows.shear_viscosity[i, c]
            drawn += sheared
            unit += one
            if work.holds[i, j] and work.fill[i, j] == 1.0:
                f, g = surface.viscosity[i, q], speed * surface.drag[i, q]
                j2, j3 = half * (a * a + b * b), half * (a * a * a + b * b * b)
                sheared += share * 3.0 * f * g * g * (j1 - j2 * j2 / j3)
            friction += sheared
            warmth[i, j] += 0.5 * sheared
            warmth[after, j] += 0.5 * sheared
    return friction, drawn / unit if unit > 0.0 else 1.0


@inlined
def flow_between_lines(surface, film, work, columns, flows, warmth):
    """Flows by shear and by pressure from line to line, and the heat of the latter; work of the former."""
    lines, worked = surface.held.shape[0], 0.0
    for i in range(surface.step.size):
        after = i + 1 if i + 1 < lines else 0
        for j in range(surface.nodes):
            c = columns.column[j]
            drop = work.pressure[i, j] - work.pressure[after, j]
            flux, push = film.couette[i, j] * work.fill[i, j], film.conductance[i, j] * drop
            if surface.conserving and surface.held[i, j] and not work.holds[after, j]:
                flux, push = film.inlet[i, j] * work.fill[i, j], 0.0
            flows.shear[i, c] += flux
            flows.pressure[i, c] += push
            worked += flux * drop
            warmth[i, j] += 0.5 * push * drop
            warmth[after, j] += 0.5 * push * drop
    return worked


@inlined
def flow_across(surface, film, work, columns, flows, warmth):
    """Flows across the width and over the sides, the heat of all flows and the liquid fraction of the cells."""
    nodes = surface.nodes
    leaving, part = np.empty(nodes), np.empty(nodes)
    for j in range(nodes):
        part[j] = column_share(surface, j)
    for i in range(surface.held.shape[0]):
        leaving[:] = 0.0
        for q in range(surface.points):
            gradient = 0.0
            for b in range(nodes):
                gradient += surface.slope[q, b] * work.pressure[i, b]
            if gradient != 0.0:
                conduct = surface.kappa * surface.share[q] * film.cubed[i, q] * gradient
                warmth[i, surface.node[q]] += conduct * gradient
                for b in range(nodes):
                    leaving[b] += conduct * surface.slope[q, b]
        through = 0.0
        for j in range(nodes):
            c = columns.column[j]
            through += leaving[j]
            if j < nodes - 1 and columns.column[j + 1] != c:
                flows.axial[i, c] += through
            flows.heat[i, c] += warmth[i, j]
            if columns.side[j] == 1 and columns.supply[i, c] < 0:
                flows.leak[i, c] -= work.row[i, j]
            flows.fill[i, c] += min(max(work.fill[i, j], 0.0), 1.0) * part[j] / columns.size[c]


@inlined
def stirring(surface, i, q, gap):
    """Turbulent over laminar shear at a place of the film."""
    law = surface.turbulence
    return stirred(law, law[0] * surface.radius[q] * gap / surface.viscosity[i, q])


@inlined
def column_share(surface, j):
    """Share of the width of a node."""
    total = 0.0
    for q in range(surface.points):
        if surface.node[q] == j:
            total += surface.share[q]
    return total
