"""What a bearing carries and how fast it runs, as a base or at one of several operating points."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.load_components import load_or_components
from babbitt.case.part import Issue, Part, at_most_one, rule
from babbitt.case.parts.fields import Name, Span
from babbitt.case.parts.load_and_speed import LOADS, SPEEDS
from babbitt.case.parts.position import PositionInput
from babbitt.case.parts.supply import GaugePressure, OilTemperature, SupplyFlow
from babbitt.core.units import either_sense, si
from babbitt.kinds.journal.case.supply_element import SupplyElementInput

LoadAngle = Annotated[float, si("rad", "-360 deg", "360 deg")]


class LoadAndSpeed(Part):
    """Load and speed. One of the loads and one of the speeds is given."""

    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = (LOADS, SPEEDS)

    load: Annotated[float, load_or_components("N", "1 N", "1000 MN")] | None = Field(
        None, description="Bearing load F, or its components, such as {x: 22 kN, y: -35 kN}."
    )
    specific_load: Annotated[float, si("Pa", "1 kPa", "500 MPa")] | None = Field(
        None, description="Load per projected area F/(B D), in place of the load."
    )
    eccentricity_ratio: Annotated[float, si("1", "0.01", "0.99")] | None = Field(
        None, description="Prescribed relative eccentricity, in place of the load, which is then found."
    )
    attitude_angle: Annotated[float, si("rad", "-180 deg", "180 deg")] | None = Field(
        None,
        description="With the eccentricity ratio, for the film method: from the load angle to the journal "
        "centre in the sense of rotation. The direction of the load is then found, too.",
    )
    position: PositionInput | None = Field(
        None,
        description="Prescribed place of the journal centre, for the film method, in place of the load. The load "
        "and its direction are found.",
    )
    speed: Annotated[float, either_sense("rad/s", "0.1 rpm", "1000000 rpm")] | None = Field(
        None, description="Rotational speed of the journal, positive counter-clockwise."
    )
    surface_speed: Annotated[float, either_sense("m/s", "1 mm/s", "200 m/s")] | None = Field(
        None, description="Surface speed of the journal, in place of the rotational speed."
    )

    @rule
    def _attitude_needs_eccentricity(self) -> Iterator[Issue]:
        if self.attitude_angle is not None and self.eccentricity_ratio is None:
            says = "an attitude angle prescribes the position only together with eccentricity_ratio"
            yield Issue(("attitude_angle",), says, "eccentricity_ratio with it")


class OperatingPoint(LoadAndSpeed):
    """One of several operating points. What it does not give is taken from the bearing."""

    name: Name = Field(description="Name of the operating point.")
    load_angle: LoadAngle | None = Field(None, description="Direction of the load, from +x.")
    supply_temperature: OilTemperature | None = Field(None, description="Oil temperature at the inlet.")
    supply_pressure: GaugePressure | None = Field(None, description="Gauge pressure of the supply system.")
    supply_flow: SupplyFlow | None = Field(
        None, description="Oil flow in place of the supply pressure, for the film method."
    )
    span: Span | None = Field(None, description="Angular span, where the load turns relative to the pockets.")
    supply_element: SupplyElementInput | None = Field(
        None, description="Supply element, where the load turns relative to the pockets."
    )

    @rule
    def _pressure_or_flow(self) -> Iterator[Issue]:
        yield from at_most_one(self, "supply_pressure", "supply_flow")


def stating(names: tuple[str, ...], bearing: LoadAndSpeed, point: LoadAndSpeed | None) -> LoadAndSpeed:
    """Give the piece that states one of some fields: the operating point where it does, else the bearing.

    Parameters
    ----------
    names : tuple of str
        `LOADS` or `SPEEDS`.
    bearing, point : LoadAndSpeed
        None as point: the bearing as such.
    """
    states = point is not None and any(getattr(point, name) is not None for name in names)
    return point if point is not None and states else bearing
