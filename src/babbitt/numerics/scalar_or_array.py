"""Formulas written once, for one number (fast, no numpy) and for arrays."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Value = TypeVar("Value", float, Array)
"""A number in, a number out; an array in, an array out."""


def functions_for(value: object) -> Any:
    """The functions of `math` for one number, those of numpy 2 (which bear the same names) for an array."""
    return np if isinstance(value, np.ndarray) else math


def clipped(value: Value, smallest: float, largest: float) -> Value:
    """Value kept within a range."""
    if isinstance(value, np.ndarray):
        return np.clip(value, smallest, largest)
    return min(max(value, smallest), largest)


def larger(value: Value, other: Value | float) -> Value:
    """The larger of two values, of arrays element by element."""
    if isinstance(value, np.ndarray) or isinstance(other, np.ndarray):
        return np.maximum(value, other)
    return max(value, other)


def smaller(value: Value, other: Value | float) -> Value:
    """The smaller of two values, of arrays element by element."""
    if isinstance(value, np.ndarray) or isinstance(other, np.ndarray):
        return np.minimum(value, other)
    return min(value, other)


def sense_of(value: Value) -> Value:
    """1 with the sign of a value, element by element.

    >>> sense_of(-3.0), sense_of(0.0)
    (-1.0, 1.0)
    """
    sense: Value = functions_for(value).copysign(1.0, value)
    return sense


def holds_anywhere(value: Any) -> bool:
    """Whether something holds, of an array whether it does for any of its elements."""
    return bool(value.any()) if isinstance(value, np.ndarray) else bool(value)


def place_among(bounds: Sequence[float], value: Any) -> Any:
    """Number of rising bounds below a value, element by element.

    >>> place_among((1.0, 2.0, 4.0), 2.0), place_among((1.0, 2.0, 4.0), np.array([0.5, 3.0])).tolist()
    (1, [0, 2])
    """
    return np.searchsorted(bounds, value) if isinstance(value, np.ndarray) else bisect_left(bounds, value)


def outside(value: float | Array, smallest: float, largest: float | Array) -> bool:
    """Whether any value lies outside a range or is not a number."""
    if isinstance(value, np.ndarray) or isinstance(largest, np.ndarray):
        return not np.asarray((value >= smallest) & (value <= largest)).all()
    return not smallest <= value <= largest
