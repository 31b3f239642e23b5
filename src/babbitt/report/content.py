"""What stands in a report, as plain data: texts and numbers, never markup.

The typesetter gets this as JSON. Text from a case file is only ever a string in it.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from babbitt.notices import EXPLANATIONS
from babbitt.quantities import QUANTITIES
from babbitt.report import verdict as judge
from babbitt.report.calculation import calculation
from babbitt.report.columns import COLUMNS, is_film
from babbitt.report.drawing import Drawing
from babbitt.report.expression import text
from babbitt.report.figures import clearance_range, draw
from babbitt.report.inputs import inputs
from babbitt.report.labels import label
from babbitt.report.line import Line
from babbitt.report.symbols import symbol_node
from babbitt.report.text import counted, plain_text
from babbitt.report.verdict import Group, Verdict
from babbitt.results import Bound, Check, Result

if TYPE_CHECKING:
    from babbitt.solve import MachineResult
    from babbitt.standards.iso7902 import DesignCase

Data = dict[str, Any]

KEY_RESULTS = (
    "specific_load",
    "surface_speed",
    "operating_relative_clearance",
    "sommerfeld_number",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "maximum_pressure",
    "friction_coefficient",
    "friction_power",
    "side_flow",
    "supply_flow",
    "total_flow",
    "effective_temperature",
    "outlet_temperature",
    "bearing_temperature",
    "effective_viscosity",
    "film_reynolds_number",
    "transition_speed",
)
"""Results shown at the head of a bearing; kinds without a film show all they have."""

NOT_FOR_PAPER = ("wall_time", "iterations")
"""Results that tell of the run rather than of the bearing, and differ from run to run."""


def content(machine: MachineResult) -> Data:
    """Everything that the report says.

    Parameters
    ----------
    machine : MachineResult

    Returns
    -------
    dict
        Strings, numbers, lists and dictionaries only.
    """
    results = machine.results
    cases: Sequence[DesignCase | None] = machine.design_cases or [None] * len(results)
    return {
        "name": plain_text(machine.name) or "Unnamed case",
        "version": machine.version,
        "hash": machine.case_hash,
        "count": _count(results),
        "columns": [{"heading": _heading(c.heading), "unit": c.unit} for c in COLUMNS],
        "rows": _rows(results),
        "worst": [_worst_case(results, code) for code in _codes(results)],
        "findings": _findings(results),
        "bearings": [_bearing(machine, case, result) for case, result in zip(cases, results, strict=True)],
    }


def _count(results: Sequence[Result]) -> str:
    found = Counter(judge.verdict(result) for result in results)
    said = {
        Verdict.OK: "within all limits and advice",
        Verdict.ADVICE: "within the limits, against some advice",
        Verdict.FAIL: "beyond a limit",
        Verdict.UNSOLVED: "without a solution",
    }
    parts = [f"{found[word]} {words}" for word, words in said.items() if found[word]]
    return f"{counted(len(results), 'bearing')}: {', '.join(parts)}."


def _heading(heading: str) -> list[Any]:
    """A column heading of several symbols, as nodes with their separators."""
    for separator in (" → ", " / "):
        if separator in heading:
            first, second = heading.split(separator)
            return [symbol_node(first), separator, symbol_node(second)]
    return [symbol_node(heading)]


def _rows(results: Sequence[Result]) -> list[Data]:
    if not any(is_film(result) for result in results):
        return []
    columns = [column.cells(results) for column in COLUMNS]
    return [
        {
            "name": plain_text(result.name),
            "cells": [cells[place] for cells in columns],
            "verdict": judge.verdict(result).value,
        }
        for place, result in enumerate(results)
    ]


def _codes(results: Sequence[Result]) -> list[tuple[str, str]]:
    """Codes and quantities of all checks of solved bearings, in the order of the standard."""
    found = {(c.code, c.quantity): None for r in results if r.outcome.solved for c in r.checks}
    return sorted(found)


def _worst_case(results: Sequence[Result], of: tuple[str, str]) -> Data:
    """The bearing that comes closest to one limit."""
    pairs = [
        (result, check)
        for result in results
        if result.outcome.solved
        for check in result.checks
        if (check.code, check.quantity) == of
    ]
    result, check = min(pairs, key=lambda pair: pair[1].margin)
    return {**_check(check), "bearing": plain_text(result.name), "of": len(pairs)}


def _findings(results: Sequence[Result]) -> list[Data]:
    sections = (
        ("No solution", judge.unsolved(results)),
        ("Limits violated", judge.missed_limits(results)),
        ("Advice not followed", judge.missed_advice(results)),
        ("Warnings", judge.gathered_warnings(results)),
    )
    return [
        {"heading": heading, "groups": [_group(group) for group in groups]}
        for heading, groups in sections
        if groups
    ]


def _group(group: Group) -> Data:
    return {
        "code": group.code,
        "title": group.title,
        "bearings": group.bearings,
        "message": group.message,
        "remedy": group.remedy,
    }


def _bearing(machine: MachineResult, case: DesignCase | None, result: Result) -> Data:
    solved = result.outcome.solved
    sources = list(dict.fromkeys(plain_text(check.source) for check in result.checks)) if solved else []
    drawings: tuple[Drawing, ...] = ()
    if case is not None and solved:
        drawings = draw(case, result, clearance_range(case, machine.design_cases))
    return {
        "name": plain_text(result.name),
        "verdict": judge.verdict(result).value,
        "method": _method(result),
        "outcome": _outcome(result),
        "results": _key_results(result) if solved else [],
        "inputs": [
            {"title": group.title, "rows": [vars(row) for row in group.rows]}
            for group in (inputs(case) if case is not None else ())
        ],
        "assumptions": [plain_text(assumption) for assumption in result.assumptions],
        "sections": [
            {
                "title": section.title,
                "remark": section.remark,
                "lines": [_line(line) for line in section.lines],
            }
            for section in (calculation(case, result) if case is not None else ())
        ],
        "checks": [_check(check, sources) for check in result.checks] if solved else [],
        "sources": sources,
        "warnings": [
            {
                "code": notice.code,
                "title": EXPLANATIONS[notice.code].title,
                "message": plain_text(notice.message),
                "meaning": EXPLANATIONS[notice.code].meaning,
                "remedy": EXPLANATIONS[notice.code].remedy,
            }
            for notice in result.warnings
        ],
        "figures": [
            {"name": drawing.name, "caption": drawing.caption, "svg": drawing.image.decode()}
            for drawing in drawings
        ],
    }


def _method(result: Result) -> str:
    return {"iso7902": "ISO 7902", "statics": "Statics of the shaft"}.get(result.method, plain_text(result.method))


def _outcome(result: Result) -> Data | None:
    if result.outcome.solved:
        return None
    explanation = EXPLANATIONS.get(result.outcome.code)
    return {
        "code": result.outcome.code,
        "title": result.outcome.value,
        "message": plain_text(result.message),
        "remedy": explanation.remedy if explanation else "",
    }


def _key_results(result: Result) -> list[Data]:
    film = "minimum_film_thickness" in result.values
    names = KEY_RESULTS if film else [name for name in result.values if name not in NOT_FOR_PAPER]
    rows = []
    for name in names:
        value = result.values.get(name, math.nan)
        if name in QUANTITIES and math.isfinite(value):
            quantity = QUANTITIES[name]
            rows.append(
                {
                    "label": label(name),
                    "symbol": symbol_node(quantity.symbol),
                    "value": quantity.format(value),
                    "unit": quantity.display.label,
                }
            )
    return rows


def _line(line: Line) -> Data:
    return {
        "meaning": label(line.name),
        "symbol": line.symbol,
        "formula": line.formula,
        "substituted": line.substituted,
        "results": [{"number": number, "unit": unit} for number, unit in line.results],
        "remark": plain_text(line.remark),
        "spoken": f"{text(line.symbol)} = {text(line.results[-1][0])} {line.results[-1][1]}".strip(),
    }


def _check(check: Check, sources: Sequence[str] = ()) -> Data:
    quantity = QUANTITIES.get(check.quantity)
    return {
        "code": check.code,
        "quantity": label(check.quantity),
        "symbol": symbol_node(quantity.symbol) if quantity else None,
        "value": judge.written(check.quantity, check.value),
        "sign": "≤" if check.bound is Bound.AT_MOST else "≥",
        "limit": judge.written(check.quantity, check.limit),
        "margin": judge.margin(check).replace("-", "−"),
        "verdict": judge.check_verdict(check).value,
        "advisory": check.advisory,
        "source": str(1 + sources.index(plain_text(check.source))) if sources else "",
    }
