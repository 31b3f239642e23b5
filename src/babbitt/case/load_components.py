"""A load across the shaft as components, ``{x: 22 kN, y: -35 kN}``, in place of its size and direction."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from babbitt.core.units import QuantityError, SiField, SiNumber, read

if TYPE_CHECKING:
    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

__all__ = [
    "DIRECTION",
    "LOAD",
    "LoadOrComponents",
    "direction_given_twice",
    "load_or_components",
    "with_direction",
]

LOAD, DIRECTION = "load", "load_angle"
AXES = ("x", "y")
EXAMPLE = "{x: 22 kN, y: -35 kN}"
SAME_DIRECTION = 1e-9
"""rad. Directions that differ by less are one."""


@dataclass(frozen=True)
class LoadOrComponents(SiField):
    """Pydantic metadata of a load whose direction is another field: its size, or its components in x and y."""

    def __call__(self, given: object) -> float:
        """Read and check what was given; a number is in SI.

        >>> load_or_components("N", "1 N", "1 MN")({"x": "3 kN", "y": "-4 kN"})
        5000.0
        >>> load_or_components("N", "1 N", "1 MN")({"x": "3 kN", "z": "-4 kN"})
        Traceback (most recent call last):
        babbitt.core.units.reading.QuantityError: z is no component of a load; allowed: {x: 22 kN, y: -35 kN}
        """
        return super().__call__(SiNumber(self._size(given)) if isinstance(given, Mapping) else given)

    def as_written(self, given: object) -> float:
        """Read and check what stands in a case file, where a number has a unit too."""
        if isinstance(given, Mapping):
            for name, value in given.items():
                if not isinstance(value, str | SiNumber) and isinstance(value, int | float):
                    self._named(str(name), self.require_unit, float(value))
            return self(given)
        return super().as_written(given)

    def _size(self, given: Mapping[Any, Any]) -> float:
        unknown = next((name for name in given if name not in AXES), None)
        if unknown is not None or not given:
            what = f"{unknown} is no component of a load" if given else "the load has no component"
            raise QuantityError(what, EXAMPLE)
        return math.hypot(*(self._named(name, self._component, value) for name, value in given.items()))

    def _component(self, given: object) -> float:
        return read(given, self.unit)

    @staticmethod
    def _named(name: str, reading: Any, value: Any) -> Any:
        """Read a component; what is wrong with it is told with its name."""
        try:
            return reading(value)
        except QuantityError as error:
            raise QuantityError(f"{name}: {error.says}", error.allowed, error.hint) from None

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors that components will do."""
        described = super().__get_pydantic_json_schema__(schema, handler)
        component = {
            "anyOf": [{"const": 0}, {"type": "string"}],
            "x-unit": self.unit,
            "x-allowed": f"-{self.highest} to {self.highest}",
        }
        components = {
            "type": "object",
            "properties": dict.fromkeys(AXES, component),
            "additionalProperties": False,
            "description": f"Components in x and y, in place of size and direction: {EXAMPLE}.",
        }
        return {**described, "anyOf": [*described["anyOf"], components]}


def load_or_components(unit: str, lowest: str, highest: str) -> LoadOrComponents:
    """Make the metadata of a load across the shaft, with the range of its size."""
    return LoadOrComponents(unit, lowest, highest)


def with_direction(given: Mapping[str, Any]) -> Mapping[str, Any]:
    """What a part was given, with the direction of a load that is given by its components.

    Components that cannot be read are left to the field of the load, which refuses them.

    Parameters
    ----------
    given : Mapping
        Of a part that has a direction of the load; it is not changed.
    """
    angle = _direction(given.get(LOAD))
    return given if angle is None else {**given, DIRECTION: SiNumber(angle)}


def direction_given_twice(given: Mapping[str, Any]) -> bool:
    """Whether components are given and a direction that is not theirs."""
    angle = _direction(given.get(LOAD))
    if angle is None or given.get(DIRECTION) is None:
        return False
    try:
        other = read(given[DIRECTION], "rad")
    except QuantityError:
        return True
    return abs(math.remainder(other - angle, 2.0 * math.pi)) > SAME_DIRECTION


def _direction(load: Any) -> float | None:
    if not isinstance(load, Mapping):
        return None
    try:
        x, y = (read(load.get(axis, 0.0), "N") for axis in AXES)
    except QuantityError:
        return None
    return math.atan2(y, x) if x or y else None
