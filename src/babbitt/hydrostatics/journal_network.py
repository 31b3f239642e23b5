"""Recessed journal bearing by lumped lands: the quick method.

Two axial lands for every recess over its pitch, one land between neighbours (or two to a drain groove), effective
length L - a, effective chord D sin(pi/n). Exact in the limit of small eccentricity for the lumped lands; against the
film in two dimensions 3 % low in stiffness for four recesses, 5 % high in flow.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.film.recess import RecessResponse
from babbitt.hydrostatics.geometry import RecessedJournal
from babbitt.hydrostatics.impedance import static_coefficients
from babbitt.hydrostatics.network import Feeding, NetworkState, solve_network
from babbitt.hydrostatics.state import Ending

__all__ = ["LumpedState", "centred_stiffness", "land_interaction", "lumped_at", "lumped_under"]

Array = NDArray[np.float64]
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)
STEP = 1e-30  # of the complex step, in clearances


class LumpedState:
    """Lumped lands and network at a position: ``response``, ``network``, ``at``, ``ending``."""

    def __init__(self, response: RecessResponse, network: NetworkState, at: Array, ending: Ending) -> None:
        self.response, self.network, self.at, self.ending = response, network, at, ending


def integrals(bearing: RecessedJournal, at: NDArray[np.complex128], first: float, last: float, power: int) -> complex:
    """Integral of h^power over an arc."""
    angle = 0.5 * (last + first) + 0.5 * (last - first) * NODES
    gap = bearing.clearance - at[0] * np.cos(angle) - at[1] * np.sin(angle)
    return complex(0.5 * (last - first) * (WEIGHTS @ gap**power))


def lumped_flow(
    bearing: RecessedJournal, viscosity: float, speed: float, at: NDArray[np.complex128]
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Matrix and Couette part of the outflow of all recesses: q = G p + q_0."""
    n, radius, a = bearing.count, bearing.radius, bearing.axial_land
    length = bearing.width - a
    matrix, couette = np.zeros((n, n), dtype=complex), np.zeros(n, dtype=complex)
    order = sorted(range(n), key=lambda k: bearing.recess_angles[k] % (2.0 * math.pi))
    surface = speed * radius
    for place, k in enumerate(order):
        following = order[(place + 1) % n]
        middle = bearing.recess_angles[k]
        pitch = (bearing.recess_angles[following] - middle) % (2.0 * math.pi) or 2.0 * math.pi
        half = 0.5 * bearing.recess_extent
        for owner, first, last in ((k, middle, middle + 0.5 * pitch), (following, middle + 0.5 * pitch, middle + pitch)):
            axial = integrals(bearing, at, first, last, 3) * radius / (6.0 * viscosity * a)
            matrix[owner, owner] += axial
        start, end = middle + half, middle + pitch - half
        lands: list[tuple[int | None, int | None, float, float]] = [(k, following, start, end)]
        if bearing.groove_extent > 0.0:
            centre, groove = middle + 0.5 * pitch, 0.5 * bearing.groove_extent
            lands = [(k, None, start, centre - groove), (None, following, centre + groove, end)]
        for before, after, first, last in lands:
            third = integrals(bearing, at, first, last, -3)
            conducts = length / (12.0 * viscosity * radius * third)
            dragged = length * 0.5 * surface * integrals(bearing, at, first, last, -2) / third
            for one, other, sign in ((before, after, 1.0), (after, before, -1.0)):
                if one is not None:
                    matrix[one, one] += conducts
                    couette[one] += sign * dragged
                    if other is not None:
                        matrix[one, other] -= conducts
    return matrix, couette


def lumped_at(
    bearing: RecessedJournal, feeding: Feeding, viscosity: float, speed: float, at: Array,
    guess: NetworkState | None = None,
) -> LumpedState:  # fmt: skip
    """State at a position.

    Parameters
    ----------
    bearing : RecessedJournal
    feeding : Feeding
    viscosity : float
        Pa s.
    speed : float
        rad/s.
    at : ndarray, shape (2,)
        m.
    guess : NetworkState or None

    Returns
    -------
    LumpedState
    """
    matrix, couette = lumped_flow(bearing, viscosity, speed, at.astype(complex))
    supply = feeding.nominal_pressure or 1e6
    begin = np.full(bearing.count, 0.5 * supply) if guess is None else guess.pressures
    supply = supply if guess is None else guess.supply_pressure
    outflow = (matrix @ begin + couette).real
    network = solve_network(feeding, matrix.real, outflow, begin, supply)
    p = network.pressures
    opening = np.empty((bearing.count, 2))
    for axis in range(2):
        moved = at.astype(complex)
        moved[axis] += 1j * STEP * bearing.clearance
        own, dragged = lumped_flow(bearing, viscosity, speed, moved)
        opening[:, axis] = (own @ p + dragged).imag / (STEP * bearing.clearance)
    chord = bearing.diameter * math.sin(math.pi / bearing.count) if bearing.count > 1 else bearing.diameter
    angles = np.array(bearing.recess_angles)
    area = -chord * (bearing.width - bearing.axial_land) * np.array([np.cos(angles), np.sin(angles)])
    response = RecessResponse(
        force=area @ p, outflow=(matrix @ p + couette).real, stiffness=np.zeros((2, 2)), damping=np.zeros((2, 2)),
        conductance=matrix.real, opening=opening, area=area, changed=0,
    )  # fmt: skip
    stable = network.least_eigenvalue(matrix.real) > 1e-12
    ending = Ending.NOT_CONVERGED if not network.converged else Ending.SOLVED
    return LumpedState(response, network, at, ending if stable else Ending.UNSTABLE_NETWORK)


def lumped_under(
    bearing: RecessedJournal, feeding: Feeding, viscosity: float, speed: float, load: Array
) -> LumpedState:
    """Equilibrium under a load (N, on the journal): Newton with steps that keep the gap open."""
    at = np.zeros(2)
    state = lumped_at(bearing, feeding, viscosity, speed, at)
    size = float(np.hypot(*load)) or 1.0
    for _ in range(60):
        residual = state.response.force + load
        if float(np.hypot(*residual)) < 1e-10 * size:
            return state
        stiffness, damping = static_coefficients(state.response, state.network)
        move = np.linalg.solve(stiffness, residual)
        if move @ residual <= 0.0:  # behind the greatest load
            move = np.linalg.solve(damping, residual)
            move *= 0.1 * bearing.clearance / float(np.hypot(*move))
        gap, share = bearing.clearance - float(np.hypot(*at)), 1.0
        while bearing.clearance - float(np.hypot(*(at + share * move))) < 0.4 * gap:
            share *= 0.5
        at = at + share * move
        if bearing.clearance - float(np.hypot(*at)) < 1e-3 * bearing.clearance:
            break
        state = lumped_at(bearing, feeding, viscosity, speed, at, state.network)
        if state.ending is not Ending.SOLVED:
            return state
    return LumpedState(state.response, state.network, state.at, Ending.OVERLOADED)


def land_interaction(bearing: RecessedJournal) -> float:
    """Gamma = n a (L - a)/(pi D b): how well the lands between recesses conduct against the axial ones."""
    n, a = bearing.count, bearing.axial_land
    between = (2.0 * math.pi / n - bearing.recess_extent) * bearing.radius
    return n * a * (bearing.width - a) / (math.pi * bearing.diameter * between)


def centred_stiffness(bearing: RecessedJournal, supply_pressure: float, pressure_ratio: float) -> float:
    """Stiffness of the centred journal with capillaries or slots and without drain grooves, N/m."""
    n = bearing.count
    share = land_interaction(bearing) * (1.0 - math.cos(2.0 * math.pi / n))
    whole = 1.5 * n * n / math.pi * math.sin(math.pi / n) ** 2 * bearing.diameter
    whole *= (bearing.width - bearing.axial_land) * supply_pressure * pressure_ratio * (1.0 - pressure_ratio)
    return whole / (bearing.clearance * (1.0 + share * (1.0 - pressure_ratio)))
