"""The examples of a page: fenced blocks, with the file a block shows or the command it is the output of."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"

_FENCE = re.compile(r"^(?P<indent>\s*)(?P<ticks>`{3,})(?P<language>\{?[\w-]*\}?)(?P<argument>.*)$")
_COMMENT = re.compile(r"^\s*<!-- (?P<what>file|output of): (?P<value>.+?) -->$")


@dataclass(frozen=True)
class Block:
    """A fenced block.

    `language` is in braces for a directive; `stands_for` is the name of the file that the block shows, and
    `output_of` the command whose output it shows.
    """

    line: int
    language: str
    text: str
    stands_for: str = ""
    output_of: str = ""


@dataclass(frozen=True)
class Step:
    """A command of a console block and the output shown below it."""

    command: str
    shown: str


def pages() -> list[Path]:
    """Every hand-written page, the README files and the guide for contributors."""
    written = (page for page in DOCS.rglob("*.md") if not {"_generated", "_build"} & set(page.parts))
    return [*sorted(written), ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "examples" / "README.md"]


def blocks(page: Path) -> list[Block]:
    """All fenced blocks of a page."""
    return list(_blocks(page.read_text(encoding="utf-8").splitlines()))


def _blocks(lines: list[str]) -> Iterator[Block]:
    number = 0
    while number < len(lines):
        opening = _FENCE.match(lines[number])
        if opening is None:
            number += 1
            continue
        start, indent = number, len(opening["indent"])
        number += 1
        while lines[number].strip() != opening["ticks"]:
            number += 1
        text = "".join(line[indent:] + "\n" for line in lines[start + 1 : number])
        comment = _COMMENT.match(lines[start - 1]) if start else None
        said = {comment["what"]: comment["value"]} if comment else {}
        yield Block(start + 1, opening["language"], text, said.get("file", ""), said.get("output of", ""))
        number += 1


def steps(block: Block) -> list[Step]:
    """The commands of a console block."""
    found: list[tuple[str, list[str]]] = []
    for line in block.text.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        else:
            assert found, f"line {block.line}: a console block begins with a command, not with {line!r}"
            found[-1][1].append(line)
    return [Step(command, "".join(f"{line}\n" for line in shown)) for command, shown in found]
