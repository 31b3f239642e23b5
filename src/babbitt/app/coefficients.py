"""Coefficients over speed as a file for a rotor program, as `babbitt export` writes them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from babbitt.app.answer import NAME, Fault, Table, faults_of, read
from babbitt.app.document import CaseDocument
from babbitt.app.form import as_text, quantities
from babbitt.app.progress import followed
from babbitt.app.units import split
from babbitt.case import CaseError, located
from babbitt.core.language import translated
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.units import QuantityError, si
from babbitt.export import FORMATS, CoefficientTable, export, mirrored
from babbitt.export.frame import declaration
from babbitt.report.questioned_coefficients import code_lines, format_lines, left_out_lines
from babbitt.study.table_target import chosen_problem

__all__ = ["FEWEST", "CoefficientFile", "Speeds", "coefficient_file", "first_speeds"]

FEWEST = max(one.fewest_speeds for one in FORMATS.values())
"""Speeds that every format takes."""

SPEED = si("rad/s")

RANGE = (0.5, 1.5)
"""First ends of the speeds, over that of the case."""


@dataclass(frozen=True)
class Speeds:
    """First and last speed as a case file has them, and how many."""

    first: str
    last: str
    number: int = 10


@dataclass(frozen=True)
class CoefficientFile:
    """What is wrong with a case, or a file for a rotor program, its coefficients and what to know of it."""

    faults: tuple[Fault, ...] = ()
    name: str = ""
    content: bytes = b""
    tables: tuple[Table, ...] = ()
    remarks: tuple[str, ...] = ()


def first_speeds(document: CaseDocument) -> Speeds:
    """The speeds to begin with: about that of the case."""
    for entry in quantities(document.items):
        number, unit = split(as_text(entry.value), entry.units)
        if entry.path[-1] == "speed" and (value := abs(float(number))):
            first, last = (f"{share * value:.6g} {unit}" for share in RANGE)
            return Speeds(first, last)
    return Speeds("500 rpm", "5000 rpm")


def coefficient_file(
    text: str, bearing: str | None, speeds: Speeds, format_name: str, progress: str
) -> CoefficientFile:
    """Solve a bearing over speed and write its coefficients, never raising for what stands in the case.

    Parameters
    ----------
    text : str
    bearing : str or None
        Which one, where the case has several.
    speeds : Speeds
    format_name : str
        One of `babbitt.export.FORMATS`. A table of a journal that turns clockwise is seen from the other end of
        the shaft where the format has no place for the sense.
    progress : str
        File for `babbitt.app.progress`.
    """
    try:
        case = read(text)
    except CaseError as error:
        return CoefficientFile(faults_of(error))
    wanted = FORMATS[format_name]
    try:
        problem, method = chosen_problem(case, Path(NAME), bearing)
        turned = method.is_clockwise(problem) and not wanted.either_rotation
        (run,) = (method.coefficients_over_speed(problem, one) for one in followed([_spaced(speeds)], progress))
        table = mirrored(run.table()) if turned else run.table()
    except InputError as error:
        return CoefficientFile(faults_of(located(error, case, NAME)))
    name = f"coefficients{wanted.suffixes[0]}"
    with TemporaryDirectory(prefix="babbitt-") as folder:
        file = Path(folder) / name
        export(table, file, format_name)
        return CoefficientFile(
            (), name, file.read_bytes(), (shown_coefficients(table),),
            (*left_out_lines(run), *_remarks(table, turned, format_name)),
        )  # fmt: skip


def shown_coefficients(table: CoefficientTable) -> Table:
    """Stiffness and damping over speed in the engineer's units, with the codes that question them."""
    speed = QUANTITIES["angular_speed"]
    heads, columns = [speed.display.label], [[speed.format(float(one)) for one in table.speeds]]
    for name, matrices in (("stiffness", table.stiffness), ("damping", table.damping)):
        unit = QUANTITIES[f"{name}_xx"].suited(*map(float, matrices.flat))
        for (i, first), (j, second) in product(enumerate("xy"), repeat=2):
            quantity = QUANTITIES[f"{name}_{first}{second}"]
            heads.append(f"{quantity.symbol} {unit.display.label}")
            columns.append([unit.format(float(value)) for value in matrices[:, i, j]])
    if any(table.warnings):
        heads.append(translated("questioned by"))
        columns.append([" ".join(codes) for codes in table.warnings])
    return Table("", tuple(heads), tuple(zip(*columns, strict=True)), words=0)


def _remarks(table: CoefficientTable, turned: bool, format_name: str) -> list[str]:
    """What the terminal says of a table, too."""
    said = [f"{table.speeds.size} speeds; {declaration(table.frame)}; temperatures: {table.temperatures}"]
    if turned:
        said.append("The bearing is seen from the other end of the shaft: build the rotor from that end.")
    return [*said, *code_lines(table), *format_lines(table, format_name)]


def _spaced(speeds: Speeds) -> list[float]:
    """In rad/s.

    Raises
    ------
    InputError
        E003 for what is no speed, or for speeds that do not rise.
    """
    try:
        first, last = SPEED(speeds.first), SPEED(speeds.last)
    except QuantityError as error:
        raise InputError("E003", f"speeds: {error}; allowed: such as 500 rpm") from None
    if not 0.0 < first < last:
        raise InputError("E003", f"speeds: {speeds.first} to {speeds.last} do not rise from above zero")
    if speeds.number < FEWEST:
        raise InputError("E003", f"speeds: {speeds.number} are given; at least {FEWEST} are needed")
    return [float(one) for one in np.linspace(first, last, speeds.number)]
