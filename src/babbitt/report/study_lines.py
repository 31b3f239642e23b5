"""Lines of a study as a table of text, and what the tables of all kinds of study have in common."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from babbitt.core.language import translated
from babbitt.core.limited_flow import limited
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Verdict
from babbitt.report.columns import MARK
from babbitt.report.study_values import (
    DASH,
    Scale,
    StudyTable,
    bearing_text,
    input_scale,
    margin_text,
    output_scale,
    reason_text,
)
from babbitt.report.text import plain_text
from babbitt.study.held_film import WITH_LIMITED_FLOW
from babbitt.study.rows import Columns
from babbitt.study.study import Study

__all__ = [
    "MOST_ROWS",
    "WORDS",
    "bearing_head",
    "bearings_in",
    "has_several",
    "heads",
    "line_table",
    "mean_heading",
    "reason_at",
]
MOST_ROWS = 200
"""Rows of a sweep that a table shows."""

WORDS = {verdict.key: verdict.value for verdict in Verdict}


def heads(*names: str) -> tuple[tuple[str, str], ...]:
    """Headings without units."""
    return tuple((translated(name), "") for name in names)


def reason_at(columns: Columns, place: int) -> str:
    """Why a row has no answer."""
    message, codes, status = (str(columns[name][place]) for name in ("message", "codes", "status"))
    return plain_text(reason_text(message, codes.partition(" ")[0], status))


def scales_of(study: Study) -> tuple[dict[str, Scale], dict[str, Scale]]:
    """How fields and results of a study are shown, by their names."""
    inputs = {one["path"]: input_scale(one, _numbers(study, one)) for one in study.inputs}
    return inputs, {name: output_scale(name) for name in study.outputs}


def _numbers(study: Study, one: Mapping[str, Any]) -> Any:
    return None if "values" in one else study.columns[one["path"]]


def bearings_in(columns: Columns) -> list[str]:
    """Names of the bearings, in the order of their first lines."""
    return [str(one) for one in dict.fromkeys(columns["bearing"]) if one]


def has_several(study: Study) -> bool:
    """Whether a study is of several bearings."""
    return len(bearings_in(study.columns)) > 1


def line_table(
    study: Study, columns: Columns, title: str, first: str = "", notes: Sequence[str] = ()
) -> StudyTable:
    """Lines of a study as they stand, in engineers' units; `first` names a column that stands at their head."""
    inputs, outputs = scales_of(study)
    several = has_several(study)
    headings = [*heads(first)] if first else []
    headings += [(scale.name, scale.unit) for scale in inputs.values()]
    headings += bearing_head(several)
    headings += [(scale.name, scale.unit) for scale in outputs.values()]
    headings += heads("margin", "governed by", "verdict", "codes")
    rows = []
    for place in range(min(columns["row"].size, MOST_ROWS)):
        cells = [str(columns[first][place])] if first else []
        cells += [scale.text(columns[path][place]) for path, scale in inputs.items()]
        cells += [bearing_text(str(columns["bearing"][place]))] if several else []
        cells += [
            scale.text(columns[name][place]) + _mark(columns, name, place) for name, scale in outputs.items()
        ]
        cells += [margin_text(columns, place)]
        status = str(columns["status"][place])
        verdict = translated(WORDS.get(str(columns["verdict"][place]), ""))
        cells += [str(columns["governing_check"][place]) or DASH]
        cells += [translated(status) if status == "refused" else verdict]
        rows.append((*cells, str(columns["codes"][place])))
    more = columns["row"].size - len(rows)
    said = [translated("{number} more rows are not shown; --xlsx or --out has all.", number=more)] * (more > 0)
    return StudyTable(title, tuple(headings), tuple(rows), 1 if first else 0, (*notes, *said))


def _mark(columns: Columns, name: str, place: int) -> str:
    """What marks the reading of a film with limited flow."""
    less = WITH_LIMITED_FLOW in columns and columns[WITH_LIMITED_FLOW][place]
    return MARK if less and limited(name) in QUANTITIES else ""


def bearing_head(several: bool) -> tuple[tuple[str, str], ...]:
    """The heading of the bearings; none where there is one."""
    return heads("bearing") if several else ()


def mean_heading(symbol: str) -> str:
    """What a mean of a quantity is called."""
    return translated("mean {symbol}", symbol=symbol)
