"""What a chapter of the report says, as plain data: one bearing at one operating point."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator
from typing import Any

from babbitt.core.language import translated, translated_if_known, unit_sign
from babbitt.core.limited_flow import is_limited, is_short_of_oil, limited
from babbitt.core.notices import Effect, explanations
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.result import Result
from babbitt.report import findings
from babbitt.report import verdict as verdicts
from babbitt.report.chapters import Chapter, Member
from babbitt.report.check_content import check_content, compared_checks, solved_checks, sources_of
from babbitt.report.coefficient_temperatures import temperature_remark
from babbitt.report.columns import ABSENT, is_fed
from babbitt.report.drawing import Drawing
from babbitt.report.expression import text
from babbitt.report.inputs import Row, inputs
from babbitt.report.labels import label
from babbitt.report.line import Line, Section
from babbitt.report.machine_table import in_machine_table
from babbitt.report.meanings import remark_on_zero
from babbitt.report.names import format_members, shown_name
from babbitt.report.symbols import symbol_node
from babbitt.report.text import plain_text
from babbitt.report.units_of_matrices import suited_among

Data = dict[str, Any]

NOT_FOR_PAPER = ("wall_time", "iterations")
"""Results about the run rather than the bearing, and differ from run to run."""

OF_EVERY_FILM = ("specific_load", "surface_speed")
"""Results that load, speed and inputs alone decide."""

WARNING_HEADINGS = {
    Effect.NO_VERDICT: "No verdict: outside the validity of the model",
    Effect.QUESTIONS_RESULT: "Remarks",
    Effect.INFORMATION: "Information",
}
"""Headings of the warnings of a bearing, by what they do to its verdict."""


def bearing_content(chapter: Chapter, given: Collection[str] = (), own_words: Collection[str] = ()) -> Data:
    """What the report says of one bearing, but for calculation and figures.

    Parameters
    ----------
    chapter : Chapter
        One result, or several that differ in the clearance only: those stand side by side, and inputs,
        calculation and figures are those of one of them.
    given : collection of str
        Paths of the fields that the case has written; empty where that is not known.
    own_words : collection of str
        What the case itself assumes, which stays as it is.

    Returns
    -------
    dict
        Strings, numbers, lists and dictionaries only.
    """
    shown, several = chapter.shown, len(chapter.members) > 1
    view, result = chapter.view, shown.result
    sources = sources_of(chapter.results)
    checks = [check_content(check, sources) for check in solved_checks(result)]
    return {
        "name": shown_name(chapter.name),
        "clearances": [format_members([member.clearance]) for member in chapter.members] if several else [],
        "shown": format_members([shown.clearance]) if several and not view.of_every_state else "",
        "verdict": verdicts.worst_verdict(chapter.results).value,
        "unchecked": verdicts.unchecked(result),
        "lacking": [
            {"code": group.code, "title": group.title, "message": group.message}
            for group in findings.lacking(chapter.results)
        ],
        "method": translated(view.title or plain_text(result.method)),
        "outcomes": [_outcome(member) for member in chapter.members if not member.result.outcome.solved],
        "answers": [translated(plain_text(said)) for said in view.sentences(result)],
        "tables": [_table(table) for table in view.tables(result)],
        "heading": translated("Operating point" if in_machine_table(result) else "Results"),
        "results": _key_results(chapter) if result.outcome.solved else [],
        "axes": _axes(result),
        "inputs": [
            {
                "title": translated(group.title),
                "rows": [_input(row, left_out=row.is_left_out(view.left_out, given)) for row in group.rows],
            }
            for group in inputs(shown.problem, view, chapter.given)
        ],
        "assumptions": list(dict.fromkeys(assumptions_of(chapter.results, own_words))),
        "checks": compared_checks(chapter, sources) if several else checks,
        "sources": sources,
        "not_checked": [
            {"code": group.code, "title": group.title, "message": _said(group)}
            for group in findings.not_checked(chapter.results)
        ],
        "warnings": [
            {"heading": translated(heading), "found": found}
            for effect, heading in WARNING_HEADINGS.items()
            if (found := _warnings(chapter, effect))
        ],
    }


def assumptions_of(results: Iterable[Result], own_words: Collection[str] = ()) -> Iterator[str]:
    """What is assumed of some results; what the case itself says stays in its words."""
    every = (plain_text(said) for result in results for said in result.assumptions)
    return (said if said in own_words else translated_if_known(said) for said in every)


def calculation_content(chapter: Chapter) -> list[Data]:
    """The calculation of a bearing, line by line: formula, numbers put in, result."""
    return [
        {
            "title": heading,
            "remark": translated(section.remark),
            "lines": [_line(line, chapter.shown.result.kind) for line in section.lines],
        }
        for heading, section in _sections(chapter)
    ]


def figures_content(chapter: Chapter) -> list[Data]:
    """The figures of a bearing."""
    return [
        {
            "name": drawing.name,
            "caption": translated(drawing.caption),
            "svg": drawing.image.decode(),
            "wide": drawing.wide,
        }
        for drawing in figures_of(chapter)
    ]


def sketch_content(chapter: Chapter) -> Data | None:
    """The bearing to scale with its feed, load and rotation; None for what no drawing is known of."""
    picture = chapter.view.picture(chapter.shown.solution)
    return None if picture is None else {"svg": picture.printed(), "caption": picture.spoken, "tall": picture.tall}


def figures_of(chapter: Chapter) -> tuple[Drawing, ...]:
    """Figures of a chapter: of the member shown, or of every steady state."""
    members = chapter.members if chapter.view.of_every_state else (chapter.shown,)
    return tuple(drawing for member in members for drawing in chapter.view.report_figures(member.solution))


def _sections(chapter: Chapter) -> Iterator[tuple[str, Section]]:
    """The calculation of the member shown, or of every steady state, each section with its heading."""
    if not chapter.view.of_every_state:
        for section in chapter.view.sections(chapter.shown.solution):
            yield translated(section.title), section
        return
    for member in chapter.members:
        for section in chapter.view.sections(member.solution):
            if member.clearance:
                heading = f"{_capital(translated(member.clearance))}: {translated(section.title.lower())}"
            else:
                heading = translated(section.title)
            yield heading, section


def _capital(said: str) -> str:
    """A text with a large first letter; nouns within it keep theirs."""
    return said[:1].upper() + said[1:]


def _outcome(member: Member) -> Data:
    outcome = member.result.outcome
    explanation = explanations().get(outcome.code)
    message = plain_text(member.result.message).removesuffix(".")
    return {
        "clearance": f"{_capital(format_members([member.clearance]))}: " if member.clearance else "",
        "code": outcome.code,
        "title": translated(outcome.value),
        "message": _capital(message),
        "remedy": explanation.remedy if explanation else "",
    }


def _key_results(chapter: Chapter) -> list[Data]:
    result = chapter.shown.result
    every = dict.fromkeys(name for r in chapter.results if r.outcome.solved for name in r.values)
    names = chapter.view.key_results or tuple(name for name in every if name not in NOT_FOR_PAPER)
    if not is_fed(result):
        names = tuple(name for name in names if name not in chapter.view.fed_results)
    if len(chapter.members) > 1:
        names = tuple(one for name in ("relative_clearance", *names) for one in (name, limited(name)))
    rows = []
    for name in names:
        values = [r.values.get(name, math.nan) if r.outcome.solved else math.nan for r in chapter.results]
        if name in QUANTITIES and any(map(math.isfinite, values)):
            quantity = suited_among(name, *(r.values for r in chapter.results if r.outcome.solved))
            zero = "".join({remark_on_zero(name, value) for value in values})
            row = {
                "label": label(name, result.kind) + zero + temperature_remark(name, result),
                "symbol": symbol_node(quantity.symbol),
                "values": [quantity.format(value) if math.isfinite(value) else ABSENT for value in values],
                "unit": quantity.display.label,
                **({"of_limited_film": True} if is_limited(name) else {}),
            }
            rows.append(row | _of_limited_film(chapter, name, quantity))
    rows += [
        {
            "label": f"{label(name, result.kind)}: {translated(reason)}",
            "symbol": symbol_node(QUANTITIES[name].symbol),
            "values": [ABSENT] * len(chapter.results),
            "unit": "",
        }
        for name, reason in result.missing.items()
    ]
    return [*rows, *(row | {"label": translated(row["label"])} for row in chapter.view.rows(chapter.results))]


def _axes(result: Result) -> str:
    """What the subscripts of coefficients mean; empty where there are none of two axes."""
    if "stiffness_xy" not in result.values:
        return ""
    return translated(
        "x points to the right and y upward, as drawn; k_xy is the force in x that resists a move in y: the force"
        " of the film changes by −(K dx + C dx/dt)."
    )


def _of_limited_film(chapter: Chapter, name: str, quantity: Quantity) -> Data:
    """The same with the flow that the supply delivers, for a bearing short of oil; a dash where it has none."""
    result = chapter.shown.result
    if len(chapter.members) > 1 or not is_short_of_oil(result):
        return {}
    value = result.values.get(name if name in OF_EVERY_FILM else limited(name), math.nan)
    return {"limited": quantity.format(value) if math.isfinite(value) else ABSENT}


def _line(line: Line, kind: str) -> Data:
    return {
        "meaning": label(line.name, kind),
        "symbol": line.symbol,
        "formula": line.formula,
        "substituted": line.substituted,
        "results": [{"number": number, "unit": unit} for number, unit in line.results],
        "remark": translated(plain_text(line.remark)),
        "spoken": f"{text(line.symbol)} = {text(line.results[-1][0])} {line.results[-1][1]}".strip(),
    }


def _input(row: Row, *, left_out: bool) -> Data:
    return {
        "symbol": row.symbol,
        "label": translated_if_known(row.label),
        "value": translated_if_known(row.value),
        "unit": unit_sign(row.unit),
        **({"left_out": True} if left_out else {}),
    }


def _table(table: Data) -> Data:
    heads = [head | {"text": translated_if_known(head["text"])} for head in table["columns"]]
    rows = [[translated_if_known(cell) for cell in row] for row in table["rows"]]
    return table | {
        "title": translated(table["title"]), "columns": heads, "rows": rows, "note": translated(table["note"])
    }  # fmt: skip


def _said(group: findings.Group) -> str:
    return group.message if set(group.names) == set(group.of) else f"{group.message}: {group.bearings}"


def _warnings(chapter: Chapter, effect: Effect) -> list[Data]:
    """Warnings of one effect of all members, one a code; those that some members lack say whose they are."""
    found: dict[str, dict[str, list[str]]] = {}
    for member in chapter.members:
        for notice in (one for one in member.result.warnings if one.effect is effect):
            messages = found.setdefault(notice.code, {})
            messages.setdefault(plain_text(notice.message), []).append(member.clearance)
    return [
        {
            "code": code,
            "title": explanations()[code].title,
            "message": "; ".join(
                f"{message} ({format_members(whose)})" if 0 < len(whose) < len(chapter.members) else message
                for message, whose in messages.items()
            ),
            "remedy": explanations()[code].remedy,
        }
        for code, messages in found.items()
    ]
