"""The columns of footsteps in tables."""

from babbitt.report.columns import column_of

__all__ = ["COLUMNS"]

COLUMNS = (
    column_of("load", 0),
    column_of("rim_pressure", 1),
    column_of("face_flow", 3),
    column_of("maximum_temperature", 2),
    column_of("friction_power", 1),
    column_of("face_gap_stiffness", 4),
    column_of("load_ratio_to_smooth", 5),
)
"""Of the states of footsteps."""
