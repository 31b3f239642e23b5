"""Cubic splines as linear maps of their node values.

A spline is linear in the values at its nodes. Stored as the matrix from values to coefficients it can be
applied along either axis of a table, and the tables need no library of splines at run time.
"""

from __future__ import annotations

import numpy as np

from babbitt.numerics.scalar_or_array import Array


def spline_coefficients(nodes: Array) -> Array:
    """Matrix from node values to the coefficients of the cubic spline with not-a-knot ends.

    In interval i the spline is sum_k c[k, i] (t - nodes[i])^k with c = matrix @ values: twice continuously
    differentiable, and thrice at the second and the last but one node (de Boor, A Practical Guide to Splines,
    ch. IV).

    Parameters
    ----------
    nodes : ndarray, shape (n,)
        Strictly increasing, n >= 4.

    Returns
    -------
    ndarray, shape (4, n - 1, n)
        Powers 0 ... 3, intervals, node values.

    Examples
    --------
    A cubic polynomial is its own spline:

    >>> nodes = np.array([0.0, 1.0, 2.5, 3.0, 4.0])
    >>> (spline_coefficients(nodes) @ nodes**3)[:, 0].round(12) + 0.0
    array([0., 0., 0., 1.])
    """
    count = len(nodes)
    steps = np.diff(nodes)
    if count < 4 or not (steps > 0.0).all():
        raise ValueError("a spline needs at least 4 strictly increasing nodes")
    values = np.eye(count)
    slopes = np.diff(values, axis=0) / steps[:, None]
    # moments = second derivatives at the nodes
    system = np.zeros((count, count))
    right = np.zeros((count, count))
    inner = np.arange(1, count - 1)
    system[inner, inner - 1] = steps[:-1]
    system[inner, inner] = 2.0 * (steps[:-1] + steps[1:])
    system[inner, inner + 1] = steps[1:]
    right[inner] = 6.0 * np.diff(slopes, axis=0)
    system[0, :3] = steps[1], -(steps[0] + steps[1]), steps[0]
    system[-1, -3:] = steps[-1], -(steps[-2] + steps[-1]), steps[-2]
    moments = np.linalg.solve(system, right)
    return np.stack(
        [
            values[:-1],
            slopes - steps[:, None] * (2.0 * moments[:-1] + moments[1:]) / 6.0,
            0.5 * moments[:-1],
            np.diff(moments, axis=0) / (6.0 * steps[:, None]),
        ]
    )
