"""The tab of coefficients for rotor programs: speeds and format, the calculation, the file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from nicegui import ui

from babbitt.app.coefficients import FEWEST, CoefficientFile, Speeds, coefficient_file, first_speeds
from babbitt.app.document import CaseDocument
from babbitt.app.parts import LongWork, Question, show_faults, show_table
from babbitt.app.solver import Questions
from babbitt.app.words import told, word
from babbitt.export import FORMATS

__all__ = ["CoefficientsView"]


class CoefficientsView:
    """Coefficients over speed of the bearing that is shown.

    Parameters
    ----------
    document : CaseDocument
    solver : Questions
        Of long work.
    bearing : callable
        Name of the bearing that is shown, None where there is one alone.
    """

    def __init__(self, document: CaseDocument, solver: Questions, bearing: Callable[[], str | None]) -> None:
        self._document, self._bearing = document, bearing
        self._format = next(iter(FORMATS))
        self._first: Speeds | None = None
        ui.label(word("coefficients_help")).classes("small")
        self._box = ui.row().classes("axis")
        LongWork(solver, word("run_coefficients"), self._asked, self._show)
        self.draw()

    def draw(self) -> None:
        """Draw the speeds anew: another case. What was typed stays where the case has the same speed."""
        first = first_speeds(self._document)
        if first == self._first:
            return
        self._first = self._speeds = first
        self._box.clear()
        with self._box:
            for part, says in (("first", "from"), ("last", "to")):
                ui.input(
                    word(says), value=getattr(self._speeds, part),
                    on_change=lambda event, part=part: self._set(part, str(event.value or "").strip()),
                ).props(f'dense aria-label="{word("speed")} {word(says)}"').classes("end")  # fmt: skip
            ui.number(
                word("points"), value=self._speeds.number, min=FEWEST, max=100, precision=0,
                on_change=lambda event: self._set("number", int(event.value or FEWEST)),
            ).props("dense").classes("narrow")  # fmt: skip
            ui.select(
                {name: f"{name}: {told(one.meaning)}" for name, one in FORMATS.items()}, value=self._format,
                label=word("format"), on_change=self._formatted,
            ).props("dense").classes("grow")  # fmt: skip

    def _set(self, part: str, value: Any) -> None:
        self._speeds = replace(self._speeds, **{part: value})

    def _formatted(self, event: Any) -> None:
        self._format = event.value

    def _asked(self) -> Question | None:
        return coefficient_file, (self._document.text, self._bearing(), self._speeds, self._format)

    def _show(self, found: CoefficientFile) -> None:
        show_faults(found.faults)
        for table in found.tables:
            show_table(table)
        for line in found.remarks:
            ui.label(line).classes("small")
        if found.content:
            name = self._document.file_name(found.name)
            ui.download.content(found.content, name)
            ui.button(
                word("download_again"), on_click=lambda: ui.download.content(found.content, name)
            ).props("flat dense no-caps")  # fmt: skip
