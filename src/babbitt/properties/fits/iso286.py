"""Tolerance classes of ISO 286: from ``H7`` and a nominal size to the limit deviations."""

from __future__ import annotations

import re
import tomllib
from bisect import bisect_left
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from babbitt.core.notices import InputError
from babbitt.properties.fits.sizes import Deviations

HOLE_LETTERS = ("C", "D", "E", "F", "G", "H", "JS")
SHAFT_LETTERS = ("c", "d", "e", "f", "g", "h", "j", "js")
GRADES = range(4, 13)

_CLASS = re.compile(r"\s*([A-Za-z]{1,2})\s*([0-9]{1,2})\s*")


@dataclass(frozen=True)
class _Steps:
    """Tabulated lengths in um: entry i holds up to and including bound i."""

    bounds: tuple[float, ...]  # mm
    lengths: tuple[float, ...]  # um

    def at(self, size: float, what: str) -> float:
        """Length in m for a size in m."""
        # A size that arithmetic left a hair above 30 mm still belongs to the step that ends there.
        millimetres = round(size * 1e3, 6)
        if not 0.0 < millimetres <= self.bounds[-1]:
            raise InputError(
                "E006",
                f"{what} is tabulated for sizes above 0 up to {self.bounds[-1]:g} mm, "
                f"given {size * 1e3:.6g} mm; give explicit deviations instead",
            )
        return self.lengths[bisect_left(self.bounds, millimetres)] * 1e-6


@dataclass(frozen=True)
class _Tables:
    source: str
    standard_tolerances: dict[int, _Steps]
    clearance_letters: dict[str, _Steps]
    shaft_j: dict[int, _Steps]


@cache
def _tables() -> _Tables:
    raw = tomllib.loads(files("babbitt.properties.fits").joinpath("iso286.toml").read_text(encoding="utf-8"))
    grades = raw["standard_tolerances"]
    return _Tables(
        source=raw["source"],
        standard_tolerances={
            grade: _Steps(tuple(grades["up_to_mm"]), tuple(grades[f"IT{grade}"])) for grade in GRADES
        },
        clearance_letters={
            letter: _Steps(tuple(steps["up_to_mm"]), tuple(steps["distance"]))
            for letter, steps in raw["clearance_letters"].items()
        },
        shaft_j={
            int(grade): _Steps(tuple(steps["up_to_mm"]), tuple(steps["distance"]))
            for grade, steps in raw["shaft_j"].items()
        },
    )


def standard_tolerance(grade: int, nominal: float) -> float:
    """Standard tolerance ITn of ISO 286-1.

    Parameters
    ----------
    grade : int
        Standard tolerance grade, 4 to 12.
    nominal : float
        Nominal size in m, above 0 up to 0.63.

    Returns
    -------
    float
        Tolerance in m.

    Raises
    ------
    InputError
        E005 for another grade, E006 for another size.

    Examples
    --------
    >>> round(standard_tolerance(7, 0.050) * 1e6)
    25
    """
    try:
        steps = _tables().standard_tolerances[grade]
    except KeyError:
        raise InputError(
            "E005",
            f"tolerance grade IT{grade} is not included; allowed are IT{GRADES[0]} to IT{GRADES[-1]}",
        ) from None
    return steps.at(nominal, f"IT{grade}")


def tolerance_limits(tolerance_class: str, nominal: float) -> Deviations:
    """Limit deviations of an ISO 286 tolerance class.

    Capital letters are holes (bores), small letters shafts (journals). For C to H the zone lies above the
    nominal size and begins at the fundamental deviation, for c to h it lies below; js and JS are symmetrical,
    with half the standard tolerance not rounded; j begins at its tabulated lower deviation.

    Parameters
    ----------
    tolerance_class : str
        Letter and grade: C to H or JS, or c to h, j, js, with grade 4 to 12 (j: 5 to 8).
    nominal : float
        Nominal size in m, above 0 up to 0.63 (c and j: 0.5; j8: 0.003).

    Returns
    -------
    Deviations
        Lower and upper deviation in m.

    Raises
    ------
    InputError
        E005 for an unknown class, E006 for a size outside the table.

    Examples
    --------
    >>> f7 = tolerance_limits("f7", 0.050)
    >>> round(f7.lower * 1e6), round(f7.upper * 1e6)
    (-50, -25)
    """
    letter, grade = letter_and_grade(tolerance_class)
    what = f"tolerance class {letter}{grade}"
    width = _tables().standard_tolerances[grade].at(nominal, what)
    if letter in ("js", "JS"):
        return Deviations(-width / 2.0, width / 2.0)
    if letter == "j":
        lower = -_tables().shaft_j[grade].at(nominal, what)
        return Deviations(lower, lower + width)
    distance = _tables().clearance_letters[letter.lower()].at(nominal, what)
    if letter.isupper():
        return Deviations(distance, distance + width)
    return Deviations(-distance - width, -distance)


def letter_and_grade(tolerance_class: str) -> tuple[str, int]:
    """Letter and grade of a tolerance class.

    Raises
    ------
    InputError
        E005 for a class that is not included.

    >>> letter_and_grade("H7")
    ('H', 7)
    """
    match = _CLASS.fullmatch(tolerance_class)
    if match:
        letter, grade = match[1], int(match[2])
        grades = tuple(_tables().shaft_j) if letter == "j" else tuple(GRADES)
        if letter in HOLE_LETTERS + SHAFT_LETTERS and grade in grades:
            return letter, grade
    raise InputError(
        "E005",
        f"tolerance class {tolerance_class!r} is not included; allowed are holes {' '.join(HOLE_LETTERS)} "
        f"and shafts {' '.join(SHAFT_LETTERS)} with grades {GRADES[0]} to {GRADES[-1]} (j: 5 to 8), "
        "such as H7 or e8; or give explicit deviations",
    )
