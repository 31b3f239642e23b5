"""What the film method sees beyond the standard: grooves, pockets, holes, form of the bore, misalignment,
choices."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, at_most_one, exactly_one, rule
from babbitt.case.parts.supply import SupplyFlow
from babbitt.core.units import si, written
from babbitt.kinds.journal.film.bore import (
    Bore,
    LobedBore,
    MeasuredBore,
    PressureDamBore,
    RoundBore,
    TaperedBore,
    WornBore,
)
from babbitt.kinds.journal.film.model import FeedSize
from babbitt.reynolds.model import Step

Angle = Annotated[float, si("rad", "-360 deg", "360 deg")]
FeedPressure = Annotated[float, si("Pa", "0 Pa", "50 MPa")]
Depth = Annotated[float, si("m", "0.1 um", "5 mm")]

ANGLE = "Direction of its centre, counter-clockwise from the x axis."
PRESSURE = "Gauge pressure, if not that of the supply."
PocketFlow = Annotated[float, si("m3/s", "0 L/min", "100000 L/min")]
LEAST_FLOW = 1e-4 / 6e4
"""Least flow that feeds anything, m3/s: that of a supply."""
FLOW = "Oil flow in place of a pressure: flooded where the film draws less, starved where it asks for more."
POCKET_FLOW = f"{FLOW} 0 L/min closes it: nothing feeds it, and its pressure is what the film makes of it."
POSITION = "Axial position of its centre from the mid-plane."
TURN = 2.0 * math.pi
EDGE = 1e-6
"""Angle in rad that decides nothing."""


class FedPart(Part):
    """What feeds the film by a pressure or a flow."""

    @rule
    def _pressure_or_flow(self) -> Iterator[Issue]:
        yield from at_most_one(self, "pressure", "flow")


class GrooveInput(FedPart):
    """An axial groove as wide as the bearing."""

    angle: Angle = Field(description=ANGLE)
    extent: Annotated[float, si("rad", "0 deg", "180 deg")] = Field(
        description="Angle it takes around the bore; 0 is a line of supply."
    )
    pressure: FeedPressure | None = Field(None, description=PRESSURE)
    flow: SupplyFlow | None = Field(None, description=FLOW)

    def feed(self, diameter: float) -> FeedSize:
        """Give the feed of the film."""
        return FeedSize(self.angle, self.extent, pressure=self.pressure, flow=self.flow)

    def reach(self, diameter: float) -> tuple[float, float]:
        """Angle and length along the shaft that it covers, rad and m."""
        return self.extent, math.inf


class ClosablePart(FedPart):
    """What is fed by a pressure or a flow, or by nothing."""

    @rule
    def _closed_or_fed(self) -> Iterator[Issue]:
        flow = getattr(self, "flow", None)
        if flow is not None and 0.0 < flow < LEAST_FLOW * (1.0 - 1e-9):
            says = f"{written(flow, 'L/min')} is next to nothing"
            yield Issue(("flow",), says, "0 L/min, which closes it, or at least 0.0001 L/min")


class PocketInput(ClosablePart):
    """A rectangular pocket, narrower than the bearing; one of 360 deg is a circumferential groove."""

    angle: Angle = Field(description=ANGLE)
    extent: Annotated[float, si("rad", "0.1 deg", "360 deg")] = Field(
        description="Angle it takes around the bore; 360 deg makes a circumferential groove."
    )
    width: Annotated[float, si("m", "0.1 mm", "3 m")] = Field(description="Size along the shaft.")
    axial_position: Annotated[float, si("m", "-3 m", "3 m")] = Field(0.0, description=POSITION)
    pressure: FeedPressure | None = Field(None, description=PRESSURE)
    flow: PocketFlow | None = Field(None, description=POCKET_FLOW)

    def feed(self, diameter: float) -> FeedSize:
        """Give the feed of the film."""
        return FeedSize(self.angle, self.extent, self.width, self.axial_position, self.pressure, self.flow)

    def reach(self, diameter: float) -> tuple[float, float]:
        """Angle and length along the shaft that it covers, rad and m."""
        return self.extent, self.width


class SupplyHoleInput(ClosablePart):
    """A round hole in the bore."""

    angle: Angle = Field(description=ANGLE)
    diameter: Annotated[float, si("m", "0.1 mm", "1 m")] = Field(description="Diameter of the hole.")
    axial_position: Annotated[float, si("m", "-3 m", "3 m")] = Field(0.0, description=POSITION)
    pressure: FeedPressure | None = Field(None, description=PRESSURE)
    flow: PocketFlow | None = Field(None, description=POCKET_FLOW)

    def feed(self, diameter: float) -> FeedSize:
        """Give the feed of the film, a square of the same area."""
        return FeedSize.hole(self.angle, self.diameter, diameter, self.axial_position, self.pressure, self.flow)

    def reach(self, diameter: float) -> tuple[float, float]:
        """Angle and length along the shaft that it covers, rad and m."""
        return 2.0 * self.diameter / diameter, self.diameter


class MisalignmentInput(Part):
    """Misalignment of the journal axis in the bore."""

    x: Annotated[float, si("rad", "-0.05 rad", "0.05 rad", "rad")] = Field(
        0.0, description="Slope dx/dz of the journal axis: towards x along the shaft."
    )
    y: Annotated[float, si("rad", "-0.05 rad", "0.05 rad", "rad")] = Field(
        0.0, description="Slope dy/dz of the journal axis: towards y along the shaft."
    )


class RoundBoreInput(Part):
    """A round bore."""

    kind: Literal["round"] = Field(description="A round bore.")

    def bore(self) -> Bore:
        """Give the bore of the film."""
        return RoundBore()


class LobedBoreInput(Part):
    """A bore of lobes: every land between two grooves is an arc of a larger circle."""

    kind: Literal["lobes"] = Field(
        description="Lobes between grooves: lemon bore, three or four lobes, offset halves (offset 1)."
    )
    preload: Annotated[float, si("1", "0", "0.95")] = Field(
        description="Preload 1 - c/c_l: c is the clearance of the assembled bearing, c_l that of a lobe."
    )
    offset: Annotated[float, si("1", "0", "1")] = Field(
        0.5,
        description="Where on the lobe the gap of a centred journal is smallest: 0.5 in the middle, 1 at its end.",
    )

    def bore(self) -> Bore:
        """Give the bore of the film."""
        return LobedBore(self.preload, self.offset)


class TaperedBoreInput(Part):
    """Lands that are cut back where the oil enters."""

    kind: Literal["taper_land"] = Field(description="Every land is tapered where the oil enters.")
    depth: Depth = Field(description="Depth of the taper at the leading edge of the land.")
    share: Annotated[float, si("1", "0.02", "1")] = Field(description="Share of the land that is tapered.")

    def bore(self) -> Bore:
        """Give the bore of the film."""
        return TaperedBore(self.depth, self.share)


class ReliefInput(Part):
    """The track of a pressure dam bearing that relieves its loaded land."""

    angle: Angle = Field(description=ANGLE)
    extent: Annotated[float, si("rad", "1 deg", "360 deg")] = Field(description="Angle it takes around the bore.")
    width: Annotated[float, si("m", "0.1 mm", "3 m")] = Field(
        description="Size along the shaft, around the middle."
    )
    depth: Depth = Field(description="How much deeper it lies.")


class PressureDamBoreInput(Part):
    """A round bore with a recess that ends in a dam, to load the journal from the other side."""

    kind: Literal["pressure_dam"] = Field(description="A recess of the unloaded land ends in a dam.")
    angle: Angle = Field(
        description="Direction of the dam: the edge at which the recess ends in the sense of rotation."
    )
    extent: Annotated[float, si("rad", "1 deg", "180 deg")] = Field(
        description="Arc of the recess before the dam."
    )
    width: Annotated[float, si("m", "0.1 mm", "3 m")] = Field(
        description="Size of the recess along the shaft, around the middle."
    )
    depth: Depth = Field(description="Depth of the recess.")
    relief: ReliefInput | None = Field(None, description="Track that relieves the loaded land.")

    def bore(self) -> Bore:
        """Give the bore of the film."""
        track = self.relief
        relief = None if track is None else Step(track.angle, track.extent, track.width, track.depth)
        return PressureDamBore(self.angle, self.extent, self.width, self.depth, relief)

    def across_grooves(self, grooves: tuple[GrooveInput, ...], sense: float) -> Iterator[Issue]:
        """Complain about a dam in a groove, or a recess that runs over one onto the next land.

        `sense` is 1 where the journal turns counter-clockwise, -1 otherwise; a recess may begin in a groove.
        """
        turning = "counter-clockwise" if sense > 0.0 else "clockwise"
        for index, groove in enumerate(grooves):
            before = (sense * (self.angle - groove.angle)) % TURN
            if min(before, TURN - before) < 0.5 * groove.extent - EDGE:
                says = f"the dam lies in grooves[{index}]"
                yield Issue(("bore", "angle"), says, "a place on the land between two grooves")
            elif before + 0.5 * groove.extent < self.extent - EDGE:
                says = f"the recess before the dam runs over grooves[{index}] onto another land"
                reach = written(before + 0.5 * groove.extent, "deg")
                allowed = f"up to {reach}, or another angle or sign of the speed"
                yield Issue(("bore", "extent"), f"{says}, as the journal turns {turning}", allowed)

    def too_wide(self, width: float) -> Iterator[Issue]:
        """Complain about a recess or track wider than the bearing."""
        for path, part in ((("bore",), self), (("bore", "relief"), self.relief)):
            if part is not None and part.width > width * (1.0 + 1e-9):
                says = f"{written(part.width, 'mm')} is wider than the bearing"
                yield Issue((*path, "width"), says, f"up to {written(width, 'mm')}")


class WornBoreInput(Part):
    """A bore worn by its journal."""

    kind: Literal["wear"] = Field(description="An arc of the journal is worn into the bore (Dufrane).")
    depth: Depth = Field(description="Depth of the wear at its deepest place.")
    angle: Angle = Field(description="Direction of the deepest place, counter-clockwise from the x axis.")

    @property
    def largest_departure(self) -> float:
        """Largest departure from the circle, m."""
        return self.depth

    def bore(self) -> Bore:
        """Give the bore of the film."""
        return WornBore(self.depth, self.angle)


class MeasuredBoreInput(Part):
    """A bore as it was measured."""

    kind: Literal["measured"] = Field(description="Departures from the circle, measured around the bore.")
    departures: tuple[Annotated[float, si("m", "-1 mm", "1 mm")], ...] | None = Field(
        None,
        min_length=8,
        max_length=720,
        description="Departures from the circle of the given clearance, outward positive, at equal steps once "
        "around in counter-clockwise order; the last point lies one step before the first.",
    )
    file: str | None = Field(
        None,
        max_length=1000,
        description="CSV table of angle and departure in place of them, named from the folder of the case; its "
        "heading has the units: angle [deg],departure [um].",
    )
    start: Angle = Field(0.0, description="Direction of the first point, counter-clockwise from the x axis.")

    @property
    def largest_departure(self) -> float:
        """Largest departure from the circle, m."""
        return max(abs(departure) for departure in self.departures or (0.0,))

    def bore(self) -> Bore:
        """Give the bore of the film."""
        return MeasuredBore(self.departures or (0.0,), self.start)

    @rule
    def _one_source(self) -> Iterator[Issue]:
        yield from exactly_one(self, "departures", "file")


BoreInput = Annotated[
    RoundBoreInput | LobedBoreInput | TaperedBoreInput | PressureDamBoreInput | WornBoreInput | MeasuredBoreInput,
    Discriminator("kind"),
]

__all__ = [
    "BoreInput",
    "GrooveInput",
    "LobedBoreInput",
    "MisalignmentInput",
    "PocketInput",
    "PressureDamBoreInput",
    "SupplyHoleInput",
]


def issues_of_feeds(
    feeds: list[tuple[tuple[str | int, ...], GrooveInput | PocketInput | SupplyHoleInput]],
    width: float | None,
    diameter: float,
) -> Iterator[Issue]:
    """Complain about feeds that reach beyond the bearing, overlap, do not go together, or leave no land.

    Parameters
    ----------
    feeds : list
        Each with its path in the case.
    width : float or None
        Of the bearing, m; None while unknown.
    diameter : float
        m.
    """
    for path, feed in feeds:
        if width is not None and not isinstance(feed, GrooveInput):
            _, length = feed.reach(diameter)
            size = "diameter" if isinstance(feed, SupplyHoleInput) else "width"
            beyond = abs(feed.axial_position) + length / 2.0
            if length >= width:
                says = f"{written(length, 'mm')} is not narrower than the bearing, {written(width, 'mm')}"
                yield Issue((*path, size), says, f"less than {written(width, 'mm')}", "a groove spans the width")
            elif beyond > width / 2.0 * (1.0 + 1e-9):
                room = written((width - length) / 2.0, "mm")
                says = f"at {written(feed.axial_position, 'mm')} it reaches {written(beyond, 'mm')} from the "
                says += f"mid-plane, beyond the bearing of {written(width, 'mm')}"
                yield Issue((*path, "axial_position"), says, f"-{room} to {room}")
    grooves = [(path, feed) for path, feed in feeds if isinstance(feed, GrooveInput)]
    for index, (path, feed) in enumerate(feeds):
        for other_path, other in feeds[:index]:
            if _overlap(feed, other, diameter):
                says = f"it touches or overlaps {other_path[0]}[{other_path[1]}]"
                yield Issue((*path, "angle"), says, "supplies with land between them, at least 1 deg for grooves")
                break
    covered = sum(groove.extent for _, groove in grooves)
    if covered > TURN - math.radians(10.0):
        says = f"the grooves take {written(covered, 'deg')} of the bore"
        yield Issue(grooves[-1][0], says, "at most 350 deg together")


MOST_DEPARTURE = 3.0
"""Largest departure of a worn or measured bore over the radial clearance; beyond it is another bearing."""

LEAST_LAND = math.radians(1.0)
"""Least land between two grooves in rad; less is no film that a grid could see."""


def _overlap(
    one: GrooveInput | PocketInput | SupplyHoleInput,
    other: GrooveInput | PocketInput | SupplyHoleInput,
    diameter: float,
) -> bool:
    (extent, length), (other_extent, other_length) = one.reach(diameter), other.reach(diameter)
    apart = abs(math.remainder(one.angle - other.angle, TURN))
    if isinstance(one, GrooveInput) or isinstance(other, GrooveInput):
        return apart < (extent + other_extent) / 2.0 + LEAST_LAND
    if apart >= (extent + other_extent) / 2.0 * (1.0 - 1e-9) and (apart > 0.0 or extent + other_extent > 0.0):
        return False
    return abs(one.axial_position - other.axial_position) < (length + other_length) / 2.0 * (1.0 - 1e-9)
