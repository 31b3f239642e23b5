"""The tables of a design: proposals, why they are so, what was not confirmed, or the nearest misses."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from babbitt.core.check_text import distance, number
from babbitt.core.language import translated, translated_if_known
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
    ranking = translated(CRITERION, reserve=percent(study.block.reserve))
    criterion = translated("Ranked: {criterion}.", criterion=ranking)
    counts = translated(
        "{within} of {tried} designs that were tried keep all limits by {method}",
        within=found.within,
        tried=found.computed,
        method=first,
    )
    if found.proposals:
        rows = [_pair(study, place, pair) for place, pair in enumerate(found.proposals, 1)]
        kept = translated(
            "{counts}; each proposal is solved again by {method}, at all clearances of its fit.",
            counts=counts,
            method=second,
        )
        worst = translated(
            "Margin, P_f and Q: the worst of the clearances; all other numbers are those of the mean one."
        )
        recommended = translated("Recommended: {what}.", what=recommendation(study))
        yield _table(translated("Proposals"), rows, (recommended, *edges(study), criterion, worst, kept))
        reasons = tuple((str(place), *_reasons(study, one)) for place, (one, _) in enumerate(found.proposals, 1))
        yield StudyTable(translated("Why"), _heads("no.", "governed by", "rules"), reasons, 3)
        yield from _meanings(found.proposals)
    else:
        rows = [_single(study, place, one) for place, one in enumerate(found.nearest, 1)]
        codes = dict.fromkeys(one.code for one in found.nearest if one.code)
        missed = "; ".join(map(check_title, codes))
        says = translated("{counts}. These miss theirs least, by: {missed}.", counts=counts, missed=missed)
        says = f"{says} {translated(REMEDIES)}"
        yield _table(translated("No design keeps all limits: the nearest misses"), rows, (says, criterion))
    if found.refuted:
        rows = [_pair(study, place, pair) for place, pair in enumerate(found.refuted, 1)]
        title = translated("Within the limits by {first}, not by {second}", first=first, second=second)
        yield _table(title, rows, ())
    case: dict[str, Any] = study.description["case"]
    if assumed := case.get("assumptions", ()):
        told = tuple((plain_text(translated_if_known(str(one))),) for one in assumed)
        yield StudyTable(translated("Assumptions"), _heads("assumption"), told)


def _heads(*names: str) -> tuple[tuple[str, str], ...]:
    return tuple((translated(name), "") for name in names)


def _meanings(proposals: Sequence[tuple[Candidate, Candidate]]) -> Iterator[StudyTable]:
    """What remarks and missed recommendations of the proposals mean."""
    codes = dict.fromkeys(code for pair in proposals for one in pair for code in (*one.remarks, *one.departures))
    rows = tuple((code, title) for code in codes if (title := check_title(code).removeprefix(code).strip()))
    if rows:
        note = translated("`babbitt explain CODE` says what each means, and what to do.")
        yield StudyTable(
            translated("Remarks and missed recommendations"), _heads("code", "title"), rows, 2, (note,)
        )


def _table(title: str, rows: Sequence[Cells], notes: tuple[str, ...]) -> StudyTable:
    heads = tuple(rows[0]) if rows else (("", ""),)
    return StudyTable(title, heads, tuple(tuple(row.values()) for row in rows), 4, notes)


def _single(study: Study, place: int, one: Candidate) -> Cells:
    shown = rules_of(study.description["kind"]).shown(one.fields, one.values)
    return {
        (translated("no."), ""): str(place),
        **{head: plain_text(cell) for head, cell in shown.items()},
        ("P_f", _unit("friction_power")): number("friction_power", one.power),
        ("Q", _unit("total_flow")): number("total_flow", one.flow),
        (translated("margin"), ""): _margin(one),
        (translated("verdict"), ""): verdict_said(one),
        (translated("misses"), ""): ", ".join(one.departures),
    }


def _pair(study: Study, place: int, pair: tuple[Candidate, Candidate]) -> Cells:
    one, again = pair
    _, second = rules_of(study.description["kind"]).METHODS
    film = number("minimum_film_thickness", again.values.get("minimum_film_thickness", math.nan))
    return {
        **_single(study, place, one),
        (f"{second}: h_min", _unit("minimum_film_thickness")): film,
        (_by("P_f", second), _unit("friction_power")): number("friction_power", again.power),
        (_by(translated("margin"), second), ""): _margin(again),
        (_by(translated("verdict"), second), ""): verdict_said(again),
    }


def _by(what: str, method: str) -> str:
    return translated("{what} by {method}", what=what, method=method)


def _unit(quantity: str) -> str:
    return QUANTITIES[quantity].display.label


def _margin(one: Candidate) -> str:
    return f"{distance(one.margin, one.kelvin, MARGIN_DECIMALS)} {one.code}".strip()


def _reasons(study: Study, one: Candidate) -> tuple[str, str]:
    governing = f"{check_title(one.code)} {distance(one.margin, one.kelvin, MARGIN_DECIMALS)}"
    return governing, plain_text("; ".join(reasons_of(study, one)))
