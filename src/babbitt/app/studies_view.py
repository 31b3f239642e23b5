"""The tab of studies: which fields vary and how, the study while it runs, its tables and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from nicegui import ui

from babbitt.app.document import CaseDocument, path_in
from babbitt.app.parts import LongWork, Question, show_faults, show_figures, show_table, tell_ended
from babbitt.app.solver import Ended, Questions
from babbitt.app.studies import (
    NEEDS,
    Axis,
    Studied,
    asked_text,
    axes_of,
    block_of,
    first_axis,
    kinds_of,
    replaces_fit,
    sizes_of,
    studied,
    study_file,
    with_value,
)
from babbitt.app.words import path_name, word
from babbitt.case.with_units import case_text
from babbitt.core.notices import InputError
from babbitt.study.best_designs import texts_of_best
from babbitt.study.size import Size, size_of

__all__ = ["StudiesView"]

FILES = {".csv": "as_csv", ".xlsx": "as_workbook", ".pdf": "as_pdf", ".html": "as_html"}
"""Endings of files of a study, each with its word."""

MOST_SAMPLES = 100_000

STAYS = 15_000
"""Milliseconds that a message stays which is to be read."""


@dataclass(frozen=True)
class Asked:
    """A case of which a value that a study found may be taken, and what was asked: kind, axes, system of units."""

    case: dict[str, Any]
    kind: str
    axes: dict[str, Axis]
    system: str


class StudiesView:
    """Studies of the case.

    Parameters
    ----------
    document : CaseDocument
    solver : Questions
        Of long work.
    changed : callable
        Called when the study was put into the case.
    system : callable
        Name of the system of units of the page.
    """

    def __init__(
        self, document: CaseDocument, solver: Questions, changed: Callable[[], None], system: Callable[[], str]
    ) -> None:
        self.document, self._solver, self._changed, self._system = document, solver, changed, system
        self._kind, self._samples = "sweep", 1000
        self._known: dict[str, Axis] = {}
        self._axes: dict[str, Axis] = {}
        self._study: Any = None
        self._computed: list[Asked] = []
        self._case: dict[str, Any] = {}
        self._aside: dict[str, tuple[Axis, Axis | None]] = {}  # of fields without a number just now, as they began
        self._box = ui.column().classes("w-full")
        self.work = LongWork(solver, word("run_study"), self._asked, self._show)
        ui.button(word("keep_study"), on_click=self._keep).props("flat dense no-caps").tooltip(
            word("keep_study_help")
        )
        self.draw()

    def draw(self) -> None:
        """Draw the choices anew: another case. What was typed stays where the case has the same value."""
        kinds = kinds_of(self.document.given)
        self._kind = self._kind if self._kind in kinds else kinds[0]
        self._follow()
        self._box.clear()
        with self._box:
            names = {kind: word(f"study_{kind}") for kind in kinds}
            ui.select(names, value=self._kind, label=word("study_kind"), on_change=self._asks).classes("w-full")
            if self._known:
                self._fields()
            if self._kind == "tolerance":
                ui.number(
                    word("samples"), value=self._samples, min=10, max=MOST_SAMPLES, precision=0,
                    on_change=lambda event: setattr(self, "_samples", int(event.value or 0)),
                )  # fmt: skip

    def _follow(self) -> None:
        """Take the axes of the case; those of a study that was asked of this case, or whose answer it took."""
        before, self._known = self._known, axes_of(self.document, self._kind, self._system())
        last, self._case = self._case, self.document.without_study
        asked = self._asked_of(self._case) if self._case != last else None
        if asked is not None and (asked.kind, asked.system) == (self._kind, self._system()):
            self._axes = dict(asked.axes)
            return
        if self._case.get("kind") != last.get("kind"):
            self._aside = {}
        of = {path: (axis, before.get(path)) for path, axis in self._axes.items()} | self._aside
        self._aside = {path: pair for path, pair in of.items() if path not in self._known}
        self._axes = {
            path: of[path][0] if of[path][1] == axis else axis for path, axis in self._known.items() if path in of
        }

    def _asked_of(self, case: dict[str, Any]) -> Asked | None:
        return next((one for one in self._computed if one.case == case), None)

    def _asks(self, event: Any) -> None:
        self._kind, self._axes, self._aside = event.value, {}, {}
        self.work.forget()
        self.draw()

    def _fields(self) -> None:
        names = {path: path_name(path_in(path), self.document.given) for path in self._known}
        fewest, most = NEEDS[self._kind]
        if not (self._axes or self._aside) and fewest:
            first = first_axis(self.document.given, self._known)
            self._axes = {first: self._known[first]}
        label = word("vary_field") if most == 1 else word("vary_fields", fewest=fewest, most=most)
        ui.select(
            names, value=list(self._axes), multiple=True, label=label, on_change=self._picked
        ).props("dense use-chips").classes("w-full")  # fmt: skip
        for axis in self._axes.values():
            self._axis(axis, names[axis.path])

    def _picked(self, event: Any) -> None:
        most = NEEDS[self._kind][1]
        chosen, self._aside = list(event.value)[-most:], {}  # the last ones count
        self._axes = {path: self._axes.get(path, self._known[path]) for path in chosen}
        self.draw()

    def _axis(self, axis: Axis, name: str) -> None:
        with ui.row().classes("axis"):
            ui.label(name).classes("name")
            if axis.choices:
                self._input(axis, "choices", word("choices"), ", ".join(axis.choices), wide=True)
            elif axis.law in ("fit", "scatter"):
                ui.label(word(f"law_{axis.law}", what=axis.law_of)).classes("small")
            else:
                self._input(axis, "first", word("from"), axis.first)
                self._input(axis, "last", word("to"), axis.last)
                if self._kind == "tolerance":
                    laws = {law: word(f"law_{law}") for law in ("uniform", "triangular")}
                    ui.select(
                        laws, value=axis.law, label=word("law"),
                        on_change=lambda e: self._set(axis.path, law=e.value),
                    ).props("dense")  # fmt: skip
                else:
                    ui.number(
                        word("points"), value=axis.points, min=2, max=200, precision=0,
                        on_change=lambda e: self._set(axis.path, points=int(e.value or 2)),
                    ).props("dense").classes("narrow")  # fmt: skip

    def _input(self, axis: Axis, part: str, label: str, value: str, wide: bool = False) -> None:
        def typed(event: Any) -> None:
            text = str(event.value or "").strip()
            words = tuple(one.strip() for one in text.split(",") if one.strip())
            self._set(axis.path, **{part: words if part == "choices" else text})

        field = ui.input(label, value=value, on_change=typed).props("dense")
        field.props(f'aria-label="{axis.path} {label}"').classes("grow" if wide else "end")

    def _set(self, path: str, **changes: Any) -> None:
        self._axes[path] = replace(self._axes[path], **changes)

    def _block(self) -> dict[str, Any] | None:
        """The study that is asked for; None for the one that stands in the case."""
        return None if self._kind == "own" else block_of(self._kind, tuple(self._axes.values()), self._samples)

    def _text(self) -> str:
        block = self._block()
        return self.document.text if block is None else asked_text(self.document.given, block)

    def _asked(self) -> Question | None:
        self._computed = [Asked(self.document.without_study, self._kind, dict(self._axes), self._system())]
        return studied, (self._text(),)

    def _keep(self) -> None:
        """Put the study into the case, so that `babbitt study` computes it."""
        self.document.take(self._text())
        self._kind = "own"
        self._changed()

    def _show(self, found: Studied) -> None:
        show_faults(found.faults)
        if found.study is None:
            return
        self._study = found.study
        ui.label(found.overview)
        with ui.row():
            for ending, says in FILES.items():
                ui.button(word(says), on_click=lambda _, e=ending: self._download(e)).props("flat dense no-caps")
        if found.study.kind == "size" and (sizes := sizes_of(found.study)) is not None:
            self._offer(size_of(found.study), sizes)
        if designs := texts_of_best(found.study):
            with ui.row().classes("items-center"):
                ui.label(word("take_design"))
                for name, text in designs.items():
                    number = name.rpartition("-")[2]
                    ui.button(number, on_click=partial(self._take_design, text, number)).props("outline no-caps")
        for table in found.tables:
            show_table(table)
        show_figures(found.figures)

    def _offer(self, size: Size, sizes: dict[str, str]) -> None:
        """Buttons that put a value which keeps all limits into the case."""
        with ui.row().classes("items-center"):
            ui.label(word("take_size" if sizes else "no_size"))
            for text, role in sizes.items():
                said = f"{text} ({role})" if role else text
                ui.button(said, on_click=lambda _, text=text: self._take(size.path, text)).props("outline no-caps")
        if any(None in (one.below, one.above) for one in size.intervals):
            ui.label(word("scan_ends")).classes("small")

    def _take(self, path: str, text: str) -> None:
        """Put a value into the case."""
        if self._may_take():
            loses_fit = replaces_fit(self.document.given, path)
            self._put(case_text(with_value(self.document.given, path, text)), text)
            if loses_fit:
                ui.notify(word("without_fit"), type="warning", timeout=STAYS)

    def _take_design(self, text: str, name: str) -> None:
        if self._may_take():
            self._put(text, name)

    def _may_take(self) -> bool:
        """Whether the case is one of which something was found; what was computed of another one stays away."""
        may = self._asked_of(self.document.without_study) is not None
        if not may:
            ui.notify(word("outdated"), type="warning")
        return may

    def _put(self, text: str, name: str) -> None:
        """Put another case on the page and say what of it is new."""
        self.document.take(text)
        self._computed.append(replace(self._computed[0], case=self.document.without_study))
        self._changed()
        ui.notify(word("taken", name=name))

    async def _download(self, ending: str) -> None:
        ui.notify(word("working"))
        try:
            content = await self._solver.ask(study_file, self._study, ending)
        except (Ended, InputError) as error:
            ui.notify(tell_ended(error), type="warning")
            return
        ui.download.content(content, self.document.file_name(f"study{ending}"))
