"""Text files, with errors that say what to do."""

from __future__ import annotations

from pathlib import Path

from babbitt.notices import InputError


def read_text(path: str | Path) -> str:
    """The text of a UTF-8 file.

    Raises
    ------
    InputError
        E001 when it cannot be read.
    """
    try:
        return Path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise InputError("E001", f"{path}: cannot be read ({error.strerror})") from None
    except UnicodeDecodeError:
        raise InputError("E001", f"{path}: is not a text file in UTF-8") from None


def write_text(path: str | Path, text: str) -> None:
    """Write a UTF-8 file with the line ends as they stand in the text.

    Raises
    ------
    InputError
        E007 when it cannot be written.
    """
    try:
        Path(path).write_text(text, encoding="utf-8", newline="")
    except OSError as error:
        raise InputError("E007", f"{path}: cannot be written ({error.strerror})") from None
