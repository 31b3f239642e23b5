"""The tab of fields: pressure, film thickness and temperature over the film, flat or as a surface."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from babbitt.app.document import CaseDocument
from babbitt.app.maps import Map, chart_of, fields_file, maps_of
from babbitt.app.parts import on_request
from babbitt.app.solver import Questions
from babbitt.app.words import word

__all__ = ["MapsView"]


class MapsView:
    """Fields of the films of a case, drawn when they are asked for.

    Parameters
    ----------
    solver : Questions
    document : CaseDocument
    """

    def __init__(self, solver: Questions, document: CaseDocument) -> None:
        self._solver, self._document = solver, document
        self._maps: dict[tuple[str, str], Map] = {}
        self._as_surface = True
        self._place: tuple[str, str] | None = None
        on_request(word("draw_maps"), self._draw)
        on_request(word("save_maps"), self._save)

    async def _draw(self, box: ui.column) -> None:
        found: tuple[Map, ...] = await self._solver.ask(maps_of, self._document.text)
        self._maps = {(one.bearing, one.name): one for one in found}
        box.clear()
        with box:
            if not self._maps:
                ui.label(word("no_maps"))
                return
            several = len({bearing for bearing, _ in self._maps}) > 1
            names = {
                place: f"{place[0]}: {one.meaning}" if several else one.meaning
                for place, one in self._maps.items()
            }
            self._place = self._place if self._place in self._maps else next(iter(self._maps))
            with ui.row().classes("items-center w-full"):
                ui.select(names, value=self._place, label=word("field"), on_change=self._chosen).classes("grow")
                ui.switch(word("as_surface"), value=self._as_surface, on_change=self._turned)
            self._chart = (
                ui.plotly(self._figure())
                .classes("w-full chart")
                .props(f'role="figure" aria-label="{word("field")}"')
            )

    async def _save(self, box: ui.column) -> None:
        content = await self._solver.ask(fields_file, self._document.text)
        box.clear()
        ui.download.content(content, self._document.file_name("fields.nc"))

    def _figure(self) -> dict[str, Any]:
        assert self._place is not None, "a field was chosen"
        return chart_of(self._maps[self._place], self._as_surface)

    def _chosen(self, event: Any) -> None:
        self._place = event.value
        self._chart.update_figure(self._figure())

    def _turned(self, event: Any) -> None:
        self._as_surface = bool(event.value)
        self._chart.update_figure(self._figure())
