"""Bearings with several recesses by lumped lands: the quick method of journal bearings and thrust rings.

Exact for the lumped lands; against the film in two dimensions the stiffness of a four-recess journal bearing is
3 % low, its flow 5 % high.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.gap_search import gap_for_load
from babbitt.kinds.hydrostatic.geometry import RecessedJournal
from babbitt.kinds.hydrostatic.impedance import static_coefficients
from babbitt.kinds.hydrostatic.lumps import Lumps
from babbitt.kinds.hydrostatic.network import Feeding, NetworkState, solve_network
from babbitt.kinds.hydrostatic.state import SearchOutcome, ending_of
from babbitt.numerics.damped_newton import damped_newton
from babbitt.reynolds.recess.recess_film import RecessResponse

__all__ = ["LumpedState", "centred_stiffness", "land_interaction", "level_under", "lumped_at", "lumped_under"]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi
FLAT = 1e-9
"""Of the largest stiffness: what is less is none."""
MOST_STEPS, MOST_HALVINGS, THINNEST = 80, 30, 1e-3
"""Of a search, of one of its steps, and the gap over that at rest at which it gives up."""
ROUND_OFF = 1e-12
"""Of what all recesses push, whatever their direction: no load is met more closely than that."""


@dataclass(frozen=True, eq=False)
class LumpedState:
    """Lumped lands and network at a position.

    Attributes
    ----------
    response : RecessResponse
    network : NetworkState
    at : ndarray
        Position, m and rad.
    ending : SearchOutcome
    carried : float
        Greatest share of the load found to be carried, where not all was.
    """

    response: RecessResponse
    network: NetworkState
    at: Array
    ending: SearchOutcome
    carried: float = 0.0


def lumped_at(lumps: Lumps, feeding: Feeding, at: Array, guess: NetworkState | None = None) -> LumpedState:
    """State at a position.

    Parameters
    ----------
    lumps : Lumps
    feeding : Feeding
    at : ndarray, shape (motions,)
        m and rad.
    guess : NetworkState or None

    Returns
    -------
    LumpedState
    """
    supply = (feeding.nominal_pressure or 1e6) if guess is None else guess.supply_pressure
    begin = np.full(len(lumps.angles), 0.5 * supply) if guess is None else guess.pressures
    flow = lumps.flow(at)
    network = solve_network(feeding, flow.conductance, flow.outflow(begin), begin, supply)
    p = network.pressures
    response = RecessResponse(
        force=lumps.area @ p, outflow=flow.outflow(p), stiffness=np.zeros((at.size, at.size)),
        damping=lumps.damping(at), conductance=flow.conductance, opening=flow.opening(p), area=lumps.area,
        changed=0,
    )  # fmt: skip
    return LumpedState(response, network, at, ending_of(network))


def level_under(
    lumps: Lumps, feeding: Feeding, load: float, bounds: tuple[float, float], tolerance: float
) -> tuple[float, LumpedState]:
    """Gap (m) of a level ring under a load (N), to a relative tolerance, and the ring as it was tried last.

    The gap is as of `babbitt.kinds.hydrostatic.gap_search.gap_for_load`: 0, infinite or nan where there is none.
    """
    state: LumpedState | None = None

    def carried(gap: float) -> tuple[float, float]:
        nonlocal state
        at = np.array([gap - lumps.gap, 0.0, 0.0])
        state = lumped_at(lumps, feeding, at, None if state is None else state.network)
        stiffness, _ = static_coefficients(state.response, state.network)
        return float(state.response.force[0]), float(stiffness[0, 0])

    found = gap_for_load(carried, load, bounds, lumps.gap, tolerance)
    assert state is not None  # the search begins with a gap
    return found, state


def lumped_under(lumps: Lumps, feeding: Feeding, load: Array, state: LumpedState) -> LumpedState:
    """Equilibrium under a load: Newton with steps that keep the gap open.

    Parameters
    ----------
    lumps : Lumps
    feeding : Feeding
    load : ndarray, shape (motions,)
        On the moving part, N and N m.
    state : LumpedState
        To begin from.

    Returns
    -------
    LumpedState
    """
    carrying = _Carrying(lumps, feeding, load, state)
    ended = damped_newton(carrying, state.at, MOST_STEPS, THINNEST * lumps.gap, MOST_HALVINGS)
    carried = 0.0 if ended.status is SearchOutcome.SOLVED else carrying.best
    return replace(carrying.state, ending=ended.status, carried=carried)


@dataclass(eq=False)
class _Carrying:
    """Lumped lands that are to carry a load; see `babbitt.numerics.damped_newton.NewtonProblem`."""

    lumps: Lumps
    feeding: Feeding
    load: Array
    state: LumpedState
    best: float = 0.0
    no_room: ClassVar[SearchOutcome] = SearchOutcome.OVERLOADED
    too_many_steps: ClassVar[SearchOutcome] = SearchOutcome.OVERLOADED

    def room(self, at: Array) -> float:
        """Thinnest gap, m."""
        return self.lumps.thinnest(at)

    def kept_room(self, at: Array, room: float) -> float:
        """A share of the gap."""
        return 0.4 * room

    def look(self, at: Array, step: int) -> SearchOutcome | None:
        """Lands and network there, and whether they carry the load."""
        if step > 1:
            self.state = lumped_at(self.lumps, self.feeding, at, self.state.network)
            if self.state.ending is not SearchOutcome.SOLVED:
                return self.state.ending
        arm = np.where(np.arange(self.load.size) < (1 if self.load.size == 3 else 2), 1.0, 1.0 / self.lumps.radius)
        size = float(np.abs(self.load * arm).max()) or 1.0
        short = float(np.abs((self.state.response.force + self.load) * arm).max())
        pushed = float((np.abs(self.lumps.area) @ np.abs(self.state.network.pressures) * arm).max())
        if short < max(1e-10 * size, ROUND_OFF * pushed):
            return SearchOutcome.SOLVED
        self.best = max(self.best, 1.0 - short / size)
        return None

    def move(self, at: Array, room: float) -> Array:
        """Newton's step; a creep where it leads behind the greatest load."""
        stiffness, damping = static_coefficients(self.state.response, self.state.network)
        residual = self.state.response.force + self.load
        move, creep = step_against(self.lumps, stiffness, residual), 0.0
        while move @ residual <= 0.0 and creep < 1e12:
            creep = max(10.0 * creep, 1e-3 * abs(np.trace(stiffness) / np.trace(damping)))
            move = step_against(self.lumps, stiffness + creep * damping, residual)
        return move


def step_against(lumps: Lumps, stiffness: Array, residual: Array) -> Array:
    """Newton's step; the least one where there are too few recesses to resist every motion."""
    if len(lumps.angles) > 2:
        return np.asarray(np.linalg.solve(stiffness, residual), dtype=np.float64)
    return np.asarray(np.linalg.lstsq(stiffness, residual, rcond=FLAT)[0], dtype=np.float64)


def land_interaction(bearing: RecessedJournal) -> float:
    """Gamma = n a (L - a)/(pi D b): how well the lands between recesses conduct against the axial ones."""
    n, a = bearing.count, bearing.axial_land
    between = (TURN / n - bearing.recess_extent) * bearing.radius
    return n * a * (bearing.width - a) / (math.pi * bearing.diameter * between)


def centred_stiffness(bearing: RecessedJournal, supply_pressure: float, pressure_ratio: float) -> float:
    """Stiffness of the centred journal with capillaries or slots and without drain grooves, N/m.

    The limit of the lumped lands for small eccentricity, three recesses or more.
    """
    n = bearing.count
    share = land_interaction(bearing) * (1.0 - math.cos(TURN / n))
    whole = 1.5 * n * n / math.pi * math.sin(math.pi / n) ** 2 * bearing.diameter
    whole *= (bearing.width - bearing.axial_land) * supply_pressure * pressure_ratio * (1.0 - pressure_ratio)
    return whole / (bearing.clearance * (1.0 + share * (1.0 - pressure_ratio)))
