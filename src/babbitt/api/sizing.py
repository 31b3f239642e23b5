"""The permitted values of a field of a case, asked in Python."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from babbitt.api.given import as_given
from babbitt.case.field_types import field_annotations, quantity_in
from babbitt.case.problems import CaseError, Problem
from babbitt.case.variation import variation_of
from babbitt.core.units import SiNumber, read
from babbitt.core.units.kinds import KINDS
from babbitt.study.size import DECADE, Scan, Size, find_size, scan_values

if TYPE_CHECKING:
    from babbitt.api.case import Case

__all__ = ["size_of"]


def size_of(
    case: Case,
    path: str,
    within: tuple[Any, Any] | None,
    points: int,
    limits: str | Sequence[str],
    over_tolerance: bool,
) -> Size:
    """All intervals of a field in which a complete case keeps its limits, in SI; see `Case.size`.

    Raises
    ------
    CaseError
        For a field that takes no quantity or has no decade to scan, and where the case refuses every value.
    InputError
        E003 for a range that does not ascend, E005 for a code that no check has.
    """
    where = type(case).__name__
    found = [quantity_in(one) for one in field_annotations(case.model, path.split("."))]
    unit = next((one.unit for one in found if one is not None), None)
    if unit is None:
        raise _refused(where, path, "takes no quantity", "a field with a unit, such as load or clearance.mean")
    variation = variation_of(case, path)
    present = None if variation.present is None else read(variation.present, unit)
    if within is None:
        if present is None or present <= 0.0 or (unit in KINDS and KINDS[unit].offsets):
            raise _refused(where, path, "has no decade to scan", "within=(first, last)")
        first, last = present / DECADE, present * DECADE
    else:
        first, last = (read(as_given(one, where, (path,)), unit) for one in within)
    scan = Scan(scan_values(first, last, points), unit, present, SiNumber)
    return find_size(variation, scan, (limits,) if isinstance(limits, str) else tuple(limits), over_tolerance)


def _refused(where: str, field: str, says: str, allowed: str) -> CaseError:
    return CaseError([Problem(where, 0, field, says, allowed=allowed)])
