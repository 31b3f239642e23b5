"""The tables of a design: proposals, why they are so, what was not confirmed, or the nearest misses."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from babbitt.core.check_text import distance, number
from babbitt.core.quantities import QUANTITIES
from babbitt.report.study_values import MARGIN_DECIMALS, StudyTable, check_title, percent
from babbitt.report.text import plain_text
from babbitt.study.best_designs import edges, reasons_of, recommendation, verdict_said
from babbitt.study.candidates import CRITERION, Candidate
from babbitt.study.design import designs_of, rules_of
from babbitt.study.study import Study

__all__ = ["design_tables"]

REMEDIES = (
    "Try another diameter, a cooler supply or one of more pressure, other oils, another metal or other clearances."
)

Cells = dict[tuple[str, str], str]


def design_tables(study: Study) -> Iterator[StudyTable]:
    """The ranked proposals, or how near the best came to their limits."""
    found = designs_of(study)
    first, second = rules_of(study.description["kind"]).METHODS
    criterion = f"Ranked: {CRITERION.format(percent(study.block.reserve))}."
    counts = f"{found.within} of {found.computed} designs that were tried keep all limits by {first}"
    if found.proposals:
        rows = [_pair(study, place, pair) for place, pair in enumerate(found.proposals, 1)]
        kept = f"{counts}; each proposal is solved again by {second}, at all clearances of its fit."
        worst = "Margin, P_f and Q: the worst of the clearances; all other numbers are those of the mean one."
        recommended = f"Recommended: {recommendation(study)}."
        yield _table("Proposals", rows, (recommended, *edges(study), criterion, worst, kept))
        reasons = tuple((str(place), *_reasons(study, one)) for place, (one, _) in enumerate(found.proposals, 1))
        yield StudyTable("Why", (("no.", ""), ("governed by", ""), ("rules", "")), reasons, 3)
        yield from _meanings(found.proposals)
    else:
        rows = [_single(study, place, one) for place, one in enumerate(found.nearest, 1)]
        codes = dict.fromkeys(one.code for one in found.nearest if one.code)
        missed = "; ".join(map(check_title, codes))
        says = f"{counts}. These miss theirs least, by: {missed}. {REMEDIES}"
        yield _table("No design keeps all limits: the nearest misses", rows, (says, criterion))
    if found.refuted:
        rows = [_pair(study, place, pair) for place, pair in enumerate(found.refuted, 1)]
        yield _table(f"Within the limits by {first}, not by {second}", rows, ())
    case: dict[str, Any] = study.description["case"]
    if assumed := case.get("assumptions", ()):
        yield StudyTable("Assumptions", (("assumption", ""),), tuple((plain_text(str(one)),) for one in assumed))


def _meanings(proposals: Sequence[tuple[Candidate, Candidate]]) -> Iterator[StudyTable]:
    """What remarks and missed recommendations of the proposals mean."""
    codes = dict.fromkeys(code for pair in proposals for one in pair for code in (*one.remarks, *one.departures))
    rows = tuple((code, title) for code in codes if (title := check_title(code).removeprefix(code).strip()))
    if rows:
        note = "`babbitt explain CODE` says what each means, and what to do."
        yield StudyTable("Remarks and missed recommendations", (("code", ""), ("title", "")), rows, 2, (note,))


def _table(title: str, rows: Sequence[Cells], notes: tuple[str, ...]) -> StudyTable:
    heads = tuple(rows[0]) if rows else (("", ""),)
    return StudyTable(title, heads, tuple(tuple(row.values()) for row in rows), 4, notes)


def _single(study: Study, place: int, one: Candidate) -> Cells:
    shown = rules_of(study.description["kind"]).shown(one.fields, one.values)
    return {
        ("no.", ""): str(place),
        **{head: plain_text(cell) for head, cell in shown.items()},
        ("P_f", _unit("friction_power")): number("friction_power", one.power),
        ("Q", _unit("total_flow")): number("total_flow", one.flow),
        ("margin", ""): _margin(one),
        ("verdict", ""): verdict_said(one),
        ("misses", ""): ", ".join(one.departures),
    }


def _pair(study: Study, place: int, pair: tuple[Candidate, Candidate]) -> Cells:
    one, again = pair
    _, second = rules_of(study.description["kind"]).METHODS
    film = number("minimum_film_thickness", again.values.get("minimum_film_thickness", math.nan))
    return {
        **_single(study, place, one),
        (f"{second}: h_min", _unit("minimum_film_thickness")): film,
        (f"P_f by {second}", _unit("friction_power")): number("friction_power", again.power),
        (f"margin by {second}", ""): _margin(again),
        (f"verdict by {second}", ""): verdict_said(again),
    }


def _unit(quantity: str) -> str:
    return QUANTITIES[quantity].display.label


def _margin(one: Candidate) -> str:
    return f"{distance(one.margin, one.kelvin, MARGIN_DECIMALS)} {one.code}".strip()


def _reasons(study: Study, one: Candidate) -> tuple[str, str]:
    governing = f"{check_title(one.code)} {distance(one.margin, one.kelvin, MARGIN_DECIMALS)}"
    return governing, plain_text("; ".join(reasons_of(study, one)))
