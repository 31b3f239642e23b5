"""The columns of thrust bearings and shaft lines in tables."""

from babbitt.report.columns import Column, column_of, column_with_limit, column_without_limit, reading_of

__all__ = ["COLUMNS"]

COLUMNS = (
    column_of("specific_load", 4),
    column_with_limit("largest_specific_load", "p_lim", 3),
    column_without_limit("surface_speed", 7),
    column_with_limit("surface_speed", "U_lim", 7),
    column_with_limit("pressure_speed_product", "p̄U_lim", 8),
    column_of("pad_load_ratio", 5),
    Column(
        "T_en → T_ex",
        "",
        (reading_of("supply_temperature"), reading_of("outlet_temperature")),
        3,
        " → ",
        "outlet_temperature",
    ),
    column_with_limit("maximum_temperature", "T_lim", 2),
    column_with_limit("hottest_trailing_temperature", "T_lim", 2),
    column_with_limit("trailing_temperature", "T_lim", 2),
    column_with_limit("effective_temperature", "T_lim", 2),
    column_without_limit("minimum_film_thickness", 1),
    column_with_limit("minimum_film_thickness", "h_lim", 0),
    column_with_limit("quasi_static_minimum_film_thickness", "h_lim", 0),
    column_with_limit("dynamic_minimum_film", "h_lim", 0),
    column_with_limit("loss_mean_bound", "L_lim", 0),
    column_with_limit("unload_margin_bound", "L_lim", 3),
    column_of("natural_frequency_1", 6),
    column_of("friction_power", 8),
    column_of("total_flow", 9),
)
"""Of thrust bearings and shaft lines: each film, load and temperature that is compared with its limit."""
