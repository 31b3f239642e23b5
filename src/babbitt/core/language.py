"""The language in which reports are written now, and the texts of other languages than English.

English stands in the modules and in ``words.en.toml``. Another language has ``words.LANGUAGE.toml`` in the same
folders: sentences of notices under their codes (`babbitt.core.notices.words`), other texts in three tables:

- ``phrases``: the English text and that of the language. A ``{placeholder}`` stands for a part that changes.
- ``composed``: the same for texts that come composed, such as assumptions: they are recognised by the words
  between the placeholders, and the parts are translated alike; ``{placeholder:number}`` is a number alone.
- ``plurals``: an English noun and its forms after a number: two in German, three in Russian.

A text without a translation stays English and is remembered, so that whoever writes the report can say so.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any

__all__ = [
    "COMPOSED",
    "ENGLISH",
    "LANGUAGES",
    "PHRASES",
    "PLURALS",
    "add_folder",
    "composed",
    "decimal",
    "folders",
    "has_folder",
    "keeping",
    "language",
    "listed",
    "phrases",
    "plural",
    "read_again",
    "read_words",
    "translated",
    "translated_if_known",
    "unit_sign",
    "written_in",
]

ENGLISH = "en"

LANGUAGES = {ENGLISH: "English", "de": "German", "ru": "Russian"}

PHRASES, COMPOSED, PLURALS = "phrases", "composed", "plurals"
"""Tables of a file of words that belong to no code."""

NUMBER = re.compile(r"[±+−-]?\d+(\.\d+)?(e[+−-]?\d+)?\D{0,12}")
"""A number, perhaps with its unit."""

NUMBERS = re.compile(rf"{NUMBER.pattern}(, {NUMBER.pattern})+")
"""Several numbers."""

UNITS = {"de": {"rpm": "1/min"}, "ru": {"rpm": "r/min"}}
"""Labels of units that are English words, and their signs: DIN 1301-1, GOST 8.417 (international sign)."""

MOST_TEXTS = 10_000
"""Composed texts that are remembered: cases hold any number of others, and a server writes reports for long."""

_OTHERS: list[str] = []
"""Packages of other kinds that have texts."""


@dataclass
class _Writing:
    """What is written now: in which language, which texts it lacks, and which are words of the case."""

    language: str = ENGLISH
    missing: dict[str, None] = field(default_factory=dict)
    own: frozenset[str] = frozenset()


_WRITING: ContextVar[_Writing] = ContextVar("babbitt_language", default=_Writing())  # noqa: B039 - never written to


@contextmanager
def written_in(chosen: str) -> Iterator[Mapping[str, None]]:
    """Reports and plots that are made inside are written in a language; ends with the block.

    Yields
    ------
    mapping
        The texts that the language lacks, in the order in which they were wanted.

    Raises
    ------
    ValueError
        For a language that is not known.

    >>> with written_in("de") as missing:
    ...     translated("Specific load"), decimal("2.51 MPa"), translated("no such text")
    ('Spezifische Lagerbelastung', '2,51 MPa', 'no such text')
    >>> list(missing)
    ['no such text']
    """
    if chosen not in LANGUAGES:
        raise ValueError(f"'{chosen}' is no language of reports; there are: {', '.join(LANGUAGES)}")
    writing = _Writing(chosen)
    former = _WRITING.set(writing)
    try:
        yield writing.missing
    finally:
        _WRITING.reset(former)


@contextmanager
def keeping(own: Iterable[str]) -> Iterator[None]:
    """Words of a case, such as the name of an oil, are not taken for texts of a module; ends with the block.

    >>> with written_in("de"), keeping(["laminar film"]):
    ...     translated_if_known("laminar film"), translated_if_known("rigid surfaces")
    ('laminar film', 'starre Oberflächen')
    """
    former = _WRITING.set(replace(_WRITING.get(), own=frozenset(own)))
    try:
        yield
    finally:
        _WRITING.reset(former)


def language() -> str:
    """The language in which is written now."""
    return _WRITING.get().language


def translated(text: str, /, **values: Any) -> str:
    """A text of a module in the language that is written now, its placeholders filled.

    Parameters
    ----------
    text : str
        In English.
    **values
        What stands for its placeholders, translated already.

    >>> translated("{first} of {second}", first=1, second=2)
    '1 of 2'
    """
    writing = _WRITING.get()
    if writing.language == ENGLISH:
        return text.format(**values) if values else text
    found = phrases(writing.language).get(text)
    if found is None and not values:
        found = _recognised(text, writing.language, writing.own)
    if found is None:
        if text and not NUMBER.fullmatch(text):
            writing.missing[text] = None
        found = text
    return found.format(**values) if values else found


def translated_if_known(text: str) -> str:
    """A text that may be the user's own: translated where it is known, numbers with the sign of the language."""
    language_code, own = language(), _WRITING.get().own
    if language_code == ENGLISH or text in own:
        return text
    found = phrases(language_code).get(text) or _recognised(text, language_code, own)
    if found is not None:
        return found
    if NUMBERS.fullmatch(text):
        return listed(text.split(", "))
    return decimal(text) if NUMBER.fullmatch(text) else text


def listed(numbers: Iterable[str]) -> str:
    """Numbers one after the other: where any has a decimal comma, semicolons stand between them.

    >>> listed(["0.5", "1"])
    '0.5, 1'
    >>> with written_in("de"):
    ...     listed(["0.5", "1"]), listed(["1", "2"])
    ('0,5; 1', '1, 2')
    """
    said = [decimal(one) for one in numbers]
    return ("; " if any("," in one for one in said) else ", ").join(said)


def decimal(number: str) -> str:
    """A number with its decimal sign: a comma in German and Russian, which set the sign of per cent apart, too.

    >>> with written_in("ru"):
    ...     decimal("0.25"), decimal("+31.5%")
    ('0,25', '+31,5 %')
    """
    if language() == ENGLISH:
        return number
    return re.sub(r"(?<=\d)%", " %", re.sub(r"(?<=\d)\.(?=\d)", ",", number))


def unit_sign(label: str) -> str:
    """The sign of a unit, which is another where the label is an English word.

    >>> with written_in("de"):
    ...     unit_sign("rpm"), unit_sign("MPa")
    ('1/min', 'MPa')
    """
    return UNITS.get(language(), {}).get(label, label)


def plural(noun: str, number: int) -> str:
    """The form of a noun after a number.

    >>> plural("bearing", 2)
    'bearings'
    >>> with written_in("ru"):
    ...     plural("bearing", 1), plural("bearing", 3), plural("bearing", 11), plural("bearing", 22)
    ('подшипник', 'подшипника', 'подшипников', 'подшипника')
    """
    language_code = language()
    forms = _plurals(language_code).get(noun)
    if forms is None:
        if language_code != ENGLISH:
            _WRITING.get().missing[noun] = None
        return noun if number == 1 else f"{noun}s"
    if language_code == "ru":  # one, few, many (Unicode CLDR, plural rules)
        tens, units = number % 100, number % 10
        if units == 1 and tens != 11:
            return forms[0]
        return forms[1] if units in (2, 3, 4) and tens not in (12, 13, 14) else forms[2]
    return forms[0] if number == 1 else forms[1]


@cache
def phrases(language_code: str) -> Mapping[str, str]:
    """English texts and their translations."""
    return _table(language_code, PHRASES)


@cache
def composed(language_code: str) -> Mapping[str, str]:
    """The same of texts that come composed."""
    return _table(language_code, COMPOSED)


@cache
def _plurals(language_code: str) -> Mapping[str, Sequence[str]]:
    return _table(language_code, PLURALS)


def _table(language_code: str, name: str) -> dict[str, Any]:
    return {text: said for words in _words(language_code) for text, said in words.get(name, {}).items()}


@cache
def _words(language_code: str) -> tuple[dict[str, Any], ...]:
    return tuple(read_words(folder, language_code) for folder in folders())


@cache
def _patterns(language_code: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """Phrases with placeholders as expressions that recognise a composed text, those with most words first."""
    found = []
    for text, said in composed(language_code).items():
        parts = re.split(r"\{(\w+(?::number)?)\}", text)
        made = "".join(_piece(part) if place % 2 else re.escape(part) for place, part in enumerate(parts))
        found.append((sum(map(len, parts[::2])), re.compile(made, re.DOTALL), said))
    return tuple((pattern, said) for _, pattern, said in sorted(found, key=lambda one: -one[0]))


def _piece(placeholder: str) -> str:
    name, _, kind = placeholder.partition(":")
    return f"(?P<{name}>[+−-]?\\d[\\d.]*)" if kind else f"(?P<{name}>.+?)"


@lru_cache(MOST_TEXTS)
def _recognised(text: str, language_code: str, own: frozenset[str]) -> str | None:
    """A composed text in a language, by the phrase it was composed from; None where there is none.

    Its parts are translated but for words of the case, `own`.
    """
    for pattern, said in _patterns(language_code):
        if (found := pattern.fullmatch(text)) is not None:
            return said.format(**{name: translated_if_known(part) for name, part in found.groupdict().items()})
    return None


def add_folder(package: str) -> None:
    """Know the texts of another package, which stand beside its modules."""
    _OTHERS.append(package)
    read_again()


def has_folder(package: str) -> bool:
    """Whether the texts of another package are known."""
    return package in _OTHERS


def read_again() -> None:
    """Forget what was read, for other folders have texts now."""
    for cached in (phrases, composed, _plurals, _words, _patterns, _recognised):
        cached.cache_clear()


def folders() -> Iterator[Traversable]:
    """Where texts may stand: first those of all kinds, of reports and page, then each kind's, then others."""
    yield files("babbitt.core.notices")
    yield from (files("babbitt").joinpath(name) for name in ("report", "app"))
    yield from sorted(files("babbitt").joinpath("kinds").iterdir(), key=lambda folder: folder.name)
    yield from map(files, _OTHERS)


def read_words(folder: Traversable, language_code: str) -> dict[str, Any]:
    """The texts of a folder in a language; none where it has no such file."""
    file = folder.joinpath(f"words.{language_code}.toml")
    return tomllib.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
