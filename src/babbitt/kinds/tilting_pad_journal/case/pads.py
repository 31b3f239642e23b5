"""Pads around a journal: what they share, and what single ones have of their own."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Annotated, Any, ClassVar

from pydantic import Field

from babbitt.case.error_messages import MISSING
from babbitt.case.part import Issue, Part, exactly_one, is_given, rule
from babbitt.case.parts.clearance import ClearanceInput
from babbitt.case.parts.fields import WholeNumber
from babbitt.core.units import si, written
from babbitt.kinds.tilting_pad_journal.case.materials import PadStructureInput
from babbitt.kinds.tilting_pad_journal.case.pivots import PivotInput, RigidPivotInput

__all__ = ["THREE", "JournalPads", "OnePad", "clearances", "given_three", "own_path", "pad_fields"]

Angle = Annotated[float, si("rad", "-360 deg", "360 deg")]
Extent = Annotated[float, si("rad", "1 deg", "179 deg")]
Width = Annotated[float, si("m", "0.1 mm", "4.5 m")]
Thickness = Annotated[float, si("m", "0.1 mm", "2 m")]
Preload = Annotated[float, si("1", "-0.5", "0.99")]
Mass = Annotated[float, si("kg", "0 kg", "1000 t")]
Inertia = Annotated[float, si("kg m2", "0 kg m2", "1e6 kg m2")]
Offset = Annotated[float, si("m", "-1 m", "1 m")]
Fraction = Annotated[float, si("1", "0", "1")]

THREE = ("clearance", "preload", "assembled_clearance")
"""Of these two are given, and the third follows: 1 - preload is assembled over machined clearance."""

TURN = 2.0 * math.pi


class OnePad(Part):
    """What one pad has of its own."""

    example: ClassVar[str] = "{preload: 0.45}"

    extent: Extent | None = Field(None, description="Angle of this pad.")
    width: Width | None = Field(None, description="Width of this pad.")
    thickness: Thickness | None = Field(None, description="Thickness of this pad, from the bore to the pivot.")
    clearance: ClearanceInput | None = Field(None, description="Machined clearance of this pad.")
    preload: Preload | None = Field(None, description="Preload of this pad.")
    assembled_clearance: ClearanceInput | None = Field(None, description="Assembled clearance of this pad.")
    pivot: PivotInput | None = Field(None, description="What this pad stands on.")
    mass: Mass | None = Field(None, description="Mass of this pad.")
    inertia: Inertia | None = Field(None, description="Moment of inertia of this pad about its pivot.")
    mass_offset: Offset | None = Field(
        None, description="Centre of gravity of this pad ahead of the pivot, in the sense of rotation."
    )
    mass_inset: Offset | None = Field(
        None, description="How much nearer to the bearing centre its centre of gravity is than its pivot."
    )
    material: PadStructureInput | None = Field(
        None, description="Material of this pad, in place of materials.pads: what it gives."
    )
    probe_fraction: Fraction | None = Field(
        None, description="Where a probe of the temperature stands in this pad, a share of its arc."
    )


class JournalPads(Part):
    """Pads around a journal."""

    two_of: ClassVar[tuple[str, ...]] = THREE

    number: Annotated[int, WholeNumber(2, 24)] | None = Field(
        None, description="Number of pads at equal distances, with first_pivot. In place of pivot_angles."
    )
    pivot_angles: tuple[Angle, ...] | None = Field(
        None,
        max_length=24,
        description="Angle of every pivot, counter-clockwise from the x axis, rising. In place of number.",
    )
    first_pivot: Angle | None = Field(
        None, description="Angle of the first pivot; the others follow counter-clockwise. With number."
    )
    extent: Extent = Field(description="Angle of a pad, from edge to edge.")
    width: Width = Field(description="Width of the pads.")
    thickness: Thickness = Field(description="Thickness of a pad, from its bore to the contact of the pivot.")
    clearance: ClearanceInput | None = Field(
        None,
        description="Machined clearance of a pad: radius of its bore less that of the journal. Two of clearance, "
        "preload and assembled_clearance are given.",
    )
    preload: Preload | None = Field(
        None,
        description="Preload: 1 less assembled over machined clearance. Usual 0 to 0.5. Where it alone is varied, "
        "the clearance that is given besides is held, and the other follows.",
    )
    assembled_clearance: ClearanceInput | None = Field(
        None, description="Assembled clearance: gap at the pivots when the journal is centred."
    )
    pivot: PivotInput = Field(
        RigidPivotInput(kind="rigid"),
        description="What a pad stands on. A rigid pivot in its middle if not given.",
    )
    mass: Mass = Field(0.0, description="Mass of a pad, which counts where its pivot gives way.")
    inertia: Inertia = Field(0.0, description="Moment of inertia of a pad about its pivot.")
    mass_offset: Offset = Field(
        0.0, description="Centre of gravity of a pad ahead of the pivot, in the sense of rotation."
    )
    mass_inset: Offset = Field(
        0.0,
        description="How much nearer to the bearing centre the centre of gravity of a pad is than its pivot. It "
        "counts where a flexure gives way along the motion.",
    )
    probe_fraction: Fraction = Field(
        0.75,
        description="Where a probe of the temperature stands in the bore of a pad: share of its arc from the "
        "leading edge.",
    )
    each: tuple[OnePad, ...] = Field(
        (),
        max_length=24,
        description="What single pads have of their own, one entry for each pad, {} for a usual one. Empty: none.",
    )

    @property
    def count(self) -> int:
        """Number of pads."""
        return self.number if self.pivot_angles is None else len(self.pivot_angles)  # type: ignore[return-value]

    @property
    def angles(self) -> tuple[float, ...]:
        """Angle of every pivot, rad."""
        if self.pivot_angles is not None:
            return self.pivot_angles
        count, first = self.number or 0, self.first_pivot or 0.0
        return tuple(first + TURN * place / count for place in range(count))

    @rule
    def _placed_in_one_way(self) -> Iterator[Issue]:
        yield from exactly_one(self, "number", "pivot_angles")
        if is_given(self, "pivot_angles") and is_given(self, "number"):
            return
        if is_given(self, "number") and not is_given(self, "first_pivot"):
            hint = "needed: angle of one pivot, for load on a pad differs from load between pads"
            yield Issue(("first_pivot",), MISSING, hint=hint, code="E003")
        if is_given(self, "pivot_angles") and is_given(self, "first_pivot"):
            yield Issue(("first_pivot",), "given besides pivot_angles", "with number alone", "remove one")

    @rule
    def _pivots_in_order(self) -> Iterator[Issue]:
        angles = self.pivot_angles
        if angles is None:
            return
        if len(angles) < 2:
            says = f"{len(angles)} pivot angle is given; a bearing of tilting pads has two pads or more"
            yield Issue(("pivot_angles",), says, "2 to 24 angles")
            return
        for place, (before, here) in enumerate(pairwise(angles), 2):
            if not here > before:
                same = "is that of the pad before" if here == before else "lies before that of the pad before"
                says = f"pad {place}: its pivot angle {written(here, 'deg')} {same}, {written(before, 'deg')}"
                yield Issue(("pivot_angles", place - 1), says, "angles that rise from pad to pad")
                return
        if not angles[-1] - angles[0] < TURN:
            says = f"from pad 1 to pad {len(angles)} the angles go around more than once"
            yield Issue(("pivot_angles",), says, "less than 360 deg from the first to the last")

    @rule
    def _one_entry_each(self) -> Iterator[Issue]:
        if self.each and len(self.each) != self.count:
            says = f"{len(self.each)} entries are given for {self.count} pads"
            yield Issue(("each",), says, f"{self.count} entries, {{}} for a pad like the others, or none")

    @rule
    def _two_of_three(self) -> Iterator[Issue]:
        own = own_three(self)
        if len(own) < 2:
            missing = "only " + own[0] if own else "none"
            says = f"{missing} of {', '.join(THREE)} is given"
            allowed = "two of them; the third follows, 1 - preload = assembled over machined clearance"
            yield Issue((), says, allowed, code="E003", lacks=(next(n for n in THREE if n not in own),))
        for index, one in enumerate(self.each):
            alone = own_three(one)
            if len(alone) == 1 and (len(own) == 3 or (len(own) == 2 and alone[0] not in own)):
                says = f"pad {index + 1}: {alone[0]} alone does not tell which of {', '.join(own)} it replaces"
                yield Issue(("each", index, alone[0]), says, f"two of {', '.join(THREE)} for this pad")

    def fields_of(self, number: int) -> dict[str, Any]:
        """Give the fields of a pad, its number from 0: its own where it has them."""
        return pad_fields(self, self.each[number] if number < len(self.each) else None)


def own_path(number: int) -> str:
    """What a pad has of its own, for people: its number from 0 is shown from 1, as in results."""
    return f"pads.each (pad {number + 1})"


def own_three(part: Part) -> list[str]:
    """Which of `THREE` a piece gives."""
    return [name for name in THREE if is_given(part, name)]


def field_of(pads: JournalPads, one: OnePad | None, name: str) -> Any:
    """Give a field of a pad: its own, else that of all pads."""
    return getattr(one, name) if one is not None and is_given(one, name) else getattr(pads, name, None)


def pad_fields(pads: JournalPads, one: OnePad | None) -> dict[str, Any]:
    """Give all fields of a pad. Of `THREE` it takes its own two, or its own one with another of all pads."""
    fields = {name: field_of(pads, one, name) for name in OnePad.model_fields}
    own = [] if one is None else own_three(one)
    if len(own) >= 2:
        fields |= {name: None for name in THREE if name not in own}
    return fields


def given_three(fields: Mapping[str, Any]) -> tuple[str, ...]:
    """Which of `THREE` the fields of a pad give, as `pad_fields` has them."""
    return tuple(name for name in THREE if fields[name] is not None)


def clearances(fields: Mapping[str, Any], diameter: float, which: str = "mean") -> tuple[float, float]:
    """Machined and assembled clearance of a pad, m, from two of three that are given.

    Parameters
    ----------
    fields : Mapping
        Of a pad, as `pad_fields` gives them.
    diameter : float
        m.
    which : {"mean", "minimum", "maximum"}
        Limit of every clearance that has limits; a preload stays what it is.
    """
    machined, assembled, preload = (fields[name] for name in ("clearance", "assembled_clearance", "preload"))
    pad = None if machined is None else radial(machined, diameter, which)
    gap = None if assembled is None else radial(assembled, diameter, which)
    if pad is None:
        assert gap is not None
        return gap / (1.0 - preload), gap
    return pad, pad * (1.0 - preload) if gap is None else gap


def radial(clearance: ClearanceInput, diameter: float, which: str) -> float:
    """A clearance on the radius, m."""
    return float(0.5 * getattr(clearance.at_20_degrees(diameter), which))
