"""Fixed points x = G(x) by Anderson's acceleration, always with a status.

Of the residuals f = G(x) - x of the last states that combination is taken which is least in the linear picture,

    gamma = argmin |f - dF gamma|,   x' = x + b f - (dX + b dF) gamma,

with the differences dX, dF of states and residuals and the damping b.
Source: D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547-560;
H. F. Walker, P. Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011) 1715-1735
(type II).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

import numpy as np

from babbitt.numerics.scalar_or_array import Array
from babbitt.numerics.secants import RecycledSecants

__all__ = ["AndersonAccelerator", "AndersonOptions", "FixedPoint", "FixedPointStatus", "fixed_point"]

SAME = 1e-6
"""Sine between differences of residuals, and size of one over the residual, below which it tells nothing new."""


@dataclass(frozen=True)
class AndersonOptions:
    """How states are combined, and how long a search may take.

    Attributes
    ----------
    most_evaluations : int
        Of the map.
    memory : int
        Differences of earlier states that are combined.
    damping, least_damping : float
        Share b of the residual that the next state takes, and the least to which failures halve it.
    astray : float
        Residual over the least one from which the search begins anew at the best state, with half the damping.
    largest_share : float
        Bound on the entries of gamma.
    most_failures : int
        States in a row without a value of the map, each half-way back to the last one that had one.
    """

    most_evaluations: int
    memory: int = 8
    damping: float = 1.0
    least_damping: float = 0.05
    astray: float = math.inf
    largest_share: float = math.inf
    most_failures: int = 0


class FixedPointStatus(Enum):
    """How a search ended."""

    CONVERGED = "converged"
    TOO_MANY_EVALUATIONS = "too many evaluations"
    LOST = "the map has no value where the search leads"


@dataclass(frozen=True, eq=False)
class FixedPoint:
    """Where a search ended: the last state at which the map had a value, or the start."""

    status: FixedPointStatus
    state: Array
    evaluations: int

    @property
    def converged(self) -> bool:
        """Whether it is the fixed point."""
        return self.status is FixedPointStatus.CONVERGED


class AndersonAccelerator:
    """The next state from the last ones and their residuals, vectors of one length.

    Parameters
    ----------
    options : AndersonOptions
    weights : ndarray or float
        Of the entries in the norm of residuals.
    """

    def __init__(self, options: AndersonOptions, weights: Array | float = 1.0) -> None:
        self.options, self.damping, self._weights = options, options.damping, weights
        self._states: list[Array] = []
        self._residuals: list[Array] = []
        self._best = math.inf

    def step(self, state: Array, residual: Array) -> tuple[Array, Array]:
        """State to go on from, and the move from there."""
        size = self.norm(residual)
        if size > self.options.astray * self._best:
            least = min(range(len(self._states)), key=lambda one: self.norm(self._residuals[one]))
            self._states, self._residuals = [self._states[least]], [self._residuals[least]]
            self._best = self.norm(self._residuals[0])
            self._shorten()
            return self._states[0], self.damping * self._residuals[0]
        self._best = min(self._best, size)
        kept = -1 - self.options.memory
        self._states, self._residuals = [*self._states, state][kept:], [*self._residuals, residual][kept:]
        if len(self._states) == 1:
            return state, self.damping * residual
        if len(self._states) == 2:
            move, gain = state - self._states[0], residual - self._residuals[0]
            share = self._share(gain, residual, size)
            return state, self.damping * residual - share * (move + self.damping * gain)
        states, residuals = np.array(self._states), np.array(self._residuals)
        moves, gains = states[1:] - states[:-1], residuals[1:] - residuals[:-1]
        shares = self._shares(gains, residual, size)
        return state, self.damping * residual - np.einsum("ik,i->k", moves + self.damping * gains, shares)

    def fail(self) -> None:
        """Forget all states, for the last step led nowhere, and take shorter ones."""
        self._states, self._residuals, self._best = [], [], math.inf
        self._shorten()

    def norm(self, residual: Array) -> float:
        """Weighted size of a residual."""
        weighted = residual * self._weights
        return math.sqrt(float(weighted @ weighted))

    def _share(self, gain: Array, residual: Array, size: float) -> float:
        """gamma of one difference: a quotient; the general way takes longer than many a map."""
        weighted = gain * np.square(self._weights)
        normal = float(weighted @ gain)
        if not math.sqrt(normal) > SAME * size:
            return 0.0
        most = self.options.largest_share
        return min(max(float(weighted @ residual) / normal, -most), most)

    def _shares(self, gains: Array, residual: Array, size: float) -> Array:
        """gamma, of least norm where differences tell the same."""
        # a few long vectors: threads of a BLAS would wait for each other longer than they work, einsum has none
        weighted = gains * np.square(self._weights)
        normal, right = np.einsum("ik,jk->ij", weighted, gains), np.einsum("ik,k->i", weighted, residual)
        lengths = np.sqrt(normal.diagonal())
        scale = np.divide(1.0, lengths, out=np.zeros_like(lengths), where=lengths > SAME * size)
        cosines = normal * np.outer(scale, scale)
        shares = scale * np.linalg.lstsq(cosines, scale * right, rcond=SAME**2)[0]
        return np.asarray(np.clip(shares, -self.options.largest_share, self.options.largest_share))

    def _shorten(self) -> None:
        self.damping = max(0.5 * self.damping, min(self.options.least_damping, self.damping))


def as_it_is(_: Array, move: Array) -> Array:
    """A move without bound."""
    return move


def fixed_point(
    residual: Callable[[Array], Array | None],
    settled: Callable[[Array, Array], bool],
    start: Array,
    options: AndersonOptions,
    bounded: Callable[[Array, Array], Array | None] = as_it_is,
    weights: Array | float = 1.0,
    secants: RecycledSecants | None = None,
) -> FixedPoint:
    """State at which a residual has converged.

    Parameters
    ----------
    residual : callable
        G(x) - x at a state x, a vector; None where the map has no value. What it raises passes through.
    settled : callable
        Whether a state with its residual is the answer.
    start : ndarray
        A vector.
    options : AndersonOptions
    bounded : callable
        The part of a move from a state that may be taken; None: none of it, the search is lost.
    weights : ndarray or float
        Of the entries in the norm of residuals.
    secants : RecycledSecants or None
        What searches for almost the same map have learnt; it takes the place of Anderson's combinations.

    Returns
    -------
    FixedPoint

    Examples
    --------
    x = cos x:

    >>> options = AndersonOptions(most_evaluations=9, memory=1)
    >>> found = fixed_point(lambda x: np.cos(x) - x, lambda x, f: abs(f[0]) < 1e-12, np.ones(1), options)
    >>> found.status.name, found.evaluations, found.state.round(9)
    ('CONVERGED', 7, array([0.73908513]))
    """
    accelerator = AndersonAccelerator(options, weights) if secants is None else secants
    if secants is not None:
        secants.begin()
    state, failures = start, 0
    known: Array | None = None
    for evaluations in range(1, options.most_evaluations + 1):
        off = residual(state)
        if off is None:
            failures += 1
            if known is None or failures > options.most_failures:
                return FixedPoint(FixedPointStatus.LOST, state if known is None else known, evaluations)
            accelerator.fail()
            state = 0.5 * (state + known)
            continue
        known, failures = state, 0
        if settled(state, off):
            return FixedPoint(FixedPointStatus.CONVERGED, state, evaluations)
        if evaluations == options.most_evaluations:
            break
        begin, move = accelerator.step(state, off)
        allowed = bounded(begin, move)
        if allowed is None:
            return FixedPoint(FixedPointStatus.LOST, state, evaluations)
        state = begin + allowed
    last = state if known is None else known
    return FixedPoint(FixedPointStatus.TOO_MANY_EVALUATIONS, last, options.most_evaluations)
