"""The table of `babbitt compare`: one column a method, one line a quantity."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from io import StringIO
from textwrap import fill

from rich.console import Console
from rich.table import Table
from rich.text import Text

from babbitt.core.check_text import margin
from babbitt.core.language import ENGLISH, decimal, language, translated, translated_if_known
from babbitt.core.result import Check, Result, Verdict
from babbitt.report.labels import label
from babbitt.report.meanings import meaning
from babbitt.report.table import PIPED_WIDTH, console
from babbitt.report.text import plain_text
from babbitt.report.units_of_matrices import suited_among
from babbitt.report.us_words import OF_RESULTS, in_us_units
from babbitt.report.verdict import governing, governing_temperature, missed_codes
from babbitt.report.view import view_of
from babbitt.study.comparison import Comparison, Variant

WIDEST_HEAD = 14
"""Characters in a line of a head: words take the room, and numbers need little."""
AS_ASKED = " *"
"""Behind the name of the method that the case asks for."""
MOST_ROWS = 10
"""Quantities of a short table; all of them stand in that of `print_comparison`."""


def print_comparison(comparisons: Sequence[Comparison]) -> bool:
    """Print every bearing with its methods side by side; say whether the case as given has a solution.

    What differs from a method in one choice only stands in a table of its own below.
    """
    to = console()
    for comparison in comparisons:
        title = Text(plain_text(comparison.name), style="bold")  # a name is never read as markup
        methods, others = comparison.methods, comparison.choices
        to.print(_table(title, comparison.compared, methods, comparison.asked))
        to.print(f" {asked_for(comparison)}", markup=False)
        for line in (*notes_on(methods), *map(spoken, (*comparison.sentences, *comparison.left_out.splitlines()))):
            to.print(f"  {line}", markup=False)
        to.print()
        if others:
            to.print(
                _table(
                    Text("Other choices within a method", style="bold"),
                    comparison.compared,
                    others,
                    comparison.asked,
                )
            )
            for line in notes_on(others):
                to.print(f"  {line}", markup=False)
            to.print()
    return all(comparison.asked.result.outcome.solved for comparison in comparisons)


def short_comparison(comparison: Comparison) -> str:
    """Methods side by side in the quantities that matter most, in fewer than 25 lines of text."""
    asked = comparison.asked
    key = [name for name in view_of(asked.result).key_results if name in comparison.compared]
    shown = (key or list(comparison.compared))[:MOST_ROWS]
    table = _table(Text(plain_text(comparison.name)), shown, comparison.methods, asked)
    table.columns[0].no_wrap = True  # each quantity on one line
    to = Console(width=PIPED_WIDTH, file=StringIO(), color_system=None, highlight=False)
    with to.capture() as written:
        to.print(table)
        to.print(f" {asked_for(comparison)}", markup=False)
        if others := ", ".join(spoken(one.label) for one in comparison.choices):
            to.print(f"   also: {others}", markup=False)
    return "\n".join(line.rstrip() for line in written.get().splitlines())


def spoken(said: str) -> str:
    """What variants say, in the language and units that are spoken: it was composed before these were chosen."""
    turned: str = in_us_units(_with_decimals(translated(said)), OF_RESULTS)
    return turned


def _with_decimals(said: str) -> str:
    """Numbers of a sentence with the sign of the language, apart by semicolons where it is a comma."""
    if language() == ENGLISH:
        return said
    return decimal(re.sub(r"(?<=\d), (?=[\d–])", "; ", said) if re.search(r"\d\.\d", said) else said)


def told_left_out(line: str) -> str:
    """A method that does not apply, with the reason; another language has it where it knows its sentence."""
    if language() == ENGLISH:
        return spoken(line)
    which, why = re.split(r" (?:is|are) left out: ", line, maxsplit=1)
    reason, left_out = translated_if_known(why), translated_if_known(which)
    if reason == why:
        return translated("left out: {which}", which=left_out)
    said: str = in_us_units(translated("left out: {which} ({why})", which=left_out, why=reason), OF_RESULTS)
    return said


def head(variant: Variant, asked: Variant) -> str:
    """Head of the column of a variant."""
    label = spoken(variant.label)
    return f"{label}{AS_ASKED}" if variant is asked else label


def objected(result: Result) -> str:
    """Limits that a result misses, and codes of warnings that touch its verdict; empty for none."""
    missed, codes = missed_codes(result), result.questioning_codes
    said = [translated("misses {codes}", codes=", ".join(missed))] if missed else []
    return "; ".join(said + ([translated("warns {codes}", codes=", ".join(codes))] if codes else []))


def _table(title: Text, compared: Sequence[str], variants: Sequence[Variant], asked: Variant) -> Table:
    table = Table(title=title, title_justify="left")
    table.add_column("quantity")
    table.add_column("unit")
    for variant in variants:
        table.add_column(fill(head(variant, asked), WIDEST_HEAD), justify="right")
    for row in compared_rows(compared, variants):
        table.add_row(row.meaning, row.unit, *row.cells)
    return table


@dataclass(frozen=True)
class Row:
    """One quantity with its unit, by every method."""

    meaning: str
    unit: str
    cells: tuple[str, ...]


def compared_rows(compared: Sequence[str], variants: Sequence[Variant]) -> Iterator[Row]:
    """What is put side by side of some variants."""
    for name in compared:
        results = [variant.result for variant in variants]
        known = [result.values.get(name) if result.outcome.solved else None for result in results]
        nothing = {None, 0.0} if name in SILENT_AT_ZERO else {None}
        if set(known) <= nothing:
            continue
        quantity = suited_among(name, *(result.values for result in results if result.outcome.solved))
        cells = ("–" if value is None else quantity.format(value) for value in known)
        kind = variants[0].result.kind
        said = meaning(name, kind) if language() == ENGLISH else label(name, kind)
        yield Row(f"{said}, {quantity.symbol}", quantity.display.label, tuple(cells))
    for said, check_of in MARGINS.items():
        margins = [_margin(variant.result, check_of) for variant in variants]
        if set(margins) != {"–"}:
            yield Row(translated(said), "", tuple(margins))
    verdicts = tuple(translated(variant.result.verdict.value) for variant in variants)
    yield Row(translated("Verdict"), "", verdicts)
    open_checks = [len(variant.result.not_checked) if variant.result.outcome.solved else 0 for variant in variants]
    if any(open_checks):
        yield Row(translated("Checks not made"), "", tuple(map(str, open_checks)))


MARGINS: dict[str, Callable[[Result], Check | None]] = {
    "Margin of the film thickness to its limit": lambda result: governing(result, "minimum_film_thickness"),
    "Margin of the temperature to its limit": governing_temperature,
}
"""Limits whose margins are put side by side, by the strictest check of each."""


def _margin(result: Result, check_of: Callable[[Result], Check | None]) -> str:
    found = check_of(result) if result.outcome.solved else None
    return "–" if found is None else margin(found)


SILENT_AT_ZERO = ("heat_film_to_bush", "heat_film_to_journal", "heat_to_surroundings", "flow_inconsistency")
"""What is left out where it is zero by every method."""


def contradiction(variants: Sequence[Variant]) -> str:
    """Say which methods fail what others pass; empty where none does."""
    passing = [spoken(one.label) for one in variants if one.result.within_limits]
    failing = [spoken(one.label) for one in variants if one.result.verdict is Verdict.FAIL]
    if not passing or not failing:
        return ""
    return translated(
        "The methods disagree: limits kept by {passing} are missed by {failing}.",
        passing=", ".join(passing),
        failing=", ".join(failing),
    )


def notes_on(variants: Sequence[Variant]) -> Iterator[str]:
    """Whether some variants disagree, what each sees and neglects, and what stands against its result."""
    if said := contradiction(variants):
        yield said
    for variant in variants:
        label, result = spoken(variant.label), variant.result
        yield f"{label}: {spoken(variant.remark)}"
        if not result.outcome.solved:
            yield f"{label}: {translated(result.outcome.value)}; {in_us_units(result.message, OF_RESULTS)}"
        if objections := objected(result):
            yield f"{label}: {objections}"


def asked_for(comparison: Comparison) -> str:
    """What the mark behind the name of a method says."""
    return translated(
        "{mark} {label}: what the case asks for", mark=AS_ASKED, label=spoken(comparison.asked.label)
    )


def warnings_of(comparison: Comparison) -> dict[str, str]:
    """Messages of all methods by their code, each by the first that raises it."""
    raised = [one for variant in comparison.variants for one in variant.result.warnings]
    found = {one.code: one.message for one in reversed(raised)}
    return {code: found[code] for code in sorted(found)}
