"""What every file has, whatever it describes."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Literal, Self

from pydantic import Field, PrivateAttr

from babbitt.cases.part import Part

if TYPE_CHECKING:
    from babbitt.cases.designs import EveryDesign


class CaseFile(Part):
    """A whole file: the version of its language, and its text."""

    babbitt: Literal[1] = Field(1, description="Version of the case language.")

    _text: str = PrivateAttr("")
    _files: tuple[FilePath, ...] = PrivateAttr(())

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

    def designs(self) -> tuple[EveryDesign, ...]:
        """Give what is to be computed, numbers in SI and all choices made; none for the statics of a shaft."""
        return ()
