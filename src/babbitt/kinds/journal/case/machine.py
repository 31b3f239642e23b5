"""What stands in a file with one journal bearing, or with a machine of many."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field

from babbitt.case.case_file import CaseFile
from babbitt.case.error_messages import Path
from babbitt.case.named_files import NamedFiles
from babbitt.case.part import Issue, as_far_as_usable, named_once, rule
from babbitt.case.parts.fields import Name, Prose
from babbitt.case.parts.shared import SharedInputs
from babbitt.kinds.journal.case.completeness import issues_of
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.oil_system import OilSystemInput, issues_of_bearings


class JournalFile(CaseFile):
    """A file with journal bearings, which may name tables of bore, load, displacement, compliance and limits."""

    @classmethod
    def with_named_files(cls, given: dict[str, Any], files: NamedFiles) -> dict[str, Any]:
        """Put the points of tables and the text of limits in place of their files."""
        from babbitt.kinds.journal.case.bore_file import with_tables
        from babbitt.kinds.journal.case.compliance_file import with_compliances
        from babbitt.kinds.journal.case.displacement_file import with_displacements

        return with_compliances(with_displacements(with_tables(given, files), files), files)


class SingleBearing(JournalBearing, JournalFile):
    """What stands in a file with one journal bearing."""

    @rule
    def _nothing_is_missing(self) -> Iterator[Issue]:
        yield from issues_of(self, None)


class SeveralBearings(SharedInputs, JournalFile):
    """A file with the bearings of a machine, which share what stands here and may differ in single fields."""

    kind: Literal["machine"] = Field(description="Several bearings that share lubricant, supply and cooling.")
    name: Name = Field(description="Name of the machine.")
    clearance_cases: Literal["mean", "all"] = Field(
        "mean", description="Calculate with the mean clearance, or with minimum, mean and maximum."
    )
    bearings: tuple[JournalBearing, ...] = Field(
        min_length=1, max_length=200, description="The bearings of the machine."
    )
    oil_system: OilSystemInput | None = Field(
        None,
        description="Pump, header and a line to each bearing, from which the pressures follow. None: every "
        "bearing has the pressure of supply.",
    )
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @rule
    def _names_are_their_own(self) -> Iterator[Issue]:
        yield from named_once((vars(one).get("name") for one in self.bearings), "bearing", "bearings")

    @rule
    def _oil_system_feeds_all(self) -> Iterator[Issue]:
        if self.oil_system is None:
            return
        if self.clearance_cases != "mean":
            yield Issue(("clearance_cases",), "an oil system has one clearance of each bearing", "mean")
        yield from issues_of_bearings(self.oil_system, self.bearings, self.supply)

    @rule
    def _nothing_is_missing(self) -> Iterator[Issue]:
        # What all bearings lack is reported once, at the machine.
        reported: dict[tuple[Path, str], Issue] = {}
        for index, bearing in enumerate(self.bearings):
            for issue in as_far_as_usable(issues_of(bearing, self, "bearings", index)):
                reported.setdefault((issue.path, issue.says), issue)
        yield from reported.values()
