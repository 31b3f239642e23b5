"""The head of the page: templates, files, the way back, what is taken along from the page."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from nicegui import events, ui

from babbitt.app.answer import json_of, report_of
from babbitt.app.document import CaseDocument
from babbitt.app.link import link_of
from babbitt.app.parts import icon_button, tell_ended
from babbitt.app.python_text import python_of
from babbitt.app.solver import Ended, Questions
from babbitt.app.words import page_language, word
from babbitt.case.loading import LARGEST_FILE
from babbitt.core.kind import kinds
from babbitt.core.language import translated
from babbitt.core.notices import InputError

if TYPE_CHECKING:
    from babbitt.report.document import Format

__all__ = ["Head"]


TONGUES = {"en": "English", "de": "Deutsch", "ru": "Русский"}
"""Names of the languages, each in itself."""


class Head:
    """Buttons and menus at the top.

    Parameters
    ----------
    document : CaseDocument
    solver : Questions
    replaced, stepped, darken : callable
        Called when the whole case is another one, when it is an earlier or later one again, and to change between
        light and dark.
    """

    def __init__(
        self, document: CaseDocument, solver: Questions, replaced: Callable[[], None],
        stepped: Callable[[], None], darken: Callable[[], None],
    ) -> None:  # fmt: skip
        self.document, self._solver, self._replaced, self._stepped = document, solver, replaced, stepped
        with ui.header().classes("head"):
            for section in ("form", "results", "more"):  # page.js goes there without another address
                ui.link(word(f"skip_{section}"), f"#{section}").classes("skip")
            ui.html(word("title"), tag="h1", sanitize=False).classes("title").props('id="tools" tabindex="-1"')
            with self._menu(word("new"), "note_add"):
                for name, kind in kinds().items():
                    self._entry(translated(kind.description), partial(self._template, name))
            icon_button("folder_open", word("open"), lambda: self._upload.run_method("pickFiles"))
            self._upload = ui.upload(
                on_upload=self._opened, on_rejected=lambda: ui.notify(word("too_large"), type="negative"),
                max_file_size=LARGEST_FILE, auto_upload=True,
            ).classes("hidden")  # fmt: skip
            icon_button("save", word("save"), self._save)
            icon_button("undo", word("undo"), lambda: self._step(self.document.undo))
            icon_button("redo", word("redo"), lambda: self._step(self.document.redo))
            icon_button("link", word("share"), self._share)
            with self._menu(word("copy"), "content_copy"):
                self._entry(word("copy_yaml"), lambda: self._offer(self.document.text))
                self._entry(word("copy_python"), self._python)
            with self._menu(word("report"), "description"):
                self._entry(word("as_pdf"), lambda: self._report("pdf"))
                self._entry(word("as_html"), lambda: self._report("html"))
                self._entry(word("as_json"), self._json)
            icon_button("print", word("print"), lambda: ui.run_javascript("window.print()"))
            ui.space()
            ui.select(
                TONGUES, value=page_language(),
                on_change=lambda event: ui.run_javascript(f"babbitt.speak({json.dumps(event.value)})"),
            ).props(f'dense borderless aria-label="{word("language")}"')  # fmt: skip
            icon_button("contrast", word("dark"), darken)

    def _menu(self, says: str, icon: str) -> ui.menu:
        with ui.button(says, icon=icon).props("flat dense no-caps"):
            return ui.menu()

    def _entry(self, says: str, pressed: Callable[[], Any]) -> None:
        ui.menu_item(says, pressed).props('role="menuitem"')

    def _template(self, kind: str) -> None:
        self._replace(kinds()[kind].read_template())

    def _replace(self, text: str) -> None:
        self.document.write(text)
        self._replaced()

    def _step(self, move: Callable[[], None]) -> None:
        move()
        self._stepped()

    async def _opened(self, event: events.UploadEventArguments) -> None:
        content = await event.file.read()
        self._upload.reset()
        if len(content) > LARGEST_FILE:
            ui.notify(word("too_large"), type="negative")
            return
        try:
            self._replace(content.decode("utf-8"))
        except UnicodeDecodeError:
            ui.notify(word("no_text"), type="negative")

    def _save(self) -> None:
        ui.download.content(self.document.text, self.document.file_name("case.yaml"))

    async def _python(self) -> None:
        try:
            self._offer(await self._solver.ask(python_of, self.document.text))
        except (Ended, InputError) as error:
            ui.notify(tell_ended(error), type="warning")

    def _offer(self, text: str) -> None:
        """Show a text to take along, copied where the browser lets it be."""
        ui.run_javascript(f"navigator.clipboard?.writeText({json.dumps(text)})")
        with ui.dialog() as dialog, ui.card().classes("offered"):
            ui.textarea(word("copied"), value=text).props("readonly outlined autogrow").classes("w-full")
            ui.button(word("close"), on_click=dialog.close).props("outline no-caps")
        dialog.on("hide", dialog.delete)
        dialog.open()

    async def _report(self, report_format: Format) -> None:
        name = self.document.file_name(f"report.{report_format}")
        await self._download(report_of, name, self.document.text, report_format)

    async def _json(self) -> None:
        await self._download(json_of, self.document.file_name("results.json"), self.document.text)

    async def _download(self, function: Callable[..., Any], name: str, *given: Any) -> None:
        ui.notify(word("working"))
        try:
            content = await self._solver.ask(function, *given)
        except (Ended, InputError) as error:
            ui.notify(tell_ended(error), type="warning")
            return
        ui.download.content(content, name)

    async def _share(self) -> None:
        link = link_of(self.document.text)
        await ui.run_javascript(
            f"history.replaceState(null, '', '#{link}'); navigator.clipboard?.writeText(location.href)"
        )
        ui.notify(word("shared"))
