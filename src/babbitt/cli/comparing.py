"""The command that compares: methods for one case, or several designs."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, AllowOutside, System, Tongue, Units, app, reach
from babbitt.cli.upgrading import report_former_places
from babbitt.core.notices import InputError
from babbitt.core.quantities import displayed_in

if TYPE_CHECKING:
    from babbitt.case.case_file import CaseFile

__all__ = ["compare"]


@app.command()
def compare(
    files: Annotated[list[Path], typer.Argument(metavar="FILE...", help="One case file, or several designs.")],
    plots: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Of one file: write one figure per bearing with journal and film into a folder."
        ),
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write figures, tables and remarks as one page: OUT.html.")
    ] = None,
    json: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Of several designs: write them as OUT.json, in SI.")
    ] = None,
    csv: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Of several designs: write a table, OUT.csv or OUT.xlsx.")
    ] = None,
    language: Annotated[
        Tongue | None,
        typer.Option(help="Of the page: else that of the first case, else English."),
    ] = None,
    units: Units = System.SI,
    allow_outside: AllowOutside = False,
) -> None:
    """One file: the same bearings by every method that applies. Several files: designs side by side."""
    from babbitt.case import load_case

    several = len(files) > 1
    unfit = [("--plots", plots)] if several else [("--json", json), ("--csv", csv)]
    for option, value in unfit:
        if value is not None:
            says = "is of one file, by every method" if several else "is of several designs"
            raise InputError("E005", f"{option} {says}")
    cases = [load_case(file, reach(allow_outside)) for file in files]
    for file, case in zip(files, cases, strict=True):
        report_former_places(file, case)
    if several:
        solved = _designs(files, cases, (json, csv, report), units, language)
    else:
        solved = _methods(files[0], cases[0], plots, report, units, language)
    if not solved:
        raise typer.Exit(NO_SOLUTION)


def _designs(
    files: list[Path],
    cases: list[CaseFile],
    targets: tuple[Path | None, Path | None, Path | None],
    units: System,
    language: Tongue | None,
) -> bool:
    """Several designs side by side; whether all have a solution."""
    from babbitt.report.designs_output import require_designs_outputs, write_designs_outputs
    from babbitt.report.designs_table import print_designs
    from babbitt.report.outputs import inputs_of, left_in_english
    from babbitt.study.designs import compare_designs

    json, csv, report = targets
    inputs = inputs_of(files, [path for case in cases for path in case.files])
    require_designs_outputs(inputs, json, csv, report)
    _language_of_page(cases, report, language)
    found = compare_designs(cases, [file.stem for file in files])
    write_designs_outputs(found, json, None, None)  # in SI always
    with displayed_in(units):
        missing = write_designs_outputs(found, None, csv, report, language)
        print_designs(found)
    if report is not None and missing:
        print(left_in_english(report, missing), file=sys.stderr)
    return found.solved


def _language_of_page(cases: list[CaseFile], report: Path | None, language: Tongue | None) -> str:
    """The language of the page; refuses one where there is no page, or that lacks the words of a kind."""
    from babbitt.report.languages import chosen_language

    if report is None and language is not None:
        raise InputError("E007", "--language is of the page, and there is none; add --report OUT.html")
    return chosen_language(cases[0].title_block, [case.kind for case in cases if report is not None], language)


def _methods(
    file: Path, case: CaseFile, plots: Path | None, report: Path | None, units: System, language: Tongue | None
) -> bool:
    """One case by every method; whether it has a solution as given."""
    from babbitt.core.files.writing import require_distinct
    from babbitt.report.comparison_table import print_comparison
    from babbitt.report.outputs import inputs_of, left_in_english
    from babbitt.study.comparison import compare_methods

    require_distinct([path for path in (report, plots) if path is not None], inputs_of([file], case.files))
    if report is not None or plots is not None:
        from babbitt.report.drawing import require_extra

        require_extra("matplotlib", "plots")
    if report is not None:
        from babbitt.report.comparison_page import require_page

        require_page(report)
    language_code = _language_of_page([case], report, language)
    found = compare_methods(case)
    if plots is not None:
        from babbitt.report.comparison_plots import write_comparison_plots

        with displayed_in(units):
            drawn = write_comparison_plots(found, plots)
        if len(drawn) < len(found):
            print(
                f"--plots: {len(drawn)} of {len(found)} comparisons have a figure; the others have tables alone "
                f"(kind {case.kind}; no method has found a film that has a temperature)",
                file=sys.stderr,
            )
    if report is not None:
        from babbitt.report.comparison_page import write_comparison_page

        with displayed_in(units):
            missing = write_comparison_page(found, report, language_code)
        if missing:
            print(left_in_english(report, missing), file=sys.stderr)
    with displayed_in(units):
        return print_comparison(found)
