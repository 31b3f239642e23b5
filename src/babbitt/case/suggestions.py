"""What an unknown key may have meant: a word of the synonym table, a near typo, a field further down."""

from __future__ import annotations

import re
import tomllib
import typing
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from babbitt.core.nearest_name import nearest_names

if TYPE_CHECKING:
    from babbitt.case.part import Part

__all__ = ["meant_field", "near_typo", "synonyms"]

NEAR = 0.75
"""Likeness from which two words are one with a typo: two letters exchanged in one of four. Higher than of other
names, since a field that is not meant has a meaning of its own."""

_UNIT_AT_THE_END = re.compile(
    r"_(mm|um|m|in|kn|n|lbf|rpm|rad_s|hz|mpa|kpa|pa|bar|psi|degc|celsius|c|k|deg|kg|t|l_min|m_s)$"
)


def meant_field(name: str, cls: type[Part]) -> str:
    """Path from a part to the field that an unknown key seems to mean; empty where that would be a guess.

    Parameters
    ----------
    name : str
        The key as it was written.
    cls : type
        The part where it stands.
    """
    word = _plain(name)
    words = dict.fromkeys((word, _UNIT_AT_THE_END.sub("", word)))
    for said in (_own_field, _synonym, _typo, _further_down):
        for one in words:
            if field := said(one, cls):
                return field
    return ""


def near_typo(name: str, known: Iterable[str]) -> str:
    """The known name that differs from what was written by a typo, rarely one in the first letter; empty if none.

    >>> near_typo("laod", ["load", "speed"]), near_typo("length", ["width", "depth"])
    ('load', '')
    """
    word = _plain(name)
    alike = [one for one in known if one[:1].lower() == word[:1]]
    return next(iter(nearest_names(word, alike, spelled=str, alike=NEAR)), "")


@cache
def synonyms() -> Mapping[str, tuple[str, ...]]:
    """Fields by the word that people write for them, in the order in which they are tried."""
    table = tomllib.loads(files("babbitt.case").joinpath("synonyms.toml").read_text(encoding="utf-8"))
    found: dict[str, tuple[str, ...]] = {}
    for field, words in table.items():
        for word in words:
            found[word] = (*found.get(word, ()), field)
    return found


def _plain(name: str) -> str:
    return re.sub(r"[\s\-./]+", "_", name.strip().lower())


def _own_field(word: str, cls: type[Part]) -> str:
    return word if word in cls.model_fields else ""


def _synonym(word: str, cls: type[Part]) -> str:
    return next((field for field in synonyms().get(word, ()) if _has(cls, field.split("."))), "")


def _typo(word: str, cls: type[Part]) -> str:
    return near_typo(word, cls.model_fields)


def _further_down(word: str, cls: type[Part]) -> str:
    """A field of that name in one of the mappings of a part, if it is in one alone."""
    holders = [
        name for name in cls.model_fields if any(word in part.model_fields for part in _parts_of(cls, name))
    ]
    return f"{holders[0]}.{word}" if len(holders) == 1 else ""


def _has(cls: type[Part], steps: list[str]) -> bool:
    first, *rest = steps
    if first not in cls.model_fields:
        return False
    return not rest or any(_has(part, rest) for part in _parts_of(cls, first))


@cache
def _parts_of(cls: type[Part], name: str) -> tuple[type[Part], ...]:
    return tuple(_parts_in(cls.model_fields[name].annotation))


def _parts_in(annotation: Any) -> Iterator[type[Part]]:
    if hasattr(annotation, "model_fields"):
        yield annotation
    elif typing.get_origin(annotation) is not tuple:
        for one in typing.get_args(annotation):
            yield from _parts_in(one)
