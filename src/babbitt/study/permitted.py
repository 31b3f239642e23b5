"""Permitted values of one number: all intervals in which a bearing keeps its limits, and what ends each.

Limits may fail at both ends of a range, so that a bisection between a value that passes and one that fails can
miss a permitted set or take one end of it for the whole. Here the range is scanned, and every end is
bracketed between the last value that passes and the first that does not.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

from babbitt.numerics.roots import find_root

__all__ = ["TOLERANCE", "Interval", "Trial", "find_permitted"]

TOLERANCE = 1e-4
"""Width of the bracket of an end over the end."""

MARGIN_DIGITS = 6
"""Of margins that are taken for equal."""

LEAST = 1e-12
"""Size that a margin has at least in the search: a limit that is met exactly is kept."""

WITHOUT_MARGIN = -1.0
"""Margin in the search where a value fails by no limit: the bracket is halved there."""


@dataclass(frozen=True)
class Trial:
    """How a bearing does at one value.

    Attributes
    ----------
    value : float
        Of the field; of a choice its place.
    permitted : bool
        Whether all limits asked for are kept.
    margin : float
        The least margin of these limits; NaN where there is no operating point.
    code : str
        Of the check with that margin, or of what fails otherwise: how the solution ended, the warning that leaves
        no verdict.
    bearing : str
        Which bearing, operating point and clearance that is.
    reason : str
        Why the value fails, with the code.
    remarks : tuple of str
        Codes of the warnings that question the result.
    kelvin : float
        The margin in K where it is that of a temperature; else NaN.
    """

    value: float
    permitted: bool
    margin: float
    code: str = ""
    bearing: str = ""
    reason: str = ""
    remarks: tuple[str, ...] = ()
    kelvin: float = math.nan

    @property
    def signed(self) -> float:
        """The margin as a function whose sign says whether the value is permitted."""
        if self.permitted:
            return max(self.margin, LEAST) if math.isfinite(self.margin) else -WITHOUT_MARGIN
        return min(self.margin, -LEAST) if math.isfinite(self.margin) else WITHOUT_MARGIN


@dataclass(frozen=True)
class Interval:
    """Values that are permitted, as far as the scan sees.

    Attributes
    ----------
    lower, upper : Trial
        The ends, both permitted.
    below, above : Trial or None
        The nearest values outside, which are not; None where the scan ends.
    best : Trial
        The value of the scan with the largest margin.
    """

    lower: Trial
    upper: Trial
    below: Trial | None
    above: Trial | None
    best: Trial


def find_permitted(scan: Sequence[Trial], tried: Callable[[float], Trial]) -> tuple[Interval, ...]:
    """Narrow every end of the permitted intervals of a scan down.

    Parameters
    ----------
    scan : sequence of Trial
        With ascending values.
    tried : callable
        How a bearing does at a value.

    Returns
    -------
    tuple of Interval
        Ascending. One that is narrower than a step of the scan may be missed, be it of permitted values or of
        others between them.

    Raises
    ------
    ValueError
        For values that do not ascend.

    Examples
    --------
    >>> def within(value):
    ...     margin = 1.0 - (value - 3.0) ** 2
    ...     return Trial(value, margin >= 0.0, margin)
    >>> (found,) = find_permitted([within(value) for value in (0.5, 1.5, 2.5, 3.5, 4.5)], within)
    >>> round(found.lower.value, 2), round(found.upper.value, 2), found.best.value
    (2.0, 4.0, 2.5)
    """
    if any(second.value <= first.value for first, second in pairwise(scan)):
        raise ValueError("the values of a scan ascend")
    intervals = []
    for first, last in _runs(scan):
        lower, below = (scan[first], None) if first == 0 else _end(tried, scan[first], scan[first - 1])
        last_of_scan = last == len(scan) - 1
        upper, above = (scan[last], None) if last_of_scan else _end(tried, scan[last], scan[last + 1])
        # Of margins that are equal but for round-off, that of a value without remarks.
        every = (lower, *scan[first : last + 1], upper)
        best = max(every, key=lambda one: (round(one.margin, MARGIN_DIGITS), not one.remarks))
        intervals.append(Interval(lower, upper, below, above, best))
    return tuple(intervals)


def _runs(scan: Sequence[Trial]) -> list[tuple[int, int]]:
    """First and last place of every run of permitted values."""
    runs = [[place for place, _ in run] for permitted, run in groupby(enumerate(scan), _permitted) if permitted]
    return [(run[0], run[-1]) for run in runs]


def _permitted(numbered: tuple[int, Trial]) -> bool:
    return numbered[1].permitted


def _end(tried: Callable[[float], Trial], inside: Trial, outside: Trial) -> tuple[Trial, Trial]:
    """The last permitted value between one that is and one that is not, and the first beyond it that is not."""
    way = math.copysign(1.0, outside.value - inside.value)
    while abs(outside.value - inside.value) > TOLERANCE * max(abs(inside.value), abs(outside.value)):
        met = [inside, outside]

        def margin(value: float, met: list[Trial] = met) -> float:
            met.append(tried(value))
            return met[-1].signed

        low, high = sorted((inside.value, outside.value))
        find_root(margin, low, high, relative=TOLERANCE)
        # Of several changes between the two the search finds one; the first is sought.
        outside = min((one for one in met if not one.permitted), key=lambda one: way * one.value)
        within = [one for one in met if one.permitted and way * one.value < way * outside.value]
        inside = max(within, key=lambda one: way * one.value)
    return inside, outside
