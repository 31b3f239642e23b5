"""Designs side by side as rows: changed inputs, results with their differences, verdicts and governing checks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from io import StringIO
from textwrap import fill

from rich.console import Console
from rich.table import Table
from rich.text import Text

from babbitt.core.check_text import margin
from babbitt.core.language import decimal, translated
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.result import Result
from babbitt.report.comparison_table import WIDEST_HEAD
from babbitt.report.labels import told_meaning
from babbitt.report.table import PIPED_WIDTH, console
from babbitt.report.text import counted, plain_text
from babbitt.report.units_of_matrices import suited_among
from babbitt.report.us_words import in_us_units
from babbitt.study.designs import ABSENT, ComparedBearing, Designs

__all__ = ["DesignRow", "bearing_rows", "difference", "kinds_said", "print_designs", "short_designs"]

SAME = {"0 %", "+0.0 K", "+0.0 °", "+0,0 K", "+0,0 °"}
"""Differences of results that no design changes, in every language."""

ROUND_OFF = 1e-9
"""Numbers without unit up to which they are what is left of a balance."""

TURNS = ("rad",)
"""SI units of which a share says nothing: angles from an axis."""


@dataclass(frozen=True)
class DesignRow:
    """One line: what it is, its unit, the cells of the designs, differences of all but the first from it."""

    meaning: str
    unit: str
    cells: tuple[str, ...]
    differences: tuple[str, ...]
    name: str = ""


def bearing_rows(bearing: ComparedBearing) -> Iterator[DesignRow]:
    """Results of a bearing in every design, then verdict and governing check."""
    yield from filter(None, (_row(name, bearing) for name in bearing.quantities))
    lines = (
        ("Verdict", [_said(one, translated(one.verdict.value) if one else "") for one in bearing.results]),
        ("Governing check", [_said(one, _governing(one) if one else "") for one in bearing.results]),
        ("Limits missed", [_said(one, _missed(one) if one else "") for one in bearing.results]),
        ("Warnings to the verdict", [_said(one, ", ".join(one.questioning_codes)) if one else ABSENT
                                     for one in bearing.results]),
    )  # fmt: skip
    for said, cells in lines:
        if any(cell not in ("", ABSENT) for cell in cells):
            yield DesignRow(
                translated(said), "", tuple(cell or ABSENT for cell in cells), ("",) * (len(cells) - 1)
            )


def _degree(quantity: Quantity) -> str:
    """Unit of a difference of temperatures or angles."""
    if not quantity.display.offset:
        return "°"
    return "K" if quantity.display.scale == 1.0 else quantity.display.label


def difference(name: str, first: float | None, other: float | None) -> str:
    """How a result differs from that of the first design: in per cent, of temperatures, angles and what may be
    negative in their unit; nothing where tables write both alike.

    >>> difference("friction_power", 2000.0, 1500.0), difference("outlet_temperature", 330.0, 333.0)
    ('-25.0 %', '+3.0 K')
    >>> difference("friction_power", 0.0, 1.0), difference("friction_power", 0.0, 0.0)
    ('–', '0 %')
    >>> difference("journal_y", -41.9e-6, -82.6e-6), difference("load", 9000.00005, 9000.0)
    ('-40.7 µm', '0 %')
    """
    if first is None or other is None or not (math.isfinite(first) and math.isfinite(other)):
        return ABSENT
    quantity = QUANTITIES[name]
    if quantity.display.offset or quantity.unit in TURNS:
        decimals = max(quantity.display.decimals, 1)
        change = round((other - first) * quantity.display.scale, decimals) + 0.0  # no -0
        return decimal(f"{change:+.{decimals}f} {_degree(quantity)}")
    suited = quantity.suited(first, other)
    is_round_off = quantity.unit == "1" and max(abs(first), abs(other)) <= ROUND_OFF
    if is_round_off or suited.format(first) == suited.format(other):
        return "0 %"
    if min(first, other) < 0.0:  # a share of a negative number reads as if it had shrunk
        return f"{'-' if other < first else '+'}{suited.with_unit(abs(other - first))}"
    if first == 0.0:
        return ABSENT
    share = other / first - 1.0
    if abs(share) >= 10.0:
        return decimal(f"x {other / first:.3g}")
    return decimal(f"{100.0 * share:+.1f} %" if round(100.0 * share, 1) else "0.0 %")


def _row(name: str, bearing: ComparedBearing) -> DesignRow | None:
    known = [one.values.get(name) if one is not None and one.outcome.solved else None for one in bearing.results]
    if all(value is None for value in known):
        return None
    solved = (one.values for one in bearing.results if one is not None and one.outcome.solved)
    quantity = suited_among(name, *solved)
    cells = tuple(ABSENT if value is None else quantity.format(value) for value in known)
    first = next(one for one in bearing.results if one is not None)
    said = f"{told_meaning(name, first.kind)}, {quantity.symbol}"
    differences = tuple(difference(name, known[0], other) for other in known[1:])
    return DesignRow(said, quantity.display.label, cells, differences, name)


def _said(result: Result | None, words: str) -> str:
    return ABSENT if result is None else words


def _governing(result: Result) -> str:
    check = result.governing_check
    return "" if check is None else f"{check.code} {margin(check)}"


def _missed(result: Result) -> str:
    return ", ".join(dict.fromkeys(check.code for check in result.limits if not check.ok))


def kinds_said(designs: Designs) -> str:
    """What to know of designs of different kinds; empty for one kind."""
    if designs.one_kind:
        return ""
    named = ", ".join(f"{label} {kind}" for label, kind in zip(designs.labels, designs.kinds, strict=True))
    return translated(
        "The designs are of different kinds ({kinds}): only results that all of them have are compared.",
        kinds=named,
    )


def print_designs(designs: Designs) -> None:
    """Print changed inputs, and of every bearing the results that differ, side by side."""
    _print(console(), designs)


def short_designs(designs: Designs) -> str:
    """Changed inputs and the results that differ, as text."""
    to = Console(width=PIPED_WIDTH, file=StringIO(), color_system=None, highlight=False)
    with to.capture() as written:
        _print(to, designs)
    return "\n".join(line.rstrip() for line in written.get().splitlines())


def _print(to: Console, designs: Designs) -> None:
    if said := kinds_said(designs):
        to.print(said, markup=False)
    if designs.changed:
        to.print(_table("Changed inputs", ("field",), designs.labels, ((one.path, *one.shown)
                                                                      for one in designs.changed)))  # fmt: skip
    else:
        to.print("No input differs.", markup=False)
    differences = [f"{label} against {designs.labels[0]}" for label in designs.labels[1:]]
    for bearing in designs.bearings:
        rows = list(bearing_rows(bearing))
        shown = [one for one in rows if set(one.differences) - SAME]
        heads = (*designs.labels, *differences)
        cells = ((one.meaning, one.unit, *one.cells, *one.differences) for one in shown)
        to.print(_table(plain_text(bearing.name), ("quantity", "unit"), heads, cells))
        if left := len(rows) - len(shown):
            to.print(f"  left out: {counted(left, 'result')} that no design changes", markup=False)
        for label, result in zip(designs.labels, bearing.results, strict=True):
            if result is not None and not result.outcome.solved:
                to.print(f"  {label}: {result.outcome.value}; {in_us_units(result.message)}", markup=False)


def _table(title: str, words: Sequence[str], numbers: Sequence[str], rows: Iterator[tuple[str, ...]]) -> Table:
    table = Table(title=Text(title, style="bold"), title_justify="left")
    for word in words:
        table.add_column(word)
    for head in numbers:
        table.add_column(fill(plain_text(head), WIDEST_HEAD), justify="right")
    for row in rows:
        table.add_row(*(Text(plain_text(cell)) for cell in row))
    return table
