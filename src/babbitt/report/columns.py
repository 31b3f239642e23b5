"""The columns of a machine's table, on the screen and on paper alike."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from babbitt.core.language import translated
from babbitt.core.limited_flow import quantity_held
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.verdict import governing

ABSENT = "–"

MARK = "*"
MARKED = f"{MARK} with the flow that the supply delivers: the limits are held against this film"

Reading = Callable[[Result], str]
"""A number in the engineer's unit taken from a result, as text; `ABSENT` where it has none."""


@dataclass(frozen=True)
class Column:
    """One column: heading, unit, and the numbers that stand in it.

    Of the columns that do not fit, the one with the highest `rank` is left out first; rank 0 always stays.
    Where `quantity` names one, its symbol stands for ``{symbol}`` in the title, and the unit is its own. It is
    looked up when the column is used: a kind's own quantities join the vocabulary after its views are imported.
    """

    title: str
    label: str
    readings: tuple[Reading, ...]
    rank: int
    separator: str = " "
    quantity: str = ""

    @property
    def heading(self) -> str:
        """What stands at its head."""
        return self.title.format(symbol=QUANTITIES[self.quantity].symbol) if self.quantity else self.title

    @property
    def unit(self) -> str:
        """Unit of its numbers."""
        return QUANTITIES[self.quantity].display.label if self.quantity else self.label

    @property
    def symbols(self) -> tuple[str, ...]:
        """The symbols of its heading."""
        return tuple(re.split(" → | / ", self.heading))

    def cells(self, results: Sequence[Result]) -> list[str]:
        """The text of each row; a dash where a bearing has no operating point or no such quantity."""
        return [self._cell(result) for result in results]

    def _cell(self, result: Result) -> str:
        parts = [reading(result) for reading in self.readings] if result.outcome.solved else [ABSENT]
        return ABSENT if set(parts) == {ABSENT} else self.separator.join(parts)


def _number(name: str, value: float) -> str:
    return QUANTITIES[name].format(value) if math.isfinite(value) else ABSENT


def reading_of(name: str) -> Reading:
    """The number of a quantity of the film that limits are held against, marked where that is short of oil."""

    def reading(result: Result) -> str:
        held = quantity_held(result, name)
        text = _number(name, result.values.get(held, math.nan))
        return text if held == name or text == ABSENT else text + MARK

    return reading


def footnote(columns: Sequence[Column], results: Sequence[Result]) -> str:
    """What marks in a table mean; empty for none."""
    marked = any(MARK in cell for column in columns for cell in column.cells(results))
    return translated(MARKED) if marked else ""


def limit_of(name: str) -> Reading:
    """The strictest limit of a quantity."""

    def reading(result: Result) -> str:
        check = governing(result, name)
        return _number(name, check.limit) if check else ABSENT

    return reading


def column_with_limit(name: str, limit: str, rank: int) -> Column:
    """The column of a quantity beside its limit, with those results in it that have one."""
    value = reading_of(name)

    def reading(result: Result) -> str:
        return value(result) if governing(result, name) else ABSENT

    return Column(f"{{symbol}} / {limit}", "", (reading, limit_of(name)), rank, " / ", name)


def column_without_limit(name: str, rank: int) -> Column:
    """The column of a quantity that is not held against a limit here."""
    value = reading_of(name)

    def reading(result: Result) -> str:
        return ABSENT if governing(result, name) else value(result)

    return Column("{symbol}", "", (reading,), rank, quantity=name)


def column_of(name: str, rank: int) -> Column:
    """The column of one quantity."""
    return Column("{symbol}", "", (reading_of(name),), rank, quantity=name)


def filled(columns: Sequence[Column], results: Sequence[Result]) -> tuple[Column, ...]:
    """Those of some columns in which some bearing has a number."""
    return tuple(column for column in columns if set(column.cells(results)) != {ABSENT})


def is_fed(result: Result) -> bool:
    """Whether oil is fed to a bearing from outside."""
    return "supply_temperature" in result.values
