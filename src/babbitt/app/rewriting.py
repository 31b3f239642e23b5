"""The text of a case with other values, its comments and its order kept."""

from __future__ import annotations

from collections.abc import Mapping
from io import StringIO
from typing import Any

from babbitt.case.document import DocumentError, read_document
from babbitt.case.with_units import case_text

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

    Comments stay where their field stays. A text that cannot be kept so (JSON, aliases) is written anew.

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
    if before == given:
        return text
    if before:
        try:
            made = _in_its_lines(text, before, given)
        except (YAMLError, ValueError, LookupError):  # it reads dates, and keys that are numbers, as no texts
            made = ""
        if mapping_in(made) == given:
            return made
    return case_text(given)


def _in_its_lines(text: str, before: Mapping[str, Any], given: Mapping[str, Any]) -> str:
    """The text with the values that are new; empty where it is a mapping in braces."""
    from ruamel.yaml import YAML

    yaml = YAML()
    yaml.preserve_quotes = True
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
        elif name not in before or old != value or type(old) is not type(value):
            tree[name] = value
