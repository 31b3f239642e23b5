"""Where the nodes of the film stand: dense where the gap is narrow, and dense towards the rim.

Both maps are smooth, so halving every interval keeps the error of second order and Richardson extrapolation
holds.
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.kinds.journal.iso7902.characteristics.sommerfeld_angle import sommerfeld_angle
from babbitt.numerics.scalar_or_array import Array

# Share of the nodes that follow the Sommerfeld angle; the others are even in phi. At eps = 0.99 this puts the
# nodes at the narrowest gap seven times as close as even spacing would, and nowhere more than twice as far
# apart.
_SOMMERFELD_SHARE = 0.5

# Intervals across the half width shrink from (1 + c) at mid-plane to (1 - c) at the rim, where at large eps
# and B/D the pressure falls within a strip as narrow as the loaded region is long.
_RIM_CROWDING = 0.75


def circumferential_nodes(start: float, end: float, eccentricity_ratio: float, cells: int) -> Array:
    """Nodes between two angles, their density the mean of even in phi and even in the Sommerfeld angle.

    Parameters
    ----------
    start, end : float
        Edges of the film phi1 < phi2 [rad], within 0 ... 2 pi.
    eccentricity_ratio : float
        eps, 0 <= eps < 1.
    cells : int
        Number of intervals.

    Returns
    -------
    ndarray, shape (cells + 1,)
        Increasing angles [rad] with the edges first and last.
    """
    wanted = np.linspace(0.0, 1.0, cells + 1)
    gamma_start, gamma_end = sommerfeld_angle(np.array([start, end]), eccentricity_ratio)
    even_density = (1.0 - _SOMMERFELD_SHARE) / (end - start)
    gamma_density = _SOMMERFELD_SHARE / (gamma_end - gamma_start)
    root = math.sqrt(1.0 - eccentricity_ratio**2)

    angle = start + (end - start) * wanted
    low, high = np.full_like(angle, start), np.full_like(angle, end)
    for _ in range(100):  # Newton kept inside its bracket: the share of nodes passed is monotone in phi
        passed = even_density * (angle - start) + gamma_density * (
            sommerfeld_angle(angle, eccentricity_ratio) - gamma_start
        )
        low = np.where(passed < wanted, angle, low)
        high = np.where(passed < wanted, high, angle)
        density = even_density + gamma_density * root / (1.0 + eccentricity_ratio * np.cos(angle))
        newton = angle - (passed - wanted) / density
        following = np.where((newton > low) & (newton < high), newton, 0.5 * (low + high))
        step = float(np.abs(following - angle).max())
        angle = following
        if step < 1e-14:
            break
    angle[0], angle[-1] = start, end
    return angle


def axial_nodes(cells: int) -> Array:
    """Nodes across the half width, from mid-plane (0) to the rim (1), closer towards the rim.

    Parameters
    ----------
    cells : int
        Number of intervals over half the width.

    Returns
    -------
    ndarray, shape (cells + 1,)

    Examples
    --------
    >>> axial_nodes(2)
    array([0.    , 0.6875, 1.    ])
    """
    even = np.linspace(0.0, 1.0, cells + 1)
    return even * (1.0 + _RIM_CROWDING * (1.0 - even))
