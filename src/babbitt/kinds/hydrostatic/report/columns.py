"""The columns of hydrostatic bearings and jacking pockets in tables."""

from babbitt.report.columns import Column, column_of, limit_of, reading_of

__all__ = ["COLUMNS"]

COLUMNS = (
    column_of("load", 3),
    column_of("specific_load", 7),
    column_of("gap", 1),
    column_of("eccentricity_ratio", 2),
    Column(
        "h_min / h_lim",
        "",
        (reading_of("minimum_film_thickness"), limit_of("minimum_film_thickness")),
        0,
        " / ",
        "minimum_film_thickness",
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
