"""The axes of a map that names none: those of its kind, speed and load of most."""

from __future__ import annotations

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.core.kind import SPEED_AND_LOAD, find_kind
from babbitt.core.notices import InputError
from babbitt.study.fields import numbers_of, present_quantity
from babbitt.study.shares import EVERYWHERE, SHARED, places_of

__all__ = ["FROM", "TO", "default_axes"]

FROM, TO = 0.2, 2.0
"""Of what the case itself has: the ends of an axis."""


def default_axes(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """A map with the two axes of its kind, for one that names none.

    Raises
    ------
    InputError
        E003 where the case gives nothing from which an axis follows.
    """
    if block.vary:
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
    value = present_quantity(case, path)
    if not value:
        return None
    unit = numbers_of(case, path)[1].unit
    return {path: Vary.model_validate({"range": (f"{FROM * value!r} {unit}", f"{TO * value!r} {unit}", points)})}
