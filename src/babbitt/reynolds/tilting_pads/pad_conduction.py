"""Conduction of heat in a pad, in r and theta, as matrices from the heat flux into its bore.

Finite volumes on the lines of the film and on circles through the thickness; between two circles the flux of

    div(k grad T) = 0

is exact for a temperature that varies with ln r alone. Heat leaves at the back and at both edges. The problem is
linear and does not depend on the film: it is solved once for every pad geometry.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded

from babbitt.reynolds.tilting_pads.pad_heat import PadWalls

__all__ = ["SURROUNDINGS", "PadConduction", "pad_conduction"]

Array = NDArray[np.float64]

CIRCLES = 9
"""Through the thickness, both surfaces among them."""
SURROUNDINGS = 3
"""Temperatures around a pad: at its leading edge, its trailing edge and its back."""


@dataclass(frozen=True, eq=False)
class PadConduction:
    """Temperatures of a pad over what drives them: flux into the bore at every line (W/m2), then the temperatures
    at leading edge, trailing edge and back (K).

    Attributes
    ----------
    bore : ndarray, shape (n + 1, n + 1 + 3)
        Of the bore.
    difference : ndarray, same shape
        Bore less back, of the linear profile with the same bending moment:
        dT = (12/t^2) int (T - T_m) (t/2 - y) dy, y from the bore.
    pivot, mean : ndarray, shape (n + 1 + 3,)
        Mean through the thickness at the pivot, and of the whole pad.
    edges : ndarray, shape (2, n + 1 + 3)
        Heat given off over leading and trailing edge, W per metre of width.
    """

    bore: Array
    difference: Array
    pivot: Array
    mean: Array
    edges: Array


@lru_cache(maxsize=64)
def pad_conduction(
    radius: float, thickness: float, extent: float, fraction: float, intervals: int, walls: PadWalls
) -> PadConduction:
    """Conduction of a pad with the bore ``radius``, whose pivot stands at ``fraction`` of its ``extent``."""
    rows, n = intervals + 1, CIRCLES
    r = np.linspace(radius, radius + thickness, n)
    deep, wide = thickness / (n - 1), extent / intervals
    depth, width = np.full(n, deep), np.full(rows, wide)
    depth[[0, -1]] *= 0.5
    width[[0, -1]] *= 0.5
    outward = walls.conductivity / np.log(r[1:] / r[:-1])
    around = walls.conductivity * depth / (r * wide)
    back, edge = walls.back_coefficient * r[-1] * width, walls.edge_coefficient * depth

    diagonal, next_circle = np.zeros((rows, n)), np.zeros((rows, n))
    diagonal[:, :-1] += width[:, None] * outward
    diagonal[:, 1:] += width[:, None] * outward
    next_circle[:, :-1] = -width[:, None] * outward
    diagonal[:-1] += around
    diagonal[1:] += around
    diagonal[:, -1] += back
    diagonal[0] += edge
    diagonal[-1] += edge
    banded = np.zeros((n + 1, rows * n))  # lower form: the diagonal, the next circle, .., the next line
    banded[0], banded[1] = diagonal.ravel(), next_circle.ravel()
    banded[n, : (rows - 1) * n] = np.tile(-around, rows - 1)

    drives = np.zeros((rows, n, rows + SURROUNDINGS))
    drives[np.arange(rows), 0, np.arange(rows)] = radius * width
    drives[0, :, rows], drives[-1, :, rows + 1], drives[:, -1, rows + 2] = edge, edge, back
    solved = solveh_banded(banded, drives.reshape(rows * n, -1), lower=True).reshape(rows, n, -1)

    through = depth / thickness
    lever = 12.0 / thickness * (0.5 * thickness - (r - radius)) * through
    lever /= lever @ (0.5 - (r - radius) / thickness)  # exact for a linear profile on these circles
    columns = np.einsum("ijd,j->id", solved, through)
    edges = np.einsum("eid,i->ed", solved[[0, -1]], edge)
    edges[[0, 1], [rows, rows + 1]] -= edge.sum()
    place = fraction * intervals
    before = min(int(place), intervals - 1)
    share = place - before
    return PadConduction(
        solved[:, 0],
        np.einsum("ijd,j->id", solved, lever),
        (1.0 - share) * columns[before] + share * columns[before + 1],
        width @ columns / extent,
        edges,
    )
