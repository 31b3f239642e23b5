"""What the choices of a method are made of: the fields, and the mapping in which a file has them."""

from __future__ import annotations

import typing
from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from babbitt.case.part import Part

if TYPE_CHECKING:
    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

__all__ = ["MethodChoices", "MethodInput"]


class MethodChoices(Part):
    """Fields that are choices of one method. A part that inherits them reads them from the mapping of its method;
    in the part itself they stood before there was one, and are still read."""

    known_to: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """Other fields of the part that not every method reads, and the methods that do."""

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Mark the former place of a choice, and fields that not every method reads."""
        drawn = handler(schema)
        if not issubclass(cls, MethodInput):
            fields = handler.resolve_ref_schema(drawn)["properties"]
            for name, methods in cls.known_to.items():
                fields[name]["x-methods"] = list(methods)
            for base in cls.__mro__:
                if MethodChoices in base.__bases__:
                    for name in base.model_fields:  # type: ignore[attr-defined]  # a part, as its base is
                        fields[name]["deprecated"] = True
        return drawn


class MethodInput(Part):
    """The mapping of a method; its `kind` is the name of the method."""

    read_in: ClassVar[tuple[str, ...]] = ()
    """Path from the bearing to the part that has the choices; empty where the bearing itself has them."""

    @classmethod
    def method_name(cls) -> str:
        """The name of the method."""
        (name,) = typing.get_args(cls.model_fields["kind"].annotation)
        return str(name)
