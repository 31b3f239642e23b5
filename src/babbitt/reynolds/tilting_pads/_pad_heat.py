"""Kernels: temperatures of the films of tilting pads, of the oil between them, and of the journal.

The energy equation is linear. With the flows as they are, the temperatures of a pad are those in surroundings at
0 K, plus T_in times those for oil that enters at 1 K, plus T_J times those for a journal at 1 K, all else at 0 K.

A pad meets its film at a conductance alpha on both sides (Robin): the film knows T_pad - q/alpha of the last pass,
the pad q + alpha T_film of this one. Where both agree alpha is out of it. What is uneven along a pad comes to rest
in few passes. The level of a whole pad would not where films and pads take little heat compared with alpha, as in
slow bearings: the fourth state is that of T_pad - q/alpha raised by 1 K.

Four states of one matrix then. Balances of the oil between the pads, of the journal and of the heat of every pad
give all T_in, T_J and these levels at once, exactly.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import bool_, float64, int64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inlined, inner, spliced
from babbitt.reynolds.heat._heat_cells import fill_cells
from babbitt.reynolds.heat._heat_flows import spread_viscosity
from babbitt.reynolds.heat._heat_pass import relax_viscosity
from babbitt.reynolds.lands._grids import new_film
from babbitt.reynolds.tilting_pads._pad_flows import NARROWEST, pad_flows, take_viscosity

Array = NDArray[float64]

MOST_SWEEPS = 60  # of a pad in which oil flows back
SWEPT = 1e-10  # change of a state at 1 K that ends them
LEADING, TRAILING, BACK = range(3)
STATES = 4  # sources alone, oil at 1 K, journal at 1 K, T_pad - q/alpha raised by 1 K


class Oil(NamedTuple):
    """The oil, its scales and what feeds the pads."""

    conduction: float  # k / (rho c omega c^2)
    flow_heat: float  # rho c omega R c B, W/K
    wall_heat: float  # rho c omega c, W/(m2 K): flux over the temperature of the kernels
    rise: float  # temperature per unit of heat over flow, K
    fresh: float  # temperature of the supply, K
    carry_over: float  # share of the oil that a pad sends off and the next one takes
    share: Array  # width of every pad over that of the bearing, (pads,)
    previous: NDArray[int64]  # the pad in front of every pad in the sense of rotation, (pads,)


class WallState(NamedTuple):
    """Journal and pads behind the film."""

    journal: Array  # temperature (K), heat taken (W), loss along the shaft (W/K), its ambient (K), (4,)
    journal_open: bool  # whether it takes heat
    journal_given: bool
    pads_open: bool
    exchange: float  # alpha, W/(m2 K)
    answer: Array  # bore temperature over q + alpha T of the film, (pads, n + 1, n + 1), K m2/W
    given: Array  # bore temperature over that of leading edge, trailing edge and back, (pads, n + 1, 3)
    answer_mean: Array  # mean of answer along the bore, that of the leading edge with the next, (pads, n + 1)
    given_mean: Array  # mean of given along the bore, (pads, 3)
    edge_answer: Array  # heat over leading and trailing edge over q + alpha T, by flow_heat, (pads, 2, n + 1)
    edge_given: Array  # the same over the temperatures around, (pads, 2, 3)
    back: float  # temperature behind the pads, K
    bore: Array  # temperature, K, (lines,)
    flux: Array  # into the bore, W/m2, (lines,)
    datum: Array  # T_pad - q/alpha, K, (lines,)


class Temperatures(NamedTuple):
    """Temperatures on their way, (lines, 1, layers) unless said; viscosity over its unit."""

    viscosity: Array
    temperature: Array  # of the cells, K
    on_lines: Array  # K
    states: Array  # (lines, layers, STATES)
    inlet: Array  # temperature of the oil that enters every pad, K, (pads,)
    capped: NDArray[bool_]  # whether a pad is brought more than it takes, (pads,)


@compiled
def prepare_films(pads, ring, columns, flows, films, fresh, part):
    """Coefficients of the films for viscosities of which ``part`` is ``fresh``.

    Returns the largest share by which they still differ from that.
    """
    relax_viscosity(columns, fresh, films.viscosity, part)
    spread_viscosity(ring, columns, films.viscosity, flows)
    take_viscosity(pads, ring)
    behind = 0.0
    for i in range(fresh.shape[0]):
        for n in range(fresh.shape[2]):
            behind = max(behind, abs(fresh[i, 0, n] / films.viscosity[i, 0, n] - 1.0))
    return behind


@compiled
def heat_pads(axial, pads, grid, places, ring, columns, flows, cells, oil, walls, films, totals):
    """Flows, temperatures, grooves, journal and pads for films that stand; the largest change of temperature, K.

    It counts by the share of the width that oil fills. Infinite where a pad, concentric with its bore as an
    unloaded one, would touch the journal.
    """
    pad_flows(axial, pads, grid, new_film(grid.step.shape[1]), places, oil.rise, flows, totals)
    if not totals[:, NARROWEST].min() > 0.0:
        return np.inf
    bush = walls.exchange / oil.wall_heat if walls.pads_open else 0.0
    journal = np.inf if walls.journal_open else 0.0
    fill_cells(ring, columns, flows, oil.conduction, 0.0, bush, journal, 0.0, films.viscosity, cells)
    rows = grid.step.shape[1] + 1
    for k in range(pads.kappa.size):
        sweep_pad(columns, flows, cells, walls, k * rows, rows, films.states)
    change = balance_grooves(ring, columns, flows, cells, oil, walls, rows, films)
    if walls.pads_open:
        change = max(change, answer_pads(ring, cells, oil, walls, rows, films))
    return change


@inner
def sweep_pad(columns, flows, cells, walls, first, rows, states):
    """March along a pad, again and again where oil flows back, until its states no longer change.

    What a film draws over its sides is as warm as the oil that enters.
    """
    layers = len(columns.layers)
    last = first + rows - 1
    right = np.empty((layers, STATES))
    states[first] = 0.0
    states[first, :, 1] = 1.0
    backward = False
    for i in range(first + 1, last):
        for k in range(layers):
            backward = backward or cells.east[i, 0, k] > 0.0
    for _ in range(MOST_SWEEPS):
        change = 0.0
        for i in range(first + 1, last + 1):
            behind = min(i + 1, last)
            for k in range(layers):
                west, east = cells.west[i, 0, k], cells.east[i, 0, k]
                for s in range(STATES):
                    right[k, s] = west * states[i - 1, k, s] + east * states[behind, k, s]
                right[k, 0] += cells.heat[i, 0, k]
                right[k, 1] += max(-flows.leak[i, 0], 0.0) * flows.pressure_profile[i, 0, k]
            right[0, 0] += cells.bush[i, 0] * walls.datum[i]
            right[layers - 1, 2] += cells.journal[i, 0]
            right[0, 3] += cells.bush[i, 0]
            change = max(change, take_layers(cells, i, layers, right, states))
        if not backward or change < SWEPT:
            break


@inlined
def take_layers(cells, i, layers, right, states):
    """Solve the layers of a line; returns the largest change of a state at 1 K."""
    for k in range(1, layers):
        factor = cells.factor[i, 0, k]
        for s in range(STATES):
            right[k, s] -= factor * right[k - 1, s]
    change = 0.0
    for k in range(layers - 1, -1, -1):
        pivot, high = cells.pivot[i, 0, k], cells.high[i, 0, k]
        for s in range(STATES):
            value = pivot * right[k, s]
            if k < layers - 1:
                value -= high * right[k + 1, s]
            right[k, s] = value
        change = max(change, abs(right[k, 1] - states[i, k, 1]))
        for s in range(STATES):
            states[i, k, s] = right[k, s]
    return change


@inlined
def edge_flow(flows, r, k):
    """Flow of a layer through an interval of the ring."""
    return (
        flows.shear[r, 0] * flows.shear_profile[r, 0, k] + flows.pressure[r, 0] * flows.pressure_profile[r, 0, k]
    )


@spliced
def balance_grooves(ring, columns, flows, cells, oil, walls, rows, films):
    """Temperatures of the oil that enters every pad, of the journal and of the pads, and with them of all films.

    As ``_heat_cells.mix``: of the oil brought to a groove, by the pad in front and by what flows back, the share
    that is carried over enters, and fresh oil for what is missing; the edges of both pads at the groove warm it.
    Returns the largest change, K.
    """
    count, layers, states = films.inlet.size, len(columns.layers), films.states
    matrix, right = np.eye(2 * count + 1), np.zeros(2 * count + 1)
    fed = np.ones(count, np.bool_)
    for k in range(count):
        b, first = oil.previous[k], k * rows
        matrix[k, k] = 0.0
        last = b * rows + rows - 1
        brought, taken = 0.0, 0.0
        for i in range(first + 1, first + rows):
            taken += oil.share[k] * max(-flows.leak[i, 0], 0.0)
        for n in range(layers):
            phi = oil.share[b] * edge_flow(flows, last, n)
            brought += phi
            right[k] += oil.carry_over * phi * states[last, n, 0]
            matrix[k, b] -= oil.carry_over * phi * states[last, n, 1]
            matrix[k, count] -= oil.carry_over * phi * states[last, n, 2]
            matrix[k, count + 1 + b] -= oil.carry_over * phi * states[last, n, 3]
            phi = oil.share[k] * edge_flow(flows, first, n)
            if phi >= 0.0:
                taken += phi
                continue
            brought -= phi
            right[k] -= oil.carry_over * phi * states[first + 1, n, 0]
            matrix[k, k] += oil.carry_over * phi * states[first + 1, n, 1]
            matrix[k, count] += oil.carry_over * phi * states[first + 1, n, 2]
            matrix[k, count + 1 + k] += oil.carry_over * phi * states[first + 1, n, 3]
        kept = oil.carry_over * brought
        films.capped[k] = kept > taken
        added = max(taken - kept, 0.0)
        if kept + added <= 0.0:
            added, fed[k] = 1.0, False
        matrix[k, k] += kept + added
        right[k] += added * oil.fresh
        if walls.pads_open:
            pad_balance(ring, cells, oil, walls, k, rows, films, matrix, right)
    if walls.pads_open:
        for k in range(count):
            edge_balance(ring, cells, oil, walls, k, rows, films, fed, matrix, right)
    right[count] = walls.journal[0]
    if walls.journal_open and not walls.journal_given:
        journal_balance(cells, oil, walls, rows, films, matrix[count], right)
    if not np.isfinite(matrix.sum() + right.sum()):
        return np.inf
    solution = np.linalg.solve(matrix, right)
    return take_temperatures(cells, flows, oil, walls, rows, films, solution)


@inlined
def journal_balance(cells, oil, walls, rows, films, row, right):
    """The last row: heat of the films into the journal less what it loses along the shaft."""
    count, top = films.inlet.size, films.states.shape[1] - 1
    row[count] = -walls.journal[2] / oil.flow_heat
    right[count] = -walls.journal[2] * walls.journal[3] / oil.flow_heat
    for k in range(count):
        for i in range(k * rows + 1, (k + 1) * rows):
            conduct = oil.share[k] * cells.journal[i, 0]
            right[count] -= conduct * films.states[i, top, 0]
            row[k] += conduct * films.states[i, top, 1]
            row[count] += conduct * (films.states[i, top, 2] - 1.0)
            row[count + 1 + k] += conduct * films.states[i, top, 3]


@inlined
def pad_balance(ring, cells, oil, walls, k, rows, films, matrix, right):
    """A pad takes on the whole what its film gives: D' = D + d, q of the film, and mean(q) = mean(q_pad) with

    q_pad = q + alpha (q/alpha + D' - T_pad), T_pad = answer (2 q + alpha D') + given T_around, over alpha.
    """
    count, first, alpha = films.inlet.size, k * rows, walls.exchange
    level = count + 1 + k
    matrix[level, level] = 0.0
    for i in range(1, rows):
        r = first + i
        share = 0.5 * (ring.step[r - 1] + ring.step[r]) / (0.5 * ring.step[first] * (rows - 1))
        of_flux = share / alpha - 2.0 * walls.answer_mean[k, i]
        of_datum = share - alpha * walls.answer_mean[k, i]
        conduct = of_flux * film_conductance(ring, cells, oil, r)
        s = films.states[r, 0]
        right[level] -= conduct * (s[0] - walls.datum[r]) + of_datum * walls.datum[r]
        matrix[level, k] += conduct * s[1]
        matrix[level, count] += conduct * s[2]
        matrix[level, level] += conduct * (s[3] - 1.0) + of_datum
    matrix[level, k] -= walls.given_mean[k, LEADING]
    matrix[level, follower(oil, k)] -= walls.given_mean[k, TRAILING]
    right[level] += walls.given_mean[k, BACK] * walls.back


@inlined
def edge_balance(ring, cells, oil, walls, k, rows, films, fed, matrix, right):
    """Heat that pad k gives off over its edges, into the rows of the oil of both grooves where that flows.

    Linear in q + alpha T, as `pad_balance`; over rho c omega R c B a flow times a temperature.
    """
    count, first, alpha = films.inlet.size, k * rows, walls.exchange
    level, behind = count + 1 + k, follower(oil, k)
    for side in range(2):
        groove = behind if side == TRAILING else k
        if not fed[groove]:
            continue
        for i in range(1, rows):
            r, share = first + i, walls.edge_answer[k, side, i]
            conduct, s = 2.0 * film_conductance(ring, cells, oil, r), films.states[r, 0]
            right[groove] += share * (conduct * (s[0] - walls.datum[r]) + alpha * walls.datum[r])
            matrix[groove, k] -= share * conduct * s[1]
            matrix[groove, count] -= share * conduct * s[2]
            matrix[groove, level] -= share * (conduct * (s[3] - 1.0) + alpha)
        matrix[groove, k] -= walls.edge_given[k, side, LEADING]
        matrix[groove, behind] -= walls.edge_given[k, side, TRAILING]
        right[groove] += walls.edge_given[k, side, BACK] * walls.back


@inlined
def film_conductance(ring, cells, oil, r):
    """Between a cell next to the pad and T_pad - q/alpha, W/(m2 K)."""
    return cells.bush[r, 0] * oil.wall_heat / (0.5 * (ring.step[r - 1] + ring.step[r]))


@inlined
def follower(oil, k):
    """The pad behind pad k in the sense of rotation."""
    for b in range(oil.previous.size):
        if oil.previous[b] == k:
            return b
    return 0


@spliced
def take_temperatures(cells, flows, oil, walls, rows, films, solution):
    """Temperatures of all films, of what enters them and of the journal, and its heat; the largest change, K."""
    count, layers = films.inlet.size, films.states.shape[1]
    journal, taken = solution[count], 0.0
    change = abs(journal - walls.journal[0])
    for k in range(count):
        inlet, level = solution[k], solution[count + 1 + k]
        change = max(change, abs(inlet - films.inlet[k]))
        films.inlet[k] = inlet
        for i in range(k * rows, (k + 1) * rows):
            for n in range(layers):
                s = films.states[i, n]
                value = s[0] + inlet * s[1] + journal * s[2] + level * s[3]
                change = max(change, abs(value - films.temperature[i, 0, n]) * flows.fill[i, 0])
                films.temperature[i, 0, n] = value
            taken += oil.share[k] * cells.journal[i, 0] * (films.temperature[i, 0, layers - 1] - journal)
            walls.datum[i] += level
        temperatures_on_lines(films, k * rows, rows)
    walls.journal[0], walls.journal[1] = journal, taken * oil.flow_heat
    return change


@spliced
def temperatures_on_lines(films, first, rows):
    """Temperatures of a pad on its lines: the cells give those half an interval further, where they send oil off.

    The first cell begins at the leading edge, the last one ends at the trailing edge.
    """
    last = first + rows - 1
    for n in range(films.temperature.shape[2]):
        films.on_lines[first, 0, n] = films.temperature[first, 0, n]
        films.on_lines[last, 0, n] = films.temperature[last, 0, n]
    for i in range(first + 1, last):
        share = 2.0 / 3.0 if i == first + 1 else 0.5
        for n in range(films.temperature.shape[2]):
            before, behind = films.temperature[i - 1, 0, n], films.temperature[i, 0, n]
            films.on_lines[i, 0, n] = before + share * (behind - before)


@inner
def answer_pads(ring, cells, oil, walls, rows, films):
    """Let the pads take the heat of their films: bore temperatures, fluxes, and what the films know of them.

    Returns by how much the bores differ from the walls of their films, K.
    """
    alpha, count, apart = walls.exchange, films.inlet.size, 0.0
    asked = np.empty(rows)
    for k in range(count):
        first = k * rows
        trailing = films.inlet[follower(oil, k)]
        for i in range(1, rows):
            r = first + i
            film = film_conductance(ring, cells, oil, r) * (films.temperature[r, 0, 0] - walls.datum[r])
            asked[i] = 2.0 * film + alpha * walls.datum[r]  # q + alpha T at the wall of the film
        asked[0] = asked[1]
        for i in range(rows):
            bore = walls.given[k, i, LEADING] * films.inlet[k] + walls.given[k, i, TRAILING] * trailing
            bore += walls.given[k, i, BACK] * walls.back
            for j in range(rows):
                bore += walls.answer[k, i, j] * asked[j]
            wall = 0.5 * (asked[i] / alpha + walls.datum[first + i])  # D + q/alpha
            if i > 1:
                apart = max(apart, abs(bore - wall))
            walls.bore[first + i] = bore
            walls.flux[first + i] = asked[i] - alpha * bore
            walls.datum[first + i] = 2.0 * bore - asked[i] / alpha
        # the first cell lies along the half step at the leading edge, too
        walls.datum[first + 1] += (walls.datum[first] - walls.datum[first + 1]) / 3.0
    return apart
