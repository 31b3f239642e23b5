"""What a report covers and what it does not: operating points, clearances, checks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from babbitt.core.language import translated
from babbitt.core.result import Result
from babbitt.core.result_name import ResultName
from babbitt.report.text import plain_text

__all__ = ["scope_of"]

LIMITS = ("minimum", "maximum")
"""Clearances that a tolerance ends at."""


def scope_of(results: Sequence[Result]) -> Iterator[str]:
    """Sentences on the operating points, clearances and checks of a report.

    Parameters
    ----------
    results : sequence of Result

    Yields
    ------
    str
    """
    names = [one.name if isinstance(one.name, ResultName) else ResultName(one.name) for one in results]
    points = dict.fromkeys(plain_text(name.point) for name in names if name.point)
    if points:
        yield translated(
            "Operating points: {points}. Other loads and speeds, overload and the other sense of rotation are not "
            "part of this report.",
            points=", ".join(points),
        )
    else:
        yield translated(
            "One operating point of each bearing. Other loads and speeds, overload and the other sense of "
            "rotation are not part of this report."
        )
    yield from _clearances(results, names)
    yield translated(
        "Checked is what the tables of checks list. Strength and fatigue of parts, wear, starting and stopping "
        "are not, unless they stand there."
    )


def _clearances(results: Sequence[Result], names: Sequence[ResultName]) -> Iterator[str]:
    """Whether bearings that have a clearance are computed at the limits of it."""
    of_bearing: dict[str, set[str]] = {}
    for result, name in zip(results, names, strict=True):
        if "relative_clearance" in result.values:
            of_bearing.setdefault(name.bearing, set()).add(name.clearance)
    at_limits = [bearing for bearing, found in of_bearing.items() if found >= set(LIMITS)]
    if not of_bearing:
        return
    if len(at_limits) == len(of_bearing):
        yield translated("Clearance: smallest and largest value of each bearing.")
    elif not at_limits:
        yield translated(
            "One clearance of each bearing. Its smallest and largest values are not part of this report."
        )
    else:
        yield translated(
            "Clearance: smallest and largest value of {bearings}; one value of the others.",
            bearings=", ".join(map(plain_text, at_limits)),
        )
