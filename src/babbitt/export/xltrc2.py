"""Tables as XLTRC2 keeps its bearings: a row of names, a row of units, one row for each speed.

Programs for rotor dynamics read or paste this layout: ``Speed, Kxx, Kxy, Kyx, Kyy, Cxx, Cxy, Cyx, Cyy`` and added
masses, speed in rpm, and the units row decides between N/m and lb/in. Axes x right, y up, rotation from x towards
y. The layout has no place for the frame: in CSV it stands in lines above the names, in a workbook on a second
sheet, because readers look for "rpm" and "lb" anywhere on the first. So do the codes of warnings, in a cell for
each speed.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from babbitt.core.files.reading import read_text
from babbitt.core.files.spreadsheet import Cell, openpyxl_library, read_rows, rows_text, workbook
from babbitt.core.files.writing import write_file, write_text
from babbitt.core.notices import InputError
from babbitt.core.quantities import AXES
from babbitt.export.coefficients import Array, CoefficientTable
from babbitt.export.frame import Frame, declaration, declared, settled
from babbitt.export.frames import for_rotor_programs
from babbitt.export.numbers import POUND_PER_INCH, RPM, number, rounded_rpm

_UNITS = {"k": "N/m", "c": "N-s/m", "m": "kg"}

_STIFFNESS = {"N/m": 1.0, "kN/m": 1e3, "MN/m": 1e6, "N/mm": 1e3, "kN/mm": 1e6} | dict.fromkeys(
    ("lb/in", "lbf/in"), POUND_PER_INCH
)
_DAMPING = {unit.replace("/", "-s/"): scale for unit, scale in _STIFFNESS.items()}
_MASS = {"kg": 1.0, "t": 1e3} | {unit.replace("/", "-s2/"): scale for unit, scale in _STIFFNESS.items()}
_SPEED = {"rpm": RPM, "rad/s": 1.0}
_SCALES = {"k": _STIFFNESS, "c": _DAMPING, "m": _MASS}
"""Units of each kind of column, and what turns them into SI."""


def write_xltrc2(table: CoefficientTable, path: str | Path) -> None:
    """Write a table in SI units and rpm.

    Parameters
    ----------
    table : CoefficientTable
        Counter-clockwise; axes that are not x right, y up are turned back.
    path : str or Path
        ``.csv``, or ``.xlsx`` where the package openpyxl is installed.

    Raises
    ------
    InputError
        E003 for another suffix or a clockwise table, E007 when the file cannot be written or openpyxl is missing.
    """
    path = Path(path)
    table = for_rotor_programs(table)
    notes = [["Bearing", table.name], ["Frame", declaration(table.frame)], ["Method", table.method]]
    if table.temperatures:
        notes.append(["Temperatures", table.temperatures])
    if table.warnings:
        notes.append(["Warnings", *(" ".join(codes) for codes in table.warnings)])
    if path.suffix.lower() == ".csv":
        write_text(path, rows_text([*notes, *_grid(table)]))
    elif path.suffix.lower() == ".xlsx":
        write_file(path, workbook({"Coefficients": _grid(table), "Frame": notes}, path))
    else:
        raise InputError("E003", f"{path}: an XLTRC2-style table is written to .csv or .xlsx")


def read_xltrc2(path: str | Path, *, name: str | None = None, frame: Frame | None = None) -> CoefficientTable:
    """Read a table of this layout, in SI or in US units.

    Parameters
    ----------
    path : str or Path
        ``.csv``, or ``.xlsx`` where the package openpyxl is installed.
    name : str, optional
        Of the bearing; the name in the file, or else of the file.
    frame : Frame, optional
        Where the file does not declare it.

    Returns
    -------
    CoefficientTable

    Raises
    ------
    InputError
        E001 for an unreadable file; E003 without a row of names and a row of units, for a cell that is no number,
        or when nobody says what the frame is.
    """
    path = Path(path)
    rows, notes = _read_workbook(path) if path.suffix.lower() == ".xlsx" else (_read_csv(path), [])
    head = next((i for i, row in enumerate(rows) if "kxx" in _lower(row)), None)
    if head is None or head + 1 >= len(rows):
        raise InputError("E003", f"{path}: no row of names with 'Kxx' and a row of units below it")
    titles, units = _lower(rows[head]), [str(cell or "").strip() for cell in rows[head + 1]]
    cells = {
        str(row[0]).strip().lower(): [str(cell or "") for cell in row[1:]]
        for row in [*rows[:head], *notes]
        if len(row) > 1 and row[0]
    }
    said = {title: texts[0] for title, texts in cells.items()}
    data = _in_si(str(path), _data(str(path), rows[head + 2 :], titles), dict(zip(titles, units, strict=False)))

    def matrix(letter: str) -> Array:
        return np.array([data[letter + entry] for entry in AXES]).T.reshape(-1, 2, 2)

    return CoefficientTable(
        name=name or said.get("bearing") or path.stem,
        speeds=np.array(data["speed"]),
        stiffness=matrix("k"),
        damping=matrix("c"),
        mass=matrix("m") if all("m" + entry in data for entry in AXES) else None,
        frame=settled(str(path), declared(said.get("frame", "")), frame),
        method=said.get("method", ""),
        temperatures=said.get("temperatures", ""),
        warnings=_warnings(cells.get("warnings", []), len(data["speed"])),
    )


def _warnings(cells: Sequence[str], speeds: int) -> tuple[tuple[str, ...], ...]:
    """Codes of every speed; rows of a workbook lose or gain empty cells at their ends."""
    used = max((i for i, codes in enumerate(cells, 1) if codes.strip()), default=0)
    return tuple(tuple(codes.split()) for codes in (*cells[:used], *[""] * (speeds - used)))


def _grid(table: CoefficientTable) -> list[list[Cell]]:
    """Names, units and rows."""
    matrices = {"k": table.stiffness, "c": table.damping, "m": table.mass}
    present = {letter: values for letter, values in matrices.items() if values is not None}
    titles = ["Speed", *(letter.upper() + entry for letter in present for entry in AXES)]
    units = ["rpm", *(_UNITS[letter] for letter in present for _ in AXES)]
    speeds = [rounded_rpm(speed) for speed in table.speeds.tolist()]
    numbers = np.column_stack([speeds, *(values.reshape(-1, 4) for values in present.values())])
    rows: list[list[Cell]] = [[*titles], [*units]]
    return rows + [[*row] for row in numbers.tolist()]


def _lower(row: Sequence[Cell]) -> list[str]:
    return [str(cell or "").strip().lower() for cell in row]


def _data(where: str, rows: Iterable[Sequence[Cell]], titles: list[str]) -> dict[str, list[float]]:
    """Columns of numbers down to the first row that does not begin with one."""
    needed = ["speed", *("k" + entry for entry in AXES), *("c" + entry for entry in AXES)]
    if missing := [title for title in needed if title not in titles]:
        raise InputError("E003", f"{where}: no column {', '.join(missing)}")
    wanted = {title: i for i, title in enumerate(titles) if title in needed or title in {"m" + e for e in AXES}}
    data: dict[str, list[float]] = {title: [] for title in wanted}
    for row in rows:
        first = row[wanted["speed"]] if len(row) > wanted["speed"] else None
        if first is None or not str(first).strip():
            break
        for title, i in wanted.items():
            data[title].append(number(f"{where}: {title}", row[i] if i < len(row) else ""))
    return data


def _in_si(where: str, data: dict[str, list[float]], units: dict[str, str]) -> dict[str, list[float]]:
    """Bring every column to SI by its own unit."""
    scales = {title: _scale(where, title, units.get(title, "")) for title in data}
    return {title: [scales[title] * value for value in column] for title, column in data.items()}


def _scale(where: str, title: str, unit: str) -> float:
    """What turns a column into SI."""
    known = _SPEED if title == "speed" else _SCALES[title[0]]
    spelled = _spelled(unit)
    lower = {name.lower(): scale for name, scale in known.items() if not name.startswith("M")}
    if (scale := known.get(spelled, lower.get(spelled.lower()))) is None:
        shown = title if title == "speed" else title.capitalize()
        raise InputError(
            "E003",
            f"{where}: the unit of {shown} is '{unit}'; the row below the names must say one of "
            f"{', '.join(known)}",
        )
    return scale


def _spelled(unit: str) -> str:
    """Bring the ways of writing a unit to one.

    >>> _spelled("lb*sec/in"), _spelled("N·s/m"), _spelled("lbf s^2/in"), _spelled("Ns/m")
    ('lb-s/in', 'N-s/m', 'lbf-s2/in', 'N-s/m')
    """
    text = re.sub(r"[\s·*.]+", "-", unit.strip()).replace("sec", "s").replace("^", "").replace("²", "2")
    return re.sub(r"N(s2?/)", r"N-\1", text)


def _read_csv(path: Path) -> list[list[Cell]]:
    try:
        return [list(row) for row in read_rows(read_text(path))]
    except csv.Error as error:
        raise InputError("E003", f"{path}: not a table of comma-separated values ({error})") from None


def _read_workbook(path: Path) -> tuple[list[list[Cell]], list[list[Cell]]]:
    library = openpyxl_library(path)
    try:
        book = library.load_workbook(path, read_only=True, data_only=True)
    except Exception as error:  # openpyxl, zipfile and the XML parser each raise their own
        raise InputError("E001", f"{path}: is not a workbook that can be read ({error})") from None
    sheets = [[list(row) for row in sheet.iter_rows(values_only=True)] for sheet in book.worksheets]
    book.close()
    return sheets[0], [row for sheet in sheets[1:] for row in sheet]
