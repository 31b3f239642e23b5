"""The answers of a sweep as a table on the screen and as CSV."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from babbitt.core.files.spreadsheet import Cell, rows_text
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result, Verdict
from babbitt.export.unit_names import static_column
from babbitt.report.bearing_table import STYLES, engineers_table
from babbitt.report.columns import Column, footnote
from babbitt.report.findings import not_checked
from babbitt.report.sweep_columns import sweep_columns
from babbitt.report.table import console_for, fitting, measured
from babbitt.report.text import plain_text
from babbitt.report.verdict import missed_codes
from babbitt.study.case_sweep import CaseSweep

REFUSED = "refused"
NOT_REPORTED = ("wall_time", "iterations")
"""Results about the run, which differ from run to run."""


def print_sweep(sweep: CaseSweep, to: Console | None = None) -> None:
    """Print one line a value and bearing: the key results in the engineer's units, the verdict and its codes.

    A verdict counts only what was checked, so the checks that were not made stand below.
    """
    rows = list(sweep.rows())
    results = [result for _, result in rows]
    every = sweep_columns(results)
    to = to or console_for(_table(sweep, every))
    columns, hidden = fitting(every, results, to.width - measured(_table(sweep, ())).minimum)
    to.print(_table(sweep, columns))
    if said := footnote(columns, results):
        to.print(Text(said, style="dim"))
    if hidden:
        to.print(
            Text(f"Left out for want of width: {', '.join(column.heading for column in hidden)}", style="dim")
        )
    for place, result in rows:
        if result.verdict is Verdict.NO_SOLUTION:
            to.print(Text(f"{sweep.path} {sweep.values.texts[place]}, {result.name}: {result.outcome.value}"))
    for group in not_checked(results):
        to.print(Text(f"Not checked: {group.code}  {group.title}: {group.message}"))
    for reason in sweep.refused.values():
        to.print(Text(plain_text(reason)))


def _table(sweep: CaseSweep, columns: Sequence[Column]) -> Table:
    """A row for each value and bearing: the field, some columns, the verdict and its codes."""
    rows = list(sweep.rows())
    results = [result for _, result in rows]
    named, shown = len(sweep.names) > 1, _shown(sweep)
    table = engineers_table(title=Text(plain_text(sweep.machines[0].name), style="bold"), title_justify="left")
    table.add_column(Text(f"{sweep.path}\n{sweep.values.unit_shown}"), justify="right", no_wrap=True)
    if named:
        table.add_column(Text("Bearing"), overflow="fold")
    for column in columns:
        table.add_column(Text(f"{column.heading}\n{column.unit}"), justify="right", no_wrap=True)
    table.add_column(Text("verdict"), no_wrap=True)
    codes = [codes_of(result) for result in results]
    coded = any(codes)
    if coded:
        table.add_column(Text("codes"), overflow="fold")
    cells = list(zip(*(column.cells(results) for column in columns), strict=True)) or [()] * len(results)
    answered = zip(rows, cells, codes, strict=True)
    lines = [
        (place, result.name, line, result.verdict.value, STYLES[result.verdict], said)
        for (place, result), line, said in answered
    ]
    none = ("",) * len(columns)
    lines += [(place, "", none, REFUSED, STYLES[Verdict.NO_SOLUTION], ()) for place in sweep.refused]
    for place, bearing, line, word, style, said in sorted(lines, key=lambda one: one[0]):
        name = (Text(plain_text(bearing)),) if named else ()
        table.add_row(
            Text(plain_text(shown[place])),
            *name,
            *map(Text, line),
            Text(word, style=style),
            *_cell_of(said, coded),
        )
    return table


def codes_of(result: Result) -> tuple[str, ...]:
    """Codes on which the verdict of a result rests: how it ended, its missed limits, and what questions it."""
    ended = [] if result.outcome.solved else [result.outcome.code]
    return tuple(dict.fromkeys([*ended, *missed_codes(result), *result.questioning_codes]))


def _cell_of(codes: Sequence[str], shown: bool) -> tuple[Text, ...]:
    return (Text(" ".join(codes)),) if shown else ()


def sweep_csv(sweep: CaseSweep) -> str:
    """The answers as CSV in UTF-8, with comma and decimal point: `sweep_rows`, in which no word is a formula."""
    return rows_text(sweep_rows(sweep))


def sweep_rows(sweep: CaseSweep) -> list[list[Cell]]:
    """The answers as rows: one a value and bearing, results in SI with the unit in every column name.

    The first row names the columns. The first column is the field; its unit, where the values have one, stands in
    its name. A row without an operating point has no results; the status of a value that the case does not take is
    ``refused``. The last column names the codes on which the verdict rests.
    """
    rows = list(sweep.rows())
    quantities = dict.fromkeys(
        name
        for _, result in rows
        if result.outcome.solved
        for name in result.values
        if name in QUANTITIES and name not in NOT_REPORTED
    )
    unit = f" [{sweep.values.unit}]" if sweep.values.unit and sweep.values.numbers is not None else ""
    heading: list[Cell] = [f"{sweep.path}{unit}", "bearing", "status"]
    heading += [*(static_column(name) for name in quantities), "codes"]
    exact = sweep.values.numbers
    given: Sequence[Cell] = sweep.values.texts if exact is None else [float(f"{number:.12g}") for number in exact]
    lines: list[tuple[int, list[Cell]]] = [
        (place, [given[place], None, REFUSED, *([None] * len(quantities)), None]) for place in sweep.refused
    ]
    for place, result in rows:
        solved = result.outcome.solved
        numbers = [result.values.get(name, math.nan) if solved else math.nan for name in quantities]
        values = [float(number) if math.isfinite(number) else None for number in numbers]
        lines.append(
            (
                place,
                [
                    given[place],
                    result.name,
                    result.outcome.name.lower(),
                    *values,
                    " ".join(codes_of(result)) or None,
                ],
            )
        )
    return [heading, *(line for _, line in sorted(lines, key=lambda one: one[0]))]


def _shown(sweep: CaseSweep) -> tuple[str, ...]:
    """Values without their unit, which stands in the heading; words as they are."""
    numbers = sweep.values.numbers
    return sweep.values.texts if numbers is None else tuple(f"{number:.6g}" for number in numbers)
