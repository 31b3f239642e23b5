"""The columns of journal bearings in tables."""

from __future__ import annotations

from babbitt.core.result import Result
from babbitt.report.columns import ABSENT, Column, column_of, is_fed, limit_of, reading_of

__all__ = ["COLUMNS", "OVERVIEW_COLUMNS"]


def _supply_flow(result: Result) -> str:
    """None for a bearing that no oil is fed to, which is not the same as a flow of zero."""
    return reading_of("supply_flow")(result) if is_fed(result) else ABSENT


COLUMNS = (
    column_of("specific_load", 2),
    column_of("surface_speed", 7),
    column_of("operating_relative_clearance", 8),
    Column(
        "T_en → T_ex",
        "",
        (reading_of("supply_temperature"), reading_of("outlet_temperature")),
        1,
        " → ",
        "outlet_temperature",
    ),
    column_of("bearing_temperature", 1),
    column_of("eccentricity_ratio", 3),
    Column(
        "h_min / h_lim",
        "",
        (reading_of("minimum_film_thickness"), limit_of("minimum_film_thickness")),
        0,
        " / ",
        "minimum_film_thickness",
    ),
    column_of("friction_power", 4),
    column_of("side_flow", 5),
    Column("{symbol}", "", (_supply_flow,), 6, quantity="supply_flow"),
    column_of("surplus_flow", 5),
    Column(
        "Re / Re_cr", "", (reading_of("film_reynolds_number"), reading_of("critical_reynolds_number")), 9, " / "
    ),
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
