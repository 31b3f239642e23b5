"""Shapes of hydrostatic pads with one recess, as an engineer writes them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, rule
from babbitt.kinds.hydrostatic.case.recess_parts import Length
from babbitt.kinds.hydrostatic.case.recess_rules import in_order
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, PadShape, RectangularPad

DIAMETERS = ("inner_diameter", "recess_inner_diameter", "recess_outer_diameter", "outer_diameter")
"""Edges of a ring and of its recess, from inside to outside."""


class CircularInput(Part):
    """A round pad with a round recess in the middle."""

    example: ClassVar[str] = "{kind: circular, diameter: 100 mm, recess_diameter: 50 mm}"

    kind: Literal["circular"] = Field(description="Round pad.")
    diameter: Length = Field(description="Outer diameter.")
    recess_diameter: Length = Field(description="Diameter of the recess.")

    @rule
    def _recess_inside(self) -> Iterator[Issue]:
        yield from in_order(self, "recess_diameter", "diameter")

    def pad(self) -> PadShape:
        """Give the pad of the calculation."""
        return CircularPad(0.5 * self.diameter, 0.5 * self.recess_diameter)


class AnnularInput(Part):
    """A ring with an annular recess."""

    kind: Literal["annular"] = Field(description="Ring with one annular recess.")
    inner_diameter: Length = Field(description="Inner edge of the ring.")
    recess_inner_diameter: Length = Field(description="Inner edge of the recess.")
    recess_outer_diameter: Length = Field(description="Outer edge of the recess.")
    outer_diameter: Length = Field(description="Outer edge of the ring.")

    @rule
    def _diameters_in_order(self) -> Iterator[Issue]:
        yield from in_order(self, *DIAMETERS)

    def pad(self) -> AnnularPad:
        """Give the pad of the calculation."""
        return AnnularPad(
            0.5 * self.inner_diameter,
            0.5 * self.recess_inner_diameter,
            0.5 * self.recess_outer_diameter,
            0.5 * self.outer_diameter,
        )


class RectangularInput(Part):
    """A rectangle with a rectangular recess in the middle."""

    kind: Literal["rectangular"] = Field(description="Rectangular pad.")
    length: Length = Field(description="Side along the sliding, if it slides.")
    width: Length = Field(description="Other side.")
    recess_length: Length = Field(description="Side of the recess along length.")
    recess_width: Length = Field(description="Other side of the recess.")

    @rule
    def _recess_inside(self) -> Iterator[Issue]:
        yield from in_order(self, "recess_length", "length")
        yield from in_order(self, "recess_width", "width")

    def pad(self) -> PadShape:
        """Give the pad of the calculation."""
        return RectangularPad(self.length, self.width, self.recess_length, self.recess_width)
