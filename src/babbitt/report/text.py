"""Text that came from a case file, made safe to show."""

from __future__ import annotations

import re
import unicodedata

from babbitt.core.language import plural

_DIRECTION_MARKS = {chr(c) for c in (*range(0x202A, 0x202F), *range(0x2066, 0x206A), 0x200E, 0x200F, 0x061C)}
_TYPEFACE_RANGES = (
    (0x0020, 0x0530),  # Latin, Greek, Cyrillic
    (0x0590, 0x0600),  # Hebrew
    (0x1E00, 0x2000),  # Latin and Greek with marks
    (0x2000, 0x2200),  # punctuation, sub- and superscripts, letter-like
    (0x2200, 0x2300),  # mathematical operators
    (0xFB00, 0xFB07),  # ligatures
)
"""Blocks that the typefaces inside typst cover."""


def plain_text(text: str) -> str:
    """One line of visible characters: no control characters, no marks that turn the direction of writing.

    What an engineer types stays as it is; what could move a cursor, hide a word or break a file format goes.

    >>> plain_text("Pinion\\x1b[31m\\t left ")
    'Pinion[31m left'
    """
    if not text.isprintable():
        text = "".join(character for character in text if character.isspace() or _is_visible(character))
    return re.sub(r"\s+", " ", text).strip()


def _is_visible(character: str) -> bool:
    hidden = unicodedata.category(character) in ("Cc", "Cs", "Cn", "Co") or character in _DIRECTION_MARKS
    return not hidden


def needs_system_fonts(text: str) -> bool:
    """Whether a text has characters that only typefaces of the operating system may cover.

    >>> needs_system_fonts("Ψ вал ±5 µm"), needs_system_fonts("轴承")
    (False, True)
    """
    return any(
        not any(first <= ord(character) < end for first, end in _TYPEFACE_RANGES) for character in set(text)
    )


def counted(number: int, noun: str) -> str:
    """A number with its noun.

    >>> counted(1, "bearing"), counted(11, "bearing")
    ('1 bearing', '11 bearings')
    """
    return f"{number} {plural(noun, number)}"


def plain_lines(text: str) -> str:
    """The lines of a file as visible characters: line breaks and indentation stay, tabs become spaces.

    >>> plain_lines("a:\\r\\n\\tb\\x1b[31m")
    'a:\\n    b[31m'
    """
    lines = (line.expandtabs(4) for line in text.splitlines())
    return "\n".join("".join(_plain_character(c) for c in line).rstrip() for line in lines)


def _plain_character(character: str) -> str:
    if character.isspace():
        return " "
    return character if _is_visible(character) else ""
