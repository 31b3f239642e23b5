"""Contact of rough surfaces: the pressure that asperities carry at a mean gap, after Greenwood and Tripp.

Source: Greenwood, Tripp, The contact of two nominally flat rough surfaces, Proc. Instn Mech. Engrs 185 (1970)
625-633. The integral F_5/2 of the Gaussian distribution is taken by its usual fit, 4.4086e-5 (4 - h/σ)^6.804,
which ends at 4 σ.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["CONTACT_UP_TO", "AsperityContact", "composite_modulus", "composite_roughness"]

Array = NDArray[np.float64]

CONTACT_UP_TO = 4.0
"""Gap over composite roughness from which asperities do not touch."""

FIT_FACTOR, FIT_EXPONENT = 4.4086e-5, 6.804
"""Of the fit of F_5/2."""

RZ_OVER_RQ = 5.0
"""Mean peak-to-valley height over rms roughness of one surface. Assumption: no fixed ratio is standardised, and
turned and ground surfaces have about 4 to 6."""


@dataclass(frozen=True)
class AsperityContact:
    """Asperities of both surfaces together.

    Attributes
    ----------
    roughness : float
        Composite rms roughness σ in m.
    modulus : float
        ``E' = 1/((1 - ν1²)/E1 + (1 - ν2²)/E2)`` in Pa.
    density : float
        ``η_s β_s σ``, dimensionless: asperities per area, radius of their tips, roughness.
    sharpness : float
        ``σ/β_s``, dimensionless.
    friction : float
        Coefficient of boundary friction where asperities touch.
    """

    roughness: float
    modulus: float
    density: float = 0.04
    sharpness: float = 0.001
    friction: float = 0.1

    @property
    def scale(self) -> float:
        """``(16 √2 π/15) (η_s β_s σ)² √(σ/β_s) E'`` in Pa."""
        factor = 16.0 * math.sqrt(2.0) * math.pi / 15.0
        return factor * self.density**2 * math.sqrt(self.sharpness) * self.modulus

    def pressure(self, gap: ArrayLike) -> Array:
        """Mean contact pressure in Pa at gaps in m, zero from 4 σ on.

        >>> AsperityContact(1e-6, 50e9).pressure([2e-6, 4e-6, 1.0]).round(-1).tolist()
        [59060.0, 0.0, 0.0]
        """
        return np.asarray(self.scale * FIT_FACTOR * self._depth(gap) ** FIT_EXPONENT)

    def stiffness(self, gap: ArrayLike) -> Array:
        """``-dp/dh`` in Pa/m."""
        slope = FIT_EXPONENT * self._depth(gap) ** (FIT_EXPONENT - 1.0)
        return np.asarray(self.scale * FIT_FACTOR * slope / self.roughness)

    def _depth(self, gap: ArrayLike) -> Array:
        return np.maximum(CONTACT_UP_TO - np.asarray(gap, dtype=np.float64) / self.roughness, 0.0)


def composite_roughness(bearing: float, journal: float) -> float:
    """Rms roughness σ of both surfaces in m from their heights Rz in m, ``sqrt(Rz_B² + Rz_J²)/5``.

    >>> round(1e6 * composite_roughness(4e-6, 3e-6), 9)
    1.0
    """
    return math.hypot(bearing, journal) / RZ_OVER_RQ


def composite_modulus(first: tuple[float, float], second: tuple[float, float]) -> float:
    """``E' = 1/((1 - ν1²)/E1 + (1 - ν2²)/E2)`` in Pa of two bodies, each by modulus in Pa and Poisson's ratio.

    >>> round(1e-9 * composite_modulus((210e9, 0.3), (210e9, 0.3)), 2)
    115.38
    """
    return 1.0 / sum((1.0 - ratio**2) / modulus for modulus, ratio in (first, second))
