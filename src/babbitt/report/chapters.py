"""The chapters of a report: one for each bearing and operating point, its clearance cases together.

Cases that differ in nothing but the clearance share inputs and assumptions, and a reader wants their results side
by side: one of them, that which comes closest to a limit, is shown in full.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Check, Result
from babbitt.core.solution import Solution
from babbitt.report.names import split_clearance
from babbitt.report.view import View, view_of


@dataclass(frozen=True)
class Member:
    """One result of a chapter; `clearance` is ``minimum``, ``mean``, ``maximum``, or empty for the only one."""

    clearance: str
    solution: Solution

    @property
    def problem(self) -> Any:
        """What was computed."""
        return self.solution.problem

    @property
    def given(self) -> tuple[tuple[str, str], ...]:
        """Words of the case file that stand behind it."""
        return tuple(getattr(self.problem, "given", ()))

    @property
    def result(self) -> Result:
        """What an engineer reads of the solution."""
        return self.solution.result


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
    def view(self) -> View:
        """How its solutions are shown."""
        return view_of(self.members[0].result)

    @property
    def given(self) -> tuple[tuple[str, str], ...]:
        """Words of the case file that hold for every member."""
        every = [set(member.given) for member in self.members]
        return tuple(row for row in self.shown.given if all(row in given for given in every))

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


def chapters(solutions: Sequence[Solution]) -> tuple[Chapter, ...]:
    """Gather the solutions of a machine into chapters, in their order.

    Parameters
    ----------
    solutions : sequence of Solution

    Returns
    -------
    tuple of Chapter
    """
    gathered: list[list[Member]] = []
    for solution in solutions:
        member = Member(split_clearance(solution.result.name)[1], solution)
        if gathered and _belongs(member, gathered[-1][-1]):
            gathered[-1].append(member)
        else:
            gathered.append([member])
    return tuple(_chapter(members) for members in gathered)


def _belongs(member: Member, before: Member) -> bool:
    """Whether two results are those of one bearing that differ in nothing but the clearance."""
    if "" in (member.clearance, before.clearance):
        return False
    same_name = split_clearance(member.result.name)[0] == split_clearance(before.result.name)[0]
    if not same_name or type(member.problem) is not type(before.problem):
        return False
    alike = view_of(member.result).alike
    return bool(alike(member.problem) == alike(before.problem))


def _chapter(members: Sequence[Member]) -> Chapter:
    name = members[0].result.name
    if len(members) == 1:
        return Chapter(name, (replace(members[0], clearance=""),))
    return Chapter(split_clearance(name)[0], tuple(members))
