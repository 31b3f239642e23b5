"""Bicubic splines through several tables on one grid: cut along a line, or evaluated at scattered points."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from babbitt.numerics.piecewise_cubic import PiecewiseCubic, interval_of
from babbitt.numerics.scalar_or_array import Array
from babbitt.numerics.spline import spline_coefficients


@dataclass(frozen=True, eq=False)
class TensorSpline:
    """Tensor-product cubic splines of `k` functions of two variables.

    Attributes
    ----------
    first_nodes, second_nodes : ndarray, shape (n,) and (m,)
        Strictly increasing.
    values : ndarray, shape (k, n, m)
        Functions at the nodes.
    """

    first_nodes: Array
    second_nodes: Array
    values: Array

    def cut(self, second: float) -> tuple[PiecewiseCubic, ...]:
        """The `k` functions of the first variable at one value of the second."""
        index = int(interval_of(self.second_nodes, np.asarray(second)))
        powers = (second - self.second_nodes[index]) ** np.arange(4)
        on_cut = self.values @ (powers @ self._second_matrix[:, index])
        return tuple(PiecewiseCubic(self.first_nodes, self._first_matrix @ function) for function in on_cut)

    def at_many(self, function: int, first: Array, second: Array) -> Array:
        """One of the functions at scattered points; `first` and `second` broadcast."""
        row, column = interval_of(self.first_nodes, first), interval_of(self.second_nodes, second)
        along, across = first - self.first_nodes[row], second - self.second_nodes[column]
        coefficients = self.coefficients[function]
        result: Array = np.zeros(np.broadcast_shapes(first.shape, second.shape))
        for power in (3, 2, 1, 0):
            strip = coefficients[power, 3][row, column]
            for other in (2, 1, 0):
                strip = strip * across + coefficients[power, other][row, column]
            result = result * along + strip
        return result

    @cached_property
    def _first_matrix(self) -> Array:
        return spline_coefficients(self.first_nodes)

    @cached_property
    def _second_matrix(self) -> Array:
        return spline_coefficients(self.second_nodes)

    @cached_property
    def coefficients(self) -> Array:
        """Bicubic coefficients, shape (k, 4, 4, n - 1, m - 1); made only when scattered points are asked for."""
        along = np.tensordot(self._first_matrix, self.values, axes=(2, 1))  # power, interval, k, m
        both = np.tensordot(along, self._second_matrix, axes=(3, 2))  # power, interval, k, power, interval
        return np.ascontiguousarray(both.transpose(2, 0, 3, 1, 4))
