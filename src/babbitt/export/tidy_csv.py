"""Tidy CSV: one row per bearing and speed, SI, the unit in every column name, the frame in columns of its own.

Coefficients over frequency stand in further rows, one for each speed and frequency; rows without a frequency hold
those of the speed itself, and the codes of the warnings that question them. Matrices of journal and pads stand in
one cell each, row after row, with their labels; so do the speeds that the table lacks, in every row.

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
from babbitt.core.quantities import AXES
from babbitt.export.coefficients import Array, CoefficientTable
from babbitt.export.frame import Frame, Rotation
from babbitt.export.numbers import number
from babbitt.export.questioned import UNSOLVED
from babbitt.export.unit_names import static_column, static_quantity
from babbitt.export.whirl import OverFrequency, SystemMatrices

_TEXT = ("bearing", "method", "temperatures", "rotation")
_FRAME = ("x_axis_angle_rad", "load_angle_rad")
_SPEED = "speed_rad_per_s"
_FREQUENCY = "frequency_rad_per_s"
_LABELS = "motions"
_WARNINGS = "warnings"
_SYSTEM = {
    "stiffness": "motions_stiffness_N_per_m",
    "damping": "motions_damping_N_s_per_m",
    "mass": "motions_mass_kg",
}
_MATRICES = {"stiffness": ("k", "N_per_m"), "damping": ("c", "N_s_per_m"), "mass": ("m", "kg")}


def columns_of(matrix: str) -> tuple[str, ...]:
    """The four column names of a matrix.

    >>> columns_of("stiffness")
    ('kxx_N_per_m', 'kxy_N_per_m', 'kyx_N_per_m', 'kyy_N_per_m')
    """
    letter, unit = _MATRICES[matrix]
    return tuple(f"{letter}{name}_{unit}" for name in AXES)


def csv_text(tables: CoefficientTable | Iterable[CoefficientTable]) -> str:
    """Write one or more tables as the text of a tidy CSV file; a cell is empty where a table has no value.

    Words that a spreadsheet program would take for a formula have an apostrophe before them, which `read_csv`
    takes away again.
    """
    rows = [row for table in _listed(tables) for row in _rows(table)]
    present = {column for row in rows for column in row}
    ordered = [
        *_TEXT,
        *_FRAME,
        _SPEED,
        _FREQUENCY,
        _WARNINGS,
        *(column for matrix in _MATRICES for column in columns_of(matrix)),
    ]
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
        **({UNSOLVED: _joined(np.array(table.unsolved_speeds))} if table.unsolved_speeds else {}),
    }
    for i, speed in enumerate(table.speeds):
        row = {**shared, _SPEED: float(speed)}
        if table.warnings:
            row[_WARNINGS] = " ".join(table.warnings[i])
        for matrix in _MATRICES:
            values = getattr(table, matrix)
            if values is not None:
                row.update(zip(columns_of(matrix), (float(v) for v in values[i].flat), strict=True))
        row.update({static_column(name): float(values[i]) for name, values in table.static.items()})
        if table.systems:
            system = table.systems[i]
            row[_LABELS] = "; ".join(system.labels)
            row.update({column: _joined(getattr(system, name)) for name, column in _SYSTEM.items()})
        yield row
        over = table.over_frequency
        for j, frequency in enumerate(() if over is None else over.frequencies):
            moving: dict[str, Cell] = {**shared, _SPEED: float(speed), _FREQUENCY: float(frequency)}
            for name in ("stiffness", "damping"):
                values = getattr(over, name)[i, j]
                moving.update(zip(columns_of(name), (float(v) for v in values.flat), strict=True))
            yield moving


def _joined(matrix: Array) -> str:
    """Numbers in one cell, a matrix row after row, in brackets: a minus alone would make a formula of it."""
    return "[" + " ".join(repr(float(one)) for one in matrix.flat) + "]"


def _parted(where: str, cell: str, size: int) -> Array:
    """The matrix of a cell that `_joined` wrote."""
    numbers = _in_cell(where, cell)
    if len(numbers) != size * size:
        raise InputError("E004", f"{where} has {len(numbers)} numbers for {size} labels")
    return np.array(numbers).reshape(size, size)


def _in_cell(where: str, cell: str) -> list[float]:
    """The numbers of a cell that `_joined` wrote."""
    return [number(where, one) for one in cell.strip("[]").split()]


def _table(where: str, name: str, rows: list[dict[str, str]]) -> CoefficientTable:
    """The table of the rows of one bearing."""
    moving = [row for row in rows if row.get(_FREQUENCY)]
    rows = [row for row in rows if not row.get(_FREQUENCY)]
    if not rows:
        raise InputError(
            "E003", f"{where}: {name} has no row without a frequency, for the coefficients of its speeds"
        )
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
        over_frequency=_over_frequency(where, name, moving, len(rows)),
        unsolved_speeds=tuple(_in_cell(f"{where}: {name}, {UNSOLVED}", first.get(UNSOLVED) or "")),
        warnings=tuple(tuple((row.get(_WARNINGS) or "").split()) for row in rows),
        systems=tuple(_system(f"{where}: {name}", row) for row in rows if row.get(_LABELS)),
    )


def _system(where: str, row: dict[str, str]) -> SystemMatrices:
    """The matrices of journal and pads of a row."""
    labels = tuple(label.strip() for label in row[_LABELS].split(";"))
    return SystemMatrices(
        labels, *(_parted(f"{where}, {column}", row.get(column) or "", len(labels)) for column in _SYSTEM.values())
    )


def _over_frequency(where: str, name: str, rows: list[dict[str, str]], speeds: int) -> OverFrequency | None:
    """Coefficients of the rows that have a frequency, speed by speed."""
    if not rows:
        return None
    if len(rows) % speeds:
        raise InputError("E004", f"{where}: {name} has {len(rows)} rows with a frequency for {speeds} speeds")

    def values(title: str) -> Array:
        return np.array([number(f"{where}: {name}, {title}", row[title]) for row in rows]).reshape(speeds, -1)

    def matrix(which: str) -> Array:
        return np.moveaxis(np.array([values(title) for title in columns_of(which)]), 0, -1).reshape(
            speeds, -1, 2, 2
        )

    frequencies = values(_FREQUENCY)
    if np.any(frequencies != frequencies[0]):
        raise InputError("E004", f"{where}: the frequencies of {name} differ from speed to speed")
    return OverFrequency(frequencies[0], matrix("stiffness"), matrix("damping"))
