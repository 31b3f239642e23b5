"""The tab of oils and bearing metals: tables and the viscosity chart; one of them is put into the case."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import ui

from babbitt.app.answer import Table
from babbitt.app.catalogue import FIELDS, field_for, metals, oils, viscosity_chart
from babbitt.app.document import CaseDocument
from babbitt.app.parts import show_table
from babbitt.app.words import word

__all__ = ["CatalogueView"]

FIRST = ("ISO VG 32", "ISO VG 46", "ISO VG 68")
"""Oils of the chart to begin with."""


class CatalogueView:
    """Oils and metals of the catalogue.

    Parameters
    ----------
    document : CaseDocument
    changed : callable
        Called when one was put into the case.
    """

    def __init__(self, document: CaseDocument, changed: Callable[[], None]) -> None:
        self.document, self._changed = document, changed
        found = oils()
        names = [row[0] for row in found.rows]
        chosen = ui.select(names, value=list(FIRST), multiple=True, label=word("oils_of_chart"))
        chosen.props("dense use-chips").classes("w-full")
        chart = ui.plotly(viscosity_chart(FIRST)).classes("w-full chart")
        chart.props(f'role="figure" aria-label="{word("viscosity_chart")}"')
        chosen.on_value_change(lambda event: chart.update_figure(viscosity_chart(event.value)))
        ui.label(word("viscosity_axes")).classes("small")
        self._table(found, "oil")
        self._table(metals(), "metal")

    def _table(self, found: Table, what: str) -> None:
        ui.label(word(f"{what}s")).classes("heading")
        names = [row[0] for row in found.rows]
        with ui.row().classes("items-center w-full"):
            chosen = ui.select(names, label=word(f"choose_{what}"), with_input=True).props("dense").classes("grow")

            def taken() -> None:
                if chosen.value is None:
                    ui.notify(word("choose_first"))
                else:
                    self._put(str(chosen.value), what)

            ui.button(word("take"), on_click=taken).props(f'outline no-caps aria-label="{word(f"take_{what}")}"')
        show_table(found)

    def _put(self, name: str, what: str) -> None:
        path = field_for(self.document.items, FIELDS[what])
        if path is None:
            ui.notify(word("no_such_field"), type="warning")
            return
        self.document.change(path, name)
        self._changed()
        ui.notify(word("taken", name=name))
