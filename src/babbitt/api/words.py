"""What Python says in other words than the case language: methods as objects, bearings of a machine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from babbitt.api.case import Case
from babbitt.api.methods import METHODS, MethodOptions
from babbitt.api.own_bore import with_own_bore_in_words
from babbitt.case.problems import CaseError, Problem

__all__ = ["of_machine", "with_method", "with_method_in_words"]


def with_method(given: Mapping[str, Any], method: MethodOptions) -> dict[str, Any]:
    """What a bearing was given, with another method: options of the one before go, those of the new one come."""
    former = METHODS.get(str(given.get("method", "iso7902")))
    options = set(former.model_fields) if former is not None else set()
    kept = {name: value for name, value in given.items() if name not in options | set(type(method).model_fields)}
    return {**kept, "method": method.method, **method.given}


def with_method_in_words(given: Mapping[str, Any]) -> dict[str, Any]:
    """What a bearing was given, its method as the case language has it: a name, and fields of the bearing.

    Raises
    ------
    CaseError
        For an option that is given twice.
    """
    method = given.get("method")
    if not isinstance(method, MethodOptions):
        return dict(given)
    options = method.given
    if twice := sorted(options.keys() & given.keys()):
        says = f"given beside the {type(method).__name__} that gives it, too"
        raise CaseError([Problem("JournalBearing", 0, twice[0], says, allowed="once")])
    return {**given, **options, "method": method.method}


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
            **with_own_bore_in_words(with_method_in_words(bearing)),
        }
    return bearing
