"""A massive housing: the bore unrolled onto the surface of an elastic half-space."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.deformation.compliance import BoreGrid, check_elastic

__all__ = ["HalfSpace", "patch_displacement"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class HalfSpace:
    """A body much larger than the loaded part of its bore.

    Distances count along the unrolled bore, the shorter way around; displacement against the body far away. That
    the bore is hollow makes it softer than this, by the more the wider the loaded arc.

    Attributes
    ----------
    elastic_modulus : float
        Pa.
    poisson_ratio : float
    """

    elastic_modulus: float
    poisson_ratio: float

    def __post_init__(self) -> None:
        check_elastic(self.elastic_modulus, self.poisson_ratio)

    @property
    def premise(self) -> str:
        """See `babbitt.reynolds.deformation.compliance.Compliance`."""
        return "The housing gives way as an elastic half-space onto which its bore is unrolled."

    def displacement(self, bore: BoreGrid, pressure: Array) -> Array:
        """See `babbitt.reynolds.deformation.compliance.Compliance`."""
        unit = (1.0 - self.poisson_ratio**2) / (math.pi * self.elastic_modulus)
        spectrum = np.fft.rfft(pressure, axis=0)
        displaced = np.einsum("njk,nk->nj", _influence(bore), spectrum)
        return np.asarray(unit * np.fft.irfft(displaced, bore.rows, axis=0))


def patch_displacement(x: Array, y: Array, half_length: float, half_width: Array) -> Array:
    """Displacement of a half-space under a rectangle of uniform pressure, over p (1 - nu^2) / (pi E), m.

    Love (1929), as Johnson, Contact Mechanics (1985), eq. (3.25).

    Parameters
    ----------
    x, y : ndarray
        From the middle of the rectangle, m.
    half_length, half_width : float, ndarray
        Of the rectangle in x and y, m.

    Returns
    -------
    ndarray
        Shape of x and y.
    """
    east, west, north, south = x + half_length, x - half_length, y + half_width, y - half_width
    return np.asarray(
        _log_term(east, north, south)
        + _log_term(north, east, west)
        - _log_term(west, north, south)
        - _log_term(south, east, west)
    )


def _log_term(arm: Array, high: Array, low: Array) -> Array:
    """``arm ln((high + |arm, high|) / (low + |arm, low|))``: zero where the arm is."""
    # ln(t + sqrt(t^2 + a^2)) - ln|a| = asinh(t / |a|), which loses nothing for negative t
    size = np.abs(arm)
    safe = np.where(size > 0.0, size, 1.0)
    return np.asarray(np.where(size > 0.0, arm * (np.arcsinh(high / safe) - np.arcsinh(low / safe)), 0.0))


@lru_cache(maxsize=4)
def _influence(bore: BoreGrid) -> Array:
    """Harmonics around of the influence of column k on column j, shape (rows // 2 + 1, j, k), m."""
    step = bore.turned[1]
    turned = np.minimum(bore.turned, 2.0 * math.pi - bore.turned)  # the shorter way
    half = 0.5 * bore.width
    z = bore.z
    cell = 0.5 * bore.width / (bore.columns - 1)
    low, high = np.maximum(z - cell, -half), np.minimum(z + cell, half)
    kernel = patch_displacement(
        (bore.radius * turned)[:, None, None],
        z[None, :, None] - 0.5 * (low + high)[None, None, :],
        0.5 * bore.radius * step,
        (0.5 * (high - low))[None, None, :],
    )
    return np.asarray(np.fft.rfft(kernel, axis=0).real)  # even around: no imaginary part
