"""The words of the page: English by their keys, other languages from the catalogues of the reports."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from nicegui.slot import Slot

from babbitt.core.language import ENGLISH, language, phrases, translated, translated_if_known, written_in

__all__ = ["LANGUAGE", "field_name", "page_language", "path_name", "sections", "told", "word"]

LANGUAGE = "language"
"""Under which a page keeps its language, and its address asks for one."""


@cache
def _catalogue() -> Mapping[str, Any]:
    return tomllib.loads(files("babbitt.app").joinpath("page.toml").read_text(encoding="utf-8"))


def page_language() -> str:
    """The language of the page that is drawn or was acted on; without a page the one that is written now."""
    stack = Slot.get_stack()
    return str(stack[-1].parent.client.storage.get(LANGUAGE, language())) if stack else language()


def word(key: str, **values: Any) -> str:
    """A word or sentence of the catalogue in the language of the page, its placeholders filled."""
    with written_in(page_language()):
        return translated(_catalogue()[key], **values)


def sections() -> Mapping[str, tuple[str, ...]]:
    """Headings of the form, each with its fields."""
    found: Mapping[str, list[str]] = _catalogue()["sections"]
    with written_in(page_language()):
        return {translated(heading): tuple(names) for heading, names in found.items()}


def told(text: str) -> str:
    """What another module says, in the language of the page where that knows it."""
    with written_in(page_language()):
        return translated_if_known(text)


def field_name(name: str) -> str:
    """What stands at a field of a case; in English where the language has no name for it.

    A catalogue has it as ``field load_angle``, or as the quantity that is called alike.

    >>> field_name("load_angle")
    'Load angle'
    """
    known = phrases(page_language()).get(f"field {name}")
    return known or told(name.replace("_", " ").capitalize())


def path_name(path: Iterable[str | int], given: Any = None) -> str:
    """A field with those that it stands in; parts of a list by their names in the case, else counted from 1.

    >>> path_name(["supply", "temperature"])
    'supply temperature'
    >>> path_name(["bearings", 1, "load"]), path_name(["bearings", 0, "load"], {"bearings": [{"name": "Pinion"}]})
    ('bearings 2 load', 'bearings Pinion load')
    """
    in_english, within, steps = page_language() == ENGLISH, given, []
    for step in path:
        within = _within(within, step)
        if isinstance(step, int):
            name = within.get("name") if isinstance(within, Mapping) else None
            steps.append(str(name or step + 1))
        else:
            steps.append(step.replace("_", " ") if in_english else field_name(step))
    return (" " if in_english else ", ").join(steps)


def _within(given: Any, step: str | int) -> Any:
    try:
        return given[step]
    except (LookupError, TypeError):
        return None
