"""Tables as sheets of a workbook: headings, a row of units, numbers with the digits that are worth showing."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from statistics import median

from babbitt.core.files.spreadsheet import Cell, Sheet, Shown
from babbitt.report.study_values import StudyTable

__all__ = ["sheet_name", "sheet_of_rows", "sheet_of_table", "sheet_with_units"]

SHARE = "0.0%"
SHARES = re.compile(r"(margin|advisory_C\d+|margin_C\d+)")
"""Headings of columns that hold shares of a limit."""

DIGITS, MOST_DECIMALS = 4, 6
"""Significant digits of the median of a column, and decimals at most."""

LONGEST_NAME = 31
"""Letters of the name of a sheet."""

_HEADING = re.compile(r"(.+?) \[(.*)\]")
_NUMBER = re.compile(r"([+-]?)(\d+(?:\.(\d+))?(?:e[+-]?\d+)?)( %|%| K| °F|\*)?")


def sheet_of_rows(rows: Sequence[Sequence[Cell]]) -> Sheet:
    """A sheet of rows under their headings, as they stand in CSV."""
    heading, *lines = rows
    return Sheet(rows, 1, 1, _formats([str(one) for one in heading], lines))


def sheet_with_units(rows: Sequence[Sequence[Cell]]) -> Sheet:
    """A sheet of rows under their headings; units in brackets stand in a row of their own below the names."""
    heading, *lines = rows
    parts = [_HEADING.fullmatch(str(one)) for one in heading]
    names = [found[1] if found else str(one) for found, one in zip(parts, heading, strict=True)]
    units = [found[2] if found else None for found in parts]
    heads: list[Sequence[Cell]] = [names, units] if any(units) else [names]
    return Sheet([*heads, *lines], len(heads), 1, _formats(names, lines))


def _formats(names: Sequence[str], lines: Sequence[Sequence[Cell]]) -> dict[int, str]:
    """Formats of the columns that hold numbers, by their places."""
    columns = ([line[place] for line in lines if place < len(line)] for place in range(len(names)))
    found = (_format(name, column) for name, column in zip(names, columns, strict=True))
    return {place: shown for place, shown in enumerate(found) if shown}


def _format(name: str, column: Sequence[Cell]) -> str:
    """How the numbers of a column are shown; empty where it has none."""
    numbers = [abs(one) for one in column if isinstance(one, int | float) and one != 0.0]
    if not numbers:
        return ""
    if SHARES.fullmatch(name):
        return SHARE
    if all(float(one).is_integer() for one in numbers):
        return "0"
    decimals = DIGITS - 1 - math.floor(math.log10(median(numbers)))
    return "0.00E+00" if decimals > MOST_DECIMALS else _decimals(max(decimals, 0))


def _decimals(count: int) -> str:
    return f"0.{'0' * count}" if count else "0"


def sheet_of_table(table: StudyTable) -> Sheet:
    """A sheet of a table of text, its numbers as numbers; notes stand below it."""
    names: list[Cell] = [name or None for name, _ in table.columns]
    units: list[Cell] = [unit or None for _, unit in table.columns]
    heads: list[Sequence[Cell]] = [names, units] if any(units) else [names]
    rows: list[Sequence[Cell]] = [
        [_cell(text, number=place >= table.words) for place, text in enumerate(row)] for row in table.rows
    ]
    notes: list[Sequence[Cell]] = [[], *([note] for note in table.notes)] if table.notes else []
    return Sheet([*heads, *rows, *notes], len(heads), min(table.words, 1))


def _cell(text: str, *, number: bool) -> Cell:
    """A number as a number in the digits that the table shows, with what stands behind it; anything else as text.

    >>> _cell("+29.9 K", number=True), _cell("14.4*", number=True)
    (Shown(value=29.9, format='+0.0" K";-0.0" K"'), Shown(value=14.4, format='0.0"*"'))
    >>> _cell("52.4 %", number=True), _cell("pass", number=True)
    (Shown(value=0.524, format='0.0%'), 'pass')
    """
    found = _NUMBER.fullmatch(text.replace("−", "-")) if number else None
    if found is None:
        return text or None
    sign, digits, decimals, behind = found[1], found[2], len(found[3] or ""), found[4] or ""
    value = float(f"{sign}{digits}")
    shown = "0.000E+00" if "e" in digits else _decimals(decimals)
    if behind.strip() == "%":
        value, behind, shown = round(0.01 * value, decimals + 4), "", f"{shown}%"
    shown = f'{shown}"{behind}"' if behind else shown
    return Shown(value, f"+{shown};-{shown}" if sign == "+" else shown)


def sheet_name(title: str, taken: Sequence[str]) -> str:
    """A title as the name of a sheet: without letters that none has, short, and unlike others.

    >>> sheet_name("Map of a/b: speed up", []), sheet_name("Yield", ["Yield"])
    ('Map of a b speed up', 'Yield 2')
    """
    plain = " ".join(re.sub(r"[\[\]:*?/\\']", " ", title).split())
    name, number = plain[:LONGEST_NAME].strip(), 1
    while name.lower() in (one.lower() for one in taken):
        number += 1
        name = f"{plain[: LONGEST_NAME - 1 - len(str(number))].strip()} {number}"
    return name
