"""Pump, header and lines of a machine, as the engineer writes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Issue, Part, exactly_one, named_once, rule
from babbitt.case.parts.fields import Name
from babbitt.case.parts.supply import Supply, Tube
from babbitt.core.units import si
from babbitt.kinds.journal.oil_balance.model import Line, OilSystem, Pump

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.journal import JournalBearing

__all__ = ["LineInput", "OilSystemInput", "PumpInput", "PumpPoint", "issues_of_bearings"]

Delivery = Annotated[float, si("m3/s", "0 L/min", "100000 L/min")]
HeaderPressure = Annotated[float, si("Pa", "0 kPa", "50 MPa")]

KNOWN_METHODS = ("iso7902", "film")
"""Methods whose flow follows from the supply pressure."""


class PumpPoint(Part):
    """One point of the curve of a pump."""

    pressure: HeaderPressure = Field(description="Gauge pressure of the header.")
    flow: Delivery = Field(description="Delivery at this pressure.")


class PumpInput(Part):
    """The pump: one delivery up to the relief valve, or a curve."""

    example: ClassVar[str] = "{flow: 40 L/min, relief_pressure: 0.3 MPa}"

    flow: Annotated[float, si("m3/s", "0.001 L/min", "100000 L/min")] | None = Field(
        None, description="Delivery at every pressure, in place of a curve."
    )
    curve: tuple[PumpPoint, ...] = Field(
        (), max_length=50, description="Delivery over the pressure of the header, straight between its points."
    )
    relief_pressure: Annotated[float, si("Pa", "1 kPa", "50 MPa")] | None = Field(
        None,
        description="Gauge pressure at which the relief valve opens. The last pressure of the curve if not given.",
    )

    @rule
    def _one_delivery(self) -> Iterator[Issue]:
        yield from exactly_one(self, "flow", "curve")

    @rule
    def _curve_falls(self) -> Iterator[Issue]:
        if self.flow is not None and self.relief_pressure is None:
            yield Issue(("relief_pressure",), "is missing", "a pressure such as '0.3 MPa'", code="E003")
        if len(self.curve) == 1:
            yield Issue(("curve",), "has one point", "two points at least")
        for place, (one, other) in enumerate(pairwise(self.curve), start=1):
            if other.pressure <= one.pressure:
                yield Issue(("curve", place, "pressure"), "does not rise", "pressures in rising order")
            if other.flow > one.flow:
                yield Issue(("curve", place, "flow"), "rises with the pressure", "no more than at less pressure")
        if self.curve and not any(one.flow > 0.0 for one in self.curve[:1]):
            yield Issue(("curve", 0, "flow"), "the pump delivers nothing", "more than 0 L/min")

    def pump(self) -> Pump:
        """Give the pump of the calculation."""
        curve = tuple((one.pressure, one.flow) for one in self.curve) or ((0.0, self.flow or 0.0),)
        return Pump(curve, self.relief_pressure or curve[-1][0])


class LineInput(Part):
    """From the header to one bearing, before what its own supply has: a tube, an orifice, or both."""

    example: ClassVar[str] = "{bearing: Pinion, orifice_diameter: 4 mm}"

    bearing: Name = Field(description="Name of the bearing.")
    orifice_diameter: Annotated[float, si("m", "0.1 mm", "200 mm")] | None = Field(
        None, description="Diameter of a sharp orifice."
    )
    discharge_coefficient: Annotated[float, si("1", "0.1", "1")] = Field(
        0.6,
        description="Of the orifice, and of the one that is proposed. 0.6 is an assumption: a sharp edge at high "
        "Reynolds numbers.",
    )
    tube: Tube | None = Field(
        None,
        description="Tube of the line: Hagen and Poiseuille, turbulent above a Reynolds number of 2300.",
    )

    @rule
    def _something_holds_back(self) -> Iterator[Issue]:
        if self.orifice_diameter is None and self.tube is None:
            says = "nothing is between header and bearing"
            yield Issue((), says, "orifice_diameter, tube, or both", code="E003")

    def line(self) -> Line:
        """Give the line of the calculation."""
        tube = None if self.tube is None else self.tube.duct()
        return Line(self.bearing, tube, self.orifice_diameter, self.discharge_coefficient)


class OilSystemInput(Part):
    """Pump, header and a line to each bearing; the pressure of each bearing follows."""

    pump: PumpInput = Field(description="The pump.")
    lines: tuple[LineInput, ...] = Field(min_length=1, max_length=200, description="One line for each bearing.")
    margin: Annotated[float, si("1", "0", "10")] = Field(
        0.2,
        description="What proposed orifices give beyond the need of a bearing, over it. 20 % is an assumption.",
    )

    @rule
    def _each_once(self) -> Iterator[Issue]:
        yield from named_once((vars(one).get("bearing") for one in self.lines), "line", "lines")

    def system(self, bearings: Sequence[str]) -> OilSystem:
        """Give the system of the calculation, its lines in the order of the bearings."""
        lines = {one.bearing: one.line() for one in self.lines}
        return OilSystem(self.pump.pump(), tuple(lines[name] for name in bearings), self.margin)

    def supply_of(self, bearing: str, supply: Supply | None) -> Supply | None:
        """Give the supply of a bearing from the header on, which stands at the pressure of the relief valve."""
        given = next((one for one in self.lines if one.bearing == bearing), None)
        if supply is None or given is None:
            return supply
        return supply.model_copy(update={"pressure": self.pump.pump().relief_pressure})


def issues_of_bearings(
    system: OilSystemInput, bearings: Sequence[JournalBearing], shared: Supply | None
) -> Iterator[Issue]:
    """Complain about bearings that an oil system does not know, and lines without a bearing."""
    names = [vars(one).get("name") for one in bearings]
    for place, line in enumerate(system.lines):
        if vars(line).get("bearing") not in names:
            known = ", ".join(str(name) for name in names if name)
            yield Issue(("oil_system", "lines", place, "bearing"), "there is no such bearing", known)
    lines = {vars(one).get("bearing") for one in system.lines}
    if shared is not None and (shared.pressure is not None or shared.flow is not None):
        name = "pressure" if shared.pressure is not None else "flow"
        yield Issue(("supply", name), "follows from the oil system", "temperature alone")
    for place, one in enumerate(bearings):
        path = ("bearings", place)
        if names[place] not in lines:
            says = f"no line of the oil system leads to {names[place]}"
            yield Issue((*path, "name"), says, "a line for each bearing in oil_system.lines")
        if one.supply is None and shared is None:
            yield Issue(
                ("supply",), "is missing", "the oil temperature, such as {temperature: 50 degC}", code="E003"
            )
        if one.operating_points:
            yield Issue((*path, "operating_points"), "an oil system has one operating point", "leave them out")
        if one.clearance_cases == "all":
            yield Issue((*path, "clearance_cases"), "an oil system has one clearance of each bearing", "mean")
        if one.method not in KNOWN_METHODS:
            says = f"the flow of method {one.method} does not follow from the supply pressure"
            yield Issue((*path, "method"), says, "iso7902 or film")
        if one.feeds_itself():
            says = "every groove, pocket and hole has a pressure or flow of its own: no oil of the system is taken"
            yield Issue(path, says, "a groove, pocket or hole without pressure and flow")
        for name in ("pressure", "flow"):
            if one.supply is not None and getattr(one.supply, name) is not None:
                yield Issue((*path, "supply", name), "follows from the oil system", "leave it out")
