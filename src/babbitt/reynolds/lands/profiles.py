"""Sampled bores of several lands on one grid, for the kernels keep them in one table."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

__all__ = ["MOST_SAMPLES", "common_profiles"]

Array = NDArray[np.float64]

MOST_SAMPLES = 4097
"""Samples of a table. Where a grid of all samples needs more, bends are rounded within 1/4096 of a land."""


def common_profiles(profiles: Sequence[Sequence[float] | Array]) -> Array:
    """Profiles at equally spaced angles, each of its own land, with equally many samples, straight between.

    Parameters
    ----------
    profiles : sequence of sequences of float
        Any number of samples each, from edge to edge; one: the same everywhere; none: a circle.

    Returns
    -------
    ndarray, shape (lands, samples)
        Zeros for a circle; no samples where all are circles. The grid holds the samples of all, so that what a
        land is does not depend on the others (up to `MOST_SAMPLES`).

    Examples
    --------
    >>> common_profiles([(0.0, 6.0, 0.0), (0.0, 6.0), ()])
    array([[0., 6., 0.],
           [0., 3., 6.],
           [0., 0., 0.]])
    """
    if not any(map(len, profiles)):
        return np.zeros((len(profiles), 0))
    given = [np.atleast_1d(np.asarray(one, dtype=np.float64)) for one in profiles]
    intervals = [max(one.size - 1, 1) for one in given if one.size]
    size = min(math.lcm(*intervals) + 1, MOST_SAMPLES)
    table = np.zeros((len(given), size))
    places = np.linspace(0.0, 1.0, size)
    for row, samples in zip(table, given, strict=True):
        if samples.size:
            row[:] = np.interp(places, np.linspace(0.0, 1.0, samples.size), samples)
    return table
