"""Field types that several parts of the case language share."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import AfterValidator, Field

from babbitt.core.units import AS_WRITTEN, KINDS, Kind, QuantityError, SiNumber, bare_number, read
from babbitt.design.span import TABULATED_SPANS

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, ValidationInfo
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema


@dataclass(frozen=True)
class WholeNumber:
    """Pydantic metadata of an integer between two bounds, both allowed."""

    lowest: int
    highest: int

    def __call__(self, given: object) -> int:
        """Read and check what was given.

        >>> WholeNumber(1, 100)(12)
        12
        """
        allowed = f"a whole number from {self.lowest} to {self.highest}"
        try:
            value = read(given, "1")
        except QuantityError as error:
            raise QuantityError(error.says, allowed) from None
        if not (value.is_integer() and self.lowest <= value <= self.highest):
            raise QuantityError(f"{given} is not allowed", allowed)
        return int(value)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Read before pydantic's own check."""
        from pydantic_core import core_schema

        return core_schema.no_info_before_validator_function(self, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors the bounds."""
        return {"type": "integer", "minimum": self.lowest, "maximum": self.highest}


@dataclass(frozen=True)
class TabulatedSpan:
    """Pydantic metadata of an angular span that the tables of the standard know; the value is in degrees."""

    unit: ClassVar[str] = "rad"
    """What a number without unit is in, where it is taken."""

    @property
    def kind(self) -> Kind:
        """The kind of quantity."""
        return KINDS[self.unit]

    def __call__(self, given: object) -> int:
        """Read and check what was given.

        >>> TabulatedSpan()("180 deg")
        180
        """
        degrees = math.degrees(read(given, "rad"))
        for span in TABULATED_SPANS:
            # A span may come in radians, with as many digits as its writer cared for.
            if math.isclose(degrees, span, rel_tol=1e-5):
                return span
        raise QuantityError(f"{given!r} is not tabulated", self.allowed)

    @property
    def allowed(self) -> str:
        """The spans in words."""
        return ", ".join(f"{span} deg" for span in TABULATED_SPANS)

    def _validated(self, given: object, info: ValidationInfo) -> int:
        bare = None if isinstance(given, SiNumber) else bare_number(given)
        if bare is not None and (info.context is AS_WRITTEN or isinstance(given, str)):
            hint = f"write '{bare:.12g} deg'" if bare in TABULATED_SPANS else ""
            raise QuantityError(f"{bare:.12g} has no unit", self.allowed, hint)
        return self(given)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Read before pydantic's own check."""
        from pydantic_core import core_schema

        return core_schema.with_info_before_validator_function(self._validated, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors the spans."""
        return {
            "type": "string",
            "enum": [f"{span} deg" for span in TABULATED_SPANS],
            "x-unit": "rad",
            "x-allowed": self.allowed,
        }


def _one_line(text: str) -> str:
    if not text.isprintable():
        raise QuantityError("the text has line breaks or control characters", "one line of text")
    return text.strip()


def _harmless(text: str) -> str:
    if not all(letter.isprintable() or letter in "\n\t" for letter in text):
        raise QuantityError("the text has control characters", "plain text")
    return text.strip()


Name = Annotated[str, Field(min_length=1, max_length=120), AfterValidator(_one_line)]
"""One short line of text."""

Prose = Annotated[str, Field(max_length=20_000), AfterValidator(_harmless)]
"""Free text."""

Span = Annotated[int, TabulatedSpan()]
"""Angular span in whole degrees."""
