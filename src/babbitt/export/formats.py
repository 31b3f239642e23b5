"""The formats by name, as the command line offers them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from babbitt.core.notices import InputError
from babbitt.export.ansys import write_ansys
from babbitt.export.coefficients import CoefficientTable
from babbitt.export.json_file import write_json
from babbitt.export.ross import RECOMMENDED_SPEEDS, RossVersion, write_ross
from babbitt.export.tidy_csv import write_csv
from babbitt.export.xltrc2 import write_xltrc2


@dataclass(frozen=True)
class ExportFormat:
    """A format a coefficient table can be written in."""

    name: str
    suffixes: tuple[str, ...]
    meaning: str
    write: Callable[[CoefficientTable, Path], None]
    either_rotation: bool = False
    """Whether the format has a place for the rotation sense; the others hold counter-clockwise tables only."""
    fewest_speeds: int = 1
    """Speeds that a table must have at least."""


def _ross(version: RossVersion) -> Callable[[CoefficientTable, Path], None]:
    return lambda table, path: write_ross(table, path, version=version)


FORMATS: dict[str, ExportFormat] = {
    one.name: one
    for one in (
        ExportFormat(
            "ross2",
            (".json", ".toml"),
            "bearing element of ROSS, version 2",
            _ross(RossVersion.TWO),
            fewest_speeds=RECOMMENDED_SPEEDS,
        ),
        ExportFormat(
            "ross3",
            (".json", ".toml"),
            "bearing element of ROSS, version 3",
            _ross(RossVersion.THREE),
            fewest_speeds=RECOMMENDED_SPEEDS,
        ),
        ExportFormat("xltrc2", (".csv", ".xlsx"), "table with a row of units, as XLTRC2 has it", write_xltrc2),
        ExportFormat("ansys", (".txt",), "bearing characteristics of Ansys Mechanical APDL", write_ansys),
        ExportFormat("csv", (".csv",), "tidy table in SI, unit in each column name", write_csv, True),
        ExportFormat("json", (".json",), "everything in SI, unit in each key", write_json, True),
    )
}


OVER_FREQUENCY = frozenset({"ross3", "csv", "json"})
"""Formats that hold coefficients over frequency; the others hold the synchronous ones alone."""


def export(table: CoefficientTable, path: str | Path, format_name: str) -> None:
    """Write a table in one of `FORMATS`.

    Raises
    ------
    InputError
        E005 for an unknown format; whatever the format itself refuses.
    """
    if format_name not in FORMATS:
        raise InputError("E005", f"no format '{format_name}'; there are {', '.join(FORMATS)}")
    FORMATS[format_name].write(table, Path(path))
