"""The form of a case: one control a field, errors under their fields."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import replace
from html import escape
from typing import Any

from nicegui import ui

from babbitt.app.answer import Fault
from babbitt.app.catalogue import suggestions
from babbitt.app.document import CaseDocument
from babbitt.app.form import (
    NONE,
    TEXT,
    Choice,
    Entry,
    Group,
    Item,
    Path,
    Rows,
    as_text,
    list_text,
    quantities,
    sections_of,
)
from babbitt.app.units import SYSTEMS, in_unit, is_number, shown_in, split
from babbitt.app.words import field_name, sections, word

__all__ = ["FormView"]

PAUSE = 300
"""Milliseconds after the last key at which a field is taken."""


class FormView:
    """Controls of a case; `changed` is called when one of them changed the document, or how it shows.

    Parameters
    ----------
    document : CaseDocument
    changed : callable

    Attributes
    ----------
    system : str
        Of the units in which values show; the case keeps those in which it was written.
    """

    def __init__(self, document: CaseDocument, changed: Callable[[], None]) -> None:
        self.document, self._changed = document, changed
        self._inputs: dict[Path, Any] = {}
        self._shows: dict[Path, Callable[[Entry], None]] = {}
        self._open = set(list(sections())[:1])
        self.system = SYSTEMS[0]
        self._box = ui.column().classes("form")
        self.draw()

    def draw(self) -> None:
        """Draw all controls anew: another case, or another way to give a part."""
        self._inputs.clear()
        self._shows.clear()
        self._box.clear()
        items = self.document.items
        with self._box:
            self._units()
            if not items:
                ui.label(word("no_form")).classes("small")
            for heading, under in sections_of(items, sections(), word("section_other")).items():
                is_open = heading in self._open
                section = ui.expansion(heading, value=is_open, on_value_change=self._keep(heading))
                with section.classes("section"):
                    self._list(under)

    def show(self, paths: Iterable[Path]) -> None:
        """Show quantities that moved elsewhere; a form that has no control for one is drawn anew."""
        moved = set(paths)
        entries = {one.path: one for one in quantities(self.document.items) if one.path in moved}
        if moved <= self._shows.keys() & entries.keys():
            for path, entry in entries.items():
                self._shows[path](entry)
        else:
            self.draw()

    def _units(self) -> None:
        """Choose the system of units."""
        names = {system: word(f"units_{system}") for system in SYSTEMS}
        found = ui.toggle(names, value=self.system, on_change=self._shown_in).props(
            "dense no-caps unelevated toggle-color=grey-8"
        )
        found.props(f'aria-label="{word("unit_system")}"').classes("units")

    def _shown_in(self, event: Any) -> None:
        self.system = event.value
        self.draw()
        self._changed()

    def blame(self, faults: Iterable[Fault]) -> None:
        """Show what is wrong under the fields that are to blame."""
        said: dict[Path, str] = {}
        for fault in faults:
            said.setdefault(path_of(fault.field), fault.message)
        for path, control in self._inputs.items():
            message = said.get(path, "")
            control.error = message or None

    def tell_unread(self, fields: Iterable[str]) -> None:
        """Say under the fields that a method does not read that they change nothing."""
        unread = set(map(path_of, fields))
        for path, control in self._inputs.items():
            if path in unread:
                control.props["hint"] = word("unread")
            elif control.props.pop("hint", None) is None:
                continue
            control.update()

    def _keep(self, heading: str) -> Callable[[Any], None]:
        def kept(event: Any) -> None:
            (self._open.add if event.value else self._open.discard)(heading)

        return kept

    def _list(self, items: Iterable[Item]) -> None:
        for found in items:
            item = replace(found, label=field_name(str(found.path[-1])))
            match item:
                case Entry():
                    self._entry(item)
                case Choice():
                    self._choice(item)
                case Group():
                    self._group(item)
                case Rows():
                    self._rows(item)

    def _entry(self, entry: Entry) -> None:
        if entry.is_switch:
            is_on = entry.is_on if entry.value is None else bool(entry.value)
            switch = ui.switch(entry.label, value=is_on, on_change=lambda e: self._take(entry.path, bool(e.value)))
            _explain(switch, entry.help)
        elif entry.options:
            options = list(entry.options) if entry.is_required else [NONE, *entry.options]
            value = as_text(entry.value) if as_text(entry.value) in options else options[0]
            found = ui.select(
                options, value=value, label=entry.label,
                on_change=lambda e: self._take(entry.path, e.value or None),
            )  # fmt: skip
            self._known(entry, found)
        elif entry.is_list:
            self._text(entry, list_text(entry.value), _listed)
        elif entry.units:
            self._quantity(entry)
        else:
            self._text(entry, as_text(entry.value), _number if entry.is_number else _word)

    def _text(self, entry: Entry, value: str, read: Callable[[str], Any]) -> None:
        found = ui.input(entry.label, value=value, placeholder=entry.example)
        _on_typed(found, lambda: self._take(entry.path, read(found.value or "")))
        self._known(entry, found)
        if names := suggestions(entry.path):
            options = "".join(f"<option>{escape(name)}</option>" for name in names)
            # The field looks for its list under this name, and has one itself on telephones alone.
            ui.html(options, tag="datalist", sanitize=False).props(f'id="{found.html_id}-datalist"')

    def _quantity(self, entry: Entry) -> None:
        shown = number, chosen = self._number_and_unit(entry)
        with ui.row().classes("quantity"):
            field = ui.input(entry.label, value=number, placeholder=entry.example).classes("grow")
            select = ui.select(list(entry.units), value=chosen).classes("unit").props("dense borderless")
            select.props(f'aria-label="{word("unit")}: {entry.label}"')

        def show(moved: Entry) -> None:
            """In the unit that is picked: set one after the other, number and unit would make another case."""
            nonlocal shown
            number, unit = self._number_and_unit(moved)
            shown = number if unit == chosen else in_unit(number, unit, chosen), chosen
            field.value = shown[0]

        def taken() -> None:
            nonlocal shown
            before, shown = shown, (field.value or "", select.value)
            if shown == before:  # the case says it already, perhaps in a unit of its own
                return
            text = shown[0].strip()
            self._take(entry.path, f"{text} {select.value}" if is_number(text) else text or None)

        def converted(event: Any) -> None:
            nonlocal chosen
            if is_number(field.value or ""):
                field.value = in_unit(field.value, chosen, event.value)
            chosen = event.value
            taken()

        _on_typed(field, taken)
        select.on_value_change(converted)
        self._shows[entry.path] = show
        self._known(entry, field)

    def _number_and_unit(self, entry: Entry) -> tuple[str, str]:
        """As they stand in the form, in the system of units that was chosen."""
        number, unit = split(as_text(entry.value), entry.units)
        return shown_in(self.system, number, unit or entry.units[0], entry.units)

    def _known(self, entry: Entry, control: Any) -> None:
        control.props("dense" + (f" debounce={PAUSE}" if isinstance(control, ui.input) else ""))
        if entry.symbol:
            control.props["prefix"] = f"{entry.symbol} ="
        allowed = word("allowed", range=entry.allowed) if entry.allowed else ""
        _explain(control, " ".join(filter(None, (entry.help, allowed))))
        self._inputs[entry.path] = control

    def _choice(self, choice: Choice) -> None:
        names = {way: word("as_words") if way == TEXT else way.replace("_", " ") for way in choice.ways}
        options = names if choice.is_required else {NONE: word("not_given"), **names}
        value = choice.way if choice.way in options else next(iter(options))

        def chosen(event: Any) -> None:
            way, before = event.value, self.document.text
            if way == NONE:
                self.document.change(choice.path, None)
            else:
                self.document.choose(choice.path, way)
            self._told(before)
            self.draw()

        if choice.way == TEXT:  # what is asked for stands before the other ways to give it
            self._list(choice.items)
        says = word("given_as", label=choice.label) if TEXT in choice.ways else choice.label
        found = ui.select(options, value=value, label=says, on_change=chosen)
        found.props("dense")
        _explain(found, choice.help)
        self._inputs.setdefault(choice.path, found)
        if choice.items and choice.way != TEXT:
            with ui.column().classes("inner"):
                self._list(choice.items)

    def _group(self, group: Group) -> None:
        with ui.expansion(group.label, value=group.is_given).classes("inner").props("dense"):
            self._list(group.items)

    def _rows(self, rows: Rows) -> None:
        with ui.expansion(f"{rows.label} ({len(rows.rows)})", value=bool(rows.rows)).classes("inner") as box:
            box.props("dense")
            _explain(box, rows.help)
            for number, items in enumerate(rows.rows):
                with ui.row().classes("row-head"):
                    ui.label(f"{number + 1}")
                    self._button("delete", word("remove"), (*rows.path, number), None)
                self._list(items)
            self._button("add", word("add"), (*rows.path, len(rows.rows)), {})

    def _button(self, icon: str, says: str, path: Path, value: Any) -> None:
        def pressed() -> None:
            self._take(path, value)
            self.draw()

        ui.button(icon=icon, on_click=pressed).props(f'flat dense round aria-label="{says}"').tooltip(says)

    def _take(self, path: Path, value: Any) -> None:
        before = self.document.text
        self.document.change(path, value)
        self._told(before)

    def _told(self, before: str) -> None:
        """Tell of a change of the document since it was another text."""
        if self.document.text != before:
            self._changed()


def _on_typed(field: ui.input, take: Callable[[], None]) -> None:
    """Take what is typed; a field that is emptied when it is left, for most are filled anew."""
    is_held = False

    def entered() -> None:
        nonlocal is_held
        is_held = True

    def left() -> None:
        nonlocal is_held
        is_held = False
        changed()

    def changed() -> None:
        if not is_held or (field.value or "").strip():
            take()

    field.on_value_change(lambda _: changed())
    field.on("focus", entered)
    field.on("blur", left)


def _explain(control: ui.element, says: str) -> None:
    """Say what a control is for, above it: under it stands what is wrong with it."""
    if says:
        with control:
            ui.tooltip(says).props('anchor="top middle" self="bottom middle"')


def path_of(field: str) -> Path:
    """The path of a field as messages write it.

    >>> path_of("bearings[1 'Output wheel'].supply.pressure")
    ('bearings', 1, 'supply', 'pressure')
    """
    steps: list[str | int] = []
    for name, number in re.findall(r"([A-Za-z_]\w*)(?=[.\[]|$)|\[(\d+)[^\]]*\]", field):
        steps.append(name if name else int(number))
    return tuple(steps)


def _number(text: str) -> Any:
    text = text.strip()
    if not text:
        return None
    return (int(text) if re.fullmatch(r"[+-]?\d+", text) else float(text)) if is_number(text) else text


def _word(text: str) -> Any:
    return text.strip() or None


def _listed(text: str) -> Any:
    return [_number(one) for one in text.split(",") if one.strip()] or None
