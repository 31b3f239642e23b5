"""How a case gave its pads, in an engineer's words, for the report."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.units import written as written_plainly
from babbitt.kinds.tilting_pad_journal.case.pads import given_three

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase

__all__ = ["words_of"]


def written(value: float, unit: str) -> str:
    """An SI value in an everyday unit, as it looks on paper."""
    return written_plainly(value, unit).replace(" um", " µm").replace(" deg", "°")


def words_of(case: TiltingPadJournalCase, speed: float, which: str) -> Iterator[tuple[str, str]]:
    """Say how the numbers of a bearing were given."""
    pads = case.pads
    if pads.pivot_angles is None:
        yield "Pads", f"{pads.count} at equal distances, the first pivot at {written(pads.angles[0], 'deg')}"
    else:
        yield "Pads", f"{pads.count}, pivots at {', '.join(written(angle, 'deg') for angle in pads.angles)}"
    given = given_three(pads.fields_of(0))
    yield "Clearances", f"by {' and '.join(name.replace('_', ' ') for name in given)}, {which} values"
    differing = [str(number) for number, one in enumerate(pads.each, 1) if one.model_fields_set]
    if differing:
        yield "Pads with fields of their own", ", ".join(differing)
    yield "Speed", written(speed, "rpm")
    yield "Feed", case.feed.replace("_", " ")
