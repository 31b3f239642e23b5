"""How much a report says."""

from __future__ import annotations

from enum import StrEnum

__all__ = ["Level"]


class Level(StrEnum):
    """How much a report says of a machine and its bearings."""

    SUMMARY = "summary"
    """The machine alone: a line a bearing, what comes closest to the limits, remarks, counts of missed advice."""
    STANDARD = "standard"
    """Inputs, results, checks and figures of every bearing, too."""
    FULL = "full"
    """Calculation line by line and case file, too."""
