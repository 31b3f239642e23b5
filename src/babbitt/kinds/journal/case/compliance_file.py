"""Matrices of compliance that a case names: CSV with a line for every pair of angles, or NPZ."""

from __future__ import annotations

import io
import zipfile
import zlib
from typing import TYPE_CHECKING, Any

from babbitt.case.error_messages import Path
from babbitt.case.named_files import NamedFiles, TableError, with_its_file
from babbitt.core.files.printing import printable
from babbitt.core.units import SiNumber
from babbitt.kinds.journal.case.bore_file import LARGEST_TABLE, rows_of_table
from babbitt.kinds.journal.case.every_bearing import for_every_bearing

if TYPE_CHECKING:
    from numpy.typing import NDArray

EXAMPLE = (
    "CSV of three columns with the heading 'angle [deg],loaded [deg],compliance [um/MPa]', or NPZ with the arrays "
    "angles (rad) and compliance (m/Pa)"
)

KINDS = ("rad", "rad", "m/Pa")

LARGEST_UNPACKED = 4_000_000
"""Bytes of all arrays of an NPZ together; the largest matrix that a case may have takes a fifteenth of it."""


def with_compliances(given: dict[str, Any], files: NamedFiles) -> dict[str, Any]:
    """Put the values of every matrix of compliance in the place of its file; as `CaseFile.with_named_files`."""
    return for_every_bearing(given, lambda bearing, path: _with_matrices(bearing, path, files))


def _with_matrices(bearing: dict[str, Any], path: Path, files: NamedFiles) -> dict[str, Any]:
    parts = bearing.get("compliance")
    if not isinstance(parts, list):
        return dict(bearing)
    return bearing | {
        "compliance": [_with_matrix(part, (*path, "compliance", index), files) for index, part in enumerate(parts)]
    }


def _with_matrix(part: Any, at: Path, files: NamedFiles) -> Any:
    if not (isinstance(part, dict) and part.get("kind") == "file" and "file" in part and "values" not in part):
        return part
    return with_its_file(part, at, EXAMPLE, lambda *named: matrix_of(files, *named))


def matrix_of(files: NamedFiles, name: str, at: Path) -> dict[str, Any]:
    """Angles (rad) and values (m/Pa) of a matrix, a row for every angle that gives way."""
    return (_of_arrays if name.lower().endswith(".npz") else _of_lines)(files, name, at)


def _of_lines(files: NamedFiles, name: str, at: Path) -> dict[str, Any]:
    found: dict[tuple[float, float], float] = {}
    for line, (angle, loaded, value) in rows_of_table(files, name, at, KINDS, EXAMPLE):
        if (angle, loaded) in found:
            raise TableError(at, f"line {line} of {name} repeats a pair of angles", "each of them once")
        found[angle, loaded] = value
    angles = sorted({angle for angle, _ in found})
    if angles != sorted({loaded for _, loaded in found}) or len(found) != len(angles) ** 2:
        says = f"{name} has {len(found)} values for {len(angles)} angles"
        raise TableError(at, says, "one value for every angle loaded at every angle")
    return {"angles": angles, "values": [[found[angle, loaded] for loaded in angles] for angle in angles]}


def _of_arrays(files: NamedFiles, name: str, at: Path) -> dict[str, Any]:
    import numpy as np

    content = files.content(name, at, LARGEST_TABLE, EXAMPLE)
    name = printable(name)
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:  # whose reader unpacks no more than is declared
            unpacked = sum(member.file_size for member in archive.infolist())
        if unpacked > LARGEST_UNPACKED:
            limit = f"{LARGEST_UNPACKED // 1_000_000} MB"
            raise TableError(at, f"{name} unpacks to more than {limit}", EXAMPLE)
        with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
            angles, values = (_numbers(arrays[which]) for which in ("angles", "compliance"))
    except KeyError as error:
        raise TableError(at, f"{name} lacks an array: {printable(error.args[0])}", EXAMPLE) from None
    except (OSError, EOFError, ValueError, TypeError, MemoryError, RuntimeError, zlib.error, zipfile.BadZipFile):
        raise TableError(at, f"{name} cannot be read", EXAMPLE) from None
    if angles.ndim != 1 or values.shape != (angles.size, angles.size):
        says = f"compliance of {name} has the shape {values.shape} for angles of {angles.shape}"
        raise TableError(at, says, "a row and a column for every angle")
    return {
        "angles": [SiNumber(angle) for angle in angles.tolist()],
        "values": [[SiNumber(value) for value in row] for row in values.tolist()],
    }


def _numbers(array: NDArray[Any]) -> NDArray[Any]:
    """An array of real numbers as such.

    Raises
    ------
    TypeError
        For text, times or complex numbers.
    """
    if array.dtype.kind not in "fiu":
        raise TypeError(f"no numbers: {array.dtype}")
    return array.astype(float)
