"""The answer as markup: one text for each part of it, so that an answer costs the server little.

Elements are made as a tree, which escapes every text of a case.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable
from xml.etree import ElementTree

from babbitt.app.answer import Answer, Card, Finding, Shown
from babbitt.app.words import told, word
from babbitt.core.quantities import QUANTITIES
from babbitt.report.picture import SUBSCRIPT

__all__ = ["cards_markup", "findings_markup", "verdict_markup"]

ICONS = {"pass": "check_circle", "remarks": "info", "fail": "cancel", "no_verdict": "help", "no_solution": "error"}
"""Of verdicts, so that none differs by colour alone."""

SYMBOLS = {one.symbol for one in QUANTITIES.values() if "_" in one.symbol}
SYMBOL = re.compile(rf"(?<![\w.`'])({'|'.join(map(re.escape, sorted(SYMBOLS, key=len, reverse=True)))})(?!\w)")
"""A symbol with a subscript within a text."""

Element = ElementTree.Element


def verdict_markup(shown: Shown, answer: Answer) -> str:
    """Verdict, method and governing check of one bearing, of several under the worst verdict of all."""
    several = len(answer.bearings) > 1
    row = _verdict(answer.bearings[answer.worst] if several else shown)
    if answer.quick:
        _within(row, "quick", word("quick"))
    made = [row]
    if several:
        counted = Counter(one.verdict for one in answer.bearings)
        said = ", ".join(f"{number} × {verdict}" for verdict, number in counted.items())
        made += [
            _part("small", f"{word('all_bearings')}: {said}"),
            _part("small name", shown.name),
            _verdict(shown),
        ]
    made.append(_part("small", shown.method))
    if shown.governing:
        made.append(_part("small", f"{word('governing')}: {shown.governing}"))
    return _text(made)


def _verdict(shown: Shown) -> Element:
    row = _part(f"verdict {shown.verdict_key}")
    _within(row, "q-icon material-icons", ICONS[shown.verdict_key], "i", {"aria-hidden": "true"})
    _within(row, "word", shown.verdict)
    return row


def cards_markup(cards: Iterable[Card], kept: Shown | None = None) -> str:
    """Numbers with their limits, those of a design that was kept under them."""
    before = {card.label: card for card in kept.cards} if kept is not None else {}
    return _text(_card(card, before.get(card.label)) for card in cards)


def findings_markup(findings: Iterable[Finding]) -> str:
    """Warnings and what was not checked, each to be opened."""
    return _text(map(_finding, findings))


def _card(card: Card, before: Card | None) -> Element:
    made = _part(f"card {card.word}".strip())
    line = _within(made, "line")
    _within(line, "name", card.label)
    _symbol(_within(line, "number"), card.symbol, f" = {card.value}")
    if before is not None:
        _within(made, "small kept", f"A: {before.value}")
    if card.limit:
        used = min(card.share, 1.0) if math.isfinite(card.share) else 1.0
        bar = _within(made, "bar", attributes={"role": "img", "aria-label": _used(card)})
        _within(bar, "used", attributes={"style": f"width: {100.0 * used:.0f}%"})
        line = _within(made, "line small")
        advice = word("advice_missed" if card.word == "missed" else "advice_kept")
        _within(line, "word", advice if card.is_advice else told(card.word))
        _within(line, "", f"{card.limit} ({card.margin})")
    return made


def _symbol(outer: Element, symbol: str, after: str) -> None:
    """A symbol with its subscript, and what stands behind it."""
    stem, *lower = re.split(SUBSCRIPT, symbol, maxsplit=1)
    outer.text = stem if lower else stem + after
    if lower:
        _within(outer, "", lower[0], "sub").tail = lower[1] + after


def _used(card: Card) -> str:
    share = f"{100.0 * card.share:.0f} %" if math.isfinite(card.share) else word("over_all")
    return f"{share} {word('used')}"


def _finding(finding: Finding) -> Element:
    made = _part("finding grave" if finding.grave else "finding", tag="details")
    _written(_within(made, "", tag="summary"), f"{finding.code} {finding.title}".strip())
    _written(_within(made, ""), finding.message)
    if finding.remedy:
        _written(_within(made, ""), f"{word('what_to_do')}: {finding.remedy}")
    return made


def _written(outer: Element, text: str) -> None:
    """A text, its symbols with their subscripts."""
    outer.text, *parts = re.split(SYMBOL, text)
    for symbol, after in zip(parts[::2], parts[1::2], strict=True):
        stem, lower, *rest = re.split(SUBSCRIPT, symbol, maxsplit=1)
        if len(outer):
            outer[-1].tail = f"{outer[-1].tail or ''}{stem}"
        else:
            outer.text += stem
        _within(outer, "", lower, "sub").tail = "".join((*rest, after))


def _part(style: str, text: str = "", tag: str = "div", attributes: dict[str, str] | None = None) -> Element:
    made = ElementTree.Element(tag, {**({"class": style} if style else {}), **(attributes or {})})
    made.text = text
    return made


def _within(
    outer: Element, style: str, text: str = "", tag: str = "div", attributes: dict[str, str] | None = None
) -> Element:
    made = _part(style, text, tag, attributes)
    outer.append(made)
    return made


def _text(parts: Iterable[Element]) -> str:
    return "".join(ElementTree.tostring(part, encoding="unicode", method="html") for part in parts)
