"""Bearings in the rows of a table: columns are fields of a case, which has everything else."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import build_case
from babbitt.case.named_files import NamedFiles, TableError
from babbitt.case.variation import variation_of
from babbitt.case.with_units import quantity_text
from babbitt.core.notices import InputError
from babbitt.core.units import KINDS, QuantityError, SiField, SiNumber, read
from babbitt.core.units.reading import bare_number
from babbitt.study.fields import meaning_of, numeric_field, path_in, types_at, unknown_field
from babbitt.study.inputs import Input
from babbitt.study.laws import Choices, Listed
from babbitt.study.table_cells import LARGEST_TABLE, REMARK, BearingTable, Cell, table_of_content

__all__ = ["TableRows", "inputs_as_told", "rows_of_table", "table_in"]

_IN_PARENTHESES = re.compile(r"(.+?)\s*\((.*)\)")

_HEADING = re.compile(r"(.+?)\s*(?:\[(.*)\])?", re.DOTALL)

WORDS_OF_LOGIC = {"true": True, "false": False}


def table_in(case: CaseFile, name: str) -> BearingTable:
    """The table that the study of a case names, sought from its folder.

    Raises
    ------
    InputError
        E003 for a file that cannot be used.
    """
    origin = case.origin
    assert origin is not None, "only a case that was read is varied"
    at, example = ("study", "rows"), "a CSV file or workbook with columns such as 'diameter [mm]'"
    try:
        content = NamedFiles(origin.file.parent, origin.reach).content(name, at, LARGEST_TABLE, example)
    except TableError as error:
        raise InputError("E003", f"study.rows: {error}; allowed: {error.allowed}") from None
    return table_of_content(name, name[name.rfind(".") :].lower(), content)


@dataclass(frozen=True, eq=False)
class TableRows:
    """What the rows of a table say.

    Attributes
    ----------
    inputs : tuple of Input
        The fields that vary.
    values : dict of str to ndarray
        By the path of each its values, shape (rows,).
    refused : dict of int to str
        Rows with a cell that its field does not take, from 0, and why.
    """

    inputs: tuple[Input, ...]
    values: dict[str, NDArray[Any]]
    refused: dict[int, str]


def rows_of_table(case: CaseFile, table: BearingTable) -> TableRows:
    """The fields that vary, and the values of each.

    A column of numbers of its field holds SI numbers; a row with a cell that is none, and no other word that the
    field takes, is refused. Any other column holds words as they are written, which the case takes or refuses row
    by row. An empty cell leaves what the case says: NaN, or an empty word.

    Raises
    ------
    InputError
        E003 for headings that name no field or unit, or a field twice, and for numbers that may be misread.
    """
    fields = [_field(case, table, heading) for heading in table.headings]
    paths = [path for path, *_ in fields]
    for path in paths:
        if paths.count(path) > 1:
            raise table.refused(f"two columns are headed '{path}'")
    numeric = [place for place, (_, form, _, _) in enumerate(fields) if form]
    cells = table.with_points(numeric)
    inputs, values = [], {}
    refused: dict[int, str] = {}
    for place, (path, form, quantity, unit) in enumerate(fields):
        column = cells.get(place, table.columns[place])
        one, values[path], lost = _column(case, table, path, form, quantity, unit, column)
        inputs.append(one)
        refused = lost | refused
    return TableRows(tuple(inputs), values, refused)


def _field(case: CaseFile, table: BearingTable, heading: str) -> tuple[str, str, SiField | None, str]:
    """Path, form, quantity and unit of a column, by its heading."""
    found = _HEADING.fullmatch(heading)
    assert found is not None, "headings are not empty"
    path, unit = found.group(1), (found.group(2) or "").strip()
    annotations = types_at(case, path)
    if not annotations:
        raise table.refused(f"column '{heading}': {_unknown(case, path)}")
    form, quantity = numeric_field(annotations)
    if unit:
        if quantity is None:
            raise table.refused(f"column '{heading}': takes no quantity; write '{path}' without a unit")
        try:
            read(f"1 {unit}", quantity.unit)
        except QuantityError as error:
            raise table.refused(f"column '{heading}': {error}") from None
    return path, form, quantity, unit


def _unknown(case: CaseFile, path: str) -> str:
    """Say why a heading names no field, and what to write instead."""
    rounded = _IN_PARENTHESES.fullmatch(path)
    if rounded is not None and types_at(case, rounded[1]):
        return f"write the unit in square brackets, '{rounded[1]} [{rounded[2]}]'"
    return f"{unknown_field(case, path_in(case, path))} (a column of remarks is headed '{REMARK} ...')"


def _column(
    case: CaseFile,
    table: BearingTable,
    path: str,
    form: str,
    quantity: SiField | None,
    unit: str,
    cells: Sequence[Cell],
) -> tuple[Input, NDArray[Any], dict[int, str]]:
    """One field that varies, with its values, and the rows whose cell it does not take."""
    field, reason = path_in(case, path), f"column of {table.name}"
    meaning = meaning_of(case, path, field)
    written = [_written(cell, unit, quantity) for cell in cells]
    numbers, strange = _numbers(written, quantity) if form else ([], {})
    if strange and quantity is not None and not unit:
        _require_unit(table, path, quantity, written, strange)
    lost: dict[int, str] = {}
    if strange and len(strange) < sum(map(bool, written)):
        why = {text: _refusal(case, table, field, text) for text in dict.fromkeys(strange.values())}
        lost = {row: why[text] for row, text in strange.items() if why[text]}
    if form and len(lost) == len(strange):
        si = "" if quantity is None or quantity.unit == "1" else KINDS[quantity.unit].unit
        law = Listed(tuple(one for one in numbers if one == one) or (math.nan,), "column of a table")
        return Input(path, field, law, si, meaning, reason, table.name, form), np.array(numbers, float), lost
    known = {text: WORDS_OF_LOGIC.get(text, text) for text in dict.fromkeys(written) if text}
    words = Choices(tuple(known), "column of a table")
    as_words = Input(path, field, words, "", meaning, reason, table.name, "choice", known)
    return as_words, np.array(written, object), {}


def _require_unit(
    table: BearingTable, path: str, quantity: SiField, written: Sequence[str], strange: Mapping[int, str]
) -> None:
    """Refuse a column without unit in its heading or any of its cells, once for all rows."""
    if any(text and bare_number(text) is None and row not in strange for row, text in enumerate(written)):
        return
    if any(bare_number(text) is not None for text in strange.values()):
        unit = quantity.kind.example.partition(" ")[2]
        raise table.refused(f"column '{path}' has no unit; write '{path} [{unit}]', or a unit behind each number")


def _numbers(written: Sequence[str], quantity: SiField | None) -> tuple[list[float], dict[int, str]]:
    """The numbers of a column in SI, NaN for what is none, and by their rows the words that are none."""
    numbers, strange = [], {}
    for row, text in enumerate(written):
        try:
            numbers.append(_si(text, quantity) if text else math.nan)
        except QuantityError:
            numbers.append(math.nan)
            strange[row] = text
    return numbers, strange


def _refusal(case: CaseFile, table: BearingTable, field: str, text: str) -> str:
    """Why a case does not take a word in a field; empty where it does."""
    try:
        variation = variation_of(case, field)
        files = NamedFiles(variation.file.parent, variation.reach)
        build_case(variation.given_with(text), table.short_name, files)
    except InputError as error:
        return error.message
    return ""


def _written(cell: Cell, unit: str, quantity: SiField | None) -> str:
    """A cell as it would stand in a case file."""
    if isinstance(cell, SiNumber) and quantity is not None and not unit:
        return str(quantity_text(float(cell), quantity.kind))
    if isinstance(cell, str):
        text = cell.strip()
        return f"{text} {unit}".strip() if text and unit else text
    number = repr(cell).removesuffix(".0")
    return f"{number} {unit}".strip()


def _si(text: str, quantity: SiField | None) -> float:
    if quantity is not None:
        return quantity.as_written(text)
    try:
        whole = float(text)
    except ValueError:
        whole = math.nan
    if not whole.is_integer():
        raise QuantityError(f"'{text}' is no whole number")
    return whole


def inputs_as_told(told: Sequence[Mapping[str, Any]]) -> tuple[Input, ...]:
    """The fields of a table that was stored, by what ``study.json`` says of them."""
    made = []
    for one in told:
        choices = one["form"] == "choice"
        words = one.get("values", ())
        law = Choices(tuple(words), one["law"]) if choices else Listed(tuple(one["support"]), one["law"])
        known = {text: WORDS_OF_LOGIC.get(text, text) for text in words} if choices else None
        about = (one["unit"], one["meaning"], one["reason"], "", one["form"])
        made.append(Input(one["path"], one["field"], law, *about, known))
    return tuple(made)
