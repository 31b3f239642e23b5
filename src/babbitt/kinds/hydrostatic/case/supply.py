"""The oil supply of hydrostatic bearings, as an engineer writes it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Issue, Part, exactly_one, is_given, rule
from babbitt.core.units import si
from babbitt.kinds.hydrostatic.case.restrictors import FlowRate, Leakage
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.restrictors import Restrictor
from babbitt.kinds.hydrostatic.supply import FixedPressure, Pump

SupplyPressure = Annotated[float, si("Pa", "10 kPa", "100 MPa")]


class HydrostaticSupply(Part):
    """Oil before the restrictors: at a fixed pressure, or from one pump."""

    example: ClassVar[str] = "{pressure: 5 MPa}"

    temperature: Annotated[float, si("K", "-30 degC", "200 degC")] | None = Field(
        None, description="Temperature of a lubricant before the restrictors."
    )
    pressure: SupplyPressure | None = Field(
        None, description="Gauge pressure before the restrictors, kept by a relief valve that overflows."
    )
    pump_flow: FlowRate | None = Field(None, description="Flow of one pump for all restrictors, in its place.")
    leakage: Leakage = Field(0.0, description="What that pump delivers less for every pascal.")
    relief_pressure: SupplyPressure | None = Field(
        None, description="Gauge pressure at which its relief valve opens."
    )
    highest_pressure: SupplyPressure | None = Field(None, description="Gauge pressure that the pump can hold.")
    pump_efficiency: Annotated[float, si("1", "0.05", "1")] = Field(0.8, description="Efficiency of the pump.")
    manifold_volume: Annotated[float, si("m3", "0 mL", "1000 L")] = Field(
        0.0, description="Oil between pump and restrictors."
    )

    @rule
    def _one_source(self) -> Iterator[Issue]:
        yield from exactly_one(self, "pressure", "pump_flow")
        for name in ("leakage", "relief_pressure", "manifold_volume"):
            if is_given(self, name) and is_given(self, "pressure"):
                yield Issue((name,), f"{name} is of a pump, but the pressure is given", "pump_flow", "remove one")

    @rule
    def _pump_holds(self) -> Iterator[Issue]:
        highest = self.highest_pressure
        for name in ("pressure", "relief_pressure"):
            given = getattr(self, name)
            if highest is not None and given is not None and given > highest:
                yield Issue(
                    (name,),
                    f"{name} is above highest_pressure",
                    "a pressure that the pump can hold",
                    "correct one",
                )

    def feeding(self, restrictors: Iterable[Restrictor]) -> Feeding:
        """Give restrictors and supply of the calculation."""
        if self.pressure is not None:
            return Feeding(tuple(restrictors), FixedPressure(self.pressure))
        relief = float("inf") if self.relief_pressure is None else self.relief_pressure
        return Feeding(tuple(restrictors), Pump(self.pump_flow or 0.0, self.leakage, relief))
