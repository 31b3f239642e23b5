"""How values get into the fields of a case, and quantities that vary by one share in all places: ``*.load``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt.case.case_file import CaseFile
from babbitt.case.field_types import field_annotations, quantity_in
from babbitt.case.loading import build_case
from babbitt.case.named_files import NamedFiles
from babbitt.case.variation import CaseVariation
from babbitt.case.with_units import short_quantity
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach
from babbitt.core.units import KINDS, QuantityError, SiField, SiNumber, read

if TYPE_CHECKING:
    from babbitt.study.inputs import Input

__all__ = ["EVERYWHERE", "SHARED", "given_with", "places_of", "require_buildable", "share_of"]

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
    given, found = origin.given if origin is not None else {}, {}
    for path, value in _given(given, name, ()):
        fields = map(quantity_in, field_annotations(model, path, given))
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


def given_with(one: Input, given: dict[str, Any], file: Path, reach: Reach, value: Any) -> dict[str, Any]:
    """What stands in a case, with a value of an input in all its fields.

    Raises
    ------
    InputError
        E005 where a path leads through something that is no mapping or list.
    """
    for field, each in one.places(value):
        given = CaseVariation(file, given, field, reach=reach).given_with(each)
    return given


def require_buildable(variation: CaseVariation, one: Input, value: Any) -> None:
    """Build the case with a value of an input; what it is refused for is raised."""
    given = given_with(one, variation.given, variation.file, variation.reach, value)
    shown = short_quantity(value, KINDS[one.unit]) if one.unit else value
    title = f"{printable(variation.file)} with {one.path}: {shown}"
    build_case(given, title, NamedFiles(variation.file.parent, variation.reach))
