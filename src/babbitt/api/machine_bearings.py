"""A bearing of a machine as a bearing by itself: what it was given, and what it shares with its machine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from babbitt.case.part import Part
from babbitt.case.parts.cooling import Cooling
from babbitt.case.parts.materials import Materials
from babbitt.case.parts.shared import replaced_by
from babbitt.case.parts.supply import Supply

__all__ = ["by_itself"]

PARTS: Mapping[str, type[Part]] = {"supply": Supply, "cooling": Cooling, "materials": Materials}
"""Shared parts of which a bearing may give single fields, the others coming from its machine."""


def by_itself(bearing: Mapping[str, Any], machine: Mapping[str, Any]) -> dict[str, Any]:
    """What a bearing would be given without its machine, in the words of a case file.

    Parameters
    ----------
    bearing, machine : Mapping
        What both were given, in the words of today.

    Examples
    --------
    >>> machine = {"lubricant": "ISO VG 46", "supply": {"temperature": "50 degC", "pressure": "2 bar"}}
    >>> by_itself({"kind": "journal", "supply": {"flow": "3 L/min"}}, machine)["supply"]
    {'temperature': '50 degC', 'flow': '3 L/min'}
    """
    made = {name: value for name, value in bearing.items() if value is not None}
    for name in ("lubricant", "clearance_cases"):
        if machine.get(name) is not None:
            made.setdefault(name, machine[name])
    for name, part in PARTS.items():
        if machine.get(name) is not None:
            made[name] = _joined(part, made.get(name), machine[name])
    if machine.get("assumptions"):
        made["assumptions"] = [*machine["assumptions"], *made.get("assumptions", ())]
    return made


def _joined(part: type[Part], own: Any, shared: Any) -> Any:
    """A part of which the bearing gives single fields."""
    if own is None or not (isinstance(own, Mapping) and isinstance(shared, Mapping)):
        return shared if own is None else own
    replaced = replaced_by(part, own.keys())
    return {**{name: value for name, value in shared.items() if name not in replaced}, **own}
