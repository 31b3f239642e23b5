"""The command that seeks the permitted values of one field: the one-line form of a study of kind size."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, AllowOutside, System, Units, app, reach
from babbitt.cli.studying import Kept, PlotFolder, Processes, Report, StudyTongue, Workbook, computed

__all__ = ["size"]


@app.command()
def size(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file.")],
    path: Annotated[
        str, typer.Argument(metavar="PATH", help="Field that is sought: load, clearance.mean, lubricant, ...")
    ],
    first: Annotated[
        str | None,
        typer.Option(
            "--from", metavar="A", help="Where the scan begins; a tenth of the case's value if left out."
        ),
    ] = None,
    last: Annotated[
        str | None,
        typer.Option("--to", metavar="B", help="Where it ends; ten times the case's value if left out."),
    ] = None,
    points: Annotated[int, typer.Option(metavar="N", help="Values of the scan.")] = 64,
    among: Annotated[
        str | None, typer.Option(metavar="CHOICES", help="Hold these choices against the limits: 'H7, F7'.")
    ] = None,
    preferred: Annotated[
        bool, typer.Option("--preferred", help="Show the preferred numbers (R20 of ISO 3) that are permitted.")
    ] = False,
    limits: Annotated[
        str,
        typer.Option(
            metavar="LIMITS", help="all, recommended (recommendations count too), or codes: 'C101, C104'."
        ),
    ] = "all",
    over_tolerance: Annotated[
        bool, typer.Option("--over-tolerance", help="At the smallest, mean and largest clearance.")
    ] = False,
    bearing: Annotated[
        str | None, typer.Option(metavar="NAME", help="One bearing of a machine; PATH begins at it.")
    ] = None,
    json: Annotated[Path | None, typer.Option(metavar="OUT", help="Write the answer as JSON.")] = None,
    out: Kept = None,
    workers: Processes = None,
    xlsx: Workbook = None,
    report: Report = None,
    plots: PlotFolder = None,
    language: StudyTongue = None,
    units: Units = System.SI,
    allow_outside: AllowOutside = False,
) -> None:
    """Find the values of a field that keep all limits: every interval, and the check that ends it."""
    from babbitt.case.variation import case_variation
    from babbitt.core.quantities import displayed_in
    from babbitt.report.size_output import write_size
    from babbitt.report.study_output import require_language, require_study_outputs, write_study
    from babbitt.report.study_table import print_study
    from babbitt.study.size import size_block, size_of

    variation = case_variation(file, path, bearing, reach(allow_outside))
    require_study_outputs(
        dict.fromkeys((file, *variation.inputs), "an input of the run"), xlsx, report, plots, json
    )
    case, field = variation.unchanged, variation.whole_path
    require_language(case, language, report, plots)
    block = size_block(case, field, first, last, points, _parts(among), _parts(limits), over_tolerance, preferred)
    found = computed(file, case, block, out, workers)
    write_size(found, json)
    with displayed_in(units):
        write_study(found, xlsx, report, plots, language)
        print_study(found)
    if not size_of(found).permitted:
        raise typer.Exit(NO_SOLUTION)


def _parts(text: str | None) -> tuple[str, ...]:
    return tuple(one.strip() for one in text.split(",")) if text else ()
