"""Commands that calculate: solve, check, sweep, export."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, NOT_PASSED, AllowOutside, Files, System, Tongue, Units, app, reach
from babbitt.cli.interruption import INTERRUPTED, raised_interrupts
from babbitt.cli.upgrading import report_former_places
from babbitt.core.files.printing import printable
from babbitt.core.report_level import Level

if TYPE_CHECKING:
    from babbitt.case.case_file import CaseFile

__all__ = ["check", "export", "solve", "sweep"]


@app.command()
def solve(
    files: Files,
    json: Annotated[
        str | None, typer.Option(metavar="OUT", help="Write the results as JSON; - is standard output.")
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write the report: OUT.pdf or OUT.html.")
    ] = None,
    document: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FIELD=VALUE",
            help="With --report: a field of its title block, such as revision=B; once for each.",
        ),
    ] = None,
    report_level: Annotated[
        Level,
        typer.Option(
            help="summary: the machine alone; standard: inputs, results, checks and figures of every bearing; "
            "full: calculation and case file, too.",
        ),
    ] = Level.STANDARD,
    language: Annotated[
        Tongue | None,
        typer.Option(help="Of report and plots: English, German or Russian; else that of the case, else English."),
    ] = None,
    plots: Annotated[Path | None, typer.Option(metavar="DIR", help="Write the plots into a folder.")] = None,
    fields: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Write the fields of the films as NetCDF: OUT.nc.")
    ] = None,
    table: Annotated[
        Path | None,
        typer.Option(
            metavar="ROWS",
            help="Solve the bearings in the rows of a CSV file or workbook: columns such as 'diameter \\[mm]' "
            "take the place of fields of FILE.",
        ),
    ] = None,
    csv: Annotated[
        str | None,
        typer.Option(metavar="OUT", help="With --table: write inputs and results; - is standard output."),
    ] = None,
    xlsx: Annotated[
        Path | None,
        typer.Option(metavar="OUT", help="With --table: write inputs, results and summary: OUT.xlsx."),
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(metavar="N", help="With --table: processes. By default one a core.", min=1),
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 on fail or no verdict.")] = False,
    units: Units = System.SI,
    allow_outside: AllowOutside = False,
) -> None:
    """Solve the bearings of case files, or those in the rows of a table, and print a table."""
    if table is not None or csv is not None or xlsx is not None or workers is not None:
        from babbitt.cli.solving_table import require_table, solve_rows

        unread: dict[str, object] = {"--json": json, "--plots": plots, "--fields": fields, "--document": document}
        rows = require_table(table, files, unread)
        solve_rows(files[0], rows, (csv, xlsx, report), workers, strict, reach(allow_outside), units, language)
        return
    from babbitt.case import CaseError, Problem, load_cases, located
    from babbitt.core.notices import InputError
    from babbitt.core.quantities import displayed_in
    from babbitt.report import outputs, print_machine
    from babbitt.report.progress import shown
    from babbitt.solving import solve as solve_case

    cases = load_cases(files, reach(allow_outside))  # every problem of every file first; nothing is written before
    cases = _with_title_blocks(cases, document, report)
    tables = [table for case in cases for table in case.files]
    plan = outputs(files, json, report, plots, fields, tables, report_level, units, language)
    if report is not None or plots is not None:
        from babbitt.report.languages import chosen_language

        for case in cases:
            chosen_language(case.title_block, [case.kind], language)
    elif language is not None:
        raise InputError(
            "E007", "--language is of report and plots, and there are none; add --report OUT.pdf or --plots DIR"
        )
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
        with displayed_in(units):
            for machine in machines:
                print_machine(machine)
    if problems:
        raise CaseError(problems)
    if not all(machine.solved for machine in machines):
        raise typer.Exit(NO_SOLUTION)
    if strict and not all(machine.within_limits for machine in machines):
        raise typer.Exit(NOT_PASSED)


def _with_title_blocks(
    cases: tuple[CaseFile, ...], document: list[str] | None, report: Path | None
) -> tuple[CaseFile, ...]:
    """The cases with what the command line says of their reports."""
    if not document:
        return cases
    from babbitt.core.notices import InputError
    from babbitt.report.title_block import title_block_of_options

    if report is None:
        raise InputError("E007", "--document is of a report, and there is none; add --report OUT.pdf")
    blocks = [title_block_of_options(case.title_block, document) for case in cases]
    return tuple(case.with_title_block(block) for case, block in zip(cases, blocks, strict=True))


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
            from babbitt.study.plan import require_possible

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
    fields: Annotated[
        list[str],
        typer.Argument(
            metavar="PATH VALUES ...",
            help="Fields that change, such as load or clearance.mean, or '*.speed' (by one share wherever it "
            "stands: '0.5:1.5:5'), each with its values: '1 kN, 2 kN', "
            "first:last:number as '1 kN:10 kN:10', or at equal ratios '1 kN:100 kN:7:log'.",
        ),
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
    engineering: Annotated[
        bool, typer.Option("--engineering", help="Write them in the units of the table, such as µm and °C.")
    ] = False,
    columns: Annotated[
        str | None,
        typer.Option(metavar="NAMES", help="Results in table, files and plot: 'friction_power, total_flow'."),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="OUT", help="Draw the key results: OUT.png, OUT.svg or OUT.pdf.")
    ] = None,
    workers: Annotated[int, typer.Option(metavar="N", help="Processes of this machine.", min=1)] = 1,
    units: Units = System.SI,
    allow_outside: AllowOutside = False,
) -> None:
    """Solve a case for several values of some fields and print the key results."""
    from babbitt.core.notices import InputError
    from babbitt.core.quantities import displayed_in
    from babbitt.report.outputs import STANDARD_OUTPUT
    from babbitt.report.study_progress import StudyProgress
    from babbitt.report.sweep_output import require_outputs, write_outputs
    from babbitt.report.sweep_table import in_engineers_units, in_si, print_sweep
    from babbitt.study.case_sweep import sweep_case, varied_in
    from babbitt.study.sweep_values import values_of
    from babbitt.study.workers import Alone, Processes

    if unknown := [one for one in fields if one.startswith("--")]:
        raise InputError(
            "E005",
            f"sweep has no option {unknown[0]}; PATH and VALUES stand one after the other, "
            "such as: load '1 kN:10 kN:10' (babbitt sweep --help lists the options)",
        )
    if len(fields) % 2:
        raise InputError("E005", f"sweep takes each PATH with its VALUES; '{fields[-1]}' has none")
    given = [values_of(values) for values in fields[1::2]]
    variations = [varied_in(file, path, bearing, reach(allow_outside)) for path in fields[::2]]
    chosen = [name.strip() for name in columns.split(",")] if columns is not None else []
    require_outputs(variations[0], csv, plot, chosen)
    try:
        with raised_interrupts(), StudyProgress(f"{printable(file)}: {', '.join(fields[::2])}") as watch:
            hands = Alone() if workers == 1 else Processes(workers)
            found = sweep_case(list(zip(variations, given, strict=True)), hands, watch)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        raise typer.Exit(INTERRUPTED) from None
    with displayed_in(units):
        write_outputs(found, csv, plot, in_engineers_units if engineering else in_si, chosen)
        if str(csv) != STANDARD_OUTPUT:
            print_sweep(found, chosen=chosen)
    if found.interrupted:
        done = len(found.answers) + len(found.refused)
        print(f"interrupted; {done} of {found.count} values are kept", file=sys.stderr)
        raise typer.Exit(INTERRUPTED)
    if not found.solved:
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
    from babbitt.export import export as write_table
    from babbitt.export import mirrored
    from babbitt.export.frame import declaration
    from babbitt.report.outputs import inputs_of
    from babbitt.report.questioned_coefficients import left_out_lines, table_lines
    from babbitt.study.speed_range import speeds_of
    from babbitt.study.table_target import chosen_problem, require_target

    case = load_case(file, reach(allow_outside))
    report_former_places(file, case)
    problem, method = chosen_problem(case, file, bearing)
    taken = speeds_of(speeds)
    name, clockwise = problem.name, method.is_clockwise(problem)
    require_target(format_name, name, clockwise, inputs_of([file], case.files), output, other_end, taken)
    run = method.coefficients_over_speed(problem, taken)
    failed = left_out_lines(run)
    for line in failed:
        print(f"{printable(name)}: {line}", file=sys.stderr)
    if len(failed) == len(run.solutions):
        print("nothing was written", file=sys.stderr)
        raise typer.Exit(NO_SOLUTION)
    table = mirrored(run.table()) if other_end else run.table()
    write_table(table, output, format_name)
    speeds_written = f"{table.speeds.size} speed{'s' if table.speeds.size > 1 else ''}"
    print(
        f"wrote {printable(output)}: {speeds_written}; {declaration(table.frame)}; "
        f"temperatures: {table.temperatures}",
        file=sys.stderr,
    )
    for line in table_lines(table, format_name):
        print(line, file=sys.stderr)
    if failed:
        raise typer.Exit(NO_SOLUTION)
