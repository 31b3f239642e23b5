"""The numbers of one bearing by ISO 7902 as its calculation goes on."""

from __future__ import annotations

import math

from babbitt.core.result import Result
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.report.worksheet import Worksheet

__all__ = ["JournalSheet"]


class JournalSheet(Worksheet):
    """Values of the result, and of the case what they follow from; see `Worksheet`."""

    def __init__(self, case: DesignCase, result: Result) -> None:
        bearing = case.bearing
        known = dict(result.values)
        known |= {
            "angular_span": math.radians(bearing.span),
            "expansion_bearing": bearing.expansion_bearing,
            "expansion_journal": bearing.expansion_journal,
            "friction_factor": case.friction_factor,
        }
        if bearing.surfaces is not None:
            known |= vars(bearing.surfaces)
        if case.cooling is not None:
            known["heat_transfer_coefficient"] = case.cooling.heat_transfer_coefficient
            known["cooling_surface"] = case.cooling.surface
        super().__init__(known)
