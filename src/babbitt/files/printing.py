"""Names and texts from outside, made safe to print."""

from __future__ import annotations

__all__ = ["printable", "printable_lines"]

LONGEST_NAME = 240
"""Characters of a name that a message shows; file systems allow 255 in each part of a path."""


def printable(name: object) -> str:
    """A name on one line in visible characters: what could move a cursor or hide a word is written as its escape.

    >>> printable("table\\x1b[31m.csv")
    'table\\\\x1b[31m.csv'
    >>> printable("Lager ü.yaml")
    'Lager ü.yaml'
    """
    text = "".join(_visible(character) for character in str(name))
    return text if len(text) <= LONGEST_NAME else f"{text[: LONGEST_NAME - 3]}..."


def printable_lines(text: str) -> str:
    """Lines of a message in visible characters; line breaks stay.

    >>> printable_lines("first\\nsecond\\x07")
    'first\\nsecond\\\\x07'
    """
    return "\n".join("".join(_visible(character) for character in line) for line in text.split("\n"))


def _visible(character: str) -> str:
    return character if character.isprintable() else character.encode("unicode_escape", "surrogatepass").decode()
