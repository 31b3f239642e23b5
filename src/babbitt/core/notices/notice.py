"""What a result says about itself: a code, a variant and values, which become a sentence where they are shown."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from babbitt.core.language import ENGLISH, decimal, language, listed, translated_if_known, written_in
from babbitt.core.notices.explanation import Effect
from babbitt.core.notices.words import PLACEHOLDER, SHARED, explanations, words
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.quantities.display import SI

__all__ = ["TITLED", "Notice", "quantity_shown", "retold"]


RANGE = ("least", "most")
"""Names of the ends of the range to which a value is held."""

COMPARED = re.compile(rf"({PLACEHOLDER.pattern}) [<>] ({PLACEHOLDER.pattern})")
"""Two values of which one lies beyond the other."""

TITLED = "titled"
"""As which a code is shown with its title."""

FIELDS = "fields"
"""Placeholder of names of fields, which may be words of the language as well and stay as they are."""

PLAIN = Quantity("", "", "", SI[""], 4, "")
"""As which numbers without a measure are shown."""


@dataclass(frozen=True)
class Notice:
    """A warning about a result, or the reason why a check was not made.

    Attributes
    ----------
    code : str
        A code of `explanations`.
    variant : str
        Which of the messages of the code, where it has several.
    values : Mapping[str, Any]
        The values of the case by the placeholders of that message: numbers in SI, counts, names, clauses (notices
        with values of their own), or a tuple of one of these.
    """

    code: str
    variant: str = ""
    values: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.code not in explanations():
            raise KeyError(
                f"no words.en.toml has the code {self.code}; those of another package are known once its kind is "
                "registered, which babbitt.core.kind.kinds() does for all that are installed"
            )
        wanted = words().placeholders(self.code, self.variant)
        if wanted != self.values.keys():
            raise KeyError(f"values of notice {self.code} {self.variant}: {sorted(wanted ^ self.values.keys())}")

    def __hash__(self) -> int:
        return hash((self.code, self.variant, tuple(self.values.items())))

    def __str__(self) -> str:
        return f"{self.code} {self.message}"

    @property
    def effect(self) -> Effect:
        """What it does to the verdict of the result that carries it."""
        return explanations()[self.code].effect

    @property
    def message(self) -> str:
        """The sentence with its values in the language that is written now; in English where that has none.

        >>> Notice("W169", values={"starts": 5, "least": 20}).message
        '5 starts < 20'
        >>> Notice("W193", values={"relative_clearance": 10.002e-3, "least": 1e-4, "most": 1e-2}).message
        'ψ = 10.002 ‰ lies outside 0.100 ‰ to 10.000 ‰'
        """
        said = words(language()).message(self.code, self.variant)
        apart = dict(self._told_apart(said))
        return PLACEHOLDER.sub(
            lambda found: apart.get(found[0]) or _shown(self.values[found[1]], found[2] or found[1]), said
        )

    def _told_apart(self, said: str) -> Iterator[tuple[str, str]]:
        """Placeholders of values that are compared and read alike, with the digits that show the difference."""
        for place, other_place in _compared(said):
            value, other = self.values[place[1]], self.values[other_place[1]]
            first, second = place[2] or place[1], other_place[2] or other_place[1]
            if not all(isinstance(one, int | float) for one in (value, other)):
                continue
            if _shown(value, first) == _shown(other, first):
                texts = (quantity_shown(first) or PLAIN).told_apart(value, other)
                alike = second == first or quantity_shown(second) is not None
                yield from zip((place[0], other_place[0])[: 1 + alike], texts, strict=False)

    def sentence(self, chosen: str = ENGLISH) -> str:
        """The same in a language of its own."""
        with written_in(chosen):
            return self.message

    def plain_values(self) -> dict[str, Any]:
        """The values for JSON: clauses as their values, several as a list, null for what is not finite."""
        return {name: _plain(value) for name, value in self.values.items()}


def _compared(said: str) -> Iterator[tuple[re.Match[str], re.Match[str]]]:
    """Placeholders on both sides of < or >; the first one of a message and the ends of its range."""
    places = {place[0]: place for place in PLACEHOLDER.finditer(said)}
    for found in COMPARED.finditer(said):
        yield places[found[1]], places[found[4]]
    value = next((place for place in places.values() if place[1] not in RANGE), None)
    if value is not None:
        yield from ((value, place) for place in places.values() if place[1] in RANGE)


def retold(code: str, sentence: str) -> str | None:
    """A sentence of a code that was kept in English, in the language that is written now.

    Returns
    -------
    str or None
        None where the code has no message of this form.

    >>> with written_in("de"):
    ...     retold("W109", "surface speed 45.00 m/s > 20 m/s"), retold("W109", "another sentence")
    ('Gleitgeschwindigkeit 45,00 m/s > 20 m/s', None)
    """
    matches = ((variant, form.fullmatch(sentence)) for variant, form in _forms(code))
    variant, found = next((one for one in matches if one[1] is not None), ("", None))
    if found is None:
        return None
    parts = {name: retold(code, part) or translated_if_known(part) for name, part in found.groupdict().items()}
    return decimal(PLACEHOLDER.sub(lambda place: parts[place[1]], words(language()).message(code, variant)))


@cache
def _forms(code: str) -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Variants of the English message of a code as expressions, those with most words first."""
    english, found = words(), []
    for _, variant in (key for key in english.messages if key[0] in (code, SHARED)):
        said = english.message(code, variant)
        texts, names = re.split(PLACEHOLDER.pattern, said)[::3], [place[1] for place in PLACEHOLDER.finditer(said)]
        groups = [f"(?P<{name}>.+?)" if name not in names[:n] else ".+?" for n, name in enumerate(names)]
        made = "".join(itertools.chain(*itertools.zip_longest(map(re.escape, texts), groups, fillvalue="")))
        if re.search("[a-z]{2}", "".join(texts)):  # values alone are of no form
            found.append((len("".join(texts)), variant, re.compile(made)))
    return tuple((variant, form) for _, variant, form in sorted(found, key=lambda one: -one[0]))


def quantity_shown(measure: str) -> Quantity | None:
    """The quantity, known by its name or by a unit, as which a placeholder shows a number."""
    if measure in SI:
        return Quantity(measure, "", "", SI[measure], 4, "")
    return QUANTITIES.get(measure)


def _shown(value: Any, measure: str) -> str:
    if isinstance(value, Notice):
        return value.message
    if isinstance(value, tuple):
        said = [_shown(one, measure) for one in value]
        if any(isinstance(one, float) for one in value):
            return listed(said)
        return ("; " if any(isinstance(one, Notice) for one in value) else ", ").join(said)
    if isinstance(value, str):
        if measure == TITLED and value in explanations():
            return f"{value} ({explanations()[value].title})"
        return value if measure == FIELDS else translated_if_known(value)
    quantity = quantity_shown(measure)
    if quantity is None:
        return str(value) if isinstance(value, int) else decimal(f"{value:.4g}")
    return quantity.suited(value).with_unit(value)


def _plain(value: Any) -> Any:
    if isinstance(value, Notice):
        return value.plain_values()
    if isinstance(value, tuple):
        return [_plain(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
