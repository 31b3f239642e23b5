"""The columns of a machine's table, on the screen and on paper alike."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from babbitt.quantities import QUANTITIES
from babbitt.report.verdict import governing
from babbitt.results import Result

ABSENT = "–"

Reading = Callable[[Result], str]
"""A number in the engineer's unit taken from a result, as text; `ABSENT` where it has none."""


@dataclass(frozen=True)
class Column:
    """One column: heading, unit, and the numbers that stand in it.

    Of the columns that do not fit, the one with the highest `rank` is left out first; rank 0 always stays.
    """

    heading: str
    unit: str
    readings: tuple[Reading, ...]
    rank: int
    separator: str = " "

    def cells(self, results: Sequence[Result]) -> list[str]:
        """The text of each row; a dash where a bearing has no operating point or no such quantity."""
        return [self._cell(result) for result in results]

    def _cell(self, result: Result) -> str:
        parts = [reading(result) for reading in self.readings] if result.outcome.solved else [ABSENT]
        return ABSENT if set(parts) == {ABSENT} else self.separator.join(parts)


def _number(name: str, value: float) -> str:
    return QUANTITIES[name].format(value) if math.isfinite(value) else ABSENT


def _reading(name: str) -> Reading:
    return lambda result: _number(name, result.values.get(name, math.nan))


def _film_limit(result: Result) -> str:
    check = governing(result, "minimum_film_thickness")
    return _number("minimum_film_thickness", check.limit) if check else ABSENT


def _supply_flow(result: Result) -> str:
    """None for a bearing that no oil is fed to, which is not the same as a flow of zero."""
    return _reading("supply_flow")(result) if is_fed(result) else ABSENT


def _quantity(name: str, rank: int) -> Column:
    quantity = QUANTITIES[name]
    return Column(quantity.symbol, quantity.display.label, (_reading(name),), rank)


COLUMNS = (
    _quantity("specific_load", 2),
    _quantity("surface_speed", 7),
    _quantity("operating_relative_clearance", 8),
    Column("T_en → T_ex", "°C", (_reading("supply_temperature"), _reading("outlet_temperature")), 1, " → "),
    _quantity("bearing_temperature", 1),
    _quantity("eccentricity_ratio", 3),
    Column("h_min / h_lim", "µm", (_reading("minimum_film_thickness"), _film_limit), 0, " / "),
    _quantity("friction_power", 4),
    _quantity("side_flow", 5),
    Column(QUANTITIES["supply_flow"].symbol, QUANTITIES["supply_flow"].display.label, (_supply_flow,), 6),
    Column("Re / Re_cr", "", (_reading("film_reynolds_number"), _reading("critical_reynolds_number")), 9, " / "),
)
"""All columns; a machine's table has those in which some bearing has a number."""


HEEL_COLUMNS = (
    _quantity("load", 0),
    _quantity("rim_pressure", 1),
    _quantity("face_flow", 3),
    _quantity("maximum_temperature", 2),
    _quantity("friction_power", 1),
    _quantity("face_gap_stiffness", 4),
    _quantity("load_ratio_to_smooth", 5),
)
"""Of the states of footsteps."""

PUMPED_COLUMNS = (
    _quantity("load", 3),
    _quantity("specific_load", 7),
    _quantity("gap", 1),
    _quantity("eccentricity_ratio", 2),
    Column("h_min / h_lim", "µm", (_reading("minimum_film_thickness"), _film_limit), 0, " / "),
    _quantity("mean_pressure_ratio", 1),
    _quantity("pocket_pressure", 1),
    _quantity("total_flow", 2),
    _quantity("pumping_power", 4),
    _quantity("friction_power", 4),
    _quantity("temperature_rise", 5),
    _quantity("gap_stiffness", 6),
)
"""Of hydrostatic bearings and jacking pockets."""


def columns_of(results: Sequence[Result]) -> tuple[Column, ...]:
    """The columns in which some bearing has a number.

    A bearing cooled by its housing has a bearing temperature, one fed with oil the temperatures of that oil: each
    stands under its own heading.
    """
    kinds = {result.kind for result in results}
    among: tuple[Column, ...] = COLUMNS
    if kinds == {"screw_heel"}:
        among = HEEL_COLUMNS
    elif kinds and all(kind == "jacking_pocket" or kind.startswith("hydrostatic_") for kind in kinds):
        among = PUMPED_COLUMNS
    return tuple(column for column in among if set(column.cells(results)) != {ABSENT})


def is_fed(result: Result) -> bool:
    """Whether oil is fed to a bearing from outside."""
    return "supply_temperature" in result.values


def is_film(result: Result) -> bool:
    """Whether a result belongs in the table: it has a film, or should have had one."""
    if result.kind == "screw_heel":
        return False
    return "minimum_film_thickness" in result.values or not result.outcome.solved
