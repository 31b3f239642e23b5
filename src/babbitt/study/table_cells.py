"""Tables of bearings as they stand in files: the cells of CSV files and workbooks, numbers never misread."""

from __future__ import annotations

import csv
import io
import re
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import Any

from babbitt.core.files.printing import printable
from babbitt.core.files.reading import UnreadableFileError, read_regular
from babbitt.core.files.spreadsheet import openpyxl_library, plain_word
from babbitt.core.notices import InputError
from babbitt.core.units import SiNumber

__all__ = ["LARGEST_TABLE", "BearingTable", "read_table", "table_of_columns", "table_of_content"]

LARGEST_TABLE = 200_000_000
"""Bytes of a table of bearings."""

REMARK = "#"
"""With what the heading of a column of remarks begins, which is not read."""

COMMA, SEMICOLON, TAB = ",", ";", "\t"

_NUMBER = re.compile(r"[-+]?[\d.,]*\d[\d.,]*(?:[eE][-+]?\d+)?")
_GROUPED = re.compile(r"[-+]?[1-9]\d{0,2}[.,]\d{3}")

Cell = str | float
"""Words, or a number of a workbook or program; an empty word where nothing stands."""


@dataclass(frozen=True)
class BearingTable:
    """Cells under headings.

    Attributes
    ----------
    name : str
        What messages call it.
    headings : tuple of str
        Paths of fields, with units in brackets.
    columns : tuple of tuple
        The cells below each, all of one length.
    lines : tuple of int
        Where the rows stand: in a sheet from 1, the line of the headings counted; of a program from 0.
    separator : str
        What stands between the cells of a line; empty where they come from a workbook or a program.
    """

    name: str
    headings: tuple[str, ...]
    columns: tuple[tuple[Cell, ...], ...]
    lines: tuple[int, ...]
    separator: str = ""

    @property
    def count(self) -> int:
        """Rows."""
        return len(self.lines)

    @property
    def short_name(self) -> str:
        """Its name without folders, for reasons of single rows."""
        return PurePath(self.name).name

    def refused(self, says: str) -> InputError:
        """What to raise of the table."""
        return InputError("E003", f"{self.name}: {says}")

    def with_points(self, columns: Iterable[int]) -> dict[int, tuple[Cell, ...]]:
        """Columns of numbers, every decimal comma of them a point.

        Parameters
        ----------
        columns : iterable of int
            Places of columns that hold numbers, with units or without.

        Raises
        ------
        InputError
            E003 where a comma or a point may separate thousands as well as decimals.
        """
        taken = {place: self.columns[place] for place in columns}
        numbers = [found for cells in taken.values() for cell in cells if (found := _number(cell))]
        commas, points = ([one for one in numbers if mark in one] for mark in ",.")
        if both := [one for one in commas if one in points]:
            raise self.refused(f"'{both[0]}' has a comma and a point; write it without separators of thousands")
        if commas and points:
            says = f"numbers are written with a comma ('{commas[0]}') and with a point ('{points[0]}')"
            raise self.refused(f"{says}; use one of them for decimals throughout, and nothing for thousands")
        if commas and self.separator == COMMA:
            says = f"'{commas[0]}' has a comma, which separates the columns, too"
            raise self.refused(f"{says}; write decimals with a point, or separate the columns by semicolons")
        self._require_decimals(commas)
        if self.separator != COMMA:
            self._require_decimals(points)
        return {place: tuple(_pointed(cell) for cell in cells) for place, cells in taken.items()}

    def _require_decimals(self, numbers: Sequence[str]) -> None:
        """Refuse numbers whose mark may separate thousands: no other number shows that it separates decimals."""
        repeated = next((one for one in numbers if one.count(",") + one.count(".") > 1), None)
        if repeated is not None:
            raise self.refused(f"'{repeated}' has separators of thousands; write it without")
        if numbers and all(_GROUPED.fullmatch(one) for one in numbers):
            one = numbers[0]
            whole, decimal = re.sub("[.,]", "", one), one.replace(",", ".") + "0"
            says = f"'{one}' may be {decimal} or {whole}, and no other number of the table tells"
            raise self.refused(f"{says}; write {whole}, or {decimal}")


def _number(cell: Cell) -> str:
    """The number with which words begin; empty where none does, and for numbers of a program."""
    found = _NUMBER.match(cell.strip()) if isinstance(cell, str) else None
    return found.group() if found is not None else ""


def _pointed(cell: Cell) -> Cell:
    number = _number(cell)
    return cell.strip().replace(number, number.replace(",", "."), 1) if isinstance(cell, str) and number else cell


def read_table(path: Path) -> BearingTable:
    """Read a table of bearings from a file.

    Parameters
    ----------
    path : Path
        ``.csv`` (in UTF-8, columns separated by commas, semicolons or tabs) or ``.xlsx`` (its first sheet).

    Raises
    ------
    InputError
        E001 for a file that cannot be read, E003 for what is no table.
    """
    try:
        content = read_regular(path, LARGEST_TABLE)
    except UnreadableFileError as error:
        raise InputError("E001", f"{printable(path)}: {error.says}") from None
    return table_of_content(printable(path), path.suffix.lower(), content)


def table_of_content(name: str, suffix: str, content: bytes) -> BearingTable:
    """The table in the bytes of a file; raises as `read_table`."""
    if suffix == ".xlsx":
        return _table(name, _cells_of_workbook(name, content), "")
    if suffix not in (".csv", ".tsv", ".txt"):
        raise InputError("E001", f"{name}: a table of bearings ends in .csv or .xlsx")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        says = "is not text in UTF-8; save it as 'CSV UTF-8', or as .xlsx"
        raise InputError("E001", f"{name}: {says}") from None
    return _table_of_text(name, text)


def _table_of_text(name: str, text: str) -> BearingTable:
    lines = text.splitlines(keepends=True)
    if lines and lines[0].lower().startswith("sep="):  # Excel says so what separates the columns
        lines = lines[1:]
    heading = next((line for line in lines if line.strip()), "")
    outside = re.sub('"[^"]*"', "", heading)
    separator = next((mark for mark in (SEMICOLON, TAB) if mark in outside), COMMA)
    try:
        rows: list[list[Cell]] = [
            [plain_word(cell) for cell in row]
            for row in csv.reader(io.StringIO("".join(lines)), delimiter=separator, strict=True)
        ]
    except csv.Error as error:
        raise InputError("E003", f"{name}: is no table of {_NAMES[separator]}-separated values: {error}") from None
    return _table(name, rows, separator)


_NAMES = {COMMA: "comma", SEMICOLON: "semicolon", TAB: "tab"}


def _cells_of_workbook(name: str, content: bytes) -> list[list[Cell]]:
    """The cells of the first sheet."""
    openpyxl = openpyxl_library(name)
    try:
        sheets = [
            openpyxl.load_workbook(io.BytesIO(content), data_only=values).worksheets[0] for values in (True, False)
        ]
    except (zipfile.BadZipFile, EOFError, KeyError, IndexError, ValueError, OSError) as error:
        raise InputError("E003", f"{name}: is no workbook that can be read ({error})") from None
    made: list[list[Cell]] = []
    for values, written in zip(sheets[0].iter_rows(), sheets[1].iter_rows(), strict=True):
        made.append([_cell(name, one, formula) for one, formula in zip(values, written, strict=True)])
    return made


def _cell(name: str, cell: Any, written: Any) -> Cell:
    """What stands in a cell of a workbook; what a spreadsheet program has made of it is refused."""
    value = cell.value
    if value is None and written.data_type == "f":
        says = f"cell {cell.coordinate} is a formula without a value; calculate and save the workbook"
        raise InputError("E003", f"{name}: {says}")
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int | float):
        return float(value)
    if isinstance(value, str) and cell.data_type != "e":
        return plain_word(value)
    what = (
        f"an error ({value})" if cell.data_type == "e" else "a date or time; format the column as number or text"
    )
    raise InputError("E003", f"{name}: cell {cell.coordinate} is {what}")


def table_of_columns(columns: Mapping[str, Iterable[Any]], name: str = "table") -> BearingTable:
    """The table that a program gives: by heading its cells, such as a mapping or a pandas DataFrame.

    Numbers are in the unit of their heading, in SI where that has none.

    Raises
    ------
    InputError
        E003 for columns of different lengths, or none.
    """
    cells = {str(heading): tuple(_given(one) for one in columns[heading]) for heading in columns}
    counts = {heading: len(column) for heading, column in cells.items()}
    if len(set(counts.values())) > 1:
        told = ", ".join(f"'{heading}' {count}" for heading, count in counts.items())
        raise InputError("E003", f"{name}: the columns differ in length: {told}")
    rows = [list(cells), *(list(row) for row in zip(*cells.values(), strict=True))]
    made = _table(name, rows, "")
    return replace(made, lines=tuple(line - FIRST_ROW for line in made.lines))


def _given(cell: Any) -> Cell:
    if isinstance(cell, bool):
        return str(cell).lower()
    if cell is None or cell != cell:  # NaN, NaT
        return ""
    try:
        return cell if isinstance(cell, str) else SiNumber(cell)
    except (TypeError, ValueError):
        return str(cell)


FIRST_ROW = 2
"""Line of a sheet below that of the headings."""


def _table(name: str, rows: Sequence[Sequence[Cell]], separator: str) -> BearingTable:
    """Rows under their headings, empty ones and columns of remarks left out."""
    filled = [(number, row) for number, row in enumerate(rows, 1) if any(map(_is_filled, row))]
    if not filled:
        raise InputError("E003", f"{name}: is empty; its first line names fields, such as 'diameter [mm]'")
    headings = [str(cell).strip() for cell in filled[0][1]]
    while headings and not headings[-1]:
        headings.pop()
    for number, row in filled[1:]:
        if any(map(_is_filled, row[len(headings) :])):
            says = f"line {number} has {len(row)} cells under {len(headings)} headings"
            hint = "; separate the columns by semicolons if the numbers have decimal commas"
            raise InputError("E003", f"{name}: {says}{hint if separator == COMMA else ''}")
    if not all(headings):
        raise InputError("E003", f"{name}: column {headings.index('') + 1} has no heading")
    read = [place for place, heading in enumerate(headings) if not heading.startswith(REMARK)]
    if not read:
        raise InputError("E003", f"{name}: no column names a field; head one 'diameter [mm]', for example")
    padded = [[*row, *[""] * len(headings)] for _, row in filled[1:]]
    if not padded:
        raise InputError("E003", f"{name}: has headings and no rows")
    columns = tuple(tuple(row[place] for row in padded) for place in read)
    lines = tuple(number for number, _ in filled[1:])
    return BearingTable(name, tuple(headings[place] for place in read), columns, lines, separator)


def _is_filled(cell: Cell) -> bool:
    return not isinstance(cell, str) or bool(cell.strip())
