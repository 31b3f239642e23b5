"""The permitted values of one field of a case: largest load, window of the clearance, least speed or width."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from babbitt.case.kinds import KINDS
from babbitt.case.variation import CaseVariation
from babbitt.core.notices import Effect, InputError
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Check, Result
from babbitt.core.units import SiNumber
from babbitt.solving import solve
from babbitt.study.permitted import Appraisal, Interval, find_permitted

__all__ = [
    "ALL_LIMITS",
    "RECOMMENDED",
    "Scan",
    "Size",
    "appraisal_of",
    "at_all_clearances",
    "find_size",
    "scan_values",
]

ALL_LIMITS, RECOMMENDED = "all", "recommended"
"""All limits; all limits and recommendations."""

MOST_POINTS = 2000
"""Values of one scan."""

LOGARITHMIC_FROM = 20.0
"""Ratio of last and first value from which the values of a scan have equal ratios, else equal distances."""

DECADE = 10.0
"""Factor below and above the value of the case that a scan covers where no range is given."""


@dataclass(frozen=True)
class Size:
    """The permitted values of a field.

    Attributes
    ----------
    name, path : str
        Of the case; the field.
    unit : str
        Of all values.
    present : float or None
        What the case itself has in the field.
    limits : tuple of str
        ``("all",)``, ``("recommended",)`` or the codes asked for.
    over_tolerance : bool
        Whether the limits hold at the smallest, mean and largest clearance of the tolerances.
    intervals : tuple of Interval
        Ascending; empty where no value of the scan is permitted.
    scan : tuple of Appraisal
    """

    name: str
    path: str
    unit: str
    present: float | None
    limits: tuple[str, ...]
    over_tolerance: bool
    intervals: tuple[Interval, ...]
    scan: tuple[Appraisal, ...]

    @property
    def nearest_miss(self) -> Appraisal | None:
        """Of the values that are not permitted the one with the largest margin; None where none has a margin."""
        missed = [one for one in self.scan if not one.permitted and math.isfinite(one.margin)]
        return max(missed, key=lambda one: one.margin, default=None)


@dataclass(frozen=True)
class Scan:
    """Values at which a field is tried.

    Attributes
    ----------
    values : tuple of float
        Ascending (`scan_values`).
    unit : str
        Of all of them.
    present : float or None
        What the case has in the field.
    given : callable
        Makes what stands in the case of a value.
    """

    values: tuple[float, ...]
    unit: str
    present: float | None
    given: Callable[[float], str | SiNumber]


def find_size(
    variation: CaseVariation,
    scan: Scan,
    limits: Sequence[str] = (ALL_LIMITS,),
    over_tolerance: bool = False,
    progress: ProgressCallback = no_progress,
) -> Size:
    """Find all intervals of a field in which every bearing of a case keeps its limits.

    Parameters
    ----------
    variation : CaseVariation
        The case and the field.
    scan : Scan
    limits : sequence of str
        "all": every check but recommendations, and a verdict; "recommended": recommendations too; else codes of
        checks, of which nothing but these counts.
    over_tolerance : bool
        At the smallest, mean and largest clearance.
    progress : callable
        Hands on the places of the values one by one.

    Raises
    ------
    InputError
        Where the case refuses every value, what the first is refused for; E005 for a code that no check has; E004
        for a kind whose clearance has no tolerances.
    """
    if over_tolerance:
        at_all_clearances(variation)
    refused: dict[float, InputError] = {}

    def appraise(value: float) -> Appraisal:
        try:
            results = solve(variation.case(scan.given(value))).results
        except InputError as error:
            refused[value] = error
            return Appraisal(value, False, math.nan, error.code, reason=str(error))
        return appraisal_of(value, results, limits)

    intervals, appraisals = find_permitted(appraise, scan.values, progress)
    if len(refused) == len(appraisals):
        raise refused[appraisals[0].value]
    name = variation.given.get("name", "")
    return Size(
        name, variation.path, scan.unit, scan.present, tuple(limits), over_tolerance, intervals, appraisals
    )


def scan_values(first: float, last: float, points: int) -> tuple[float, ...]:
    """Values of a scan: with equal ratios over a wide range of positive numbers, else with equal distances.

    Raises
    ------
    InputError
        E003 where they do not ascend, and for fewer than 2 or more than `MOST_POINTS` of them.

    Examples
    --------
    >>> scan_values(1.0, 3.0, 3), scan_values(1.0, 100.0, 3)
    ((1.0, 2.0, 3.0), (1.0, 10.0, 100.0))
    """
    if not 2 <= points <= MOST_POINTS:
        raise InputError("E003", f"a scan has 2 to {MOST_POINTS} points, not {points}")
    if not first < last:
        raise InputError("E003", f"the range begins at {first:g} and ends at {last:g}; give a larger end")
    steps = [place / (points - 1) for place in range(1, points - 1)]
    if first > 0.0 and last >= LOGARITHMIC_FROM * first:
        return (first, *(first * (last / first) ** step for step in steps), last)
    return (first, *(first + (last - first) * step for step in steps), last)


def appraisal_of(value: float, results: Sequence[Result], limits: Sequence[str]) -> Appraisal:
    """How the bearings of a case do at a value: the one that does worst decides.

    Raises
    ------
    InputError
        E005 for a code that no check of any bearing has.
    """
    made = {check.code for result in results for check in result.checks}
    made |= {notice.code for result in results for notice in result.not_checked}
    unknown = [code for code in limits if code not in (ALL_LIMITS, RECOMMENDED, *made)]
    if unknown and all(result.outcome.solved for result in results):
        there = ", ".join(sorted(made))
        raise InputError(
            "E005", f"no check '{unknown[0]}'; this case has: {there}; or {ALL_LIMITS}, {RECOMMENDED}"
        )
    remarks = tuple(dict.fromkeys(code for result in results for code in result.questioning_codes))
    found = [_of_one(value, result, limits, remarks) for result in results]
    return min(found, key=_standing)


def _standing(one: Appraisal) -> tuple[bool, float]:
    """What sorts the worst bearing first: one that fails without a margin, then the least margin."""
    return one.permitted, one.margin if math.isfinite(one.margin) else math.inf if one.permitted else -math.inf


def _of_one(value: float, result: Result, limits: Sequence[str], remarks: tuple[str, ...]) -> Appraisal:
    """How one bearing does."""
    if not result.outcome.solved:
        return Appraisal(value, False, math.nan, result.outcome.code, result.name, reason=result.outcome.value)
    checks = _chosen(result, limits)
    worst = min(checks, key=lambda one: one.margin if math.isfinite(one.margin) else -math.inf, default=None)
    missed = worst is not None and not all(check.ok for check in checks)
    if not missed and (code_and_reason := _undecided(result, limits)) is not None:
        return Appraisal(value, False, math.nan, code_and_reason[0], result.name, reason=code_and_reason[1])
    if worst is None:
        return Appraisal(value, True, math.nan, bearing=result.name, remarks=remarks)
    return Appraisal(value, not missed, worst.margin, worst.code, result.name, worst, remarks=remarks)


def _chosen(result: Result, limits: Sequence[str]) -> tuple[Check, ...]:
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
    if result.within_limits:
        return None
    for warning in result.warnings:
        if warning.effect is Effect.NO_VERDICT:
            return warning.code, warning.message
    return "", f"not checked: {', '.join(subject.value for subject in result.lacking) or 'any limit'}"


def at_all_clearances(variation: CaseVariation) -> None:
    """Have the case solved at the smallest, mean and largest clearance."""
    given = variation.given
    if "clearance_cases" not in KINDS[given["kind"]].model_fields:
        raise InputError("E004", f"{variation.file}: a clearance of kind {given['kind']!r} has no tolerances")
    bearings: Sequence[Mapping[str, object]] = given.get("bearings", ())
    if bearings:
        given["bearings"] = [
            {name: one for name, one in bearing.items() if name != "clearance_cases"} for bearing in bearings
        ]
    given["clearance_cases"] = "all"
