"""Formulas written once, for one number (fast, no numpy) and for arrays."""

from __future__ import annotations

import math
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


def outside(value: float | Array, smallest: float, largest: float) -> bool:
    """Whether any value lies outside a range or is not a number."""
    if isinstance(value, np.ndarray):
        return value.size > 0 and not (float(value.min()) >= smallest and float(value.max()) <= largest)
    return not smallest <= value <= largest
