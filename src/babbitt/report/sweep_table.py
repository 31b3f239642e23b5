"""The answers of a sweep as a table on the screen and as CSV."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from babbitt.core.check_text import margin
from babbitt.core.files.spreadsheet import Cell
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result, Verdict
from babbitt.export.unit_names import static_column
from babbitt.report.bearing_table import STYLES, engineers_table
from babbitt.report.columns import ABSENT, Column, column_of, footnote
from babbitt.report.findings import not_checked
from babbitt.report.study_values import check_title
from babbitt.report.sweep_columns import sweep_columns
from babbitt.report.table import NAME_WIDTH, console_for, fitting, measured
from babbitt.report.text import plain_text
from babbitt.report.verdict import missed_codes
from babbitt.study.case_sweep import CaseSweep, SweptField

REFUSED = "refused"
NOT_REPORTED = ("wall_time", "iterations")
"""Results about the run, which differ from run to run."""


def print_sweep(sweep: CaseSweep, to: Console | None = None, chosen: Sequence[str] = ()) -> None:
    """Print one line a row and bearing: results in the engineer's units, margin, governing check, verdict, codes.

    What the codes mean stands below, and the checks that were not made, since a verdict counts only those made.

    Parameters
    ----------
    sweep : CaseSweep
    to : Console, optional
    chosen : sequence of str
        Quantities that are shown; the key results if none are named.
    """
    rows = list(sweep.rows())
    results = [result for _, result in rows]
    every = tuple(column_of(name, 1) for name in chosen) or sweep_columns(results)
    to = to or console_for(_table(sweep, every))
    columns, hidden = fitting(every, results, to.width - measured(_table(sweep, ())).minimum)
    to.print(_table(sweep, columns))
    if said := footnote(columns, results):
        to.print(Text(said, style="dim"))
    if hidden:
        to.print(
            Text(f"Left out for want of width: {', '.join(column.heading for column in hidden)}", style="dim")
        )
    if codes := dict.fromkeys(code for result in results for code in codes_of(result)):
        to.print(Text("; ".join(map(check_title, codes)), style="dim"))
    for row, result in rows:
        if result.verdict is Verdict.NO_SOLUTION:
            of = zip(sweep.fields, sweep.texts(row), strict=True)
            where = ", ".join(f"{field.path} {text}" for field, text in of)
            to.print(Text(f"{where}, {result.name}: {result.outcome.value}"))
    for group in not_checked(results):
        to.print(Text(f"Not checked: {group.code}  {group.title}: {group.message}"))
    for reason in sweep.refused.values():
        to.print(Text(plain_text(reason)))


def _table(sweep: CaseSweep, columns: Sequence[Column]) -> Table:
    """A row for each row and bearing: the fields, some columns, margin, governing check, verdict and its codes."""
    rows = list(sweep.rows())
    results = [result for _, result in rows]
    named = len(sweep.names) > 1
    table = engineers_table(title=Text(plain_text(sweep.name), style="bold"), title_justify="left")
    for field in sweep.fields:
        table.add_column(Text(f"{field.path}\n{field.values.unit_shown}"), justify="right", no_wrap=True)
    if named:
        longest = max(len(plain_text(name)) for name in sweep.names)
        table.add_column(Text("Bearing"), overflow="fold", min_width=min(longest, NAME_WIDTH))
    for column in columns:
        table.add_column(Text(f"{column.heading}\n{column.unit}"), justify="right", no_wrap=True)
    judged = any(result.governing_check is not None for result in results)
    if judged:
        table.add_column(Text("margin"), justify="right", no_wrap=True)
        table.add_column(Text("by"), no_wrap=True)
    table.add_column(Text("verdict"), no_wrap=True)
    codes = [codes_of(result) for result in results]
    coded = any(codes)
    if coded:
        table.add_column(Text("codes"), overflow="fold")
    cells = list(zip(*(column.cells(results) for column in columns), strict=True)) or [()] * len(results)
    lines = [
        (
            row,
            result.name,
            (*line, *_governing(result, judged)),
            result.verdict.value,
            STYLES[result.verdict],
            said,
        )
        for (row, result), line, said in zip(rows, cells, codes, strict=True)
    ]
    none = ("",) * (len(columns) + 2 * judged)
    lines += [(row, "", none, REFUSED, STYLES[Verdict.NO_SOLUTION], ()) for row in sweep.refused]
    for row, bearing, line, word, style, said in sorted(lines, key=lambda one: one[0]):
        table.add_row(
            *(Text(plain_text(text)) for text in _shown(sweep, row)),
            *((Text(plain_text(bearing)),) if named else ()),
            *map(Text, line),
            Text(word, style=style),
            *((Text(" ".join(said)),) if coded else ()),
        )
    return table


def _governing(result: Result, shown: bool) -> tuple[str, ...]:
    """Margin and code of the governing check."""
    check = result.governing_check
    return () if not shown else (ABSENT, "") if check is None else (margin(check), check.code)


def codes_of(result: Result) -> tuple[str, ...]:
    """Codes on which the verdict of a result rests: how it ended, its missed limits, and what questions it."""
    ended = [] if result.outcome.solved else [result.outcome.code]
    return tuple(dict.fromkeys([*ended, *missed_codes(result), *result.questioning_codes]))


Units = Callable[[str], tuple[str, Callable[[float], float]]]
"""By the name of a quantity the heading of its column, and how a value in SI stands in it."""


def in_si(name: str) -> tuple[str, Callable[[float], float]]:
    """Columns in SI, the unit in their name.

    >>> in_si("load")[0], in_engineers_units("load")[0], in_engineers_units("load")[1](12e3)
    ('load_N', 'load [kN]', 12.0)
    """
    return static_column(name), float


def in_engineers_units(name: str) -> tuple[str, Callable[[float], float]]:
    """Columns in the units of tables and reports."""
    label = QUANTITIES[name].display.label
    return f"{name} [{label}]" if label else name, QUANTITIES[name].shown


def sweep_rows(sweep: CaseSweep, units: Units = in_si, chosen: Sequence[str] = ()) -> list[list[Cell]]:
    """The answers as rows: one a row and bearing, results with the unit in every column name.

    The first row names the columns. The first columns are the fields; their unit, where the values have one,
    stands in their name. A row without an operating point has no results; the status of one that the case does not
    take is ``refused``. The last columns are the verdict, the governing check, its margin (a share of the limit),
    and the codes on which the verdict rests. A result that a field says already is left out.

    Parameters
    ----------
    sweep : CaseSweep
    units : callable
        `in_si` or `in_engineers_units`.
    chosen : sequence of str
        Quantities that are written; all if none are named.
    """
    rows = list(sweep.rows())
    quantities = tuple(chosen) or tuple(
        dict.fromkeys(
            name
            for _, result in rows
            if result.outcome.solved
            for name in result.values
            if name in QUANTITIES and name not in NOT_REPORTED
        )
    )
    fields = [_field_heading(field) for field in sweep.fields]
    columns = {name: column for name in quantities if (column := units(name))[0] not in fields}
    heading: list[Cell] = [*fields, "bearing", "status"]
    heading += [*(title for title, _ in columns.values()), "verdict", "governing_check", "margin", "codes"]
    lines: list[tuple[int, list[Cell]]] = [
        (row, [*_given(sweep, row), None, REFUSED, *([None] * (len(columns) + 4))]) for row in sweep.refused
    ]
    for row, result in rows:
        solved = result.outcome.solved
        numbers = [result.values.get(name, math.nan) if solved else math.nan for name in columns]
        values = zip(numbers, columns.values(), strict=True)
        check = result.governing_check
        cells: list[Cell] = [
            *_given(sweep, row),
            result.name,
            result.outcome.name.lower(),
            *(in_unit(number) if math.isfinite(number) else None for number, (_, in_unit) in values),
            result.verdict.key,
            None if check is None else check.code,
            float(result.margin) if math.isfinite(result.margin) else None,
            " ".join(codes_of(result)) or None,
        ]
        lines.append((row, cells))
    return [heading, *(line for _, line in sorted(lines, key=lambda one: one[0]))]


def _field_heading(field: SweptField) -> str:
    values = field.values
    return f"{field.path} [{values.unit}]" if values.unit and values.numbers is not None else field.path


def _given(sweep: CaseSweep, row: int) -> list[Cell]:
    """The values of a row, numbers as numbers."""
    cells: list[Cell] = []
    for field, place in zip(sweep.fields, sweep.places(row), strict=True):
        exact = field.values.numbers
        cells.append(field.values.texts[place] if exact is None else float(f"{exact[place]:.12g}"))
    return cells


def _shown(sweep: CaseSweep, row: int) -> tuple[str, ...]:
    """Values without their unit, which stands in the heading; words as they are."""
    of = zip(sweep.fields, sweep.places(row), strict=True)
    return tuple(
        field.values.texts[place] if field.values.numbers is None else f"{field.values.numbers[place]:.6g}"
        for field, place in of
    )
