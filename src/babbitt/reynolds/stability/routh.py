"""Which masses a bearing carries without whirl, and how fast a rigid journal whirls on the threshold.

Equation of motion of a mass m carried by one film, about equilibrium:  m r'' + C r' + K r = 0. Its characteristic
polynomial is a quartic in s; on the threshold s = i Omega. Source: Lund J.W., Thomsen K.K. (1978). The criterion
of Routh for that quartic asks for tr C > 0, det K > 0, k0 > 0 and

    det C k0 > m (k0^2 - k0 tr K + det K)

with k0 the threshold stiffness. Where det C is positive it bounds the mass from above; where det C is negative, as
that of mass-conserving films with one groove behind the load may be, from below. Matrices may hold
`babbitt.numerics.lanes.Lanes` in place of numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["StableMasses", "critical_mass", "stable_masses", "whirl_frequency"]

Matrix = NDArray[np.float64]


def threshold_stiffness(stiffness: Matrix, damping: Matrix) -> float:
    """Stiffness m Omega^2 of the journal on the threshold, N/m."""
    (kxx, kxy), (kyx, kyy) = stiffness
    (cxx, cxy), (cyx, cyy) = damping
    return _number((kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy) / (cxx + cyy))  # type: ignore[no-any-return]


def _number(value: Any) -> Any:
    """A plain number, or the lanes that take its place."""
    return value if np.ndim(value) else float(value)


def _determinant(matrix: Matrix) -> float:
    (xx, xy), (yx, yy) = matrix
    return _number(xx * yy - xy * yx)  # type: ignore[no-any-return]


def _trace(matrix: Matrix) -> float:
    (xx, _), (_, yy) = matrix
    return _number(xx + yy)  # type: ignore[no-any-return]


def whirl_frequency(stiffness: Matrix, damping: Matrix) -> float:
    """Angular frequency of the whirl on the threshold, rad/s; zero if no mass is on the threshold.

    Omega^2 = ((k0 - Kxx)(k0 - Kyy) - Kxy Kyx) / det C with k0 the threshold stiffness.
    """
    k0 = threshold_stiffness(stiffness, damping)
    (kxx, kxy), (kyx, kyy) = stiffness
    squared = ((k0 - kxx) * (k0 - kyy) - kxy * kyx) / _determinant(damping)
    return _number(np.sqrt(squared)) if squared > 0.0 else 0.0


@dataclass(frozen=True)
class StableMasses:
    """Masses of a rotor that run without whirl: more than `least` and less than `greatest`, kg per bearing."""

    least: float
    greatest: float

    def reserve(self, mass: float) -> float:
        """How many times a rotor's mass, in kg, is within its nearer bound: above 1 where it is stable."""
        heaviest = self.greatest / mass if mass > 0.0 else math.inf
        return min(heaviest, mass / self.least if self.least > 0.0 else math.inf)


NO_MASS = StableMasses(math.inf, 0.0)
"""Where a journal of any mass leaves its place."""


def stable_masses(stiffness: Matrix, damping: Matrix) -> StableMasses:
    """Masses of a rigid journal for which every motion dies away, by the criterion of Routh.

    Parameters
    ----------
    stiffness, damping : ndarray, shape (2, 2)
        N/m and N s/m.

    Returns
    -------
    StableMasses
        `NO_MASS` where it leaves its place at any mass: where the static stiffness is that of a saddle or pushes
        it off, or where the film feeds its motion.
    """
    k0 = threshold_stiffness(stiffness, damping)
    of_k, of_c = _determinant(stiffness), _determinant(damping)
    if not (_trace(damping) > 0.0 and of_k > 0.0 and k0 > 0.0):
        return NO_MASS
    slope = k0 * k0 - k0 * _trace(stiffness) + of_k
    if of_c > 0.0:
        return StableMasses(0.0, of_c * k0 / slope if slope > 0.0 else math.inf)
    return StableMasses(of_c * k0 / slope, math.inf) if slope < 0.0 else NO_MASS


def critical_mass(stiffness: Matrix, damping: Matrix) -> float:
    """Mass above which the journal whirls, kg per bearing; infinite if a heavy one never does, zero if any does.

    Parameters
    ----------
    stiffness, damping : ndarray, shape (2, 2)
        N/m and N s/m.

    Returns
    -------
    float
    """
    return stable_masses(stiffness, damping).greatest
