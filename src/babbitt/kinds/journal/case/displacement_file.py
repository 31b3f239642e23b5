"""Tables of displacement that a case names: CSV with a line for every angle and axial place."""

from __future__ import annotations

import math
from typing import Any

from babbitt.case.error_messages import Path
from babbitt.case.named_files import NamedFiles, TableError, with_its_file
from babbitt.core.files.printing import printable
from babbitt.kinds.journal.case.bore_file import CLOSES_TO, rows_of_table
from babbitt.kinds.journal.case.every_bearing import for_every_bearing

EXAMPLE = "three columns with the heading 'angle [deg],z [mm],displacement [um]'"

KINDS = ("rad", "m", "m")

TURN = 2.0 * math.pi


def with_displacements(given: dict[str, Any], files: NamedFiles) -> dict[str, Any]:
    """Put the values of every table of displacement in the place of its file; as `CaseFile.with_named_files`."""
    return for_every_bearing(given, lambda bearing, path: _with_table(bearing, path, files))


def _with_table(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    table = bearing.get("displacement")
    if not (isinstance(table, dict) and "file" in table and "values" not in table):
        return dict(bearing)
    filled = with_its_file(table, (*path, "displacement"), EXAMPLE, lambda *named: displacement_of(files, *named))
    return bearing | {"displacement": filled}


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
