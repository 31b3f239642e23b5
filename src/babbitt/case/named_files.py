"""Files that a case names: sought from its folder, regular files only, and of bounded size."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path as FilePath
from typing import Any

from babbitt.case.error_messages import Path, shown
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach, UnreadableFileError, read_regular
from babbitt.core.picklable_error import PicklableError

__all__ = ["NamedFiles", "TableError", "with_its_file"]


class TableError(PicklableError):
    """A table that cannot be used: where in the case, what is wrong, what would do."""

    def __init__(self, path: Path, says: str, allowed: str = "", hint: str = "") -> None:
        super().__init__(says)
        self.path, self.says, self.allowed, self.hint = path, says, allowed, hint


class NamedFiles:
    """What a case may read beside its own text.

    Parameters
    ----------
    folder : Path
        What the files are named from.
    reach : Reach

    Attributes
    ----------
    taken : list of Path
        The files that were read, in their order.
    """

    def __init__(self, folder: FilePath, reach: Reach = Reach.FOLDER) -> None:
        self.folder, self.reach = folder, reach
        self.taken: list[FilePath] = []

    def content(self, name: str, at: Path, largest: int, example: str) -> bytes:
        """The bytes of a file.

        Parameters
        ----------
        name : str
            As it stands in the case.
        at : tuple
            Where in the case it stands.
        largest : int
            Bytes that are accepted.
        example : str
            What would do.

        Raises
        ------
        TableError
            For a file that is missing or not readable, not a regular file, too large, or out of reach.
        """
        file = self.folder / name
        if self.reach is Reach.NOWHERE:
            raise TableError(at, "a case may name no files here", "the numbers themselves, pasted in their place")
        try:
            if "\0" not in name and self.reach is Reach.FOLDER and not self._is_within(file):
                raise TableError(
                    at,
                    f"{printable(name)} lies outside the folder of the case",
                    "a file in the folder of the case or below it",
                    "copy it there, or add --allow-outside if you trust this case",
                )
            content = read_regular(file, largest)
        except UnreadableFileError as error:
            says = f"{error.says}: {printable(file)}" if error.missing else f"{printable(name)} {error.says}"
            raise TableError(at, says, example) from None
        except OSError as error:  # a ring of links, a name that is too long
            says = f"{printable(name)} cannot be read ({error.strerror or error})"
            raise TableError(at, says, example) from None
        except RuntimeError:  # a ring of links, up to Python 3.12
            raise TableError(at, f"{printable(name)} cannot be read", example) from None
        self.taken.append(file)
        return content

    def text(self, name: str, at: Path, largest: int, example: str) -> str:
        """The text of a UTF-8 file; raises as `content`."""
        try:
            return self.content(name, at, largest, example).decode("utf-8-sig")
        except UnicodeDecodeError:
            raise TableError(at, f"{printable(name)} is not text in UTF-8", example) from None

    def _is_within(self, file: FilePath) -> bool:
        """Whether a file lies below the folder once every link is followed."""
        return file.resolve().is_relative_to(self.folder.resolve())


def with_its_file(
    part: dict[str, Any], at: Path, example: str, read: Callable[[str, Path], dict[str, Any]]
) -> dict[str, Any]:
    """A part of a case with what is read from its ``file`` in place of the name.

    Parameters
    ----------
    part : dict
        As it stands in the case, which it does at ``at``; it is not changed.
    at : tuple
    example : str
        What would do.
    read : callable
        Name of the file, and where in the case it stands -> fields.

    Raises
    ------
    TableError
        For what is not the name of a file that can be used.
    """
    name, at = part["file"], (*at, "file")
    if not isinstance(name, str):
        raise TableError(at, f"{shown(name)} is not the name of a file", example)
    return {field: value for field, value in part.items() if field != "file"} | read(name, at)
