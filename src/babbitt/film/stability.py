"""When a bearing whirls: critical mass, whirl frequency ratio, Routh-Hurwitz margin of a rigid journal.

Equation of motion of a mass m carried by one film, about equilibrium:  m r'' + C r' + K r = 0. Its characteristic
polynomial is a quartic in s; on the threshold s = i Omega. Source: Lund J.W., Thomsen K.K. (1978).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

__all__ = ["critical_mass", "hurwitz_margins", "is_stable", "whirl_frequency"]

Matrix = NDArray[np.float64]


def threshold_stiffness(stiffness: Matrix, damping: Matrix) -> float:
    """Stiffness m Omega^2 of the journal on the threshold, N/m."""
    (kxx, kxy), (kyx, kyy) = stiffness
    (cxx, cxy), (cyx, cyy) = damping
    return float((kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy) / (cxx + cyy))


def whirl_frequency(stiffness: Matrix, damping: Matrix) -> float:
    """Angular frequency of the whirl on the threshold, rad/s; zero if the bearing cannot whirl.

    Omega^2 = ((k0 - Kxx)(k0 - Kyy) - Kxy Kyx) / det C with k0 the threshold stiffness.
    """
    k0 = threshold_stiffness(stiffness, damping)
    (kxx, kxy), (kyx, kyy) = stiffness
    squared = ((k0 - kxx) * (k0 - kyy) - kxy * kyx) / np.linalg.det(damping)
    return math.sqrt(squared) if squared > 0.0 else 0.0


def critical_mass(stiffness: Matrix, damping: Matrix) -> float:
    """Mass above which the journal whirls, kg per bearing; infinite if it never does.

    Zero where it leaves its place at any mass: where the static stiffness is that of a saddle or pushes it off.

    Parameters
    ----------
    stiffness, damping : ndarray, shape (2, 2)
        N/m and N s/m.

    Returns
    -------
    float
    """
    stays = np.linalg.det(stiffness) > 0.0 and threshold_stiffness(stiffness, damping) > 0.0
    if not stays:
        return 0.0
    frequency = whirl_frequency(stiffness, damping)
    if frequency == 0.0:
        return math.inf
    return threshold_stiffness(stiffness, damping) / frequency**2


def hurwitz_margins(mass: float, stiffness: Matrix, damping: Matrix) -> tuple[float, ...]:
    """Coefficients a3..a0 of the quartic over a4, and the last Hurwitz determinant; all positive means stable."""
    (kxx, kxy), (kyx, kyy) = np.asarray(stiffness) / mass
    (cxx, cxy), (cyx, cyy) = np.asarray(damping) / mass
    a3 = cxx + cyy
    a2 = kxx + kyy + cxx * cyy - cxy * cyx
    a1 = kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy
    a0 = kxx * kyy - kxy * kyx
    return float(a3), float(a2), float(a1), float(a0), float(a1 * (a3 * a2 - a1) - a3**2 * a0)


def is_stable(mass: float, stiffness: Matrix, damping: Matrix) -> bool:
    """Whether a rigid journal of this mass returns to its equilibrium (Routh-Hurwitz)."""
    return all(margin > 0.0 for margin in hurwitz_margins(mass, stiffness, damping))
