"""A change made to every bearing of a case: to the case itself, and to each entry of its list of bearings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from babbitt.case.error_messages import Path

__all__ = ["Change", "for_every_bearing"]

Change = Callable[[dict[str, Any], Path], dict[str, Any]]
"""A bearing as it stands in the file and its place in the case -> the bearing changed; what is given stays."""


def for_every_bearing(given: dict[str, Any], change: Change) -> dict[str, Any]:
    """Make a change to the case, whose fields its bearings may share, and to each of its bearings.

    Parameters
    ----------
    given : dict
        A case as it stands in the file; it is not changed.
    change : callable

    Returns
    -------
    dict
        A new case. What stands in the list of bearings and is no mapping is left for the validation to refuse.
    """
    made = change(given, ())
    bearings = made.get("bearings")
    if not isinstance(bearings, list):
        return made
    return made | {
        "bearings": [
            change(one, ("bearings", index)) if isinstance(one, dict) else one
            for index, one in enumerate(bearings)
        ]
    }
