"""Where a study goes: checked before anything is computed, written afterwards."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from babbitt.core.files.printing import printable
from babbitt.core.files.spreadsheet import openpyxl_library
from babbitt.core.files.writing import require_distinct, require_writable, write_file
from babbitt.core.notices import InputError
from babbitt.study.study import Study

__all__ = ["require_study_outputs", "write_study"]


def require_study_outputs(
    inputs: Mapping[Path, str],
    xlsx: Path | None,
    report: Path | None,
    plots: Path | None,
    record: Path | None = None,
) -> None:
    """Find out before any work is done whether a study can be written.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, an unknown ending, an output that would replace an input, or a
        package that is not installed.
    """
    outputs = [path for path in (xlsx, report, plots, record) if path is not None]
    require_distinct(outputs, inputs)
    if record is not None:
        require_writable(record)
    if xlsx is not None:
        if xlsx.suffix.lower() != ".xlsx":
            raise InputError("E007", f"cannot write {printable(xlsx)}: a workbook ends in .xlsx")
        openpyxl_library(printable(xlsx))
        require_writable(xlsx)
    if report is not None:
        from babbitt.report.document import FORMATS

        if report.suffix.lower() not in FORMATS:
            raise InputError("E007", f"cannot write {printable(report)}: a report ends in .pdf or .html")
        require_writable(report)
    if report is not None or plots is not None:
        from babbitt.report.drawing import require_extra

        require_extra("matplotlib", "plots")


def write_study(study: Study, xlsx: Path | None, report: Path | None, plots: Path | None) -> None:
    """Write a study as a workbook, a report and figures, as far as asked for.

    Raises
    ------
    InputError
        E007 when a file cannot be written.
    """
    if xlsx is not None:
        from babbitt.report.study_workbook import study_workbook

        write_file(xlsx, study_workbook(study, printable(xlsx)))
    if report is not None:
        from babbitt.report.study_document import write_study_report

        write_study_report(study, report)
    if plots is not None:
        from babbitt.report.study_figures import write_study_plots

        write_study_plots(study, plots)
