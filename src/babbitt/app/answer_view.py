"""The answer beside the form: verdict, cards with their limits, warnings, the drawing and the table of results."""

from __future__ import annotations

import math

from nicegui import ui

from babbitt.app.answer import Answer, Card, Finding, Shown
from babbitt.app.words import word

__all__ = ["cards", "drawing", "results"]

ICONS = {"pass": "check_circle", "remarks": "info", "fail": "cancel", "no_verdict": "help", "no_solution": "error"}
"""Of verdicts, so that none is told by colour alone."""


def cards(answer: Answer, place: int) -> None:
    """Verdict and numbers of one bearing, or what is wrong with the case."""
    if answer.faults:
        ui.label(word("faults")).classes("heading")
        for fault in answer.faults:
            where = f"{fault.field}: " if fault.field else f"{word('line')} {fault.line}: "
            ui.label(f"{where}{fault.message} [{fault.code}]").classes("fault")
        return
    shown = answer.bearings[place]
    with ui.row().classes(f"verdict {shown.verdict_key}").props('role="status"'):
        ui.icon(ICONS[shown.verdict_key])
        ui.label(shown.verdict).classes("word")
        if answer.quick:
            ui.label(word("quick")).classes("quick")
    ui.label(shown.method).classes("small")
    if shown.governing:
        ui.label(f"{word('governing')}: {shown.governing}").classes("small")
    for card in shown.cards:
        _card(card)
    for finding in shown.findings:
        _finding(finding)


def _card(card: Card) -> None:
    with ui.element("div").classes(f"card {card.word}"):
        with ui.row().classes("line"):
            ui.label(card.label).classes("name")
            ui.label(f"{card.symbol} = {card.value}").classes("number")
        if card.limit:
            used = min(card.share, 1.0) if math.isfinite(card.share) else 1.0
            with ui.element("div").classes("bar").props(f'role="img" aria-label="{_used(card)}"'):
                ui.element("div").classes("used").style(f"width: {100.0 * used:.0f}%")
            with ui.row().classes("line small"):
                ui.label(card.word).classes("word")
                ui.label(f"{card.limit} ({card.margin})")


def _used(card: Card) -> str:
    share = f"{100.0 * card.share:.0f} %" if math.isfinite(card.share) else "over 100 %"
    return f"{share} {word('used')}"


def _finding(finding: Finding) -> None:
    grave = " grave" if finding.grave else ""
    with ui.expansion(f"{finding.code} {finding.title}").classes(f"finding{grave}").props("dense"):
        ui.label(finding.message)
        if finding.remedy:
            ui.label(f"{word('what_to_do')}: {finding.remedy}")


def drawing(shown: Shown) -> None:
    """The bearing to look at."""
    if not shown.picture:
        ui.label(word("no_picture")).classes("small")
        return
    # Written by this package, every text in it escaped: what a sanitiser would do to it is spared.
    ui.html(shown.picture, sanitize=False).classes("drawing")
    ui.label(word("not_to_scale")).classes("small")


def results(shown: Shown) -> None:
    """Every number."""
    columns = [
        {"name": name, "label": said, "field": name, "align": align}
        for name, said, align in (
            ("quantity", word("quantity"), "left"),
            ("symbol", word("symbol"), "left"),
            ("value", word("value"), "right"),
            ("unit", word("unit"), "left"),
        )
    ]
    rows = [dict(zip(("quantity", "symbol", "value", "unit"), row, strict=True)) for row in shown.rows]
    ui.table(columns=columns, rows=rows, row_key="quantity").props("dense flat").classes("results")
