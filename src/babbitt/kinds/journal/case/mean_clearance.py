"""Limits of a clearance whose mean alone is solved."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.kinds.journal.case.journal import JournalBearing

__all__ = ["warnings_about_mean_clearance"]

FAR_FROM_THE_MEAN = 1.5
"""Factor between the mean clearance and a limit above which the mean says little of the limits.

Assumption: the load number goes with the square of the clearance, and is there less than half or more than twice
that of the mean. The least clearance of H7/f7, half the mean, runs 50 K hotter than the mean in a pump by ISO 7902
and misses the limit by films with temperatures of their own, too; that of H7/e7 keeps it by such films."""


def warnings_about_mean_clearance(bearing: JournalBearing, asked_for: bool) -> Iterator[Notice]:
    """Question limits of the clearance at which nothing is solved.

    Near limits are an information where the case asks for the mean alone.
    """
    clearance = bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter)
    least, mean, most = clearance.minimum, clearance.mean, clearance.maximum
    if mean > FAR_FROM_THE_MEAN * least or most > FAR_FROM_THE_MEAN * mean:
        yield Notice("W174", "far", {"least": least, "mean": mean, "most": most})
    elif least < most and not asked_for:
        yield Notice("W174", "unsolved", {"least": least, "mean": mean, "most": most})
    elif getattr(bearing.clearance, "minimum", None) is not None:
        yield Notice("W183", "limits_of_clearance", {"fields": ("clearance.minimum", "clearance.maximum")})
