"""Texts of all codes, by language: ``words.LANGUAGE.toml`` here, in the folder of each kind and in other packages.

A code is a table with ``title``, ``meaning`` and ``remedy``, ``effect`` where a warning does not just question the
result, ``subject`` of a check that a bearing cannot be passed without, and ``message``, the sentence of a result:
a text, or a table with one for each variant. Messages of several codes stand in the table ``shared``; a kind may
add messages to a code of all kinds. Line breaks count as spaces, an empty line parts paragraphs of a meaning.
English is complete; other languages give the texts that they have, by the same keys.
A ``{placeholder}`` names a value of the notice:

- ``{load}``, the name of a quantity: the number with its unit, as in tables;
- ``{limit:film_reynolds_number}``, ``{depth:um}``: shown like that quantity, or in a unit of
  `babbitt.core.quantities.quantity.SI`;
- ``{pad}``, any other: a count, a name, or a number in SI with up to four digits;
- ``{given} < {least}``: where both read alike, as many digits as show the difference;
- ``{code:titled}``: a code with its title;
- ``{remedy}``: no value, but the remedy of the code, as the rest of a sentence.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable

from babbitt.core.language import (
    COMPOSED,
    ENGLISH,
    PHRASES,
    PLURALS,
    add_folder,
    folders,
    has_folder,
    language,
    read_words,
)
from babbitt.core.notices.explanation import Effect, Explanation, Subject

__all__ = ["ENGLISH", "PLACEHOLDER", "Words", "add_words", "explanations", "words"]

SHARED = "shared"
"""Key of the messages of several codes."""

PLACEHOLDER = re.compile(r"\{(\w+)(?::([^{}]+))?\}")
"""Name of a value, and how it is shown if not by its name."""

REMEDY = "{remedy}"


@dataclass(frozen=True)
class Words:
    """Explanations by code, and messages by code and variant."""

    explanations: Mapping[str, Explanation]
    messages: Mapping[tuple[str, str], str]
    language: str = ENGLISH

    def message(self, code: str, variant: str) -> str:
        """The sentence of a variant, with its placeholders."""
        said = self.messages.get((code, variant)) or self.messages.get((SHARED, variant))
        if said is None:
            raise KeyError(f"{code} has no message {variant!r}")
        if REMEDY in said:
            remedy = self.explanations[code].remedy
            first = remedy[0] if self.language == "de" else remedy[0].lower()  # it may be a noun
            said = said.replace(REMEDY, first + remedy[1:])
        return said

    def placeholders(self, code: str, variant: str) -> frozenset[str]:
        """Names of the values that a sentence shows."""
        return _names_in(self.message(code, variant))


@cache
def _names_in(said: str) -> frozenset[str]:
    """Names of the placeholders of a sentence."""
    return frozenset(name for name, _ in PLACEHOLDER.findall(said))


@cache
def words(language: str = ENGLISH) -> Words:
    """All texts; English where the language has none."""
    entries: dict[str, dict[str, str]] = {}
    messages: dict[tuple[str, str], str] = {}
    for language_code in dict.fromkeys((ENGLISH, language)):
        for folder in folders():
            own_entries, own_messages = _read(folder, language_code)
            for code, entry in own_entries.items():
                entries.setdefault(code, {}).update(entry)
            messages |= own_messages
    return Words({code: _explanation(**entry) for code, entry in entries.items()}, messages, language)


def explanations(chosen: str = "") -> Mapping[str, Explanation]:
    """What every code means, by code: in the language that is written now, or in the one chosen."""
    return words(chosen or language()).explanations


def add_words(package: str) -> None:
    """Add the texts of another package, which stand beside its modules.

    Raises
    ------
    ValueError
        Where a code or message of it has another text already; nothing is added.
    """
    if has_folder(package):
        return
    entries, messages = _read(files(package), ENGLISH)
    own = Words({code: _explanation(**entry) for code, entry in entries.items()}, messages)
    known = words()
    taken = [code for code in own.explanations if code in known.explanations]
    taken += [" ".join(key) for key in own.messages if key in known.messages]
    if taken:
        raise ValueError(f"{package} gives another meaning to {', '.join(taken)}")
    add_folder(package)
    words.cache_clear()


def _read(folder: Traversable, language: str) -> tuple[dict[str, dict[str, str]], dict[tuple[str, str], str]]:
    """Explanations by code and messages by code and variant, as the file of one folder has them."""
    entries, messages = {}, {}
    for code, table in read_words(folder, language).items():
        if code in (PHRASES, COMPOSED, PLURALS):
            continue
        said = table if code == SHARED else table.pop("message", {})
        for variant, text in ({"": said} if isinstance(said, str) else said).items():
            messages[code, variant] = _one_line(text)
        if code != SHARED and table:
            entries[code] = {key: _paragraphs(text) for key, text in table.items()}
    return entries, messages


def _one_line(text: str) -> str:
    return " ".join(text.split())


def _paragraphs(text: str) -> str:
    return "\n\n".join(map(_one_line, text.split("\n\n")))


def _explanation(
    title: str, meaning: str, remedy: str, effect: str = Effect.QUESTIONS_RESULT.name, subject: str = ""
) -> Explanation:
    return Explanation(
        title, meaning, remedy, Effect[effect.upper()], Subject[subject.upper()] if subject else None
    )
