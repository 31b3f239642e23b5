"""The title block of a report as plain data: what it is of, who signs it, what was changed."""

from __future__ import annotations

import datetime
from collections.abc import Iterable
from typing import Any

from pydantic import ValidationError

from babbitt.case.loading import problems_of
from babbitt.case.parts.title_block import TitleBlock
from babbitt.case.problems import CaseError, Problem
from babbitt.core.language import translated
from babbitt.report.text import plain_text

__all__ = ["title_block_of_options", "title_content"]

Data = dict[str, Any]

ROWS = (
    ("Project", "project"),
    ("Client", "client"),
    ("Document", "number"),
    ("Revision", "index"),
)
"""Labels of the title block and where their words stand; the date of calculation follows them."""

SIGNATURES = (("Prepared", "author"), ("Checked", "checker"), ("Approved", "approver"))


def title_content(block: TitleBlock | None, today: datetime.date) -> Data:
    """What the template shows of a title block; without one the date and the lines to sign.

    Parameters
    ----------
    block : TitleBlock or None
    today : date
        Of the run, where the block has no date.

    Examples
    --------
    >>> made = title_content(TitleBlock(number="B-17", author="A. Smith"), datetime.date(2026, 11, 27))
    >>> [(row["label"], row["value"]) for row in made["rows"]], made["signatures"][0]
    ([('Document', 'B-17'), ('Date of calculation', '2026-11-27')], {'what': 'Prepared', 'who': 'A. Smith'})
    """
    block = block or TitleBlock()
    rows = [(label, getattr(block, name) or "") for label, name in ROWS]
    rows.append(("Date of calculation", block.date or today.isoformat()))
    return {
        "rows": [{"label": translated(label), "value": plain_text(value)} for label, value in rows if value],
        "signatures": [
            {"what": translated(what), "who": plain_text(getattr(block, name) or "")} for what, name in SIGNATURES
        ],
        "revisions": [
            [plain_text(word or "") for word in (one.revision, one.date, one.change, one.author)]
            for one in block.revisions
        ],
        "mark": plain_text(
            " ".join(filter(None, (block.number, block.index and translated("rev. {index}", index=block.index))))
        ),
        "logo": _logo(block),
    }


def _logo(block: TitleBlock) -> Data | None:
    if not block.picture:
        return None
    return {"bytes": list(block.picture), "format": block.picture_format}


def title_block_of_options(block: TitleBlock | None, options: Iterable[str]) -> TitleBlock:
    """The title block of a case with fields that a command line gives as ``FIELD=VALUE``.

    Raises
    ------
    CaseError
        For an option without a value, and for fields or values that the block does not take.
    """
    given: dict[str, str] = {}
    for option in options:
        field, equals, value = option.partition("=")
        if not equals:
            allowed, hint = "FIELD=VALUE, such as revision=B", "put it in quotes where it has blanks"
            raise CaseError([Problem("--document", 0, "", f"{option!r} has no value", allowed=allowed, hint=hint)])
        given[field.strip()] = value.strip()
    if "logo" in given:
        says, allowed = "logo names a file, which is sought from the case", "document: {logo: ...} in the case"
        raise CaseError([Problem("--document", 0, "logo", says, allowed=allowed)])
    own = {} if block is None else block.model_dump(exclude_unset=True)
    try:
        made = TitleBlock.model_validate(own | given)
    except ValidationError as error:
        problems = problems_of(error.errors(include_url=False), own | given, "--document")
        raise CaseError(problems) from None
    return made if block is None else made.with_picture_of(block)
