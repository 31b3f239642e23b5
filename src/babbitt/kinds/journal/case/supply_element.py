"""What feeds the film: holes, slots, pockets and grooves."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, rule
from babbitt.case.parts.fields import WholeNumber
from babbitt.core.units import si, written
from babbitt.design.span import ConventionalSpan, SpanRounding, conventional_span
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
    SupplyElement,
    equivalent_holes,
)

Place = Literal["opposite", "side", "both_sides"]
PLACE = "Seen from the load: opposite, at one side (90 deg), or at both sides."

POCKET_EXTENT = math.radians(20.0)
"""Extent around the bore of a pocket that does not give its own. Assumption."""

FeedSize = Annotated[float, si("m", "0.1 mm", "3 m")]
"""Size of a feed in the bearing surface."""


class HoleElement(Part):
    """One hole, or a row of holes, at each place."""

    kind: Literal["hole"] = Field(description="Round holes.")
    diameter: FeedSize = Field(description="Diameter of a hole.")
    place: Place = Field(description=PLACE)
    number: Annotated[int, WholeNumber(1, 20)] = Field(1, description="Holes at each place.")

    @property
    def axial_size(self) -> float:
        """Size along the shaft in m."""
        return self.diameter

    def extent_in(self, diameter: float) -> float:
        """Angle in rad that a hole takes of a bore of that diameter in m."""
        return 2.0 * self.diameter / diameter

    def element(self, diameter: float, span: int) -> SupplyElement:
        """Give the supply element of the calculation in a bore of that diameter (m) and span (deg)."""
        edge = edge_of_place(self.place, self.extent_in(diameter), span)
        taken = self.number * self.diameter
        return Holes(self.diameter, Arrangement(self.place), float(self.number), edge, taken)


class SlotElement(Part):
    """A slot at each place, computed as round holes of the same perimeter and area."""

    kind: Literal["slot"] = Field(description="Slots along the shaft, computed as equivalent holes.")
    length: FeedSize = Field(description="Longer side of the slot, along the shaft.")
    width: FeedSize = Field(description="Shorter side of the slot.")
    place: Place = Field(description=PLACE)

    @property
    def axial_size(self) -> float:
        """Size along the shaft in m: the longer side."""
        return self.length

    @rule
    def _longer_side_first(self) -> Iterator[Issue]:
        if self.width > self.length:
            yield Issue(("width",), "width is larger than length", "the shorter side", "exchange the two")

    def extent_in(self, diameter: float) -> float:
        """Angle in rad that the slot takes of a bore of that diameter in m."""
        return 2.0 * self.width / diameter

    def element(self, diameter: float, span: int) -> SupplyElement:
        """Give the supply element of the calculation in a bore of that diameter (m) and span (deg)."""
        size, number = equivalent_holes(self.length, self.width)
        edge = edge_of_place(self.place, self.extent_in(diameter), span)
        return Holes(size, Arrangement(self.place), number, edge, self.length)


class PocketElement(Part):
    """One pocket at each place."""

    kind: Literal["pocket"] = Field(description="Pockets placed evenly about the load.")
    width: FeedSize = Field(description="Size of the pocket along the shaft.")
    place: Place = Field(description=PLACE)
    extent: Annotated[float, si("rad", "0.1 deg", "180 deg")] | None = Field(
        None, description="Circumferential extent of each pocket; 20 deg are taken without it."
    )

    @property
    def axial_size(self) -> float:
        """Size along the shaft in m."""
        return self.width

    @rule
    def _leaves_an_arc(self) -> Iterator[Issue]:
        if self.place == "both_sides" and self.extent is not None and self.extent >= math.pi * (1.0 - 1e-9):
            says = f"two pockets of {written(self.extent, 'deg')} at 90 deg to the load leave no arc to carry it"
            yield Issue(("extent",), says, "less than 180 deg; `place: side` for one pocket")

    def extent_in(self, diameter: float) -> float:
        """Angle in rad that each pocket takes of the bore."""
        return self.extent or POCKET_EXTENT

    def element(self, diameter: float, span: int) -> SupplyElement:
        """Give the supply element of the calculation in a bore of that diameter (m) and span (deg)."""
        extent = self.extent_in(diameter)
        return Pockets(self.width, Arrangement(self.place), edge_of_place(self.place, extent, span), extent)


class GrooveElement(Part):
    """A groove around the whole circumference or its unloaded half."""

    kind: Literal["groove_360", "groove_180"] = Field(description="Groove around 360 or the unloaded 180 deg.")
    width: FeedSize = Field(description="Size of the groove along the shaft.")

    @property
    def axial_size(self) -> float:
        """Size along the shaft in m."""
        return self.width

    def element(self, diameter: float, span: int) -> SupplyElement:
        """Give the supply element of the calculation."""
        groove = CircumferentialGroove if self.kind == "groove_360" else HalfCircumferentialGroove
        return groove(self.width)


class UnevenPockets(Part):
    """Two pockets at different angles from the load; they set the angular span."""

    kind: Literal["uneven_pockets"] = Field(description="Two pockets at different angles from the load.")
    width: FeedSize = Field(description="Size of the pockets along the shaft.")
    entry_angle: Annotated[float, si("rad", "1 deg", "359 deg")] = Field(
        description="From the centre of the pocket before the load, in the sense of rotation, to the load."
    )
    exit_angle: Annotated[float, si("rad", "1 deg", "359 deg")] = Field(
        description="From the load to the centre of the pocket behind it, in the sense of rotation."
    )
    extent: Annotated[float, si("rad", "0 deg", "180 deg")] = Field(
        description="Circumferential extent of each pocket."
    )
    rounding: Literal["down", "nearest"] = Field(
        "down", description="How the conventional span is brought to a tabulated one. Down is safe."
    )

    @property
    def axial_size(self) -> float:
        """Size along the shaft in m."""
        return self.width

    @property
    def edges(self) -> tuple[float, float]:
        """Angles in rad from the load to the near edge of the entry-side and of the exit-side pocket."""
        return self.entry_angle - self.extent / 2.0, self.exit_angle - self.extent / 2.0

    def conventional_span(self) -> ConventionalSpan:
        """Give the span of the centred arc that stands for the arc between the pockets."""
        return conventional_span(*self.edges, SpanRounding(self.rounding))

    def element(self, diameter: float, span: int) -> SupplyElement:
        """Give the supply element of the calculation, whose flow by pressure ignores the unevenness."""
        return Pockets(self.width, Arrangement.BOTH_SIDES, self.edges[0], self.extent, self.exit_angle)

    @rule
    def _pockets_fit_around(self) -> Iterator[Issue]:
        half = written(self.extent / 2.0, "deg")
        for name, angle in (("entry_angle", self.entry_angle), ("exit_angle", self.exit_angle)):
            if angle <= self.extent / 2.0:
                says = (
                    f"the pocket lies under the load: it reaches {half} to both sides of {written(angle, 'deg')}"
                )
                yield Issue((name,), says, f"more than {half}")
        around = self.entry_angle + self.exit_angle + self.extent
        if around > 2.0 * math.pi * (1.0 + 1e-12):
            yield Issue(
                ("extent",),
                f"the pockets overlap behind the shaft: both angles and the extent make {written(around, 'deg')}",
                "at most 360 deg together",
            )


def edge_of_place(place: Place, extent: float, span: int) -> float:
    """Angle in rad from the downstream edge of an element before the load to the load.

    Elements at both sides stand at 90 deg, or where an arc shorter than 360 deg ends.

    >>> [round(math.degrees(edge_of_place(place, math.radians(20.0), 360))) for place in ("opposite", "side")]
    [170, 80]
    >>> round(math.degrees(edge_of_place("both_sides", math.radians(20.0), 120)))
    60
    """
    if place == "both_sides" and span < 360:
        return math.radians(span) / 2.0
    return Arrangement(place).angle - extent / 2.0


SupplyElementInput = Annotated[
    HoleElement | SlotElement | PocketElement | GrooveElement | UnevenPockets, Discriminator("kind")
]


def half_bearing_width(element: SupplyElementInput | None, width: float) -> float | None:
    """Width in m of each half bearing into which a groove around the circumference parts a bearing, else None."""
    if not isinstance(element, GrooveElement) or element.kind != "groove_360":
        return None
    return (width - element.width) / 2.0


def issues_of(element: SupplyElementInput, width: float) -> Iterator[Issue]:
    """Complain about an element that does not fit into its bearing."""
    sizes: dict[type[Part], str] = {HoleElement: "diameter", SlotElement: "length"}
    name = sizes.get(type(element), "width")
    if element.axial_size >= width:
        what = {GrooveElement: "groove", UnevenPockets: "pocket"}.get(type(element), element.kind)
        turned = isinstance(element, SlotElement)
        yield Issue(
            ("supply_element", name),
            f"the {what} reaches outside the bearing: {written(element.axial_size, 'mm')} in a width of "
            f"{written(width, 'mm')}",
            f"less than {written(width, 'mm')}",
            "a slot lies along the shaft; one around the bore is a pocket with its extent" if turned else "",
        )
    elif isinstance(element, HoleElement) and element.number * element.diameter >= width * (1.0 - 1e-9):
        together, size = written(element.number * element.diameter, "mm"), written(element.diameter, "mm")
        says = f"{element.number} holes of {size} in a row along the shaft take {together}"
        most = math.ceil(width / element.diameter) - 1
        allowed = f"up to {most} of {size} in a width of {written(width, 'mm')}"
        yield Issue(("supply_element", "number"), says, allowed, "fewer or smaller holes")
    elif (
        isinstance(element, SlotElement) and (hole := equivalent_holes(element.length, element.width)[0]) >= width
    ):
        says = f"the equivalent hole of the slot, {written(hole, 'mm')}, is wider than the bearing"
        yield Issue(("supply_element", "width"), says, f"less than {written(width, 'mm')}")
