"""The columns of a machine's table, on the screen and on paper alike."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from babbitt.quantities import QUANTITIES
from babbitt.report.verdict import governing
from babbitt.results import Result

ABSENT = "–"

Reading = Callable[[Result], float]
"""A number in the engineer's unit taken from a result; NaN where it has none."""


@dataclass(frozen=True)
class Column:
    """One column: heading, unit, and the numbers that stand in it.

    Of the columns that do not fit, the one with the highest `rank` is left out first; rank 0 always stays.
    """

    heading: str
    unit: str
    readings: tuple[Reading, ...]
    digits: int
    rank: int
    separator: str = " "

    def cells(self, results: Sequence[Result]) -> list[str]:
        """The text of each row, with equal decimals down the column; dashes for unsolved bearings."""
        parts = [
            [reading(result) if result.outcome.solved else math.nan for result in results]
            for reading in self.readings
        ]
        places = [decimals(numbers, self.digits) for numbers in parts]
        return [
            self.separator.join(
                f"{number:.{place}f}" if math.isfinite(number) else ABSENT
                for number, place in zip(row, places, strict=True)
            )
            if result.outcome.solved
            else ABSENT
            for result, row in zip(results, zip(*parts, strict=True), strict=True)
        ]


def decimals(numbers: Iterable[float], digits: int) -> int:
    """Decimals that show the largest number with `digits` significant ones, and the smallest with at least two.

    >>> decimals([26.2, 8.5], 3), decimals([1500.0, 890.0], 3), decimals([1.5, 0.06], 3)
    (1, 0, 3)
    """
    sizes = [math.floor(math.log10(abs(n))) for n in numbers if math.isfinite(n) and n != 0.0]
    if not sizes:
        return 0
    return min(max(0, digits - 1 - max(sizes), 1 - min(sizes)), 6)


def _reading(name: str) -> Reading:
    quantity = QUANTITIES[name]
    return lambda result: quantity.shown(result.values.get(name, math.nan))


def _first(*names: str) -> Reading:
    """The first of several quantities that a result has."""

    def read(result: Result) -> float:
        present = [name for name in names if name in result.values]
        return _reading(present[0])(result) if present else math.nan

    return read


def _film_limit(result: Result) -> float:
    check = governing(result, "minimum_film_thickness")
    return QUANTITIES["minimum_film_thickness"].shown(check.limit) if check else math.nan


def _quantity(name: str, rank: int) -> Column:
    quantity = QUANTITIES[name]
    return Column(quantity.symbol, quantity.display.label, (_reading(name),), quantity.digits, rank)


COLUMNS = (
    _quantity("specific_load", 2),
    _quantity("surface_speed", 7),
    _quantity("operating_relative_clearance", 8),
    Column(
        "T_en → T_ex",
        "°C",
        (
            _first("supply_temperature", "ambient_temperature"),
            _first("outlet_temperature", "bearing_temperature"),
        ),
        3,
        1,
        " → ",
    ),
    _quantity("eccentricity_ratio", 3),
    Column("h_min / h_lim", "µm", (_reading("minimum_film_thickness"), _film_limit), 3, 0, " / "),
    _quantity("friction_power", 4),
    _quantity("side_flow", 5),
    _quantity("supply_flow", 6),
    Column(
        "Re / Re_cr",
        "",
        (_reading("film_reynolds_number"), _reading("critical_reynolds_number")),
        3,
        9,
        " / ",
    ),
)


def is_film(result: Result) -> bool:
    """Whether a result belongs in the table: it has a film, or should have had one."""
    return "minimum_film_thickness" in result.values or not result.outcome.solved
