"""Small pieces of Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def table(headings: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table of text cells.

    >>> print(table(["name", "unit"], [["load", "N"]]))
    | name | unit |
    | --- | --- |
    | load | N |
    <BLANKLINE>
    """
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join("| " + " | ".join(cell.replace("\n", " ") for cell in line) + " |\n" for line in lines)


def text(words: str) -> str:
    """Words that shall not be taken for Markdown, except for `code`.

    >>> text("h_min < 3*x | `a_b`")
    'h\\\\_min &lt; 3\\\\*x \\\\| `a_b`'
    """
    pieces = words.split("`")
    escaped = (piece if index % 2 else _escape(piece) for index, piece in enumerate(pieces))
    return "`".join(escaped)


def _escape(words: str) -> str:
    for character in "\\*_|[]{}$":
        words = words.replace(character, "\\" + character)
    return words.replace("<", "&lt;").replace("~", "\\~")


def code(words: object) -> str:
    """A name or a value as code, also inside a table."""
    return f"`{words}`".replace("|", "\\|")


def anchor(name: str) -> str:
    """A target that other pages can link to."""
    return f"({name})=\n"
