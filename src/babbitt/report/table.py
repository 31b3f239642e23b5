"""What the terminal shows: the machine at a glance or one bearing in full, then misses and warnings."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from io import StringIO
from shutil import get_terminal_size
from typing import TYPE_CHECKING, Any

from rich.cells import cell_len
from rich.console import Console, Group, RenderableType
from rich.measure import Measurement
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from babbitt.core.files.printing import nearest_letters
from babbitt.core.result import Result
from babbitt.report import findings
from babbitt.report.bearing_table import STYLES, bearing_table, engineers_table
from babbitt.report.columns import ABSENT, Column, footnote
from babbitt.report.machine_table import columns_of, counted_parts, in_machine_table
from babbitt.report.text import plain_text
from babbitt.report.totals import totals
from babbitt.report.us_words import OF_RESULTS, in_us_units
from babbitt.report.view import view_of

if TYPE_CHECKING:
    from babbitt.solving import MachineResult

PIPED_WIDTH = 140
"""Columns written when standard output is a file or a pipe and has no width of its own."""

ENDLESS = 10_000
"""Columns on which a table is as wide as it would like to be."""

NARROWEST = 40
"""And never fewer than these, whatever the terminal says of itself."""

NAME_WIDTH = 18
"""The name column wraps rather than let a column of numbers go, down to this width."""

NAME_LIMIT = 48
"""And never wider than this, however long a name is."""

GAP = 2
"""Columns between two columns of the table."""

NOT_CHECKED = "not made"
"""Heading of the column that counts checks for which data are missing."""


def console(width: int | None = None) -> Console:
    """Rich console on standard output; colours as the terminal and ``NO_COLOR`` have it.

    Parameters
    ----------
    width : int, optional
        Columns; the terminal's own when omitted, and `PIPED_WIDTH` where there is no terminal.
    """
    nearest_letters(sys.stdout)  # an old code page without ψ must not end in a traceback
    if width is None:
        width = max(get_terminal_size((PIPED_WIDTH, 25)).columns, NARROWEST)
    return Console(width=width, highlight=False)


def console_for(table: Table) -> Console:
    """The console of `console`; where there is no terminal, one on which a table keeps all its columns."""
    piped = get_terminal_size((0, 0)).columns == 0
    return console(max(PIPED_WIDTH, measured(table).maximum) if piped else None)


def measured(table: Table) -> Measurement:
    """Columns of text that a table needs, and those it would like."""
    endless = Console(width=ENDLESS, file=StringIO(), color_system=None)
    return Measurement.get(endless, endless.options, table)


def print_machine(machine: MachineResult, to: Console | None = None) -> None:
    """Print what an engineer reads first: all bearings in a table, or one bearing in full."""
    if to is None:
        rows = [result for result in machine.results if in_machine_table(result)]
        to = console_for(_machine_table(machine.name, rows, columns_of(rows)) if len(rows) > 1 else Table())
    to.print(render(machine.name, machine.results, to.width))


def render(name: str, results: Sequence[Result], width: int) -> RenderableType:
    """The table of a machine, or of one bearing, with the warnings below it.

    Parameters
    ----------
    name : str
        Of the machine.
    results : sequence of Result
    width : int
        Columns at hand.
    """
    results = tuple(results)
    rows = [result for result in results if in_machine_table(result)]
    parts: list[RenderableType] = []
    of_states = view_of(results[0]).state_table if results else None
    if of_states is not None:
        parts.append(of_states(results))
    elif len(results) == 1 or not rows:
        parts += [bearing_table(result) for result in results]
    else:
        parts.append(_machine(name, rows, width))
        parts += [bearing_table(result) for result in results if result not in rows]
    parts += [
        part
        for result in results
        for data in view_of(result).terminal_tables(result)
        for part in (Text(), terminal_table(in_us_units(data, OF_RESULTS), plain_text(result.name)))
    ]
    said = [
        in_us_units(sentence, OF_RESULTS) for result in results for sentence in view_of(result).sentences(result)
    ]
    parts += [Text(), *(Padding(Text(sentence), (0, 0, 0, 2)) for sentence in said)] if said else []
    parts += _remarks(results)
    return Group(*parts)


def _machine(name: str, results: Sequence[Result], width: int) -> RenderableType:
    bare = _machine_table(name, results, ())
    shown, hidden = fitting(columns_of(results), results, width - measured(bare).minimum)
    parts: list[RenderableType] = [_machine_table(name, results, shown)]
    if said := footnote(shown, results):
        parts.append(Text(said, style="dim"))
    if hidden:
        names = ", ".join(column.heading for column in hidden)
        parts.append(Text(f"Left out for want of width: {names}", style="dim"))
    summed = totals(results)
    if summed is not None:
        parts.append(Text(f"\n{summed.sentence}"))
    return Group(*parts)


def _machine_table(name: str, results: Sequence[Result], shown: Sequence[Column]) -> Table:
    """A row for each bearing: its name, some columns, its verdict, and how many checks were not made."""
    incomplete = any(result.not_checked for result in results)
    table = engineers_table(title=Text(plain_text(name), style="bold"), title_justify="left")
    table.add_column(
        Text("Bearing"), overflow="fold", min_width=min(NAME_WIDTH, _longest_name(results)), max_width=NAME_LIMIT
    )
    for column in shown:
        table.add_column(Text(f"{column.heading}\n{column.unit}"), justify="right", no_wrap=True)
    table.add_column(Text("verdict"), no_wrap=True)
    if incomplete:
        table.add_column(Text(f"checks\n{NOT_CHECKED}"), justify="right", no_wrap=True)
    rows = zip(*(column.cells(results) for column in shown), strict=True) if shown else ((),) * len(results)
    for result, cells in zip(results, rows, strict=True):
        word = result.verdict
        missing = [Text(str(len(result.not_checked)) if result.not_checked else "")] if incomplete else []
        name_and_cells = (Text(plain_text(result.name)), *map(Text, cells))
        table.add_row(*name_and_cells, Text(word.value, style=STYLES[word]), *missing)
    return table


def fitting(columns: Sequence[Column], results: Sequence[Result], width: int) -> tuple[list[Column], list[Column]]:
    """Columns that fit into a width, each with the gap before it, and those that do not."""
    shown = list(columns)

    def needed() -> int:
        return sum(_column_width(column, results) + GAP for column in shown)

    while shown and needed() > width:
        loosest = max(shown, key=lambda column: column.rank)
        if loosest.rank == 0:
            break
        shown.remove(loosest)
    return shown, [column for column in columns if column not in shown]


def _column_width(column: Column, results: Sequence[Result]) -> int:
    return max(len(text) for text in (column.heading, column.unit, *column.cells(results)))


def _longest_name(results: Sequence[Result]) -> int:
    return max(cell_len(plain_text(result.name)) for result in results)


def terminal_table(data: Mapping[str, Any], name: str) -> Table:
    """A table of `plain_tables` of the bearing of a name; its note stands below where a number is absent."""
    table = engineers_table(title=Text(f"{data['title']}: {name}", style="bold"), title_justify="left")
    if any(ABSENT in row for row in data["rows"]):
        table.caption, table.caption_justify = Text(data["note"], style="dim"), "left"
    for place, column in enumerate(data["columns"]):
        head = f"{column['text']}\n{column['unit']}"
        table.add_column(Text(head), justify="right" if place else "left", no_wrap=place > 0)
    for row in data["rows"]:
        table.add_row(*map(Text, row))
    return table


def _remarks(results: Sequence[Result]) -> list[RenderableType]:
    parts: list[RenderableType] = []
    several = len(results) > 1
    sections = (
        ("No solution", findings.unsolved(results), "bold red"),
        ("Limits violated", findings.missed_limits(results), "bold red"),
        ("No verdict", findings.no_verdict(results), "bold yellow"),
        ("Remarks", findings.remarks(results), "yellow"),
        ("Recommendations and screening indicators missed", findings.missed_advice(results), "default"),
        ("Information", findings.information(results), "default"),
        ("Values not found", findings.missing_values(results), "default"),
        ("Not checked", findings.not_checked(results), "default"),
    )
    for heading, groups, style in sections:
        if groups:
            parts.append(Text(f"\n{heading}", style=style))
            parts += [Padding(_line(group, several), (0, 0, 0, 2)) for group in groups]
    if not parts and any(result.checks for result in results):
        parts.append(Text(f"\n{counted_parts(results)}: all limits kept, no warnings.", style="green"))
    return parts


def _line(group: findings.Group, several: bool) -> Text:
    line = Text(f"{group.code}  " if group.code else "", style="bold")
    said = f"{group.title}: {group.message}" if group.message else group.title
    line.append(said, style="default")
    return line.append(f"  [{group.some_bearings}]", style="default") if several else line
