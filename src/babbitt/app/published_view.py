"""The tab of published cases: each is run here when it is asked for."""

from __future__ import annotations

from nicegui import ui

from babbitt.app.answer import Table
from babbitt.app.parts import LongWork, Question, show_table
from babbitt.app.published import published, scoreboard
from babbitt.app.solver import Solver
from babbitt.app.words import word

__all__ = ["PublishedView"]


class PublishedView:
    """Published cases.

    Parameters
    ----------
    solver : Solver
        Of long work.
    """

    def __init__(self, solver: Solver) -> None:
        ui.label(word("validation_help")).classes("small")
        LongWork(solver, word("run_cases"), self._asked, self._show)
        self._table = show_table(published())
        self._table.set_selection("multiple")

    def _asked(self) -> Question | None:
        if not self._table.selected:
            ui.notify(word("choose_first"))
            return None
        return scoreboard, (tuple(row["0"] for row in self._table.selected),)

    def _show(self, found: tuple[Table, ...]) -> None:
        for table in found:
            show_table(table)
