"""What stands against the limits of a clearance at whose mean a bearing keeps all limits."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any, Protocol, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import Notice
from babbitt.core.result import Result, Verdict
from babbitt.core.solution import Calculation
from babbitt.design.missed_limit import missed_limit
from babbitt.numerics.lanes import chooser

__all__ = [
    "HasClearanceLimits",
    "for_values",
    "held_at_limits",
    "many_held_at_limits",
    "standing_against",
    "without_limits",
    "with_missed",
]

Index = NDArray[np.intp]
ByVerdict = Iterable[tuple[Index, Result, Verdict]]

WITHIN_LIMITS = (Verdict.PASS, Verdict.REMARKS)


class HasClearanceLimits(Protocol):
    """A bearing whose clearance may have limits at which no other case of it is."""

    @property
    def clearance_limits(self) -> tuple[Any, Any] | None:
        """The least and the greatest clearance over diameter at 20 °C; None where there are none to be solved."""

    def at_clearance(self, relative: Any) -> Self:
        """The same with another clearance over diameter at 20 °C, and without limits of it."""


def for_values(calculation: Calculation) -> Calculation:
    """The calculation as far as its values go: nothing else is solved against which its limits are held."""
    return without_limits(calculation.only(()))


def without_limits(calculation: Calculation) -> Calculation:
    """The calculation at its own clearance alone."""
    problem: Any = calculation.problem
    if getattr(problem, "clearance_limits", None) is None:
        return calculation
    return replace(calculation, problem=replace(problem, clearance_limits=None))


CaseT = TypeVar("CaseT", bound=HasClearanceLimits)


def held_at_limits(case: CaseT, found: Result, solve: Callable[[CaseT], Result]) -> Result:
    """A result within its limits, with a warning of the limits of the clearance that are not, or are questioned.

    Parameters
    ----------
    case : HasClearanceLimits
    found : Result
        At its own clearance.
    solve : callable
        Result of the bearing at another clearance.
    """
    if not found.within_limits:
        return found
    limits = zip(("least", "greatest"), case.clearance_limits or (), strict=False)
    return with_missed(found, (
        (Notice("W174", which, {"clearance": limit}), standing_against(solve(case.at_clearance(limit)), found))
        for which, limit in limits
    ))  # fmt: skip


def with_missed(found: Result, against: Iterable[tuple[Notice, tuple[Notice, ...]]]) -> Result:
    """A result with a warning of the limits of its clearance, each with what stands against it."""
    missed = tuple(Notice("W174", "against", {"at": at, "told": told}) for at, told in against if told)
    if not missed:
        return found
    return replace(found, warnings=(*found.warnings, Notice("W174", "missed", {"missed": missed})))


def standing_against(result: Result, mean: Result) -> tuple[Notice, ...]:
    """Clauses on what stands against a result at another clearance, and not against that at the mean."""
    if not result.outcome.solved:
        return (Notice("W174", "no_film"),)
    missed = sorted((one for one in result.limits if not one.ok), key=lambda one: one.margin)
    if missed:  # of one quantity the strictest limit
        return tuple(missed_limit(one, "W174") for one in {one.quantity: one for one in reversed(missed)}.values())
    if result.verdict is Verdict.NO_VERDICT:
        return (Notice("W174", "no_verdict", {"remarks": result.invalidating_codes or ("–",)}),)
    remarks = tuple(code for code in result.questioning_codes if code not in mean.questioning_codes)
    return (Notice("W174", "questioned", {"remarks": remarks}),) if remarks else ()


def many_held_at_limits(
    case: CaseT, count: int, solve: Callable[[CaseT, int], ByVerdict]
) -> Iterator[tuple[Index, Result, Verdict]]:
    """The same of many bearings in lanes; left out are those that `held_at_limits` would warn of.

    Parameters
    ----------
    case : HasClearanceLimits
        Its numbers that differ from bearing to bearing are `Lanes`.
    count : int
        Bearings.
    solve : callable
        Bearings at the clearance of a case by their verdict (`babbitt.design.verdict_lanes.by_verdict`).
    """
    at_limits = [tuple(solve(case.at_clearance(limit), count)) for limit in case.clearance_limits or ()]
    for index, result, verdict in solve(case, count):
        sure = np.ones(index.size, bool)
        if verdict in WITHIN_LIMITS:
            for found in at_limits:
                sure &= np.isin(index, list(_as_good(found, result)))
        if sure.any():
            lanes = np.flatnonzero(sure)
            yield index[lanes], chooser(result)(lanes), verdict


def _as_good(found: ByVerdict, than: Result) -> Iterator[int]:
    """Bearings that keep their limits and are questioned by nothing more than another result."""
    known = set(than.questioning_codes)
    for index, result, verdict in found:
        if verdict in WITHIN_LIMITS and known.issuperset(result.questioning_codes):
            yield from index.tolist()
