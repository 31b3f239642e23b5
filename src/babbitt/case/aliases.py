"""Former words of the case language, read as those of today before anything is checked.

A part names them in `former_words`: path of the former word and path of the one that took its place, both from the
part. What is wrong with the value is reported at the word that the file has.
"""

from __future__ import annotations

import re
import typing
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import TYPE_CHECKING, Any

from babbitt.case.error_messages import Path
from babbitt.case.method_mapping import (
    KIND,
    METHOD,
    choices_of,
    every_choice,
    in_mapping,
    method_models,
    named_method,
    read_method,
)
from babbitt.case.nested import values_at, with_value, without_value
from babbitt.case.reading import Reading

if TYPE_CHECKING:
    from babbitt.case.part import Part

__all__ = [
    "FormerWords",
    "Move",
    "Moved",
    "in_former_words",
    "in_method_mappings",
    "in_todays_words",
    "may_be",
    "moves",
    "read_former",
    "read_given",
    "scaled",
    "todays_field",
    "todays_path",
    "part_at",
    "parts_in",
]


def _always(value: Any) -> bool:
    return True


@dataclass(frozen=True)
class Moved:
    """Where the value of a former word stands today, if more is to be said than its path.

    Attributes
    ----------
    to : str
        Path of the word of today.
    kind : str
        What the mapping that holds it is, where that has a `kind`.
    scale : float
        The value of today over the former one: 2 for a diameter in place of a radius.
    where : callable
        Tells the former form of a value from that of today where both have one word.
    """

    to: str
    kind: str = ""
    scale: float = 1.0
    where: Callable[[Any], bool] = _always

    @property
    def path(self) -> tuple[str, ...]:
        """Path of the word of today."""
        return tuple(self.to.split("."))


@dataclass(frozen=True)
class Move:
    """A value of a file that is written elsewhere today.

    Attributes
    ----------
    base : tuple
        Path of the part that tells of it.
    former, today : tuple
        Paths of the value from the part.
    kind : str
        Of the mapping that holds it today, where that has a `kind`.
    scale : float
        The value of today over the former one.
    """

    base: Path
    former: tuple[str, ...]
    today: tuple[str, ...]
    kind: str = ""
    scale: float = 1.0

    @property
    def path(self) -> Path:
        """Where it stands in the file."""
        return (*self.base, *self.former)


FormerWords = Mapping[str, str | Moved]


def read_former(words: FormerWords, given: Mapping[str, Any]) -> Reading:
    """Read the former words of one part as those of today.

    Parameters
    ----------
    words : Mapping
        `former_words` of the part.
    given : Mapping
        As it stands in the file; it is not changed.
    """
    if not words:
        return Reading(given, given)
    today: dict[str, Any] = dict(given)
    found = [
        (former, one, value)
        for former, one in _steps(words)
        for value in values_at(given, former)
        if one.where(value)
    ]
    for former, _, _ in found:
        today = without_value(today, former)
    moved: list[tuple[Path, Path]] = []
    twice: list[tuple[Path, Path]] = []
    for former, one, value in found:
        if (blocked := _occupied(today, one)) is not None:
            twice.append((former, blocked))
            continue
        today = with_value(today, one.path, scaled(value, one.scale))
        if one.kind:
            today = with_value(today, (*one.path[:-1], "kind"), one.kind)
        moved.append((former, one.path))
    scales: dict[Path, float] = {former: one.scale for former, one, _ in found}
    return Reading(today, given, tuple(moved), tuple(twice), scales=scales)


def read_given(cls: type[Part], given: Mapping[str, Any]) -> Reading:
    """Read what a part was given as its model has it: the choices of its method, then former words."""
    chosen = read_method(cls, given)
    today = read_former(cls.former_words, chosen.given)
    moved, twice = chosen.moved + today.moved, chosen.twice + today.twice
    return Reading(today.given, given, moved, twice, chosen.unknown, today.scales)


def in_todays_words(cls: type[Part], given: Any) -> Any:
    """What a part was given, its parts included, in the words of its model: no former ones, and every choice of a
    method where the part reads it."""
    if not isinstance(given, Mapping):
        return given
    today = read_given(cls, given).given
    return {name: _within(_parts_of(cls, name), value, in_todays_words) for name, value in today.items()}


def in_method_mappings(cls: type[Part], given: Any) -> Any:
    """What a part was given in the words of its model, as a file has it: the choices of methods in mappings."""
    if not isinstance(given, Mapping):
        return given
    within = {name: _within(_parts_of(cls, name), value, in_method_mappings) for name, value in given.items()}
    return in_mapping(cls, within)


def moves(cls: type[Part], given: Any, base: Path = ()) -> Iterator[Move]:
    """What of a part, and of the parts within, is not written as it is today.

    Choices of another method than that of the part stay where they are: a comparison reads them.

    Parameters
    ----------
    cls : type
    given : object
        As it stands in the file.
    base : tuple
        Path of the part.
    """
    if not isinstance(given, Mapping):
        return
    for former, one in _steps(cls.former_words):
        if any(one.where(value) for value in values_at(given, former)):
            yield Move(base, former, one.path, one.kind, one.scale)
    method = named_method(cls, given)
    for name, path in choices_of(cls, method).items():
        if any(True for _ in values_at(given, path)):
            yield Move(base, path, (METHOD, name), method)
    for name, value in given.items():
        several = enumerate(value) if isinstance(value, list | tuple) else ()
        for at, one in (((name,), value), *(((name, index), piece) for index, piece in several)):
            parts = (part for part in _parts_of(cls, name) if isinstance(one, Mapping) and may_be(part, one))
            yield from dict.fromkeys(move for part in parts for move in moves(part, one, (*base, *at)))


def todays_path(cls: type[Part], steps: Sequence[str]) -> tuple[str, ...]:
    """Path of a field in the words of today, its names and numbers from a part on.

    Parameters
    ----------
    cls : type
    steps : sequence of str
        In former words or in those of today.
    """
    return todays_field(cls, steps)[0]


def todays_field(cls: type[Part], steps: Sequence[str]) -> tuple[tuple[str, ...], float]:
    """As `todays_path`, and the value of today over that at the path as it was given."""
    if steps[0] == METHOD and len(steps) > 1 and method_models(cls):
        choice = {**every_choice(cls), KIND: (METHOD,)}.get(steps[1], (METHOD, steps[1]))
        return (*choice, *steps[2:]), 1.0
    for former, one in _steps(cls.former_words):
        has_two_forms = former == one.path[: len(former)]
        if tuple(steps[: len(former)]) == former and not has_two_forms:
            path, scale = todays_field(cls, (*one.path, *steps[len(former) :]))
            return path, scale * one.scale
    count = 1
    while count < len(steps) and steps[count].isdecimal():
        count += 1
    rest = tuple(steps[count:])
    branches = (todays_field(part, rest) for part in _parts_of(cls, steps[0])) if rest else ()
    path, scale = next((found for found in branches if found[0] != rest), (rest, 1.0))
    return (*steps[:count], *path), scale


def in_former_words(cls: type[Part], content: Mapping[str, Any]) -> dict[str, Any]:
    """The content of one part with former words where it has them: what hashes are made of, so that they last."""
    renamed = dict(content)
    for former, one in _steps(cls.former_words):
        values = list(values_at(renamed, one.path))
        if not values or (one.kind and not _is_alone(renamed, one)):
            continue
        renamed = without_value(renamed, one.path[:-1] if one.kind else one.path)
        renamed = with_value(renamed, former, values[0] if one.scale == 1.0 else values[0] / one.scale)
    return renamed


def _steps(words: FormerWords) -> Iterator[tuple[tuple[str, ...], Moved]]:
    for former, one in words.items():
        yield tuple(former.split(".")), Moved(one) if isinstance(one, str) else one


def _occupied(given: Mapping[str, Any], one: Moved) -> Path | None:
    """Path of what stands where a value is to go; None where there is room."""
    for count in range(1, len(one.path) + 1):
        for value in values_at(given, one.path[:count]):
            room = value is None or (isinstance(value, Mapping) and count < len(one.path) and not one.kind)
            if not room:
                return one.path[:count]
    return None


_QUANTITY = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(\s*[^\d\s].*)?", re.DOTALL)


def scaled(value: Any, scale: float) -> Any:
    """A quantity times a power of two, exact to the last bit; what is none is reported where it is read."""
    if scale == 1.0 or isinstance(value, bool):
        return value
    if isinstance(value, int | float):
        return type(value)(scale * value) if isinstance(value, float) else scale * value
    number = _QUANTITY.fullmatch(value) if isinstance(value, str) else None
    return f"{Decimal(number[1]) * Decimal(scale)}{number[2] or ''}" if number else value


def _is_alone(content: Mapping[str, Any], one: Moved) -> bool:
    """Whether the mapping of a kind says no more than its kind and the value."""
    return all(dict(holder).keys() == {"kind", one.path[-1]} and holder["kind"] == one.kind
               for holder in values_at(content, one.path[:-1]))  # fmt: skip


def _within(parts: Sequence[type[Part]], value: Any, change: Callable[[type[Part], Any], Any]) -> Any:
    if isinstance(value, list | tuple):
        return [_within(parts, one, change) for one in value]
    for part in parts:
        if isinstance(value, Mapping) and may_be(part, value):
            value = change(part, value)
    return value


def may_be(part: type[Part], value: Mapping[str, Any]) -> bool:
    """Whether a mapping may be a part, by its ``kind`` where the part has one."""
    kinds = typing.get_args(part.model_fields["kind"].annotation) if "kind" in part.model_fields else ()
    return not kinds or value.get("kind", kinds[0]) in kinds


def _parts_of(cls: type[Part], name: str) -> tuple[type[Part], ...]:
    known = cls.model_fields.get(name)
    return () if known is None else tuple(parts_in(known.annotation))


def part_at(cls: type[Part], steps: Sequence[str]) -> type[Part]:
    """The part that a path in the words of today leads to from another; of a union the first."""
    for step in steps:
        if not step.isdecimal():
            cls = next(iter(_parts_of(cls, step)), cls)
    return cls


def parts_in(annotation: Any) -> Iterator[type[Part]]:
    """Parts that a field may hold, itself or in a list."""
    if hasattr(annotation, "former_words"):
        yield annotation
    for one in typing.get_args(annotation):
        yield from parts_in(one)
