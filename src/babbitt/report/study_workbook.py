"""A study as a workbook: what varied, all results with verdict and governing check, and the summary."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from babbitt.core.files.spreadsheet import Cell, workbook
from babbitt.core.result import Verdict
from babbitt.report.study_content import StudyTable, overview, study_tables
from babbitt.report.study_values import Scale, input_scale, kelvin_scale, output_scale
from babbitt.report.text import plain_text
from babbitt.study.rows import kelvin_name
from babbitt.study.study import Study

__all__ = ["study_rows", "study_workbook"]

MOST_LINES = 1_000_000
"""Of a sheet; more than a million lines belong into the folder of the study."""

VERDICTS = {verdict.key: verdict.value for verdict in Verdict}


def study_workbook(study: Study, where: object) -> bytes:
    """The workbook of a study, numbers as numbers, in engineers' units.

    Raises
    ------
    InputError
        E007 when openpyxl is not installed; `where` is named in it.
    """
    sheets = {"Inputs": _inputs(study), "Results": study_rows(study), "Summary": _summary(study)}
    return workbook(sheets, where)


def _inputs(study: Study) -> list[list[Cell]]:
    rows: list[list[Cell]] = [["Case", plain_text(str(study.description["name"]))], ["Study", overview(study)]]
    rows += [
        ["Babbitt", str(study.description["babbitt"])],
        ["Hash of the case", str(study.description["case_hash"])],
    ]
    rows += [[], ["field", "meaning", "values or distribution", "reason", "from", "to", "unit"]]
    for one in study.inputs:
        scale = input_scale(one)
        ends = one["values"] if "values" in one else [float(scale.shown(end)) for end in one["support"]]
        named: list[Cell] = [plain_text(one["path"]), one["meaning"], one["law"], one["reason"]]
        rows.append([*named, ends[0], ends[-1], scale.unit])
    return rows


def study_rows(study: Study) -> list[list[Cell]]:
    """A line for each row and bearing under a heading, in engineers' units."""
    columns = study.columns | {"row": study.lines}
    scales = {one["path"]: input_scale(one) for one in study.inputs}
    scales |= {name: output_scale(name) for name in study.outputs}
    warm = {name: kelvin_scale(name) for name in columns if name.startswith(kelvin_name(""))}
    words = ("group", "bearing", "verdict", "governing_check", "failed_checks", "codes", "status", "message")
    names = [
        "row",
        *scales,
        *(name for name in columns if name.startswith(("margin", "kelvin", "advisory"))),
        *words,
    ]
    count = min(columns["row"].size, MOST_LINES)
    shown = scales | warm
    made = [_column(name, columns[name][:count], shown.get(name)) for name in names]
    heading: list[Cell] = [_heading(name, shown.get(name)) for name in names]
    lines: list[list[Cell]] = [list(line) for line in zip(*made, strict=True)]
    left_out = columns["row"].size - count
    more: list[list[Cell]] = [[f"{left_out} more lines: babbitt.open_study"]] if left_out else []
    return [heading, *lines, *more]


def _heading(name: str, scale: Scale | None) -> str:
    if scale is None or not scale.unit:
        return name
    return f"{name} [{scale.unit}]"


def _column(name: str, values: NDArray[Any], scale: Scale | None) -> list[Cell]:
    if values.dtype == object:
        known = VERDICTS if name == "verdict" else {}
        return [known.get(str(one), plain_text(str(one))) or None for one in values]
    shown = values.astype(float) if scale is None else scale.shown(values.astype(float))
    return [float(f"{one:.12g}") if math.isfinite(one) else None for one in shown.tolist()]


def _summary(study: Study) -> list[list[Cell]]:
    rows: list[list[Cell]] = [[overview(study)]]
    for table in study_tables(study):
        rows += [[], [table.title], *_lines(table)]
    return rows


def _lines(table: StudyTable) -> Iterator[list[Cell]]:
    yield [f"{name} [{unit}]" if unit else name or None for name, unit in table.columns]
    for row in table.rows:
        yield [_cell(text, place >= table.words) for place, text in enumerate(row)]
    for note in table.notes:
        yield [note]


def _cell(text: str, number: bool) -> Cell:
    """A number as a number, a share in percent as a share."""
    if not number:
        return text
    try:
        return 0.01 * float(text.removesuffix(" %")) if text.endswith(" %") else float(text)
    except ValueError:
        return text or None
