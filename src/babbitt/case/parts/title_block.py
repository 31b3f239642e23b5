"""The `document` block of a case: title block of its report (fields after ISO 7200), signatures, revisions."""

from __future__ import annotations

import datetime
from collections.abc import Iterator
from typing import Annotated, Literal, Self

from pydantic import AfterValidator, Field, PrivateAttr

from babbitt.case.error_messages import Path
from babbitt.case.named_files import NamedFiles, TableError
from babbitt.case.part import Issue, Part, is_given, rule
from babbitt.case.parts.fields import Name
from babbitt.core.units import QuantityError

__all__ = ["RevisionEntry", "TitleBlock"]

LARGEST_LOGO = 500_000
"""Bytes."""

EXAMPLE_LOGO = "a picture as .svg or .png in the folder of the case"

PNG = b"\x89PNG\r\n\x1a\n"
"""First bytes of every such file (ISO/IEC 15948)."""


def _date(given: str) -> str:
    try:
        return datetime.date.fromisoformat(given).isoformat()
    except ValueError:
        raise QuantityError(f"{given!r} is no date", "year, month and day as in 2026-11-27") from None


Date = Annotated[str, AfterValidator(_date)]
"""A calendar date (ISO 8601)."""


class RevisionEntry(Part):
    """One line of the history of changes."""

    revision: Name = Field(description="Its index, such as B.")
    date: Date | None = Field(None, description="When it was issued, such as 2026-11-27.")
    change: Name = Field(description="What was changed.")
    author: Name | None = Field(None, description="Who changed it.")


class TitleBlock(Part):
    """What a report says of itself; nothing of it enters the calculation or the hash of the case."""

    language: Literal["en", "de", "ru"] | None = Field(
        None, description="Of the report: English, German or Russian; en if not given."
    )
    project: Name | None = Field(None, description="What the bearing is for.")
    client: Name | None = Field(None, description="Whom the report is for.")
    number: Name | None = Field(None, description="Of the document.")
    revision: Name | None = Field(None, description="Its index, such as B; the last of revisions if not given.")
    author: Name | None = Field(None, description="Who prepared it; stands at the line to sign.")
    checker: Name | None = Field(None, description="Who checks it; stands at the line to sign.")
    approver: Name | None = Field(None, description="Who approves it; stands at the line to sign.")
    date: Date | None = Field(
        None, description="Of the calculation, such as 2026-11-27; if not given, of the run."
    )
    logo: Name | None = Field(None, description="A picture in the folder of the case, .svg or .png.")
    revisions: tuple[RevisionEntry, ...] = Field((), max_length=40, description="What was changed, oldest first.")

    _picture: bytes = PrivateAttr(b"")

    @rule
    def _last_revision(self) -> Iterator[Issue]:
        if self.revisions and is_given(self, "revision") and self.revision != self.revisions[-1].revision:
            says = f"is {self.revision}, and the last of revisions is {self.revisions[-1].revision}"
            yield Issue(("revision",), says, "the index of the last revision", "leave it out", code="E004")

    @rule
    def _order_of_revisions(self) -> Iterator[Issue]:
        first: dict[str, int] = {}
        latest = ""
        for place, one in enumerate(self.revisions):
            if (before := first.setdefault(one.revision, place)) != place:
                says = f"is {one.revision}, as is that of entry {before + 1}"
                yield Issue(("revisions", place, "revision"), says, "each index once", code="E004")
            if one.date is not None and one.date < latest:
                says = f"is {one.date}, and an entry before it has {latest}"
                hint = "put the oldest entry first, or correct the date"
                yield Issue(("revisions", place, "date"), says, "dates that do not fall", hint, code="E004")
            latest = max(latest, one.date or "")

    @property
    def index(self) -> str | None:
        """The index of the revision."""
        return self.revision or (self.revisions[-1].revision if self.revisions else None)

    @property
    def picture(self) -> bytes:
        """The logo; empty where there is none."""
        return self._picture

    @property
    def picture_format(self) -> str:
        """Of the logo: png or svg."""
        return "png" if self._picture.startswith(PNG) else "svg"

    def with_picture(self, files: NamedFiles, at: Path) -> Self:
        """Give the same block with the logo that it names.

        Raises
        ------
        TableError
            For a file that cannot be used.
        """
        if self.logo is None:
            return self
        content = files.content(self.logo, at, LARGEST_LOGO, EXAMPLE_LOGO)
        if not content.startswith(PNG) and b"<svg" not in content[:1000]:
            raise TableError(at, f"{self.logo} is neither PNG nor SVG", EXAMPLE_LOGO)
        return self._with(content)

    def with_picture_of(self, other: TitleBlock) -> Self:
        """Give the same block with the logo of another one."""
        return self._with(other.picture)

    def _with(self, picture: bytes) -> Self:
        block = self.model_copy()
        block._picture = picture
        return block
