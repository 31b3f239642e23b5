"""The table of `babbitt validate`: published, computed, difference, tolerance, verdict."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.table import Table

from babbitt.report.table import console
from babbitt.validation import Evidence, summary

if TYPE_CHECKING:
    from babbitt.validation import ValidationCase


_PLURALS = {
    Evidence.VALIDATION: "validations",
    Evidence.REPRODUCTION: "reproductions",
    Evidence.REGRESSION: "own values, regression",
}


def print_validation(case: ValidationCase) -> bool:
    """Run a published case, print it side by side, and say whether every judged value agrees."""
    rows = case.rows
    table = Table(title=f"{case.name}: {case.title}", title_justify="left", title_style="bold")
    for column in ("quantity", "unit", "reference", "computed", "difference", "tolerance", "verdict"):
        table.add_column(column, justify="left" if column in ("quantity", "unit", "verdict") else "right")
    for row in rows:
        table.add_row(*row.cells())
    to = console()
    to.print(table)
    for row in rows:
        if row.suspect:
            to.print(f"  set aside: {row.label}. {row.suspect}", markup=False)
    to.print(summary(rows, case.evidence).sentence, markup=False)
    to.print()
    return all(row.ok for row in rows)


def print_count(chosen: Sequence[ValidationCase], agreed: Sequence[bool]) -> None:
    """Say how many validations agree, and apart from them how many reproductions and regressions."""
    words = []
    for evidence in Evidence:
        found = [ok for case, ok in zip(chosen, agreed, strict=True) if case.evidence is evidence]
        if found:
            words.append(f"{_PLURALS[evidence]}: {sum(found)} of {len(found)} agree")
    console().print("; ".join(words) + ".", markup=False)
