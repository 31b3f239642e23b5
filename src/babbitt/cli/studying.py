"""The command that studies a case: many variants of it, one question."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, AllowOutside, app, reach
from babbitt.cli.interruption import INTERRUPTED, raised_interrupts
from babbitt.core.files.printing import printable
from babbitt.core.notices import InputError

if TYPE_CHECKING:
    from babbitt.study.study import Study
    from babbitt.study.workers import Workers

__all__ = ["study"]

LONG = 60.0
"""Seconds of work of which is said that they can be kept."""


@app.command()
def study(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE or show NAME.study",
            help="A case file with a study, or a file with study and case; show: a study that is stored.",
        ),
    ],
    out: Annotated[
        Path | None,
        typer.Option(metavar="NAME.study", help="Keep what is finished in a folder; the same command goes on."),
    ] = None,
    workers: Annotated[
        int | None, typer.Option(metavar="N", help="Processes of this machine. By default one a core.", min=1)
    ] = None,
    scheduler: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="A dask scheduler instead, such as tcp://10.0.0.1:8786.")
    ] = None,
    xlsx: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write inputs, results and summary: OUT.xlsx.")
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write the report: OUT.pdf or OUT.html.")
    ] = None,
    plots: Annotated[Path | None, typer.Option(metavar="DIR", help="Write the figures into a folder.")] = None,
    allow_outside: AllowOutside = False,
) -> None:
    """Study many variants of a case: sweep, tolerance, map, sensitivity, optimise, spectrum."""
    from babbitt.report.study_output import require_study_outputs, write_study
    from babbitt.report.study_table import print_study

    stored = words[0] == "show" and len(words) == 2
    if not stored and len(words) != 1:
        raise InputError("E005", "study takes one file, or: study show NAME.study")
    if stored:
        from babbitt.study.study import open_study

        require_study_outputs({Path(words[1]): "a stored study"}, xlsx, report, plots)
        found = open_study(words[1])
    else:
        found = _computed(Path(words[0]), out, workers, scheduler, (xlsx, report, plots), allow_outside)
    write_study(found, xlsx, report, plots)
    print_study(found)
    if not (found.columns["status"] == "converged").any():
        raise typer.Exit(NO_SOLUTION)


def _computed(
    file: Path,
    out: Path | None,
    workers: int | None,
    scheduler: str | None,
    outputs: tuple[Path | None, Path | None, Path | None],
    allow_outside: bool,
) -> Study:
    """Plan and compute a study; nothing is written before all of it was found possible."""
    from babbitt.case.study_file import load_study
    from babbitt.report.study_output import require_study_outputs
    from babbitt.report.study_progress import StudyProgress
    from babbitt.study.engine import InterruptedStudyError
    from babbitt.study.study import plan, run_study, write_designs

    read = load_study(file, reach(allow_outside))
    case, block = read.case, read.study
    assert block is not None, "a file without a study is refused"
    require_study_outputs(dict.fromkeys(read.files, "an input of the run"), *outputs)
    made = plan(case, block)
    count = workers or os.cpu_count() or 1
    if out is None and made.work / count > LONG:
        said = (
            f"about {made.work / count / 60.0:.0f} minutes of work; with --out NAME.study what is finished is kept"
        )
        print(f"{printable(file)}: {said}", file=sys.stderr)
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
