"""Published cases on the page: which there are, and how they do when they are run here."""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.app.answer import Table
from babbitt.app.progress import followed
from babbitt.core.language import translated
from babbitt.validation import ValidationCase, cases, summary, validation_case

__all__ = ["published", "scoreboard"]

HEADS = ("case", "what it shows", "title")


def published() -> Table:
    """All published cases."""
    return Table(
        "",
        tuple(map(translated, HEADS)),
        tuple((one.name, translated(one.evidence.value), one.title) for one in cases()),
        words=3,
    )


def scoreboard(names: Sequence[str], progress: str) -> tuple[Table, ...]:
    """Run published cases: for several a row for each, for one case every value beside ours.

    Parameters
    ----------
    names : sequence of str
    progress : str
        File for `babbitt.app.progress`.
    """
    chosen = [validation_case(name) for name in names]
    if len(chosen) == 1:
        return (next(_values(one) for one in followed(chosen, progress)),)
    rows = []
    for one in followed(chosen, progress):
        found = summary(one.rows, one.evidence)
        rows.append((one.name, translated(one.evidence.value), found.sentence))
    return (Table("", tuple(map(translated, (*HEADS[:2], "how it does"))), tuple(rows), words=3),)


def _values(case: ValidationCase) -> Table:
    rows = case.rows
    names = ("quantity", "unit", "reference value", "computed", "difference", "tolerance", "verdict")
    heads = tuple(map(translated, names))
    remarks = (summary(rows, case.evidence).sentence, case.story.source)
    return Table(case.title, heads, tuple(row.cells() for row in rows), remarks, words=2)
