"""Types of fields that take a quantity: numbers in SI or text with a unit, within a range that makes sense."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any

from babbitt.units.kinds import KINDS, Kind
from babbitt.units.reading import QuantityError, plausible_unit, read

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema


@dataclass(frozen=True)
class SiField:
    """Pydantic metadata of a float that is read with `babbitt.units.read` and kept within a range.

    Attributes
    ----------
    unit : str
        SI unit, a key of `babbitt.units.KINDS`.
    lowest, highest : str
        Inclusive range as the engineer writes it, such as ``"1 mm"``; messages show it so. Both or none.
    """

    unit: str
    lowest: str = ""
    highest: str = ""

    @property
    def kind(self) -> Kind:
        """The kind of quantity."""
        return KINDS[self.unit]

    @cached_property
    def bounds(self) -> tuple[float, float] | None:
        """The range in SI."""
        return (read(self.lowest, self.unit), read(self.highest, self.unit)) if self.highest else None

    @property
    def allowed(self) -> str:
        """The range in words, empty where there is none.

        >>> si("m", "1 mm", "3 m").allowed
        '1 mm to 3 m'
        """
        return f"{self.lowest} to {self.highest}" if self.highest else ""

    def holds(self, value: float) -> bool:
        """Whether an SI value lies in the range."""
        return self.bounds is None or self.bounds[0] <= value <= self.bounds[1]

    def __call__(self, given: object) -> float:
        """Read and check what was given.

        >>> si("m", "1 mm", "3 m")("250 mm")
        0.25
        >>> si("m", "1 mm", "3 m")(250)
        Traceback (most recent call last):
        babbitt.units.reading.QuantityError: 250 without unit is 250 m; allowed: 1 mm to 3 m; write '250 mm'
        """
        value = read(given, self.unit)
        if self.bounds is None or self.holds(value):
            return value
        bare = _bare_number(given)
        if bare is None or self.unit == "1":
            side = "too small" if value < self.bounds[0] else "too large"
            shown = given if bare is not None else f"'{str(given).strip()}'"
            raise QuantityError(f"{shown} is {side}", self.allowed)
        meant = plausible_unit(bare, self.kind, *self.bounds)
        hint = f"write '{bare:.12g} {meant}'" if meant else ""
        raise QuantityError(f"{bare:.12g} without unit is {bare:.12g} {self.unit}", self.allowed, hint)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Read before pydantic's own float check."""
        from pydantic_core import core_schema

        return core_schema.no_info_before_validator_function(self, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors: a number in SI, or text with a unit."""
        number: dict[str, Any] = {"type": "number"}
        if self.bounds is not None:
            number |= {"minimum": self.bounds[0], "maximum": self.bounds[1]}
        described: JsonSchemaValue = {"anyOf": [number, {"type": "string"}], "x-unit": self.unit}
        if self.unit != "1":
            described["x-example"] = self.kind.example
        if self.allowed:
            described["x-allowed"] = self.allowed
        return described


def si(unit: str, lowest: str = "", highest: str = "") -> SiField:
    """Make the metadata of a quantity field: ``Annotated[float, si("m", "1 mm", "3 m")]``."""
    return SiField(unit, lowest, highest)


def _bare_number(given: object) -> float | None:
    try:
        return float(given) if isinstance(given, int | float | str) else None
    except ValueError:
        return None


Length = Annotated[float, si("m")]
Area = Annotated[float, si("m2")]
Volume = Annotated[float, si("m3")]
Angle = Annotated[float, si("rad")]
Mass = Annotated[float, si("kg")]
Force = Annotated[float, si("N")]
Pressure = Annotated[float, si("Pa")]
Temperature = Annotated[float, si("K")]
RotationalSpeed = Annotated[float, si("rad/s")]
Speed = Annotated[float, si("m/s")]
Viscosity = Annotated[float, si("Pa s")]
KinematicViscosity = Annotated[float, si("m2/s")]
Density = Annotated[float, si("kg/m3")]
FlowRate = Annotated[float, si("m3/s")]
HeatTransferCoefficient = Annotated[float, si("W/(m2 K)")]
ThermalExpansion = Annotated[float, si("1/K")]
Dimensionless = Annotated[float, si("1")]
