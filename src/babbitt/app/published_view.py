"""The tab of published cases: each is run here when it is asked for."""

from __future__ import annotations

from nicegui import ui

from babbitt.app.answer import Table
from babbitt.app.parts import LongWork, Question, plain_box, show_table
from babbitt.app.published import published, scoreboard
from babbitt.app.solver import Questions
from babbitt.app.words import word

__all__ = ["PublishedView"]


class PublishedView:
    """Published cases.

    Parameters
    ----------
    solver : Questions
        Of long work.
    """

    def __init__(self, solver: Questions) -> None:
        ui.label(word("validation_help")).classes("small")
        found = published()
        self._chosen = ui.select([row[0] for row in found.rows], multiple=True, label=word("choose_cases"))
        self._chosen.props("dense use-chips").classes("w-full")
        LongWork(solver, word("run_cases"), self._asked, self._show, plain_box)
        show_table(found)

    def _asked(self) -> Question | None:
        if not self._chosen.value:
            ui.notify(word("choose_first"))
            return None
        return scoreboard, (tuple(self._chosen.value),)

    def _show(self, found: tuple[Table, ...]) -> None:
        for table in found:
            show_table(table)
