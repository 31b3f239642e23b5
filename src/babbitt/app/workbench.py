"""One page: a case at the left, its drawing in the middle, its answer at the right, more of it below."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from contextlib import suppress
from copy import copy
from itertools import count
from typing import Any

from nicegui import background_tasks, context, events, ui

from babbitt.app.answer import Answer, answer, compared, figures
from babbitt.app.answer_view import AnswerView, DrawingView, ResultsView
from babbitt.app.catalogue_view import CatalogueView
from babbitt.app.coefficients_view import CoefficientsView
from babbitt.app.designs_view import DesignsView
from babbitt.app.document import CaseDocument, path_in
from babbitt.app.figures import all_figures
from babbitt.app.form import Path
from babbitt.app.form_view import FormView
from babbitt.app.head import Head
from babbitt.app.in_language import InLanguage
from babbitt.app.link import case_of, link_of
from babbitt.app.maps_view import MapsView
from babbitt.app.parts import (
    LongWork,
    forget,
    on_request,
    outdate,
    show_faults,
    show_figures,
    show_table,
    tell_ended,
)
from babbitt.app.published_view import PublishedView
from babbitt.app.service import Service
from babbitt.app.slider import Slider
from babbitt.app.solver import Ended, InUnits, Latest
from babbitt.app.studies_view import StudiesView
from babbitt.app.units import SYSTEMS
from babbitt.app.words import LANGUAGE, word
from babbitt.core.language import ENGLISH, written_in

__all__ = ["Workbench"]

LOCALES: Mapping[str, Any] = {ENGLISH: "en-US", "de": "de", "ru": "ru"}
"""What the library of the page calls the languages."""

LOOK = 0.5
"""Seconds between two looks at kernels that are being compiled."""


class Workbench:
    """A page with a case; every visitor has one.

    Parameters
    ----------
    service : Service
    text : str
        The case to begin with.
    language : {"en", "de", "ru"}
        The language of the page.
    """

    def __init__(self, service: Service, text: str, language: str = ENGLISH) -> None:
        self.service, self._language = service, language
        self._drafts, self._solver, self._slow = (
            InLanguage(InUnits(one, self._system), language)
            for one in (service.drafts, service.solver, service.slow)
        )
        self._quick, self._settled = Latest(self._drafts), Latest(self._solver)
        self._questions, self._shown, self._awaited = count(1), 0, 0
        self.document = CaseDocument(text)
        self.found = Answer()
        self.place, self._is_picked = 0, False
        self._computed: dict[str, Any] = {}
        self._key = f"babbitt:{hashlib.sha256(text.encode()).hexdigest()[:16]}"

    def _system(self) -> str:
        return self._form.system

    def build(self) -> None:
        """Draw the page."""
        self._client = context.client
        self._client.storage[LANGUAGE] = self._language
        self._client.page = copy(self._client.page)  # that of all visitors is left alone
        self._client.page.language = LOCALES[self._language]
        with written_in(self._language):
            self._build()

    def _build(self) -> None:
        self._dark = ui.dark_mode(None)  # as the system has it
        Head(self.document, self._solver, self._replaced, self._all_anew, self._darken)
        with ui.element("div").classes("bench"):
            with _section("case", "form"):
                self._case()
            with _section("bearing", "bearing") as drawn:
                self._compiling = ui.label("").classes("small").props('role="status"')
                self._drawing = DrawingView()
            with _section("more", "more"):
                self._tabs()
            with _section("answer", "results") as answered:
                self._computing = ui.label("").classes("computing").props('role="status"')
                self._view = AnswerView(self._chosen)
        self._parts = drawn, answered
        ui.on("turned", self._turned, args=["field", "angle"])
        ui.on("linked", self._linked)
        ui.timer(0.0, self._begin, once=True)
        self._timer = ui.timer(LOOK, self._look)

    def _case(self) -> None:
        with ui.tabs().props("dense no-caps") as tabs:
            form, text = ui.tab(word("form")), ui.tab(word("text"))
        with ui.tab_panels(tabs, value=form).classes("w-full panels").props("keep-alive"):
            with ui.tab_panel(form):
                self._form = FormView(self.document, self._changed)
            with ui.tab_panel(text):
                self._editor = ui.codemirror(
                    self.document.text, language="YAML", on_change=self._typed, line_wrapping=True
                ).classes("editor").props(f'aria-label="{word("case_text")}"')  # fmt: skip

    def _tabs(self) -> None:
        drawn: dict[str, Callable[[], Any]] = {
            "explore": self._sliders,
            "results": self._result_table,
            "maps": lambda: MapsView(self._solver, self.document),
            "figures": self._figures,
            "compare": lambda: on_request(word("run_comparison"), self._compare),
            "designs": self._designs_tab,
            "studies": self._studies_tab,
            "coefficients": self._coefficients_tab,
            "catalogue": lambda: CatalogueView(self.document, self._set_elsewhere),
            "validation": lambda: PublishedView(self._slow),
        }
        with ui.tabs().props("dense align=left no-caps").classes("wrapped") as tabs:
            made = {name: ui.tab(word(name)) for name in drawn}
        with ui.tab_panels(tabs, value=made["explore"]).classes("w-full panels"):
            for name, draw in drawn.items():
                with ui.tab_panel(made[name]):
                    draw()

    def _sliders(self) -> None:
        self._slider = Slider(self.document, self._slid, self._stopped, self._system)

    def _result_table(self) -> None:
        self._results = ResultsView()

    def _figures(self) -> None:
        on_request(word("draw_figures"), self._draw_figures)
        ui.label(word("all_figures_help")).classes("small")
        LongWork(self._slow, word("all_figures"), lambda: (all_figures, (self.document.text,)), _figures_shown)

    def _designs_tab(self) -> None:
        self._designs = DesignsView(
            self._solver, lambda: (self.document.text, self.found, self._system()), self._replace, self._show
        )

    def _studies_tab(self) -> None:
        self._studies = StudiesView(self.document, self._slow, self._set_elsewhere, self._system)

    def _coefficients_tab(self) -> None:
        self._coefficients = CoefficientsView(self.document, self._slow, self._bearing_shown)

    def _bearing_shown(self) -> str | None:
        """Name of the bearing that is shown; None where the case has one alone."""
        bearings = self.found.bearings
        return bearings[self.place].key if len(bearings) > 1 else None

    async def _begin(self) -> None:
        """Take the case of the draft or of the link, if there is one, and answer."""
        script = f"return {{fragment: location.hash, ...babbitt.kept('{self._key}')}}"
        found = await ui.run_javascript(script, timeout=5.0)
        self._dark.value = found.get("dark")
        self._form.system = system if (system := found.get("units")) in SYSTEMS else self._form.system
        fragment, draft = str(found["fragment"] or ""), found.get("text")
        text = draft if isinstance(draft, str) else None
        if text is None and len(fragment) > 1:
            text = case_of(fragment)
            if text is None:
                ui.notify(word("not_a_link"), type="negative")
        if text is not None and text != self.document.text:
            self.document.begin(text)
            self._replaced()
        elif self._form.system != SYSTEMS[0]:
            self._all_anew()
        else:
            await self._answer(False)

    def _linked(self, event: events.GenericEventArguments) -> None:
        """Another link came into the address."""
        text = case_of(str(event.args))
        if text is None:
            ui.notify(word("not_a_link"), type="negative")
        else:
            self._replace(text)

    def _look(self) -> None:
        now = self.service.compiling
        self._compiling.text = "" if now is None else word("compiling", done=now.done, rows=now.rows)
        self._compiling.set_visibility(now is not None)
        if self.service.is_ready:
            self._timer.deactivate()

    def _replace(self, text: str) -> None:
        self.document.write(text)
        self._replaced()

    def _replaced(self) -> None:
        self._is_picked = False
        forget()
        self._all_anew()

    def _all_anew(self) -> None:
        self._form.draw()
        self._slider.draw()
        self._follow()

    def _follow(self) -> None:
        """Text and studies are those of the document, which is answered."""
        self._studies.draw()
        self._coefficients.draw()
        if self._editor.value != self.document.text:
            self._editor.set_value(self.document.text)
        self._ask(False)

    def _set_elsewhere(self) -> None:
        """A tab put something into the case."""
        self._all_anew()

    def _typed(self, event: events.ValueChangeEventArguments[Any]) -> None:
        if event.value != self.document.text:
            self.document.write(event.value)
            self._all_anew()

    def _changed(self) -> None:
        """The form changed the document."""
        self._slider.draw()
        self._follow()

    def _stopped(self, moved: set[Path]) -> None:
        """A slider came to a stop."""
        self._form.show(moved)
        self._follow()

    def _slid(self) -> None:
        """A slider is moving: an answer on the draft grid will do."""
        self._ask(True)

    def _turned(self, event: events.GenericEventArguments) -> None:
        """A hand turned the load or a feed."""
        field, angle = event.args["field"], float(event.args["angle"])
        if not self.document.may_turn(str(field)):
            return
        path = path_in(str(field))
        self.document.change(path, f"{angle:.1f} deg")
        self._form.show([path])
        self._slider.draw()
        self._follow()

    def _ask(self, quick: bool) -> None:
        """Answer in a task of its own: the control that asked may be gone by then."""
        background_tasks.create(self._answer(quick))

    async def _answer(self, quick: bool) -> None:
        with self._client:
            if not quick:
                self._outdate()
                self._keep()
            await self._answered(quick)

    def _keep(self) -> None:
        """Have the browser keep what a reload would lose."""
        draft = {"text": self.document.text, "units": self._system(), "dark": self._dark.value}
        link = f"#{link_of(self.document.text)}"
        ui.run_javascript(f"babbitt.keep({json.dumps(self._key)}, {json.dumps(link)}, {json.dumps(draft)})")

    def _darken(self) -> None:
        self._dark.value = not self._dark.value
        self._keep()

    def _outdate(self) -> None:
        """Mark what was computed of another case; the study that is asked of a case does not change it."""
        case = self.document.without_study | {"shown in": self._system()}
        if case != self._computed:
            self._computed = case
            outdate()

    async def _answered(self, quick: bool) -> None:
        mine, latest = next(self._questions), self._quick if quick else self._settled
        if quick:
            self._settled.withdraw()
        self._await(0 if quick else mine)
        try:
            found = await latest.ask(answer, self.document.text, quick)
        except Ended as ended:
            if ended.why != "cancelled" and mine > self._shown:  # no later question was answered yet
                self._fail(tell_ended(ended))
            return
        except Exception:  # an error of the program: what is shown is not of this case
            if mine > self._shown:
                self._fail(word("died"))
            raise
        finally:
            if mine == self._awaited:
                self._await(0)
        if found is None or mine < self._shown:
            return
        self._shown = mine
        if found.faults or self.found.faults:
            self._form.blame(found.faults)
        self.found = found
        if not self._is_picked or self.place >= len(found.bearings):
            self.place, self._is_picked = found.worst, False
        self._show()
        with suppress(Ended):  # the design that was kept stays as it was shown
            if await self._designs.follow(self._system()):
                self._show()

    def _await(self, question: int) -> None:
        """Mark what is shown as not yet that of the case while a question about it is asked; 0 for none."""
        self._awaited = question
        self._computing.text = word("working") if question else ""
        for part in self._parts:
            part.classes(**{"add" if question else "remove": "pending"})

    def _show(self) -> None:
        if not (self.found.bearings or self.found.faults):
            return
        self._view.show(self.found, self.place, self._designs.of(self.place, self.document.given.get("kind")))
        if self.found.faults:
            self._fade()
            return
        shown = self.found.bearings[self.place]
        self._form.tell_unread(shown.unread)
        self._drawing.show(shown)
        if not self.found.quick:
            self._results.show(shown)

    def _fail(self, why: str) -> None:
        """Show that the case has no answer, and why."""
        self.found = Answer()
        self._view.fail(why)
        self._fade()

    def _fade(self) -> None:
        self._drawing.fade()
        self._results.fade()

    def _chosen(self, place: int) -> None:
        self.place, self._is_picked = place, True
        self._show()

    async def _draw_figures(self, box: ui.column) -> None:
        found = await self._solver.ask(figures, self.document.text)
        box.clear()
        with box:
            show_figures(found)

    async def _compare(self, box: ui.column) -> None:
        found = await self._solver.ask(compared, self.document.text)
        box.clear()
        with box:
            for table in found:
                show_table(table)


def _section(style: str, name: str) -> ui.element:
    """A part of the page, which the links that skip can go to by its name."""
    part = ui.element("section").classes(style)
    with part:
        ui.link(word("skip_tools"), "#tools").classes("skip")
    return part.props(f'aria-label="{word(name)}" id="{name}" tabindex="-1"')


def _figures_shown(found: Any) -> None:
    faults, drawn = found
    show_faults(faults)
    if not drawn and not faults:
        ui.label(word("no_figures")).classes("small")
    show_figures(drawn)
