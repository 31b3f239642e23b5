"""Grid lines between edges, crowded towards every edge.

The corner of a recess is re-entrant: the pressure gradient grows there as r^-1/3, and a uniform grid converges
with order 4/3 only. Cosine spacing between edges gives second order back.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.lands.axial import AxialMesh, element_axial_mesh

__all__ = ["DRAFT", "ENGINEERING", "REFERENCE", "Grid", "across", "between"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Grid:
    """How fine a film between recesses is solved.

    Attributes
    ----------
    per_turn : int
        Intervals around the bearing, or along a rectangular pad.
    degree : int
        Of the polynomials across every land; recesses have half of it.
    """

    per_turn: int = 96
    degree: int = 6

    @property
    def coarser(self) -> Grid:
        """Grid for the first steps and for the error estimate."""
        return Grid(self.per_turn // 2, max(3, self.degree // 2 + 1))


DRAFT = Grid(96, 5)
ENGINEERING = Grid(192, 6)
REFERENCE = Grid(384, 10)


def between(edges: Array, per_unit: float, fewest: int = 6) -> Array:
    """Lines on all edges and between them, with cosine spacing.

    Parameters
    ----------
    edges : ndarray
        Ascending.
    per_unit : float
        Intervals per unit of length, on average.
    fewest : int
        Intervals between two edges.

    Returns
    -------
    ndarray

    Examples
    --------
    >>> between(np.array([0.0, 1.0]), 4.0, 2).round(3).tolist()
    [0.0, 0.146, 0.5, 0.854, 1.0]
    """
    pieces = [edges[:1]]
    for left, right in pairwise(edges):
        count = max(fewest, round(per_unit * (right - left)))
        t = np.arange(1, count + 1) / count
        pieces.append(left + (right - left) * 0.5 * (1.0 - np.cos(math.pi * t)))
    lines = np.concatenate(pieces)
    lines[np.searchsorted(lines, edges - 1e-12)] = edges
    return lines


def across(edges: tuple[float, ...], degrees: tuple[int, ...]) -> AxialMesh:
    """Spectral elements across, between given edges (``film.axial``)."""
    return element_axial_mesh(edges, degrees)
