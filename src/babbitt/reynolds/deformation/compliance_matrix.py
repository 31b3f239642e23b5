"""A bore whose compliance was calculated or measured elsewhere: a matrix of influence around it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.deformation.compliance import TURN, BoreGrid

__all__ = ["ComplianceMatrix"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ComplianceMatrix:
    """Displacement of the bore at given angles by the pressure around each of them; even along the shaft.

    Attributes
    ----------
    angles : tuple of float
        rad, rising, less than one turn in all.
    compliance : tuple of tuple of float
        m/Pa: a row for every angle at which the bore gives way (outwards positive), a column for every angle
        around which a unit of pressure acts, from half way to its neighbour before to half way to that behind,
        over the whole width.
    """

    angles: tuple[float, ...]
    compliance: tuple[tuple[float, ...], ...]

    def __post_init__(self) -> None:
        count = len(self.angles)
        if count < 3 or any(after <= before for before, after in pairwise(self.angles)):
            raise InputError("E101", "the angles of a compliance matrix must rise; at least three of them.")
        if not self.angles[-1] - self.angles[0] < TURN:
            raise InputError(
                "E101", "the angles of a compliance matrix pass a whole turn; leave the last one out."
            )
        if len(self.compliance) != count or any(len(row) != count for row in self.compliance):
            raise InputError(
                "E101", f"a compliance matrix for {count} angles needs {count} rows of {count} values."
            )
        if not all(math.isfinite(value) for row in self.compliance for value in row):
            raise InputError("E101", "a compliance matrix has values that are not finite.")

    @property
    def premise(self) -> str:
        """See `babbitt.reynolds.deformation.compliance.Compliance`."""
        return (
            f"The bore gives way by a given matrix for {len(self.angles)} angles, even along the shaft, under the "
            "mean pressure over the width."
        )

    def displacement(self, bore: BoreGrid, pressure: Array) -> Array:
        """See `babbitt.reynolds.deformation.compliance.Compliance`."""
        given = np.array(self.compliance) @ (_sectors(self.angles, bore) @ (pressure @ bore.shares))
        return bore.across(np.interp(bore.theta, self.angles, given, period=TURN))


@lru_cache(maxsize=16)
def _sectors(angles: tuple[float, ...], bore: BoreGrid) -> Array:
    """Mean over the sector around every angle of values at equal steps, each of which stands for its own step."""
    at = np.array(angles)
    behind = np.append(at[1:], at[0] + TURN)
    ends = 0.5 * (at + behind)
    starts = np.concatenate(([ends[-1] - TURN], ends[:-1]))
    step, middle = TURN / bore.rows, bore.theta
    covered = np.zeros((at.size, bore.rows))
    for turn in (-2.0, -1.0, 0.0, 1.0, 2.0):
        low = np.maximum(starts[:, None], middle[None, :] + turn * TURN - 0.5 * step)
        high = np.minimum(ends[:, None], middle[None, :] + turn * TURN + 0.5 * step)
        covered += np.maximum(high - low, 0.0)
    return np.asarray(covered / (ends - starts)[:, None])
