"""What stands in a report, as plain data: texts and numbers, never markup.

The typesetter gets this as JSON. Text from a case file is only ever a string in it.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from babbitt.core.language import keeping, language, phrases, translated, translated_if_known
from babbitt.core.quantities import QUANTITIES
from babbitt.core.report_level import Level
from babbitt.core.result import Result, Verdict
from babbitt.report import findings
from babbitt.report.bearing_content import (
    Data,
    assumptions_of,
    bearing_content,
    calculation_content,
    figures_content,
    sketch_content,
)
from babbitt.report.chapters import Chapter, chapters
from babbitt.report.check_content import check_content
from babbitt.report.checker_page import checker_content
from babbitt.report.citations import references
from babbitt.report.columns import footnote
from babbitt.report.findings import Group
from babbitt.report.labels import label
from babbitt.report.machine_table import (
    columns_of,
    counted_parts,
    in_machine_table,
    overview_columns,
    overview_results,
)
from babbitt.report.names import shown_name
from babbitt.report.scope import scope_of
from babbitt.report.symbols import symbol_node
from babbitt.report.text import plain_lines, plain_text
from babbitt.report.totals import Totals, totals
from babbitt.report.us_words import in_us_units
from babbitt.report.view import view_of

if TYPE_CHECKING:
    from babbitt.solving import MachineResult

ROUND_OFF = 1e-8
"""Relative difference of margins below which a search for the same load made it."""


def content(machine: MachineResult, level: Level = Level.FULL) -> Data:
    """Everything that the report says.

    Parameters
    ----------
    machine : MachineResult
    level : Level

    Returns
    -------
    dict
        Strings, numbers, lists and dictionaries only.
    """
    own_words = {plain_text(one) for one in machine.own_words}
    with keeping(own_words):
        return dict(in_us_units(_said(machine, level, own_words), own_words=own_words))


def _said(machine: MachineResult, level: Level, own_words: Collection[str]) -> Data:
    results = machine.results
    parts = chapters(machine.solutions)
    shared = _shared_assumptions(results, own_words) if level is Level.STANDARD else ()
    summed, marks = totals(results), footnote(columns_of(results), results)
    worst = [_worst_case(results, code) for code in _codes(results, level)]
    bearings = [
        _bearing(
            bearing_content(part, machine.given.get(part.shown.problem.name, ()), own_words),
            part,
            level,
            len(parts),
            shared,
        )
        for part in parts
    ]
    return {
        "language": language(),
        "words": dict(phrases(language())),
        "name": plain_text(machine.name) or translated("Unnamed case"),
        "version": machine.version,
        "hash": machine.case_hash,
        "source": plain_text(machine.source),
        "notes": plain_text(machine.notes),
        "count": _count(results),
        "columns": [{"heading": _heading(c.heading), "unit": c.unit} for c in columns_of(results)],
        "rows": _rows(parts, results),
        "incomplete": any(result.not_checked for result in results),
        **({"footnote": marks} if marks else {}),
        "conclusion": {
            "governing": _governing(results),
            "scope": list(scope_of(results)),
            "legend": _legend(results),
            "ranks": [column.rank for column in columns_of(results)],
            "references": [] if level is Level.SUMMARY else _references(machine),
            "left_to_standard": list(_left_to_standard(results)) if level is Level.SUMMARY else [],
        },
        "totals": _totals(summed) if summed else None,
        "worst": worst,
        "overview": _overview(() if level is Level.SUMMARY else results),
        "findings": _findings(results, level),
        "level": level.value,
        "shared_assumptions": list(shared),
        "bearings": bearings,
        "checker": None
        if level is Level.SUMMARY
        else checker_content(parts, worst, [one["inputs"] for one in bearings]),
        "case_text": plain_lines(machine.case_text).strip("\n") if level is Level.FULL else "",
    }


def _governing(results: Sequence[Result]) -> Data | None:
    """The limit that all bearings come closest to, or are farthest beyond; None where nothing was checked."""
    pairs = [(result, check) for result in results if (check := result.governing_check) is not None]
    if not pairs:
        return None
    result, check = min(pairs, key=lambda pair: pair[1].margin)
    return {**check_content(check), "bearing": shown_name(result.name)}


def _legend(results: Sequence[Result]) -> list[Data]:
    """What the symbols of the machine's table mean, and in which columns; of a limit its quantity says it."""
    if not any(in_machine_table(result) for result in results):
        return []
    solved = [result for result in results if result.outcome.solved]
    known = {
        QUANTITIES[name].symbol: (name, one.kind) for one in solved for name in one.values if name in QUANTITIES
    }
    wanted: dict[str, list[int]] = {}
    for place, column in enumerate(columns_of(results)):
        for symbol in column.symbols:
            wanted.setdefault(symbol, []).append(place)
    return [
        {"symbol": symbol_node(symbol), "said": label(*known[symbol]), "columns": places}
        for symbol, places in wanted.items()
        if symbol in known
    ]


def _references(machine: MachineResult) -> list[str]:
    computed = [(one.problem, view_of(one.result)) for one in machine.solutions]
    return [translated_if_known(plain_text(said)) for said in references(computed)]


MOST_WITH_FIGURES = 3
"""Bearings up to which a standard report has curves and maps; of more it has their drawings alone."""


def _shared_assumptions(results: Sequence[Result], own_words: Collection[str]) -> tuple[str, ...]:
    """What is assumed of every bearing of a machine of several."""
    if len({result.name for result in results}) < 2:
        return ()
    first, *others = (dict.fromkeys(assumptions_of([result], own_words)) for result in results)
    return tuple(said for said in first if all(said in other for other in others))


def _bearing(said: Data, part: Chapter, level: Level, count: int, shared: Sequence[str]) -> Data:
    """What a level of the report keeps of what is said of a bearing, with its calculation and figures."""
    said["assumptions"] = [one for one in said["assumptions"] if one not in shared]
    if level is Level.SUMMARY:
        empty: Data = {key: [] for key in ("inputs", "tables", "assumptions", "sections", "figures")}
        return said | empty | {"sketch": None}
    full = level is Level.FULL
    figures = figures_content(part) if full or count <= MOST_WITH_FIGURES else []
    sections = calculation_content(part) if full else []
    return said | {"sketch": sketch_content(part), "sections": sections, "figures": figures}


def _count(results: Sequence[Result]) -> str:
    found = Counter(result.verdict for result in results)
    incomplete = any(result.not_checked for result in results)
    said = {
        Verdict.PASS: "within all limits that could be checked" if incomplete else "within all limits",
        Verdict.REMARKS: "within the limits that could be checked, with remarks"
        if incomplete
        else "within the limits, with remarks",
        Verdict.FAIL: "beyond a limit",
        Verdict.NO_VERDICT: "without a verdict",
        Verdict.NO_SOLUTION: "without a solution",
    }
    parts = [f"{found[word]} {translated(words)}" for word, words in said.items() if found[word]]
    if not any(result.checks for result in results) and set(found) == {Verdict.PASS}:
        return ""
    return f"{counted_parts(results)}: {', '.join(parts)}."


def _totals(summed: Totals) -> Data:
    return {
        "heading": summed.heading,
        "sums": [{**vars(part), "symbol": symbol_node(part.symbol)} for part in summed.sums],
    }


def _heading(heading: str) -> list[Any]:
    """A column heading of several symbols, as nodes with their separators."""
    for separator in (" → ", " / "):
        if separator in heading:
            first, second = heading.split(separator)
            return [symbol_node(first), separator, symbol_node(second)]
    return [symbol_node(heading)]


def _rows(parts: Sequence[Chapter], results: Sequence[Result]) -> list[Data]:
    """One row a result, with the place of its chapter, counted from 1."""
    if not any(in_machine_table(result) for result in results):
        return []
    columns = [column.cells(results) for column in columns_of(results)]
    chapter_of = [place for place, part in enumerate(parts, start=1) for _ in part.members]
    return [
        {
            "name": shown_name(result.name),
            "chapter": chapter_of[place],
            "cells": [cells[place] for cells in columns],
            "verdict": result.verdict.value,
            "unchecked": str(len(result.not_checked) or ""),
        }
        for place, result in enumerate(results)
    ]


def _overview(results: Sequence[Result]) -> Data:
    """Bearings side by side once more, in the columns that their view has for that."""
    shown = overview_results(results)
    columns = overview_columns(shown)
    cells = [column.cells(shown) for column in columns]
    return {
        **({"footnote": marks} if (marks := footnote(columns, shown)) else {}),
        "columns": [{"heading": _heading(column.heading), "unit": column.unit} for column in columns],
        "rows": [
            {"name": shown_name(one.name), "cells": [each[place] for each in cells]}
            for place, one in enumerate(shown)
        ]
        if columns
        else [],
    }


def _codes(results: Sequence[Result], level: Level) -> list[tuple[str, str]]:
    """Codes and quantities of the checks of solved bearings, in their order; in a summary of limits alone."""
    checks = (check for result in results if result.outcome.solved for check in result.checks)
    found = {(c.code, c.quantity): None for c in checks if level is not Level.SUMMARY or not c.advisory}
    return sorted(found)


def _worst_case(results: Sequence[Result], of: tuple[str, str]) -> Data:
    """The bearing that comes closest to one limit; of several that do, the first."""
    pairs = [
        (result, check)
        for result in results
        if result.outcome.solved
        for check in result.checks
        if (check.code, check.quantity) == of
    ]
    worst = min(pairs, key=lambda pair: pair[1].margin)
    result, check = next(
        pair for pair in pairs
        if pair is worst or math.isclose(pair[1].margin, worst[1].margin, rel_tol=ROUND_OFF)
    )  # fmt: skip
    return {**check_content(check), "bearing": shown_name(result.name), "of": len(pairs)}


NOT_IN_SUMMARY = ("Recommendations and screening indicators missed", "Information", "Values not found")
"""Findings that change no verdict."""


def _findings(results: Sequence[Result], level: Level) -> list[Data]:
    sections = (
        ("No solution", findings.unsolved(results)),
        ("Limits violated", findings.missed_limits(results)),
        ("No verdict", findings.no_verdict(results)),
        ("Remarks", findings.remarks(results)),
        ("Recommendations and screening indicators missed", findings.missed_advice(results)),
        ("Information", findings.information(results)),
        ("Values not found", findings.missing_values(results)),
        ("Not checked, for want of data", findings.not_checked(results)),
    )
    return [
        {
            "heading": translated(heading),
            "groups": [_group(group) for group in groups],
            "decides": heading not in NOT_IN_SUMMARY and heading != "Not checked, for want of data",
        }
        for heading, groups in sections
        if groups and not (level is Level.SUMMARY and heading in NOT_IN_SUMMARY)
    ]


def _left_to_standard(results: Sequence[Result]) -> Iterator[str]:
    """What a summary counts, and the next level lists: recommendations that are missed, and assumptions."""
    missed = Counter(
        code
        for result in results
        if result.outcome.solved
        for code in {check.code for check in result.checks if check.advisory and not check.ok}
    )
    if missed:
        several = len(results) > 1
        codes = [f"{code} ({missed[code]})" if several else code for code in sorted(missed)]
        yield translated(
            "Recommendations and screening indicators missed, with the number of results: {codes}."
            if several
            else "Recommendations and screening indicators missed: {codes}.",
            codes=", ".join(codes),
        )
    if any(result.assumptions for result in results):
        yield translated("The calculation rests on assumptions: the report of the level `standard` lists them.")


def _group(group: Group) -> Data:
    return {
        "code": group.code,
        "title": group.title,
        "bearings": group.bearings if len(group.of) > 1 else "",
        "message": group.message,
        "remedy": group.remedy,
    }
