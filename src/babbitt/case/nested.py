"""Values in mappings within mappings, by the path of their keys."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

__all__ = ["values_at", "with_value", "without_value"]


def values_at(given: Any, path: Sequence[str | int]) -> Iterator[Any]:
    """The value at a path, if there is one."""
    for step in path:
        if not isinstance(given, Mapping) or step not in given:
            return
        given = given[step]
    yield given


def without_value(given: Mapping[str, Any], path: Sequence[str]) -> dict[str, Any]:
    """A mapping without the value at a path, and without the mappings that this leaves empty."""
    first, *rest = path
    left = {name: value for name, value in given.items() if name != first}
    if rest and isinstance(given.get(first), Mapping) and (below := without_value(given[first], rest)):
        return {name: below if name == first else value for name, value in given.items()}
    return left


def with_value(given: Mapping[str, Any], path: Sequence[str], value: Any) -> dict[str, Any]:
    """A mapping with a value at a path."""
    first, *rest = path
    return {**given, first: with_value(given.get(first) or {}, rest, value) if rest else value}
