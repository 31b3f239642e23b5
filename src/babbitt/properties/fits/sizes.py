"""Limits of size of a bore or a journal, and the deviations that lead to them."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.core.notices import InputError
from babbitt.numerics.scalar_or_array import functions_for


@dataclass(frozen=True)
class SizeLimits:
    """Smallest and largest permissible diameter of a part at 20 °C, in m.

    Raises
    ------
    InputError
        E003 if a limit is not a positive finite number, E004 if the largest is below the smallest.
    """

    minimum: float
    maximum: float

    def __post_init__(self) -> None:
        for name, size in (("minimum", self.minimum), ("maximum", self.maximum)):
            if not (functions_for(size).isfinite(size) and size > 0.0):
                raise InputError("E003", f"the {name} limit of size is {size!r} m; it must be a positive number")
        if self.maximum < self.minimum:
            raise InputError(
                "E004",
                f"the maximum limit of size {self.maximum * 1e3:.6g} mm is below the minimum "
                f"{self.minimum * 1e3:.6g} mm; exchange the two values",
            )


@dataclass(frozen=True)
class Deviations:
    """Lower and upper limit deviation from the nominal size, in m (ISO 286-1: EI, ES or ei, es).

    Raises
    ------
    InputError
        E003 if a deviation is not finite, E004 if the upper one is below the lower.
    """

    lower: float
    upper: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.lower) and math.isfinite(self.upper)):
            raise InputError("E003", f"deviations must be finite numbers, given {self.lower!r} and {self.upper!r}")
        if self.upper < self.lower:
            raise InputError(
                "E004",
                f"the upper deviation {self.upper * 1e6:+.4g} um is below the lower "
                f"{self.lower * 1e6:+.4g} um; exchange the two values",
            )

    @property
    def tolerance(self) -> float:
        """Width of the tolerance zone in m."""
        return self.upper - self.lower

    def limits(self, nominal: float) -> SizeLimits:
        """Limits of size around a nominal size.

        Parameters
        ----------
        nominal : float
            Nominal size in m.

        Returns
        -------
        SizeLimits
            In m.
        """
        return SizeLimits(nominal + self.lower, nominal + self.upper)
