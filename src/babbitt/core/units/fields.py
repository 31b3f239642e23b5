"""Types of fields that take a quantity: numbers in SI or text with a unit, within a range that makes sense."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any

from babbitt.core.nearest_name import unknown_name
from babbitt.core.units.kinds import KINDS, Kind
from babbitt.core.units.reading import QuantityError, SiNumber, bare_number, plausible_units, read

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, ValidationInfo
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

AS_WRITTEN = MappingProxyType({"numbers": "as written"})
"""Context of a validation whose input was written by hand: numbers have units there. Without it they are in SI."""


@dataclass(frozen=True)
class SiField:
    """Pydantic metadata of a float that is read with `babbitt.core.units.read` and kept within a range.

    Attributes
    ----------
    unit : str
        A key of `babbitt.core.units.KINDS`: the SI unit, or the name of a kind that shares it.
    lowest, highest : str
        Inclusive range as the engineer writes it, such as ``"1 mm"``; messages show it so. Both or none.
    usual : str
        Unit that a number without one was meant in, as drawings have it; empty: any that brings it into range.
    sample : str
        How an engineer writes one, where the example of its kind would mislead; empty: as `example` finds it.
    """

    unit: str
    lowest: str = ""
    highest: str = ""
    usual: str = ""
    sample: str = ""

    def __post_init__(self) -> None:
        if self.unit not in KINDS:
            raise ValueError(unknown_name(self.unit, KINDS, "an SI unit of a field"))

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

    @property
    def example(self) -> str:
        """How an engineer writes one: in its usual unit, as the kind has it, or in the unit of the lower end.

        >>> si("m", "1 mm", "3 m").example, si("m", "0 um", "1 mm").example, si("m", "-5 mm", "5 mm").example
        ('120 mm', '10 um', '1 mm')
        """
        unit = self.lowest.partition(" ")[2]
        first = self.sample or (f"10 {self.usual}" if self.usual else self.kind.example)
        return next((one for one in (first, f"10 {unit}", f"1 {unit}") if self._fits(one)), self.lowest)

    def _fits(self, written: str) -> bool:
        return self.bounds is None or self.holds(read(written, self.unit))

    def ranged(self, value: float) -> float:
        """What of an SI value is held to the range: the value."""
        return value

    def holds(self, value: float) -> bool:
        """Whether an SI value lies in the range."""
        return self.bounds is None or self.bounds[0] <= self.ranged(value) <= self.bounds[1]

    def __call__(self, given: object) -> float:
        """Read and check what was given; a number is in SI.

        >>> si("m", "1 mm", "3 m")("250 mm")
        0.25
        >>> si("m", "1 mm", "3 m")("250")
        Traceback (most recent call last):
        babbitt.core.units.reading.QuantityError: 250 has no unit; allowed: 1 mm to 3 m; write '250 mm'
        """
        if isinstance(given, str) and (bare := bare_number(given)) is not None:
            self.require_unit(bare)
        value = read(given, self.unit)
        if self.bounds is None or self.holds(value):
            return value
        side = "too small" if self.ranged(value) < self.bounds[0] else "too large"
        hint = self._meant(value) if self.unit == "1" and bare_number(given) is not None else ""
        shown = f"'{str(given).strip()}'" if bare_number(given) is None else given
        raise QuantityError(f"{shown} is {side}", self.allowed, hint)

    def as_written(self, given: object) -> float:
        """Read and check what stands in a case file, where a number has a unit too.

        >>> si("rad/s", "1 rpm", "9000 rpm").as_written(3000)
        Traceback (most recent call last):
        babbitt.core.units.reading.QuantityError: 3000 has no unit; allowed: 1 rpm to 9000 rpm; write '3000 rpm'
        """
        if not isinstance(given, str | SiNumber) and (bare := bare_number(given)) is not None:
            self.require_unit(bare)
        return self(given)

    def require_unit(self, bare: float) -> None:
        """Refuse a number without unit, unless all write the quantity in one unit, or it is a zero in any of them.

        Raises
        ------
        QuantityError
            With the units that bring the number into the range.
        """
        if self.kind.one_unit or (bare == 0.0 and not self.kind.offsets) or not math.isfinite(bare):
            return
        allowed = self.allowed or f"{self.kind.phrase} such as '{self.kind.example}'"
        raise QuantityError(f"{bare:.12g} has no unit", allowed, self._meant(bare))

    def _meant(self, bare: float) -> str:
        """Hint at the units that a number without unit may be in."""
        units = plausible_units(self.ranged(bare), self.kind, self.bounds)
        if self.usual and (self.bounds is None or self.holds(read(f"{bare:.12g} {self.usual}", self.unit))):
            units = [self.usual]
        if (
            self.unit == "1"
        ):  # 500 is no eccentricity of 500 permille; a clearance, whose range is in permille, may be
            units = [unit for unit in units if unit == self.highest.partition(" ")[2]]
        return "write " + " or ".join(f"'{bare:.12g} {unit}'" for unit in units) if units else ""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Read before pydantic's own float check."""
        from pydantic_core import core_schema

        return core_schema.with_info_before_validator_function(self._validated, handler(source))

    def _validated(self, given: object, info: ValidationInfo) -> float:
        return self.as_written(given) if info.context is AS_WRITTEN else self(given)

    def numbers(self) -> list[dict[str, Any]]:
        """Give the schema of the numbers that a case file may write without unit."""
        if not self.kind.one_unit:
            return [{"const": 0}] if not self.kind.offsets and self.holds(0.0) else []
        if self.bounds is None:
            return [{"type": "number"}]
        return [{"type": "number", "minimum": self.bounds[0], "maximum": self.bounds[1]}]

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors: text with a unit, or a number where all write it in one unit."""
        described: JsonSchemaValue = {"anyOf": [*self.numbers(), {"type": "string"}], "x-unit": self.kind.unit}
        if self.kind.name:
            described["x-kind"] = self.kind.name
        if self.unit != "1":
            described["x-example"] = self.example
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


@dataclass(frozen=True)
class ZeroOr(SiField):
    """Pydantic metadata of a float that is zero or within a range; what lies between is a slip of unit."""

    @property
    def allowed(self) -> str:
        """The range in words.

        >>> zero_or("Pa", "1 kPa", "50 MPa").allowed
        '0 or 1 kPa to 50 MPa'
        """
        return f"0 or {super().allowed}"

    def holds(self, value: float) -> bool:
        """Whether an SI value is zero or lies in the range."""
        return value == 0.0 or super().holds(value)


def si(unit: str, lowest: str = "", highest: str = "", usual: str = "", sample: str = "") -> SiField:
    """Make the metadata of a quantity field: ``Annotated[float, si("m", "1 mm", "3 m")]``.

    >>> si("m", "0 um", "5 mm", "um")("5")
    Traceback (most recent call last):
    babbitt.core.units.reading.QuantityError: 5 has no unit; allowed: 0 um to 5 mm; write '5 um'
    """
    return SiField(unit, lowest, highest, usual, sample)


def either_sense(unit: str, lowest: str, highest: str) -> EitherSense:
    """Make the metadata of a quantity whose sign says the sense of rotation, with the range of its magnitude."""
    return EitherSense(unit, lowest, highest)


def zero_or(unit: str, lowest: str, highest: str) -> ZeroOr:
    """Make the metadata of a quantity that is zero or within a range."""
    return ZeroOr(unit, lowest, highest)


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
