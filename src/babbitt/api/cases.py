"""Case files and text as objects of the Python front door."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from babbitt import case
from babbitt.api.bearings import public_case
from babbitt.core.files.reading import Reach

__all__ = ["load_case", "parse_case"]


def load_case(path: str | Path, reach: Reach = Reach.FOLDER) -> Any:
    """Read a case file: a bearing of the class of its kind, such as `babbitt.JournalBearing`.

    Parameters
    ----------
    path : str or Path
        A YAML or JSON file in UTF-8 of at most 1 MB.
    reach : Reach
        Where it may name other files.

    Raises
    ------
    CaseError
        With every problem of the file.
    """
    return public_case(case.load_case(path, reach))


def parse_case(text: str, name: str = "<text>", reach: Reach = Reach.FOLDER) -> Any:
    """Read a case from text, as `load_case` from a file.

    Parameters
    ----------
    text : str
        YAML or JSON.
    name : str
        What to call the text in messages.
    reach : Reach
        Where it may name other files.

    Raises
    ------
    CaseError
        With every problem of the text.
    """
    return public_case(case.parse_case(text, name, reach))
