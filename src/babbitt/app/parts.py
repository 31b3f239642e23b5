"""Parts that several tabs of the page are made of: tables, figures, faults, work that is asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from tempfile import TemporaryDirectory
from typing import Any

from nicegui import ElementFilter, context, ui

from babbitt.app.answer import Fault, Figure, Table
from babbitt.app.progress import progress_in
from babbitt.app.solver import LONGEST, LONGEST_STUDY, Ended, Questions, outcome_of
from babbitt.app.words import word
from babbitt.core.notices import InputError

__all__ = [
    "LongWork",
    "forget",
    "icon_button",
    "on_request",
    "outdate",
    "plain_box",
    "rows_of_table",
    "show_faults",
    "show_figures",
    "show_table",
    "tell_ended",
]

OF_CASE = "of_case"
"""Mark of places for what was computed of the case."""

LOOK = 0.5
"""Seconds between two looks at how far long work is."""

NUMBERS = {"align": "right"}
"""Columns of numbers, which do not break over lines."""

Question = tuple[Callable[..., Any], tuple[Any, ...]]


def icon_button(icon: str, says: str, pressed: Callable[[], Any]) -> ui.button:
    """A button without words, which says them to whoever cannot see it."""
    made = ui.button(icon=icon, on_click=pressed).props(f'flat dense round aria-label="{says}"')
    return made.tooltip(says)


def show_table(table: Table) -> ui.table:
    """Rows of text."""
    columns = [
        {"name": str(n), "label": head, "field": str(n), **(_words(table) if n < table.words else NUMBERS)}
        for n, head in enumerate(table.heads)
    ]
    made = ui.table(columns=columns, rows=rows_of_table(table.rows), row_key="key", title=table.title or None)
    made.props("dense flat").classes("results")
    with ui.column().classes("remarks"):
        for remark in table.remarks:
            ui.label(remark).classes("small")
    return made


def _words(table: Table) -> dict[str, Any]:
    """Columns of words, which may break over lines: a single one has room."""
    return {"align": "left", "style": f"white-space: normal; min-width: {13 if table.words == 1 else 7}em"}


def rows_of_table(rows: Iterable[tuple[str, ...]]) -> list[dict[str, Any]]:
    """Rows as a table of the page takes them."""
    return [{"key": key, **{str(n): cell for n, cell in enumerate(row)}} for key, row in enumerate(rows)]


def show_figures(figures: Iterable[Figure]) -> None:
    """Figures, each with its caption."""
    for figure in figures:
        # Drawn by this package, its texts as paths: nothing of a case is markup in it.
        drawn = ui.html(figure.svg, sanitize=False).classes("figure").props('role="img"')
        drawn.props["aria-label"] = figure.name
        ui.label(figure.caption).classes("small")


def show_faults(faults: Iterable[Fault]) -> None:
    """What is wrong."""
    for fault in faults:
        where = f"{fault.field}: " if fault.field else f"{word('line')} {fault.line}: " if fault.line else ""
        ui.label(f"{where}{fault.message} [{fault.code}]").classes("fault").props('role="alert"')


def tell_ended(error: Ended | InputError, longest: float = LONGEST) -> str:
    """Why a question has no answer, in words."""
    return word(error.why, seconds=longest) if isinstance(error, Ended) else error.message


def answer_box() -> ui.column:
    """A place for what was computed of the case, under a remark that shows when the case has changed since."""
    ui.label(word("outdated")).classes("since")
    return plain_box().mark(OF_CASE)


def plain_box() -> ui.column:
    """A place for what was computed."""
    return ui.column().classes("w-full")


def outdate() -> None:
    """Say wherever something was computed of the case of a page that it has changed since."""
    for box in ElementFilter(kind=ui.column, marker=OF_CASE):
        box.classes(add="outdated")


def forget() -> None:
    """Take away what was computed of the case of a page, and what is being computed: there is another one."""
    for box in ElementFilter(kind=ui.column, marker=OF_CASE):
        box.clear()
    for work in ElementFilter(kind=LongWork, marker=OF_CASE):
        work.forget()


def on_request(says: str, work: Callable[[ui.column], Any]) -> ui.column:
    """A button, and under it what it asked for."""
    button = ui.button(says).props("outline no-caps")
    box = answer_box()

    async def pressed() -> None:
        button.disable()
        box.classes(remove="outdated")
        box.clear()
        with box:
            ui.label(word("working")).props('role="status"')
        try:
            await work(box)
        except (Ended, InputError) as error:
            box.clear()
            with box:
                ui.label(tell_ended(error)).classes("fault").props('role="alert"')
        finally:
            button.enable()

    button.on_click(pressed)
    return box


class LongWork(ui.element):
    """Work of minutes: a button that begins it, how far it is, a button that ends it, and what came of it.

    Parameters
    ----------
    solver : Questions
        Of long work.
    says : str
        On the button.
    question : callable
        Gives the function and what it is given; the function gets a file for its progress besides. None where
        there is nothing to ask.
    show : callable
        Shows the answer.
    place : callable
        Makes the place where it is shown.
    """

    def __init__(
        self,
        solver: Questions,
        says: str,
        question: Callable[[], Question | None],
        show: Callable[[Any], None],
        place: Callable[[], ui.column] = answer_box,
    ) -> None:
        super().__init__("div")
        if place is answer_box:
            self.mark(OF_CASE)
        self._solver, self._question, self._show = solver, question, show
        self._running: Any = None
        self._file = ""
        with self.classes("nicegui-column w-full"):
            self._draw(says, place)
        self._idle(True)
        context.client.on_delete(self._end)

    def _draw(self, says: str, place: Callable[[], ui.column]) -> None:
        with ui.row().classes("items-center w-full"):
            self._start = ui.button(says, on_click=self._begin).props("outline no-caps")
            self._cancel = ui.button(word("cancel"), on_click=self._end).props("flat no-caps")
            self._bar = ui.linear_progress(value=0.0, show_value=False).classes("grow progress")
            self._bar.props(f'aria-label="{word("progress")}"')
            self._said = ui.label("").classes("small").props('role="status"')
        self._box = place()
        self._timer = ui.timer(LOOK, self._look, active=False)

    def forget(self) -> None:
        """Take away what came of the last question, and end the work at it."""
        self._end()
        self._running = None
        self._timer.active = False
        self._box.clear()
        self._said.text = ""

    def _idle(self, is_idle: bool) -> None:
        self._start.set_enabled(is_idle)
        self._timer.active = not is_idle
        self._cancel.set_visibility(not is_idle)
        self._bar.set_visibility(not is_idle)

    def _look(self) -> None:
        now = progress_in(self._file)
        self._bar.value = now.share
        self._said.text = word("rows_done", done=now.done, rows=now.rows) if now.rows else word("working")

    def _end(self) -> None:
        if self._running is not None:
            self._running.cancel()

    async def _begin(self) -> None:
        asked = self._question()
        if asked is None:
            return
        function, given = asked
        self._box.classes(remove="outdated")
        self._box.clear()
        self._said.text = word("working")
        self._idle(False)
        try:
            with TemporaryDirectory(prefix="babbitt-") as folder:
                self._file = f"{folder}/progress"
                self._running = self._solver.start(function, *given, self._file, longest=LONGEST_STUDY)
                found = await outcome_of(self._running)
        except (Ended, InputError) as error:
            if self._running is not None:
                self._said.text = tell_ended(error, LONGEST_STUDY)
            return
        finally:
            self._running = None
            self._idle(True)
        self._said.text = "" if getattr(found, "faults", ()) else word("done")
        with self._box:
            self._show(found)
