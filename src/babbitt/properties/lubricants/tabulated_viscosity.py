"""A viscosity law by a table: Andrade's law from point to point."""

from __future__ import annotations

import itertools
import math
from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from babbitt.core.notices import InputError
from babbitt.properties.lubricants._evaluation import Point, Value, evaluate, require_falling
from babbitt.properties.lubricants.viscosity_laws import ViscosityKind

FEWEST_POINTS = 3
"""With two the law is Andrade's over the whole range, which mineral oils are far from."""


@dataclass(frozen=True)
class TabulatedViscosity:
    r"""Viscosities at several temperatures, with Andrade's law from each to the next.

    .. math:: \eta = \eta_i \, \exp\Bigl(b_i \bigl(\tfrac{1}{T} - \tfrac{1}{T_i}\bigr)\Bigr), \qquad
        T_i \le T \le T_{i+1}

    so that :math:`\ln\eta` over :math:`1/T` is a line of straight pieces. Outside the table its first and last
    piece go on.

    Parameters
    ----------
    points : tuple of tuple of float
        Temperatures in K, rising, each with its viscosity, falling; at least three.
    kind : ViscosityKind
        Which viscosity they are: dynamic in Pa s, or kinematic in m²/s.

    Raises
    ------
    InputError
        E003 for a number that is not positive and finite, E006 for fewer points, temperatures that do not rise or
        viscosities that do not fall.

    Notes
    -----
    Source of the law of each piece: E. N. da C. Andrade, Nature 125 (1930) 309. The error between points of an oil
    by Walther's law falls with the square of their distance: 0.26 % at most for 5 K, 0.04 % for 2 K (ISO VG 46, 0
    to 120 °C).

    Examples
    --------
    >>> law = TabulatedViscosity(((293.15, 0.1), (323.15, 0.025), (363.15, 0.008)))
    >>> law(323.15), law.temperature_range
    (0.025, (293.15, 363.15))
    """

    points: tuple[Point, ...]
    kind: ViscosityKind = ViscosityKind.DYNAMIC

    def __post_init__(self) -> None:
        if len(self.points) < FEWEST_POINTS:
            says = f"Table of viscosities: {len(self.points)} points; it takes {FEWEST_POINTS} or more."
            raise InputError("E006", f"{says} Exponential and Walther go through two.")
        require_falling("Table of viscosities", *self.points)

    @property
    def temperature_range(self) -> tuple[float, float]:
        """From the first to the last temperature of the table, K."""
        return self.points[0][0], self.points[-1][0]

    def __call__(self, temperature: Value) -> Value:
        """Viscosity in SI at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=0.0, law="the table of viscosities")

    def _formula(self, m: Any, temperature: Any) -> Any:
        if m is math:
            row = max(0, bisect_right(self._temperatures, temperature) - 1)
            at, viscosity, slope = self._pieces[row]
        else:
            row = np.maximum(0, np.searchsorted(self._temperatures, temperature, side="right") - 1)
            at, viscosity, slope = np.moveaxis(np.array(self._pieces)[row], -1, 0)
        return viscosity * m.exp(slope * (1.0 / temperature - 1.0 / at))

    @cached_property
    def _temperatures(self) -> list[float]:
        return [temperature for temperature, _ in self.points]

    @cached_property
    def _pieces(self) -> list[tuple[float, float, float]]:
        """Temperature, viscosity and slope of ln η over 1/T of the piece that begins at each point."""
        slopes = [
            math.log(thick / thin) / (1.0 / colder - 1.0 / warmer)
            for (colder, thick), (warmer, thin) in itertools.pairwise(self.points)
        ]
        return [(*point, slope) for point, slope in zip(self.points, [*slopes, slopes[-1]], strict=True)]
