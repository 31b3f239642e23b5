"""Cells that a spreadsheet program takes for what they are: words stay words, numbers stay numbers."""

from __future__ import annotations

import csv
import importlib
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from babbitt.core.files.marks import CREATOR
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install

__all__ = [
    "Cell",
    "Sheet",
    "Shown",
    "openpyxl_library",
    "plain_word",
    "read_rows",
    "rows_text",
    "workbook",
    "written_word",
]


@dataclass(frozen=True)
class Shown:
    """A number with the format in which a spreadsheet program shows it, such as ``0.0%``."""

    value: float
    format: str


Cell = str | float | Shown | None
"""What stands in a cell; a number is never text."""


@dataclass(frozen=True)
class Sheet:
    """A sheet as it is read: headings that stay in sight, columns as wide as what stands in them.

    Attributes
    ----------
    rows : sequence of sequence of Cell
        The headings among them.
    headings : int
        Rows from the top that are headings; 0 for a sheet of words.
    fixed : int
        Columns from the left that stay in sight, too.
    formats : mapping of int to str
        By the place of a column the format of its numbers.
    """

    rows: Sequence[Sequence[Cell]]
    headings: int = 1
    fixed: int = 0
    formats: Mapping[int, str] = field(default_factory=dict)


_FORMULA = re.compile(r"'*[=+\-@\t\r]")
_NEUTRAL = re.compile(r"'+[=+\-@\t\r]")


def written_word(text: str) -> str:
    """A word that no spreadsheet program takes for a formula: an apostrophe goes before ``=``, ``+``, ``-`` and
    ``@``.

    >>> written_word("=1+1"), written_word("Pinion"), plain_word(written_word("'-x"))
    ("'=1+1", 'Pinion', "'-x")

    References
    ----------
    OWASP, CSV Injection, https://owasp.org/www-community/attacks/CSV_Injection
    """
    return f"'{text}" if _FORMULA.match(text) else text


def plain_word(text: str) -> str:
    """The word that `written_word` was given.

    >>> plain_word("'=1+1"), plain_word("'Pinion'")
    ('=1+1', "'Pinion'")
    """
    return text[1:] if _NEUTRAL.match(text) else text


def rows_text(rows: Iterable[Sequence[Cell]]) -> str:
    """Rows as comma-separated values: words without formulas, numbers to their last digit, nothing for None."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([_written(cell) for cell in row] for row in rows)
    return stream.getvalue()


def read_rows(text: str) -> list[list[str]]:
    """Cells of comma-separated values, their words as they were before they were written.

    Raises
    ------
    csv.Error
        For a text that is no such table.
    """
    return [[plain_word(cell) for cell in row] for row in csv.reader(io.StringIO(text), strict=True)]


def workbook(sheets: Mapping[str, Sheet | Iterable[Sequence[Cell]]], where: object) -> bytes:
    """A workbook (.xlsx) of the sheets named; words are stored as text, so that none is a formula.

    Rows that are no `Sheet` stand as they are, without a layout, for programs that read them.

    Raises
    ------
    InputError
        E007 when openpyxl is not installed; `where` is named in it.
    """
    book = openpyxl_library(where).Workbook()
    book.remove(book.active)
    for name, given in sheets.items():
        sheet = book.create_sheet(name)
        rows = given.rows if isinstance(given, Sheet) else given
        for row, cells in enumerate(rows, 1):
            for column, value in enumerate(cells, 1):
                if value is not None:
                    _fill(sheet.cell(row, column), value)
        if isinstance(given, Sheet):
            _lay_out(sheet, given)
    book.properties.creator = CREATOR
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


def openpyxl_library(where: object) -> Any:
    """The package openpyxl.

    Raises
    ------
    InputError
        E007 when it is not installed; `where` is named in it.
    """
    try:
        return importlib.import_module("openpyxl")
    except ImportError:
        raise InputError(
            "E007",
            f"{where}: workbooks need the package openpyxl, which is not installed. "
            f"{how_to_install('openpyxl', 'files')}; .csv needs nothing",
        ) from None


def _written(cell: Cell) -> str:
    if cell is None:
        return ""
    if isinstance(cell, str):
        return written_word(cell.replace("\r", " "))  # a return alone would end the row, for it is not quoted
    return repr(float(cell.value if isinstance(cell, Shown) else cell))


NARROWEST, WIDEST = 8, 60
"""Letters in a column; longer words are wrapped."""

MEASURED = 500
"""Rows from the top by which columns are measured."""

OF_A_NUMBER = 9
"""Letters for which a column of numbers has room."""


def _lay_out(sheet: Any, given: Sheet) -> None:
    """Freeze and mark the headings, set the widths of the columns and the formats of their numbers."""
    styles = importlib.import_module("openpyxl.styles")
    letter_of = importlib.import_module("openpyxl.utils").get_column_letter
    longest: dict[int, int] = {}
    for row in given.rows[:MEASURED]:
        for place, cell in enumerate(row if len(row) > 1 else ()):  # a word alone is a note, which may run on
            longest[place] = max(longest.get(place, 0), len(cell) if isinstance(cell, str) else OF_A_NUMBER)
    for place, letters in longest.items():
        sheet.column_dimensions[letter_of(place + 1)].width = min(max(letters, NARROWEST), WIDEST) + 2
    for row in sheet.iter_rows(min_row=given.headings + 1):
        for cell in row:
            if cell.data_type == "n" and cell.value is not None and cell.column - 1 in given.formats:
                cell.number_format = given.formats[cell.column - 1]
            elif cell.data_type == "s" and len(cell.value) > WIDEST and len(given.rows[cell.row - 1]) > 1:
                cell.alignment = styles.Alignment(wrap_text=True, vertical="top")
    for row in sheet.iter_rows(max_row=given.headings) if given.headings else ():
        for cell in row:
            cell.font = styles.Font(bold=cell.row == 1, italic=cell.row > 1)
    if given.headings:
        sheet.freeze_panes = sheet.cell(given.headings + 1, given.fixed + 1)


def _fill(cell: Any, value: str | float | Shown) -> None:
    if isinstance(value, str):
        illegal = importlib.import_module("openpyxl.cell.cell").ILLEGAL_CHARACTERS_RE
        cell.value = illegal.sub("", value)
        cell.data_type = "s"
        cell.quotePrefix = True
    elif isinstance(value, Shown):
        cell.value, cell.number_format = float(value.value), value.format
    else:
        cell.value = float(value)
