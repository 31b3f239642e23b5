"""Pages of the published cases: a scoreboard, and one page with table and figure a case."""

from __future__ import annotations

from pathlib import Path
from textwrap import shorten

from babbitt.validation import Evidence, ValidationCase, cases, cases_of, page, save_figure, summary
from babbitt.validation.figure import figure_file
from babbitt_pages.files import write
from babbitt_pages.markdown import text


def scoreboard() -> str:
    """Markdown table of all cases with the outcome of each, and the tree of their pages."""
    lines = [
        *_table(Evidence.VALIDATION),
        "",
        "## Reproductions",
        "",
        "The sources of these leave inputs open, which were fitted to the values compared. Agreement shows that "
        "one set of inputs gives them all; it does not count as validation.",
        "",
        *_table(Evidence.REPRODUCTION),
        "",
        "## Own values, regression",
        "",
        "The references of these are ours: another solver or program, or a relation between our own values. "
        "Agreement shows that both say the same and that nothing changed; it does not count as validation.",
        "",
        *_table(Evidence.REGRESSION),
    ]
    tree = "\n".join(f"/_generated/validation/{case.name}" for case in cases())
    return "\n".join(lines) + f"\n\n```{{toctree}}\n:hidden:\n\n{tree}\n```\n"


def _table(evidence: Evidence) -> list[str]:
    return [
        "| | case and source | judged | set aside | shown only | largest deviation / tolerance | verdict |",
        "| --- | --- | ---: | ---: | ---: | ---: | --- |",
        *(_line(case) for case in cases_of(evidence)),
    ]


def write_pages(target: Path) -> None:
    """Write the page and the figure of every case."""
    for case in cases():
        write(target / f"{case.name}.md", page(case))
        save_figure(case, target)


def _line(case: ValidationCase) -> str:
    found = summary(case.rows, case.evidence)
    agrees = {Evidence.REPRODUCTION: "reproduced", Evidence.REGRESSION: "unchanged"}.get(case.evidence, "agrees")
    verdict = agrees if found.agrees else f"{found.differing} differ" if found.differing else "not judged"
    link = f"[{text(case.title)}](/_generated/validation/{case.name}.md)"
    numbers = (found.judged, found.suspect, found.shown)
    counts = " | ".join(str(number) for number in numbers)
    picture = f"![](/_generated/validation/{figure_file(case)})"
    source = text(shorten(case.story.source, 150, placeholder=" ..."))
    return f"| {picture} | {link}: {source} | {counts} | {found.largest_share:.2f} | {verdict} |"
