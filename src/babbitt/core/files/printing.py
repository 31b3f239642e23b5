"""Names and texts from outside, made safe to print on any output."""

from __future__ import annotations

import codecs
import unicodedata
from typing import Any

__all__ = ["nearest_letters", "nearest_lines", "printable", "printable_lines", "takes_all_letters"]

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


_NEAREST = {
    "µ": "u", "μ": "u", "°": "deg", "‰": "permille", "±": "+-", "×": "x", "·": "*", "–": "-",
    "—": "-", "−": "-", "…": "...", "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "√": "sqrt", "∞": "inf",
}  # fmt: skip
"""ASCII for what an older encoding lacks; a unit must not lose its prefix."""

_HANDLER = "babbitt-nearest-letters"


def nearest_letters(stream: Any) -> None:
    """Let a stream write the nearest ASCII letters in place of those that its encoding lacks."""
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None:
        reconfigure(errors=_HANDLER)


def nearest_lines(text: str, encoding: str) -> str:
    """A text with the nearest ASCII letters for those that an encoding lacks; columns stay where they are.

    >>> print(nearest_lines("ψ_eff  |1.2  |‰        |\\nD      |120  |mm       |", "ascii"))
    psi_eff|1.2  |permille |
    D      |120  |mm       |
    """
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return "\n".join(_nearest_line(line, encoding) for line in text.split("\n"))
    return text


def _nearest_line(line: str, encoding: str) -> str:
    """A line in which spaces that fill a column make room for letters that take more than one place."""
    written, due = "", 0
    for place, character in enumerate(line):
        fills = character == " " and (line[place + 1 : place + 2] in (" ", "|", "") or written.endswith(" "))
        if due > 0 and fills:
            due -= 1
            continue
        try:
            character.encode(encoding)
        except UnicodeEncodeError:
            near = _nearest(character)
            due += len(near) - (0 if unicodedata.combining(character) else 1)
            written += near
        else:
            written += character
    return written


def takes_all_letters(stream: Any) -> bool:
    """Whether a stream is in UTF-8; JSON for another one needs escapes."""
    return (getattr(stream, "encoding", None) or "utf-8").lower().replace("-", "").startswith("utf8")


def _in_ascii(text: str) -> str:
    """The nearest ASCII letters.

    >>> _in_ascii("ψ = 1 ‰ at 20 °C, 3 µm²: Öl, p̄"), _in_ascii("≤ Δ 轴")
    ('psi = 1 permille at 20 degC, 3 um2: Ol, p', '<= Delta ?')
    """
    return "".join(_nearest(character) for character in text)


def _nearest(character: str) -> str:
    if character.isascii():
        return character
    if character in _NEAREST:
        return _NEAREST[character]
    if not character.isprintable():
        return _visible(character)
    if unicodedata.combining(character):
        return ""
    words = unicodedata.name(character, "").split()
    if words[:2] in (["GREEK", "SMALL"], ["GREEK", "CAPITAL"]) and words[2] == "LETTER":
        return words[3].lower() if words[1] == "SMALL" else words[3].capitalize()
    plain = unicodedata.normalize("NFKD", character)
    return "".join(_nearest(part) for part in plain) if plain != character else "?"


def _replace(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return _in_ascii(error.object[error.start : error.end]), error.end


codecs.register_error(_HANDLER, _replace)
