"""Tables of displacement that a case names: CSV with a line for every angle and axial place."""

from __future__ import annotations

import math
from typing import Any

from babbitt.case.error_messages import Path, shown
from babbitt.case.named_files import NamedFiles, TableError
from babbitt.core.files.printing import printable
from babbitt.kinds.journal.case.bore_file import CLOSES_TO, rows_of_table
from babbitt.kinds.journal.case.every_bearing import for_every_bearing

EXAMPLE = "three columns with the heading 'angle [deg],z [mm],displacement [um]'"

KINDS = ("rad", "m", "m")

TURN = 2.0 * math.pi


def with_displacements(given: dict[str, Any], files: NamedFiles) -> dict[str, Any]:
    """Put the values of every table of displacement in the place of its file.

    Parameters
    ----------
    given : dict
        A case as it stands in the file; it is not changed.
    files : NamedFiles
        What the case may read.

    Raises
    ------
    TableError
        For the first table that cannot be used.
    """
    return for_every_bearing(given, lambda bearing, path: _with_table(bearing, path, files))


def _with_table(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    table = bearing.get("displacement")
    if not (isinstance(table, dict) and "file" in table and "values" not in table):
        return dict(bearing)
    at = (*path, "displacement", "file")
    if not isinstance(table["file"], str):
        raise TableError(at, f"{shown(table['file'])} is not the name of a file", EXAMPLE)
    rest = {name: value for name, value in table.items() if name != "file"}
    return bearing | {"displacement": rest | displacement_of(files, table["file"], at)}


def displacement_of(files: NamedFiles, name: str, at: Path) -> dict[str, Any]:
    """Angles, places and values of a table, whose lines may stand in any order, in SI."""
    found: dict[tuple[float, float], float] = {}
    for line, (angle, place, value) in rows_of_table(files, name, at, KINDS, EXAMPLE):
        if (angle, place) in found:
            raise TableError(
                at, f"line {line} of {printable(name)} repeats an angle and place", "each of them once"
            )
        found[angle, place] = value
    angles, places = sorted({angle for angle, _ in found}), sorted({place for _, place in found})
    if len(found) != len(angles) * len(places):
        says = f"{printable(name)} has {len(found)} values for {len(angles)} angles at {len(places)} places"
        raise TableError(at, says, "one value for every angle at every place")
    values = [[found[angle, place] for place in places] for angle in angles]
    if len(angles) > 1 and abs(angles[-1] - angles[0] - TURN) < 1e-6:
        if max(abs(last - first) for first, last in zip(values[0], values[-1], strict=True)) > CLOSES_TO:
            raise TableError(at, f"{printable(name)} does not close after a turn", "equal values at both ends")
        angles, values = angles[:-1], values[:-1]
    return {"angles": angles, "places": places, "values": values}
