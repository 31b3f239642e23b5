"""Where the collar stands over pads on a ring, for a thrust or for a mean film."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.roots import bracketed_root

__all__ = ["THINNEST", "LoadLaw", "approach_at_film", "approach_under", "heights_at"]

Array = NDArray[np.float64]

NEWTON_STEPS = 80
SETTLED = 1e-12
"""Of a film; the step after it would change nothing, since Newton's method squares the error."""
THINNEST = 1e-9
"""Least film of the search, m."""


class LoadLaw(Protocol):
    """Load of each pad over the film at its pivot."""

    def load(self, height: Array) -> Array:
        """Loads, N, at heights of the pivots, m; they fall with the height."""

    def slope(self, height: Array) -> Array:
        """Their derivative, N/m, negative."""


def heights_at(law: LoadLaw, ring_stiffness: float, positions: Array) -> Array:
    """Films of pads over a ring: the roots of h - W(h)/c = position (S2), one each since W falls with h.

    Newton's method on h, kept between bounds that it halves where a step would leave them.
    """
    if math.isinf(ring_stiffness):
        return np.maximum(positions, THINNEST)
    reach = np.cbrt(law.load(np.full(positions.shape, 1e-4)) * 1e-8 / ring_stiffness)
    low = np.full(positions.shape, THINNEST)
    high = np.maximum(positions, 0.0) + reach + THINNEST
    while np.any(short := high - law.load(high) / ring_stiffness < positions):
        high = np.where(short, 2.0 * high, high)
    height = np.sqrt(low * high)
    height = np.where(positions > 0.3 * reach, high, np.maximum(height, 0.5 * reach))
    for _ in range(NEWTON_STEPS):
        miss = height - law.load(height) / ring_stiffness - positions
        high, low = np.where(miss > 0.0, height, high), np.where(miss > 0.0, low, height)
        new = height - miss / (1.0 - law.slope(height) / ring_stiffness)
        new = np.where((new >= low) & (new <= high), new, 0.5 * (low + high))
        if np.all(np.abs(new - height) <= SETTLED * new):
            return np.asarray(new)
        height = new
    return np.asarray(height)


def approach_under(law: LoadLaw, ring_stiffness: float, away: Array, thrust: float, mean: float) -> float:
    """Position of the collar at which the pads together carry a thrust (S3), m.

    Parameters
    ----------
    law : LoadLaw
    ring_stiffness : float
        c, N/m per pad; infinite for a rigid ring.
    away : ndarray, shape (z,)
        What is added to the film under each pad, m.
    thrust : float
        F0, N.
    mean : float
        Film of a pad under the mean load, m, about which the search begins.
    """

    def excess(approach: float) -> float:
        return math.log(float(law.load(heights_at(law, ring_stiffness, approach + away)).sum()) / thrust)

    yielding = 0.0 if math.isinf(ring_stiffness) else thrust / ring_stiffness
    low, high = -float(away.max()) - yielding - mean, mean - float(away.min())
    if math.isinf(ring_stiffness):
        low = min(0.1 * mean - float(away.min()), high)
    step = mean + yielding + float(np.ptp(away))
    while excess(low) < 0.0:
        low, step = low - step, 2.0 * step
    while excess(high) > 0.0:
        high, step = high + step, 2.0 * step
    return bracketed_root(excess, low, high)


def approach_at_film(law: LoadLaw, ring_stiffness: float, away: Array, film: float) -> float:
    """Position of the collar at which the films at the pivots have a mean, m; the ring gives way.

    Parameters
    ----------
    law, ring_stiffness, away
        As of `approach_under`.
    film : float
        m.
    """
    low, high = -float(away.max()), film - float(away.min())  # at high every pad stands farther than the mean film
    reach = film + float(law.load(np.full(away.shape, film)).mean()) / ring_stiffness

    def excess(approach: float) -> float:
        return float(heights_at(law, ring_stiffness, approach + away).mean()) - film

    while excess(low) > 0.0:
        low -= reach
    return bracketed_root(excess, low, high)
