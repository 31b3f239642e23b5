"""A function made of cubics and its inverse, for one number in microseconds or for many at once."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.scalar_or_array import Array

_STEP_TOLERANCE = 1e-13  # of an argument of order one; Newton's next step would be the square of it
_MOST_STEPS = 60  # enough for plain bisection, should Newton's steps never stay inside the bracket


@dataclass(frozen=True, eq=False)
class PiecewiseCubic:
    """A function made of cubics.

    Attributes
    ----------
    nodes : ndarray, shape (n,)
        Ends of the intervals, strictly increasing.
    coefficients : ndarray, shape (4, n - 1)
        Powers of the distance to the left end of each interval, constant first.
    """

    nodes: Array
    coefficients: Array
    _starts: list[float] = field(init=False, repr=False)
    _cubics: list[list[float]] = field(init=False, repr=False)
    _levels: list[float] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        # plain lists: one look-up in an array costs more than the whole polynomial
        object.__setattr__(self, "_starts", self.nodes.tolist())
        object.__setattr__(self, "_cubics", self.coefficients.T.tolist())
        object.__setattr__(self, "_levels", [*self.coefficients[0].tolist(), self.at(float(self.nodes[-1]))])

    def at(self, place: float) -> float:
        """Value at one place; the end cubics go on outside the nodes."""
        index = bisect_right(self._starts, place, 1, len(self._cubics)) - 1
        c0, c1, c2, c3 = self._cubics[index]
        distance = place - self._starts[index]
        return c0 + distance * (c1 + distance * (c2 + distance * c3))

    def at_many(self, places: Array) -> Array:
        """Values at many places, any shape."""
        index = interval_of(self.nodes, places)
        distance = places - self.nodes[index]
        c0, c1, c2, c3 = self.coefficients
        result: Array = c3[index]
        for power in (c2, c1, c0):
            result *= distance
            result += power[index]
        return result.view(type(places))

    @property
    def first_slope(self) -> float:
        """Derivative at the first node."""
        return self._cubics[0][1]

    def place_of(self, level: float) -> float:
        """Where an increasing function takes a value between those at its ends.

        The interval is found among the values at the nodes, the place in it by Newton's method kept inside
        its bracket, so that ``at(place_of(level))`` is `level` to round-off.
        """
        index = bisect_right(self._levels, level, 1, len(self._cubics)) - 1
        c0, c1, c2, c3 = self._cubics[index]
        low, high = 0.0, self._starts[index + 1] - self._starts[index]
        distance = high * (level - c0) / (self._levels[index + 1] - c0)
        for _ in range(_MOST_STEPS):
            excess = c0 + distance * (c1 + distance * (c2 + distance * c3)) - level
            if excess > 0.0:
                high = distance
            else:
                low = distance
            following = distance - excess / (c1 + distance * (2.0 * c2 + distance * 3.0 * c3))
            if not low <= following <= high:
                following = 0.5 * (low + high)
            step = following - distance
            distance = following
            if -_STEP_TOLERANCE < step < _STEP_TOLERANCE:
                break
        return self._starts[index] + distance

    def places_of(self, levels: Array) -> Array:
        """`place_of` for many values, any shape."""
        node_levels = np.asarray(self._levels)
        index = interval_of(node_levels, levels)
        cubics = self.coefficients[:, index]
        distance = distances_of(cubics, np.diff(self.nodes)[index], node_levels[index + 1], levels)
        found: Array = np.asarray(self.nodes[index] + distance).view(type(levels))
        return found


def distances_of(cubics: Array, widths: Array, ends: Array, levels: Array) -> Array:
    """Distances from the left ends at which increasing cubics take values between those at their ends.

    Parameters
    ----------
    cubics : ndarray, shape (4, ...)
        Powers of the distance, constant first.
    widths, ends : ndarray
        Of the intervals, and the values at their right ends.
    levels : ndarray
        The values.
    """
    c0, c1, c2, c3 = cubics
    low, high = np.zeros_like(levels), widths
    distance: Array = high * (levels - c0) / (ends - c0)
    for _ in range(_MOST_STEPS):
        excess = c0 + distance * (c1 + distance * (c2 + distance * c3)) - levels
        low, high = np.where(excess > 0.0, low, distance), np.where(excess > 0.0, distance, high)
        following = distance - excess / (c1 + distance * (2.0 * c2 + distance * 3.0 * c3))
        following = np.where((low <= following) & (following <= high), following, 0.5 * (low + high))
        step = float(np.abs(following - distance).max(initial=0.0))
        distance = following
        if step < _STEP_TOLERANCE:
            break
    return distance


def interval_of(nodes: Array, values: Array) -> NDArray[np.intp]:
    """Index of the interval each value lies in, the first or the last one for values outside."""
    return np.clip(np.searchsorted(nodes, values, side="right") - 1, 0, len(nodes) - 2)
