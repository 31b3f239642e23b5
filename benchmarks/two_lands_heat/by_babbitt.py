"""Babbitt's side: warm calls of the thermal film, adiabatic and with conducting walls, coefficients included."""

from __future__ import annotations

import sys
from functools import partial
from math import pi
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "two_lands"))

import numpy as np

import babbitt
from babbitt.reynolds.heat.heat_model import (
    THERMAL_DRAFT,
    THERMAL_ENGINEERING,
    THERMAL_REFERENCE,
    BushRing,
    ConductingWalls,
    FilmHeat,
    HeatGrid,
    JournalHeat,
)
from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal
from babbitt.reynolds.model import JournalFilm, grooved_bore
from case import CLEARANCE, DIAMETER, LAND, LOAD, SPEED, WIDTH, answer, row, timed

COLD = 323.15
WALLS = ConductingWalls(BushRing((0.2, 0.3), (50.0,), 50.0, 293.15), JournalHeat())


def viscosity(temperature: np.ndarray) -> np.ndarray:
    """Pa s: a Vogel law through 0.0275 Pa s at 40 degC and 0.0046 Pa s at 100 degC (ISO VG 32)."""
    return np.asarray(4.0e-5 * np.exp(1000.0 / (temperature - 160.02)))


def main() -> None:
    lands = grooved_bore((0.0, pi), pi - LAND)
    film = JournalFilm(DIAMETER, WIDTH, CLEARANCE, float(viscosity(np.array(COLD))), SPEED, lands)
    rows = []
    for name, walls, grid, lines in (
        ("adiabatic", None, HeatGrid(), THERMAL_ENGINEERING),
        ("adiabatic, draft grid", None, HeatGrid(), THERMAL_DRAFT),
        ("full", WALLS, HeatGrid(), THERMAL_ENGINEERING),
        ("full, draft grid", WALLS, HeatGrid(), THERMAL_DRAFT),
        ("full, resolved along the width", WALLS, HeatGrid(resolved=True), THERMAL_ENGINEERING),
    ):
        heat = FilmHeat(viscosity, 1.72e6, 0.13, COLD, walls, grid)
        found = solve_thermal_journal(film, heat, (0.0, -LOAD), lines)
        fine = solve_thermal_journal(film, heat, (0.0, -LOAD), THERMAL_REFERENCE)
        times = timed(partial(solve_thermal_journal, film, heat, (0.0, -LOAD), lines), 1.0)
        rows.append(
            row("Babbitt", name, f"4 x {lines.intervals}", times, eccentricity=found.film.eccentricity_ratio,
                maximum=found.maximum_temperature, balance=found.heat.balance_error,
                film_error=found.film.minimum_film_thickness / fine.film.minimum_film_thickness - 1.0,
                temperature_error=found.maximum_temperature - fine.maximum_temperature)
        )  # fmt: skip
    answer({"version": babbitt.__version__, "rows": rows})


if __name__ == "__main__":
    main()
