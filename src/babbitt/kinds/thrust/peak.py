"""The highest pressure of a film between its nodes."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from babbitt.reynolds.sector.sector import SectorFilm

__all__ = ["between_nodes", "peak_pressure"]

Array = NDArray[np.float64]

FINE = 65
"""Points across the pad on which the polynomial through the nodes is read."""


def peak_pressure(film: SectorFilm) -> float:
    """Highest gauge pressure, Pa: the polynomial across the pad, a parabola along it."""
    matrix = _across(film.radius.tobytes())
    fine = film.pressure @ matrix.T
    i, j = np.unravel_index(int(fine.argmax()), fine.shape)
    if 0 < i < fine.shape[0] - 1:
        before, here, after = (float(fine[k, j]) for k in (i - 1, i, i + 1))
        bend = before - 2.0 * here + after
        if bend < 0.0:
            return here - 0.125 * (after - before) ** 2 / bend
    return float(fine[i, j])


def between_nodes(radius: Array, values: Array) -> tuple[Array, Array]:
    """Radii and values of the polynomials through the nodes, on `FINE` even radii; values of shape (lines,
    nodes).
    """
    return np.linspace(radius[0], radius[-1], FINE), values @ _across(radius.tobytes()).T


@lru_cache(maxsize=64)
def _across(nodes: bytes) -> Array:
    """Values of the Lagrange polynomials of the nodes on an even grid, shape (FINE, nodes)."""
    radius = np.frombuffer(nodes)
    radius = (radius - radius[0]) / (radius[-1] - radius[0])
    fine = np.linspace(0.0, 1.0, FINE)
    others = radius[:, None] - radius[None, :] + np.eye(radius.size)
    weights = 1.0 / others.prod(axis=1)
    gaps = fine[:, None] - radius[None, :]
    matrix = np.empty_like(gaps)
    for row, gap in enumerate(gaps):
        at = np.flatnonzero(np.abs(gap) < 1e-14)
        if at.size:
            matrix[row] = np.eye(radius.size)[at[0]]
        else:
            terms = weights / gap
            matrix[row] = terms / terms.sum()
    return np.asarray(matrix)
