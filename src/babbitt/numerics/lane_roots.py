"""Roots between two bounds in each of many lanes: the method of `babbitt.numerics.roots`, all lanes together.

Source: Chandrupatla, Advances in Engineering Software 28 (1997) 145-149, as there. Scipy has such a function from
version 1.15 on, which is newer than the oldest one that Babbitt takes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.scalar_or_array import Array

__all__ = ["find_roots"]

Index = NDArray[np.intp]


def find_roots(
    function: Callable[[Index, Array], Array],
    low: Array,
    high: Array,
    at_low: Array,
    at_high: Array,
    absolute: float = 0.0,
    relative: float = 0.0,
    most_steps: int = 200,
) -> Array:
    """Roots of functions between bounds at which they have opposite signs.

    Parameters
    ----------
    function : callable
        Numbers of lanes and a place in each -> the values there.
    low, high : ndarray, shape (n,)
    at_low, at_high : ndarray, shape (n,)
        Values there.
    absolute, relative : float
        Tolerance of the roots.
    most_steps : int

    Returns
    -------
    ndarray, shape (n,)
        NaN where the tolerance was not met, and where a function is no number on the way.
    """
    newest, opposite, oldest = high.copy(), low.copy(), low.copy()
    f_newest, f_opposite, f_oldest = at_high.copy(), at_low.copy(), at_low.copy()
    relative = max(relative, 4.0 * sys.float_info.epsilon)
    roots = np.full(low.shape, np.nan)
    active = np.arange(low.size)
    for _ in range(most_steps + 1):
        a, b, fa, fb = newest[active], opposite[active], f_newest[active], f_opposite[active]
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        f_best = np.where(np.abs(fa) < np.abs(fb), fa, fb)
        width = b - a
        near = 0.5 * (max(absolute, sys.float_info.min) + relative * np.abs(best))
        done = (f_best == 0.0) | (np.abs(width) <= 2.0 * near)
        roots[active[done]] = best[done]
        active, a, b, fa, fb, width, near = (one[~done] for one in (active, a, b, fa, fb, width, near))
        if not active.size:
            break
        share = _share(a, b, oldest[active], fa, fb, f_oldest[active], width)
        least = near / np.abs(width)
        share = np.minimum(np.maximum(share, least), 1.0 - least)
        place = a + share * width
        there = function(active, place)
        same = (there > 0.0) == (fa > 0.0)
        oldest[active], f_oldest[active] = np.where(same, a, b), np.where(same, fa, fb)
        opposite[active], f_opposite[active] = np.where(same, b, a), np.where(same, fb, fa)
        newest[active], f_newest[active] = place, there
        active = active[~np.isnan(there)]
    return roots


def _share(a: Array, b: Array, c: Array, fa: Array, fb: Array, fc: Array, width: Array) -> Array:
    """Where to look next, as a share of the bracket: inverse quadratic interpolation, or the middle."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        sound = (fc != fa) & (fc != fb) & (phi * phi < xi) & ((1.0 - phi) * (1.0 - phi) < 1.0 - xi)
        share = fa / (fb - fa) * fc / (fb - fc)
        share = share + (c - a) / width * fa / (fc - fa) * fb / (fc - fb)
    return np.where(sound, share, 0.5)
