"""What every file has, whatever it describes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, Literal, Self

from pydantic import Field, PrivateAttr

from babbitt.case.part import Part
from babbitt.core.files.reading import Reach

if TYPE_CHECKING:
    from babbitt.case.designs import EveryDesign


@dataclass(frozen=True)
class Origin:
    """What a case was read from.

    Attributes
    ----------
    given : Mapping
        What stood in the file, text or dictionary.
    file : Path
        The file; for other cases what messages call it, in the folder from which files are named.
    reach : Reach
        Where the case may name other files.
    """

    given: Mapping[str, Any]
    file: FilePath
    reach: Reach


class CaseFile(Part):
    """A whole file: the version of its language, and its text."""

    babbitt: Literal[1] = Field(1, description="Version of the case language.")

    _text: str = PrivateAttr("")
    _files: tuple[FilePath, ...] = PrivateAttr(())
    _origin: Origin | None = PrivateAttr(None)

    @property
    def text(self) -> str:
        """The text that the case was read from; empty for a case from a dictionary."""
        return self._text

    def with_text(self, text: str) -> Self:
        """Give the same case with the text that it was read from."""
        case = self.model_copy()
        case._text = text
        return case

    @property
    def files(self) -> tuple[FilePath, ...]:
        """The files that the case names and that were read with it."""
        return self._files

    def with_files(self, files: tuple[FilePath, ...]) -> Self:
        """Give the same case with the files that were read with it."""
        case = self.model_copy()
        case._files = files
        return case

    @property
    def origin(self) -> Origin | None:
        """What the case was read from; None for a case that a program made of its classes."""
        return self._origin

    def with_origin(self, origin: Origin) -> Self:
        """Give the same case with what it was read from."""
        case = self.model_copy()
        case._origin = origin
        return case

    def designs(self) -> tuple[EveryDesign, ...]:
        """Give what is to be computed, numbers in SI and all choices made; none for the statics of a shaft."""
        return ()
