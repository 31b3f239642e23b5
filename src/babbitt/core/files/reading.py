"""Regular files, read with a bound on their size; a pipe or a device is never waited for."""

from __future__ import annotations

import os
import stat
from enum import Enum
from pathlib import Path

from babbitt.core.files.printing import printable
from babbitt.core.notices import InputError
from babbitt.core.picklable_error import PicklableError

__all__ = ["LARGEST_TEXT", "Reach", "UnreadableFileError", "read_regular", "read_text"]

LARGEST_TEXT = 50_000_000
"""Bytes of a table of coefficients; ten thousand speeds take about two million."""


class Reach(Enum):
    """Where a case may name files."""

    NOWHERE = "nowhere"
    FOLDER = "in the folder of the case and below it"
    ANYWHERE = "anywhere"


class UnreadableFileError(PicklableError):
    """A file that cannot be read; `says` tells why, without its name.

    Attributes
    ----------
    says : str
    missing : bool
        Whether there is no such file.
    """

    def __init__(self, says: str, missing: bool = False) -> None:
        super().__init__(says)
        self.says, self.missing = says, missing


def read_regular(path: str | Path, largest: int) -> bytes:
    """The content of a regular file.

    Parameters
    ----------
    path : str or Path
    largest : int
        Bytes that are accepted.

    Raises
    ------
    UnreadableFileError
        For a name that no file can have, a file that is missing or not readable, a folder, a pipe or a device, and
        a file that is too large.
    """
    if "\0" in str(path):
        raise UnreadableFileError("the name holds a null character", missing=True)
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    try:
        handle = os.open(path, flags)  # a pipe is opened without waiting for a writer, and refused below
    except FileNotFoundError:
        raise UnreadableFileError("there is no such file", missing=True) from None
    except OSError as error:
        raise UnreadableFileError(f"cannot be read ({error.strerror or error})") from None
    with os.fdopen(handle, "rb") as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise UnreadableFileError("is not a regular file")
        try:
            content = file.read(largest + 1)
        except OSError as error:
            raise UnreadableFileError(f"cannot be read ({error.strerror or error})") from None
    if len(content) > largest:
        raise UnreadableFileError(f"is larger than {_size(largest)}")
    return content


def read_text(path: str | Path, largest: int = LARGEST_TEXT) -> str:
    """The text of a UTF-8 file.

    Raises
    ------
    InputError
        E001 when it cannot be read.
    """
    try:
        return read_regular(path, largest).decode("utf-8-sig")
    except UnreadableFileError as error:
        raise InputError("E001", f"{printable(path)}: {error.says}") from None
    except UnicodeDecodeError:
        raise InputError("E001", f"{printable(path)}: is not a text file in UTF-8") from None


def _size(count: int) -> str:
    """Bytes in words.

    >>> _size(1_000_000), _size(100_000)
    ('1 MB', '100 kB')
    """
    return f"{count // 1_000_000} MB" if count >= 1_000_000 else f"{count // 1000} kB"
