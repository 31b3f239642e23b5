"""The axes of a map that names none: speed and load, without a speed supply pressure and load."""

from __future__ import annotations

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.core.notices import InputError
from babbitt.study.inputs import numbers_of, present_quantity

__all__ = ["default_axes"]

AXES = (("speed", "surface_speed", "supply.pressure"), ("load", "specific_load"))
"""Of each axis the first that the case gives."""

FROM, TO, POINTS = 0.2, 2.0, 19
"""Of what the case itself has: the ends of an axis, and its values."""


def default_axes(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """A map with the two axes that it has if none are named.

    Raises
    ------
    InputError
        E003 where the case gives no speed, load or supply pressure to begin with.
    """
    if block.vary:
        return block
    vary = {}
    for names in AXES:
        found = next((one for one in names if present_quantity(case, one) is not None), None)
        if found is None:
            says = f"{case.name} gives no {' or '.join(names)} from which an axis follows"
            raise InputError("E003", f"study.vary: {says}; name two fields with their values")
        value, unit = present_quantity(case, found), numbers_of(case, found)[1].unit
        vary[found] = Vary.model_validate(
            {"range": (f"{FROM * (value or 0.0)!r} {unit}", f"{TO * (value or 0.0)!r} {unit}", POINTS)}
        )
    return block.model_copy(update={"vary": vary})
