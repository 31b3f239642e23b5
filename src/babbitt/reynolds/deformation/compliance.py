"""How a bore gives way under pressure: what every compliance answers, and the column, each spot by itself.

A compliance takes the gauge pressure on a grid over the bore and answers what the gap gains there. Several of them
(a soft liner in an elastic ring) add up: the pressure passes through all.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.model import Field

__all__ = ["BoreGrid", "ColumnLiner", "Compliance", "as_field", "total_displacement"]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi


@dataclass(frozen=True)
class BoreGrid:
    """Equally spaced places over a bore, as ``babbitt.reynolds.model.Field`` has them.

    Attributes
    ----------
    radius, width : float
        Of the bore, m.
    rows, columns : int
        Once around, and from side to side.
    start : float
        Angle of the first row, rad.
    """

    radius: float
    width: float
    rows: int = 240
    columns: int = 25
    start: float = 0.0

    @property
    def theta(self) -> Array:
        """Angles of the rows, rad, shape (rows,)."""
        return self.start + self.turned

    @property
    def turned(self) -> Array:
        """Angles from the first row on, rad, shape (rows,)."""
        return np.asarray(np.arange(self.rows, dtype=np.float64) * (TURN / self.rows))

    @property
    def z(self) -> Array:
        """Axial places of the columns, m, exactly antisymmetric, shape (columns,)."""
        steps = 2.0 * np.arange(self.columns) - (self.columns - 1)
        return np.asarray(steps * (0.5 * self.width / (self.columns - 1)))

    @property
    def shares(self) -> Array:
        """Part of the width that each column stands for, shape (columns,)."""
        share = np.full(self.columns, 1.0 / (self.columns - 1))
        share[[0, -1]] *= 0.5
        return share

    def across(self, around: Array) -> Array:
        """The same values in every column, shape (rows, columns)."""
        return np.repeat(around[:, None], self.columns, axis=1)


class Compliance(Protocol):
    """Whatever tells how far a bore gives way."""

    @property
    def premise(self) -> str:
        """What it is and takes for granted, a sentence for the report."""
        ...

    def displacement(self, bore: BoreGrid, pressure: Array) -> Array:
        """Gain of the gap in m under a gauge pressure in Pa, both of shape (rows, columns)."""
        ...


@dataclass(frozen=True)
class ColumnLiner:
    """A thin liner on a rigid back, bonded to it: every spot gives way by itself (Winkler).

    Thin means against the length over which the pressure changes; a liner whose Poisson ratio is close to 0.5
    (rubber) is stiffer than any column tells.

    Attributes
    ----------
    compliance : float
        Displacement per pressure, m/Pa.
    """

    compliance: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.compliance) and self.compliance >= 0.0):
            raise InputError(
                "E101", f"the compliance of a liner is {self.compliance} m/Pa; it must be zero or more."
            )

    @classmethod
    def of_layer(cls, thickness: float, elastic_modulus: float, poisson_ratio: float) -> ColumnLiner:
        """Liner of a thickness (m), modulus (Pa) and Poisson ratio, held sideways by its back.

        k = t (1 + nu)(1 - 2 nu) / (E (1 - nu)): uniaxial strain, Johnson, Contact Mechanics (1985), section 4.3.
        """
        check_elastic(elastic_modulus, poisson_ratio)
        if not (math.isfinite(thickness) and thickness > 0.0):
            raise InputError("E101", f"the thickness of a liner is {thickness} m; it must be positive.")
        nu = poisson_ratio
        return cls(thickness * (1.0 + nu) * (1.0 - 2.0 * nu) / (elastic_modulus * (1.0 - nu)))

    @property
    def premise(self) -> str:
        """See `Compliance`."""
        return f"Liner of {1e12 * self.compliance:.3g} um/MPa: every spot of it gives way by itself."

    def displacement(self, bore: BoreGrid, pressure: Array) -> Array:
        """See `Compliance`."""
        return self.compliance * pressure


def total_displacement(compliances: Sequence[Compliance], bore: BoreGrid, pressure: Array) -> Array:
    """What the gap gains by all compliances together, m, shape (rows, columns)."""
    total = np.zeros((bore.rows, bore.columns))
    for one in compliances:
        total += one.displacement(bore, pressure)
    return total


def as_field(values: Array) -> Field:
    """Values on a ``BoreGrid`` as the film takes them."""
    return tuple(tuple(row) for row in values.tolist())


def check_elastic(elastic_modulus: float, poisson_ratio: float) -> None:
    """Refuse solids that are none."""
    if not (math.isfinite(elastic_modulus) and elastic_modulus > 0.0):
        raise InputError("E101", f"elastic_modulus is {elastic_modulus} Pa; it must be positive.")
    if not 0.0 <= poisson_ratio < 0.5:
        raise InputError("E101", f"poisson_ratio is {poisson_ratio}; it must lie from 0 up to below 0.5.")
