"""Values that people choose among: oils of the catalogue, tolerance classes, preferred numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

from babbitt.core.units import KINDS
from babbitt.properties.lubricants import catalogue
from babbitt.study.permitted import Interval

__all__ = ["BORE_CLASSES", "JOURNAL_CLASSES", "RENARD_20", "preferred_numbers", "standard_choices"]

ROUND_IN = {"rad/s": "rpm", "rad": "deg"}
"""Units in which numbers are round, where those of SI differ by more than a power of ten."""

RENARD_20 = (
    1.00, 1.12, 1.25, 1.40, 1.60, 1.80, 2.00, 2.24, 2.50, 2.80,
    3.15, 3.55, 4.00, 4.50, 5.00, 5.60, 6.30, 7.10, 8.00, 9.00,
)  # fmt: skip
"""Preferred numbers of a decade, series R20 of ISO 3."""

BORE_CLASSES = ("H6", "H7", "H8", "G7", "F7", "F8", "E8", "E9")
JOURNAL_CLASSES = ("g6", "f6", "f7", "e6", "e7", "e8", "d8", "d9")
"""Running fits of ISO 286 that bearings are made to (assumption: what drawings usually have)."""


def standard_choices(path: str) -> tuple[str, ...]:
    """Words that stand for a field where people choose among some; empty for others.

    >>> standard_choices("clearance.bore")[:3], standard_choices("lubricant")[:1], standard_choices("load")
    (('H6', 'H7', 'H8'), ('ISO VG 10',), ())
    """
    last = path.split(".")[-1]
    if last == "lubricant":
        return tuple(one.name for one in catalogue() if one.name.startswith("ISO VG"))
    return {"bore": BORE_CLASSES, "journal": JOURNAL_CLASSES}.get(last, ()) if "clearance" in path else ()


def preferred_numbers(intervals: Sequence[Interval], unit: str) -> tuple[float, ...]:
    """Numbers of `RENARD_20` within the permitted intervals, ascending, in SI; speeds are round in rpm."""
    factor = KINDS[unit].everyday[ROUND_IN[unit]] if unit in ROUND_IN else 1.0
    found = []
    for one in intervals:
        low, high = one.lower.value / factor, one.upper.value / factor
        if high <= 0.0:
            continue
        least = max(low, high * 1e-6)
        decades = range(math.floor(math.log10(least)), math.floor(math.log10(high)) + 1)
        numbers = (float(f"{number * 10.0**decade:.3g}") for decade in decades for number in RENARD_20)
        found += [number * factor for number in numbers if low <= number <= high]
    return tuple(found)
