"""The columns of tilting-pad bearings in tables."""

from babbitt.report.columns import Column, column_of, column_with_limit, column_without_limit, limit_of, reading_of

__all__ = ["COLUMNS"]

COLUMNS = (
    column_of("load", 3),
    column_with_limit("specific_load", "p_lim", 7),
    column_of("eccentricity_ratio", 2),
    column_with_limit("minimum_film_thickness", "h_lim", 0),
    column_without_limit("minimum_film_thickness", 0),
    column_of("maximum_pressure", 6),
    column_of("friction_power", 1),
    column_of("total_flow", 5),
    column_with_limit("maximum_temperature", "T_lim", 4),
    column_without_limit("maximum_temperature", 4),
    column_with_limit("trailing_temperature", "T_lim", 4),
    column_without_limit("trailing_temperature", 4),
    column_of("probe_temperature", 3),
    column_of("outlet_temperature", 9),
    column_of("loaded_pads", 10),
    Column("δ_log / δ_lim", "", (reading_of("log_decrement"), limit_of("log_decrement")), 2, " / "),
    column_of("log_decrement_anticipated", 6),
    column_of("cross_coupling_ratio", 6),
    column_of("stiffness_xx", 8),
    column_of("stiffness_yy", 8),
    column_of("damping_xx", 8),
    column_of("damping_yy", 8),
)
"""Of bearings of tilting pads."""
