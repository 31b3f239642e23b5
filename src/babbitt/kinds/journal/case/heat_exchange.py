"""Heat exchange of the long film: through its walls to journal and bush, and from there to the surroundings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Field

from babbitt.case.method_choices import MethodChoices
from babbitt.case.part import Issue, Part, rule
from babbitt.case.shorthand import Shorthand
from babbitt.core.units import si, written
from babbitt.kinds.journal.infinitely_long_bearing.model import (
    DUCT_COEFFICIENT,
    DUCT_EXPONENT,
    BushRing,
    HeatExchange,
    NusseltLaw,
)

if TYPE_CHECKING:
    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

Conductivity = Annotated[float, si("W/(m K)", "0 W/(m K)", "1000 W/(m K)")]


class NusseltInput(Part):
    """Heat transfer from the film to either wall, Nu = coefficient (Pe h/D)^exponent, formed with the gap."""

    example: ClassVar[str] = "{coefficient: 1.55, exponent: 0.333}"

    coefficient: Annotated[float, si("1", "0", "100")] = Field(
        DUCT_COEFFICIENT, description="Factor a; with exponent 0 the Nusselt number itself. 0: no heat exchange."
    )
    exponent: Annotated[float, si("1", "0", "1")] = Field(
        DUCT_EXPONENT, description="Exponent n. 1/3 as in a laminar duct if not given."
    )


class _ConstantNusselt(Shorthand):
    """A number in place of the law: a constant Nusselt number."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors that a number will do."""
        return {"anyOf": [{"type": "number", "description": "Constant Nusselt number."}, handler(schema)]}


def _number(given: Any) -> Any:
    plain = isinstance(given, int | float) and not isinstance(given, bool)
    return {"coefficient": given, "exponent": 0} if plain else given


class BushInput(Part):
    """The bush as a ring that conducts heat around the journal."""

    example: ClassVar[str] = "{outer_diameter: 100 mm, conductivity: 45 W/(m K)}"

    outer_diameter: Annotated[float, si("m", "1 mm", "10 m")] = Field(description="Outside diameter, d_o.")
    conductivity: Conductivity = Field(description="Thermal conductivity, lam_B.")


class AmbientInput(Part):
    """The surroundings of bush and shaft."""

    example: ClassVar[str] = "{temperature: 20 degC, coefficient: 20 W/(m2 K)}"

    temperature: Annotated[float, si("K", "-60 degC", "200 degC")] = Field(description="Temperature, T_amb.")
    coefficient: Annotated[float, si("W/(m2 K)", "0 W/(m2 K)", "100000 W/(m2 K)")] = Field(
        0.0, description="Heat transfer coefficient from the outside of the bush."
    )


class LongFilmChoices(MethodChoices):
    """Choices of the infinitely long film."""

    nusselt: Annotated[NusseltInput, _ConstantNusselt(_number, "a Nusselt number")] = Field(
        NusseltInput(), description="Heat transfer from film to walls. A number is a constant Nusselt number."
    )
    discretisation: Literal["consistent", "published_mean", "published_literal"] = Field(
        "consistent",
        description="consistent conserves the flow. The published ones repeat a published table and do not.",
    )
    exchange_zone: Literal["liquid_fraction", "all_around", "film"] | None = Field(
        None,
        description="How much of the ruptured film rubs and exchanges heat: its liquid fraction, all, or none. "
        "liquid_fraction if not given, all_around with a published discretisation.",
    )


class HeatExchangeInput(LongFilmChoices):
    """Where heat goes other than into the oil, and how the published calculation is repeated."""

    example: ClassVar[str] = "{bush: {outer_diameter: 100 mm, conductivity: 45 W/(m K)}}"

    bush: BushInput | None = Field(None, description="The bush. Adiabatic if not given.")
    ambient: AmbientInput | None = Field(None, description="The surroundings. No heat reaches them if not given.")
    shaft_conductance: Annotated[float, si("W/K", "0 W/K", "1000 W/K")] = Field(
        0.0, description="Conductance from the journal along the shaft to the surroundings."
    )
    supply_angle: Annotated[float, si("rad", "100 deg", "270 deg")] = Field(
        math.pi,
        description="Where the oil enters (phi_1), from the narrowest gap in the direction of rotation. 180 deg, "
        "the widest gap, if not given.",
    )

    @rule
    def _surroundings_are_known(self) -> Iterator[Issue]:
        if self.shaft_conductance > 0.0 and self.ambient is None:
            says = "heat leaves along the shaft to surroundings that are not given"
            yield Issue(("shaft_conductance",), says, "ambient with a temperature")
        if self.ambient is not None and self.ambient.coefficient > 0.0 and self.bush is None:
            says = "the outside of the bush gives off heat, and no bush is given"
            yield Issue(("ambient", "coefficient"), says, "bush with it")

    def exchange(self) -> HeatExchange:
        """Give the heat exchange of the calculation."""
        ambient, bush = self.ambient, None
        if self.bush is not None:
            coefficient = ambient.coefficient if ambient is not None else 0.0
            bush = BushRing(self.bush.outer_diameter, self.bush.conductivity, coefficient)
        return HeatExchange(
            NusseltLaw(self.nusselt.coefficient, self.nusselt.exponent),
            bush,
            self.shaft_conductance,
            None if ambient is None else ambient.temperature,
        )


def issues_of(given: HeatExchangeInput, diameter: float) -> Iterator[Issue]:
    """Complain about a bush that its bearing does not fit into."""
    if given.bush is not None and given.bush.outer_diameter <= diameter:
        says = f"the bush, {written(given.bush.outer_diameter, 'mm')}, is not larger than the bearing"
        yield Issue(("heat_exchange", "bush", "outer_diameter"), says, f"more than {written(diameter, 'mm')}")
