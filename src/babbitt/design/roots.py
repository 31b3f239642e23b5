"""A root between two bounds by Brent's method of scipy, which is imported when the first root is sought."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Root", "bracketed_root", "find_root"]


@dataclass(frozen=True)
class Root:
    """Where the search ended, and whether it met its tolerance."""

    value: float
    converged: bool


def bracketed_root(
    function: Callable[[float], float], low: float, high: float, absolute: float = 0.0, relative: float = 0.0
) -> float:
    """Root of a function between two bounds at which it has opposite signs.

    Parameters
    ----------
    function : callable
    low, high : float
    absolute, relative : float
        Tolerance of the root.

    Examples
    --------
    >>> round(bracketed_root(lambda x: x * x - 2.0, 0.0, 2.0), 12)
    1.414213562373
    """
    return find_root(function, low, high, absolute, relative).value


def find_root(
    function: Callable[[float], float],
    low: float,
    high: float,
    absolute: float = 0.0,
    relative: float = 0.0,
    most_steps: int = 200,
) -> Root:
    """Root of a function between two bounds, with the verdict on its tolerance.

    Tolerances below the round-off of the root are raised to it.

    Raises
    ------
    ValueError
        When the function has the same sign at both bounds.
    """
    from scipy.optimize import brentq

    root, report = brentq(
        function,
        low,
        high,
        xtol=max(absolute, sys.float_info.min),
        rtol=max(relative, 4.0 * sys.float_info.epsilon),
        maxiter=most_steps,
        full_output=True,
        disp=False,
    )
    return Root(float(root), bool(report.converged))
