"""Rows of results of the supplies of a film with its own temperatures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.result_rows import result_row

__all__ = ["supply_rows"]

Data = dict[str, Any]


def supply_rows(results: Sequence[Result]) -> list[Data]:
    """Fresh oil, oil that goes back and temperature of every supply of films with their own temperatures.

    Of the results side by side each has its own value.
    """
    rows = []
    result = next((one for one in results if "groove_angles" in one.arrays and one.outcome.solved), results[0])
    names = {
        "groove_pressures": "pressure",
        "groove_fresh_flows": "fresh oil",
        "groove_returned_flows": "oil that goes back",
        "groove_temperatures": "mixing temperature",
    }
    for place, angle in enumerate(result.arrays.get("groove_angles", ((),))[0], start=1):
        where = f"{QUANTITIES['groove_angles'].format(angle)} °"
        for name, said in names.items():
            if name not in result.arrays:
                continue
            values = [_of_supply(one, name, place) for one in results]
            if name != "groove_returned_flows" or any(value > 0.0 for value in values):
                rows.append(result_row(name, f"Supply {place} at {where}, {said}", values, str(place)))
    return rows


def _of_supply(result: Result, name: str, place: int) -> float:
    """A value of a supply, not a number where the result has none."""
    values = result.arrays.get(name, ((),))[0] if result.outcome.solved else ()
    return values[place - 1] if place <= len(values) else math.nan
