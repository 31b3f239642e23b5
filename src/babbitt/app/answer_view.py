"""The answer beside the form: verdict, cards with their limits, warnings, the drawing and the table of results."""

from __future__ import annotations

import math

from nicegui import ui

from babbitt.app.answer import Answer, Card, Finding, Shown, Table
from babbitt.app.parts import show_faults, show_table
from babbitt.app.words import word

__all__ = ["cards", "drawing", "results"]

ICONS = {"pass": "check_circle", "remarks": "info", "fail": "cancel", "no_verdict": "help", "no_solution": "error"}
"""Of verdicts, so that none is told by colour alone."""


def cards(answer: Answer, place: int, kept: Shown | None = None) -> None:
    """Verdict and numbers of one bearing, those of a design that was kept under them, or what is wrong."""
    if answer.faults:
        ui.label(word("faults")).classes("heading")
        show_faults(answer.faults)
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
    before = {card.label: card for card in kept.cards} if kept is not None else {}
    for card in shown.cards:
        _card(card, before.get(card.label))
    for finding in shown.findings:
        _finding(finding)


def _card(card: Card, before: Card | None) -> None:
    with ui.element("div").classes(f"card {card.word}"):
        with ui.row().classes("line"):
            ui.label(card.label).classes("name")
            ui.label(f"{card.symbol} = {card.value}").classes("number")
        if before is not None:
            ui.label(f"A: {before.value}").classes("small kept")
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
    heads = tuple(word(name) for name in ("quantity", "symbol", "value", "unit"))
    made = show_table(Table("", heads, shown.rows, words=2))
    made.columns[-1]["align"] = "left"
