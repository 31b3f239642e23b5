"""Kernels: temperature of the film, across the gap and along it, by finite volumes that conserve energy.

Balance of layer k of a cell (``_heat_flows``), phi the flows through its faces, upwind along the film:

    sum_out phi T_k - sum_in phi T_up + flux_k+1/2 - flux_k-1/2 = heat_k

Between layers oil moves and heat is conducted, F = D [B(-M/D) T_k - B(M/D) T_k+1] with B(x) = x / (exp(x) - 1),
which is exact where both are constant. The matrices of the cells do not depend on temperature: a film has its
own once, and a sweep only fills right-hand sides. Source: Patankar, Numerical Heat Transfer and Fluid Flow
(1980), 5.2 (exponential scheme).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy import float64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inlined, inner

Array = NDArray[float64]


class Cells(NamedTuple):
    """Factors of the layers of every cell and what comes in, all (lines, columns, layers) unless said."""

    factor: Array  # of the layer below, in the forward sweep
    pivot: Array  # inverse
    high: Array  # coupling to the layer above, times the pivot
    heat: Array  # dissipation, and fresh oil from the sides
    west: Array  # flow that comes from the line before
    east: Array  # flow that comes back from the line behind
    inner: Array  # flow that comes from the column before
    outer: Array  # flow that comes from the column behind
    bush: Array  # conductance to the bush, (lines, columns)
    journal: Array  # to the journal, (lines, columns)


@compiled
def new_cells(lines, columns, layers):
    """Cells of a film, not filled yet."""
    shape, flat = (lines, columns, layers), (lines, columns)
    return Cells(
        np.zeros(shape), np.zeros(shape), np.zeros(shape), np.zeros(shape), np.zeros(shape), np.zeros(shape),
        np.zeros(shape), np.zeros(shape), np.zeros(flat), np.zeros(flat),
    )  # fmt: skip


@inlined
def bernoulli(x):
    """x / (exp(x) - 1); by its series where conduction leads."""
    if abs(x) < 0.3:
        x2 = x * x
        return 1.0 - 0.5 * x + x2 * (1.0 / 12.0 - x2 * (1.0 / 720.0 - x2 / 30240.0))
    if x > 500.0:
        return 0.0
    return x / (math.exp(x) - 1.0)


@inlined
def in_series(conductance, wall):
    """Conductance of half a layer and the wall behind it."""
    if wall == 0.0 or conductance == 0.0:
        return 0.0
    return conductance if wall == math.inf else conductance * wall / (conductance + wall)


@compiled
def fill_cells(surface, columns, flows, conduction, stirred, bush, journal, fresh, viscosity, cells):
    """Factors and sources of all cells; ``conduction`` is k / (rho c omega c^2), ``fresh`` enters at the sides.

    Heat goes through a wall of the conductance ``bush`` or ``journal``, over rho c omega c: zero where it is
    insulated, infinite where it has the temperature that is given.

    Turbulence conducts between layers: k (1 + s (f - 1)) with f the turbulent over the laminar shear and s the
    Prandtl number of the oil of the cell over that of turbulence, ``stirred`` at unit viscosity; the halves of the
    outer layers beside the walls stay laminar.
    """
    lines, n = flows.gap.shape[0], surface.step.size
    layers, last = len(columns.layers), flows.gap.shape[1] - 1
    low, diagonal, high, spread = np.empty(layers), np.empty(layers), np.zeros(layers), np.empty(layers)
    for i in range(lines):
        west, east = (i - 1) % n, i % n
        width = 0.5 * (surface.step[west] + surface.step[east])
        for c in range(last + 1):
            if columns.supply[i, c] >= 0 or not flows.gap[i, c] > 0.0:
                continue
            conduct = conduction * width * columns.size[c] * flows.fill[i, c] / flows.gap[i, c]
            leak, inward = flows.leak[i, c], flows.axial[i, c - 1] if c > 0 else 0.0
            outward = flows.axial[i, c] if c < last else 0.0
            # heat among the layers: stress squared over viscosity
            slope = flows.stress[east, c] * flows.pressure[east, c] / (columns.size[c] * flows.gap[i, c])
            level, eta, total = surface.speed * flows.shear_viscosity[east, c], 0.0, 0.0
            for k in range(layers):
                stress = level + slope * (eta + 0.5 * columns.layer[k] - flows.balance[east, c])
                spread[k] = columns.layer[k] * stress * stress / viscosity[i, c, k]
                total += spread[k]
                eta += columns.layer[k]
            for k in range(layers):
                spread[k] = spread[k] / total if total > 0.0 else columns.layer[k]
            prandtl = stirred * flows.shear_viscosity[east, c]
            stirring, across = conduct * (1.0 + prandtl * (flows.stir[i, c] - 1.0)), 0.0
            for k in range(layers):
                diagonal[k] = AT_REST
                low[k] = 0.0
            # oil that a film without mass conservation has from nowhere enters, and what it loses leaves, at T_k
            made = flows.shear[east, c] + flows.pressure[east, c] + outward + leak
            made -= flows.shear[west, c] + flows.pressure[west, c] + inward
            if surface.conserving:
                made = 0.0
            for k in range(layers):
                arrives = flows.shear[west, c] * flows.shear_profile[west, c, k]
                arrives += flows.pressure[west, c] * flows.pressure_profile[west, c, k]
                leaves = flows.shear[east, c] * flows.shear_profile[east, c, k]
                leaves += flows.pressure[east, c] * flows.pressure_profile[east, c, k]
                profile = flows.pressure_profile[east, c, k]
                behind = inward * flows.pressure_profile[east, c - 1, k] if c > 0 else 0.0
                ahead, aside = outward * profile, leak * profile
                cells.west[i, c, k], cells.east[i, c, k] = max(arrives, 0.0), max(-leaves, 0.0)
                cells.inner[i, c, k], cells.outer[i, c, k] = max(behind, 0.0), max(-ahead, 0.0)
                diagonal[k] += max(-arrives, 0.0) + max(leaves, 0.0) + max(-behind, 0.0) + max(ahead, 0.0)
                born = made * flows.shear_profile[east, c, k]
                diagonal[k] += max(aside, 0.0) - born
                cells.heat[i, c, k] = flows.heat[i, c] * spread[k] + max(-aside, 0.0) * fresh
                across -= leaves - arrives + ahead + aside - behind - born
                if k < layers - 1:
                    between = 2.0 * stirring / (columns.layer[k] + columns.layer[k + 1])
                    if between > 0.0:
                        down = between * bernoulli(across / between)
                        up = down + across
                    else:
                        up, down = max(across, 0.0), max(-across, 0.0)
                    diagonal[k] += up
                    high[k] = -down
                    low[k + 1] = -up
                    diagonal[k + 1] += down
            area = width * columns.size[c]
            cells.bush[i, c] = in_series(conduct / (0.5 * columns.layer[0]), bush * area)
            cells.journal[i, c] = in_series(conduct / (0.5 * columns.layer[layers - 1]), journal * area)
            diagonal[0] += cells.bush[i, c]
            diagonal[layers - 1] += cells.journal[i, c]
            pivot, factor = 0.0, 0.0
            for k in range(layers):
                if k > 0:
                    factor = low[k] * pivot
                    diagonal[k] -= factor * high[k - 1]
                pivot = 1.0 / diagonal[k]
                cells.factor[i, c, k], cells.pivot[i, c, k], cells.high[i, c, k] = factor, pivot, high[k] * pivot


AT_REST = 1e-14  # a cell that nothing passes keeps its temperature
MOST_SHARE = 0.97  # of a change that the next sweep repeats: more is not extrapolated


@compiled
def sweep_energy(surface, columns, flows, cells, walls, temperature, groove, most, tolerance):
    """March round the film until its temperatures, and those of the supplies, rest. Returns the last change.

    Oil that goes round many times before it leaves warms slowly, and in one pattern: of two sweeps the changes
    d_1, d_2 tell its share lambda = d_1 d_2 / d_1^2, and lambda / (1 - lambda) d_2 is what is still to come
    (Aitken). Only after sweeps that change less than before the last such step: oil with more than one pattern
    would be thrown ever further.
    """
    lines, count, layers = temperature.shape[0], temperature.shape[1], len(columns.layers)
    right = np.empty(layers)
    before, last = np.empty(temperature.shape), np.empty(temperature.shape)
    change, trusted = 0.0, np.inf
    for turn in range(most):
        change = 0.0
        copy_layers(temperature, before)
        for i in range(lines):
            for c in range(count):
                s = columns.supply[i, c]
                if s >= 0:
                    if (i == 0 or columns.supply[i - 1, c] != s) and (c == 0 or columns.supply[i, c - 1] != s):
                        moved = mix(surface, columns, flows, walls, temperature, groove, s)
                        change = max(change, moved)
                    for k in range(layers):
                        temperature[i, c, k] = groove[s]
                elif flows.gap[i, c] > 0.0:
                    change = max(change, solve_cell(columns, cells, walls, temperature, i, c, right))
        if change < tolerance:
            break
        if turn % 3 == 0:
            for i in range(lines):
                for c in range(count):
                    for k in range(layers):
                        last[i, c, k] = temperature[i, c, k] - before[i, c, k]
        elif turn % 3 == 1 and turn < most - 1 and change < trusted:
            trusted = change
            extrapolate(temperature, before, last, columns, groove)
    return change


@inner
def copy_layers(temperature, before):
    """Keep temperatures in ``before``. (An assignment of whole arrays takes seconds to compile.)"""
    for i in range(temperature.shape[0]):
        for c in range(temperature.shape[1]):
            for k in range(temperature.shape[2]):
                before[i, c, k] = temperature[i, c, k]


@inlined
def solve_cell(columns, cells, walls, temperature, i, c, right):
    """Temperatures of one cell, its neighbours as they are; returns their largest change."""
    lines, count, layers = temperature.shape[0], temperature.shape[1], len(columns.layers)
    before, after = i - 1 if i > 0 else lines - 1, i + 1 if i < lines - 1 else 0
    for k in range(layers):
        right[k] = cells.heat[i, c, k] + AT_REST * temperature[i, c, k]
        right[k] += cells.west[i, c, k] * temperature[before, c, k]
        right[k] += cells.east[i, c, k] * temperature[after, c, k]
    if c > 0:
        for k in range(layers):
            right[k] += cells.inner[i, c, k] * temperature[i, c - 1, k]
    if c < count - 1:
        for k in range(layers):
            right[k] += cells.outer[i, c, k] * temperature[i, c + 1, k]
    right[0] += cells.bush[i, c] * walls.bush[i]
    right[layers - 1] += cells.journal[i, c] * walls.journal[0]
    value = 0.0
    for k in range(layers):
        value = right[k] - cells.factor[i, c, k] * value
        right[k] = value * cells.pivot[i, c, k]
    change, value = 0.0, 0.0
    for k in range(layers - 1, -1, -1):
        value = right[k] - cells.high[i, c, k] * value
        change = max(change, abs(value - temperature[i, c, k]))
        temperature[i, c, k] = value
    return change


@inner
def extrapolate(temperature, before, last, columns, groove):
    """Add what is still to come of a change that every sweep repeats in part."""
    lines, count, layers = temperature.shape[0], temperature.shape[1], len(columns.layers)
    both, alone = 0.0, 0.0
    for i in range(lines):
        for c in range(count):
            for k in range(layers):
                both += (temperature[i, c, k] - before[i, c, k]) * last[i, c, k]
                alone += last[i, c, k] * last[i, c, k]
    share = min(max(both / alone, 0.0), MOST_SHARE) if alone > 0.0 else 0.0
    for i in range(lines):
        for c in range(count):
            s = columns.supply[i, c]
            for k in range(layers):
                temperature[i, c, k] += (temperature[i, c, k] - before[i, c, k]) * share / (1.0 - share)
            if s >= 0:
                groove[s] = temperature[i, c, 0]


@inner
def mix(surface, columns, flows, walls, temperature, groove, s):
    """Mixing temperature of a supply: what is carried over of the oil that the film brings, and fresh oil for
    the rest. Returns its change.

    Oil that is not carried over leaves the supply as it came.
    """
    enthalpy = np.zeros(1)
    brought, taken = groove_balance(
        surface, columns, flows, 1.0, temperature.reshape((*temperature.shape, 1)), s, enthalpy
    )
    kept = walls.carry_over * brought
    added = max(taken - kept, 0.0)
    if kept + added <= 0.0:
        return 0.0
    before = groove[s]
    groove[s] = (walls.carry_over * enthalpy[0] + added * walls.fresh) / (kept + added)
    return abs(groove[s] - before)


@compiled
def supply_balances(surface, columns, flows, temperature, supplies):
    """Flow that the film brings to every supply, flow that it takes, and enthalpy (``groove_balance``)."""
    brought, taken, enthalpy = np.empty(supplies), np.empty(supplies), np.empty((supplies, 1))
    temperatures = temperature.reshape((*temperature.shape, 1))
    for s in range(supplies):
        brought[s], taken[s] = groove_balance(surface, columns, flows, 1.0, temperatures, s, enthalpy[s])
    return brought, taken, enthalpy[:, 0]


@compiled
def groove_balance(surface, columns, flows, sources, temperatures, s, enthalpy):
    """Flow that the film brings to a supply, and the flow that it takes.

    ``enthalpy`` (states,) is filled with that of the flow brought and the heat born in the supply, for every one
    of the ``temperatures`` (lines, columns, layers, states).
    """
    lines, n, layers, states = temperatures.shape[0], surface.step.size, len(columns.layers), enthalpy.size
    count = columns.size.size
    brought, taken = 0.0, 0.0
    enthalpy[:] = 0.0
    for i in range(n):
        after = (i + 1) % lines
        for c in range(count):
            own, other = columns.supply[i, c] == s, columns.supply[after, c] == s
            if own == other:
                continue
            for k in range(layers):
                phi = flows.shear[i, c] * flows.shear_profile[i, c, k]
                phi += flows.pressure[i, c] * flows.pressure_profile[i, c, k]
                if own:
                    phi = -phi  # now positive into the supply
                if phi > 0.0:
                    brought += phi
                    for m in range(states):
                        enthalpy[m] += phi * temperatures[after if own else i, c, k, m]
                else:
                    taken -= phi
    for i in range(lines):
        for c in range(count):
            own = columns.supply[i, c] == s
            if own:
                for m in range(states):
                    enthalpy[m] += sources * flows.heat[i, c]
            if c < count - 1 and own != (columns.supply[i, c + 1] == s):
                phi = -flows.axial[i, c] if own else flows.axial[i, c]
                if phi <= 0.0:
                    taken -= phi
                    continue
                brought += phi
                for k in range(layers):
                    part = phi * flows.pressure_profile[i % n, c, k]
                    for m in range(states):
                        enthalpy[m] += part * temperatures[i, c + 1 if own else c, k, m]
    return brought, taken
