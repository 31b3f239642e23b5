"""Files that a case names: measured bores and changing loads (CSV), tables of limits (TOML)."""

from __future__ import annotations

import csv
import math
import re
from itertools import pairwise
from typing import Any

from babbitt.case.error_messages import Path, shown
from babbitt.case.named_files import NamedFiles, TableError, with_its_file
from babbitt.core.files.printing import printable
from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, SiNumber, read
from babbitt.kinds.journal.case.every_bearing import for_every_bearing
from babbitt.properties.materials import parse_experience_limits

POINTS = 360
"""Points at equal steps to which a table is interpolated."""

LARGEST_STEP = math.radians(45.0)
"""Largest angle between two points of a table."""

CLOSES_TO = 1e-6
"""m. First and last point of a table over a whole turn may differ by this."""

LARGEST_TABLE = 1_000_000
"""Bytes."""

LARGEST_LIMITS = 100_000
"""Bytes."""

LIMITS_FORM = "a TOML file in the form of the shipped limits.toml"

HEADING = re.compile(r"^\s*[^\[\](]+?\s*[\[(]\s*(?P<unit>[^\])]+?)\s*[\])]\s*$")

EXAMPLE = "two columns with the heading 'angle [deg],departure [um]'"

LOAD_EXAMPLE = "three columns with the heading 'angle [deg],fx [kN],fy [kN]'"

MOST_LOADS = 1440
"""Points of a changing load."""


def with_tables(given: dict[str, Any], files: NamedFiles) -> dict[str, Any]:
    """Put the points of measured bores and changing loads, and the text of tables of limits, in place of their
    files; as `CaseFile.with_named_files`.
    """
    return for_every_bearing(given, lambda bearing, path: _with_table(bearing, path, files))


def _with_table(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    return _with_limits(_with_load(_with_bore(bearing, path, files), path, files), path, files)


def _with_limits(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    limits = bearing.get("limits")
    if not (isinstance(limits, dict) and isinstance(limits.get("tables"), str)):
        return bearing
    name, at = limits["tables"], (*path, "limits", "tables")
    if "\n" in name:  # the text itself, of a case that was read before
        return bearing
    text = files.text(name, at, LARGEST_LIMITS, LIMITS_FORM)
    try:
        parse_experience_limits(text, printable(name))
    except ValueError:
        raise TableError(at, f"{printable(name)} cannot be read", LIMITS_FORM) from None
    except InputError as error:
        raise TableError(at, error.message, LIMITS_FORM) from None
    return bearing | {"limits": limits | {"tables": text}}


def _with_bore(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    bore = bearing.get("bore")
    if not (
        isinstance(bore, dict) and bore.get("kind") == "measured" and "file" in bore and "departures" not in bore
    ):
        return dict(bearing)

    def read(name: str, at: Path) -> dict[str, Any]:
        return {"departures": departures_of(files, name, at)}

    return bearing | {"bore": with_its_file(bore, (*path, "bore"), EXAMPLE, read)}


def _with_load(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    load = bearing.get("dynamic_load")
    if not (isinstance(load, dict) and load.get("kind") == "table" and "file" in load and "angle" not in load):
        return bearing

    def read(name: str, at: Path) -> dict[str, Any]:
        rows = [row for _, row in rows_of_table(files, name, at, ("rad", "N", "N"), LOAD_EXAMPLE)]
        if len(rows) > MOST_LOADS:
            raise TableError(at, f"{printable(name)} has {len(rows)} points", f"at most {MOST_LOADS}")
        return {column: [row[place] for row in rows] for place, column in enumerate(("angle", "fx", "fy"))}

    return bearing | {"dynamic_load": with_its_file(load, (*path, "dynamic_load"), LOAD_EXAMPLE, read)}


def departures_of(files: NamedFiles, name: str, at: Path) -> list[float]:
    """Departures in m at equal steps from angle 0, interpolated linearly between the points of a table."""
    points = [(row[0], row[1]) for _, row in rows_of_table(files, name, at, ("rad", "m"), EXAMPLE)]
    return _once_around(points, printable(name), at)


def rows_of_table(
    files: NamedFiles, name: str, at: Path, kinds: tuple[str, ...], example: str
) -> list[tuple[int, tuple[float, ...]]]:
    """Rows of a CSV table whose heading has the units: the line, and each column in its SI unit.

    Parameters
    ----------
    files : NamedFiles
    name : str
        Of the table, as it stands in the case.
    at : tuple
        Where in the case the table is named.
    kinds : tuple of str
        SI unit of each column.
    example : str
        How a table is written.

    Raises
    ------
    TableError
        For a file that is missing or not readable, without heading, or with a row that is not of numbers.
    """
    try:
        reader = csv.reader(files.text(name, at, LARGEST_TABLE, example).splitlines())
        rows = [(reader.line_num, row) for row in reader if any(row)]
    except csv.Error:
        raise TableError(at, f"{printable(name)} cannot be read", example) from None
    name = printable(name)
    heading = [HEADING.match(cell) for cell in rows[0][1]] if rows else []
    units = [match["unit"] for match in heading if match is not None]
    if not len(units) == len(heading) == len(kinds):
        raise TableError(at, f"{name} has no heading with units", example)
    found: list[tuple[int, tuple[float, ...]]] = []
    for line, row in rows[1:]:
        for cell in row:
            if not _is_finite(cell):
                raise TableError(at, f"line {line} of {name}: {shown(cell)} is not a finite number", example)
        try:
            values = [read(f"{float(c)} {unit}", si) for c, unit, si in zip(row, units, kinds, strict=True)]
            found.append((line, tuple(SiNumber(value) for value in values)))
        except (ValueError, QuantityError):
            raise TableError(at, f"line {line} of {name} is {shown(','.join(row))}", example) from None
    return found


def _is_finite(cell: str) -> bool:
    try:
        return math.isfinite(float(cell))
    except ValueError:
        return False


def _once_around(points: list[tuple[float, float]], name: str, at: Path) -> list[float]:
    turn = 2.0 * math.pi
    if len(points) < 8:
        raise TableError(at, f"{name} has {len(points)} points", "at least 8")
    steps = [after[0] - before[0] for before, after in pairwise(points)]
    whole = points[-1][0] - points[0][0]
    if min(steps) <= 0.0 or whole > turn * (1.0 + 1e-6):
        raise TableError(at, f"the angles of {name} do not rise once around", "rising angles over one turn")
    if whole > turn * (1.0 - 1e-6):
        if abs(points[-1][1] - points[0][1]) > CLOSES_TO:
            gap = 1e6 * abs(points[-1][1] - points[0][1])
            raise TableError(
                at, f"{name} does not close: its ends are {gap:.3g} um apart", "equal values at both ends"
            )
        points = points[:-1]
    if max(*steps, turn - whole) > LARGEST_STEP:
        raise TableError(at, f"{name} leaves a gap between its points", "steps of at most 45 deg all around")
    import numpy as np

    places = np.arange(POINTS) * (turn / POINTS)
    found = np.interp(places, [angle for angle, _ in points], [value for _, value in points], period=turn)
    return [SiNumber(value) for value in found]
