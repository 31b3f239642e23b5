"""What stands in a report, as plain data: texts and numbers, never markup.

The typesetter gets this as JSON. Text from a case file is only ever a string in it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from babbitt.report import verdict as judge
from babbitt.report.bearing_content import Data, bearing_content, check_content
from babbitt.report.columns import COLUMNS, is_film
from babbitt.report.symbols import symbol_node
from babbitt.report.text import counted_results, plain_text
from babbitt.report.verdict import Group, Verdict
from babbitt.results import Result

if TYPE_CHECKING:
    from babbitt.cases.build import AnyDesign
    from babbitt.solving import MachineResult


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
    cases: Sequence[AnyDesign | None] = machine.design_cases or [None] * len(results)
    return {
        "name": plain_text(machine.name) or "Unnamed case",
        "version": machine.version,
        "hash": machine.case_hash,
        "count": _count(results),
        "columns": [{"heading": _heading(c.heading), "unit": c.unit} for c in COLUMNS],
        "rows": _rows(results),
        "worst": [_worst_case(results, code) for code in _codes(results)],
        "findings": _findings(results),
        "bearings": [bearing_content(case, result) for case, result in zip(cases, results, strict=True)],
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
    if not any(result.checks for result in results) and set(found) == {Verdict.OK}:
        return ""
    return f"{counted_results([result.name for result in results])}: {', '.join(parts)}."


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
    return {**check_content(check), "bearing": plain_text(result.name), "of": len(pairs)}


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
