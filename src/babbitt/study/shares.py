"""A quantity that stands in several places of a case, varied by one share in all of them: ``*.load``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.case.field_types import field_annotations, quantity_in
from babbitt.core.units import QuantityError, SiField, SiNumber, read

__all__ = ["EVERYWHERE", "SHARED", "places_of", "share_of"]

EVERYWHERE = "*."
"""What the path of such a field begins with."""

SHARED: Mapping[str, tuple[str, ...]] = {
    "speed": ("speed", "surface_speed"),
    "load": ("load", "specific_load"),
    "power": ("power", "torque"),
}
"""By the name of the quantity the fields that give it."""

WITHIN = ("bearings", "operating_points", "gears", "couplings")
"""Lists whose members may give it."""


def places_of(case: CaseFile, name: str) -> dict[str, Any]:
    """Where a case gives a quantity of `SHARED`: by the path its value in SI, of a load also its components.

    What every operating point gives for itself counts there alone.
    """
    origin = case.origin
    model = getattr(case, "model", type(case))
    found = {}
    for path, value in _given(origin.given if origin is not None else {}, name, ()):
        fields = map(quantity_in, field_annotations(model, path))
        quantity = next((one for one in fields if isinstance(one, SiField)), None)
        if quantity is not None and (number := _in_si(value, quantity.unit)) is not None:
            found[".".join(path)] = number
    return found


def share_of(value: Any, share: float) -> Any:
    """A share of a value in SI, of a load also of its components."""
    if isinstance(value, Mapping):
        return {name: SiNumber(share * one) for name, one in value.items()}
    return SiNumber(share * value)


def _given(place: Any, name: str, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
    if not isinstance(place, Mapping):
        return
    points = place.get("operating_points")
    alone = isinstance(points, list) and all(_gives(one, name) for one in points)
    for field in SHARED[name]:
        if field in place and not alone:
            yield (*path, field), place[field]
    for group in WITHIN:
        members = place.get(group)
        for number, one in enumerate(members if isinstance(members, list) else ()):
            yield from _given(one, name, (*path, group, str(number)))


def _gives(place: Any, name: str) -> bool:
    return isinstance(place, Mapping) and any(field in place for field in SHARED[name])


def _in_si(value: Any, unit: str) -> Any:
    try:
        if isinstance(value, Mapping):
            return {name: read(one, unit) for name, one in value.items()}
        return read(value, unit)
    except QuantityError:
        return None
