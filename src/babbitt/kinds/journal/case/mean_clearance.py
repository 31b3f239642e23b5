"""Limits of a clearance whose mean alone is solved."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.case.parts.clearance import has_far_limits
from babbitt.core.notices import Notice
from babbitt.kinds.journal.case.journal import JournalBearing

__all__ = ["warnings_about_mean_clearance"]


def warnings_about_mean_clearance(bearing: JournalBearing, asked_for: bool) -> Iterator[Notice]:
    """Question limits of the clearance at which nothing is solved (`babbitt.kinds.journal.limits_of_clearance`).

    Near limits are an information where the case asks for the mean alone by a method that does not solve them.
    """
    clearance = bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter)
    least, mean, most = clearance.minimum, clearance.mean, clearance.maximum
    solves_limits = asked_for and bearing.method == "iso7902"
    if not solves_limits and has_far_limits(least, mean, most):
        yield Notice("W174", "far", {"least": least, "mean": mean, "most": most})
    elif least < most and not asked_for:
        yield Notice("W174", "unsolved", {"least": least, "mean": mean, "most": most})
    elif bearing.method not in ("iso7902", "film") and getattr(bearing.clearance, "minimum", None) is not None:
        yield Notice("W183", "limits_of_clearance", {"fields": ("clearance.minimum", "clearance.maximum")})
