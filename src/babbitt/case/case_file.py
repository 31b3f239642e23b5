"""What every file has, whatever it describes."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, Literal, Self

from pydantic import Field, PrivateAttr

from babbitt.case.named_files import NamedFiles
from babbitt.case.part import Part
from babbitt.case.parts.study import StudyBlock
from babbitt.case.parts.title_block import TitleBlock
from babbitt.core.files.reading import Reach
from babbitt.core.solution import Calculation


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
    _study: StudyBlock | None = PrivateAttr(None)
    _title_block: TitleBlock | None = PrivateAttr(None)

    if TYPE_CHECKING:  # fields of every kind, each with its own description

        @property
        def kind(self) -> str:
            """What the file describes."""

        @property
        def name(self) -> str:
            """Of the bearing, machine or shaft."""

        @property
        def notes(self) -> str:
            """To be shown in the report."""

        @property
        def source(self) -> str:
            """Where the numbers come from."""

        @property
        def assumptions(self) -> tuple[str, ...]:
            """To be shown in the report."""

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

    @property
    def study_block(self) -> StudyBlock | None:
        """The study that stands beside the case in its file; it changes nothing of the case."""
        return self._study

    def with_study(self, study: StudyBlock) -> Self:
        """Give the same case with a study of it."""
        case = self.model_copy()
        case._study = study
        return case

    @property
    def title_block(self) -> TitleBlock | None:
        """What the report of the case says of itself; it changes nothing of the case."""
        return self._title_block

    def with_title_block(self, block: TitleBlock) -> Self:
        """Give the same case with the title block of its report."""
        case = self.model_copy()
        case._title_block = block
        return case

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Give a copy; one with other values no longer has the text that says others."""
        copy = super().model_copy(update=update, deep=deep)
        if update:
            copy._text = ""
        return copy

    @classmethod
    def with_named_files(cls, given: dict[str, Any], files: NamedFiles) -> dict[str, Any]:
        """Put what stands in the files that a case names in their place; here no field names one.

        Parameters
        ----------
        given : dict
            A case as it stands in the file; it is not changed.
        files : NamedFiles
            What the case may read.

        Raises
        ------
        TableError
            For the first file that cannot be used.
        """
        return given

    def complete(self) -> Self:
        """Give the case as it can be solved; what was read from a file is.

        Raises
        ------
        CaseError
            With what is missing, of a case that a program makes step by step.
        """
        return self

    @abstractmethod
    def calculations(self) -> tuple[Calculation, ...]:
        """Give what is to be computed and how: numbers in SI, all choices made, in the order of the file."""

    def problems(self) -> tuple[Any, ...]:
        """Give what is to be computed, without how."""
        return tuple(one.problem for one in self.calculations())
