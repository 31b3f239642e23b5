"""The chapters of a report: one for each bearing and operating point, its clearance cases together.

Cases that differ in nothing but the clearance share inputs and assumptions, and a reader wants their results side
by side: one of them, that which comes closest to a limit, is shown in full.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Check, Result
from babbitt.kinds.footstep.model_case import HeelCase
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.design import ThrustDesign
from babbitt.report.names import split_clearance

if TYPE_CHECKING:
    from babbitt.case.designs import EveryDesign


@dataclass(frozen=True)
class Member:
    """One result of a chapter; `clearance` is ``minimum``, ``mean``, ``maximum``, or empty for the only one."""

    clearance: str
    case: EveryDesign | None
    result: Result


@dataclass(frozen=True)
class Chapter:
    """A bearing at one operating point, in one clearance or in several."""

    name: str
    members: tuple[Member, ...]

    @property
    def shown(self) -> Member:
        """The member shown in full: the solved one that misses most limits.

        Of several that miss as many the one that comes closest to a limit, or is farthest beyond; the mean if none
        is checked.
        """
        solved = [member for member in self.members if member.result.outcome.solved] or list(self.members)
        return min(
            solved,
            key=lambda member: (-_misses(member.result), _least_margin(member.result), member.clearance != "mean"),
        )

    @property
    def shown_case(self) -> EveryDesign | None:
        """The case shown in full, with those words of the case file that hold for every member."""
        case = self.shown.case
        if case is None or isinstance(case, ThrustDesign | LineDesign):
            return case
        others = [set(member.case.given) for member in self.members if member.case is not None]
        return replace(case, given=tuple(row for row in case.given if all(row in given for given in others)))

    @property
    def results(self) -> tuple[Result, ...]:
        """The results of all members."""
        return tuple(member.result for member in self.members)


def _least_margin(result: Result) -> float:
    return min((_margin(check, result) for check in result.limits), default=math.inf)


def _misses(result: Result) -> int:
    return sum(not check.ok for check in result.limits)


def _margin(check: Check, result: Result) -> float:
    """Distance to a limit relative to it; of a temperature, to the rise above the oil supplied that it allows."""
    cold = result.values.get("supply_temperature", math.nan)
    if not QUANTITIES[check.quantity].display.offset or not check.limit > cold:
        return check.margin
    return (check.limit - check.value) / (check.limit - cold)


def chapters(cases: Sequence[EveryDesign], results: Sequence[Result]) -> tuple[Chapter, ...]:
    """Gather the results of a machine into chapters, in their order.

    Parameters
    ----------
    cases : sequence of DesignCase or FilmCase
        What the results were computed from; empty for kinds without a film.
    results : sequence of Result

    Returns
    -------
    tuple of Chapter
    """
    gathered: list[list[Member]] = []
    for member in _members(cases, results):
        if gathered and _belongs(member, gathered[-1][-1]):
            gathered[-1].append(member)
        else:
            gathered.append([member])
    return tuple(_chapter(members) for members in gathered)


def _members(cases: Sequence[EveryDesign], results: Sequence[Result]) -> Iterator[Member]:
    known: Sequence[EveryDesign | None] = cases or [None] * len(results)
    for case, result in zip(known, results, strict=True):
        yield Member(split_clearance(result.name)[1], case, result)


def _belongs(member: Member, before: Member) -> bool:
    """Whether two results are those of one bearing that differ in nothing but the clearance."""
    if member.case is None or before.case is None or "" in (member.clearance, before.clearance):
        return False
    same_name = split_clearance(member.result.name)[0] == split_clearance(before.result.name)[0]
    return same_name and _without_clearance(member.case) == _without_clearance(before.case)


def _without_clearance(case: EveryDesign) -> EveryDesign:
    match case:
        case HydrostaticCase() | JackingCase() | ThrustDesign() | LineDesign():
            return case
        case HeelCase():
            return replace(case, footstep=case.smooth, other=None)
        case FilmCase():  # the branches are equal, their types are not
            return replace(case, name="", given=(), bearing=replace(case.bearing, relative_clearance=1.0))
        case LongFilmCase():
            return replace(case, name="", given=(), bearing=replace(case.bearing, relative_clearance=1.0))
        case SegmentCase():
            return replace(case, name="", given=(), bearing=replace(case.bearing, relative_clearance=1.0))
        case _:
            return replace(case, name="", given=(), bearing=replace(case.bearing, relative_clearance=1.0))


def _chapter(members: Sequence[Member]) -> Chapter:
    name = members[0].result.name
    if len(members) == 1:
        return Chapter(name, (replace(members[0], clearance=""),))
    return Chapter(split_clearance(name)[0], tuple(members))
