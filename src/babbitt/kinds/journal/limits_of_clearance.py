"""What stands against the limits of a clearance whose mean alone is solved and passes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Protocol, Self, TypeVar

from babbitt.core.notices import Notice
from babbitt.core.result import Result, Verdict
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad

__all__ = ["BearingWithClearance", "at_limits", "warnings_about_limits"]


class BearingWithClearance(Protocol):
    """A bearing that may be solved at another clearance."""

    @property
    def mean_alone(self) -> bool:
        """Whether its clearance has limits, and no other case of the bearing is at them."""

    @property
    def bearing(self) -> Any:
        """With `clearance_tolerance`."""

    @property
    def duty(self) -> Any:
        """What it carries."""

    def at_clearance(self, relative: float) -> Self:
        """The same with another clearance over diameter at 20 °C, alone."""


CaseT = TypeVar("CaseT", bound=BearingWithClearance)


def warnings_about_limits(case: CaseT, found: Result, solve: Callable[[CaseT], Result]) -> Iterator[Notice]:
    """What stands against the limits of a clearance at whose mean a bearing passes.

    Parameters
    ----------
    case : BearingWithClearance
    found : Result
        At its clearance.
    solve : callable
        Result of the bearing at another clearance.
    """
    if case.mean_alone and found.verdict is Verdict.PASS:
        yield from _about_missed_limits((limit, solve(other)) for limit, other in at_limits(case))


def at_limits(case: CaseT) -> Iterator[tuple[Any, CaseT]]:
    """The least and the greatest relative clearance at 20 °C, and the bearing with each.

    Nothing at a prescribed place of the journal, which no other clearance need have.
    """
    tolerance = case.bearing.clearance_tolerance
    if tolerance is not None and isinstance(case.duty, PrescribedLoad | PrescribedEccentricity):
        yield from ((limit, case.at_clearance(limit)) for limit in tolerance)


def _about_missed_limits(found: Iterable[tuple[float, Result]]) -> Iterator[Notice]:
    """Warn of clearances at which a bearing misses limits that it keeps at the mean, or is questioned.

    Parameters
    ----------
    found : iterable of (float, Result)
        Relative clearances, and what the bearing comes to there.
    """
    missed = tuple(notice for clearance, result in found for notice in _missed(clearance, result))
    if missed:
        yield Notice("W174", "missed", {"missed": missed})


def _missed(clearance: float, result: Result) -> Iterator[Notice]:
    if not result.outcome.solved:
        yield Notice("W174", "no_film", {"clearance": clearance})
        return
    codes = tuple(dict.fromkeys(one.code for one in result.limits if not one.ok))
    if codes:
        yield Notice("W174", "misses", {"clearance": clearance, "checks": codes})
    elif result.verdict is Verdict.NO_VERDICT:
        yield Notice("W174", "no_verdict", {"clearance": clearance})
    elif result.verdict is Verdict.REMARKS:
        yield Notice("W174", "questioned", {"clearance": clearance, "remarks": result.questioning_codes})
