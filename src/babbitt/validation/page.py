"""The documentation page of a published case, in MyST Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from babbitt.validation.case import Comparison, Evidence, ValidationCase
from babbitt.validation.figure import figure_file
from babbitt.validation.summary import Summary, by_quantity, summary

_COLUMNS = ("quantity", "unit", "published", "computed", "difference", "tolerance", "verdict", "source")
_QUANTITY_COLUMNS = (
    "quantity",
    "values",
    "judged",
    "tolerance of the worst",
    "largest deviation / tolerance",
    "at",
)


FITTED = (
    "**A reproduction, no validation.** The source leaves inputs open; they were fitted to the values that are "
    "compared here. Agreement shows that one set of inputs gives them all."
)


OWN = (
    "**Own values, regression, no validation.** The reference is ours: another solver or program, or a relation "
    "between our own values. Agreement shows that both say the same and that nothing changed."
)
REMARKS = {Evidence.REPRODUCTION: FITTED, Evidence.REGRESSION: OWN}


def page(case: ValidationCase) -> str:
    """Write the page of a case: story, summary, figure and all values side by side.

    Parameters
    ----------
    case : ValidationCase
        Is run.

    Returns
    -------
    str
        MyST Markdown; the figure is expected beside the page under the name `figure_file` gives.
    """
    rows = case.rows
    story = case.story
    parts = [
        f"# {case.title}",
        story.what,
        *([REMARKS[case.evidence]] if case.evidence in REMARKS else []),
        f"**{summary(rows, case.evidence).sentence}** Repeat it with `babbitt validate {case.name}`.",
        f"```{{figure}} {figure_file(case)}\n:alt: {case.title}\n\n{case.caption}\n```",
        f"## Source\n\n{story.source}",
        f"## Assumptions\n\n{story.assumptions}",
        f"## Tolerances\n\n{story.tolerances}",
        f"## What differs, and why\n\n{story.differences}",
        f"## Largest deviations\n\n{_quantity_table(rows)}",
        f"## Side by side\n\n{_side_by_side(rows)}",
        *_notes(rows),
    ]
    return "\n\n".join(parts) + "\n"


def _side_by_side(rows: Sequence[Comparison]) -> str:
    return _table(_COLUMNS, ((*row.cells(), row.source) for row in rows), right=range(2, 6))


def _quantity_table(rows: Sequence[Comparison]) -> str:
    lines = (_quantity_line(name, each) for name, each in by_quantity(rows).items())
    return _table(_QUANTITY_COLUMNS, lines, right=range(1, 5))


def _quantity_line(name: str, each: Summary) -> tuple[str, ...]:
    counts = (name, str(each.values), str(each.judged))
    if each.worst is None or each.worst.tolerance is None:
        return (*counts, "–", "–", "–")
    return (*counts, each.worst.tolerance.describe(), f"{each.largest_share:.2f}", each.worst.place)


def _notes(rows: Sequence[Comparison]) -> list[str]:
    """What is said about single rows, each reason once."""
    places: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        if row.note:
            places.setdefault((row.verdict.value, row.note), []).append(row.label)
    if not places:
        return []
    lines = [f"- {'; '.join(labels)} ({verdict}): {note}" for (verdict, note), labels in places.items()]
    return ["## Notes on single rows\n\n" + "\n".join(lines)]


def _table(columns: Sequence[str], lines: Iterable[Sequence[str]], right: range) -> str:
    rule = ["---:" if place in right else ":---" for place in range(len(columns))]
    return "\n".join(f"| {' | '.join(map(_cell, line))} |" for line in (columns, rule, *lines))


def _cell(text: str) -> str:
    return text.replace("|", "\\|")
