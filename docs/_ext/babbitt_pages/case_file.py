"""The reference of case files, from the schema that reads them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from babbitt.case import case_schema
from babbitt.case.aliases import FormerWords
from babbitt.case.method_choices import MethodChoices
from babbitt.case.part import Part
from babbitt.case.schema import define_methods
from babbitt.core.units import KINDS, Kind, written
from babbitt_pages.markdown import anchor, code, table, text

Schema = dict[str, Any]

ROOT_ORDER = ("journal", "machine", "thrust", "thrust_line", "shaft", "overhung_coupling")
"""The kinds of file in the order in which they are explained."""

FIRST = ("babbitt", "kind", "name")
"""Fields that stand first, as they do in a file."""

MANY = 8
"""Fields that a mapping takes over from a larger family are listed there once, if they are at least so many."""


@dataclass
class Section:
    """One mapping of the case language and the fields that lead to it."""

    name: str
    schema: Schema
    reached_by: list[str] = field(default_factory=list)
    family: str = ""
    former_words: FormerWords = field(default_factory=dict)

    @property
    def fields(self) -> Schema:
        """The fields by name."""
        described: Schema = self.schema["properties"]
        return described

    @property
    def label(self) -> str:
        """Target of links."""
        return f"case-{self.name.lower()}"

    @property
    def heading(self) -> str:
        """The fields that lead here, and the `kind` that selects it among others."""
        names = ", ".join(code(name) for name in dict.fromkeys(self.reached_by))
        kinds = _constants(self.fields.get("kind", {}))
        if not kinds:
            return names or f"Fields of every {text(_spaced(self.name))}"
        kind = " or ".join(code(f"kind: {name}") for name in kinds)
        return f"{names}, {kind}" if names else f"{kind} as a file"


def schema() -> Schema:
    """JSON Schema of all that a file can hold."""
    return case_schema()


PUBLIC = "babbitt.api"
"""Package of the classes for programs, which repeat the parts of the case language under short names."""


@cache
def sections() -> list[Section]:
    """Every mapping of the case language, outermost first, each once."""
    whole = schema()
    definitions: dict[str, Schema] = whole["$defs"]
    kinds = {kind: _target(reference) for kind, reference in whole["discriminator"]["mapping"].items()}
    parts = {part.__name__: part for part in _below(Part) if not part.__module__.startswith(PUBLIC)}
    found: dict[str, Section] = {}

    def visit(name: str, through: str) -> None:
        if name in found:
            if through:
                found[name].reached_by.append(through)
            return
        family = _family(parts[name])
        described = definitions[name] if name in definitions else parts[name].model_json_schema()
        define_methods({name: described})
        found[name] = Section(name, described, [through] if through else [], family, parts[name].former_words)
        if family:
            visit(family, "")
        for field_name, one in described["properties"].items():
            if not family or found[family].fields.get(field_name) != one:
                for target in _targets(one):
                    visit(target, field_name)

    for kind in (*ROOT_ORDER, *(kind for kind in kinds if kind not in ROOT_ORDER)):
        visit(kinds[kind], "")
    return list(found.values())


@cache
def page() -> str:
    """Markdown of every section with a table of its fields."""
    every = sections()
    known = {section.name: section for section in every}
    return "\n".join(_section(section, known) for section in every)


def _below(part: type[Part]) -> Iterator[type[Part]]:
    for one in part.__subclasses__():
        yield one
        yield from _below(one)


def _family(part: type[Part]) -> str:
    """The nearest base that brings many fields, empty if there is none."""
    for base in part.__mro__[1:]:
        whole = issubclass(base, Part) and MethodChoices not in base.__bases__
        if whole and base is not Part and len(base.model_fields) >= MANY:
            return base.__name__
    return ""


def _section(section: Section, known: dict[str, Section]) -> str:
    required = section.schema.get("required", [])
    family = known.get(section.family)
    rows = (
        [
            code(name),
            _type(described, known),
            _range(described),
            _default(name, described, required),
            text(says(described, known)),
        ]
        for name, described in sorted(section.fields.items(), key=_rank)
        if not described.get("deprecated") and (family is None or family.fields.get(name) != described)
    )
    body = table(["field", "what it takes", "range", "default", "meaning"], rows)
    description = text(section.schema.get("description", ""))
    if family is not None:
        heading = family.heading.replace("Fields of", "fields of")
        description += f" It has the {heading if heading.startswith('fields') else 'fields of ' + heading} "
        description += f"([see there](#{family.label})), and:"
    former = _former_words(section) + _former_places(section, family)
    return f"{anchor(section.label)}## {section.heading}\n\n{description}\n\n{body}{former}"


def _former_words(section: Section) -> str:
    """What a mapping called some of its fields before, which is still read."""
    named = [
        f"{code(former)} (now {code(one if isinstance(one, str) else one.to)})"
        for former, one in section.former_words.items()
        if former != (one if isinstance(one, str) else one.to).partition(".")[0]
    ]
    return f"\nFormer words, still read: {', '.join(named)}.\n" if named else ""


def _former_places(section: Section, family: Section | None) -> str:
    """What stands in the mapping of the method today, and is still read where it stood before."""
    known = {} if family is None else family.fields
    named = [code(name) for name, one in section.fields.items() if one.get("deprecated") and name not in known]
    return f"\nFormer places, still read, of what stands in `method` now: {', '.join(named)}.\n" if named else ""


def _rank(one: tuple[str, Schema]) -> int:
    """Place of a field in its table: those of `FIRST`, then the others in the order of the schema."""
    return FIRST.index(one[0]) if one[0] in FIRST else len(FIRST)


def _spaced(name: str) -> str:
    """A class name as words."""
    return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in name).strip()


def says(described: Schema, known: dict[str, Section]) -> str:
    """What a field means; pydantic leaves it to the mapping that the field refers to where both say the same."""
    own: str = described.get("description", "")
    if own or "$ref" not in described:
        return own
    return str(known[_target(described["$ref"])].schema.get("description", ""))


def _target(reference: str) -> str:
    return reference.rsplit("/", 1)[-1]


def _targets(described: Any) -> Iterator[str]:
    """Names of the sections that a field refers to, in order."""
    if isinstance(described, list):
        for one in described:
            yield from _targets(one)
    elif isinstance(described, dict):
        if "$ref" in described:
            yield _target(described["$ref"])
        for key, one in described.items():
            if key != "discriminator":
                yield from _targets(one)


def _constants(described: Schema) -> list[str]:
    if "const" in described:
        return [str(described["const"])]
    return [str(one) for one in described.get("enum", [])]


def _branches(described: Schema) -> list[Schema]:
    """The alternatives of a field, without the null that stands for an absent one."""
    branches = described.get("anyOf") or described.get("oneOf") or []
    return [one for one in branches if one.get("type") != "null"]


def _core(described: Schema) -> Schema:
    """What a field takes when it is given."""
    if "x-unit" in described:
        return described
    branches = _branches(described)
    return _core(branches[0]) if len(branches) == 1 else described


def _type(described: Schema, known: dict[str, Section]) -> str:
    core = _core(described)
    if "x-unit" in core:
        return _quantity(core)
    if "$ref" in core:
        return _link(known[_target(core["$ref"])])
    if constants := _constants(core):
        return " or ".join(code(one) for one in constants)
    if branches := _branches(core):
        return _alternatives(branches, known)
    if core.get("type") == "array":
        return _list(core, known)
    if core.get("type") == "object":
        inner = core.get("additionalProperties")
        return f"mapping from paths to {_type(inner, known) if isinstance(inner, dict) else 'values'}"
    if "type" not in core:
        return "any value of the field"
    return {"string": "text", "integer": "whole number", "number": "number", "boolean": "`true` or `false`"}[
        core["type"]
    ]


def _quantity(described: Schema) -> str:
    kind = _kind(described)
    if kind.unit == "1":
        return "number"
    return f"{kind.phrase.split(' ', 1)[1]}, such as {code(described.get('x-example', kind.example))}"


def _kind(described: Schema) -> Kind:
    return KINDS[described.get("x-kind", described.get("x-unit", "1"))]


def _alternatives(branches: list[Schema], known: dict[str, Section]) -> str:
    inner = [deeper for one in branches for deeper in (_branches(one) or [one])]
    mappings = [known[_target(one["$ref"])] for one in inner if "$ref" in one]
    others = dict.fromkeys(_type(one, known) for one in inner if "$ref" not in one)
    linked = [
        f"[{code(kind)}](#{section.label})"
        for section in mappings
        for kind in _constants(section.fields.get("kind", {}))
    ]
    if len(mappings) > 1:
        return " or ".join([*others, f"mapping with `kind` {', '.join(linked)}"])
    return " or ".join([*others, *(_link(section) for section in mappings)])


def _link(section: Section) -> str:
    kinds = _constants(section.fields.get("kind", {}))
    label = " or ".join(code(f"kind: {kind}") for kind in kinds) or "mapping"
    return f"[{label}](#{section.label})"


def _list(described: Schema, known: dict[str, Section]) -> str:
    if "prefixItems" in described:
        parts = [_type(one, known) for one in described["prefixItems"]]
        return f"list of {len(parts)}: {parts[0]}"
    return f"list of {_type(described['items'], known)}"


def _range(described: Schema) -> str:
    core = _core(described)
    if core.get("type") == "array":
        inner = core["prefixItems"][0] if "prefixItems" in core else core["items"]
        inner_range = _range(inner)
        most = f"up to {core['maxItems']} entries" if "items" in core and "maxItems" in core else ""
        return ", ".join(part for part in (most, inner_range) if part)
    if "x-allowed" in core:
        return text(core["x-allowed"])
    if "minimum" in core and "maximum" in core:
        return f"{core['minimum']} to {core['maximum']}"
    return ""


def _default(name: str, described: Schema, required: list[str]) -> str:
    if name in required:
        return "**required**"
    default = described.get("default")
    if default in (None, "", [], {}):
        return "–"
    if isinstance(default, dict):
        return "its defaults"
    kind = _kind(_core(described))
    if isinstance(default, int | float) and kind.unit != "1":
        return code(written(float(default), next(iter(kind.everyday))))
    return code(f"{default:g}" if isinstance(default, float) else default)
