"""The text of a case file as a tree that remembers where each value stands.

The tree is built from the events of a YAML parser, which run in a loop and evaluate nothing. Depth, size and
aliases are limited here, so that no file can exhaust the machine.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from babbitt.case.error_messages import shown
from babbitt.case.scalars import Scalar, scalar
from babbitt.core.picklable_error import PicklableError

DEEPEST = 20
"""Mappings and lists within each other; the case language needs seven."""

LARGEST = 50_000
"""Values in a file, those behind aliases counted each time."""

LONGEST_SHOWN = 60
"""Characters of a word of the file that a message shows."""


@dataclass(frozen=True)
class Mark:
    """A place in the text, both counted from 1."""

    line: int
    column: int


class DocumentError(PicklableError):
    """The text is no document that a case can be read from."""

    def __init__(self, line: int, says: str, allowed: str = "", hint: str = "") -> None:
        super().__init__(says)
        self.line, self.says, self.allowed, self.hint = line, says, allowed, hint


@dataclass
class Node:
    """A value and its place: a scalar, a list of nodes, or a mapping of key to (place of the key, node)."""

    mark: Mark
    value: Scalar | list[Node] | dict[str, tuple[Mark, Node]]
    size: int = 1
    is_open: bool = field(default=True, repr=False)

    def plain(self) -> Any:
        """Give the value without places."""
        if isinstance(self.value, dict):
            return {key: node.plain() for key, (_, node) in self.value.items()}
        if isinstance(self.value, list):
            return [node.plain() for node in self.value]
        return self.value

    def line_of(self, path: tuple[str | int, ...]) -> int:
        """Give the line of the key that a path leads to, or of the last one on the way that exists."""
        node, mark = self, self.mark
        for step in path:
            if isinstance(node.value, dict) and isinstance(step, str) and step in node.value:
                mark, node = node.value[step]
            elif isinstance(node.value, list) and isinstance(step, int) and step < len(node.value):
                node = node.value[step]
                mark = node.mark
            else:
                break
        return mark.line


def read_document(text: str) -> Node:
    """Read the one document of a text.

    Parameters
    ----------
    text : str
        YAML; JSON is YAML too.

    Raises
    ------
    DocumentError
        Not YAML, empty, several documents, nested too deeply, too large, a duplicate or unusable key, an alias
        without anchor or within its own anchor, a tag.
    """
    import yaml

    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        return _Composer(yaml.parse(text, Loader=loader)).document()
    except yaml.MarkedYAMLError as error:
        raise _not_yaml(error, text) from None
    except yaml.reader.ReaderError as error:
        before = text[: error.position] if isinstance(error.position, int) else ""
        raise DocumentError(before.count("\n") + 1, "the file has control characters", "plain text") from None


class _Composer:
    """Builds the tree from events, with a stack of its own in place of recursion."""

    def __init__(self, events: Iterator[Any]) -> None:
        self.events = events
        self.anchors: dict[str, Node] = {}
        self.size = 0

    def document(self) -> Node:
        root: Node | None = None
        stack: list[tuple[Node, list[Node]]] = []
        for event in self.events:
            kind = type(event).__name__
            if kind == "DocumentStartEvent" and root is not None:
                line = event.start_mark.line + 1
                raise DocumentError(line, "a second document begins", "one document per file", "one case per file")
            if kind in ("SequenceStartEvent", "MappingStartEvent"):
                if len(stack) >= DEEPEST:
                    line = event.start_mark.line + 1
                    raise DocumentError(line, "nested too deeply", f"at most {DEEPEST} levels")
                node = self._node(event, [] if kind == "SequenceStartEvent" else {})
                stack.append((node, []))
                continue
            if kind in ("SequenceEndEvent", "MappingEndEvent"):
                node, children = stack.pop()
                _close(node, children)
            elif kind == "ScalarEvent":
                if any("\ud800" <= letter <= "\udfff" for letter in event.value):
                    raise DocumentError(event.start_mark.line + 1, "an escape stands for half a character")
                node = self._node(event, scalar(event.value) if event.implicit[0] else event.value)
                node.is_open = False
            elif kind == "AliasEvent":
                node = self._aliased(event)
            else:
                continue
            if stack:
                stack[-1][1].append(node)
            else:
                root = node
        if root is None:
            raise DocumentError(1, "the file is empty", "", "`babbitt new journal` writes one that works")
        return root

    def _node(self, event: Any, value: Any) -> Node:
        line = event.start_mark.line + 1
        if event.tag is not None and event.tag != "!":
            raise DocumentError(line, "tags (words that begin with !) are not used in case files", "plain values")
        self._count(1, line)
        node = Node(Mark(line, event.start_mark.column + 1), value)
        if event.anchor is not None:
            self.anchors[event.anchor] = node
        return node

    def _aliased(self, event: Any) -> Node:
        line = event.start_mark.line + 1
        node = self.anchors.get(event.anchor)
        if node is None:
            raise DocumentError(
                line, f"no anchor &{event.anchor[:LONGEST_SHOWN]} stands above", "an anchor above the alias"
            )
        if node.is_open:
            raise DocumentError(
                line, f"the anchor &{event.anchor[:LONGEST_SHOWN]} refers to itself", "an alias outside its anchor"
            )
        self._count(node.size, line)
        return node

    def _count(self, more: int, line: int) -> None:
        self.size += more
        if self.size > LARGEST:
            says = "the file has too many values, those behind aliases counted each time"
            raise DocumentError(line, says, f"at most {LARGEST}")


def _close(node: Node, children: list[Node]) -> None:
    node.is_open = False
    node.size += sum(child.size for child in children)
    if isinstance(node.value, list):
        node.value.extend(children)
        return
    assert isinstance(node.value, dict)
    merged: list[Node] = []
    for key, value in zip(children[::2], children[1::2], strict=True):
        name = _key(key)
        if name == "<<":
            merged += value.value if isinstance(value.value, list) else [value]
            continue
        if name in node.value:
            first = node.value[name][0].line
            raise DocumentError(
                key.mark.line, f"the key {shown(name)} stands twice, first in line {first}", "each key once"
            )
        node.value[name] = (key.mark, value)
    for other in merged:
        if not isinstance(other.value, dict):
            raise DocumentError(other.mark.line, "'<<' merges mappings only", "an alias of a mapping")
        for name, entry in other.value.items():
            node.value.setdefault(name, entry)


def _key(key: Node) -> str:
    if isinstance(key.value, list | dict) or key.value is None:
        raise DocumentError(
            key.mark.line, "a list, a mapping or nothing stands where a key should", "a word as key"
        )
    text = str(key.value)
    return text if text.isprintable() else repr(text)


def _not_yaml(error: Any, text: str) -> DocumentError:
    mark = error.problem_mark or error.context_mark
    line = mark.line + 1 if mark is not None else 1
    lines = text.splitlines()
    here = lines[line - 1] if line <= len(lines) else ""
    if "\t" in here[: len(here) - len(here.lstrip())] or "'\\t'" in str(error.problem):
        return DocumentError(line, "a tab stands in the indentation", "spaces")
    says = f"not YAML: {error.problem or error.context}"
    if error.context_mark is not None and error.context_mark.line + 1 != line:
        says += f", in what begins in line {error.context_mark.line + 1}"
    return DocumentError(line, says, "", "check indentation, brackets, quotation marks and the space after ':'")
