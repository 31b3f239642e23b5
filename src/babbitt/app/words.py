"""The words of the page, from one catalogue."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any

__all__ = ["sections", "word"]


@cache
def _catalogue() -> Mapping[str, Any]:
    return tomllib.loads(files("babbitt.app").joinpath("words.en.toml").read_text(encoding="utf-8"))


def word(key: str, **values: Any) -> str:
    """A word or sentence of the catalogue, its placeholders filled."""
    found: str = _catalogue()[key]
    return found.format(**values) if values else found


def sections() -> Mapping[str, tuple[str, ...]]:
    """Headings of the form, each with its fields."""
    found: Mapping[str, list[str]] = _catalogue()["sections"]
    return {heading: tuple(names) for heading, names in found.items()}
