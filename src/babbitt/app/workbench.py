"""One page: a case at the left, its drawing in the middle, its answer at the right, more of it below."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from nicegui import background_tasks, context, events, ui

from babbitt.app import answer_view
from babbitt.app.answer import Answer, answer, compared, figures, json_of, report_of
from babbitt.app.document import CaseDocument
from babbitt.app.form_view import FormView
from babbitt.app.link import case_of, link_of
from babbitt.app.slider import Slider
from babbitt.app.solver import LONGEST, Ended, Latest, Solver
from babbitt.app.words import word
from babbitt.case.loading import LARGEST_FILE
from babbitt.core.kind import kinds

__all__ = ["Workbench"]


class Workbench:
    """A page with a case; every visitor has one.

    Parameters
    ----------
    solver : Solver
    text : str
        The case to begin with.
    """

    def __init__(self, solver: Solver, text: str) -> None:
        self.solver, self.latest = solver, Latest(solver)
        self.document = CaseDocument(text)
        self.found = Answer()
        self.place = 0

    def build(self) -> None:
        """Draw the page."""
        self._client = context.client
        self._head()
        with ui.element("main").classes("bench"):
            with ui.element("section").classes("case").props(f'aria-label="{word("form")}"'):
                self._case()
            with ui.element("section").classes("bearing").props(f'aria-label="{word("bearing")}"'):
                self._drawing = ui.column().classes("w-full")
                self._tabs()
            with ui.element("section").classes("answer").props(f'aria-label="{word("results")}" id="answer"'):
                self._cards = ui.column().classes("w-full")
        ui.on("turned", self._turned, args=["field", "angle"])
        ui.timer(0.1, self._begin, once=True)

    def _head(self) -> None:
        with ui.header().classes("head"):
            ui.link(word("skip"), "#answer").classes("skip")
            ui.label(word("title")).classes("title")
            with ui.button(word("new"), icon="note_add").props("flat dense"), ui.menu():
                for name, kind in kinds().items():
                    self._entry(kind.description, partial(self._template, name))
            self._icon("folder_open", word("open"), lambda: self._upload.run_method("pickFiles"))
            self._upload = ui.upload(
                on_upload=self._opened, on_rejected=lambda: ui.notify(word("too_large"), type="negative"),
                max_file_size=LARGEST_FILE, auto_upload=True,
            ).classes("hidden")  # fmt: skip
            self._icon("save", word("save"), lambda: ui.download.content(self.document.text, "case.yaml"))
            self._icon("undo", word("undo"), lambda: self._step(self.document.undo))
            self._icon("redo", word("redo"), lambda: self._step(self.document.redo))
            self._icon("link", word("share"), self._share)
            with ui.button(word("report"), icon="description").props("flat dense"), ui.menu():
                self._entry(word("as_pdf"), lambda: self._report("pdf"))
                self._entry(word("as_html"), lambda: self._report("html"))
                self._entry(word("as_json"), self._json)
            ui.space()
            dark = ui.dark_mode(None)  # as the system has it
            self._icon("contrast", word("dark"), lambda: dark.set_value(not dark.value))

    def _entry(self, says: str, pressed: Callable[[], Any]) -> None:
        ui.menu_item(says, pressed).props('role="menuitem"')

    def _icon(self, icon: str, says: str, pressed: Callable[[], Any]) -> None:
        ui.button(icon=icon, on_click=pressed).props(f'flat dense round aria-label="{says}"').tooltip(says)

    def _case(self) -> None:
        with ui.tabs().props("dense") as tabs:
            form, text = ui.tab(word("form")), ui.tab(word("text"))
        with ui.tab_panels(tabs, value=form).classes("w-full panels").props("keep-alive"):
            with ui.tab_panel(form):
                self._form = FormView(self.document, self._changed)
            with ui.tab_panel(text):
                self._editor = ui.codemirror(
                    self.document.text, language="YAML", on_change=self._typed, line_wrapping=True
                ).classes("editor").props(f'aria-label="{word("case_text")}"')  # fmt: skip

    def _tabs(self) -> None:
        with ui.tabs().props("dense align=left") as tabs:
            explore, results, pictures, methods = (
                ui.tab(word(name)) for name in ("explore", "results", "figures", "compare")
            )
        with ui.tab_panels(tabs, value=explore).classes("w-full panels"):
            with ui.tab_panel(explore):
                self._slider = Slider(self.document, self._slid, self._changed)
            with ui.tab_panel(results):
                self._results = ui.column().classes("w-full")
            with ui.tab_panel(pictures):
                self._on_request(word("draw_figures"), self._draw_figures)
            with ui.tab_panel(methods):
                self._on_request(word("run_comparison"), self._compare)

    def _on_request(self, says: str, work: Callable[[ui.column], Any]) -> None:
        button = ui.button(says).props("outline")
        box = ui.column().classes("w-full")

        async def pressed() -> None:
            button.disable()
            box.clear()
            with box:
                ui.label(word("working"))
            try:
                await work(box)
            except Ended as ended:
                box.clear()
                with box:
                    ui.label(word(ended.why, seconds=LONGEST))
            finally:
                button.enable()

        button.on_click(pressed)

    async def _begin(self) -> None:
        """Take the case of the link, if there is one, and answer."""
        fragment = await ui.run_javascript("return location.hash", timeout=5.0)
        if fragment and len(str(fragment)) > 1:
            text = case_of(str(fragment))
            if text is None:
                ui.notify(word("not_a_link"), type="negative")
            else:
                self._replace(text)
                return
        await self._answer(False)

    def _template(self, kind: str) -> None:
        self._replace(kinds()[kind].read_template())

    async def _opened(self, event: events.UploadEventArguments) -> None:
        content = await event.file.read()
        self._upload.reset()
        if len(content) > LARGEST_FILE:
            ui.notify(word("too_large"), type="negative")
            return
        self._replace(content.decode("utf-8", errors="replace"))

    def _replace(self, text: str) -> None:
        self.document.write(text)
        self.place = 0
        self._all_anew()

    def _step(self, move: Callable[[], None]) -> None:
        move()
        self._all_anew()

    def _all_anew(self) -> None:
        self._form.draw()
        self._slider.draw()
        self._editor.set_value(self.document.text)
        self._ask(False)

    def _typed(self, event: events.ValueChangeEventArguments[Any]) -> None:
        if event.value != self.document.text:
            self.document.write(event.value)
            self._form.draw()
            self._slider.draw()
            self._ask(False)

    def _changed(self) -> None:
        """The form changed the document."""
        if self._editor.value != self.document.text:
            self._editor.set_value(self.document.text)
        self._ask(False)

    def _slid(self) -> None:
        """A slider is moving: an answer on the draft grid will do."""
        self._ask(True)

    def _turned(self, event: events.GenericEventArguments) -> None:
        """A hand turned the load or a feed."""
        field, angle = event.args["field"], float(event.args["angle"])
        path = tuple(int(step) if step.isdecimal() else step for step in str(field).split("."))
        if len(path) > 1 and not self.document.has(path[:-1]):
            return
        self.document.change(path, f"{angle:.1f} deg")
        self._all_anew()

    def _ask(self, quick: bool) -> None:
        """Answer in a task of its own: the control that asked may be gone by then."""
        background_tasks.create(self._answer(quick))

    async def _answer(self, quick: bool) -> None:
        with self._client:
            await self._answered(quick)

    async def _answered(self, quick: bool) -> None:
        try:
            found = await self.latest.ask(answer, self.document.text, quick)
        except Ended as ended:
            if ended.why != "cancelled":
                ui.notify(word(ended.why, seconds=LONGEST), type="warning")
            return
        if found is None:
            return
        self.found = found
        self._form.blame(found.faults)
        self.place = min(self.place, max(len(found.bearings) - 1, 0))
        self._show()

    def _show(self) -> None:
        self._cards.clear()
        with self._cards:
            if len(self.found.bearings) > 1:
                names = {number: one.name for number, one in enumerate(self.found.bearings)}
                ui.select(names, value=self.place, label=word("bearing"), on_change=self._chosen).props("dense")
            answer_view.cards(self.found, self.place)
        if self.found.faults:
            self._drawing.classes(add="stale")  # what is drawn is what was solved last
            return
        self._drawing.classes(remove="stale")
        shown = self.found.bearings[self.place]
        self._drawing.clear()
        with self._drawing:
            answer_view.drawing(shown)
        if not self.found.quick:
            self._results.clear()
            with self._results:
                answer_view.results(shown)

    def _chosen(self, event: events.ValueChangeEventArguments[Any]) -> None:
        self.place = event.value
        self._show()

    async def _draw_figures(self, box: ui.column) -> None:
        found = await self.solver.ask(figures, self.document.text)
        box.clear()
        with box:
            for figure in found:
                ui.html(figure.svg, sanitize=False).classes("figure")  # drawn by this package, texts as paths
                ui.label(figure.caption).classes("small")

    async def _compare(self, box: ui.column) -> None:
        found = await self.solver.ask(compared, self.document.text)
        box.clear()
        with box:
            for table in found:
                heads = (word("quantity"), *table.heads)
                columns = [
                    {"name": str(n), "label": head, "field": str(n), "align": "right" if n else "left"}
                    for n, head in enumerate(heads)
                ]
                rows = [{str(n): cell for n, cell in enumerate(row)} for row in table.rows]
                ui.table(columns=columns, rows=rows, row_key="0", title=table.title).props("dense flat")
                for remark in table.remarks:
                    ui.label(remark).classes("small")

    async def _report(self, report_format: str) -> None:
        await self._download(report_of, f"report.{report_format}", self.document.text, report_format)

    async def _json(self) -> None:
        await self._download(json_of, "results.json", self.document.text)

    async def _download(self, function: Callable[..., Any], name: str, *given: Any) -> None:
        ui.notify(word("working"))
        try:
            content = await self.solver.ask(function, *given)
        except Ended as ended:
            ui.notify(word(ended.why, seconds=LONGEST), type="warning")
            return
        ui.download.content(content, name)

    async def _share(self) -> None:
        link = link_of(self.document.text)
        await ui.run_javascript(
            f"history.replaceState(null, '', '#{link}'); navigator.clipboard?.writeText(location.href)"
        )
        ui.notify(word("shared"))
