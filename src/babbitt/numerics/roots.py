"""A root between two bounds, by inverse quadratic interpolation or bisection.

Source: Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function
without using derivatives, Advances in Engineering Software 28 (1997) 145-149. It stands here because to import the
one of scipy takes longer than most of the calculations that seek a root.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Root", "bracketed_root", "find_root"]

MOST_HALVINGS = 2200
"""As many halvings lead from the widest bracket of floating-point numbers to the narrowest."""


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

    Raises
    ------
    ValueError
        When the function is no number at a bound, has the same sign at both, or when no root was found between
        them.

    Examples
    --------
    >>> round(bracketed_root(lambda x: x * x - 2.0, 0.0, 2.0), 12)
    1.414213562373
    """
    root = find_root(function, low, high, absolute, relative)
    if not root.converged:
        raise ValueError(f"the search between {low} and {high} ended without a root at {root.value}")
    return root.value


def find_root(
    function: Callable[[float], float],
    low: float,
    high: float,
    absolute: float = 0.0,
    relative: float = 0.0,
    most_steps: int = MOST_HALVINGS,
    beyond: tuple[float, float] | None = None,
) -> Root:
    """Root of a function between two bounds, with the verdict on its tolerance.

    Tolerances below the round-off of the root are raised to it. A place beyond a bound and the value there, of the
    sign at that bound, spare the first step, which otherwise halves.

    Raises
    ------
    ValueError
        When the function is no number at a bound, or has the same sign at both.

    Notes
    -----
    Where the function is no number between the bounds, the search ends there and has not converged.
    """
    lower, upper = function(low), function(high)
    if math.isnan(lower) or math.isnan(upper):
        raise ValueError(f"the function is {lower} at {low} and {upper} at {high}; it must be a number there")
    if (lower > 0.0) == (upper > 0.0) and lower != 0.0 != upper:
        raise ValueError(f"the function is {lower} at {low} and {upper} at {high}; it needs different signs there")
    newest, opposite, oldest = high, low, low
    at_newest, at_opposite, at_oldest = upper, lower, lower
    if beyond is not None:
        oldest, at_oldest = beyond
        if oldest < low:
            newest, opposite, at_newest, at_opposite = low, high, lower, upper
    relative = max(relative, 4.0 * sys.float_info.epsilon)
    for _ in range(most_steps + 1):
        best, at_best = (newest, at_newest) if abs(at_newest) < abs(at_opposite) else (opposite, at_opposite)
        width = opposite - newest
        near = 0.5 * (max(absolute, sys.float_info.min) + relative * abs(best))
        if at_best == 0.0 or abs(width) <= 2.0 * near:
            return Root(best, True)
        share = 0.5
        if at_oldest not in (at_newest, at_opposite):
            xi = (newest - opposite) / (oldest - opposite)
            phi = (at_newest - at_opposite) / (at_oldest - at_opposite)
            if phi * phi < xi and (1.0 - phi) * (1.0 - phi) < 1.0 - xi:
                share = at_newest / (at_opposite - at_newest) * at_oldest / (at_opposite - at_oldest)
                share += (
                    (oldest - newest) / width * at_newest / (at_oldest - at_newest)
                    * at_opposite / (at_oldest - at_opposite)
                )  # fmt: skip
        share = min(max(share, near / abs(width)), 1.0 - near / abs(width))
        place = newest + share * width
        there = function(place)
        if math.isnan(there):
            return Root(place, False)
        if (there > 0.0) == (at_newest > 0.0):
            oldest, at_oldest = newest, at_newest
        else:
            oldest, at_oldest, opposite, at_opposite = opposite, at_opposite, newest, at_newest
        newest, at_newest = place, there
    return Root(best, False)
