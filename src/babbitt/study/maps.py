"""The axes of a map that names none: those of its kind, speed and load of most."""

from __future__ import annotations

from babbitt.case.case_file import CaseFile
from babbitt.case.field_types import field_annotations, quantity_in
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.variation import variation_of
from babbitt.core.kind import SPEED_AND_LOAD, find_kind
from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, SiField, read
from babbitt.study.shares import EVERYWHERE, SHARED, places_of

__all__ = ["FROM", "TO", "default_axes"]

FROM, TO = 0.2, 2.0
"""Of what the case itself has: the ends of an axis."""


def default_axes(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """A map with the two axes of its kind if none are named; any other study as it is.

    Raises
    ------
    InputError
        E003 where the case gives nothing from which an axis follows.
    """
    if block.kind != "map" or block.vary:
        return block
    kind = find_kind(case.kind)
    vary: dict[str, Vary] = {}
    for names in kind.envelope if kind is not None else SPEED_AND_LOAD:
        found = next((axis for name in names if (axis := _axis(case, name, block.points)) is not None), None)
        if found is None:
            says = f"{case.name} gives no {' or '.join(names)} from which an axis follows"
            raise InputError("E003", f"study.vary: {says}; name two fields with their values")
        vary |= found
    made: StudyBlock = block.model_copy(update={"vary": vary, "points": StudyBlock.model_fields["points"].default})
    return made


def _axis(case: CaseFile, name: str, points: int) -> dict[str, Vary] | None:
    """An axis about what the case has, in one place or as a share of it in all; None where it has nothing."""
    places = places_of(case, name) if name in SHARED else {}
    path = next(iter(places), name)
    if len(places) > 1 or isinstance(places.get(path), dict):
        return {f"{EVERYWHERE}{name}": Vary(range=(FROM, TO, points))}
    present = _present(case, path)
    if present is None:
        return None
    value, unit = present
    return {path: Vary.model_validate({"range": (f"{FROM * value!r} {unit}", f"{TO * value!r} {unit}", points)})}


def _present(case: CaseFile, path: str) -> tuple[float, str] | None:
    """What the case has in a field, in SI, and its unit; None for nothing, and for zero."""
    annotations = field_annotations(getattr(case, "model", type(case)), path.split("."))
    quantity = next((one for one in map(quantity_in, annotations) if isinstance(one, SiField)), None)
    if quantity is None:
        return None
    try:
        given = variation_of(case, path).present
        value = read(given, quantity.unit) if given is not None else 0.0
    except (InputError, QuantityError):
        return None
    return (value, quantity.kind.unit) if value else None
