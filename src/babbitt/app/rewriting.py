"""The text of a case with other values, its comments and its order kept."""

from __future__ import annotations

from collections.abc import Mapping
from io import StringIO
from typing import TYPE_CHECKING, Any

from babbitt.case.document import DocumentError, read_document
from babbitt.case.scalars import scalar
from babbitt.case.with_units import case_text

if TYPE_CHECKING:
    from ruamel.yaml import YAML

__all__ = ["mapping_in", "rewritten"]


def mapping_in(text: str) -> dict[str, Any]:
    """What the text of a case says; empty for a text that is no mapping."""
    try:
        found = read_document(text).plain()
    except DocumentError:
        return {}
    return found if isinstance(found, dict) else {}


def rewritten(text: str, given: Mapping[str, Any]) -> str:
    """Write a case in the lines of the text that it was before.

    Comments stay where their field stays; with a field that is taken out go its own and those before the next. A
    text that cannot be kept so (JSON, aliases) is written anew.

    Parameters
    ----------
    text : str
        Of the case before.
    given : Mapping
        What the case gives now.

    Examples
    --------
    >>> print(rewritten("load: 10 kN  # of the fan\\n", {"load": "12 kN"}), end="")
    load: 12 kN  # of the fan
    """
    from ruamel.yaml.error import YAMLError

    before = mapping_in(text)  # bounds what is read below
    if _alike(before, given):
        return text
    if before:
        try:
            made = _in_its_lines(text, before, given)
        except (YAMLError, ValueError, LookupError):  # tags, and keys that it writes otherwise than we read them
            made = ""
        if _alike(mapping_in(made), given):
            return made
    return case_text(given)


def _alike(one: Any, other: Any) -> bool:
    """Whether two values say the same: 1 is neither true nor 1.0."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_alike(one[name], other[name]) for name in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_alike, one, other))
    return type(one) is type(other) and (one == other or repr(one) == repr(other))  # what is not a number


def _in_its_lines(text: str, before: Mapping[str, Any], given: Mapping[str, Any]) -> str:
    """The text with the values that are new; empty where it is a mapping in braces."""
    yaml = _of_words()
    yaml.width = max(110, *map(len, text.splitlines()))
    yaml.default_flow_style = None  # small mappings on one line, as in `case_text`
    yaml.indent(mapping=2, sequence=4, offset=2)
    tree = yaml.load(text)
    if tree.fa.flow_style():
        return ""
    _follow(tree, before, given)
    written = StringIO()
    yaml.dump(tree, written)
    return written.getvalue()


def _of_words() -> YAML:
    """A reader and writer to whom every word without quotation marks is a text, kept as it is written."""
    from ruamel.yaml import YAML
    from ruamel.yaml.nodes import ScalarNode
    from ruamel.yaml.resolver import VersionedResolver

    class Words(VersionedResolver):
        def resolve(self, kind: Any, value: Any, implicit: Any) -> Any:
            if kind is ScalarNode and implicit[0] and value != "<<":  # which merges mappings
                return self.DEFAULT_SCALAR_TAG
            return super().resolve(kind, value, implicit)

    yaml = YAML()
    yaml.Resolver = Words
    yaml.preserve_quotes = True
    return yaml


def _words(value: Any) -> Any:
    """A value in words, as `babbitt.case.scalars` reads them: a text that would be read otherwise in quotes."""
    from ruamel.yaml.scalarstring import PlainScalarString, SingleQuotedScalarString

    if isinstance(value, Mapping):
        return {_words(name): _words(one) for name, one in value.items()}
    if isinstance(value, list):
        return [_words(one) for one in value]
    if isinstance(value, str):
        return value if scalar(value) == value else SingleQuotedScalarString(value)
    return PlainScalarString(_word(value))  # which takes no quotes of the text before


def _word(value: float | bool | None) -> str:
    """A number, a switch or nothing in words."""
    if value is None:
        return "null"
    if isinstance(value, float) and (value != value or abs(value) == float("inf")):
        return f".{value}".replace(".-", "-.")
    return str(value).lower() if isinstance(value, bool) else repr(value)


def _follow(tree: Any, before: Any, given: Any) -> None:
    """Give a tree of lines the values that are new, list by list and mapping by mapping."""
    for name in [name for name in before if name not in given]:
        del tree[name]
    for name, value in given.items():
        old = before.get(name)
        if isinstance(old, dict) and isinstance(value, dict):
            _follow(tree[name], old, value)
        elif isinstance(old, list) and isinstance(value, list) and len(old) == len(value):
            _follow(tree[name], dict(enumerate(old)), dict(enumerate(value)))
        elif name not in before or not _alike(old, value):
            tree[name] = _words(value)
