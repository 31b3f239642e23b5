"""Film and recess network together: at a position, or under a load."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.impedance import static_coefficients
from babbitt.kinds.hydrostatic.lines import Grid
from babbitt.kinds.hydrostatic.network import Feeding, NetworkState, solve_network
from babbitt.reynolds.recess.recess_film import RecessFilm, RecessResponse, RecessSurface

__all__ = ["SearchOutcome", "RecessState", "ending_of", "equilibrium_under", "state_at"]

Array = NDArray[np.float64]
Build = Callable[[Grid], RecessSurface]
MOST_STEPS = 80
TIGHT = 1e-10


class SearchOutcome(Enum):
    """How a search ended."""

    SOLVED = "solved"
    OVERLOADED = "no gap is left under this load"
    LIFTED_OFF = "the load is too light for the widest gap"
    UNSTABLE_NETWORK = "the flow network of the recesses has no stable state"
    THERMAL_RUNAWAY = "the oil is hotter than any temperature that is searched"
    NOT_CONVERGED = "the iteration ended without meeting its tolerance"


@dataclass(frozen=True, eq=False)
class RecessState:
    """A film with its network.

    Attributes
    ----------
    film : RecessFilm
        With the nodes of this state.
    response : RecessResponse
    network : NetworkState
    at : ndarray, shape (motions,)
        Position, m and rad.
    ending : SearchOutcome
    steps : int
    residual : float
        Largest force that is not carried over the load, and pressure change over pressure.
    carried : float
        Greatest share of the load that the film was found to carry, where it could not carry all.
    """

    film: RecessFilm
    response: RecessResponse
    network: NetworkState
    at: Array
    ending: SearchOutcome
    steps: int
    residual: float
    carried: float = 0.0

    @property
    def force(self) -> Array:
        """Of the film, N and N m."""
        return self.response.force

    @property
    def solved(self) -> bool:
        """Whether this is a state of the bearing."""
        return self.ending is SearchOutcome.SOLVED

    @property
    def gap(self) -> float:
        """Smallest gap, m."""
        return self.film.gap(self.at)

    @property
    def mass_balance_error(self) -> float:
        """Largest imbalance of a recess and all imbalance of the film over the flow of the restrictors."""
        work, flow = self.film.work, self.film.of.scales.flow
        size = max(float(np.abs(self.network.flows).sum()), 1e-300)
        own = float(np.abs(self.response.outflow - self.network.flows).max()) / size
        free = work.counts & work.wet
        return max(own, abs(float(work.row[free].sum())) * flow / size)

    @property
    def dry_share(self) -> float:
        """Share of the land nodes without film."""
        free = self.film.of.recess == -1
        return float((~self.film.work.wet & free).sum() / max(int(free.sum()), 1))

    @property
    def maximum_pressure(self) -> float:
        """Gauge, Pa."""
        return float(self.film.pressures().max())


FINEST_RISE = 3e-3
"""Of the share of the load that was carried: how closely the greatest load is known."""
LEAST_SHARE = 1e-7
"""Of the load, below which none is sought that might be carried."""


def first_guess(feeding: Feeding, film: RecessFilm) -> tuple[Array, float]:
    """Recess pressures to begin with: half the supply pressure."""
    supply = feeding.nominal_pressure or film.of.scales.pressure
    return np.full(film.of.count, 0.5 * supply), supply


def state_at(build: Build, feeding: Feeding, at: Array, grid: Grid) -> RecessState:
    """Film and network at a position.

    Parameters
    ----------
    build : callable
        Grid to surface.
    feeding : Feeding
    at : ndarray, shape (motions,)
        m and rad.
    grid : Grid

    Returns
    -------
    RecessState

    Raises
    ------
    ValueError
        Where the position has not one number for every motion of the film.
    """
    film = RecessFilm.on(build(grid))
    if at.shape != film.of.scales.motion.shape:
        raise ValueError(f"a position of {at.size} numbers for {film.of.scales.motion.size} motions")
    pressures, supply = first_guess(feeding, film)
    return fixed_state(film, feeding, at, pressures, supply)


def fixed_state(film: RecessFilm, feeding: Feeding, at: Array, pressures: Array, supply: float) -> RecessState:
    """Recess pressures and active set at a position."""
    steps, moved = 0, np.inf
    while steps < MOST_STEPS:
        steps += 1
        response = film.evaluate(at, pressures)
        network = solve_network(feeding, response.conductance, response.outflow, pressures, supply)
        moved = float(np.abs(network.pressures - pressures).max() / max(float(np.abs(pressures).max()), 1e-300))
        if moved < TIGHT and response.changed == 0:
            break
        if network.converged:
            pressures, supply = network.pressures, network.supply_pressure
        elif response.changed == 0:
            break
    ending = ending_of(network, moved < 1e-8)
    return RecessState(film, response, network, at, ending, steps, moved)


def ending_of(network: NetworkState, settled: bool = True) -> SearchOutcome:
    """Whether a state is one, and stable; ``settled`` where film and network agree."""
    if not network.is_stable:
        return SearchOutcome.UNSTABLE_NETWORK
    return SearchOutcome.SOLVED if network.converged and settled else SearchOutcome.NOT_CONVERGED


def equilibrium_under(
    build: Build, feeding: Feeding, load: Array, start: Array, grid: Grid, thinnest: float
) -> RecessState:
    """Position at which the film carries a load.

    Parameters
    ----------
    build : callable
        Grid to surface.
    feeding : Feeding
    load : ndarray, shape (motions,)
        On the moving part, N and N m: force + load = 0.
    start : ndarray, shape (motions,)
        Position to begin from.
    grid : Grid
    thinnest : float
        Gap at which the search gives up, m.

    Returns
    -------
    RecessState
    """
    coarse = RecessFilm.on(build(Grid(max(48, grid.per_turn // 4), max(3, grid.degree // 2 + 1))))
    pressures, supply = first_guess(feeding, coarse)
    first = descend(coarse, feeding, load, start, pressures, supply, thinnest, 1e-4)
    if not first.solved:
        first = continue_to_load(coarse, feeding, load, start, thinnest)
        if not first.solved:
            return first
    network = first.network
    fine = RecessFilm.on(build(grid))
    last = descend(fine, feeding, load, first.at, network.pressures, network.supply_pressure, thinnest, TIGHT)
    if last.ending in (SearchOutcome.OVERLOADED, SearchOutcome.NOT_CONVERGED):
        climbed = continue_to_load(fine, feeding, load, start, thinnest)
        if not climbed.solved:
            return climbed
        network = climbed.network
        last = descend(
            fine, feeding, load, climbed.at, network.pressures, network.supply_pressure, thinnest, TIGHT
        )
    return last


def continue_to_load(
    film: RecessFilm, feeding: Feeding, load: Array, start: Array, thinnest: float
) -> RecessState:
    """Raise the load in shares, halving the rise where it fails; the answer tells how far it came."""
    pressures, supply = first_guess(feeding, film)
    at, share, rise = start, 0.0, 0.1
    state: RecessState | None = None
    while rise > max(FINEST_RISE * share, LEAST_SHARE):
        goal = min(1.0, share + rise)
        film.work.wet[:] = True
        found = descend(film, feeding, goal * load, at, pressures, supply, thinnest, 1e-4)
        if found.solved:
            at, share, rise, state = found.at, goal, 2.0 * rise, None
            pressures, supply = found.network.pressures, found.network.supply_pressure
            if share == 1.0:
                return found
        else:
            rise *= 0.5
            if state is None or found.ending is SearchOutcome.OVERLOADED or state.ending is found.ending:
                state = found  # that a larger share closes the gap tells more than that the search came to no end
    assert state is not None
    return replace(state, carried=share)


def descend(
    film: RecessFilm, feeding: Feeding, load: Array, start: Array, pressures: Array, supply: float,
    thinnest: float, tolerance: float,
) -> RecessState:  # fmt: skip
    """Newton on the position, the network solved in every step; where it does not descend, steps of a creep.

    With damping C and pseudo-time t the step is (K + C/t)^-1 (F + load): t grows where the force gets balanced.
    Not by `babbitt.numerics.damped_newton`: the pressures of the recesses are unknowns, too, and follow each step
    as far as it was taken.
    """
    units = np.abs(film.of.scales.motion) / film.of.scales.gap  # 1 for m, rad per m for tilts
    size = float(np.abs(load * units).max()) or float(film.of.scales.pressure * film.of.scales.area * 1e-3)
    at, old, creep = start.copy(), np.inf, 0.0
    gap = film.gap(at)
    moved = short = np.inf
    step = 0
    for step in range(1, MOST_STEPS + 1):
        response = film.evaluate(at, pressures)
        network = solve_network(feeding, response.conductance, response.outflow, pressures, supply)
        shift = network.pressures - pressures
        moved = float(np.abs(shift).max() / max(float(np.abs(pressures).max()), 1e-300))
        residual = response.force + response.area @ shift + load
        short = float(np.abs(residual * units).max()) / size
        if max(moved, short) < tolerance and response.changed == 0:
            return RecessState(film, response, network, at, ending_of(network), step, max(moved, short))
        if not np.isfinite(short):
            return RecessState(film, response, network, at, SearchOutcome.NOT_CONVERGED, step, short)
        stiffness, damping = static_coefficients(response, network)
        slow = 0.05 * float(np.abs(np.diag(stiffness) / np.diag(damping)).max())
        if short > 1.05 * old and short > 1e-6:
            creep = max(4.0 * creep, slow)
        else:
            creep = 0.2 * creep if creep > slow else 0.0
        old = short
        move = towards(stiffness + creep * damping, residual)
        while not move @ residual > 0.0 and short > 0.0 and creep < 1e9 * slow:  # behind the greatest load
            creep = max(4.0 * creep, slow)
            move = towards(stiffness + creep * damping, residual)
        if not np.isfinite(move).all():
            return RecessState(film, response, network, at, SearchOutcome.NOT_CONVERGED, step, short)
        new_gap, halvings = film.gap(at + move), 0
        while not new_gap > 0.4 * gap and halvings < 40:
            move, halvings = 0.5 * move, halvings + 1
            new_gap = film.gap(at + move)
        matrix = response.conductance + network.restrictor_matrix()
        change = np.linalg.solve(matrix, response.opening @ move)
        if network.converged:
            pressures = network.pressures - np.clip(change, -0.5 * abs(supply), 0.5 * abs(supply))
            supply = network.supply_pressure
        at, gap = at + move, new_gap
        if gap < thinnest:
            return RecessState(film, response, network, at, SearchOutcome.OVERLOADED, step, short)
    return RecessState(film, response, network, at, SearchOutcome.NOT_CONVERGED, step, max(moved, short))


def towards(stiffness: Array, residual: Array) -> Array:
    """Motion by which a stiffness takes up a force; no numbers where it has none in some direction."""
    try:
        return np.asarray(np.linalg.solve(stiffness, residual))
    except np.linalg.LinAlgError:
        return np.full_like(residual, np.nan)
