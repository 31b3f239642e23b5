"""Rows of results of several recesses, and of coefficients over the frequency."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.bearing_table import matrix_entries
from babbitt.report.result_rows import result_row

__all__ = ["recess_rows"]

Data = dict[str, Any]


def recess_rows(results: Sequence[Result]) -> list[Data]:
    """Pressure, ratio and flow of every recess where there are several, then coefficients over frequency."""
    result, rows = results[0], []
    several = len(result.arrays.get("recess_pressure", ((),))[0]) > 1
    for name in ("recess_pressure", "pressure_ratio", "restrictor_flow") if several else ():
        what = {"recess_pressure": "pressure", "pressure_ratio": "pressure ratio", "restrictor_flow": "flow"}[name]
        for place, value in enumerate(result.arrays[name][0], start=1):
            rows.append(_single_row(name, f"Recess {place}, {what}", value, str(place)))
    for name, said in (("dynamic_stiffness", "Stiffness"), ("dynamic_damping", "Damping")):
        for place, at in enumerate(result.arrays.get("dynamic_frequency", ((),))[0]):
            hertz = f"{QUANTITIES['dynamic_frequency'].shown(at):.6g}"
            values = result.arrays[name][place]
            for index, entry in matrix_entries(len(values)).items():
                rows.append(_single_row(name, f"{said} at {hertz} Hz", values[entry], index.removeprefix("_")))
    return rows


def _single_row(name: str, said: str, value: float, index: str) -> Data:
    return result_row(name, said, [value], index)
