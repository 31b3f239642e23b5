"""The key results of a sweep, by the kind of case."""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.core.result import Result
from babbitt.report.columns import Column, column_of, columns_of, filled

__all__ = ["panels_of", "sweep_columns"]

KEY_RESULTS = {
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
"""Of all other kinds, one panel each: of the quantities in a row the first that some answer has."""


def sweep_columns(results: Sequence[Result]) -> tuple[Column, ...]:
    """Columns in which some answer has a number: of a kind that has none in the table of a machine, its own."""
    names = KEY_RESULTS.get(results[0].kind)
    if names is None:
        return (*columns_of(results), *filled([column_of("relative_load", 3)], results))
    return filled([column_of(name, rank) for rank, name in enumerate(names)], results)


def panels_of(results: Sequence[Result]) -> tuple[tuple[str, ...], ...]:
    """What the panels of a plot show: of each row the first that some answer has."""
    there = {name for result in results if result.outcome.solved for name in result.values}
    own = [name for name in KEY_RESULTS.get(results[0].kind, ()) if name in there]
    return tuple((name,) for name in own[:4]) or FILM_PANELS
