"""`babbitt solve --table`: the bearings in the rows of a table."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import typer

from babbitt.cli.app import NO_SOLUTION, NOT_PASSED
from babbitt.cli.interruption import INTERRUPTED, raised_interrupts
from babbitt.core.files.reading import Reach
from babbitt.core.notices import InputError

__all__ = ["require_table", "solve_rows"]


def require_table(table: Path | None, files: Sequence[Path], unread: Mapping[str, object]) -> Path:
    """The table, unless options contradict it.

    Raises
    ------
    InputError
        E005 for options of a table without one, for several case files, and for outputs that a table has not.
    """
    if table is None:
        raise InputError("E005", "--csv, --xlsx and --workers belong to --table, which names the rows")
    if len(files) > 1:
        raise InputError(
            "E005", f"--table takes one case file, which has what the columns do not; given: {len(files)}"
        )
    for option, given in unread.items():
        if given is not None:
            raise InputError("E005", f"{option} is not written of a table; allowed: --csv, --xlsx, --report")
    return table


def solve_rows(
    file: Path,
    rows: Path,
    outputs: tuple[str | None, Path | None, Path | None],
    workers: int | None,
    strict: bool,
    reach: Reach,
    units: str,
    language: str | None = None,
) -> None:
    """Solve the bearings in the rows of a table, print and write them.

    Parameters
    ----------
    file : Path
        The case, which has what the columns do not.
    rows : Path
        The table.
    outputs : tuple
        Where to write comma-separated values, the workbook and the report.
    workers : int, optional
        Processes; one a core if not given.
    strict : bool
        Exit with 1 where a bearing fails or has no verdict.
    reach : Reach
        Where the case may name other files.
    units : str
        System of units of what is printed and written.
    language : {"en", "de", "ru"}, optional
        Of the report; that of the case if not given, English if that has none.
    """
    from babbitt.case import load_case
    from babbitt.core.quantities import displayed_in
    from babbitt.report.study_output import (
        STANDARD_OUTPUT,
        require_csv,
        require_language,
        require_study_outputs,
        write_study,
        write_study_csv,
    )
    from babbitt.report.study_progress import StudyProgress
    from babbitt.report.study_table import print_study
    from babbitt.study.engine import InterruptedStudyError
    from babbitt.study.plan import plan_table
    from babbitt.study.study import run_study
    from babbitt.study.table_cells import read_table
    from babbitt.study.yields import WITHIN

    csv, xlsx, report = outputs
    case = load_case(file, reach)
    inputs = dict.fromkeys((file, rows, *case.files), "an input of the run")
    require_csv(inputs, csv)
    require_study_outputs(inputs, xlsx, report, None)
    require_language(case, language, report, None)
    made = plan_table(case, read_table(rows))
    try:
        with raised_interrupts(), StudyProgress(f"{case.name}: {rows.name}") as watch:
            found = run_study(made, workers=made.hands(workers or os.cpu_count() or 1), watch=watch)
    except (InterruptedStudyError, KeyboardInterrupt) as error:
        print(f"interrupted: {error}" if str(error) else "interrupted", file=sys.stderr)
        raise typer.Exit(INTERRUPTED) from None
    with displayed_in(units):
        write_study(found, xlsx, report, None, language)
        if csv is not None:
            write_study_csv(found, csv)
        if csv != STANDARD_OUTPUT:
            print_study(found)
    if not (found.columns["status"] == "converged").all():
        raise typer.Exit(NO_SOLUTION)
    if strict and not set(found.columns["verdict"]) <= set(WITHIN):
        raise typer.Exit(NOT_PASSED)
