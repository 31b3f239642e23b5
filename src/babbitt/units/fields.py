"""Types of fields that take a quantity: numbers in SI or text with a unit, within a range that makes sense."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any

from babbitt.units.kinds import KINDS, Kind
from babbitt.units.reading import QuantityError, bare_number, plausible_unit, read

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
        A key of `babbitt.units.KINDS`: the SI unit, or the name of a kind that shares it.
    lowest, highest : str
        Inclusive range as the engineer writes it, such as ``"1 mm"``; messages show it so. Both or none.
    usual : str
        Unit that a number out of range without one was meant in, as drawings have it; empty: any in range.
    """

    unit: str
    lowest: str = ""
    highest: str = ""
    usual: str = ""

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

    def ranged(self, value: float) -> float:
        """What of an SI value is held to the range: the value."""
        return value

    def holds(self, value: float) -> bool:
        """Whether an SI value lies in the range."""
        return self.bounds is None or self.bounds[0] <= self.ranged(value) <= self.bounds[1]

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
        bare = bare_number(given)
        meant = None if bare is None else plausible_unit(self.ranged(bare), self.kind, *self.bounds)
        if bare is not None and self.usual and self.holds(read(f"{bare:.12g} {self.usual}", self.unit)):
            meant = self.usual
        if self.unit == "1" and meant != self.highest.partition(" ")[2]:
            meant = None  # 500 is no eccentricity of 500 permille; a clearance, whose range is in permille, may be
        hint = f"write '{bare:.12g} {meant}'" if meant else ""
        if bare is None or self.unit == "1":
            side = "too small" if self.ranged(value) < self.bounds[0] else "too large"
            shown = given if bare is not None else f"'{str(given).strip()}'"
            raise QuantityError(f"{shown} is {side}", self.allowed, hint)
        raise QuantityError(f"{bare:.12g} without unit is {bare:.12g} {self.kind.unit}", self.allowed, hint)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Read before pydantic's own float check."""
        from pydantic_core import core_schema

        return core_schema.no_info_before_validator_function(self, handler(source))

    def numbers(self) -> list[dict[str, Any]]:
        """Give the schema of a number in SI."""
        if self.bounds is None:
            return [{"type": "number"}]
        return [{"type": "number", "minimum": self.bounds[0], "maximum": self.bounds[1]}]

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors: a number in SI, or text with a unit."""
        described: JsonSchemaValue = {"anyOf": [*self.numbers(), {"type": "string"}], "x-unit": self.kind.unit}
        if self.kind.name:
            described["x-kind"] = self.kind.name
        if self.unit != "1":
            described["x-example"] = self.kind.example
        if self.allowed:
            described["x-allowed"] = self.allowed
        return described


@dataclass(frozen=True)
class EitherSense(SiField):
    """Pydantic metadata of a float whose sign says the sense of rotation and whose magnitude has the range."""

    @property
    def allowed(self) -> str:
        """The range in words.

        >>> either_sense("rad/s", "1 rpm", "9000 rpm").allowed
        '1 rpm to 9000 rpm, with either sign'
        """
        return f"{super().allowed}, with either sign"

    def ranged(self, value: float) -> float:
        """What of an SI value is held to the range: its magnitude."""
        return abs(value)

    def numbers(self) -> list[dict[str, Any]]:
        """Give the schema of a number in SI, of one range for each sense."""
        (counter_clockwise,) = super().numbers()
        lowest, highest = counter_clockwise["minimum"], counter_clockwise["maximum"]
        return [counter_clockwise, {"type": "number", "minimum": -highest, "maximum": -lowest}]


def si(unit: str, lowest: str = "", highest: str = "", usual: str = "") -> SiField:
    """Make the metadata of a quantity field: ``Annotated[float, si("m", "1 mm", "3 m")]``.

    >>> si("m", "0 um", "5 mm", "um")(5)
    Traceback (most recent call last):
    babbitt.units.reading.QuantityError: 5 without unit is 5 m; allowed: 0 um to 5 mm; write '5 um'
    """
    return SiField(unit, lowest, highest, usual)


def either_sense(unit: str, lowest: str, highest: str) -> EitherSense:
    """Make the metadata of a quantity whose sign says the sense of rotation, with the range of its magnitude."""
    return EitherSense(unit, lowest, highest)


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
