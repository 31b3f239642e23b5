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
        for name in COMPARED:
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
        if comparison.left_out:
            to.print(f"  {comparison.left_out}", markup=False)
        to.print()
    return all(comparison.variants[0].result.outcome.solved for comparison in comparisons)
