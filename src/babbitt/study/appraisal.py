"""How a bearing does against its limits: verdict, governing check and margin of every row of every study."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from babbitt.core.check_text import comparison
from babbitt.core.notices import Effect, InputError
from babbitt.core.result import Check, Result, Verdict

__all__ = ["ALL_LIMITS", "RECOMMENDED", "Appraisal", "appraised", "counted", "require_known"]

ALL_LIMITS, RECOMMENDED = "all", "recommended"
"""All limits; all limits and recommendations."""


@dataclass(frozen=True)
class Appraisal:
    """How one bearing does.

    Attributes
    ----------
    verdict : Verdict
        By the limits that count.
    checks : tuple of Check
        Those that count; none where there is no operating point.
    code, reason : str
        What keeps the bearing from passing, or where it passes with remarks the codes of these.
    questioned : tuple of str
        Codes of the warnings that question a result that misses no limit, or leave it without a verdict.
    """

    verdict: Verdict
    checks: tuple[Check, ...]
    code: str = ""
    reason: str = ""
    questioned: tuple[str, ...] = ()

    @property
    def codes(self) -> tuple[str, ...]:
        """Codes on which the verdict rests: how a search ended, limits that are missed, else what questions."""
        ended = (self.code,) if self.verdict is Verdict.NO_SOLUTION and self.code else ()
        return ended or self.failed or self.questioned

    @property
    def governing(self) -> Check | None:
        """The check with the least margin; None where nothing was held against a limit."""
        return min(
            self.checks, key=lambda one: one.margin if math.isfinite(one.margin) else -math.inf, default=None
        )

    @property
    def failed(self) -> tuple[str, ...]:
        """Codes of the checks that are missed, each once."""
        return tuple(dict.fromkeys(check.code for check in self.checks if not check.ok))


def appraised(result: Result, limits: Sequence[str] = (ALL_LIMITS,)) -> Appraisal:
    """Hold a result against limits.

    Parameters
    ----------
    result : Result
    limits : sequence of str
        "all": every check but recommendations, and a verdict; "recommended": recommendations too; else codes of
        checks, of which nothing but these counts.
    """
    if not result.outcome.solved:
        reason = result.message or result.outcome.value
        return Appraisal(Verdict.NO_SOLUTION, (), result.outcome.code, reason)
    checks = counted(result, limits)
    found = Appraisal(Verdict.FAIL, checks)
    if found.failed:
        assert found.governing is not None, "a check that is missed has a margin"
        return Appraisal(Verdict.FAIL, checks, found.governing.code, comparison(found.governing))
    if (undecided := _undecided(result, limits)) is not None:
        return Appraisal(Verdict.NO_VERDICT, checks, *undecided, questioned=result.questioning_codes)
    codes = result.questioning_codes
    verdict = Verdict.REMARKS if codes else Verdict.PASS
    return Appraisal(verdict, checks, reason=" ".join(codes), questioned=codes)


def counted(result: Result, limits: Sequence[str]) -> tuple[Check, ...]:
    """The checks that count."""
    if ALL_LIMITS in limits:
        return result.limits
    if RECOMMENDED in limits:
        return result.checks
    return tuple(check for check in result.checks if check.code in limits)


def _undecided(result: Result, limits: Sequence[str]) -> tuple[str, str] | None:
    """Code and reason why limits that are kept permit nothing: outside a model's validity, or a check not made."""
    if ALL_LIMITS not in limits and RECOMMENDED not in limits:
        lacking = next((one for one in result.not_checked if one.code in limits), None)
        return None if lacking is None else (lacking.code, f"not checked: {lacking.message}")
    if result.verdict is not Verdict.NO_VERDICT:
        return None
    for warning in result.warnings:
        if warning.effect is Effect.NO_VERDICT:
            return warning.code, warning.message
    return "", f"not checked: {', '.join(subject.value for subject in result.lacking) or 'any limit'}"


def require_known(limits: Sequence[str], results: Sequence[Result]) -> None:
    """Refuse the code of a check that no bearing has.

    Raises
    ------
    InputError
        E005 with those that there are.
    """
    known = {check.code for result in results for check in result.checks}
    known |= {notice.code for result in results for notice in result.not_checked}
    unknown = [code for code in limits if code not in (ALL_LIMITS, RECOMMENDED, *known)]
    if unknown and all(result.outcome.solved for result in results):
        there = ", ".join(sorted(known))
        also = f"or {ALL_LIMITS}, {RECOMMENDED}"
        raise InputError("E005", f"study.limits: no check '{unknown[0]}'; this case has: {there}; {also}")
