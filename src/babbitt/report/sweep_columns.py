"""The key results of a sweep, by the kind of case."""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.report.columns import Column, column_of, filled
from babbitt.results import Result

__all__ = ["panels_of", "sweep_columns"]

HYDROSTATIC = (
    "minimum_film_thickness",
    "total_flow",
    "mean_pressure_ratio",
    "pump_power",
    "friction_power",
    "temperature_rise",
    "gap_stiffness",
    "stiffness_xx",
    "stiffness_yy",
)

KEY_RESULTS = {
    "screw_heel": ("load", "maximum_temperature", "friction_power", "heel_leakage", "face_gap_stiffness"),
    "hydrostatic_pad": HYDROSTATIC,
    "hydrostatic_thrust_ring": HYDROSTATIC,
    "hydrostatic_journal": HYDROSTATIC,
    "jacking_pocket": ("lift", "breakaway_pressure", "pocket_pressure", "total_flow", "pump_power"),
    "overhung_coupling": ("reaction_1", "reaction_2", "reaction_angle_1", "reaction_angle_2", "coupling_arm"),
    "thrust": (
        "minimum_film_thickness",
        "friction_power",
        "outlet_temperature",
        "maximum_pressure",
        "total_flow",
        "axial_stiffness",
        "pad_load_ratio",
    ),
    "thrust_line": (
        "dynamic_minimum_film",
        "loss_mean_bound",
        "natural_frequency_1",
        "unload_margin_bound",
        "frequency_separation",
        "minimum_film_thickness",
        "axial_stiffness",
    ),
}
"""Names of results by kind, what matters most first; a screen that is too narrow leaves out the last."""

JOURNAL_PANELS = (
    ("minimum_film_thickness",),
    ("friction_power",),
    ("outlet_temperature", "bearing_temperature", "effective_temperature"),
    ("total_flow", "maximum_pressure", "eccentricity_ratio"),
)
"""Of journal bearings, one panel each: of the quantities in a row the first that some answer has."""


def sweep_columns(results: Sequence[Result]) -> tuple[Column, ...] | None:
    """Columns of a kind that has its own and in which some answer has a number; None for journal bearings."""
    names = KEY_RESULTS.get(results[0].kind)
    return None if names is None else filled([column_of(name, rank) for rank, name in enumerate(names)], results)


def panels_of(results: Sequence[Result]) -> tuple[tuple[str, ...], ...]:
    """What the panels of a plot show: of each row the first that some answer has."""
    there = {name for result in results if result.outcome.solved for name in result.values}
    own = [name for name in KEY_RESULTS.get(results[0].kind, ()) if name in there]
    return tuple((name,) for name in own[:4]) or JOURNAL_PANELS
