"""Where a study goes: checked before anything is computed, written afterwards."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from babbitt.case.loading import DOCUMENT, read_tree
from babbitt.case.parts.title_block import TitleBlock
from babbitt.core.files.printing import printable
from babbitt.core.files.spreadsheet import openpyxl_library, rows_text
from babbitt.core.files.writing import require_distinct, require_folder, require_writable, write_file
from babbitt.core.language import written_in
from babbitt.core.notices import InputError
from babbitt.report.languages import chosen_language
from babbitt.report.outputs import STANDARD_OUTPUT, left_in_english
from babbitt.report.study_workbook import study_rows, study_workbook
from babbitt.study.study import Study

if TYPE_CHECKING:
    from babbitt.case.case_file import CaseFile

__all__ = [
    "STANDARD_OUTPUT",
    "language_of_study",
    "require_csv",
    "require_language",
    "require_study_outputs",
    "write_study",
    "write_study_csv",
]


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
    if plots is not None:
        require_folder(plots, "--plots")
    if report is not None or plots is not None:
        from babbitt.report.drawing import require_extra

        require_extra("matplotlib", "plots")


def require_csv(inputs: Mapping[Path, str], csv: str | None) -> None:
    """Find out before any work is done whether the rows of a study can be written as CSV.

    Raises
    ------
    InputError
        E007 as `require_study_outputs`.
    """
    if csv is None or csv == STANDARD_OUTPUT:
        return
    path = Path(csv)
    if path.suffix.lower() != ".csv":
        raise InputError("E007", f"cannot write {printable(path)}: a table of values ends in .csv")
    require_distinct([path], inputs)
    require_writable(path)


def write_study_csv(study: Study, csv: str) -> None:
    """Write the rows of a study with their results as comma-separated values, to a file or standard output.

    Raises
    ------
    InputError
        E007 when the file cannot be written.
    """
    text = rows_text(study_rows(study))
    if csv == STANDARD_OUTPUT:
        print(text, end="")
    else:
        write_file(Path(csv), text.encode())


def require_language(case: CaseFile, language_code: str | None, report: Path | None, plots: Path | None) -> None:
    """Find out before any work is done whether a language can be written.

    Raises
    ------
    InputError
        E005 for a language that is not known, or that lacks the words of the kind; E007 for one that is asked for
        where neither report nor figures are.
    """
    if report is not None or plots is not None:
        chosen_language(case.title_block, [case.kind], language_code)
    elif language_code is not None:
        raise InputError(
            "E007", "--language is of report and plots, and there are none; add --report OUT.pdf or --plots DIR"
        )


def language_of_study(study: Study, asked: str | None = None) -> str:
    """The language of a report: the one asked for, else that of the title block of the case, else English.

    Raises
    ------
    InputError
        E005 for one that is not known, or that lacks the words of the kind.
    """
    text = str(study.description["text"])
    stated = (read_tree(text, "").plain() if text else {}).get(DOCUMENT) or {}
    block = TitleBlock(language=stated.get("language"))
    return chosen_language(block, [str(study.description["kind"])], asked)


def write_study(
    study: Study, xlsx: Path | None, report: Path | None, plots: Path | None, language_code: str | None = None
) -> None:
    """Write a study as a workbook, a report and figures, as far as asked for.

    Parameters
    ----------
    study : Study
    xlsx, report, plots : Path or None
    language_code : {"en", "de", "ru"}, optional
        Of report and figures, as `language_of_study` takes it; the workbook is in English.

    Raises
    ------
    InputError
        E005 as `language_of_study`; E007 when a file cannot be written.
    """
    if xlsx is not None:
        write_file(xlsx, study_workbook(study, printable(xlsx)))
    written = report or plots
    if written is None:
        return
    with written_in(language_of_study(study, language_code)) as missing:
        if report is not None:
            from babbitt.report.study_document import write_study_report

            write_study_report(study, report)
        if plots is not None:
            from babbitt.report.study_figures import write_study_plots

            write_study_plots(study, plots)
    if missing:
        print(left_in_english(written, tuple(missing)), file=sys.stderr)
