"""Flow network of the recesses: what the restrictors let in, the film lets out.

At a fixed active set the film is linear, q = q_0 + G p with G symmetric; the restrictors are not. Newton on the
recess pressures and, behind a pump, the supply pressure:

    q_k(p) = Q_k(p_k, p_s),     sum_k Q_k = Q_pump(p_s).

A state is stable if all eigenvalues of G - dQ/dp have positive real parts; valves with a rising law can break
that.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.restrictors import Restrictor
from babbitt.kinds.hydrostatic.supply import FixedPressure, Pump, Supply

__all__ = ["Feeding", "NetworkState", "solve_network"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]
MOST_STEPS = 80
TIGHT = 1e-13


@dataclass(frozen=True)
class Feeding:
    """Restrictors, one for every recess, and what feeds them.

    Attributes
    ----------
    restrictors : tuple of Restrictor
    supply : Supply
    """

    restrictors: tuple[Restrictor, ...]
    supply: Supply

    @property
    def is_uniform(self) -> bool:
        """Whether all restrictors are alike."""
        return all(one == self.restrictors[0] for one in self.restrictors)

    @property
    def nominal_pressure(self) -> float:
        """A pressure of the size to come, Pa."""
        supply = self.supply
        if isinstance(supply, FixedPressure):
            return supply.pressure
        return supply.relief_pressure if np.isfinite(supply.relief_pressure) else 0.0


@dataclass(frozen=True, eq=False)
class NetworkState:
    """Pressures and flows of the network.

    Attributes
    ----------
    pressures, flows : ndarray, shape (n,)
        Gauge Pa and m3/s, of every recess.
    supply_pressure : float
        Gauge, Pa.
    overflow : float
        Through the relief valve, m3/s.
    slope : ndarray, shape (n,)
        G_r = -dQ/dp at standing supply pressure.
    supply_slope : ndarray, shape (n,)
        dQ/dp_s; zeros where the supply pressure stands.
    manifold_slope : float
        What the pump lacks more and the restrictors take more per pascal of supply; infinite where it stands.
    residual : float
        Largest imbalance of a recess over the largest flow.
    converged : bool
    least_eigenvalue : float
        Of G - dQ/dp, its least real part over the largest in size; the state is stable where it is positive.
    """

    pressures: Array
    flows: Array
    supply_pressure: float
    overflow: float
    slope: Array
    supply_slope: Array
    manifold_slope: float
    residual: float
    converged: bool
    least_eigenvalue: float

    @property
    def is_stable(self) -> bool:
        """Whether recess pressures come back after a disturbance."""
        return self.least_eigenvalue > 1e-12

    def restrictor_matrix(self) -> Array:
        """-dQ/dp of all restrictors with the answer of the supply pressure."""
        return answering(self.slope, self.supply_slope, self.manifold_slope)

    def moved_restrictor_matrix(self, manifold: complex) -> ComplexArray:
        """The same where the oil in the manifold gives way; ``manifold`` is its i nu V/B."""
        return np.asarray(answering(self.slope, self.supply_slope, self.manifold_slope + manifold), complex)


def answering(slope: Array, supply_slope: Array, manifold_slope: complex) -> NDArray[Any]:
    """-dQ/dp of restrictors with what they take off the supply pressure, where that does not stand."""
    own = np.diag(slope)
    if cmath.isinf(manifold_slope) or not np.any(supply_slope):  # metered flows do not ask for the supply pressure
        return own
    return own - np.outer(supply_slope, slope) / manifold_slope


def least_eigenvalue(matrix: Array, symmetric: bool) -> float:
    """Least real part among the eigenvalues of G - dQ/dp over the largest in size."""
    if matrix.size == 1:
        return math.copysign(1.0, float(matrix[0, 0]))
    found = np.linalg.eigvalsh(matrix) if symmetric else np.linalg.eigvals(matrix)
    return float(found.real.min() / max(np.abs(found).max(), 1e-300))


def solve_network(feeding: Feeding, conductance: Array, outflow: Array, at: Array, supply: float) -> NetworkState:
    """Pressures at which the film lets out what the restrictors let in.

    Parameters
    ----------
    feeding : Feeding
    conductance : ndarray, shape (n, n)
        dq/dp of the film, m3/(s Pa).
    outflow : ndarray, shape (n,)
        Of the film at the pressures ``at``, m3/s.
    at : ndarray, shape (n,)
        Pa.
    supply : float
        First guess of the supply pressure, Pa.

    Returns
    -------
    NetworkState
    """
    given = feeding.supply
    if isinstance(given, FixedPressure):
        return attempts(feeding, conductance, outflow, at, given.pressure, None)
    state = attempts(feeding, conductance, outflow, at, min(supply, given.relief_pressure), given)
    if state.converged and state.supply_pressure <= given.relief_pressure:
        return state
    if not np.isfinite(given.relief_pressure):
        return state
    relieved = attempts(feeding, conductance, outflow, at, given.relief_pressure, None)
    spare = given.delivers(given.relief_pressure) - float(relieved.flows.sum())
    return relieved if spare < 0.0 else replace(relieved, overflow=spare)


def attempts(
    feeding: Feeding, conductance: Array, outflow: Array, at: Array, supply: float, pump: Pump | None
) -> NetworkState:
    """Newton from the given pressures; where that ends nowhere or in an unstable state, from high and low ones.

    Valves with a rising law may have several states, of which the stable one lasts: for one recess Newton meets it
    from the pressure of the supply, where the ports are open and let nothing in.
    """
    first = newton(feeding, conductance, outflow, at, at, supply, pump)
    if first.converged and first.is_stable:
        return first
    for share in (1.0, 0.98, 0.02) if at.size == 1 else (0.98, 0.02):
        start = np.full(at.size, share * supply)
        other = newton(feeding, conductance, outflow, at, start, supply, pump)
        if other.converged and other.is_stable:
            return other
    return first


def newton(
    feeding: Feeding, conductance: Array, outflow: Array, at: Array, start: Array, supply: float, pump: Pump | None
) -> NetworkState:
    """Newton with halved steps; the supply pressure is an unknown where there is a pump."""
    p: NDArray[np.float64] = start.astype(float)
    count = p.size
    unknowns = count if pump is None else count + 1
    old = np.inf
    step: Array = np.zeros(unknowns)
    matrix, right = np.zeros((unknowns, unknowns)), np.zeros(unknowns)
    diagonal = np.arange(count)
    flows, by_recess, by_supply = laws(feeding.restrictors, p, supply)
    size = max(float(np.abs(flows).max()), float(np.abs(outflow).max()), 1e-300)
    halvings, short, settled = 0, np.inf, False
    for _ in range(MOST_STEPS):
        residual = outflow + conductance @ (p - at) - flows
        wrong = float(np.abs(residual).max())
        if pump is not None:
            right[count] = pump.delivers(supply) - float(flows.sum())
            wrong = max(wrong, abs(float(right[count])))
        size = max(float(np.abs(flows).max()), 1e-12 * size)
        short = wrong / size
        if short < TIGHT or settled:  # settled: what is left is the round-off of the pressures
            break
        if wrong > 0.95 * old and halvings < 12:
            step *= 0.5
            p, supply = p - step[:count], supply - (0.0 if pump is None else float(step[count]))
            halvings += 1
        else:
            matrix[:count, :count] = conductance
            matrix[diagonal, diagonal] -= by_recess
            right[:count] = -residual
            if pump is not None:
                matrix[:count, count], matrix[count, :count] = -by_supply, by_recess
                matrix[count, count] = float(by_supply.sum()) + pump.leakage
            try:
                step = np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
            except np.linalg.LinAlgError:
                break
            old, halvings = wrong, 0
            settled = float(np.abs(step).max()) < 1e-12 * max(float(np.abs(p).max()), abs(supply))
            p, supply = p + step[:count], supply + (0.0 if pump is None else float(step[count]))
        flows, by_recess, by_supply = laws(feeding.restrictors, p, supply)
    slopes = (-by_recess, np.zeros(count), np.inf)
    if pump is not None:
        slopes = (-by_recess, by_supply, float(by_supply.sum()) + pump.leakage)
    return NetworkState(
        pressures=p,
        flows=flows,
        supply_pressure=float(supply),
        overflow=0.0,
        slope=slopes[0],
        supply_slope=slopes[1],
        manifold_slope=slopes[2],
        residual=short,
        converged=bool(short < 1e-9 or (settled and short < 1e-4)),
        least_eigenvalue=least_eigenvalue(conductance + answering(*slopes), pump is None),
    )


def laws(restrictors: Sequence[Restrictor], p: Array, supply: float) -> tuple[Array, Array, Array]:
    """Flows and slopes of all restrictors."""
    found = np.array([one.law(float(own), supply) for one, own in zip(restrictors, p, strict=True)])
    return found[:, 0], found[:, 1], found[:, 2]
