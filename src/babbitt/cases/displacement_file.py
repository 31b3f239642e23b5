"""Tables of displacement that a case names: CSV with a line for every angle and axial place."""

from __future__ import annotations

import csv
import math
from pathlib import Path as FilePath
from typing import Any

from babbitt.cases.bore_file import CLOSES_TO, HEADING, LARGEST_TABLE, TableError
from babbitt.cases.plain_words import Path, shown
from babbitt.units import QuantityError, read

EXAMPLE = "three columns with the heading 'angle [deg],z [mm],displacement [um]'"

KINDS = ("rad", "m", "m")

TURN = 2.0 * math.pi


def with_displacements(given: dict[str, Any], folder: FilePath) -> dict[str, Any]:
    """Put the values of every table of displacement in the place of its file.

    Parameters
    ----------
    given : dict
        A case as it stands in the file; it is not changed.
    folder : Path
        What the files are named from.

    Raises
    ------
    TableError
        For the first table that cannot be used.
    """
    made = _with_table(given, (), folder)
    bearings = made.get("bearings")
    if isinstance(bearings, list):
        made["bearings"] = [
            _with_table(one, ("bearings", index), folder) if isinstance(one, dict) else one
            for index, one in enumerate(bearings)
        ]
    return made


def _with_table(bearing: dict[str, Any], path: Path, folder: FilePath) -> dict[str, Any]:
    table = bearing.get("displacement")
    if not (isinstance(table, dict) and "file" in table and "values" not in table):
        return dict(bearing)
    at = (*path, "displacement", "file")
    if not isinstance(table["file"], str):
        raise TableError(at, f"{shown(table['file'])} is not the name of a file", EXAMPLE)
    rest = {name: value for name, value in table.items() if name != "file"}
    return bearing | {"displacement": rest | displacement_of(folder / table["file"], at)}


def displacement_of(file: FilePath, at: Path) -> dict[str, Any]:
    """Angles, places and values of a table, whose lines may stand in any order, in SI."""
    found: dict[tuple[float, float], float] = {}
    for line, (angle, place, value) in lines_of(file, at, KINDS, EXAMPLE):
        if (angle, place) in found:
            raise TableError(at, f"row {line} of {file.name} repeats an angle and place", "each of them once")
        found[angle, place] = value
    angles, places = sorted({angle for angle, _ in found}), sorted({place for _, place in found})
    if len(found) != len(angles) * len(places):
        says = f"{file.name} has {len(found)} values for {len(angles)} angles at {len(places)} places"
        raise TableError(at, says, "one value for every angle at every place")
    values = [[found[angle, place] for place in places] for angle in angles]
    if len(angles) > 1 and abs(angles[-1] - angles[0] - TURN) < 1e-6:
        if max(abs(last - first) for first, last in zip(values[0], values[-1], strict=True)) > CLOSES_TO:
            raise TableError(at, f"{file.name} does not close after a turn", "equal values at both ends")
        angles, values = angles[:-1], values[:-1]
    return {"angles": angles, "places": places, "values": values}


def lines_of(
    file: FilePath, at: Path, kinds: tuple[str, str, str], example: str
) -> list[tuple[int, tuple[float, float, float]]]:
    """Lines of a table of three columns, numbered, each value in the SI unit of its kind."""
    try:
        if file.stat().st_size > LARGEST_TABLE:
            raise TableError(at, f"{file.name} is larger than {LARGEST_TABLE // 1_000_000} MB", example)
        rows = [row for row in csv.reader(file.read_text(encoding="utf-8-sig").splitlines()) if any(row)]
    except (OSError, UnicodeDecodeError, csv.Error):
        raise TableError(at, f"{file.name} cannot be read", example) from None
    heads = [HEADING.match(cell) for cell in rows[0]] if rows else []
    units = [head["unit"] for head in heads if head is not None]
    if len(heads) != len(kinds) or len(units) != len(kinds):
        raise TableError(at, f"{file.name} has no heading with units", example)
    lines = []
    for number, row in enumerate(rows[1:], start=2):
        try:
            first, second, value = (
                read(f"{float(cell)} {unit}", kind) for cell, unit, kind in zip(row, units, kinds, strict=True)
            )
        except (ValueError, QuantityError):
            raise TableError(at, f"row {number} of {file.name} is {shown(','.join(row))}", example) from None
        lines.append((number, (first, second, value)))
    return lines
