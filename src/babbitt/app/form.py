"""The fields of a case as a form: drawn from the schema of the case language and from what the case gives.

Nothing here knows a kind or a method: a part with a ``kind`` of its own is a choice with the fields of what is
chosen, so that the choices of other methods do not show; of fields that the method does not read those that are
given show alone.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from babbitt.app.units import split
from babbitt.case.method_mapping import KIND, METHOD
from babbitt.case.schema import shipped_schema
from babbitt.core.quantities import QUANTITIES
from babbitt.core.units import KINDS

__all__ = [
    "Choice",
    "Entry",
    "Group",
    "Item",
    "Path",
    "Rows",
    "as_text",
    "form_of",
    "list_text",
    "quantities",
    "sections_of",
]

Path = tuple[str | int, ...]
Schema = Mapping[str, Any]

NOT_SHOWN = ("babbitt", "kind", "study", "document")
"""Fields of a case that the page sets itself, or shows elsewhere."""

TEXT, NONE = "text", ""
"""Ways to give a part: as a short text, and not at all."""


@dataclass(frozen=True)
class Entry:
    """A field with one value.

    Attributes
    ----------
    path : tuple
    label, help : str
    symbol : str
        Of the quantity, where the results have one of this name.
    value : object
        As the case gives it; None where it does not.
    units : tuple of str
        Everyday units of a quantity, the most usual first; none of one without dimension.
    options : tuple of str
        All that it may be, where it is a choice of words.
    is_switch, is_list, is_required : bool
    is_on : bool
        How a switch stands that is not given.
    allowed, example : str
        Range and example, for hints.
    """

    path: Path
    label: str
    help: str
    symbol: str = ""
    value: Any = None
    units: tuple[str, ...] = ()
    options: tuple[str, ...] = ()
    is_switch: bool = False
    is_on: bool = False
    is_list: bool = False
    is_number: bool = False
    is_required: bool = False
    allowed: str = ""
    example: str = ""


@dataclass(frozen=True)
class Choice:
    """A part that may be given in several ways, with the fields of the way that is chosen."""

    path: Path
    label: str
    help: str
    ways: tuple[str, ...]
    way: str
    items: tuple[Item, ...]
    is_required: bool = False


@dataclass(frozen=True)
class Group:
    """Fields under one heading."""

    path: Path
    label: str
    help: str
    items: tuple[Item, ...]
    is_given: bool


@dataclass(frozen=True)
class Rows:
    """A list of parts that are alike."""

    path: Path
    label: str
    help: str
    rows: tuple[tuple[Item, ...], ...]


Item = Entry | Choice | Group | Rows


@cache
def _schema() -> Schema:
    found: Schema = json.loads(shipped_schema())
    return found


def form_of(given: Mapping[str, Any]) -> tuple[Item, ...]:
    """Every field that the case has, those that are asked for first.

    Parameters
    ----------
    given : Mapping
        A case as it stands in a file; its ``kind`` is one of the case language.
    """
    reference = _schema()["discriminator"]["mapping"][given["kind"]]
    return tuple(_items(_resolved({"$ref": reference}), given, (), NOT_SHOWN))


def sections_of(
    items: tuple[Item, ...], fields: Mapping[str, tuple[str, ...]], other: str
) -> dict[str, list[Item]]:
    """The fields under the headings that name them, in their order; what none names stands under the last one."""
    places = {name: (heading, place) for heading, names in fields.items() for place, name in enumerate(names)}
    found: dict[str, list[Item]] = {heading: [] for heading in (*fields, other)}
    last = (other, 0)
    for item in sorted(items, key=lambda one: places.get(str(one.path[0]), last)[1]):
        found[places.get(str(item.path[0]), last)[0]].append(item)
    return {heading: under for heading, under in found.items() if under}


def as_text(value: Any) -> str:
    """A value of a case as one types it; what is no single value has none."""
    if value is None or isinstance(value, Mapping | list):
        return ""
    return str(value)


def list_text(value: Any) -> str:
    """Values of a case as one types them behind each other; a single one where a list is asked for stands alone.

    >>> list_text(["0 um", "35 um"]), list_text("120 mm"), list_text(None)
    ('0 um, 35 um', '120 mm', '')
    """
    return ", ".join(map(as_text, value if isinstance(value, list) else [value]))


def quantities(items: tuple[Item, ...]) -> Iterator[Entry]:
    """The fields with a number and a unit, as the form has them."""
    for item in items:
        if isinstance(item, Entry):
            text = as_text(item.value)
            if item.units and text and split(text, item.units)[1]:
                yield item
        elif isinstance(item, Rows):
            for row in item.rows:
                yield from quantities(row)
        else:
            yield from quantities(item.items)


def _items(part: Schema, given: Any, path: Path, hidden: tuple[str, ...] = ("kind",)) -> Iterator[Item]:
    required, fields = part.get("required", ()), part.get("properties", {})
    values = given if isinstance(given, Mapping) else {}
    names = [name for name in fields if name not in hidden]
    method = _method_of(values.get(METHOD, fields.get(METHOD, {}).get("default")))
    for name in sorted(names, key=lambda one: (one not in required, names.index(one))):
        field = fields[name]
        is_read = name in values or method in field.get("x-methods", (method,))
        if is_read and not field.get("deprecated") and "const" not in field:
            yield _item(field, values.get(name), (*path, name), name in required)


def _method_of(given: Any) -> Any:
    """The name of a method, given alone or with its choices."""
    return given.get(KIND) if isinstance(given, Mapping) else given


def _item(field: Schema, value: Any, path: Path, is_required: bool) -> Item:
    label, help_text = str(path[-1]).replace("_", " "), field.get("description", "")
    told = {"path": path, "label": label.capitalize(), "help": help_text}
    ways = list(_ways(field))
    parts = [(way, part) for way, part in ways if "properties" in part]
    quantity = _quantity(field)
    if (quantity and not isinstance(value, Mapping)) or (not parts and "items" not in _only(ways)):
        return _entry(quantity or field, ways, value, told, is_required)
    if "items" in _only(ways):
        return _rows(_only(ways), value, told)
    simple = [part for _, part in ways if part.get("type") == "string"]
    if len(parts) == 1 and not simple:
        return Group(**told, items=tuple(_items(parts[0][1], value, path)), is_given=isinstance(value, Mapping))
    return _choice(parts, simple, value, told, is_required)


def _choice(
    parts: list[tuple[str, Schema]], simple: list[Schema], value: Any, told: dict[str, Any], is_required: bool
) -> Choice:
    """A part with ways: a text where one will do, and each kind of mapping."""
    named = [word for part in simple for word in part.get("enum", ())]
    ways = tuple(dict.fromkeys([*([] if named or not simple else [TEXT]), *(way for way, _ in parts)]))
    way, inner = NONE, value
    if isinstance(value, Mapping):
        way = str(value.get("kind")) if value.get("kind") in ways else _fitting(parts, value)
    elif isinstance(value, str):
        way = value if value in named else TEXT
        inner = {"kind": value} if value in named else value
    body: tuple[Item, ...] = ()
    if way == TEXT:
        body = (Entry(**told, value=value, is_required=is_required),)
    elif way:
        body = tuple(_items(dict(parts)[way], inner, told["path"]))
    return Choice(**told, ways=ways, way=way, items=body, is_required=is_required)


def _fitting(parts: list[tuple[str, Schema]], value: Mapping[str, Any]) -> str:
    """The way with most of the fields that are given."""
    return max(parts, key=lambda one: len(value.keys() & one[1]["properties"].keys()))[0]


def _rows(field: Schema, value: Any, told: dict[str, Any]) -> Item:
    ways = list(_ways(field["items"]))
    path, rows = told["path"], value if isinstance(value, list) else []
    if not any("properties" in part for _, part in ways):
        return Entry(**told, value=value)
    inside = tuple(
        (_item(field["items"], one, (*path, number), True),)
        if len(ways) > 1
        else tuple(_items(ways[0][1], one, (*path, number)))
        for number, one in enumerate(rows)
    )
    return Rows(**told, rows=inside)


def _entry(
    field: Schema, ways: list[tuple[str, Schema]], value: Any, told: dict[str, Any], is_required: bool
) -> Entry:
    words = tuple(str(word) for _, part in ways for word in part.get("enum", ()))
    types = {part.get("type") for _, part in ways}
    kind = KINDS.get(field.get("x-kind", field.get("x-unit", "")))
    example = field.get("x-example", "")
    everyday = () if kind is None else tuple(kind.everyday)
    if "" in everyday:  # a plain number, or in the permille and per cent that the case writes
        everyday = tuple(filter(None, everyday)) if as_text(value).partition(" ")[2] in everyday[1:] else ()
    return Entry(
        **told,
        symbol=_symbol(told["path"]),
        value=value,
        units=_usual_first(everyday, example.partition(" ")[2]),
        options=words,
        is_switch=types == {"boolean"},
        is_on=field.get("default") is True,
        is_list=types == {"array"} or isinstance(value, list),
        is_number=bool(types & {"integer", "number"}) and not words and not everyday,
        is_required=is_required,
        allowed=field.get("x-allowed", ""),
        example=example,
    )


def _symbol(path: Path) -> str:
    """The symbol of a field that is, or limits, a quantity of the results; deeper ones are of other parts."""
    name = str(path[-1])
    return QUANTITIES[name].symbol if path[:-1] in ((), ("limits",)) and name in QUANTITIES else ""


def _usual_first(units: tuple[str, ...], usual: str) -> tuple[str, ...]:
    """The units, that of the example first."""
    return tuple(dict.fromkeys([*([usual] if usual in units else []), *units]))


def _quantity(field: Schema) -> Schema | None:
    """The part of a field that tells its unit; None where it has none."""
    if "x-unit" in field:
        return field
    found = (_quantity(one) for one in field.get("anyOf", ()))
    return next((one for one in found if one is not None), None)


def _only(ways: list[tuple[str, Schema]]) -> Schema:
    return ways[0][1] if len(ways) == 1 else {}


def _ways(field: Schema) -> Iterator[tuple[str, Schema]]:
    """What a field may be, but for null: name and schema."""
    field = _resolved(field)
    if "discriminator" in field:
        for kind, reference in field["discriminator"]["mapping"].items():
            yield kind, _resolved({"$ref": reference})
        return
    inner = field.get("anyOf") or field.get("oneOf")
    if inner is None:
        if field.get("type") != "null":
            yield _name_of(field), field
        return
    for one in inner:
        yield from _ways(one)


def _resolved(field: Schema) -> Schema:
    if "$ref" not in field:
        return field
    found: Schema = _schema()["$defs"][field["$ref"].rpartition("/")[2]]
    return found


def _name_of(part: Schema) -> str:
    kind = part.get("properties", {}).get("kind", {})
    return str(kind.get("const", part.get("title", "")))
