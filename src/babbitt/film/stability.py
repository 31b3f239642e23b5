"""When a bearing whirls: critical mass and whirl frequency of a rigid journal.

Equation of motion of a mass m carried by one film, about equilibrium:  m r'' + C r' + K r = 0. Its characteristic
polynomial is a quartic in s; on the threshold s = i Omega. Source: Lund J.W., Thomsen K.K. (1978).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

__all__ = ["critical_mass", "whirl_frequency"]

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
