"""A study as a workbook: what varied, all results with verdict and governing check, and the summary."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from numpy.typing import NDArray

from babbitt.core.files.spreadsheet import Cell, Sheet, Shown, workbook
from babbitt.core.result import Verdict
from babbitt.report.sheets import sheet_name, sheet_of_table, sheet_with_units
from babbitt.report.study_content import overview, study_tables
from babbitt.report.study_values import Scale, input_scale, kelvin_scale, output_scale
from babbitt.report.text import plain_text
from babbitt.study.rows import kelvin_name
from babbitt.study.study import Study

__all__ = ["study_rows", "study_workbook"]

MOST_LINES = 1_000_000
"""Of a sheet; more than a million lines belong into the folder of the study."""

ALREADY_THERE = ("What varies", "Results", "Bearings")
"""Tables whose lines stand in the sheets of inputs and results."""

VERDICTS = {verdict.key: verdict.value for verdict in Verdict}


def study_workbook(study: Study, where: object) -> bytes:
    """The workbook of a study, numbers as numbers, in engineers' units: what was asked, inputs, results, tables.

    Raises
    ------
    InputError
        E007 when openpyxl is not installed; `where` is named in it.
    """
    sheets = {"Summary": _summary(study), "Inputs": _inputs(study), "Results": sheet_with_units(study_rows(study))}
    for table in study_tables(study):
        if table.title not in ALREADY_THERE:
            sheets[sheet_name(table.title, list(sheets))] = sheet_of_table(table)
    return workbook(sheets, where)


def _summary(study: Study) -> Sheet:
    """Of what this is: the case, the study, how many rows came to which verdict."""
    told = study.description
    rows: list[Sequence[Cell]] = [
        ["Case", plain_text(str(told["name"]))],
        ["Study", overview(study)],
        ["Babbitt", str(told["babbitt"])],
        ["Hash of the case", str(told["case_hash"])],
        [],
        ["verdict", "lines"],
    ]
    counts = {word: float((study.columns["verdict"] == key).sum()) for key, word in VERDICTS.items()}
    rows += [[word, Shown(count, "0")] for word, count in counts.items() if count]
    return Sheet(rows, headings=0)


def _inputs(study: Study) -> Sheet:
    rows: list[Sequence[Cell]] = [["field", "meaning", "values or distribution", "reason", "from", "to", "unit"]]
    for one in study.inputs:
        scale = input_scale(one)
        ends = one["values"] if "values" in one else [float(scale.shown(end)) for end in one["support"]]
        named: list[Cell] = [plain_text(one["path"]), one["meaning"], one["law"], one["reason"]]
        first, last = (ends[0], ends[-1]) if ends else (None, None)
        rows.append([*named, first, last, scale.unit])
    return Sheet(rows, fixed=1)


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
