"""The command line: solve, check, new, validate, compare, sweep, export, list, explain, cite, schema.

Nothing but results goes to standard output; messages go to standard error. Heavy modules are imported by the
command that needs them, so that ``babbitt --help`` answers at once.
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from babbitt import __version__
from babbitt.notices import EXPLANATIONS, BabbittError, InputError

SOLVED, LIMIT_VIOLATED, UNUSABLE_INPUT, NO_SOLUTION = 0, 1, 2, 3
"""Exit statuses."""

app = typer.Typer(
    name="babbitt",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Compute and design fluid-film (plain) bearings.",
    epilog="Exit status: 0 solved, 1 a design limit is violated (only with --strict), 2 input not usable, "
    "3 no solution found.",
)

Files = Annotated[list[Path], typer.Argument(metavar="FILE...", help="Case files in YAML or JSON.")]


def main() -> None:
    """Run the command line; a mistake of the user ends with one clear message and exit status 2."""
    try:
        app()
    except BabbittError as error:
        _fail(error)
    except BrokenPipeError:  # the reader of a pipe has gone; nothing is left to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:  # standard output cannot take the results, such as a full disk
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _fail(InputError("E007", f"cannot write to standard output: {error.strerror or error}"))


def _fail(error: BabbittError) -> NoReturn:
    print(f"{error.message}", file=sys.stderr)
    print(f"({error.code}: babbitt explain {error.code})", file=sys.stderr)
    sys.exit(UNUSABLE_INPUT)


def _version(wanted: bool) -> None:
    if wanted:
        print(f"babbitt {__version__}")
        raise typer.Exit


@app.callback()
def _babbitt(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    pass


@app.command()
def solve(
    files: Files,
    json: Annotated[
        str | None, typer.Option(metavar="OUT", help="Write the results as JSON; - is standard output.")
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write the report: OUT.pdf or OUT.html.")
    ] = None,
    plots: Annotated[Path | None, typer.Option(metavar="DIR", help="Write the plots into a folder.")] = None,
    fields: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write the fields of the films as NetCDF: OUT.nc.")
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 when a design limit is violated.")] = False,
) -> None:
    """Solve the bearings of case files and print a table."""
    from babbitt.cases import design_cases, load_cases
    from babbitt.report import outputs, print_machine
    from babbitt.solving import solve as solve_case

    cases = load_cases(files)  # every problem of every file first; nothing is written before
    plan = outputs(files, json, report, plots, fields)
    if fields is not None:
        from babbitt.report.fields import require_films

        for path, case in zip(files, cases, strict=True):
            require_films(str(path), design_cases(case))
    machines = [solve_case(case) for case in cases]
    if not plan.silent:
        for machine in machines:
            print_machine(machine)
    for machine, target in zip(machines, plan.targets, strict=True):
        target.write(machine)
    if not all(machine.solved for machine in machines):
        raise typer.Exit(NO_SOLUTION)
    if strict and not all(machine.within_limits for machine in machines):
        raise typer.Exit(LIMIT_VIOLATED)


@app.command()
def check(files: Files) -> None:
    """Validate case files without solving them: every problem at once."""
    from babbitt.cases import CaseError, Problem, design_cases, load_case

    problems: list[Problem] = []
    for path in files:
        try:
            case = load_case(path)
        except CaseError as error:
            problems += error.problems
            continue
        designs = design_cases(case)
        count = len(designs)
        print(f"{path}: usable, kind {case.kind}" + (f", {count} calculation{'s' * (count > 1)}" if count else ""))
        for said in dict.fromkeys(
            f"{doubt.code} {doubt.message}" for design in designs for doubt in design.doubts
        ):
            print(f"  {said}")
    if problems:
        raise CaseError(problems)


@app.command()
def new(
    kind: Annotated[str, typer.Argument(metavar="KIND", help="What to describe: see `babbitt list kinds`.")],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Where to write it.")
    ] = None,
) -> None:
    """Write a commented case file that runs as it stands."""
    from babbitt.cases import template

    text = template(kind)
    if output is None:
        print(text, end="")
        return
    if output.exists():
        raise InputError("E007", f"{output} exists already; nothing was overwritten. Choose another name.")
    _write(output, text)
    print(f"wrote {output}; solve it with: babbitt solve {output}", file=sys.stderr)


@app.command()
def schema() -> None:
    """Print the JSON Schema of case files, with which editors complete and check them."""
    import json

    from babbitt.cases import case_schema

    print(json.dumps(case_schema(), indent=2, ensure_ascii=False))


@app.command()
def validate(
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[NAME...]", help="Cases; all when omitted.")
    ] = None,
) -> None:
    """Run the published cases that ship with the package, side by side with the print.

    Exit status 1 if a judged value differs by more than its tolerance.
    """
    from babbitt.report.validation_table import print_validation
    from babbitt.validation import cases, validation_case

    chosen = [validation_case(name) for name in names] if names else list(cases())
    agreed = [print_validation(case) for case in chosen]
    if not all(agreed):
        raise typer.Exit(LIMIT_VIOLATED)


@app.command()
def compare(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file.")],
    plots: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Write one figure per bearing into a folder.")
    ] = None,
) -> None:
    """Solve the same bearings by every method that applies, side by side."""
    from babbitt.cases import load_case
    from babbitt.report.comparison_table import print_comparison
    from babbitt.studies.comparison import compare_methods

    found = compare_methods(load_case(file))
    solved = print_comparison(found)
    if plots is not None:
        from babbitt.report.comparison_figure import write_comparison_plots

        write_comparison_plots(found, plots)
    if not solved:
        raise typer.Exit(NO_SOLUTION)


@app.command(context_settings={"ignore_unknown_options": True})  # VALUES may begin with a minus sign
def sweep(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file.")],
    path: Annotated[
        str,
        typer.Argument(
            metavar="PATH", help="Field that changes: load, clearance.mean, operating_points.0.speed, ..."
        ),
    ],
    values: Annotated[
        str, typer.Argument(metavar="VALUES", help="'1 kN, 2 kN', or first:last:number, as '1 kN:10 kN:10'.")
    ],
    bearing: Annotated[
        str | None, typer.Option(metavar="NAME", help="One bearing of a machine; PATH begins at it.")
    ] = None,
    csv: Annotated[Path | None, typer.Option(metavar="OUT", help="Write all results as CSV, in SI units.")] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Draw the key results: OUT.png, OUT.svg or OUT.pdf.")
    ] = None,
) -> None:
    """Solve a case for several values of one field and print the key results."""
    from babbitt.cases.variation import case_variation
    from babbitt.report.progress import shown
    from babbitt.report.sweep_output import require_outputs, write_outputs
    from babbitt.report.sweep_table import print_sweep
    from babbitt.studies.case_sweep import sweep_case
    from babbitt.studies.sweep_values import values_of

    given = values_of(values)
    require_outputs(file, csv, plot)
    found = sweep_case(case_variation(file, path, bearing), given, shown(f"{file}: {path}"))
    print_sweep(found)
    write_outputs(found, csv, plot)
    if not found.solved:
        raise typer.Exit(NO_SOLUTION)


@app.command()
def export(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file with method: film.")],
    format_name: Annotated[
        str, typer.Option("--format", metavar="FORMAT", help="ross2, ross3, xltrc2, ansys, csv or json.")
    ],
    speeds: Annotated[
        str,
        typer.Option(
            metavar="SPEEDS", help="'500 rpm, 1000 rpm', or first:last:number, as '500 rpm:5000 rpm:10'."
        ),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="OUT", help="Where to write the table.")],
    bearing: Annotated[
        str | None, typer.Option(metavar="NAME", help="Which bearing, where the file has several.")
    ] = None,
    other_end: Annotated[
        bool,
        typer.Option(
            "--other-end",
            help="See the bearing from the other end of the shaft, where clockwise is counter-clockwise.",
        ),
    ] = False,
) -> None:
    """Write stiffness and damping over speed for a rotor program; the heat balance is closed at each speed."""
    from babbitt.cases import design_cases, load_case
    from babbitt.interop import export as write_table
    from babbitt.interop import mirrored
    from babbitt.interop.frame import declaration
    from babbitt.studies.coefficients import run_over_speed
    from babbitt.studies.speed_range import speeds_of
    from babbitt.studies.table_target import chosen_film, require_target

    film = chosen_film(design_cases(load_case(file)), file, bearing)
    require_target(format_name, film, file, output, other_end)
    run = run_over_speed(film, speeds_of(speeds))
    if run.unsolved:
        for speed, outcome in run.unsolved:
            print(f"{film.name}: {outcome.value} at {speed * 30.0 / math.pi:.0f} rpm", file=sys.stderr)
        print("nothing was written; leave these speeds out", file=sys.stderr)
        raise typer.Exit(NO_SOLUTION)
    table = mirrored(run.table()) if other_end else run.table()
    write_table(table, output, format_name)
    print(f"wrote {output}: {table.speeds.size} speeds; {declaration(table.frame)}", file=sys.stderr)


@app.command(name="list")
def list_(
    what: Annotated[str, typer.Argument(metavar="WHAT", help="lubricants, materials, kinds or cases.")],
) -> None:
    """Show what is on board, with sources."""
    from babbitt.report import listings

    show: dict[str, Callable[[], None]] = {
        "lubricants": listings.print_lubricants,
        "materials": listings.print_materials,
        "kinds": listings.print_kinds,
        "cases": listings.print_cases,
    }
    if what not in show:
        raise InputError("E005", f"nothing is listed under {what!r}; there are: {', '.join(show)}")
    show[what]()


@app.command()
def explain(code: Annotated[str, typer.Argument(metavar="CODE", help="Such as W101 or C104.")]) -> None:
    """Explain a code of an error, warning or check, and what to do about it."""
    from difflib import get_close_matches

    found = EXPLANATIONS.get(code.upper())
    if found is None:
        near = get_close_matches(code.upper(), EXPLANATIONS, n=1)
        hint = f"did you mean {near[0]}? " if near else ""
        raise InputError("E005", f"no code {code!r}; {hint}All: {', '.join(EXPLANATIONS)}")
    print(f"{code.upper()}  {found.title}\n\n{found.meaning}\n\nWhat to do: {found.remedy}")


@app.command()
def cite(file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file.")]) -> None:
    """Say what to cite for the methods that a case uses."""
    from babbitt.cases import load_case
    from babbitt.report.citations import citations_of

    print("\n\n".join(citations_of(load_case(file))))


def _write(path: Path, text: str) -> None:
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError("E007", f"cannot write {path}: {error.strerror}") from None
