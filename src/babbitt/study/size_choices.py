"""Choices of a field put to the limits: oils of the catalogue, tolerance classes, preferred numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from babbitt.case.variation import CaseVariation
from babbitt.core.notices import InputError
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.properties.lubricants import catalogue
from babbitt.solving import solve
from babbitt.study.permitted import Appraisal
from babbitt.study.size import ALL_LIMITS, Size, appraisal_of, at_all_clearances

__all__ = ["RENARD_20", "Choices", "appraise_choices", "preferred_numbers", "standard_choices"]

RENARD_20 = (
    1.00, 1.12, 1.25, 1.40, 1.60, 1.80, 2.00, 2.24, 2.50, 2.80,
    3.15, 3.55, 4.00, 4.50, 5.00, 5.60, 6.30, 7.10, 8.00, 9.00,
)  # fmt: skip
"""Preferred numbers of a decade, series R20 of ISO 3."""

BORE_CLASSES = ("H6", "H7", "H8", "G7", "F7", "F8", "E8", "E9")
JOURNAL_CLASSES = ("g6", "f6", "f7", "e6", "e7", "e8", "d8", "d9")
"""Running fits of ISO 286 that bearings are made to (assumption: what drawings usually have)."""


@dataclass(frozen=True)
class Choices:
    """How a case does with each of some choices.

    Attributes
    ----------
    name, path : str
        Of the case; the field.
    limits : tuple of str
    over_tolerance : bool
        As in `babbitt.study.size.Size`.
    appraisals : mapping of str to Appraisal
        By the choice as it stands in a case file; the values of the appraisals are their places.
    """

    name: str
    path: str
    limits: tuple[str, ...]
    over_tolerance: bool
    appraisals: Mapping[str, Appraisal]


def standard_choices(path: str) -> tuple[str, ...]:
    """Words that stand for a field where people choose among some; empty for others.

    >>> standard_choices("clearance.bore")[:3], standard_choices("lubricant")[:1], standard_choices("load")
    (('H6', 'H7', 'H8'), ('ISO VG 10',), ())
    """
    last = path.split(".")[-1]
    if last == "lubricant":
        return tuple(one.name for one in catalogue() if one.name.startswith("ISO VG"))
    return {"bore": BORE_CLASSES, "journal": JOURNAL_CLASSES}.get(last, ()) if "clearance" in path else ()


def preferred_numbers(size: Size) -> tuple[float, ...]:
    """Numbers of `RENARD_20` within the permitted intervals, ascending."""
    found = []
    for one in size.intervals:
        low, high = one.lower.value, one.upper.value
        if high <= 0.0:
            continue
        least = max(low, high * 1e-6)
        decades = range(math.floor(math.log10(least)), math.floor(math.log10(high)) + 1)
        numbers = (float(f"{number * 10.0**decade:.3g}") for decade in decades for number in RENARD_20)
        found += [number for number in numbers if low <= number <= high]
    return tuple(found)


def appraise_choices(
    variation: CaseVariation,
    choices: Sequence[str],
    limits: Sequence[str] = (ALL_LIMITS,),
    over_tolerance: bool = False,
    progress: ProgressCallback = no_progress,
) -> Choices:
    """Solve a case with every choice in the field and hold it against the limits.

    Raises
    ------
    InputError
        Where every choice is refused, what the first is refused for; E005 for a code that no check has.
    """
    if over_tolerance:
        at_all_clearances(variation)
    found: dict[str, Appraisal] = {}
    refused: list[InputError] = []
    for place in progress(range(len(choices))):
        choice = choices[place]
        try:
            found[choice] = appraisal_of(float(place), solve(variation.case(choice)).results, limits)
        except InputError as error:
            refused.append(error)
            found[choice] = Appraisal(float(place), False, math.nan, error.code, reason=str(error))
    if refused and len(refused) == len(choices):
        raise refused[0]
    return Choices(variation.given.get("name", ""), variation.path, tuple(limits), over_tolerance, found)
