"""Write the stubs of the public classes: their keywords, with the types that Python may give.

A quantity is a float once it is read, and text, a number or a pint quantity where it is given; type checkers know
the one from the models and the other from these stubs.
"""

from __future__ import annotations

import ast
import inspect
import types
import typing
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any, Literal

from babbitt.api.bearings import JournalBearing, Machine
from babbitt.api.case import Case
from babbitt.case.field_types import quantity_in
from babbitt.case.load_components import LoadOrComponents
from babbitt.case.method_mapping import MethodMapping
from babbitt.case.part import Part
from babbitt.case.shorthand import Shorthand

MODULES = (
    "bearings",
    "common_parts",
    "footstep_parts",
    "hydrostatic_parts",
    "journal_parts",
    "methods",
    "shaft_parts",
    "thrust_parts",
    "tilting_pad_parts",
)
FOLDER = Path(__file__).parents[1] / "src" / "babbitt" / "api"

OF_PYTHON = {"bore": " | Gap"}
"""What fields of a journal bearing take besides what a case file has."""

HEADING = '''"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias
'''


def stub(name: str) -> str:
    """The text of the stub of a module."""
    module = import_module(f"babbitt.api.{name}")
    tree = ast.parse((FOLDER / f"{name}.py").read_text(encoding="utf-8"))
    imports = [ast.unparse(one) for one in tree.body if isinstance(one, ast.ImportFrom)]
    of_babbitt = {one for one in imports if one.startswith("from babbitt.")}
    blocks = [HEADING + "\n" + "\n".join(sorted(of_babbitt | {"from babbitt.case.part import Part"})) + "\n"]
    blocks.append("Quantity: TypeAlias = str | SupportsFloat\n")
    for one in vars(module).values():
        if isinstance(one, type) and one.__module__ == module.__name__ and not one.__name__.startswith("_"):
            blocks.append(_class(one))
    blocks += _rest(module)
    return "\n".join(blocks)


def _class(cls: type[Part]) -> str:
    bases = ", ".join(_base(base) for base in cls.__bases__ if not base.__name__.startswith("_"))
    own = [f"    {line}\n" for line in _own(cls)]
    keywords = "".join(f"        {one},\n" for one in _keywords(cls))
    made = f"    def __init__(\n        self,\n        *,\n{keywords}    ) -> None: ...\n" if keywords else ""
    body = "".join(own) + made
    return f"class {cls.__name__}({bases}):\n{body}" if body else f"class {cls.__name__}({bases}): ...\n"


def _base(base: type) -> str:
    """How the module names a base: with its own module where it is of the case language."""
    if base.__module__.startswith("babbitt.api") or base.__name__.endswith("Case"):
        return base.__name__ if not base.__module__.endswith("journal.case.files") else f"files.{base.__name__}"
    return f"{base.__module__.rpartition('.')[2]}.{base.__name__}"


def _own(cls: type) -> Iterator[str]:
    if issubclass(cls, Case):
        yield "model: ClassVar[type[CaseFile]]"
        yield "default_name: ClassVar[str]"
    if cls is Machine:
        yield "bearings: tuple[JournalBearing, ...]"


def _keywords(cls: type[Part]) -> Iterator[str]:
    for name, field in cls.model_fields.items():
        also = OF_PYTHON.get(name, "") if cls is JournalBearing else ""
        yield f"{name}: {_type(field.rebuild_annotation())}{also} | None = ..."


def _type(annotation: Any) -> str:
    found = dict.fromkeys(_types(annotation, bool(quantity_in(annotation))))
    return " | ".join(found)


def _types(annotation: Any, is_quantity: bool) -> Iterator[str]:
    origin, arguments = typing.get_origin(annotation), typing.get_args(annotation)
    if origin is typing.Annotated:
        if any(isinstance(one, Shorthand) for one in arguments[1:]):
            yield "Quantity"
        yield from _types(arguments[0], is_quantity)
        if any(isinstance(one, LoadOrComponents) for one in arguments[1:]):
            yield "Mapping[str, Any]"
        if any(isinstance(one, MethodMapping) for one in arguments[1:]):
            yield from ("Mapping[str, Any]", "Part")
    elif origin in (typing.Union, types.UnionType):
        for one in arguments:
            if one is not type(None):
                yield from _types(one, is_quantity)
    elif origin is Literal:
        yield from (f"Literal[{', '.join(map(_quoted, arguments))}]", "Enum")
    elif origin is tuple:
        yield f"Iterable[{'Quantity' if is_quantity and not _of_parts(arguments) else 'Any'}]"
    elif inspect.isclass(annotation) and issubclass(annotation, Part):
        yield from ("Mapping[str, Any]", "Part")
    elif is_quantity and annotation in (float, int):
        yield "Quantity"
    else:
        yield {int: "SupportsIndex", float: "Quantity", str: "str", bool: "bool"}.get(annotation, "Any")


def _of_parts(arguments: tuple[Any, ...]) -> bool:
    return any(inspect.isclass(one) and issubclass(one, Part) for one in arguments)


def _quoted(value: Any) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(value)


def _rest(module: Any) -> Iterator[str]:
    if module.__name__.endswith("bearings"):
        yield "PUBLIC: Mapping[type[CaseFile], type[Case]]\n"
        yield "def public_case(case: CaseFile) -> CaseFile: ...\n"


if __name__ == "__main__":
    for each in MODULES:
        (FOLDER / f"{each}.pyi").write_text(stub(each), encoding="utf-8")
