"""Kernels: bush and journal beside the film, in balance with the heat that they take."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import float64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds.heat._heat_cells import fill_cells, groove_balance, sweep_energy

Array = NDArray[float64]


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
    carry_over: float  # share of the oil brought to a supply that goes on with the film


@inner
def wall_fluxes(columns, cells, walls, temperature, flux):
    """Fill the heat flux into the bush at every line (W/m2); returns the heat that the journal takes, W."""
    last, journal = len(columns.layers) - 1, 0.0
    for i in range(temperature.shape[0]):
        bush = 0.0
        for c in range(columns.size.size):
            bush += cells.bush[i, c] * (temperature[i, c, 0] - walls.bush[i])
            journal += cells.journal[i, c] * (temperature[i, c, last] - walls.journal[0])
        flux[i] = bush * walls.flow_heat / (walls.area * walls.width[i])
    return journal * walls.flow_heat


ALIKE = 0.5
"""Change of the film's conductance, over its largest, up to which derivatives of the walls are kept."""


@inner
def film_conductance(columns, flows, walls, i):
    """Conductance k/h of the film at a line, W/(m2 K)."""
    total = 0.0
    for c in range(columns.size.size):
        if columns.supply[i, c] < 0 and flows.gap[i, c] > 0.0:
            total += flows.fill[i, c] * columns.size[c] / flows.gap[i, c]
    return walls.conduction * walls.flow_heat / walls.area * total


@inner
def wall_jacobian_outdated(columns, flows, walls):
    """Whether the film has become another one than that for which the derivatives of the walls were made."""
    most, change = 0.0, 0.0
    for i in range(walls.conductance.size):
        film = film_conductance(columns, flows, walls, i)
        most, change = max(most, film), max(change, abs(film - walls.conductance[i]))
    return change > ALIKE * most


@compiled
def fill_film(surface, columns, flows, stirred, viscosity, cells, walls):
    """Cells of the energy equation for these flows; whether ``wall_jacobian_outdated``."""
    wall = 0.0 if walls.insulated else np.inf
    fill_cells(surface, columns, flows, walls.conduction, stirred, wall, wall, walls.fresh, viscosity, cells)
    return not walls.insulated and wall_jacobian_outdated(columns, flows, walls)


@inner
def wall_step(columns, cells, walls, temperature):
    """Newton step of the walls, harmonic by harmonic and the journal last, (modes + 1,); fills what they take.

    To zero goes what the walls take less what they pass on; ``inverse`` is of the derivatives, the answer of the
    film to a warmer wall among them.
    """
    modes = walls.analysis.shape[0]
    walls.journal[1] = wall_fluxes(columns, cells, walls, temperature, walls.bush_flux)
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
    if walls.journal_given:
        step[modes] = 0.0
    return step


@inner
def move_walls(walls, step, part):
    """Take ``part`` of a step, less where it is long; the largest change, K."""
    modes = walls.analysis.shape[0]
    change = abs(step[modes])
    rise = np.zeros(walls.bush.size)
    for i in range(rise.size):
        for m in range(modes):
            rise[i] += walls.synthesis[i, m] * step[m]
        change = max(change, abs(rise[i]))
    share = part * min(1.0, MOST_RISE / max(change, 1e-300))
    for i in range(rise.size):
        walls.bush[i] += share * rise[i]
    for m in range(modes):
        walls.harmonics[m] += share * step[m]
    walls.journal[0] += share * step[modes]
    return share * change


@compiled
def update_wall_temperatures(surface, columns, flows, cells, walls, temperature, groove, part, change):
    """Let the walls answer and the film follow by one sweep: else they chase each other from pass to pass.

    A film that was held back, its ``change`` being more than ``MOST_RISE``, does not. Returns the larger change.
    """
    answered = move_walls(walls, wall_step(columns, cells, walls, temperature), part)
    if change <= MOST_RISE:
        sweep_energy(surface, columns, flows, cells, walls, temperature, groove, int(ANSWERS), 0.0)
    return max(change, answered)


ANSWERS, SWEEPS = 1, 16
"""Sweeps after walls that answer, and of a film at rest before they do. (Callers write int(): for a constant the
compiler would make a kernel of its own.)"""

MOST_RISE = 20.0  # K: change of a temperature in one pass; what a film that leaks nothing would reach has no bound


@compiled
def close_energy(surface, columns, flows, cells, walls, temperature, groove, most, tolerance):
    """Energy equation and walls beside a film at rest, until nothing changes any more; the last change."""
    change = 0.0
    for _ in range(most):
        enough = max(tolerance, 0.02 * change)  # walls that answer to a film on its way are thrown off theirs
        change = sweep_energy(surface, columns, flows, cells, walls, temperature, groove, int(SWEEPS), enough)
        if not walls.insulated:
            change = max(change, move_walls(walls, wall_step(columns, cells, walls, temperature), 1.0))
        if change < tolerance:
            break
    return change


@compiled
def wall_response_matrix(surface, columns, flows, cells, walls, fluxes, heats, most, tolerance):
    """What the film gives to the walls with one of them at 1 K and all else at zero; the film is remembered.

    For every harmonic of the bush, and last for the journal: flux into the bush (W/m2), ``fluxes`` (lines,
    modes + 1), and heat into the journal (W), ``heats`` (modes + 1,). The energy equation is linear, so that they
    are exact but for what sweeps leave over, ``tolerance`` in K (root mean square of the last changes beside the
    bush).
    """
    lines, count, last = cells.bush.shape[0], cells.bush.shape[1], len(columns.layers) - 1
    journal = heats.size - 1
    temperatures = np.zeros((lines, count, last + 1, heats.size))
    groove, enthalpy = np.zeros((columns.supply.max() + 1, heats.size)), np.empty(heats.size)
    right, mine = np.empty((last + 1, heats.size)), np.zeros(heats.size)
    mine[journal] = 1.0
    for i in range(lines):
        walls.conductance[i] = film_conductance(columns, flows, walls, i)
    for _ in range(most):
        change = 0.0
        for i in range(lines):
            for c in range(count):
                s = columns.supply[i, c]
                if s >= 0:
                    if (i == 0 or columns.supply[i - 1, c] != s) and (c == 0 or columns.supply[i, c - 1] != s):
                        brought, taken = groove_balance(surface, columns, flows, 0.0, temperatures, s, enthalpy)
                        kept = walls.carry_over * brought
                        if max(kept, taken) > 0.0:
                            for m in range(heats.size):
                                groove[s, m] = walls.carry_over / max(kept, taken) * enthalpy[m]
                    for k in range(last + 1):
                        for m in range(heats.size):
                            temperatures[i, c, k, m] = groove[s, m]
                elif flows.gap[i, c] > 0.0:
                    change += solve_cells(columns, cells, walls, mine, temperatures, i, c, right)
        if change < fluxes.size * count * tolerance**2:
            break
    heats[:] = 0.0
    fluxes[:] = 0.0
    for i in range(lines):
        for c in range(count):
            for m in range(heats.size):
                wall = walls.synthesis[i, m] if m < journal else 0.0
                fluxes[i, m] += cells.bush[i, c] * (temperatures[i, c, 0, m] - wall)
                heats[m] += cells.journal[i, c] * (temperatures[i, c, last, m] - mine[m])
        for m in range(heats.size):
            fluxes[i, m] *= walls.flow_heat / (walls.area * walls.width[i])
    for m in range(heats.size):
        heats[m] *= walls.flow_heat


@inlined
def solve_cells(columns, cells, walls, mine, temperatures, i, c, right):
    """As ``solve_cell``, for all walls that are at 1 K one by one: the innermost loops are vectors.

    Returns the sum of the squares of the changes beside the bush.
    """
    lines, count, layers, states = temperatures.shape
    before, after = i - 1 if i > 0 else lines - 1, i + 1 if i < lines - 1 else 0
    for k in range(layers):
        west, east = cells.west[i, c, k], cells.east[i, c, k]
        for m in range(states):
            right[k, m] = west * temperatures[before, c, k, m]
        if east > 0.0:
            for m in range(states):
                right[k, m] += east * temperatures[after, c, k, m]
        if c > 0:
            for m in range(states):
                right[k, m] += cells.inner[i, c, k] * temperatures[i, c - 1, k, m]
        if c < count - 1:
            for m in range(states):
                right[k, m] += cells.outer[i, c, k] * temperatures[i, c + 1, k, m]
    for m in range(states - 1):
        right[0, m] += cells.bush[i, c] * walls.synthesis[i, m]
    right[layers - 1, states - 1] += cells.journal[i, c]
    for k in range(1, layers):
        factor = cells.factor[i, c, k]
        for m in range(states):
            right[k, m] -= factor * right[k - 1, m]
    for k in range(layers - 1, -1, -1):
        pivot, above = cells.pivot[i, c, k], min(k + 1, layers - 1)
        high = cells.high[i, c, k] if k < layers - 1 else 0.0
        for m in range(states):
            right[k, m] = pivot * right[k, m] - high * right[above, m]
    change = 0.0
    for m in range(states):
        change += (right[0, m] - temperatures[i, c, 0, m]) ** 2
    for k in range(layers):
        for m in range(states):
            temperatures[i, c, k, m] = right[k, m]
    return change
