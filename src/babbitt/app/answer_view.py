"""The answer beside the form: verdict, cards with their limits, warnings, the drawing and the table of results."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from babbitt.app.answer import Answer, Shown, Table
from babbitt.app.answer_markup import cards_markup, findings_markup, verdict_markup
from babbitt.app.parts import icon_button, rows_of_table, show_faults, show_table
from babbitt.app.words import word
from babbitt.core.result import Verdict

__all__ = ["AnswerView", "DrawingView", "ResultsView"]

NO_SOLUTION = Verdict.NO_SOLUTION.key


class AnswerView:
    """Verdict, numbers and warnings of one bearing, or what is wrong with the case.

    Parameters
    ----------
    chosen : callable
        Called with the number of the bearing to show.
    """

    def __init__(self, chosen: Callable[[int], None]) -> None:
        self._place = 0
        self._chosen = chosen
        self._bearings = ui.select({}, label=word("bearing"), on_change=self._choose).props("dense")
        self._bearings.classes("w-full").set_visibility(False)
        self._verdict = _markup("").props('role="status"')
        self._faults = ui.column().classes("w-full")
        self._cards, self._findings = _markup(""), _markup("")

    def _choose(self, event: Any) -> None:
        if event.value is not None and event.value != self._place:
            self._chosen(event.value)

    def show(self, answer: Answer, place: int, kept: Shown | None = None) -> None:
        """Show one bearing of an answer, and the numbers of a design that was kept."""
        self._place = place
        self._faults.clear()
        if answer.faults:
            self._clear()
            with self._faults:
                ui.label(word("faults")).classes("heading")
                show_faults(answer.faults)
            return
        names = {number: f"{one.name}: {one.verdict}" for number, one in enumerate(answer.bearings)}
        if names != self._bearings.options or self._bearings.value != place:
            self._bearings.set_options(names, value=place)
            self._bearings.set_visibility(len(names) > 1)
        shown = answer.bearings[place]
        self._verdict.content = verdict_markup(shown, answer)
        self._cards.content = cards_markup(shown.cards, kept)
        self._findings.content = findings_markup(shown.findings)

    def fail(self, why: str) -> None:
        """Show why there is no answer."""
        self._faults.clear()
        self._clear()
        with self._faults:
            ui.label(why).classes("fault").props('role="alert"')

    def _clear(self) -> None:
        for part in (self._verdict, self._cards, self._findings):
            part.content = ""


class DrawingView:
    """The bearing to look at; what is drawn is what was solved last."""

    def __init__(self) -> None:
        self._picture = _markup("drawing")
        with ui.row().classes("w-full items-center no-wrap"):
            self._said = ui.label("").classes("small grow")
            self._moves = icon_button(
                "motion_photos_paused", word("hold_motion"), lambda: ui.run_javascript("babbitt.hold()")
            )
        self._moves.set_visibility(False)

    def show(self, shown: Shown) -> None:
        """Draw a bearing."""
        self._picture.classes(remove="stale")
        self._picture.content = shown.picture
        nothing = "no_picture" if shown.verdict_key != NO_SOLUTION else "not_drawn"
        self._said.text = word("not_to_scale" if shown.picture else nothing)
        self._moves.set_visibility(shown.moves)

    def fade(self) -> None:
        """Show that the case on the page has no solution that could be drawn."""
        self._picture.classes(add="stale")


class ResultsView:
    """Every number."""

    def __init__(self) -> None:
        heads = tuple(word(name) for name in ("quantity", "symbol", "value", "unit"))
        self._table = show_table(Table("", heads, (), words=2))
        self._table.columns[-1]["align"] = "left"

    def show(self, shown: Shown) -> None:
        """Fill the table anew."""
        self._table.classes(remove="stale")
        self._table.rows = rows_of_table(shown.rows)

    def fade(self) -> None:
        """Show that the numbers are not those of the case on the page."""
        self._table.classes(add="stale")


def _markup(style: str) -> ui.html:
    """A place for markup that this package writes, every text in it escaped: it needs no sanitiser."""
    return ui.html("", sanitize=False).classes(f"w-full {style}")
