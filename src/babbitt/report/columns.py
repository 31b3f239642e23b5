"""The columns of a machine's table, on the screen and on paper alike."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.verdict import governing

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


def _limit(name: str) -> Reading:
    def reading(result: Result) -> str:
        check = governing(result, name)
        return _number(name, check.limit) if check else ABSENT

    return reading


def _judged(name: str, limit: str, rank: int) -> Column:
    """The column of a quantity beside its limit, with those results in it that have one."""
    quantity, value = QUANTITIES[name], _reading(name)

    def reading(result: Result) -> str:
        return value(result) if governing(result, name) else ABSENT

    heading = f"{quantity.symbol} / {limit}"
    return Column(heading, quantity.display.label, (reading, _limit(name)), rank, " / ")


def _unjudged(name: str, rank: int) -> Column:
    """The column of a quantity that is not held against a limit here."""
    quantity, value = QUANTITIES[name], _reading(name)

    def reading(result: Result) -> str:
        return ABSENT if governing(result, name) else value(result)

    return Column(quantity.symbol, quantity.display.label, (reading,), rank)


def _supply_flow(result: Result) -> str:
    """None for a bearing that no oil is fed to, which is not the same as a flow of zero."""
    return _reading("supply_flow")(result) if is_fed(result) else ABSENT


def column_of(name: str, rank: int) -> Column:
    """The column of one quantity."""
    quantity = QUANTITIES[name]
    return Column(quantity.symbol, quantity.display.label, (_reading(name),), rank)


COLUMNS = (
    column_of("specific_load", 2),
    column_of("surface_speed", 7),
    column_of("operating_relative_clearance", 8),
    Column("T_en → T_ex", "°C", (_reading("supply_temperature"), _reading("outlet_temperature")), 1, " → "),
    column_of("bearing_temperature", 1),
    column_of("eccentricity_ratio", 3),
    Column(
        "h_min / h_lim", "µm", (_reading("minimum_film_thickness"), _limit("minimum_film_thickness")), 0, " / "
    ),
    column_of("friction_power", 4),
    column_of("side_flow", 5),
    Column(QUANTITIES["supply_flow"].symbol, QUANTITIES["supply_flow"].display.label, (_supply_flow,), 6),
    Column("Re / Re_cr", "", (_reading("film_reynolds_number"), _reading("critical_reynolds_number")), 9, " / "),
)
"""All columns; a machine's table has those in which some bearing has a number."""


OVERVIEW_COLUMNS = tuple(
    column_of(name, rank)
    for rank, name in enumerate(
        (
            "specific_load",
            "minimum_film_thickness",
            "empirical_film_limit",
            "geometric_film_limit",
            "outlet_temperature",
            "effective_temperature",
            "side_flow",
            "supply_flow",
            "film_reynolds_number",
            "critical_reynolds_number",
            "relative_clearance",
            "recommended_relative_clearance",
            "stability_relative_clearance",
            "eccentricity_ratio",
        )
    )
)
"""Of the bearings of a machine by ISO 7902, in the order of a published gearbox study (2023), Tables 4 and 5."""


HEEL_COLUMNS = (
    column_of("load", 0),
    column_of("rim_pressure", 1),
    column_of("face_flow", 3),
    column_of("maximum_temperature", 2),
    column_of("friction_power", 1),
    column_of("face_gap_stiffness", 4),
    column_of("load_ratio_to_smooth", 5),
)
"""Of the states of footsteps."""

THRUST_COLUMNS = (
    column_of("specific_load", 4),
    _judged("largest_specific_load", "p_lim", 3),
    column_of("surface_speed", 7),
    column_of("pad_load_ratio", 5),
    Column("T_en → T_ex", "°C", (_reading("supply_temperature"), _reading("outlet_temperature")), 3, " → "),
    _judged("maximum_temperature", "T_lim", 2),
    _judged("hottest_trailing_temperature", "T_lim", 2),
    _judged("trailing_temperature", "T_lim", 2),
    _judged("effective_temperature", "T_lim", 2),
    _unjudged("minimum_film_thickness", 1),
    _judged("minimum_film_thickness", "h_lim", 0),
    _judged("quasi_static_minimum_film_thickness", "h_lim", 0),
    _judged("dynamic_minimum_film", "h_lim", 0),
    _judged("loss_mean_bound", "L_lim", 0),
    _judged("unload_margin_bound", "L_lim", 3),
    column_of("natural_frequency_1", 6),
    column_of("friction_power", 8),
    column_of("total_flow", 9),
)
"""Of thrust bearings and shaft lines: each film, load and temperature that is judged with its limit."""

PUMPED_COLUMNS = (
    column_of("load", 3),
    column_of("specific_load", 7),
    column_of("gap", 1),
    column_of("eccentricity_ratio", 2),
    Column(
        "h_min / h_lim", "µm", (_reading("minimum_film_thickness"), _limit("minimum_film_thickness")), 0, " / "
    ),
    column_of("mean_pressure_ratio", 1),
    column_of("pocket_pressure", 1),
    column_of("total_flow", 2),
    column_of("pumping_power", 4),
    column_of("friction_power", 4),
    column_of("temperature_rise", 5),
    column_of("gap_stiffness", 6),
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
    elif kinds and kinds <= {"thrust", "thrust_line"}:
        among = THRUST_COLUMNS
    elif kinds and all(kind == "jacking_pocket" or kind.startswith("hydrostatic_") for kind in kinds):
        among = PUMPED_COLUMNS
    return filled(among, results)


def overview_columns(results: Sequence[Result]) -> tuple[Column, ...]:
    """The columns of the overview of bearings by ISO 7902; none for fewer than two of them."""
    return filled(OVERVIEW_COLUMNS, results) if len(results) > 1 else ()


def filled(columns: Sequence[Column], results: Sequence[Result]) -> tuple[Column, ...]:
    """Those of some columns in which some bearing has a number."""
    return tuple(column for column in columns if set(column.cells(results)) != {ABSENT})


def is_fed(result: Result) -> bool:
    """Whether oil is fed to a bearing from outside."""
    return "supply_temperature" in result.values


def is_film(result: Result) -> bool:
    """Whether a result belongs in the table: it has a film, or should have had one."""
    if result.kind == "screw_heel":
        return False
    return "minimum_film_thickness" in result.values or not result.outcome.solved
