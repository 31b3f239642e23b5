"""A value of a YAML text moved to another key, comments with it; every other letter of the text stays.

The places of keys and values come from PyYAML, which reads the text anew for every move.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from babbitt.case.aliases import Move, scaled
from babbitt.core.picklable_error import PicklableError

__all__ = ["NotMovableError", "moved_text"]

STEP = 2
"""Spaces by which a mapping that is made is indented."""

_RULE = re.compile(r"[-=]{4,}")
_FIELD = re.compile(r"#\s*(?:- )?[\w']+:(?:\s|$)")
_ALIAS = re.compile(r"\s*:\s*\*[^\s,}\]]+")


class NotMovableError(PicklableError):
    """A value that stands where it cannot be moved alone: behind an alias, or as a block that a line must take."""


@dataclass(frozen=True)
class _Entry:
    """A key of a mapping with its value: from `start` to `end` in the text."""

    text: str
    key: Any
    value: Any
    is_flow: bool

    @property
    def start(self) -> int:
        return int(self.key.start_mark.index)

    @property
    def column(self) -> int:
        return int(self.key.start_mark.column)

    @property
    def is_alias(self) -> bool:
        return bool(self.value.start_mark.index < self.key.start_mark.index)

    @property
    def end(self) -> int:
        """Where the value ends."""
        if self.is_alias:
            found = _ALIAS.match(self.text, self.key.end_mark.index)
            return found.end() if found else int(self.key.end_mark.index)
        return _end(self.text, self.value)

    @property
    def key_text(self) -> str:
        return self.text[self.start : self.key.end_mark.index]

    @property
    def value_text(self) -> str:
        return self.text[self.value.start_mark.index : self.end]

    @property
    def first_line(self) -> int:
        """Where the comments directly above it begin; headings and fields in comments are left."""
        start = self.line
        while start > 0:
            above = self.text.rfind("\n", 0, start - 1) + 1
            line = self.text[above : start - 1]
            is_own = line.startswith(" " * self.column + "#")
            if not is_own or _RULE.search(line) or _FIELD.search(line):
                break
            start = above
        return start

    @property
    def line(self) -> int:
        """Where its line begins."""
        return self.text.rfind("\n", 0, self.start) + 1

    @property
    def heading(self) -> str:
        """The comment behind the key of a block, as a line of its own; empty where there is none."""
        rest = self.text[self.key.end_mark.index : _line_end(self.text, self.start)]
        found = re.fullmatch(r"\s*:\s*(#.*)", rest.rstrip())
        return f"{' ' * self.column}{found[1]}\n" if found and not self.is_flow else ""

    @property
    def comments(self) -> str:
        """The comments above it and behind it in a block, as lines of their own."""
        if self.is_flow or self.is_first_in_list:
            return ""
        behind = self.text[self.end : self.last_line].lstrip()
        return self.text[self.first_line : self.line] + (f"{' ' * self.column}{behind}" if behind else "")

    @property
    def is_first_in_list(self) -> bool:
        """Whether something but spaces stands before it on its line, such as the dash of a list."""
        return bool(self.text[self.line : self.start].strip())

    @property
    def last_line(self) -> int:
        """Where the line behind it begins, and behind comments that are indented deeper than its key."""
        end = _line_end(self.text, self.end)
        while end < len(self.text):
            behind = _line_end(self.text, end)
            line = self.text[end:behind]
            if not line.strip().startswith("#") or len(line) - len(line.lstrip()) <= self.column:
                break
            end = behind
        return end


Splice = tuple[int, int, str]
"""Where a piece of a text begins and ends, and what takes its place."""


def moved_text(text: str, move: Move) -> str:
    """The text with one value at its new place.

    Parameters
    ----------
    text : str
        Of a case that can be used.
    move : Move

    Raises
    ------
    NotMovableError
        Where the value cannot be moved alone.
    """
    import yaml

    base = _mapping(yaml.compose(text, Loader=yaml.SafeLoader), move.base)
    holder = _mapping(base, move.former[:-1])
    source = _entry(text, holder, move.former[-1])
    *above, last = move.today
    piece = _Piece(source, move)
    if tuple(above) == move.former[:-1]:
        return _spliced(text, (source.start, source.end, piece.inline))
    if tuple(above) == move.former:  # of several forms now, of which this is one
        made = f"{source.key_text}: {{{piece.kind}, {piece.inline}}}"
        return _spliced(text, (source.start, source.end, made))
    outer = _entry(text, base, move.former[0]) if len(holder.value) == 1 and holder is not base else None
    removal = _removal(text, base, outer, outer.heading) if outer else _removal(text, holder, source)
    if above and above[0] not in _keys(base):
        return _spliced(text, *_made(piece, base, move, outer, removal))
    target = _entry(text, base, above[0]) if above else None
    if target is not None and not hasattr(target.value, "flow_style"):
        return _spliced(text, removal, *_opened(piece, target))
    into = base if target is None else target.value
    if outer is None and (into.flow_style or last in _keys(into)):
        removal = (*removal[:2], removal[2] + source.comments)
    if last in _keys(into):
        return _spliced(text, removal)
    return _spliced(text, removal, _insertion(piece, text, into))


@dataclass(frozen=True)
class _Piece:
    """What is moved, as it is written at its new place."""

    source: _Entry
    move: Move

    def _like_source(self, word: str) -> str:
        quote = self.source.key_text[0]
        return f"{quote}{word}{quote}" if quote in "\"'" else word

    def named(self, word: str) -> str:
        """A key, in quotation marks where that of the source is."""
        return f"{self._like_source(word)}:"

    @property
    def kind(self) -> str:
        """The kind of the mapping that holds it; empty where that has none."""
        return f"{self.named('kind')} {self._like_source(self.move.kind)}" if self.move.kind else ""

    @property
    def value(self) -> str:
        """Its value; one that is scaled keeps its quotation marks."""
        if self.move.scale == 1.0:
            return self.source.value_text
        quote = self.source.value_text[0] if self.source.value_text[0] in "\"'" else ""
        return f"{quote}{scaled(self.source.value.value, self.move.scale)}{quote}"

    @property
    def inline(self) -> str:
        """Key and value."""
        return f"{self.named(self.move.today[-1])} {self.value}"

    @property
    def in_flow(self) -> str:
        """Key and value for a mapping in braces."""
        if getattr(self.source.value, "flow_style", None) is False:
            raise NotMovableError("a block cannot stand in braces")
        return self.inline

    @property
    def braces(self) -> str:
        """A mapping in braces with it alone, and with its kind."""
        return "{" + ", ".join(filter(None, (self.kind, self.in_flow))) + "}"

    def lines(self, indent: int) -> str:
        """Its lines in a block, with its comments."""
        source, text = self.source, self.source.text
        if source.is_flow:
            return f"{' ' * indent}{self.inline}\n"
        begins = source.start - source.column
        head = "" if source.is_first_in_list else text[source.first_line : begins]
        key, colon = self.named(self.move.today[-1]), text.index(":", source.key.end_mark.index) + 1
        behind = text[source.end : source.last_line]
        if (more := indent - source.column) > 0 and behind.startswith(" " * (more + 2)):
            behind = behind[more:]  # the comment stays in its column
        body = key + text[colon : source.value.start_mark.index] + self.value + behind
        body = head + " " * source.column + (body if body.endswith("\n") else f"{body}\n")
        return "".join(
            " " * indent + line[min(source.column, len(line) - len(line.lstrip(" "))) :]
            for line in body.splitlines(keepends=True)
        )


def _keys(node: Any) -> list[str]:
    return [key.value for key, _ in node.value]


def _mapping(node: Any, path: Sequence[str | int]) -> Any:
    for step in path:
        if isinstance(step, int):
            node = node.value[step]
        else:
            found = [value for key, value in node.value if key.value == step]
            if not found:
                raise NotMovableError("it comes from an anchor")
            node = found[0]
    return node


def _entry(text: str, node: Any, name: str | int) -> _Entry:
    for key, value in node.value:
        if key.value == name:
            entry = _Entry(text, key, value, bool(node.flow_style))
            if not entry.is_alias:
                return entry
    raise NotMovableError("it comes from an anchor")


def _removal(text: str, holder: Any, entry: _Entry, heading: str | None = None) -> Splice:
    """Take an entry out of its mapping; of one that held the piece, the comments that tell of it stay."""
    place = next(index for index, (key, _) in enumerate(holder.value) if key is entry.key)
    later = [key.start_mark.index for key, _ in holder.value[place + 1 :]]
    if later and entry.is_flow:
        return entry.start, later[0], ""
    if entry.is_flow:
        key, value = holder.value[place - 1]
        return (_Entry(text, key, value, True).end if place else entry.start), entry.end, ""
    if entry.is_first_in_list and later:
        has_comments = bool(text[entry.last_line : later[0]].strip())
        return entry.start, entry.last_line + entry.column if has_comments else later[0], ""
    return (entry.first_line if heading is None else entry.line), entry.last_line, heading or ""


def _made(piece: _Piece, base: Any, move: Move, outer: _Entry | None, removal: Splice) -> Iterator[Splice]:
    """Make the mapping that holds the piece, where the piece stood or behind what held it."""
    text, direct = piece.source.text, len(move.former) == 1
    name = piece.named(str(move.today[0]))
    beside = piece.source if direct else _entry(text, base, move.former[0])
    if beside.is_flow:
        if direct or outer:
            yield beside.start, beside.end, f"{name} {piece.braces}"
        else:
            yield from (removal, (beside.end, beside.end, f", {name} {piece.braces}"))
        return
    indent = beside.column
    kind = f"{' ' * (indent + STEP)}{piece.kind}\n" if piece.kind else ""
    block = f"{' ' * indent}{name}\n{kind}{piece.lines(indent + STEP)}"
    if (direct or outer) and beside.is_first_in_list:
        yield beside.start, beside.last_line, block[indent:]
    elif direct or outer:
        yield (
            (beside.line if outer else beside.first_line),
            beside.last_line,
            (outer.heading if outer else "") + block,
        )
    else:
        yield from (removal, (beside.last_line, beside.last_line, block))


def _opened(piece: _Piece, target: _Entry) -> Iterator[Splice]:
    """Make a mapping of a name, such as that of the method, or of nothing."""
    value, kind = target.value.start_mark.index, f"{piece.named('kind')} {target.value_text}"
    if target.is_flow or not target.value_text:
        held = f"{kind}, {piece.in_flow}" if target.value_text else piece.in_flow
        yield value, target.end, f"{{{held}}}" if target.is_flow else f" {{{held}}}"
        return
    text, indent = target.text, target.column + STEP
    colon = text.index(":", target.key.end_mark.index) + 1
    gap = len(text[target.end :]) - len(text[target.end :].lstrip(" "))
    shorter = max(0, min(gap - 2, STEP + len(kind) - len(f"{target.key_text}: {target.value_text}")))
    yield colon, target.end + shorter, f"\n{' ' * indent}{kind}"
    yield _at_end(text, target.last_line, piece.lines(indent))


def _insertion(piece: _Piece, text: str, into: Any) -> Splice:
    """Put the piece at the end of a mapping."""
    if not into.value:
        return into.start_mark.index, into.end_mark.index, "{" + piece.in_flow + "}"
    key, value = into.value[-1]
    behind = _Entry(text, key, value, bool(into.flow_style))
    if into.flow_style:
        return behind.end, behind.end, f", {piece.in_flow}"
    return _at_end(text, behind.last_line, piece.lines(behind.column))


def _at_end(text: str, place: int, lines: str) -> Splice:
    """Lines behind others, the last of which may lack its end."""
    return place, place, lines if text[:place].endswith("\n") else f"\n{lines}"


def _line_end(text: str, place: int) -> int:
    found = text.find("\n", place)
    return len(text) if found < 0 else found + 1


def _end(text: str, node: Any) -> int:
    """Where a value ends, without the comments and empty lines behind it."""
    if getattr(node, "flow_style", None) is False and node.value:
        last = node.value[-1]
        if isinstance(last, tuple):
            key, value = last
            return _Entry(text, key, value, False).end
        if last.start_mark.index >= node.start_mark.index:
            return _end(text, last)
    end = int(node.end_mark.index)
    return len(text[:end].rstrip()) if text[:end].endswith((" ", "\n")) else end


def _spliced(text: str, *splices: Splice) -> str:
    for start, end, instead in sorted(splices, reverse=True):
        text = text[:start] + instead + text[end:]
    return text
