"""What takes heat from a film."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Issue, Part, is_given, rule
from babbitt.core.units import si

__all__ = ["ConductingJournalInput", "Conductivity", "HeatTransfer", "Surroundings"]

Conductivity = Annotated[float, si("W/(m K)", "0.01 W/(m K)", "1000 W/(m K)")]
HeatTransfer = Annotated[float, si("W/(m2 K)", "0 W/(m2 K)", "100000 W/(m2 K)")]
Surroundings = Annotated[float, si("K", "-60 degC", "200 degC")]


class ConductingJournalInput(Part):
    """The journal, which has one temperature."""

    example: ClassVar[str] = "{shaft_conductance: 2 W/K, ambient_temperature: 40 degC}"

    temperature: Annotated[float, si("K", "-30 degC", "290 degC")] | None = Field(
        None, description="Prescribed temperature. Found from its heat balance if not given."
    )
    shaft_conductance: Annotated[float, si("W/K", "0 W/K", "10000 W/K")] = Field(
        0.0, description="Conductance from the journal along the shaft to its surroundings. 0: none leaves."
    )
    ambient_temperature: Surroundings | None = Field(
        None, description="Of the surroundings of the shaft. That around the housing if not given."
    )

    @rule
    def _balance_or_temperature(self) -> Iterator[Issue]:
        if self.temperature is not None and is_given(self, "shaft_conductance"):
            says = "a prescribed journal temperature needs no balance with the shaft"
            yield Issue(("shaft_conductance",), says, "temperature or shaft_conductance", "remove one")
