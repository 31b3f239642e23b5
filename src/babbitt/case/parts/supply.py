"""Oil supply and the elements through which the oil enters the film."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Issue, Part, at_most_one, rule
from babbitt.case.parts.fields import WholeNumber
from babbitt.core.units import si, zero_or
from babbitt.design.ducts import Duct

OilTemperature = Annotated[float, si("K", "-30 degC", "200 degC")]
SupplyFlow = Annotated[float, si("m3/s", "0.0001 L/min", "100000 L/min")]
GaugePressure = Annotated[float, zero_or("Pa", "1 kPa", "50 MPa")]


class Tube(Part):
    """A tube between the supply system and the bearing."""

    diameter: Annotated[float, si("m", "1 mm", "1 m")] = Field(description="Inside diameter of the tube.")
    length: Annotated[float, si("m", "0 m", "200 m")] = Field(description="Length of the tube.")
    loss_coefficient: Annotated[float, si("1", "0", "1000")] = Field(
        1.0, description="Sum of the local loss coefficients of bends and ends. 1 is one velocity head."
    )
    number: Annotated[int, WholeNumber(1, 100)] = Field(1, description="Equal tubes in parallel.")

    def duct(self) -> Duct:
        """Give the duct of the calculation."""
        return Duct(self.diameter, self.length, self.loss_coefficient, float(self.number))


class FeedHole(Part):
    """A hole through the shell or housing."""

    diameter: Annotated[float, si("m", "0.1 mm", "1 m")] = Field(description="Diameter of the hole.")
    length: Annotated[float, si("m", "0 m", "5 m")] = Field(0.0, description="Length of the hole.")
    loss_coefficient: Annotated[float, si("1", "0", "1000")] = Field(
        1.5, description="Sum of the local loss coefficients. 1.5 is entrance (0.5) and exit (1)."
    )
    number: Annotated[int, WholeNumber(1, 100)] = Field(1, description="Equal holes in parallel.")

    def duct(self) -> Duct:
        """Give the duct of the calculation."""
        return Duct(self.diameter, self.length, self.loss_coefficient, float(self.number))


class SuppliedAt(Part):
    """Fresh oil of which the temperature alone counts."""

    example: ClassVar[str] = "{temperature: 45 degC}"

    temperature: OilTemperature | None = Field(None, description="Temperature of the fresh oil.")


class Supply(Part):
    """Oil fed under pressure. A bearing may give single fields and take the others from its machine."""

    example: ClassVar[str] = "{temperature: 50 degC, pressure: 0.2 MPa}"
    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = (("pressure", "flow"),)

    temperature: OilTemperature | None = Field(None, description="Oil temperature at the inlet, T_en.")
    pressure: GaugePressure | None = Field(
        None,
        description="Gauge pressure of the supply system. Without tubes and holes, at the supply element. 0 Pa is "
        "an unpressurised feed.",
    )
    flow: SupplyFlow | None = Field(
        None,
        description="Oil flow in place of the pressure, for the film method: shared by all supplies of a bearing "
        "without pressure or flow of their own, so that all fill the same part of the gap. In a machine every "
        "bearing is given this flow.",
    )
    tubes: tuple[Tube, ...] = Field((), max_length=20, description="Tubes on the way, one after the other.")
    holes: tuple[FeedHole, ...] = Field((), max_length=20, description="Holes on the way, one after the other.")
    circulation_time: Annotated[float, si("s", "1 s", "100 h")] | None = Field(
        None,
        description="Whole oil volume over the whole flow of the supply system; above 5 min a higher oil "
        "temperature is permissible.",
    )

    @rule
    def _pressure_or_flow(self) -> Iterator[Issue]:
        yield from at_most_one(self, "pressure", "flow")
