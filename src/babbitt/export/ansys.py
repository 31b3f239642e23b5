"""Speed-dependent bearing characteristics in the ASCII layout of Ansys Mechanical APDL (element COMBI214).

    3 title lines                              A80
    nbstep, keyunit1, keyunit2                 3I10
    for each speed:
        id, omega                              I10, F10.2
        K11 K12 K21 K22                        4E15.7
        C11 C12 C21 C22                        4E15.7

``keyunit1`` = 0 leaves the coefficients as they are, 1 turns lbf/in into N/m; ``keyunit2`` = 0 leaves the speed as
it is, 1 turns rpm into rad/s. Where the keys are absent both count as 1, so they are always written here.

References
----------
Ansys, Inc.: Rotordynamic Analysis Guide, release 2024 R2, appendix A.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from babbitt.core.files.reading import read_text
from babbitt.core.files.writing import write_text
from babbitt.core.notices import InputError
from babbitt.export.coefficients import CoefficientTable
from babbitt.export.frame import Frame, declaration, declared, settled
from babbitt.export.frames import for_rotor_programs
from babbitt.export.numbers import POUND_PER_INCH, RPM, number

TITLE = 80
"""Columns of a title line."""

_TEMPERATURES = "temperatures: "


def ansys_text(table: CoefficientTable) -> str:
    """Write a table in SI units, axes 1 and 2 being x right and y up; added mass has no place in the layout.

    The third title tells the temperatures for which the coefficients hold and how they were obtained, as far as it
    has room. Coefficients keep eight digits. The speed is written with as many decimals as its ten columns hold
    beside a blank, which parts it from the number of the step for programs that read by words: Fortran takes the
    decimal point that it finds before the two decimals of the format.

    Raises
    ------
    InputError
        E003 for a clockwise table or a speed too high for its columns.
    """
    table = for_rotor_programs(table)
    titles = (table.name, declaration(table.frame), _origin(table))
    lines = [*(title[:TITLE] for title in titles), f"{table.speeds.size:10d}{0:10d}{0:10d}"]
    for step, (speed, stiffness, damping) in enumerate(
        zip(table.speeds, table.stiffness, table.damping, strict=True), 1
    ):
        lines.append(f"{step:10d}{_speed_field(float(speed))}")
        lines += ["".join(f"{value:15.7E}" for value in matrix.flat) for matrix in (stiffness, damping)]
    return "\n".join(lines) + "\n"


def write_ansys(table: CoefficientTable, path: str | Path) -> None:
    """Write a table for Ansys; see `ansys_text`.

    Raises
    ------
    InputError
        E003 for a clockwise table or a speed too high for its columns, E007 when the file cannot be written.
    """
    write_text(path, ansys_text(table))


def read_ansys(path: str | Path, *, frame: Frame | None = None) -> CoefficientTable:
    """Read a table of this layout.

    Parameters
    ----------
    path : str or Path
    frame : Frame, optional
        Where the second title line does not declare it.

    Returns
    -------
    CoefficientTable
        In SI, converted as the keys of the file demand.

    Raises
    ------
    InputError
        E001 for an unreadable file; E003 when lines are missing, a field is no number, or nobody says what the
        frame is.
    """
    lines = read_text(path).splitlines()
    if len(lines) < 4:
        raise InputError(
            "E003", f"{path}: three title lines and a line of counts are due; there are {len(lines)} lines"
        )
    counts = [_field(str(path), lines, 3, i, 10) for i in range(3)]
    steps, pounds, rpm = int(counts[0] or 0), counts[1] != 0.0, counts[2] != 0.0  # an absent key counts as 1
    if steps < 1 or len(lines) < 4 + 3 * steps:
        raise InputError(
            "E003", f"{path}: {steps} speeds need {4 + 3 * max(steps, 1)} lines; there are {len(lines)}"
        )
    speeds, stiffness, damping = [], [], []
    for step in range(steps):
        at = 4 + 3 * step
        speeds.append(_speed(str(path), lines, at))
        stiffness.append([_field(str(path), lines, at + 1, i, 15) for i in range(4)])
        damping.append([_field(str(path), lines, at + 2, i, 15) for i in range(4)])
    if any(None in row for row in [*stiffness, *damping]):
        raise InputError("E003", f"{path}: four coefficients of 15 columns are due on each line")
    scale = POUND_PER_INCH if pounds else 1.0
    temperatures, method = _origin_read(lines[2].strip())
    return CoefficientTable(
        name=lines[0].strip() or Path(path).stem,
        speeds=np.array(speeds) * (RPM if rpm else 1.0),
        stiffness=np.array(stiffness, dtype=np.float64).reshape(-1, 2, 2) * scale,
        damping=np.array(damping, dtype=np.float64).reshape(-1, 2, 2) * scale,
        frame=settled(str(path), declared(lines[1]), frame),
        method=method,
        temperatures=temperatures,
    )


def _origin(table: CoefficientTable) -> str:
    """The third title: temperatures, then as many parts of the method as its columns hold."""
    if not table.temperatures:
        return table.method
    title = f"{_TEMPERATURES}{table.temperatures}"
    for place, part in enumerate(filter(None, table.method.split(", "))):
        longer = f"{title}{', ' if place else '; '}{part}"
        if len(longer) > TITLE:
            break
        title = longer
    return title


def _origin_read(title: str) -> tuple[str, str]:
    """Temperatures and method of a third title.

    >>> _origin_read("temperatures: frozen; Babbitt film"), _origin_read("closed form")
    (('frozen', 'Babbitt film'), ('', 'closed form'))
    """
    if not title.startswith(_TEMPERATURES):
        return "", title
    temperatures, _, method = title.removeprefix(_TEMPERATURES).partition("; ")
    return temperatures, method


def _speed_field(speed: float) -> str:
    """Ten columns with a decimal point, the first of them blank.

    >>> _speed_field(94.24777960769379), _speed_field(0.0)
    (' 94.247780', '  0.000000')
    >>> _speed_field(1047.1975511965977), _speed_field(999999.99)
    (' 1047.1976', ' 999999.99')
    """
    for decimals in range(6, 1, -1):
        text = f"{speed:9.{decimals}f}"
        if len(text) == 9:
            return f" {text}"
    raise InputError("E003", f"the speed {speed} rad/s does not fit into the ten columns of the Ansys layout")


def _field(where: str, lines: list[str], line: int, place: int, width: int) -> float | None:
    """A field of fixed width, None where it is blank."""
    text = lines[line][place * width : (place + 1) * width]
    return number(f"{where}, line {line + 1}, field {place + 1}", text) if text.strip() else None


def _speed(where: str, lines: list[str], line: int) -> float:
    """The second field, F10.2: without a decimal point its last two digits would be decimals."""
    text = lines[line][10:20]
    if "." not in text:
        raise InputError("E003", f"{where}, line {line + 1}: the speed '{text.strip()}' needs a decimal point")
    return number(f"{where}, line {line + 1}, speed", text)
