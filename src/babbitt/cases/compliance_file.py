"""Matrices of compliance that a case names: CSV with a line for every pair of angles, or NPZ."""

from __future__ import annotations

import zipfile
from pathlib import Path as FilePath
from typing import Any

from babbitt.cases.bore_file import LARGEST_TABLE, TableError, rows_of_table
from babbitt.cases.every_bearing import for_every_bearing
from babbitt.cases.plain_words import Path, shown
from babbitt.units import SiNumber

EXAMPLE = (
    "CSV of three columns with the heading 'angle [deg],loaded [deg],compliance [um/MPa]', or NPZ with the arrays "
    "angles (rad) and compliance (m/Pa)"
)

KINDS = ("rad", "rad", "m/Pa")


def with_compliances(given: dict[str, Any], folder: FilePath) -> dict[str, Any]:
    """Put the values of every matrix of compliance in the place of its file.

    Parameters
    ----------
    given : dict
        A case as it stands in the file; it is not changed.
    folder : Path
        What the files are named from.

    Raises
    ------
    TableError
        For the first file that cannot be used.
    """
    return for_every_bearing(given, lambda bearing, path: _with_matrices(bearing, path, folder))


def _with_matrices(bearing: dict[str, Any], path: Path, folder: FilePath) -> dict[str, Any]:
    parts = bearing.get("compliance")
    if not isinstance(parts, list):
        return dict(bearing)
    return bearing | {
        "compliance": [
            _with_matrix(part, (*path, "compliance", index, "file"), folder) for index, part in enumerate(parts)
        ]
    }


def _with_matrix(part: Any, at: Path, folder: FilePath) -> Any:
    if not (isinstance(part, dict) and part.get("kind") == "file" and "file" in part and "values" not in part):
        return part
    if not isinstance(part["file"], str):
        raise TableError(at, f"{shown(part['file'])} is not the name of a file", EXAMPLE)
    rest = {name: value for name, value in part.items() if name != "file"}
    return rest | matrix_of(folder / part["file"], at)


def matrix_of(file: FilePath, at: Path) -> dict[str, Any]:
    """Angles (rad) and values (m/Pa) of a matrix, a row for every angle that gives way."""
    return _of_arrays(file, at) if file.suffix.lower() == ".npz" else _of_lines(file, at)


def _of_lines(file: FilePath, at: Path) -> dict[str, Any]:
    found: dict[tuple[float, float], float] = {}
    for line, (angle, loaded, value) in rows_of_table(file, at, KINDS, EXAMPLE):
        if (angle, loaded) in found:
            raise TableError(at, f"line {line} of {file.name} repeats a pair of angles", "each of them once")
        found[angle, loaded] = value
    angles = sorted({angle for angle, _ in found})
    if angles != sorted({loaded for _, loaded in found}) or len(found) != len(angles) ** 2:
        says = f"{file.name} has {len(found)} values for {len(angles)} angles"
        raise TableError(at, says, "one value for every angle loaded at every angle")
    return {"angles": angles, "values": [[found[angle, loaded] for loaded in angles] for angle in angles]}


def _of_arrays(file: FilePath, at: Path) -> dict[str, Any]:
    import numpy as np

    try:
        if file.stat().st_size > LARGEST_TABLE:
            raise TableError(at, f"{file.name} is larger than {LARGEST_TABLE // 1_000_000} MB", EXAMPLE)
        with np.load(file, allow_pickle=False) as arrays:
            angles = np.asarray(arrays["angles"], dtype=float)
            values = np.asarray(arrays["compliance"], dtype=float)
    except KeyError as error:
        raise TableError(at, f"{file.name} lacks an array: {error.args[0]}", EXAMPLE) from None
    except (OSError, ValueError, TypeError, zipfile.BadZipFile):
        raise TableError(at, f"{file.name} cannot be read", EXAMPLE) from None
    if angles.ndim != 1 or values.shape != (angles.size, angles.size):
        says = f"compliance of {file.name} has the shape {values.shape} for angles of {angles.shape}"
        raise TableError(at, says, "a row and a column for every angle")
    return {
        "angles": [SiNumber(angle) for angle in angles],
        "values": [[SiNumber(value) for value in row] for row in values],
    }
