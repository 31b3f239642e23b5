"""A table of a study: text for the screen, the report and the summary of a workbook alike."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["DASH", "StudyTable"]

DASH = "–"
"""Stands where a table has no value."""


@dataclass(frozen=True)
class StudyTable:
    """A table of text.

    Attributes
    ----------
    title : str
    columns : tuple of (str, str)
        Heading and unit.
    rows : tuple of tuple of str
    words : int
        Columns from the left that hold words; all others hold numbers.
    notes : tuple of str
        Below it.
    """

    title: str
    columns: tuple[tuple[str, str], ...]
    rows: tuple[tuple[str, ...], ...]
    words: int = 1
    notes: tuple[str, ...] = ()
