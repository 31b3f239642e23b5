"""The tab of two designs: one is kept as A, the case on the page is B."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from babbitt.app.answer import Answer, Shown, answer
from babbitt.app.designs import side_by_side
from babbitt.app.document import CaseDocument
from babbitt.app.parts import on_request, show_faults, show_table
from babbitt.app.solver import Questions
from babbitt.app.words import word

__all__ = ["DesignsView"]


class DesignsView:
    """A design that is kept and compared with the one on the page.

    Parameters
    ----------
    solver : Questions
    page : callable
        Text and answer of the case as they stand, and the system of units in which they are shown.
    replace : callable
        Puts another text on the page.
    kept : callable
        Called when a design was kept.
    """

    def __init__(
        self,
        solver: Questions,
        page: Callable[[], tuple[str, Answer, str]],
        replace: Callable[[str], None],
        kept: Callable[[], None],
    ) -> None:
        self._solver, self._page, self._kept = solver, page, kept
        self._text, self._answer, self._system = "", Answer(), ""
        self._kind: Any = None
        with ui.row():
            ui.button(word("keep_design"), on_click=self._keep).props("outline no-caps")
            self._back = ui.button(word("back_to_design"), on_click=lambda: replace(self._text))
            self._back.props("flat no-caps").disable()
        self._said = ui.label(word("no_design")).classes("small")
        on_request(word("compare_designs"), self._compare)

    def of(self, place: int, kind: Any) -> Shown | None:
        """The bearing of the design that was kept at a place; None where there is none, or of another kind."""
        bearings = self._answer.bearings if kind == self._kind else ()
        return bearings[place] if place < len(bearings) else None

    async def follow(self, system: str) -> bool:
        """Show the design that was kept in a system of units; whether that is another one.

        Raises
        ------
        Ended
        """
        if not self._text or system == self._system:
            return False
        self._system = system
        self._answer = await self._solver.ask(answer, self._text)
        return True

    def _keep(self) -> None:
        self._text, self._answer, self._system = self._page()
        self._kind = CaseDocument(self._text).given.get("kind")
        name = self._answer.bearings[0].name if self._answer.bearings else ""
        self._said.text = word("design_kept", name=name)
        self._back.enable()
        self._kept()

    async def _compare(self, box: ui.column) -> None:
        if not self._text:
            box.clear()
            with box:
                ui.label(word("no_design"))
            return
        faults, tables = await self._solver.ask(side_by_side, self._text, self._page()[0])
        box.clear()
        with box:
            show_faults(faults)
            for table in tables:
                show_table(table)
