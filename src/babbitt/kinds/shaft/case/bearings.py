"""The bearings of a shaft: supports whose loads are asked for, and bearings that are computed with these loads."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, is_given, rule
from babbitt.case.parts.fields import Name
from babbitt.case.parts.load_and_speed import LOADS, SPEEDS
from babbitt.core.units import either_sense, si, written
from babbitt.kinds.journal.case.film_features import MisalignmentInput
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.shaft.answer import ShaftAnswer
from babbitt.kinds.shaft.case.torque import Station
from babbitt.kinds.shaft.model import Support
from babbitt.kinds.shaft.statics import thrust
from babbitt.kinds.thrust.case.thrust import ThrustBearingInputs, ThrustCase

__all__ = ["ShaftBearing", "ShaftJournal", "ShaftThrust", "SupportInput", "holding_issues"]

BearingStiffness = Annotated[float, si("N/m", "1 kN/m", "1e18 N/m", "MN/m")]
Offset = Annotated[float, si("m", "-50 mm", "50 mm", "um")]
LEAST_DISTANCE = 1e-4
"""m. Radial bearings nearer to each other than this are two at one place: an assumption."""

FROM_THE_SHAFT = (*LOADS, "load_angle", "attitude_angle")


class OffsetInput(Part):
    """Where the centre of a bearing lies, off the line of the shaft."""

    example: ClassVar[str] = "{y: -20 um}"

    x: Offset = Field(0.0, description="To the right.")
    y: Offset = Field(0.0, description="Upward.")


class Place(Part):
    """Where a bearing of the shaft stands, and how it gives way."""

    station: Station = Field(description="Place of the middle of the bearing along the shaft.")
    stiffness: BearingStiffness | None = Field(
        None, description="Radial stiffness of film and housing, for the bending of the shaft. Rigid if not given."
    )
    offset: OffsetInput = Field(
        OffsetInput(),
        description="Offset of its centre from the line of the others, for the bending of the shaft.",
    )

    def support(self, name: str, radial: bool, axial: bool) -> Support:
        """Give the support of the calculation."""
        stiffness = math.inf if self.stiffness is None else self.stiffness
        return Support(name, self.station, radial, axial, stiffness, (self.offset.x, self.offset.y))


class SupportInput(Place):
    """A bearing of which the load alone is asked for."""

    kind: Literal["radial", "axial", "radial_axial"] = Field(
        description="What it carries: load across the shaft, thrust, or both."
    )
    name: Name = Field(description="Name of the bearing.")

    def as_support(self) -> Support:
        """Give the support of the calculation."""
        return self.support(self.name, self.kind != "axial", self.kind != "radial")


class ShaftJournal(Place, JournalBearing):
    """A journal bearing of the shaft: load, direction, speed and the slope of the shaft in it follow."""

    kind: Literal["journal"] = Field(description="Journal bearing, computed with its load from the shaft.")

    @rule
    def _one_load(self) -> Iterator[Issue]:
        yield from _given_by_the_shaft(self, FROM_THE_SHAFT, "the shaft gives its load and the direction")

    @rule
    def _one_speed(self) -> Iterator[Issue]:
        yield from _given_by_the_shaft(self, SPEEDS, "the shaft gives its speed")

    def as_support(self) -> Support:
        """Give the support of the calculation."""
        return self.support(self.name, radial=True, axial=False)

    def loaded(self, answer: ShaftAnswer, place: int, speed: float) -> JournalBearing:
        """The bearing under the load of the shaft, with the slope of the shaft where the method counts it.

        Parameters
        ----------
        answer : ShaftAnswer
        place : int
            Of the bearing among those of the shaft.
        speed : float
            Of the shaft, rad/s.
        """
        x, y, _ = (float(one) for one in answer.bearing_forces[place])
        found: dict[str, Any] = {"load": math.hypot(x, y), "load_angle": math.atan2(y, x), "speed": speed}
        slope = answer.slope_at(place)
        if slope is not None and self.method == "film":
            own = self.misalignment or MisalignmentInput()
            found["misalignment"] = own.model_copy(update={"x": own.x + slope[0], "y": own.y + slope[1]})
        elif slope is not None:
            size = written(math.hypot(*slope), "mrad")
            found["assumptions"] = (
                *self.assumptions,
                f"The slope of the shaft in {self.name}, {size}, {self._use}",
            )
        given = {name: value for name, value in vars(self).items() if name not in Place.model_fields}
        fields = (self.model_fields_set - Place.model_fields.keys()) | found.keys()
        loaded = JournalBearing.model_construct(_fields_set=fields, **(given | found))
        return loaded if slope is None or self.method == "film" else loaded.on_sloping_shaft(slope)

    @property
    def _use(self) -> str:
        """What the method makes of the slope of the shaft."""
        if self.method == "iso7902":
            return "counts in the limit of the film thickness alone: the film of ISO 7902 has parallel axes."
        return f"is not counted by method {self.method}."


class ShaftThrust(Place, ThrustBearingInputs):
    """A thrust bearing of the shaft: its thrust follows, and its speed where it gives none."""

    kind: Literal["thrust"] = Field(description="Thrust bearing, computed with the thrust of the shaft.")
    name: Name = Field(description="Name of the bearing.")
    speed: Annotated[float, either_sense("rad/s", "0.01 rpm", "1000000 rpm")] = Field(
        description="Speed of the collar as its pads see it: positive towards growing pad numbers. Its size is "
        "that of the shaft."
    )

    @rule
    def _no_place_of_its_own(self) -> Iterator[Issue]:
        for name in ("stiffness", "offset"):
            if name in self.model_fields_set:
                yield Issue(
                    (name,), "is radial, and a thrust bearing carries along the shaft alone", "no such field"
                )

    def as_support(self) -> Support:
        """Give the support of the calculation."""
        return self.support(self.name, radial=False, axial=True)

    def loaded(self, answer: ShaftAnswer) -> ThrustCase:
        """The bearing under the thrust of the shaft."""
        given = {name: value for name, value in vars(self).items() if name not in Place.model_fields}
        fields = (self.model_fields_set - Place.model_fields.keys()) | {"load"}
        return ThrustCase.model_construct(_fields_set=fields, **given, load=abs(thrust(answer.shaft)))


def _given_by_the_shaft(bearing: ShaftJournal, names: tuple[str, ...], says: str) -> Iterator[Issue]:
    at: list[tuple[tuple[str | int, ...], Part]] = [((), bearing)]
    at += [(("operating_points", k), point) for k, point in enumerate(bearing.operating_points)]
    for path, part in at:
        for name in names:
            if name in type(part).model_fields and is_given(part, name):
                yield Issue((*path, name), says, f"no {name} here", "remove it")


def holding_issues(bearings: Sequence[SupportInput | ShaftJournal | ShaftThrust], bends: bool) -> Iterator[Issue]:
    """Complain about bearings that do not hold a shaft: too few, at one place, two that take the thrust.

    Parameters
    ----------
    bearings : sequence of bearings
    bends : bool
        Whether the pieces of the shaft are given.
    """
    supports = [one.as_support() for one in bearings]
    radial = [(index, one) for index, one in enumerate(supports) if one.radial]
    if len(radial) < 2:
        says = f"{len(radial) or 'none'} of the bearings carries load across the shaft"
        yield Issue(("bearings",), says, "two radial bearings or more")
    if len(radial) > 2 and not bends:
        says = f"{len(radial)} radial bearings share the load by the bending of the shaft"
        yield Issue(("shaft",), says, "the pieces of the shaft, such as [{length: 2 m, diameter: 200 mm}]")
    for place, (index, one) in enumerate(radial):
        other = next((two for _, two in radial[:place] if abs(two.station - one.station) < LEAST_DISTANCE), None)
        if other is not None:
            says = f"the bearing '{other.name}' stands there, too"
            yield Issue(("bearings", index, "station"), says, "each radial bearing at a place of its own")
    axial = [(index, one) for index, one in enumerate(supports) if one.axial]
    for index, _ in axial[1:]:
        says = f"the bearing '{axial[0][1].name}' takes the thrust already"
        yield Issue(("bearings", index, "kind"), says, "one bearing that carries axially")


ShaftBearing = Annotated[SupportInput | ShaftJournal | ShaftThrust, Discriminator("kind")]
