"""The axes of a map that names none: speed and load, without a speed supply pressure and load."""

from __future__ import annotations

from babbitt.case.case_file import CaseFile
from babbitt.case.field_types import field_annotations
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.variation import variation_of
from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, SiField, read

__all__ = ["default_axes"]

AXES = (("speed", "surface_speed", "supply.pressure"), ("load", "specific_load"))
"""Of each axis the first that the case gives."""

FROM, TO, POINTS = 0.2, 2.0, 19
"""Of what the case itself has: the ends of an axis, and its values."""


def default_axes(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """A map with the two axes that it has if none are named; any other study as it is.

    Raises
    ------
    InputError
        E003 where the case gives no speed, load or supply pressure to begin with.
    """
    if block.kind != "map" or block.vary:
        return block
    vary = {}
    for names in AXES:
        found = next((one for one in names if _present(case, one) is not None), None)
        if found is None:
            says = f"{case.name} gives no {' or '.join(names)} from which an axis follows"
            raise InputError("E003", f"study.vary: {says}; name two fields with their values")
        value, unit = _present(case, found) or (0.0, "")
        vary[found] = Vary.model_validate(
            {"range": (f"{FROM * value!r} {unit}", f"{TO * value!r} {unit}", POINTS)}
        )
    return block.model_copy(update={"vary": vary})


def _present(case: CaseFile, path: str) -> tuple[float, str] | None:
    """What the case has in a field, in SI, and its unit."""
    from babbitt.case.field_types import quantity_in

    annotations = field_annotations(getattr(case, "model", type(case)), path.split("."))
    quantity = next((one for one in map(quantity_in, annotations) if isinstance(one, SiField)), None)
    if quantity is None:
        return None
    try:
        given = variation_of(case, path).present
        return (read(given, quantity.unit), quantity.kind.unit) if given is not None else None
    except (InputError, QuantityError):
        return None
