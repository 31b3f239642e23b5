"""The command that studies a case: many variants of it, one question."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, AllowOutside, System, Tongue, Units, app, reach
from babbitt.cli.interruption import INTERRUPTED, raised_interrupts
from babbitt.core.files.printing import printable
from babbitt.core.notices import InputError

if TYPE_CHECKING:
    from babbitt.case.case_file import CaseFile
    from babbitt.case.parts.study import StudyBlock
    from babbitt.case.study_file import StudiedCase
    from babbitt.study.study import Study
    from babbitt.study.workers import Workers

__all__ = [
    "Kept",
    "PlotFolder",
    "Processes",
    "Report",
    "Scheduler",
    "StudyTongue",
    "Workbook",
    "computed",
    "study",
]

ALONE = ("map", "corners")
"""Kinds of study that need no fields to be named."""

LONG = 60.0
"""Seconds of work of which is said that they can be kept."""

Kept = Annotated[
    Path | None,
    typer.Option(
        "--out", metavar="NAME.study", help="Keep what is finished in a folder; the same command goes on."
    ),
]
Processes = Annotated[
    int | None,
    typer.Option("--workers", metavar="N", help="Processes of this machine. By default one a core.", min=1),
]
Scheduler = Annotated[
    str | None, typer.Option(metavar="ADDRESS", help="A dask scheduler instead, such as tcp://10.0.0.1:8786.")
]
Workbook = Annotated[Path | None, typer.Option(metavar="OUT", help="Write inputs, results and summary: OUT.xlsx.")]
Report = Annotated[Path | None, typer.Option(metavar="OUT", help="Write the report: OUT.pdf or OUT.html.")]
PlotFolder = Annotated[Path | None, typer.Option(metavar="DIR", help="Write the figures into a folder.")]
StudyTongue = Annotated[
    Tongue | None, typer.Option("--language", help="Of report and plots: else that of the case, else English.")
]


@app.command()
def study(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE or show NAME.study",
            help="A case file with a study, or a file with study and case; show: a study that is stored.",
        ),
    ],
    kind: Annotated[
        str | None,
        typer.Option(
            metavar="KIND",
            help="Without a study in the file: map, over the fields of its kind; corners, of clearance and oil.",
        ),
    ] = None,
    points: Annotated[
        int | None, typer.Option(metavar="N", help="Values along each axis of that map.", min=2, max=1000)
    ] = None,
    out: Kept = None,
    workers: Processes = None,
    scheduler: Scheduler = None,
    xlsx: Workbook = None,
    report: Report = None,
    plots: PlotFolder = None,
    language: StudyTongue = None,
    units: Units = System.SI,
    allow_outside: AllowOutside = False,
) -> None:
    """Study many variants of a case: sweep, size, tolerance, map, corners, sensitivity, optimise, spectrum."""
    from babbitt.core.quantities import displayed_in
    from babbitt.report.study_output import language_of_study, require_language, require_study_outputs, write_study
    from babbitt.report.study_table import print_study

    stored = words[0] == "show" and len(words) == 2
    if not stored and len(words) != 1:
        raise InputError("E005", "study takes one file, or: study show NAME.study")
    if stored:
        from babbitt.study.study import open_study

        require_study_outputs({Path(words[1]): "a stored study"}, xlsx, report, plots)
        found = open_study(words[1])
        language_of_study(found, language)
    else:
        read = _read(Path(words[0]), kind, points, allow_outside)
        assert read.study is not None, "a file without a study is refused"
        require_study_outputs(dict.fromkeys(read.files, "an input of the run"), xlsx, report, plots)
        require_language(read.case, language, report, plots)
        found = computed(words[0], read.case, read.study, out, workers, scheduler)
    with displayed_in(units):
        write_study(found, xlsx, report, plots, language)
        print_study(found)
    if not (found.columns["status"] == "converged").any():
        raise typer.Exit(NO_SOLUTION)


def _read(file: Path, kind: str | None, points: int | None, allow_outside: bool) -> StudiedCase:
    """The case with the study in its file, or with one that needs nothing but its kind."""
    from babbitt.case.study_file import load_case_or_study, load_study

    if kind is None:
        if points is not None:
            raise InputError("E005", "--points belongs to --kind map")
        return load_study(file, reach(allow_outside))
    from babbitt.case.parts.study import StudyBlock

    if kind not in ALONE:
        says = f"--kind '{kind}' needs to know more; allowed: {', '.join(ALONE)}"
        raise InputError("E005", f"{says}; write a block `study` for others")
    read = load_case_or_study(file, reach(allow_outside))
    given = {"kind": kind} | ({} if points is None else {"points": points})
    return replace(read, study=StudyBlock.model_validate(given))


def computed(
    what: object,
    case: CaseFile,
    block: StudyBlock,
    out: Path | None,
    workers: int | None,
    scheduler: str | None = None,
) -> Study:
    """Plan and compute a study; nothing is written before all of it was found possible."""
    from babbitt.report.study_progress import StudyProgress
    from babbitt.study.best_designs import require_stored_designs, write_designs
    from babbitt.study.engine import InterruptedStudyError
    from babbitt.study.plan import plan
    from babbitt.study.study import run_study

    require_stored_designs(out)
    made = plan(case, block)
    count = workers or os.cpu_count() or 1
    if out is None and made.work / count > LONG:
        said = (
            f"about {made.work / count / 60.0:.0f} minutes of work; with --out NAME.study what is finished is kept"
        )
        print(f"{printable(what)}: {said}", file=sys.stderr)
    try:
        with raised_interrupts(), StudyProgress(f"{case.name}: {block.kind}") as watch:
            found = run_study(made, workers=_hands(scheduler) or made.hands(count), folder=out, watch=watch)
    except InterruptedStudyError as error:
        kept = f"kept in {printable(out)}; the same command goes on" if out is not None else "lost, without --out"
        print(f"interrupted: {error}, {kept}", file=sys.stderr)
        raise typer.Exit(INTERRUPTED) from None
    except KeyboardInterrupt:  # between two chunks
        print("interrupted", file=sys.stderr)
        raise typer.Exit(INTERRUPTED) from None
    write_designs(found)
    return found


def _hands(scheduler: str | None) -> Workers | None:
    if scheduler is None:
        return None
    from babbitt.study.workers import Cluster

    return Cluster(scheduler)
