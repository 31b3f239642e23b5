"""The key results of a sweep."""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.columns import ABSENT, Column, column_of, filled, reading_of
from babbitt.report.machine_table import columns_of
from babbitt.report.view import view_of

__all__ = ["panels_of", "sweep_columns"]

FILM_PANELS = (
    ("minimum_film_thickness", "load"),
    ("friction_power", "pocket_pressure"),
    (
        "outlet_temperature",
        "bearing_temperature",
        "effective_temperature",
        "maximum_temperature",
        "temperature_rise",
        "lift",
    ),
    ("total_flow", "rim_pressure", "maximum_pressure", "eccentricity_ratio"),
)
"""Of kinds that name none, one panel each: of the quantities in a row the first that some answer has."""


def _needed(result: Result) -> str:
    """The flow that the supply is held against."""
    limits = [check.limit for check in result.checks if check.quantity == "supply_capacity"]
    return QUANTITIES["supply_capacity"].format(max(limits)) if limits else ABSENT


SUPPLIED = Column(
    "{symbol} / needed", "", (reading_of("supply_capacity"), _needed), 4, " / ", quantity="supply_capacity"
)
"""The flow that the supply delivers, and the flow that the film needs of it."""


def sweep_columns(results: Sequence[Result]) -> tuple[Column, ...]:
    """Columns in which some answer has a number: those that its view names, else those of a machine.

    Where a shaft and its bearings answer, those of each view in turn.
    """
    by_view: dict[tuple[str, str], list[Result]] = {}
    for result in results:
        by_view.setdefault((result.kind, result.method), []).append(result)
    columns = [column for alike in by_view.values() for column in _columns_of_one_view(alike)]
    return tuple({column.heading: column for column in reversed(columns)}.values())[::-1]


def _columns_of_one_view(results: Sequence[Result]) -> tuple[Column, ...]:
    names = view_of(results[0]).sweep
    if not names:
        return (*columns_of(results), *filled([column_of("relative_load", 3), SUPPLIED], results))
    return filled([column_of(name, rank) for rank, name in enumerate(names)], results)


def panels_of(results: Sequence[Result]) -> tuple[tuple[str, ...], ...]:
    """What the panels of a plot show: of each row the first that some answer has."""
    there = {name for result in results if result.outcome.solved for name in result.values}
    own = [name for name in view_of(results[0]).sweep if name in there]
    return tuple((name,) for name in own[:4]) or FILM_PANELS
