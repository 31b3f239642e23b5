"""A case while it is changed: what it gives, its text, and the way back."""

from __future__ import annotations

import copy
import itertools
import re
import zlib
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from babbitt.app.form import TEXT, Item, Path, form_of
from babbitt.app.rewriting import mapping_in, rewritten
from babbitt.case.parts.clearance import restated
from babbitt.case.with_units import case_text

__all__ = ["CaseDocument", "path_in", "with_changed"]

MOST_STEPS = 200
"""Changes that can be taken back."""

LONGEST_STEM = 60
"""Characters of the name of a case in that of a file."""


class CaseDocument:
    """The text of a case, in step with what it gives, and all its earlier texts.

    Parameters
    ----------
    text : str
        YAML or JSON.
    """

    def __init__(self, text: str) -> None:
        self._texts, self._place = [_packed(text)], 0
        self._before: str | None = None
        self._read: tuple[str, dict[str, Any]] = ("", {})
        self._drawn: tuple[str, tuple[Item, ...]] = ("", ())

    @property
    def text(self) -> str:
        """As it stands."""
        return _unpacked(self._texts[self._place])

    @property
    def given(self) -> dict[str, Any]:
        """What it says, read once for each text; empty for a text that is no mapping."""
        if self._read[0] != self.text:
            self._read = (self.text, mapping_in(self.text))
        return self._read[1]

    @property
    def without_study(self) -> dict[str, Any]:
        """What it says but for the study that is asked of it."""
        return with_changed(self.given, ("study",), None)

    @property
    def items(self) -> tuple[Item, ...]:
        """Its fields as a form, made once for each text; none where the text names no kind of case."""
        if self._drawn[0] != self.text:
            try:
                self._drawn = (self.text, form_of(self.given))
            except (KeyError, TypeError):
                self._drawn = (self.text, ())
        return self._drawn[1]

    def file_name(self, what: str) -> str:
        """Name of a file that is taken along: the name of the case, and what it is.

        >>> CaseDocument("name: Fan shaft (hot)").file_name("report.pdf")
        'Fan_shaft_hot-report.pdf'
        """
        stem = re.sub(r"\W+", "_", str(self.given.get("name") or "")).strip("_")[:LONGEST_STEM]
        return f"{stem}-{what}" if stem else what

    def begin(self, text: str) -> None:
        """Take another text to begin with: there is no way back to the one before."""
        self._texts, self._place, self._before = [_packed(text)], 0, None

    def write(self, text: str) -> None:
        """Take another text in its place; a movement ends before."""
        self.keep()
        if text == self.text:
            return
        self._texts = [*self._texts[: self._place + 1], _packed(text)][-MOST_STEPS:]
        self._place = len(self._texts) - 1

    def change(self, path: Path, value: Any) -> None:
        """Put a value in a field; None takes the field away."""
        self._give(with_changed(self.given, path, value))

    def take(self, text: str) -> None:
        """Take the values of another text; lines and comments remain, unless it is another kind of case."""
        given = mapping_in(text)
        if given.get("kind") == self.given.get("kind"):
            self._give(given)
        else:
            self.write(text)

    def _give(self, given: Mapping[str, Any]) -> None:
        self.keep()
        self.write(rewritten(self.text, given))

    def choose(self, path: Path, way: str) -> None:
        """Give a part in another way, `TEXT` in words; a clearance remains the same gap."""
        kind = "" if way == TEXT else way
        before = self._at(path) if self.has(path) else None
        in_short = before.get("kind", "") if isinstance(before, Mapping) else ""
        chosen: Any = {"kind": kind} if kind else in_short
        if path[-1] == "clearance" and before is not None:
            bearing = self._at(path[:-1])
            chosen = restated(bearing.get("clearance"), kind, bearing.get("diameter"))
        self.change(path, chosen)

    def slide(self, path: Path, value: Any) -> None:
        """Put a value in a field while it moves: the way back leads to where the movement began.

        The text is written anew, which is quick; its comments are back when the movement ends.
        """
        if self._before is None:
            self._before = self.text
        self._texts[self._place] = _packed(case_text(with_changed(self.given, path, value)))

    def keep(self) -> None:
        """End a movement."""
        moved, before = self.text, self._before
        self._before = None
        if before is not None:
            self._texts[self._place] = _packed(before)
            self.write(rewritten(before, mapping_in(moved)))

    def has(self, path: Path) -> bool:
        """Whether the case gives something at a path."""
        try:
            self._at(path)
        except (LookupError, TypeError):
            return False
        return True

    def _at(self, path: Path) -> Any:
        place: Any = self.given
        for step in path:
            place = place[step]
        return place

    def may_turn(self, field: str) -> bool:
        """Whether a hand may turn a field: one of the case itself, or within something that it gives."""
        path = path_in(field)
        return len(path) == 1 or self.has(path[:-1])

    def undo(self) -> None:
        """Go back by one change, a movement that has not ended being one."""
        self.keep()
        self._place = max(self._place - 1, 0)

    def redo(self) -> None:
        """Go forward by one change that was taken back."""
        self.keep()
        self._place = min(self._place + 1, len(self._texts) - 1)


def _packed(text: str) -> bytes:
    """A text as it is kept: 200 of 15 kB for every visitor are more than a server has room for."""
    return zlib.compress(text.encode(errors="surrogatepass"))


@lru_cache(maxsize=64)
def _unpacked(kept: bytes) -> str:
    return zlib.decompress(kept).decode(errors="surrogatepass")


def path_in(text: str) -> Path:
    """A path that is written with dots.

    >>> path_in("grooves.0.angle")
    ('grooves', 0, 'angle')
    """
    return tuple(int(step) if step.isdecimal() else step for step in text.split("."))


def with_changed(given: Mapping[str, Any], path: Path, value: Any) -> dict[str, Any]:
    """What a case gives with another value at a path; None takes it away, and a list keeps its order.

    A part that was given by a word, such as ``method: film``, becomes a mapping of this ``kind`` where a field
    within it is set.

    >>> with_changed({"method": "film"}, ("method", "thermal"), "full")
    {'method': {'kind': 'film', 'thermal': 'full'}}
    >>> with_changed({"grooves": [{"angle": 0}]}, ("grooves", 0, "angle"), None)
    {'grooves': [{}]}
    """
    made = copy.deepcopy(dict(given))
    place: Any = made
    for step, following in itertools.pairwise(path):
        if isinstance(place, list) and step == len(place):
            place.append(None)
        inside = place[int(step)] if isinstance(place, list) else place.get(step)
        if isinstance(inside, str) and isinstance(following, str):
            inside = {"kind": inside}
        if not isinstance(inside, dict | list):
            inside = [] if isinstance(following, int) else {}
        place[step] = inside
        place = inside
    _put(place, path[-1], value)
    return made


def _put(place: Any, step: str | int, value: Any) -> None:
    if isinstance(place, list):
        index = int(step)
        place[index : index + 1] = [] if value is None else [value]
    elif value is None:
        place.pop(step, None)
    else:
        place[step] = value
