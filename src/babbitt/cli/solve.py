"""Commands that calculate: solve, check, sweep, size, export."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, NOT_PASSED, AllowOutside, Files, app, reach
from babbitt.cli.interruption import INTERRUPTED, raised_interrupts
from babbitt.cli.upgrading import report_former_places
from babbitt.core.files.printing import printable

__all__ = ["check", "export", "size", "solve", "sweep"]


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
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 on fail or no verdict.")] = False,
    allow_outside: AllowOutside = False,
) -> None:
    """Solve the bearings of case files and print a table."""
    from babbitt.case import CaseError, Problem, load_cases, located
    from babbitt.core.notices import InputError
    from babbitt.report import outputs, print_machine
    from babbitt.report.progress import shown
    from babbitt.solving import solve as solve_case

    cases = load_cases(files, reach(allow_outside))  # every problem of every file first; nothing is written before
    plan = outputs(files, json, report, plots, fields, [table for case in cases for table in case.files])
    if fields is not None:
        from babbitt.report.fields import require_films

        for path, case in zip(files, cases, strict=True):
            require_films(str(path), case)
    for path, case in zip(files, cases, strict=True):
        report_former_places(path, case)
    machines, targets = [], []
    problems: list[Problem] = []
    for path, case, target in zip(files, cases, plan.targets, strict=True):
        try:
            machines.append(solve_case(case, shown(f"{case.name}: cycles of the orbit")))
            targets.append(target)
        except InputError as error:  # the other files of the run are solved all the same
            problems += located(error, case, path).problems
    for machine, target in zip(machines, targets, strict=True):
        target.write(machine)  # before anything is printed: whoever reads the table may stop reading
    if not plan.silent:
        for machine in machines:
            print_machine(machine)
    if problems:
        raise CaseError(problems)
    if not all(machine.solved for machine in machines):
        raise typer.Exit(NO_SOLUTION)
    if strict and not all(machine.within_limits for machine in machines):
        raise typer.Exit(NOT_PASSED)


@app.command()
def check(files: Files, allow_outside: AllowOutside = False) -> None:
    """Validate case files: every problem at once, and all that `solve` would refuse."""
    from babbitt.case import CaseError, Problem, located
    from babbitt.case.study_file import load_case_or_study
    from babbitt.case.upgrade import former_places
    from babbitt.solving import refusal_of

    problems: list[Problem] = []
    for path in files:
        try:
            read = load_case_or_study(path, reach(allow_outside))
        except CaseError as error:
            problems += error.problems
            continue
        case = read.case
        if (refusal := refusal_of(case)) is not None:
            problems += located(refusal, case, path).problems
            continue
        studied = ""
        if read.study is not None:
            from babbitt.core.notices import InputError
            from babbitt.study.study import require_possible

            try:
                _, rows = require_possible(case, read.study)
            except InputError as error:
                problems += located(error, case, path).problems
                continue
            studied = f", study of kind {read.study.kind}, {rows} rows"
        problems_to_solve = case.problems()
        count = len(problems_to_solve)
        print(
            f"{printable(path)}: usable, kind {case.kind}"
            + (f", {count} calculation{'s' * (count > 1)}" if count else "")
            + studied
        )
        for said in dict.fromkeys(
            f"{warning.code} {warning.message}" for problem in problems_to_solve for warning in problem.warnings
        ):
            print(f"  {said}")
        for place in former_places(case):
            print(f"  {place} (`babbitt upgrade` moves it)")
    if problems:
        raise CaseError(problems)


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
    csv: Annotated[
        Path | None,
        typer.Option(
            metavar="OUT",
            help="Write all results in SI: OUT.csv or OUT.xlsx; - is standard output, as CSV.",
        ),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Draw the key results: OUT.png, OUT.svg or OUT.pdf.")
    ] = None,
    allow_outside: AllowOutside = False,
) -> None:
    """Solve a case for several values of one field and print the key results."""
    from babbitt.case.variation import case_variation
    from babbitt.report.outputs import STANDARD_OUTPUT
    from babbitt.report.progress import shown
    from babbitt.report.sweep_output import require_outputs, write_outputs
    from babbitt.report.sweep_table import print_sweep
    from babbitt.study.case_sweep import sweep_case
    from babbitt.study.sweep_values import values_of

    given = values_of(values)
    variation = case_variation(file, path, bearing, reach(allow_outside))
    require_outputs(variation, csv, plot)
    try:
        with raised_interrupts():
            found = sweep_case(variation, given, shown(f"{printable(file)}: {path}"))
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        raise typer.Exit(INTERRUPTED) from None
    write_outputs(found, csv, plot)
    if str(csv) != STANDARD_OUTPUT:
        print_sweep(found)
    if found.interrupted:
        print(f"interrupted; {len(found.places)} of {len(given.texts)} values are kept", file=sys.stderr)
        raise typer.Exit(INTERRUPTED)
    if not found.solved:
        raise typer.Exit(NO_SOLUTION)


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
    plot: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Draw the least margin: OUT.png, OUT.svg or OUT.pdf.")
    ] = None,
    allow_outside: AllowOutside = False,
) -> None:
    """Find the values of a field that keep all limits: every interval, and the check that ends it."""
    from babbitt.case.variation import case_variation
    from babbitt.report.progress import shown
    from babbitt.report.size_output import require_size_outputs, write_size
    from babbitt.report.size_table import print_choices, print_size
    from babbitt.study.size import find_size
    from babbitt.study.size_choices import Choices, appraise_choices, preferred_numbers, standard_choices
    from babbitt.study.size_range import range_of

    variation = case_variation(file, path, bearing, reach(allow_outside))
    require_size_outputs(variation, json, plot)
    counted = tuple(one.strip() for one in limits.split(","))
    progress = shown(f"{printable(file)}: {path}")
    words = tuple(one.strip() for one in among.split(",")) if among else standard_choices(path)
    try:
        with raised_interrupts():
            held: Choices | None
            if words:
                held = appraise_choices(variation, words, counted, over_tolerance, progress)
                print_choices(held)
                if not any(one.permitted for one in held.appraisals.values()):
                    raise typer.Exit(NO_SOLUTION)
                return
            scan = range_of(variation, first, last, points)
            found = find_size(variation, scan, counted, over_tolerance, progress)
            numbers = preferred_numbers(found) if preferred else ()
            texts = [str(scan.given(one)) for one in numbers]
            held = appraise_choices(variation, texts, counted, over_tolerance) if texts else None
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        raise typer.Exit(INTERRUPTED) from None
    write_size(found, json, plot)
    print_size(found)
    if held is not None:
        print_choices(held)
    if not found.intervals:
        raise typer.Exit(NO_SOLUTION)


@app.command()
def export(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="A case file with method: film, or of tilting pads.")
    ],
    format_name: Annotated[
        str,
        typer.Option(
            "--format",
            metavar="FORMAT",
            help="ross2 (.json or .toml), ross3 (.json or .toml), xltrc2 (.csv or .xlsx), ansys (.txt), "
            "csv (.csv) or json (.json); the ending is that of OUT. Of tilting pads ross3, csv and "
            "json hold coefficients over frequency, too, csv and json the matrices of journal and pads.",
        ),
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
    allow_outside: AllowOutside = False,
) -> None:
    """Write stiffness and damping over speed for a rotor program; the heat balance is closed at each speed."""
    from babbitt.case import load_case
    from babbitt.export import OVER_FREQUENCY, mirrored
    from babbitt.export import export as write_table
    from babbitt.export.frame import declaration
    from babbitt.report.outputs import inputs_of
    from babbitt.report.questioned_coefficients import warnings_lines
    from babbitt.study.speed_range import speeds_of
    from babbitt.study.table_target import chosen_problem, require_target

    case = load_case(file, reach(allow_outside))
    report_former_places(file, case)
    problem, method = chosen_problem(case, file, bearing)
    taken = speeds_of(speeds)
    name, clockwise = problem.name, method.is_clockwise(problem)
    require_target(format_name, name, clockwise, inputs_of([file], case.files), output, other_end, taken)
    run = method.coefficients_over_speed(problem, taken)
    failed = [(speed, outcome.value) for speed, outcome in run.unsolved]
    failed += [(speed, "no stiffness with following temperatures") for speed in run.unfollowed]
    if failed:
        for speed, why in failed:
            print(f"{printable(name)}: {why} at {speed * 30.0 / math.pi:.0f} rpm", file=sys.stderr)
        print("nothing was written; leave these speeds out", file=sys.stderr)
        raise typer.Exit(NO_SOLUTION)
    table = mirrored(run.table()) if other_end else run.table()
    write_table(table, output, format_name)
    speeds_written = f"{table.speeds.size} speed{'s' if table.speeds.size > 1 else ''}"
    print(
        f"wrote {printable(output)}: {speeds_written}; {declaration(table.frame)}; "
        f"temperatures: {table.temperatures}",
        file=sys.stderr,
    )
    for line in warnings_lines(table):
        print(line, file=sys.stderr)
    if table.over_frequency is not None and format_name not in OVER_FREQUENCY:
        print(
            f"{format_name} has no axis of frequency: the coefficients written are synchronous; ross3, csv and "
            "json hold them over frequency, too",
            file=sys.stderr,
        )
    if "following" in table.temperatures:
        print(
            "the stiffness holds for slow changes; for whirl and vibration export with "
            "temperature_coefficients: frozen",
            file=sys.stderr,
        )
