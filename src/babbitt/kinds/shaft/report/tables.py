"""Tables of a shaft for the report: what its bearings carry, and what acts on it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.symbols import symbol_node

__all__ = ["tables"]

COLUMNS = (
    "support_station",
    "support_load_x",
    "support_load_y",
    "support_load",
    "support_load_angle",
    "support_axial_load",
    "support_slope_x",
    "support_slope_y",
)
NOTE = (
    "Force that the shaft puts on each bearing; directions from +x, counter-clockwise seen against z. Slopes of "
    "the shaft in the bearing."
)


def tables(result: Result) -> Iterator[dict[str, Any]]:
    """A row for each bearing, as plain data."""
    names = [name for name in COLUMNS if name in result.arrays]
    heads: list[dict[str, Any]] = [{"text": "Bearing", "symbol": None, "unit": ""}]
    heads += [
        {"text": "", "symbol": symbol_node(QUANTITIES[name].symbol), "unit": QUANTITIES[name].display.label}
        for name in names
    ]
    columns = [[QUANTITIES[name].format(value) for value in result.arrays[name][0]] for name in names]
    bearings = [result.settings[f"bearing_{place}"] for place in range(1, len(columns[0]) + 1)]
    rows = [[name, *row] for name, *row in zip(bearings, *columns, strict=True)]
    yield {"title": "Loads of the bearings", "columns": heads, "rows": rows, "note": NOTE}
