"""What `babbitt list` prints: lubricants, materials, units, kinds of case, published cases."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rich.markup import escape
from rich.table import Table

from babbitt.core.files.printing import printable_lines
from babbitt.report.catalogue_tables import (
    LUBRICANT_HEADS,
    METAL_HEADS,
    STRUCTURAL_HEADS,
    lubricant_rows,
    metal_rows,
    structural_rows,
)
from babbitt.report.table import console


def print_lubricants() -> None:
    """Lubricants of the catalogue with viscosity, density and source."""
    console().print(_filled(LUBRICANT_HEADS, lubricant_rows()))


def print_materials() -> None:
    """Bearing metals with their limits, then shaft and housing materials."""
    to = console()
    to.print(_filled(METAL_HEADS, metal_rows()))
    to.print(_filled(STRUCTURAL_HEADS, structural_rows()))


def print_kinds() -> None:
    """Kinds of case that `babbitt new` writes."""
    from babbitt.case import kinds

    table = _table("kind", "describes")
    for name, meaning in kinds().items():
        table.add_row(name, meaning)
    console().print(table)


def print_units() -> None:
    """Kinds of quantities with the units that a case file may use."""
    from babbitt.core.units import KINDS

    table = _table("kind", "example", "units")
    for kind in KINDS.values():
        table.add_row(kind.phrase, kind.example, ", ".join(unit for unit in kind.everyday if unit))
    console().print(table)


def print_cases() -> None:
    """Published cases that `babbitt validate` runs."""
    from babbitt.validation import cases

    table = _table("case", "kind", "title", "source")
    for case in cases():
        table.add_row(case.name, case.evidence.value, case.title, case.story.source)
    console().print(table)


def _filled(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> Table:
    """A table whose last column is the source."""
    table = _table(*heads)
    for *cells, source in rows:
        table.add_row(*cells, escape(printable_lines(source)))
    return table


def _table(*columns: str) -> Table:
    table = Table()
    for column in columns:
        table.add_column(column)
    return table
