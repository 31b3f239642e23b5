"""What Python says in other words than the case language: bearings of a machine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from babbitt.api.case import Case
from babbitt.api.own_bore import with_own_bore_in_words

__all__ = ["of_machine"]


def of_machine(bearing: Any, number: int) -> Any:
    """What a bearing of a machine was given, with its kind and a name; anything else unchanged."""
    if isinstance(bearing, Case):
        words = {name: value for name, value in bearing.given.items() if name != "babbitt"}
        named = words.get("name") != bearing.default_name
        return {**words, "name": words["name"] if named else f"Bearing {number}"}
    if isinstance(bearing, Mapping):
        return {
            "kind": "journal",
            "name": f"Bearing {number}",
            **with_own_bore_in_words(bearing),
        }
    return bearing
