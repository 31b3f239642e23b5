"""The comparisons of a case in one line: how many, how far at most, and the verdict."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from babbitt.validation.case import Comparison, Evidence, Verdict

NO_VALIDATION = {
    Evidence.REPRODUCTION: "; a reproduction with fitted inputs, no validation",
    Evidence.REGRESSION: "; own values, regression, no validation",
}
"""What the sentence adds where agreement does not count as validation."""


@dataclass(frozen=True)
class Summary:
    """What a set of comparisons comes to.

    Attributes
    ----------
    values, judged, suspect, shown, differing : int
        Numbers of rows: all, judged, set aside as doubtful prints, shown as information, judged but disagreeing.
    worst : Comparison or None
        The judged row that uses most of its tolerance.
    evidence : Evidence
        Whether agreement counts as validation.
    """

    values: int
    judged: int
    suspect: int
    shown: int
    differing: int
    worst: Comparison | None
    evidence: Evidence = Evidence.VALIDATION

    @property
    def agrees(self) -> bool:
        """Whether something was judged and every judged row agrees."""
        return self.judged > 0 and self.differing == 0

    @property
    def largest_share(self) -> float:
        """Largest deviation in units of its tolerance."""
        return _severity(self.worst) if self.worst else math.nan

    @property
    def sentence(self) -> str:
        """The summary in words."""
        set_aside = [f"{self.suspect} set aside"] if self.suspect else []
        if self.shown:
            set_aside.append(f"{self.shown} shown without judgement")
        counted = f"{self.values} values, {self.judged} judged"
        if set_aside:
            counted += f" ({', '.join(set_aside)})"
        if self.worst is None:
            return f"{counted}."
        largest = f"largest deviation {self.largest_share:.2f} of its tolerance ({self.worst.label})"
        verdict = "all agree" if self.agrees else f"{self.differing} differ"
        return f"{counted}; {largest}; {verdict}{NO_VALIDATION.get(self.evidence, '')}."


def summary(rows: Iterable[Comparison], evidence: Evidence = Evidence.VALIDATION) -> Summary:
    """Count and judge the rows of a case.

    Parameters
    ----------
    rows : iterable of Comparison
    evidence : Evidence, optional
        Of the case.

    Returns
    -------
    Summary
    """
    rows = tuple(rows)
    judged = [row for row in rows if row.judged]
    verdicts = [row.verdict for row in rows]
    return Summary(
        values=len(rows),
        judged=len(judged),
        suspect=verdicts.count(Verdict.SUSPECT),
        shown=verdicts.count(Verdict.SHOWN),
        differing=verdicts.count(Verdict.DIFFERS),
        worst=max(judged, key=_severity, default=None),
        evidence=evidence,
    )


def by_quantity(rows: Iterable[Comparison]) -> dict[str, Summary]:
    """The summary of every quantity, in the order of first appearance."""
    groups: dict[str, list[Comparison]] = {}
    for row in rows:
        groups.setdefault(row.quantity, []).append(row)
    return {quantity: summary(members) for quantity, members in groups.items()}


def _severity(row: Comparison) -> float:
    """Share of the tolerance used; a value that is not a number is worse than any other."""
    return math.inf if math.isnan(row.share) else row.share
