"""The oil balance of a machine in tables and words."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result

__all__ = ["sentences", "tables"]

COLUMNS = {
    "line_pressure": "pressure",
    "line_flow": "supplied",
    "line_need": "needed",
    "line_supply_ratio": "supplied/needed",
    "line_share": "share",
    "line_reynolds_number": "Re of tube",
    "line_orifice": "orifice",
    "line_orifice_proposed": "proposed",
}
"""Quantities and heads of their columns."""
NOTE = (
    "Pressure at the end of the line, flow through it, what the film draws by its own pressure, their ratio, "
    "share of all oil, Reynolds number of the tube, orifice as it is, and the orifice that gives the need with "
    "its margin."
)


def tables(result: Result) -> Iterator[dict[str, Any]]:
    """A row for each bearing, as plain data."""
    names = [name for name in COLUMNS if name in result.arrays]
    if not names:
        return
    heads: list[dict[str, Any]] = [{"text": "Bearing", "symbol": None, "unit": ""}]
    heads += [{"text": COLUMNS[name], "symbol": None, "unit": QUANTITIES[name].display.label} for name in names]
    columns = [
        ["–" if math.isnan(value) else QUANTITIES[name].format(value) for value in result.arrays[name][0]]
        for name in names
    ]
    rows = [[name, *row] for name, *row in zip(_bearings(result), *columns, strict=True)]
    yield {"title": "Oil of the bearings", "columns": heads, "rows": rows, "note": NOTE}


def sentences(result: Result) -> Iterator[str]:
    """Which bearing starves first."""
    if "line_supply_ratio" not in result.arrays:
        return
    ratios = result.arrays["line_supply_ratio"][0]
    first = min(range(len(ratios)), key=ratios.__getitem__)
    name, ratio = _bearings(result)[first], QUANTITIES["line_supply_ratio"].format(ratios[first])
    starved = " It starves." if ratios[first] < 1.0 else ""
    yield f"First to starve: {name}, which is supplied {ratio} times what its film draws.{starved}"


def _bearings(result: Result) -> list[str]:
    return [result.settings[f"bearing_{place}"] for place in range(1, len(result.arrays["line_flow"][0]) + 1)]
