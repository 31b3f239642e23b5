"""The mapping ``method: {kind: film, ...}``: the method of a bearing and its choices.

The field `method` of a part names the models of its methods in its annotation. Each of their fields is a choice of
one method. The part inherits the same fields, or one of its own parts does: that is where they are read, and where
they stood before there was a mapping.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from babbitt.case.nested import values_at, with_value, without_value
from babbitt.case.reading import Reading

if TYPE_CHECKING:
    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

    from babbitt.case.error_messages import Path
    from babbitt.case.method_choices import MethodInput
    from babbitt.case.part import Part

__all__ = [
    "KIND",
    "METHOD",
    "Choices",
    "MethodMapping",
    "choices_of",
    "every_choice",
    "in_mapping",
    "method_models",
    "named_method",
    "read_method",
]

METHOD, KIND = "method", "kind"

Choices = Mapping[str, tuple[str, ...]]
"""By name, the path from a part to where a choice of its method is read."""


@dataclass(frozen=True)
class MethodMapping:
    """Pydantic metadata of a `method` that may be a name or a mapping with the choices of the method.

    Attributes
    ----------
    models : tuple of type
        One for each method.
    """

    models: tuple[type[MethodInput], ...]

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors that a mapping will do."""
        from pydantic import TypeAdapter

        mappings = [handler(TypeAdapter(one).core_schema) for one in self.models]
        return {"anyOf": [handler(schema), *mappings]}


@cache
def method_models(cls: type[Part]) -> Mapping[str, type[MethodInput]]:
    """The models of the methods of a part by their names; empty for a part that has no `method`."""
    field = cls.model_fields.get(METHOD)
    found = (one for one in (field.metadata if field is not None else ()) if isinstance(one, MethodMapping))
    return {model.method_name(): model for one in found for model in one.models}


@cache
def choices_of(cls: type[Part], method: str) -> Choices:
    """The choices of one method of a part; empty for a method that has none, or is not known."""
    model = method_models(cls).get(method)
    return {} if model is None else {n: (*model.read_in, n) for n in model.model_fields if n != KIND}


@cache
def every_choice(cls: type[Part]) -> Choices:
    """The choices of all methods of a part."""
    return {name: path for method in method_models(cls) for name, path in choices_of(cls, method).items()}


def read_method(cls: type[Part], given: Mapping[str, Any]) -> Reading:
    """Read the choices in the mapping of the method of a part where the part has them.

    Parameters
    ----------
    cls : type
    given : Mapping
        As it stands in the file; it is not changed.
    """
    mapping = given.get(METHOD) if method_models(cls) else None
    if not isinstance(mapping, Mapping) or KIND not in mapping:
        return Reading(given, given)  # a name, or what is refused where the part is read
    method = mapping[KIND]
    is_known = isinstance(method, str) and method in method_models(cls)
    known = choices_of(cls, method) if is_known else every_choice(cls)
    today: dict[str, Any] = {**given, METHOD: method}
    moved: list[tuple[Path, Path]] = [((METHOD, KIND), (METHOD,))]
    twice: list[tuple[Path, Path]] = []
    for name, path in known.items():
        if name not in mapping or not _has_room(given, path):
            continue
        if any(value is not None and value != mapping[name] for value in values_at(given, path)):
            twice.append((path, (METHOD, name)))
        today = with_value(today, path, mapping[name])
        moved.append(((METHOD, name), path))
    unknown = tuple((METHOD, name) for name in mapping if name not in known and name != KIND)
    return Reading(today, given, tuple(moved), tuple(twice), unknown)


def in_mapping(cls: type[Part], given: Mapping[str, Any]) -> dict[str, Any]:
    """What a part was given with the choices of its method in a mapping; those of other methods stay.

    Parameters
    ----------
    cls : type
    given : Mapping
        In the words of the model; it is not changed.
    """
    made, chosen = dict(given), {}
    method = named_method(cls, given)
    for name, path in choices_of(cls, method).items():
        for value in values_at(given, path):
            chosen[name] = value
            made = without_value(made, path)
    return made | {METHOD: {KIND: method, **chosen}} if chosen else made


def named_method(cls: type[Part], given: Mapping[str, Any]) -> str:
    """The method that a part names, or that of a part that names none; empty where it has no method."""
    if not method_models(cls):
        return ""
    method = given.get(METHOD)
    named = method.get(KIND) if isinstance(method, Mapping) else method
    return str(cls.model_fields[METHOD].default if named is None else named)


def _has_room(given: Mapping[str, Any], path: tuple[str, ...]) -> bool:
    """Whether what stands above a path are mappings, as far as there is any."""
    above = (value for count in range(1, len(path)) for value in values_at(given, path[:count]))
    return all(value is None or isinstance(value, Mapping) for value in above)
