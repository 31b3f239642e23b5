"""The tables of a study on the screen."""

from __future__ import annotations

from rich.console import Console
from rich.table import Table
from rich.text import Text

from babbitt.report.bearing_table import engineers_table
from babbitt.report.study_content import StudyTable, overview, study_tables
from babbitt.report.table import console_for
from babbitt.report.text import plain_text
from babbitt.study.study import Study

__all__ = ["print_study"]


def print_study(study: Study, to: Console | None = None) -> None:
    """Print the name of the case, what was computed, and the tables of the study."""
    tables = study_tables(study)
    if to is None:
        to = console_for(max((_drawn(one) for one in tables), key=lambda one: len(one.columns)))
    to.print(Text(plain_text(str(study.description["name"])), style="bold"))
    to.print(Text(overview(study)))
    for one in tables:
        to.print()
        to.print(_drawn(one))
        for note in one.notes:
            to.print(Text(note, style="dim"))


def _drawn(table: StudyTable) -> Table:
    made = engineers_table(title=Text(table.title, style="bold"), title_justify="left")
    units = any(unit for _, unit in table.columns)
    for place, (name, unit) in enumerate(table.columns):
        heading = Text(f"{name}\n{unit}" if units else name)
        if place < table.words:
            made.add_column(heading, overflow="fold")
        else:
            made.add_column(heading, justify="right", overflow="fold")
    for row in table.rows:
        made.add_row(*(Text(cell) for cell in row))
    return made
