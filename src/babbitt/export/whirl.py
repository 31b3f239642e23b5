"""Coefficients of bearings with motions of their own: over speed and frequency, and the matrices behind them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError

__all__ = ["OverFrequency", "SystemMatrices"]

Array = NDArray[np.float64]

MIRRORED = ("tilt", "tangential")
"""Last words of the motions of a pad that turn round where the bearing is seen from the other end."""


@dataclass(frozen=True, eq=False)
class OverFrequency:
    """Stiffness and damping at n speeds and m frequencies of vibration.

    Attributes
    ----------
    frequencies : ndarray, shape (m,)
        rad/s, not negative, strictly increasing, the same at every speed.
    stiffness, damping : ndarray, shape (n, m, 2, 2)
        N/m and N s/m.

    Raises
    ------
    InputError
        E003 for frequencies in no order or numbers that are not finite, E004 for arrays that do not fit.
    """

    frequencies: Array
    stiffness: Array
    damping: Array

    def __post_init__(self) -> None:
        frequencies = frozen("frequencies", self.frequencies)
        if frequencies.ndim != 1 or frequencies.size == 0:
            raise InputError("E003", "frequencies: give one or more in a row")
        if frequencies[0] < 0.0 or np.any(np.diff(frequencies) <= 0.0):
            raise InputError("E003", "frequencies must increase and not be negative; sort the table")
        object.__setattr__(self, "frequencies", frequencies)
        for name in ("stiffness", "damping"):
            values = frozen(f"{name} over frequency", getattr(self, name))
            if values.ndim != 4 or values.shape[1:] != (frequencies.size, 2, 2):
                due = f"(speeds, {frequencies.size}, 2, 2)"
                raise InputError("E004", f"{name} over frequency has shape {values.shape}; it must be {due}")
            object.__setattr__(self, name, values)

    def changed(self, change: Callable[[Array], Array]) -> OverFrequency:
        """The same with a linear change of all its matrices."""
        return OverFrequency(self.frequencies, change(self.stiffness), change(self.damping))


@dataclass(frozen=True, eq=False)
class SystemMatrices:
    """M, C and K of journal and pads at one speed, before the pads are eliminated.

    Attributes
    ----------
    labels : tuple of str
        Of rows and columns: x and y of the journal, then ``pad N tilt``, ``pad N pivot``, ``pad N tangential``,
        all as lengths.
    stiffness, damping, mass : ndarray, shape (k, k)
        N/m, N s/m, kg.

    Raises
    ------
    InputError
        E003 for numbers that are not finite, E004 for matrices that do not fit the labels.
    """

    labels: tuple[str, ...]
    stiffness: Array
    damping: Array
    mass: Array

    def __post_init__(self) -> None:
        size = len(self.labels)
        for name in ("stiffness", "damping", "mass"):
            values = frozen(f"{name} of journal and pads", getattr(self, name))
            if values.shape != (size, size):
                raise InputError("E004", f"{name} of journal and pads has shape {values.shape} for {size} labels")
            object.__setattr__(self, name, values)

    def turned(self, axes: Array, mirrored: bool) -> SystemMatrices:
        """The same in other axes of the journal, seen from the other end where ``mirrored``: K' = T^T K T."""
        signs = [-1.0 if mirrored and label.split()[-1] in MIRRORED else 1.0 for label in self.labels]
        turn = np.diag(signs)
        turn[:2, :2] = axes
        parts = (turn.T @ part @ turn for part in (self.stiffness, self.damping, self.mass))
        return SystemMatrices(self.labels, *parts)


def frozen(what: str, given: Any) -> Array:
    """A read-only copy of an array of finite numbers."""
    try:
        values = np.array(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("E003", f"{what} is not an array of numbers") from None
    if not np.all(np.isfinite(values)):
        raise InputError("E003", f"{what} contains NaN or infinity; leave out what is not known")
    values.setflags(write=False)
    return values
