"""Fields that may be written as one word where a mapping would say no more."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema


@dataclass(frozen=True)
class Shorthand:
    """Pydantic metadata of a mapping that may be written as text.

    Attributes
    ----------
    expand : callable
        Gives the mapping for a text, and anything else unchanged.
    words : str
        What the text says, such as "a name in the catalogue".
    """

    expand: Callable[[Any], Any]
    words: str

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Expand before the mapping is read."""
        from pydantic_core import core_schema

        return core_schema.no_info_before_validator_function(self.expand, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors that text will do."""
        return {
            "anyOf": [
                {"type": "string", "description": f"{self.words[0].upper()}{self.words[1:]}."},
                handler(schema),
            ]
        }
