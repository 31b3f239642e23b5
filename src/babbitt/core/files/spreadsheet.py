"""Cells that a spreadsheet program takes for what they are: words stay words, numbers stay numbers."""

from __future__ import annotations

import csv
import importlib
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from babbitt.core.files.marks import CREATOR
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install

__all__ = ["Cell", "openpyxl_library", "plain_word", "read_rows", "rows_text", "workbook", "written_word"]

Cell = str | float | None
"""What stands in a cell; a number is never text."""

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


def workbook(sheets: Mapping[str, Iterable[Sequence[Cell]]], where: object) -> bytes:
    """A workbook (.xlsx) of the sheets named; words are stored as text, so that none is a formula.

    Raises
    ------
    InputError
        E007 when openpyxl is not installed; `where` is named in it.
    """
    book = openpyxl_library(where).Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row, cells in enumerate(rows, 1):
            for column, value in enumerate(cells, 1):
                if value is not None:
                    _fill(sheet.cell(row, column), value)
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
    return repr(float(cell))


def _fill(cell: Any, value: str | float) -> None:
    if isinstance(value, str):
        illegal = importlib.import_module("openpyxl.cell.cell").ILLEGAL_CHARACTERS_RE
        cell.value = illegal.sub("", value)
        cell.data_type = "s"
        cell.quotePrefix = True
    else:
        cell.value = float(value)
