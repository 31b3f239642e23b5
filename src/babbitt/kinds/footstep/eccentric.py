"""The eccentric or tilted smooth clearance: how much more leaks and rubs, and the side force of its pressure.

Short-annulus film: oil runs along the heel only, ``q(theta) = (p1 - p_a)/(12 mu Int dz/h³)``. For a parallel heel
this gives the factor 1 + 3/2 eps² known for eccentric annuli (F. M. White, Viscous Fluid Flow). A tilted heel
changes the gap on the way, so that the pressure falls unevenly and pushes to one side.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.model import Footstep

__all__ = ["leak_factor", "mean_inverse_gap", "side_force_of_leakage"]

Array = NDArray[np.float64]
AROUND = 256
"""Angles of the trapezoidal rule, which converges exponentially on a circle."""


def _resistance(first: Array, last: Array) -> Array:
    """Mean of (h/delta)^-3 along a gap that runs straight from `first` to `last`: (h1 + h2)/(2 h1² h2²)."""
    return np.asarray((first + last) / (2.0 * (first * last) ** 2))


def leak_factor(rim: float, outer: float) -> float:
    """Leakage over that of the concentric clearance.

    Parameters
    ----------
    rim, outer : float
        Eccentricity over clearance at either end, in one plane.

    Examples
    --------
    >>> round(leak_factor(0.4, 0.4), 12)
    1.24
    """
    if rim == outer:
        return 1.0 + 1.5 * rim**2
    cosine = np.cos(2.0 * math.pi * np.arange(AROUND) / AROUND)
    return float(np.mean(1.0 / _resistance(1.0 + rim * cosine, 1.0 + outer * cosine)))


def mean_inverse_gap(footstep: Footstep, depth: float = 0.0) -> float:
    """Mean of 1/h over the heel, 1/m: its shear over that of a gap of one metre.

    Parameters
    ----------
    footstep : Footstep
    depth : float
        By which the gap is everywhere wider, as over a groove, m.

    Notes
    -----
    Around the heel the mean is ``1/sqrt(h0² - (delta eps)²)`` with h0 = delta + depth, along it eps runs straight
    from end to end; the mean of both is a difference of arc sines.
    """
    rim, outer = footstep.end_eccentricities
    middle = footstep.clearance + depth
    share = footstep.clearance / middle
    if rim == outer:
        return 1.0 / (middle * math.sqrt(1.0 - (share * rim) ** 2))
    return (math.asin(share * rim) - math.asin(share * outer)) / (share * (rim - outer)) / middle


def side_force_of_leakage(footstep: Footstep, rim_pressure: float) -> float:
    """Side force in N of the pressure that drives the leakage, along the eccentricity.

    Positive: towards larger eccentricity (the heel is pressed against the cup); negative: towards the centre.
    Zero for a parallel heel.

    Parameters
    ----------
    footstep : Footstep
    rim_pressure : float
        p1, Pa absolute.

    Notes
    -----
    The share of the pressure difference left at z is the resistance of the gap from z to the outer end over that
    of the whole gap. With h running straight from h1 to h2 its mean over the length is ``h1/(h1 + h2)``; hence
    ``F = -(p1 - p_a) r1 L Int cos(theta) h1/(h1 + h2) dtheta``, theta from the eccentric side.
    """
    rim, outer = footstep.end_eccentricities
    if rim == outer:
        return 0.0
    part = footstep.geometry
    cosine = np.cos(2.0 * math.pi * np.arange(AROUND) / AROUND)
    # The heel stands towards theta = 0: there the gap is 1 - eps, and pressure there pushes it back.
    first, last = 1.0 - rim * cosine, 1.0 - outer * cosine
    mean = first / (first + last)
    drop = rim_pressure - footstep.ambient_pressure
    return -drop * part.radius * part.length * 2.0 * math.pi * float(np.mean(mean * cosine))
