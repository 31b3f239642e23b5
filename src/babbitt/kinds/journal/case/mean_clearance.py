"""Limits of a clearance whose mean alone is solved."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.kinds.journal.case.journal import JournalBearing

__all__ = ["warnings_about_mean_clearance"]

FAR_FROM_THE_MEAN = 1.05
"""Factor between the mean clearance and a limit from which films are questioned that are solved at the mean alone.

Assumption: the load number goes with the square of the clearance, and differs there by a tenth. At 1.2 the least
clearance of bearings near their limits was 5 to 16 K hotter than the mean.
ISO 7902, and films whose limits are nearer, are solved at the limits
(`babbitt.kinds.journal.limits_of_clearance`): of H7/d8, 1.37 at 120 mm, the least clearance misses limits of the
temperature that the mean keeps; a critical mass goes with 1.05 of the clearance by 5 %."""


def warnings_about_mean_clearance(bearing: JournalBearing, asked_for: bool) -> Iterator[Notice]:
    """Question limits of the clearance at which nothing is solved.

    Near limits are an information where the case asks for the mean alone by a method that does not solve them.
    """
    clearance = bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter)
    least, mean, most = clearance.minimum, clearance.mean, clearance.maximum
    solves_limits = asked_for and bearing.method == "iso7902"
    if not solves_limits and (mean > FAR_FROM_THE_MEAN * least or most > FAR_FROM_THE_MEAN * mean):
        yield Notice("W174", "far", {"least": least, "mean": mean, "most": most})
    elif least < most and not asked_for:
        yield Notice("W174", "unsolved", {"least": least, "mean": mean, "most": most})
    elif bearing.method in ("iso7902", "film") and bearing.position is None:
        return
    elif getattr(bearing.clearance, "minimum", None) is not None:
        yield Notice("W183", "limits_of_clearance", {"fields": ("clearance.minimum", "clearance.maximum")})
