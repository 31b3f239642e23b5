"""What must fit in bearings with recesses, reported by the names and units of the file."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Protocol

from babbitt.case.part import Issue, Part
from babbitt.case.parts.clearance import ClearanceInput, mean_radial
from babbitt.core.notices import InputError
from babbitt.core.units import written
from babbitt.kinds.hydrostatic.geometry import pitches_around

__all__ = ["clearance_is_usable", "in_order", "lands_between"]

ROUND_OFF = 1e-9
LEAST_CLEARANCE, GREATEST_CLEARANCE = 1e-6, 2e-3
"""m, radial: as of the gaps of all hydrostatic bearings."""
CLEARANCE = ("clearance",)


class Row(Protocol):
    """Recesses around an axis, rad."""

    @property
    def middles(self) -> tuple[float, ...]:
        """Middles of the recesses."""

    @property
    def extent(self) -> float:
        """Angle that each takes."""

    @property
    def drain_groove(self) -> float:
        """Angle of the drain grooves between them."""


def in_order(part: Part, *names: str, unit: str = "mm") -> Iterator[Issue]:
    """Complain of the first of some lengths that is not greater than the one before it."""
    for smaller, larger in pairwise(names):
        own, limit = getattr(part, smaller), getattr(part, larger)
        if not own < limit:
            says = f"{smaller} is {written(own, unit)}, {larger} {written(limit, unit)}"
            hint = f"the order is {', '.join(names)}" if len(names) > 2 else ""
            yield Issue((smaller,), says, f"{smaller} less than {larger}", hint)
            return


def clearance_is_usable(given: ClearanceInput, diameter: float) -> Iterator[Issue]:
    """Complain of a clearance that the bore cannot have."""
    try:
        clearance = mean_radial(given, diameter)
    except InputError as error:
        yield Issue(("clearance",), error.message, code=error.code)
        return
    if not 2.0 * clearance < diameter:
        says = f"the radial clearance is {written(clearance, 'mm')} in a bore of {written(diameter, 'mm')}"
        yield Issue(CLEARANCE, says, "about a thousandth of the bore")
    elif not LEAST_CLEARANCE <= clearance <= GREATEST_CLEARANCE:
        says = f"the radial clearance is {written(clearance, 'um')}"
        allowed = f"{written(LEAST_CLEARANCE, 'um')} to {written(GREATEST_CLEARANCE, 'mm')}"
        yield Issue(CLEARANCE, says, allowed, code="E003")


def lands_between(field: str, row: Row) -> Iterator[Issue]:
    """Complain of recesses that overlap each other or a drain groove."""
    pitch = min(pitches_around(tuple(row.middles)))
    if row.extent < pitch - row.drain_groove - ROUND_OFF:
        return
    drains = f" and drain grooves {written(row.drain_groove, 'deg')}" if row.drain_groove else ""
    says = (
        f"recesses of {written(row.extent, 'deg')} leave no land between them: they stand "
        f"{written(pitch, 'deg')} apart{drains}"
    )
    most = written(max(pitch - row.drain_groove, 0.0), "deg")
    hint = "a smaller extent, fewer recesses, or other angles" if len(row.middles) > 1 else "a smaller extent"
    yield Issue((field, "extent"), says, f"less than {most}", hint)
