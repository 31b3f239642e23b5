"""The table of `babbitt compare`: one column a method, one line a quantity."""

from __future__ import annotations

from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from babbitt.quantities import QUANTITIES
from babbitt.report.table import console
from babbitt.report.text import plain_text
from babbitt.studies.comparison import Comparison

COMPARED = (
    "sommerfeld_number",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "effective_temperature",
    "outlet_temperature",
    "bearing_temperature",
    "friction_power",
    "side_flow",
    "supply_flow",
    "total_flow",
    "maximum_temperature",
    "journal_temperature",
    "film_flow",
    "flow_inconsistency",
    "maximum_pressure",
    "film_reynolds_number",
    "critical_mass",
    "whirl_frequency_ratio",
    "threshold_speed",
)
"""What is put side by side."""

COMPARED_HEELS = (
    "load",
    "rim_pressure",
    "face_flow",
    "heel_leakage",
    "maximum_temperature",
    "friction_power",
    "face_gap_stiffness",
    "face_gap_damping",
    "rim_drain_number",
)
"""The same of footsteps."""

HYDROSTATIC = (
    "load",
    "gap",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "mean_pressure_ratio",
    "total_flow",
    "pumping_power",
    "friction_power",
    "temperature_rise",
    "effective_area",
    "gap_stiffness",
    "gap_damping",
    "least_tilt_stiffness",
    *(f"{name}_{axes}" for name in ("stiffness", "damping") for axes in ("xx", "xy", "yx", "yy")),
    "load_capacity",
    "breakaway_pressure",
    "lying_pressure",
    "pocket_pressure",
)
"""The same of hydrostatic bearings."""


def _compared(comparison: Comparison) -> tuple[str, ...]:
    if comparison.variants[0].result.kind == "screw_heel":
        return COMPARED_HEELS
    pumped = {"mean_pressure_ratio", "pocket_pressure"}
    return HYDROSTATIC if any(pumped & set(one.result.values) for one in comparison.variants) else COMPARED


def print_comparison(comparisons: Sequence[Comparison]) -> bool:
    """Print every bearing with its variants side by side; say whether the case as given has a solution."""
    to = console()
    for comparison in comparisons:
        title = Text(plain_text(comparison.name), style="bold")  # a name is never read as markup
        table = Table(title=title, title_justify="left")
        table.add_column("quantity")
        table.add_column("unit")
        for variant in comparison.variants:
            table.add_column(variant.label, justify="right")
        for name in _compared(comparison):
            if not any(name in variant.result.values for variant in comparison.variants):
                continue
            quantity = QUANTITIES[name]
            shown = [
                quantity.format(variant.result.values[name])
                if variant.result.outcome.solved and name in variant.result.values
                else "–"
                for variant in comparison.variants
            ]
            table.add_row(f"{quantity.meaning}, {quantity.symbol}", quantity.display.label, *shown)
        to.print(table)
        for variant in comparison.variants:
            to.print(f"  {variant.label} {variant.remark}", markup=False)
            if not variant.result.outcome.solved:
                to.print(
                    f"  {variant.label}: {variant.result.outcome.value}; {variant.result.message}", markup=False
                )
        to.print()
    return all(comparison.variants[0].result.outcome.solved for comparison in comparisons)
