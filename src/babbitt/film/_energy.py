"""Kernels: temperature of the film, across the gap and along it, by finite volumes that conserve energy.

Cells lie around the lines, one per column of the width (all nodes of a line together, or each node its own), and
are cut into layers across the gap, eta = 0 on the bush and 1 on the journal. Layers take the flows of the Reynolds
solution, so that no oil is lost: with J_n(eta) = int_0^eta eta'^n / mu d eta' and J_n = J_n(1)

    u = (U / J_0) J_0(eta) + h^2 dp/dx [J_1(eta) - (J_1/J_0) J_0(eta)],
    mean flow  C U h - F h^3 dp/dx,   C = 1 - J_1/J_0,   F = J_2 - J_1^2/J_0.

Balance of layer k of a cell, phi the flows through its faces (upwind along the film, exponential between layers):

    sum_out phi T_k - sum_in phi T_up + flux_k+1/2 - flux_k-1/2 = heat_k

Dimensionless as ``_surface_film``; heat is dissipation times mu omega R^2 / (rho c c^2), temperature times flow.
Source: Dowson, A generalized Reynolds equation for fluid-film lubrication, Int. J. Mech. Sci. 4 (1962) 159-170;
exponential fluxes: Patankar, Numerical Heat Transfer and Fluid Flow (1980), 5.2.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy import float64, int64
from numpy.typing import NDArray

from babbitt.film._compiling import compiled, inlined, inner

Array = NDArray[float64]


class Columns(NamedTuple):
    """How nodes gather to columns, and the layers."""

    column: NDArray[int64]  # of every node, (nodes,)
    supply: NDArray[int64]  # supply that a cell belongs to, or -1, (lines, columns)
    side: NDArray[int64]  # 1 where a node lies on a side edge, (nodes,)
    layer: Array  # thickness of the layers, (layers,), summing to 1
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
    shear_profile: Array  # share of the layers in the flow by shear, (n, columns, layers)
    pressure_profile: Array  # share of the layers in the flow by pressure
    stress: Array  # shear stress over that of the surface speed at unit flow by pressure: slope, (n, columns)
    balance: Array  # J_1/J_0: where the flow by pressure has no stress, (n, columns)
    shear_viscosity: Array  # 1/J_0, (n, columns)


class Walls(NamedTuple):
    """What lies behind the film. Heat goes to it where it is not insulated; temperatures are changed in place.

    The bush is described by harmonics around the bore, cosines and then sines: ``analysis`` (modes, lines) takes a
    flux apart, ``synthesis`` (lines, modes) builds a temperature, ``admittance`` is flux over temperature.
    """

    insulated: bool
    conduction: float  # k / (rho c omega c^2)
    flow_heat: float  # rho c omega R c B, W/K
    area: float  # R B, m2
    bush: Array  # K, (lines,)
    bush_flux: Array  # into the bush, W/m2, (lines,)
    ambient: float  # around the bush, K
    journal: Array  # temperature (K), heat taken (W), loss along the shaft (W/K), its ambient (K), (4,)
    journal_given: bool
    width: Array  # angle of every line, (lines,)
    analysis: Array
    synthesis: Array
    admittance: Array  # W/(m2 K), (modes,)
    harmonics: Array  # of the bore temperature over the ambient one, K, (modes,)
    inverse: Array  # of the derivatives of what the walls pass on less what they take, (modes + 1, modes + 1)
    conductance: Array  # k/h of the film for which the inverse was made, W/(m2 K), (lines,)
    fresh: float  # temperature of supplies and of what enters over the sides, K


@compiled
def new_flows(lines, n, columns, layers):
    """Flows of a film, not filled yet."""
    cell, between = (lines, columns), (n, columns)
    return Flows(
        np.zeros(between), np.zeros(between), np.zeros(cell), np.zeros(cell), np.zeros(cell), np.zeros(cell),
        np.zeros(cell), np.zeros((n, columns, layers)), np.zeros((n, columns, layers)), np.zeros(between),
        np.zeros(between), np.zeros(between),
    )  # fmt: skip


@compiled
def spread_viscosity(surface, columns, viscosity, flows):
    """Effective viscosity and drag of every interval from the viscosity (lines, columns, layers), in place."""
    n, layers = surface.step.size, columns.layer.size
    lines = viscosity.shape[0]
    effective, drag = np.empty(columns.size.size), np.empty(columns.size.size)
    for i in range(n):
        after = (i + 1) % lines
        for c in range(columns.size.size):
            j0, j1, j2, low = 0.0, 0.0, 0.0, 0.0
            for k in range(layers):
                fluid = 2.0 / (viscosity[i, c, k] + viscosity[after, c, k])
                high = low + columns.layer[k]
                j0 += fluid * (high - low)
                j1 += fluid * 0.5 * (high * high - low * low)
                j2 += fluid * (high * high * high - low * low * low) / 3.0
                low = high
            share, flow = 1.0 - j1 / j0, j2 - j1 * j1 / j0
            effective[c], drag[c] = 1.0 / (12.0 * flow), 2.0 * share
            flows.shear_viscosity[i, c], flows.balance[i, c] = 1.0 / j0, j1 / j0
            flows.stress[i, c] = -1.0 / flow
            # profiles: the mean over a layer of J_0(eta) / J_0 and J_1(eta) - (J_1/J_0) J_0(eta), by Simpson
            s0, s1, low, total_s, total_p = 0.0, 0.0, 0.0, 0.0, 0.0
            for k in range(layers):
                d = columns.layer[k]
                fluid = 2.0 / (viscosity[i, c, k] + viscosity[after, c, k])
                mean0 = s0 + fluid * 0.5 * d
                mean1 = s1 + fluid * (0.5 * low * d + d * d / 6.0)
                flows.shear_profile[i, c, k] = d * mean0
                flows.pressure_profile[i, c, k] = d * (j1 / j0 * mean0 - mean1)
                total_s += flows.shear_profile[i, c, k]
                total_p += flows.pressure_profile[i, c, k]
                s0 += fluid * d
                s1 += fluid * (low * d + 0.5 * d * d)
                low += d
            for k in range(layers):
                flows.shear_profile[i, c, k] /= total_s
                flows.pressure_profile[i, c, k] /= total_p
        for q in range(surface.radius.size):
            c = columns.column[surface.node[q]]
            if surface.viscosity[i, q] < 1e9:  # grooves are plugged
                surface.viscosity[i, q], surface.drag[i, q] = effective[c], drag[c]


@compiled
def gather_flows(surface, film, work, at, columns, flows):
    """Flows, gaps and dissipation of the cells; returns dissipation and friction power of the whole film.

    Dissipation of an interval with Q its flux by shear, T its conductance, j_n = int h^-n over it, f and g the
    effective viscosity and drag:   shear + 3 f g^2 (j_1 - j_2^2/j_3) + T (p - p')^2,   and along the line p^T K p;
    friction power, from the stress on the journal: shear + 3 f g^2 (j_1 - j_2^2/j_3) - Q (p - p').
    Their difference is the work of the flow, which vanishes but for supplies under pressure.
    """
    lines, nodes = surface.held.shape
    n = surface.step.size
    for array in (flows.shear, flows.pressure, flows.axial, flows.leak, flows.heat, flows.gap, flows.fill):
        array[:] = 0.0
    warmth = np.zeros((lines, nodes))
    friction = 0.0
    weight = np.zeros((lines, columns.size.size))
    for q in range(surface.radius.size):
        j = surface.node[q]
        c, share = columns.column[j], surface.share[q]
        for i in range(n):
            after = (i + 1) % lines
            ha, hb = surface.gap_a[i, q], surface.gap_b[i, q]
            for d in range(surface.lever.shape[0]):
                lift = at[d] * surface.lever[d, q]
                ha -= lift * surface.shape_a[d, i]
                hb -= lift * surface.shape_b[d, i]
            flows.gap[i, c] += share * ha
            flows.gap[after, c] += share * hb
            weight[i, c] += share
            weight[after, c] += share
            plugged = surface.viscosity[i, q] > 1e9 or (
                surface.held[i, j] and surface.held[after, j] and columns.side[j] == 0
            )
            if plugged:
                continue
            half, speed = 0.5 * surface.step[i], surface.speed
            a, b = 1.0 / ha, 1.0 / hb
            j1 = half * (a + b)
            sheared = share * speed * speed * flows.shear_viscosity[i, c] * j1 * work.fill[i, j]
            if work.holds[i, j] and work.fill[i, j] == 1.0:
                f, g = surface.viscosity[i, q], speed * surface.drag[i, q]
                j2, j3 = half * (a * a + b * b), half * (a * a * a + b * b * b)
                sheared += share * 3.0 * f * g * g * (j1 - j2 * j2 / j3)
            friction += sheared
            warmth[i, j] += 0.5 * sheared
            warmth[after, j] += 0.5 * sheared
    for i in range(lines):
        for c in range(columns.size.size):
            flows.gap[i, c] /= weight[i, c]
    for i in range(n):
        after = (i + 1) % lines
        for j in range(nodes):
            c = columns.column[j]
            drop = work.pressure[i, j] - work.pressure[after, j]
            flux, push = film.couette[i, j] * work.fill[i, j], film.conductance[i, j] * drop
            if surface.conserving and surface.held[i, j] and not work.holds[after, j]:
                flux, push = film.inlet[i, j] * work.fill[i, j], 0.0
            flows.shear[i, c] += flux
            flows.pressure[i, c] += push
            friction -= flux * drop
            warmth[i, j] += 0.5 * push * drop
            warmth[after, j] += 0.5 * push * drop
    for i in range(lines):
        leaving = np.zeros(nodes)
        for q in range(surface.radius.size):
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
            flows.fill[i, c] += min(max(work.fill[i, j], 0.0), 1.0) * column_share(surface, j) / columns.size[c]
    return flows.heat.sum(), friction


@inlined
def column_share(surface, j):
    """Share of the width of a node."""
    total = 0.0
    for q in range(surface.radius.size):
        if surface.node[q] == j:
            total += surface.share[q]
    return total


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
def cell(surface, columns, flows, walls, viscosity, temperature, i, c, low, diagonal, high, right):
    """Solve the layers of one cell, its neighbours as they are; returns the change of its temperatures."""
    lines, layers, n = temperature.shape[0], columns.layer.size, surface.step.size
    before, west, east = (i - 1) % lines, (i - 1) % n, i % n
    after = (i + 1) % lines
    last = flows.gap.shape[1] - 1
    leak, inward = flows.leak[i, c], flows.axial[i, c - 1] if c > 0 else 0.0
    outward = flows.axial[i, c] if c < last else 0.0
    width = 0.5 * (surface.step[west] + surface.step[east])
    conduct = walls.conduction * width * columns.size[c] * flows.fill[i, c] / flows.gap[i, c]
    # heat among the layers: stress squared over viscosity
    slope = flows.stress[east, c] * flows.pressure[east, c] / (columns.size[c] * flows.gap[i, c])
    level, eta, total = surface.speed * flows.shear_viscosity[east, c], 0.0, 0.0
    for k in range(layers):
        middle = eta + 0.5 * columns.layer[k]
        stress = level + slope * (middle - flows.balance[east, c])
        high[k] = columns.layer[k] * stress * stress / viscosity[i, c, k]
        total += high[k]
        eta += columns.layer[k]
    for k in range(layers):
        right[k] = flows.heat[i, c] * (high[k] / total if total > 0.0 else columns.layer[k])
        diagonal[k], low[k] = 1e-14, 0.0  # a cell that nothing passes keeps its temperature
        right[k] += 1e-14 * temperature[i, c, k]
        high[k] = 0.0
    across = 0.0
    for k in range(layers):
        net = 0.0
        phi = flows.shear[west, c] * flows.shear_profile[west, c, k]
        phi += flows.pressure[west, c] * flows.pressure_profile[west, c, k]
        net -= phi
        if phi > 0.0:
            right[k] += phi * temperature[before, c, k]
        else:
            diagonal[k] -= phi
        phi = flows.shear[east, c] * flows.shear_profile[east, c, k]
        phi += flows.pressure[east, c] * flows.pressure_profile[east, c, k]
        net += phi
        if phi > 0.0:
            diagonal[k] += phi
        else:
            right[k] -= phi * temperature[after, c, k]
        profile = flows.pressure_profile[east, c, k]
        behind = flows.pressure_profile[east, c - 1, k] if c > 0 else 0.0
        net += (leak + outward) * profile - inward * behind
        if leak > 0.0:
            diagonal[k] += leak * profile
        else:
            right[k] -= leak * profile * walls.fresh
        if outward > 0.0:
            diagonal[k] += outward * profile
        elif outward < 0.0:
            right[k] -= outward * profile * temperature[i, c + 1, k]
        if inward > 0.0:
            right[k] += inward * behind * temperature[i, c - 1, k]
        else:
            diagonal[k] -= inward * behind
        across -= net
        if k < layers - 1:
            between = conduct / (0.5 * (columns.layer[k] + columns.layer[k + 1]))
            if between > 0.0:
                down = between * bernoulli(across / between)
                up = down + across
            else:
                up, down = max(across, 0.0), max(-across, 0.0)
            diagonal[k] += up
            high[k] = -down
            low[k + 1] = -up
            diagonal[k + 1] += down
    if conduct > 0.0 and not walls.insulated:
        wall = conduct / (0.5 * columns.layer[0])
        diagonal[0] += wall
        right[0] += wall * walls.bush[i]
        wall = conduct / (0.5 * columns.layer[layers - 1])
        diagonal[layers - 1] += wall
        right[layers - 1] += wall * walls.journal[0]
    for k in range(1, layers):
        factor = low[k] / diagonal[k - 1]
        diagonal[k] -= factor * high[k - 1]
        right[k] -= factor * right[k - 1]
    change, value = 0.0, 0.0
    for k in range(layers - 1, -1, -1):
        value = (right[k] - (high[k] * value if k < layers - 1 else 0.0)) / diagonal[k]
        change = max(change, abs(value - temperature[i, c, k]))
        temperature[i, c, k] = value
    return change


@compiled
def sweep_energy(surface, columns, flows, walls, viscosity, temperature, groove, most, tolerance):
    """March round the film until its temperatures, and those of the supplies, rest. Returns the last change.

    Oil that goes round many times before it leaves warms slowly, and in one pattern: of two sweeps the changes d_1,
    d_2 tell its share lambda = d_1 d_2 / d_1^2, and lambda / (1 - lambda) d_2 is what is still to come (Aitken).
    """
    layers = columns.layer.size
    low, diagonal, high, right = np.empty(layers), np.empty(layers), np.empty(layers), np.empty(layers)
    lines, count = temperature.shape[0], columns.size.size
    before, last = np.empty(temperature.shape), np.empty(temperature.shape)
    change = 0.0
    for turn in range(most):
        change = 0.0
        before[:] = temperature
        for i in range(lines):
            for c in range(count):
                s = columns.supply[i, c]
                if s >= 0:
                    if (i == 0 or columns.supply[i - 1, c] != s) and (c == 0 or columns.supply[i, c - 1] != s):
                        change = max(change, mix(surface, columns, flows, walls, temperature, groove, s))
                    for k in range(layers):
                        temperature[i, c, k] = groove[s]
                elif flows.gap[i, c] > 0.0:
                    moved = cell(surface, columns, flows, walls, viscosity, temperature, i, c, low, diagonal, high,
                                 right)  # fmt: skip
                    change = max(change, moved)
        if change < tolerance:
            break
        if turn % 3 == 1 and turn < most - 1:
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
        elif turn % 3 == 0:
            for i in range(lines):
                for c in range(count):
                    for k in range(layers):
                        last[i, c, k] = temperature[i, c, k] - before[i, c, k]
    return change


MOST_SHARE = 0.97  # of a change that the next sweep repeats: more is not extrapolated


@inner
def mix(surface, columns, flows, walls, temperature, groove, s):
    """Mixing temperature of a supply: what the film brings, the heat in it, and fresh oil for the rest."""
    brought, enthalpy, taken = groove_balance(surface, columns, flows, temperature, s)
    fresh = max(taken - brought, 0.0)
    if brought + fresh <= 0.0:
        return 0.0
    before = groove[s]
    groove[s] = (enthalpy + fresh * walls.fresh) / (brought + fresh)
    return abs(groove[s] - before)


@compiled
def wall_fluxes(columns, flows, walls, temperature, flux):
    """Fill the heat flux into the bush at every line (W/m2); returns the heat that the journal takes, W."""
    last, journal = columns.layer.size - 1, 0.0
    for i in range(temperature.shape[0]):
        bush = 0.0
        for c in range(columns.size.size):
            if columns.supply[i, c] < 0:
                film = walls.conduction * walls.flow_heat * walls.width[i]
                film *= flows.fill[i, c] * columns.size[c] / flows.gap[i, c]
                bush += film * 2.0 / columns.layer[0] * (temperature[i, c, 0] - walls.bush[i])
                journal += film * 2.0 / columns.layer[last] * (temperature[i, c, last] - walls.journal[0])
        flux[i] = bush / (walls.area * walls.width[i])
    return journal


@compiled
def answer_walls(columns, flows, walls, temperature, part):
    """New temperatures of bush and journal from the heat that they take; their largest change, K.

    Newton on what the walls take less what they pass on, harmonic by harmonic and for the journal; ``inverse`` is of
    the derivatives, the film's own answer to a warmer wall among them. ``part`` of the step is taken.
    """
    modes = walls.analysis.shape[0]
    walls.journal[1] = wall_fluxes(columns, flows, walls, temperature, walls.bush_flux)
    left = np.zeros(modes + 1)
    left[modes] = walls.journal[1] - walls.journal[2] * (walls.journal[0] - walls.journal[3])
    for m in range(modes):
        left[m] = -walls.admittance[m] * walls.harmonics[m]
        for i in range(temperature.shape[0]):
            left[m] += walls.analysis[m, i] * walls.bush_flux[i]
    step = np.zeros(modes + 1)
    for m in range(modes + 1):
        for n in range(modes + 1):
            step[m] += walls.inverse[m, n] * left[n]
    change = 0.0 if walls.journal_given else abs(step[modes])
    rise = np.zeros(temperature.shape[0])
    for i in range(rise.size):
        for m in range(modes):
            rise[i] += walls.synthesis[i, m] * step[m]
        change = max(change, abs(rise[i]))
    share = part * min(1.0, MOST_RISE / max(change, 1e-300))
    for i in range(rise.size):
        walls.bush[i] += share * rise[i]
    for m in range(modes):
        walls.harmonics[m] += share * step[m]
    if not walls.journal_given:
        walls.journal[0] += share * step[modes]
    return share * change


MOST_RISE = 20.0  # K: change of a temperature in one pass; what a film that leaks nothing would reach has no bound


@compiled
def close_energy(surface, columns, flows, walls, viscosity, temperature, groove, most, tolerance):
    """Energy equation and walls beside a film at rest, until nothing changes any more; the last change."""
    change = 0.0
    for _ in range(most):
        enough = max(tolerance, 0.02 * change)  # walls that answer to a film on its way are thrown off theirs
        change = sweep_energy(surface, columns, flows, walls, viscosity, temperature, groove, 16, enough)
        if not walls.insulated:
            change = max(change, answer_walls(columns, flows, walls, temperature, 1.0))
        if change < tolerance:
            break
    return change


@compiled
def groove_balance(surface, columns, flows, temperature, s):
    """Flow that the film brings to a supply, its enthalpy with the heat born there, and the flow that it takes."""
    lines, n, layers = temperature.shape[0], surface.step.size, columns.layer.size
    count = columns.size.size
    brought, enthalpy, taken = 0.0, 0.0, 0.0
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
                    enthalpy += phi * temperature[after if own else i, c, k]
                else:
                    taken -= phi
    for i in range(lines):
        for c in range(count):
            own = columns.supply[i, c] == s
            if own:
                enthalpy += flows.heat[i, c]
            if c < count - 1 and own != (columns.supply[i, c + 1] == s):
                phi = -flows.axial[i, c] if own else flows.axial[i, c]
                if phi <= 0.0:
                    taken -= phi
                    continue
                brought += phi
                for k in range(layers):
                    value = temperature[i, c + 1 if own else c, k]
                    enthalpy += phi * flows.pressure_profile[i % n, c, k] * value
    return brought, enthalpy, taken
