"""Brent's method for a root between two bounds.

scipy has it too, but takes longer to import than a bearing to solve.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Root", "bracketed_root", "find_root"]

EPSILON = 2.0**-52


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

    Raises
    ------
    ValueError
        When the function has the same sign at both bounds.

    Notes
    -----
    Inverse quadratic interpolation and secants, bisection where they do not help.
    Source: R. P. Brent, Algorithms for Minimization without Derivatives (1973), chapter 4.
    """
    before, best = low, high
    f_before, f_best = function(low), function(high)
    if f_before * f_best > 0.0:
        raise ValueError("the function has the same sign at both bounds")
    other, f_other = before, f_before
    step = last = best - before
    for _ in range(most_steps):
        if abs(f_other) < abs(f_best):
            before, best, other = best, other, best
            f_before, f_best, f_other = f_best, f_other, f_best
        tolerance = 2.0 * EPSILON * abs(best) + 0.5 * max(absolute, relative * abs(best))
        half = 0.5 * (other - best)
        if f_best == 0.0 or abs(half) <= tolerance:
            return Root(best, True)
        if abs(last) < tolerance or abs(f_before) <= abs(f_best):
            step = last = half
        else:
            trial = _interpolated((before, f_before), (best, f_best), (other, f_other))
            if 2.0 * abs(trial) < min(3.0 * abs(half) - tolerance, abs(last)) and trial * half > 0.0:
                last, step = step, trial
            else:
                step = last = half
        before, f_before = best, f_best
        best += step if abs(step) > tolerance else math.copysign(tolerance, half)
        f_best = function(best)
        if f_best * f_other > 0.0:
            other, f_other = before, f_before
            step = last = best - before
    return Root(best, False)


def _interpolated(before: tuple[float, float], best: tuple[float, float], other: tuple[float, float]) -> float:
    """Step from the best point to the root of a secant, or of the inverse parabola through three points."""
    ratio = best[1] / before[1]
    half = 0.5 * (other[0] - best[0])
    if before[0] == other[0]:
        top, bottom = 2.0 * half * ratio, 1.0 - ratio
    else:
        q, r = before[1] / other[1], best[1] / other[1]
        top = ratio * (2.0 * half * q * (q - r) - (best[0] - before[0]) * (r - 1.0))
        bottom = (q - 1.0) * (r - 1.0) * (ratio - 1.0)
    return top / -bottom if bottom else math.inf
