"""Cuts through a tensor spline, one for each of many bearings: what `PiecewiseCubic` is for one."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.lanes import Lanes
from babbitt.numerics.piecewise_cubic import distances_of, interval_of
from babbitt.numerics.scalar_or_array import Array
from babbitt.numerics.tensor_spline import TensorSpline

__all__ = ["SplineCuts", "cuts_of"]


@dataclass(frozen=True, eq=False)
class SplineCuts:
    """One function of a tensor spline along its first variable, at another value of the second in each lane.

    Attributes
    ----------
    spline : TensorSpline
    function : int
    column, across : Lanes
        Interval of the second variable, and the distance to its left end.
    """

    spline: TensorSpline
    function: int
    column: Lanes
    across: Lanes

    def at(self, place: float) -> Array:
        """Values at one place of the first variable, one a lane."""
        return self.at_many(np.full(self.across.shape, place).view(Lanes))

    def at_many(self, places: Array) -> Array:
        """Values at one place a lane; the end cubics go on outside the nodes."""
        nodes = self.spline.first_nodes
        index = interval_of(nodes, places)
        c0, c1, c2, c3 = self._cubics(index)
        distance = places - nodes[index]
        return _in_lanes(c0 + distance * (c1 + distance * (c2 + distance * c3)))

    @property
    def first_slope(self) -> Array:
        """Derivative at the first node."""
        return _in_lanes(self._cubics(np.zeros(self.across.shape, np.intp))[1])

    def places_of(self, levels: Array) -> Array:
        """Where increasing functions take values between those at their ends, one a lane."""
        nodes = self.spline.first_nodes
        index = self._interval_of(levels)
        cubics, width = self._cubics(index), np.diff(nodes)[index]
        c0, c1, c2, c3 = cubics
        ends = c0 + width * (c1 + width * (c2 + width * c3))
        return _in_lanes(nodes[index] + distances_of(cubics, width, ends, np.asarray(levels)))

    def _interval_of(self, levels: Array) -> NDArray[np.intp]:
        """Interval of the first variable in which each function takes its value, by bisection over the nodes."""
        count = self.spline.first_nodes.size - 1
        low, high = np.zeros(self.across.shape, np.intp), np.full(self.across.shape, count, np.intp)
        for _ in range(int(count).bit_length()):
            middle = np.minimum((low + high) // 2, count - 1)
            above = np.asarray(self._levels(middle) <= levels)
            low, high = np.where(above, middle, low), np.where(above, high, middle)
        return low

    def _levels(self, index: NDArray[np.intp]) -> Array:
        """Values at the left ends of intervals."""
        return self._across(self.spline.coefficients[self.function][0][:, index, np.asarray(self.column)])

    def _cubics(self, index: NDArray[np.intp]) -> Array:
        """Powers of the first variable in its intervals, shape (4, lanes)."""
        powers = self.spline.coefficients[self.function][:, :, index, np.asarray(self.column)]
        return self._across(powers.swapaxes(0, 1))

    def _across(self, powers: Array) -> Array:
        """Cubics of the second variable, by their powers along the first axis, constant first."""
        across = np.asarray(self.across)
        found: Array = powers[3]
        for other in (2, 1, 0):
            found = found * across + powers[other]
        return found


def _in_lanes(values: Array) -> Array:
    found: Array = np.asarray(values).view(Lanes)
    return found


def cuts_of(spline: TensorSpline, second: Array) -> tuple[SplineCuts, ...]:
    """The functions of a spline of the first variable, at one value of the second a lane."""
    column = interval_of(spline.second_nodes, second)
    across = (second - spline.second_nodes[column]).view(Lanes)
    first = SplineCuts(spline, 0, column.view(Lanes), across)
    return tuple(replace(first, function=number) for number in range(spline.values.shape[0]))
