"""Joint samples in the unit cube: the same for the same seed, whoever computes them."""

from __future__ import annotations

import warnings
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from babbitt.study.inputs import Input

__all__ = ["BATCHES", "batch_sizes", "sampled"]

BATCHES = 10
"""Independent hypercubes or scramblings of which a sample consists, for the spread of what it gives."""

FEWEST_IN_BATCH = 10
"""Samples; smaller ones are drawn as one batch."""


def batch_sizes(samples: int, sampling: str) -> list[int]:
    """Samples in each independent part of a sample.

    >>> batch_sizes(103, "latin_hypercube"), batch_sizes(50, "sobol"), batch_sizes(1000, "random")
    ([11, 11, 11, 10, 10, 10, 10, 10, 10, 10], [50], [1000])
    """
    if sampling == "random" or samples < BATCHES * FEWEST_IN_BATCH:
        return [samples]
    least, more = divmod(samples, BATCHES)
    return [least + (place < more) for place in range(BATCHES)]


def sampled(inputs: Sequence[Input], samples: int, sampling: str, seed: int) -> dict[str, NDArray[np.generic]]:
    """A joint sample of some inputs, which are independent of each other but for those of one table.

    Parameters
    ----------
    inputs : sequence of Input
    samples : int
    sampling : {"latin_hypercube", "sobol", "random"}
    seed : int

    Returns
    -------
    dict
        By the path of each input its values, shape (samples,).
    """
    own = [one for one in inputs if not one.table]
    tables = list(dict.fromkeys(one.table for one in inputs if one.table))
    axes = {one.path: place for place, one in enumerate(own)}
    axes |= {one.path: len(own) + tables.index(one.table) for one in inputs if one.table}
    cube = _cube(len(own) + len(tables), samples, sampling, seed)
    return {one.path: one.drawn(cube[:, axes[one.path]]) for one in inputs}


def _cube(dimensions: int, samples: int, sampling: str, seed: int) -> NDArray[np.float64]:
    """Points of the unit cube, shape (samples, dimensions): one independent batch after the other."""
    seeds = np.random.SeedSequence(seed).spawn(BATCHES)
    parts = [
        _batch(dimensions, size, sampling, np.random.default_rng(own))
        for size, own in zip(batch_sizes(samples, sampling), seeds, strict=False)
    ]
    return np.concatenate(parts)


def _batch(dimensions: int, size: int, sampling: str, random: np.random.Generator) -> NDArray[np.float64]:
    if sampling == "random":
        return random.random((size, dimensions))
    with warnings.catch_warnings():
        # Of another length than a power of two it is a little less even; the batches tell the spread.
        warnings.filterwarnings("ignore", "The balance properties", UserWarning)
        engine = qmc.Sobol if sampling == "sobol" else qmc.LatinHypercube
        points: NDArray[np.float64] = engine(dimensions, seed=random).random(size)
    return points
