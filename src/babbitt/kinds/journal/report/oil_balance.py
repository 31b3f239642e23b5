"""The oil balance of a machine in tables and words."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.inputs import InputGroup, Row

if TYPE_CHECKING:
    from babbitt.kinds.journal.oil_balance.model import Line, OilSystemProblem

__all__ = ["oil_system_inputs", "sentences", "tables"]

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


def oil_system_inputs(problem: OilSystemProblem) -> Iterator[InputGroup]:
    """Pump and lines as inputs."""
    pump = problem.system.pump
    points = tuple(
        Row(f"Delivery at {QUANTITIES['header_pressure'].with_unit(pressure)}", f"{6e4 * flow:.4g}", None, "L/min")
        for pressure, flow in pump.curve
    )
    relief = Row("Relief valve opens at", f"{1e-3 * pump.relief_pressure:.4g}", None, "kPa")
    yield InputGroup("Pump", (*points, relief))
    yield InputGroup("Lines", tuple(Row(line.bearing, _describe(line)) for line in problem.system.lines))


def _describe(line: Line) -> str:
    said = []
    if line.tube is not None:
        one = line.tube
        number = "" if one.number == 1.0 else f"{one.number:.0f} tubes in parallel, each "
        said.append(
            f"{number}tube d = {1e3 * one.diameter:.4g} mm, l = {one.length:.4g} m, ζ = {one.loss_coefficient:.4g}"
        )
    if line.orifice_diameter is not None:
        said.append(f"orifice d = {1e3 * line.orifice_diameter:.4g} mm, C_d = {line.discharge_coefficient:.3g}")
    return "; ".join(said)


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
