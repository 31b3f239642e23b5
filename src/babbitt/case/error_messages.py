"""What pydantic finds, said in the words of an engineer."""

from __future__ import annotations

import typing
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any, TypeVar

from pydantic_core import ErrorDetails, InitErrorDetails, PydanticCustomError

from babbitt.case.method_mapping import every_choice
from babbitt.case.shorthand import Shorthand
from babbitt.case.suggestions import meant_field, near_typo
from babbitt.core.units import QuantityError, SiField

if TYPE_CHECKING:
    from babbitt.case.part import Part

ERROR_TYPE = "case"
"""Type of the pydantic errors that already speak plainly; what they say stands in their context."""

MISSING = "is missing"
"""What is said of a field that must be given and is not."""

Path = tuple[str | int, ...]
Metadata = TypeVar("Metadata")

MOST_LISTED = 24
"""Fields that a message lists at most."""

_EXPECTED = {
    "string_type": "text",
    "string_too_short": "at least one character",
    "string_too_long": "at most {max_length} characters",
    "bool_type": "true or false",
    "bool_parsing": "true or false",
    "tuple_type": "a list",
    "list_type": "a list",
    "too_short": "a list of at least {min_length}",
    "too_long": "a list of at most {max_length}",
    "model_type": "a mapping of fields",
    "model_attributes_type": "a mapping of fields",
    "dict_type": "a mapping of fields",
    "invalid_key": "a word as key",
    "literal_error": "{expected}",
}


def refusal(cls: type[Part], given: Any, details: ErrorDetails) -> InitErrorDetails:
    """Say one finding of pydantic about a part in plain words.

    Parameters
    ----------
    cls : type
        The part that was to be read.
    given : object
        What it was to be read from.
    details : ErrorDetails
        What pydantic found; its location begins at the part.

    Returns
    -------
    InitErrorDetails
        For a new pydantic error. Its location has only keys and indices that stand in the file, without the
        names pydantic gives to the branches of a union.
    """
    path = _without_branch(cls, details["loc"])
    if details["type"] == ERROR_TYPE:
        context = details["ctx"]
    else:
        says, allowed, hint = _say(cls, path, details)
        missing = () if details["type"] == "missing" else None
        context = {"says": says, "allowed": allowed, "hint": hint, "code": "E003", "missing": missing}
    return InitErrorDetails(
        type=PydanticCustomError(ERROR_TYPE, "{says}", context), loc=path, input=details["input"]
    )


def is_echo(details: ErrorDetails) -> bool:
    """Whether a finding only repeats others: pydantic calls a list too short when its items are unusable."""
    given = details["input"]
    return (
        details["type"] == "too_short"
        and isinstance(given, list | tuple)
        and len(given) >= details["ctx"]["min_length"]
    )


def misspelt(cls: type[Part], given: Any, found: Iterable[ErrorDetails]) -> frozenset[str]:
    """Give the fields of a part that its unknown keys seem to mean, and that are not given by their own name."""
    meant: set[str] = set()
    for details in found:
        if details["type"] == "extra_forbidden" and len(details["loc"]) == 1:
            meant.add(meant_field(str(details["loc"][0]), cls).partition(".")[0])
    meant.discard("")
    return frozenset(meant.difference(given if isinstance(given, Mapping) else ()))


def is_missing(details: ErrorDetails, names: frozenset[str]) -> bool:
    """Whether a finding says that one of some fields is missing."""
    return details["type"] == "missing" and len(details["loc"]) == 1 and details["loc"][0] in names


def shown(given: object) -> str:
    """Show what was given, short and harmless.

    >>> shown("H7/zz"), shown({"a": 1}), shown(None)
    ("'H7/zz'", 'a mapping', 'an empty value')
    """
    match given:
        case None:
            return "an empty value"
        case bool():
            return "true" if given else "false"
        case str():
            clean = "".join(letter if letter.isprintable() else "?" for letter in given)
            return f"'{clean}'" if len(clean) <= 60 else f"'{clean[:57]}...'"
        case Mapping():
            return "a mapping"
        case list() | tuple():
            return f"a list of {len(given)}"
        case _:
            return str(given)[:60]


def nearest(name: str, known: Iterable[str]) -> str:
    """Give a hint at the known name nearest to what was written, empty if none is near."""
    return _asked(near_typo(name, known))


def _asked(meant: str) -> str:
    return f"did you mean '{meant}'?" if meant else ""


def listed(names: Iterable[str]) -> str:
    """List names, the first of many only."""
    every = list(names)
    if len(every) <= MOST_LISTED:
        return ", ".join(every)
    return f"{', '.join(every[:MOST_LISTED])} and {len(every) - MOST_LISTED} more (`babbitt schema` lists them)"


def _say(cls: type[Part], path: Path, details: ErrorDetails) -> tuple[str, str, str]:
    name = str(path[-1]) if path else ""
    given, context = details["input"], details.get("ctx", {})
    match details["type"]:
        case "missing":
            return MISSING, "", _described(cls, name)
        case "extra_forbidden":
            meant = meant_field(name, cls)
            moved = every_choice(cls)
            hint = cls.hints.get(name) or _asked(f"method.{meant}" if meant in moved else meant)
            return (
                "is not a field here",
                "" if hint else listed(n for n in cls.model_fields if n not in moved),
                hint,
            )
        case "union_tag_not_found" | "union_tag_invalid":
            return _say_branch(cls, path, given)
        case "model_attributes_type" | "model_type" if path and len(_branches(cls, str(path[0]))) > 1:
            return _say_branch(cls, path, given)
        case "value_error" if isinstance(context.get("error"), QuantityError):
            error: QuantityError = context["error"]
            hint = _elsewhere(cls, path, given, error) or error.hint or cls.hints.get(name, "")
            return error.says, error.allowed, hint
        case "literal_error" if name == "method" and isinstance(given, Mapping):  # one with a kind was read
            return "kind is missing", context["expected"].replace("'", "").replace(" or ", ", "), ""
        case "model_attributes_type" | "model_type" if given is not None and not path and cls.example:
            return f"{shown(given)} is not allowed", f"a mapping such as {cls.example}", ""
    if given is None:
        return "is empty", "", _described(cls, name)
    expected = _EXPECTED.get(details["type"])
    if expected is None:
        return f"{shown(given)} is not usable", details["msg"], ""
    allowed = expected.format(**context).replace("'", "").replace(" or ", ", ")
    if expected == "a list" and isinstance(given, Mapping):
        return f"{shown(given)} is not allowed", allowed, f"put it into brackets, {name}: [{{...}}], or after '- '"
    hint = nearest(given, allowed.split(", ")) if isinstance(given, str) else ""
    return f"{shown(given)} is not allowed", allowed, hint


def _say_branch(cls: type[Part], path: Path, given: Any) -> tuple[str, str, str]:
    kinds = _branches(cls, str(path[0]))
    if not isinstance(given, Mapping):
        short = [f"{form.words}, or " for form in metadata_of(cls, str(path[0]), Shorthand)]
        return f"{shown(given)} is not allowed", f"{''.join(short)}a mapping with kind: {', '.join(kinds)}", ""
    if "kind" not in given:
        return "kind is missing", ", ".join(kinds), ""
    kind = given["kind"]
    return (
        f"kind {shown(kind)} is not known",
        ", ".join(kinds),
        nearest(kind, kinds) if isinstance(kind, str) else "",
    )


def _elsewhere(cls: type[Part], path: Path, given: Any, error: QuantityError) -> str:
    """Hint at the field that takes what was given in its alternative: 12 m/s as speed is a surface_speed."""
    if error.given is None or len(path) != 1:
        return ""
    others = (name for group in cls.alternatives if path[0] in group for name in group)
    fits = (name for name in others if any(data.kind is error.given for data in metadata_of(cls, name, SiField)))
    return next((f"write '{name}: {shown(given)[1:-1]}'" for name in fits), "")


def metadata_of(cls: type[Part], name: str, kind: type[Metadata]) -> Iterator[Metadata]:
    """Find the metadata of one kind of a field, be it optional or not."""
    field = cls.model_fields.get(name)
    if field is not None:
        alternatives = (field, *typing.get_args(field.annotation))
        for one in alternatives:
            metadata = getattr(one, "metadata", getattr(one, "__metadata__", ()))
            yield from (data for data in metadata if isinstance(data, kind))


def _described(cls: type[Part], name: str) -> str:
    field = cls.model_fields.get(name)
    if field is None:
        return ""
    fields = (data for data in field.metadata if isinstance(data, SiField) and data.unit != "1")
    examples = [f"such as '{data.example}'" for data in fields]
    first_sentence = (field.description or name).split(". ")[0].rstrip(".")
    return "needed: " + ", ".join([first_sentence, *examples][:2])


def _without_branch(cls: type[Part], path: Path) -> Path:
    """Drop the name of the union branch that pydantic puts behind a field and its indices."""
    depth = 1
    while depth < len(path) and isinstance(path[depth], int):
        depth += 1
    branches = _branches(cls, str(path[0])) if path else ()
    if len(branches) > 1 and depth < len(path) and path[depth] in branches:
        return (*path[:depth], *path[depth + 1 :])
    return path


@cache
def _branches(cls: type[Part], name: str) -> tuple[str, ...]:
    """Give the values of `kind` that a field knows, empty for a field that is no union."""
    field = cls.model_fields.get(name)
    return tuple(dict.fromkeys(_kinds(field.annotation))) if field is not None else ()


def _kinds(annotation: Any) -> Iterable[str]:
    fields = getattr(annotation, "model_fields", None)
    if fields is not None:
        if "kind" in fields:
            yield from typing.get_args(fields["kind"].annotation)
        return
    for argument in typing.get_args(annotation):
        yield from _kinds(argument)
