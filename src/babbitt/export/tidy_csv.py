"""Tidy CSV: one row per bearing and speed, SI, the unit in every column name, the frame in columns of its own.

One header line, comma, decimal point, UTF-8. Rows of several bearings stand below each other, as spreadsheets,
pandas, COMSOL and other programs that interpolate in tables like it.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable
from itertools import zip_longest
from pathlib import Path

import numpy as np

from babbitt.core.files.reading import read_text
from babbitt.core.files.spreadsheet import Cell, read_rows, rows_text
from babbitt.core.files.writing import write_text
from babbitt.core.notices import InputError
from babbitt.export.coefficients import NAMES, Array, CoefficientTable
from babbitt.export.frame import Frame, Rotation
from babbitt.export.numbers import number
from babbitt.export.unit_names import static_column, static_quantity

_TEXT = ("bearing", "method", "temperatures", "rotation")
_FRAME = ("x_axis_angle_rad", "load_angle_rad")
_SPEED = "speed_rad_per_s"
_MATRICES = {"stiffness": ("k", "N_per_m"), "damping": ("c", "N_s_per_m"), "mass": ("m", "kg")}


def columns_of(matrix: str) -> tuple[str, ...]:
    """The four column names of a matrix.

    >>> columns_of("stiffness")
    ('kxx_N_per_m', 'kxy_N_per_m', 'kyx_N_per_m', 'kyy_N_per_m')
    """
    letter, unit = _MATRICES[matrix]
    return tuple(f"{letter}{name}_{unit}" for name in NAMES)


def csv_text(tables: CoefficientTable | Iterable[CoefficientTable]) -> str:
    """Write one or more tables as the text of a tidy CSV file; a cell is empty where a table has no value.

    Words that a spreadsheet program would take for a formula have an apostrophe before them, which `read_csv`
    takes away again.
    """
    rows = [row for table in _listed(tables) for row in _rows(table)]
    present = {column for row in rows for column in row}
    ordered = [*_TEXT, *_FRAME, _SPEED, *(column for matrix in _MATRICES for column in columns_of(matrix))]
    header = [column for column in ordered if column in present]
    header += sorted(present.difference(header))
    return rows_text([header, *([row.get(column) for column in header] for row in rows)])


def write_csv(tables: CoefficientTable | Iterable[CoefficientTable], path: str | Path) -> None:
    """Write one or more tables to a tidy CSV file.

    Parameters
    ----------
    tables : CoefficientTable or iterable of them
        With different names.
    path : str or Path

    Raises
    ------
    InputError
        E004 when two tables have the same name, E007 when the file cannot be written.
    """
    write_text(path, csv_text(tables))


def read_csv(path: str | Path) -> tuple[CoefficientTable, ...]:
    """Read the tables of a tidy CSV file, one for each name in its column ``bearing``.

    Raises
    ------
    InputError
        E001 for an unreadable file, E003 for a missing column or a cell that is no number.
    """
    try:
        header, *cells = read_rows(read_text(path)) or [[]]
    except csv.Error as error:
        raise InputError("E003", f"{path}: not a table of comma-separated values ({error})") from None
    rows = [dict(zip_longest(header, row[: len(header)], fillvalue="")) for row in cells if row]
    needed = ["bearing", "rotation", _SPEED, *columns_of("stiffness"), *columns_of("damping")]
    if missing := [column for column in needed if column not in header]:
        raise InputError("E003", f"{path}: no column {', '.join(missing)}; the first line must name the columns")
    if not rows:
        raise InputError("E003", f"{path}: no row below the column names")
    names = dict.fromkeys(row["bearing"] for row in rows)
    return tuple(_table(str(path), name, [row for row in rows if row["bearing"] == name]) for name in names)


def _listed(tables: CoefficientTable | Iterable[CoefficientTable]) -> list[CoefficientTable]:
    listed = [tables] if isinstance(tables, CoefficientTable) else list(tables)
    names = [table.name for table in listed]
    if repeated := sorted({name for name in names if names.count(name) > 1}):
        raise InputError(
            "E004", f"two tables have the name {', '.join(repeated)}; the name tells their rows apart"
        )
    return listed


def _rows(table: CoefficientTable) -> Iterable[dict[str, Cell]]:
    load = table.frame.load_angle
    shared: dict[str, Cell] = {
        "bearing": table.name,
        "method": table.method,
        **({"temperatures": table.temperatures} if table.temperatures else {}),
        "rotation": table.frame.rotation.value,
        "x_axis_angle_rad": table.frame.x_axis_angle,
        "load_angle_rad": load,
    }
    for i, speed in enumerate(table.speeds):
        row = {**shared, _SPEED: float(speed)}
        for matrix in _MATRICES:
            values = getattr(table, matrix)
            if values is not None:
                row.update(zip(columns_of(matrix), (float(v) for v in values[i].flat), strict=True))
        row.update({static_column(name): float(values[i]) for name, values in table.static.items()})
        yield row


def _table(where: str, name: str, rows: list[dict[str, str]]) -> CoefficientTable:
    """The table of the rows of one bearing."""
    for column in (*_TEXT, *_FRAME):
        if len({row.get(column) for row in rows}) > 1:
            raise InputError("E004", f"{where}: the rows of {name} differ in {column}; give each its own name")

    def numbers(title: str) -> list[float]:
        return [number(f"{where}: {name}, {title}", row[title]) for row in rows]

    def matrix(which: str) -> Array:
        return np.array([numbers(title) for title in columns_of(which)]).T.reshape(-1, 2, 2)

    first = rows[0]
    try:
        rotation = Rotation(first["rotation"])
    except ValueError:
        raise InputError(
            "E003", f"{where}: rotation is '{first['rotation']}'; allowed: counter-clockwise, clockwise"
        ) from None
    load, axis = first.get("load_angle_rad"), first.get("x_axis_angle_rad")
    frame = Frame(
        rotation=rotation,
        load_angle=number(f"{where}: load_angle_rad", load) if load else None,
        x_axis_angle=number(f"{where}: x_axis_angle_rad", axis) if axis else 0.0,
    )
    others = [title for title in first if title is not None and title not in _FRAME]
    known = {title: quantity for title in others if (quantity := static_quantity(title))}
    return CoefficientTable(
        name=name,
        speeds=np.array(numbers(_SPEED)),
        stiffness=matrix("stiffness"),
        damping=matrix("damping"),
        mass=matrix("mass") if first.get(columns_of("mass")[0]) else None,
        frame=frame,
        static={quantity: np.array(numbers(title)) for title, quantity in known.items() if first[title]},
        method=first.get("method") or "",
        temperatures=first.get("temperatures") or "",
    )
