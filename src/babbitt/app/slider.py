"""A value of the case under a slider, for an answer that follows the hand."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Iterable
from typing import Any

from nicegui import context, ui

from babbitt.app.document import CaseDocument
from babbitt.app.form import Entry, Path, as_text, quantities
from babbitt.app.units import shown_in, split
from babbitt.app.words import path_name, word

__all__ = ["Slider"]

USUAL: tuple[Path, ...] = (("load",), ("speed",), ("clearance", "mean"), ("supply", "temperature"))
"""Ends of the paths of fields that a designer moves first."""

MOST_PICKED = 4

PAUSE = 0.3
"""Seconds without movement after which a slider stands still."""

SPAN = 2.0
"""Ends of a slider: the value over this, and times this."""


class Slider:
    """A slider for each quantity that was picked.

    Parameters
    ----------
    document : CaseDocument
    moving, stopped : callable
        Called while a value moves, and with the paths of those that moved when they stopped.
    system : callable
        The system of units that the page shows now: a value moves in its unit, and is written in it.
    """

    def __init__(
        self,
        document: CaseDocument,
        moving: Callable[[], None],
        stopped: Callable[[set[Path]], None],
        system: Callable[[], str],
    ) -> None:
        self.document, self._moving, self._stopped, self._system = document, moving, stopped, system
        self._picked: list[Path] = []
        self._moved: set[Path] = set()
        self._held = False
        self._pause: asyncio.TimerHandle | None = None
        context.client.on_delete(self._leave)
        self._box = ui.column().classes("w-full")
        self.draw()

    def draw(self) -> None:
        """Draw the sliders anew; a hand that held one holds none of these.

        What was picked comes back with a case that has it again.
        """
        self._held = False
        self._box.clear()
        entries = {one.path: one for one in quantities(self.document.items)}
        if not entries:
            return
        picked = [path for path in self._picked if path in entries] or first_picked(entries)
        with self._box:
            ui.select(
                {path: path_name(path, self.document.given) for path in entries},
                value=picked, multiple=True, label=word("pick_field"), on_change=self._pick,
            ).props("dense use-chips").classes("w-full")  # fmt: skip
            for path in picked:
                self._slider(entries[path])

    def _pick(self, event: Any) -> None:
        self._picked = list(event.value)
        self.draw()

    def _slider(self, entry: Entry) -> None:
        number, unit = shown_in(self._system(), *split(as_text(entry.value), entry.units), entry.units)
        value = float(number)
        first, last = sorted((value / SPAN, value * SPAN)) if value else (-1.0, 1.0)
        says = path_name(entry.path, self.document.given)
        with ui.row().classes("slider"):
            ui.label(says).classes("name")
            found = ui.slider(min=first, max=last, step=_step(last - first), value=value).classes("grow")
            found.props(f'aria-label="{says}" label')
            shown = ui.label(f"{value:g} {unit}").classes("number")

        def moved_to(number: float) -> None:
            shown.text = f"{number:.6g} {unit}"
            self._moved.add(entry.path)
            self.document.slide(entry.path, f"{number:.6g} {unit}".strip())
            self._moving()
            self._await_stop()

        def to(end: float) -> None:
            found.value = end
            moved_to(end)

        def held(event: Any) -> None:
            self._held = event.args == "start"
            self._await_stop()

        found.on("update:model-value", lambda e: moved_to(e.args), throttle=0.05, leading_events=False)
        found.on("pan", held)
        for key, end in (("home", first), ("end", last)):
            found.on(f"keydown.{key}.prevent", lambda _, end=end: to(end))

    def _await_stop(self) -> None:
        """Take the movement as ended when nothing moves for a while, by hand or by keys."""
        self._leave()
        self._pause = asyncio.get_running_loop().call_later(PAUSE, self._stood_still)

    def _stood_still(self) -> None:
        if not self._held:  # one drag with pauses is one step to take back
            self.document.keep()
        moved, self._moved = self._moved, set()
        self._stopped(moved)

    def _leave(self) -> None:
        if self._pause is not None:
            self._pause.cancel()


def first_picked(paths: Iterable[Path]) -> list[Path]:
    """Values that a designer moves first, else the first ones.

    >>> first_picked([("diameter",), ("supply", "temperature"), ("load",)])
    [('load',), ('supply', 'temperature')]
    """
    known = list(paths)
    usual = [path for names in USUAL for path in known if path[-len(names) :] == names]
    return (usual or known)[:MOST_PICKED]


def _step(span: float) -> float:
    """A round step, about a hundredth of a span."""
    return float(10.0 ** math.floor(math.log10(span / 100.0)))
