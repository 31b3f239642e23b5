"""What every file has, whatever it describes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Self

from pydantic import Field, PrivateAttr

from babbitt.cases.part import Part

if TYPE_CHECKING:
    from babbitt.cases.designs import EveryDesign


class CaseFile(Part):
    """A whole file: the version of its language, and its text."""

    babbitt: Literal[1] = Field(1, description="Version of the case language.")

    _text: str = PrivateAttr("")

    @property
    def text(self) -> str:
        """The text that the case was read from; empty for a case from a dictionary."""
        return self._text

    def with_text(self, text: str) -> Self:
        """Give the same case with the text that it was read from."""
        case = self.model_copy()
        case._text = text
        return case

    def designs(self) -> tuple[EveryDesign, ...]:
        """Give what is to be computed, numbers in SI and all choices made; none for the statics of a shaft."""
        return ()
