"""Files with one journal bearing or with a machine of many, and what is to be computed of them."""

from __future__ import annotations

from babbitt.core.solution import Calculation
from babbitt.kinds.journal.case.build import calculations
from babbitt.kinds.journal.case.fed_machine import oil_system_calculation
from babbitt.kinds.journal.case.machine import SeveralBearings, SingleBearing

__all__ = ["JournalCase", "Machine"]


class JournalCase(SingleBearing):
    """A file with one journal bearing."""

    def calculations(self) -> tuple[Calculation, ...]:
        """Give one problem for each operating point and clearance."""
        return calculations(self)


class Machine(SeveralBearings):
    """A file with the bearings of a machine, which share what stands here and may differ in single fields."""

    def calculations(self) -> tuple[Calculation, ...]:
        """Give one problem for each bearing, operating point and clearance; of an oil system all in one."""
        found = calculations(self)
        return found if self.oil_system is None else (oil_system_calculation(self, found),)
