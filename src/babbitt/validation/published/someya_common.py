"""What both tables of Someya's databook share: the engine's row, and what a table says against itself."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from babbitt.reynolds.model import JournalFilm
from babbitt.validation.case import Comparison
from babbitt.validation.published.film_bearings import (
    CLEARANCE,
    Array,
    at_rest,
    coefficients,
    load_of,
    side_flow_ratio,
)
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

WIDTH_RATIO = 0.5
GROOVE = math.radians(10.0)
STIFFNESS = ("Kxx", "Kxy", "Kyx", "Kyy")
DAMPING = ("Bxx", "Bxy", "Byx", "Byy")
IDENTITY = "identity of every locus"
CITATION = (
    "T. Someya (ed.), *Journal-Bearing Databook*, Springer, 1989, page {page}; numbers as reproduced in the "
    "public repository VictorLier/Tribology, a file of a course at the Technical University of Denmark. Two "
    "columns have no label there and are left out."
)


def table(name: str) -> list[dict[str, float]]:
    """Rows of ``table_1`` or ``table_3`` by column name."""
    data = reference_data("someya_1989")
    return [dict(zip(data["columns"], row, strict=True)) for row in data[name]]


def solved(film: JournalFilm, bearing_number: float) -> tuple[Array, float, Array, Array]:
    """Journal position along and across the load over c, Q, K c/W and B c ω/W; c is `CLEARANCE`."""
    load = load_of(bearing_number, WIDTH_RATIO)
    found = at_rest(film, load)
    position = np.array([-found.position[1], found.position[0]]) / CLEARANCE
    return (position, side_flow_ratio(found), *coefficients(found, load))


def named(position: Array, flow: float, stiffness: Array, damping: Array) -> dict[str, float]:
    """What `solved` gives, by the names of the tables."""
    return {
        "ε": float(np.hypot(*position)),
        "φ": math.degrees(math.atan2(position[1], position[0])),
        "Q": flow,
        **dict(zip(STIFFNESS, stiffness.ravel().tolist(), strict=True)),
        **dict(zip(DAMPING, damping.ravel().tolist(), strict=True)),
    }


def printed(row: dict[str, float]) -> dict[str, float]:
    """A row of a table by the same names."""
    own = {"ε": row["eccentricity_ratio"], "φ": row["attitude_angle_degrees"], "Q": row["Q"]}
    return own | {name: row[name] for name in (*STIFFNESS, *DAMPING)}


def consistency(film: JournalFilm, rows: Sequence[dict[str, float]]) -> Iterator[Comparison]:
    """Hold the engine's stiffness against the slope of its own locus, at the bearing numbers of a table."""
    for row in rows:
        number = row["bearing_number_S"]
        slope = own_slope(lambda s: solved(film, s)[0], number)
        yield Comparison(
            "1/K over slope of the locus",
            f"S = {number:g}",
            1.0,
            compliance_over_slope(solved(film, number)[2], slope)[0],
            Within(relative=0.001),
            "",
            IDENTITY,
        )


def compliance_over_slope(stiffness: Array, slope: Array) -> tuple[float, float]:
    """Shift by stiffness under a small extra load over the shift along the locus: size, and angle in degrees.

    On a locus K dr = dW, so K c/W times d(r/c)/d ln W is the unit vector along the load: size 1 and angle 0.
    """
    shift = np.linalg.solve(stiffness, [1.0, 0.0])
    turn = math.atan2(shift[1], shift[0]) - math.atan2(slope[1], slope[0])
    return float(np.hypot(*shift) / np.hypot(*slope)), math.degrees(math.remainder(turn, 2.0 * math.pi))


def own_slope(position: Callable[[float], Array], bearing_number: float, step: float = 0.01) -> Array:
    """d(r/c)/d ln W by central difference of the engine's own equilibria."""
    heavier, lighter = (position(bearing_number / (1.0 + share)) for share in (step, -step))
    return (heavier - lighter) / (math.log1p(step) - math.log1p(-step))


def printed_consistency(rows: Sequence[dict[str, float]], assembled: float) -> list[tuple[float, float, float]]:
    """S, and `compliance_over_slope` of the print itself, its locus joined by a cubic spline; ends left out.

    ``assembled`` is the clearance of ε over that of K.
    """
    from scipy.interpolate import CubicSpline

    log_load = -np.log([row["bearing_number_S"] for row in rows])
    angle = np.radians([row["attitude_angle_degrees"] for row in rows])
    size = assembled * np.array([row["eccentricity_ratio"] for row in rows])
    slopes = CubicSpline(log_load, np.column_stack((size * np.cos(angle), size * np.sin(angle))))(log_load, 1)
    found = []
    for row, slope in list(zip(rows, slopes, strict=True))[1:-1]:
        stiffness = np.array([row[name] for name in STIFFNESS]).reshape(2, 2)
        found.append((row["bearing_number_S"], *compliance_over_slope(stiffness, slope)))
    return found
