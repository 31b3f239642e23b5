"""Viscosity that grows with pressure: laws, and the transform that keeps the Reynolds equation linear.

With mu(p) = mu_0 f(p) the flow h^3 / (12 mu) grad p is h^3 / (12 mu_0) grad r with the reduced pressure

    r(p) = int_0^p dp' / f(p')         (Kirchhoff's transform; r = (1 - exp(-alpha p)) / alpha for Barus)

so that the film is solved for r, and only loads need p(r). For Barus r ends at 1 / alpha, where the pressure would
be without bound: a film that asks for more has no pressure, and its solution says so. Couette shear takes mu(p)
from line to line. The Reynolds number of a turbulent film keeps the viscosity at ambient pressure.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError

__all__ = ["Barus", "PressureViscosity", "Roelands", "pressure_of", "pressure_table", "reduced_pressure"]

Array = NDArray[np.float64]

POINTS = 400
HIGHEST = 8.0
"""alpha p up to which the table reaches; films of plain bearings stay far below 1."""
ROELANDS_PRESSURE = 1.96e8
"""p_0 of Roelands's law, Pa. Source: Roelands, Correlational aspects of the viscosity-temperature-pressure
relationship of lubricating oils, thesis Delft 1966."""
ROELANDS_LEVEL = 9.67
"""ln mu_0 + 9.67 with mu_0 in Pa s: all isotherms of the law meet at 6.31e-5 Pa s. Same source."""


class PressureViscosity(Protocol):
    """Viscosity at a gauge pressure over that at ambient pressure."""

    @property
    def coefficient(self) -> float:
        """d ln mu / dp at ambient pressure, 1/Pa."""
        ...

    def ratio(self, pressure: Array) -> Array:
        """f(p), p in Pa, shape kept."""
        ...


@dataclass(frozen=True)
class Barus:
    """f = exp(alpha p), alpha in 1/Pa. Source: Barus, American J. Science 45 (1893) 87-96."""

    coefficient: float

    def __post_init__(self) -> None:
        check_coefficient(self.coefficient)

    def ratio(self, pressure: Array) -> Array:
        """f(p)."""
        return np.asarray(np.exp(self.coefficient * np.maximum(pressure, 0.0)))


@dataclass(frozen=True)
class Roelands:
    """f = exp((ln mu_0 + 9.67) ((1 + p/p_0)^Z - 1)), Z from the slope alpha at ambient pressure.

    Attributes
    ----------
    coefficient : float
        alpha = d ln mu / dp at p = 0, 1/Pa.
    viscosity : float
        mu_0, Pa s.
    """

    coefficient: float
    viscosity: float

    def __post_init__(self) -> None:
        check_coefficient(self.coefficient)
        if not math.log(max(self.viscosity, 1e-300)) + ROELANDS_LEVEL > 0.0:
            raise InputError("E101", f"viscosity is {self.viscosity} Pa s; Roelands's law needs more than "
                             f"{math.exp(-ROELANDS_LEVEL):.3g} Pa s, where its isotherms meet.")  # fmt: skip

    def ratio(self, pressure: Array) -> Array:
        """f(p)."""
        level = math.log(self.viscosity) + ROELANDS_LEVEL
        exponent = self.coefficient * ROELANDS_PRESSURE / level
        rise = (1.0 + np.maximum(pressure, 0.0) / ROELANDS_PRESSURE) ** exponent - 1.0
        return np.asarray(np.exp(level * rise))


def check_coefficient(coefficient: float) -> None:
    """Refuse coefficients that no oil has."""
    if not (math.isfinite(coefficient) and coefficient > 0.0):
        raise InputError("E101", f"pressure coefficient is {coefficient} 1/Pa; it must be positive.")


def pressure_table(law: PressureViscosity) -> Array:
    """Reduced pressure, pressure and slope dp/dr = f, rows of a table up to the highest pressure of a film.

    Parameters
    ----------
    law : PressureViscosity

    Returns
    -------
    ndarray, shape (3, points)
        Pa, Pa, 1.
    """
    pressure = HIGHEST / law.coefficient * np.linspace(0.0, 1.0, POINTS) ** 2
    nodes, weights = np.polynomial.legendre.leggauss(5)
    half, middle = 0.5 * np.diff(pressure), 0.5 * (pressure[1:] + pressure[:-1])
    inner = middle[:, None] + half[:, None] * nodes
    pieces = half * ((1.0 / law.ratio(inner)) @ weights)
    return np.array([np.concatenate(([0.0], np.cumsum(pieces))), pressure, law.ratio(pressure)])


def reduced_pressure(table: Array, pressure: Array) -> Array:
    """Reduced pressures by a table (rows: reduced pressure, pressure, slope between them)."""
    from scipy.interpolate import CubicHermiteSpline

    return np.asarray(CubicHermiteSpline(table[1], table[0], 1.0 / table[2])(pressure))


def pressure_of(table: Array, reduced: Array) -> Array:
    """Pressures by the same table."""
    from scipy.interpolate import CubicHermiteSpline

    return np.asarray(CubicHermiteSpline(table[0], table[1], table[2])(reduced))
