"""Accuracy of the film engine against its grid: the table of ``docs/theory/film.md``.

    python benchmarks/film_accuracy.py

Errors in per cent: of the position over the least film thickness, of K and C as the norm of the difference over
that of the matrix. The reference bearing is that of ``two_lands`` under its own load, against positions and
coefficients by a program that shares no line with the engine (``two_lands/fine_reference.py``), and under other
loads against the engine on a grid of 10 x 1536. Films whose lines differ across the width: against 8 x 768.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
from film_speed import BEARING, LOAD

from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import DRAFT, ENGINEERING, REFERENCE, Cavitation, FilmStart, Land, Pocket, Resolution
from babbitt.reynolds.scales import Scales

GRIDS = {"draft": DRAFT, "engineering": ENGINEERING, "reference": REFERENCE}
FINEST, FINEST_SURFACE = Resolution(10, 1536, 96, 1e-10), Resolution(8, 768, 48, 1e-9)
INDEPENDENT = json.loads((Path(__file__).parent / "two_lands" / "reference.json").read_text(encoding="utf-8"))


def lines(what, film, load, position, least, stiffness, damping):
    """Print one row for every grid; ``least`` is the least film thickness."""
    position, stiffness, damping = map(np.asarray, (position, stiffness, damping))
    for name, grid in GRIDS.items():
        found = solve_journal(film, load, grid)
        moved = np.linalg.norm(found.position - position) / least
        parts = [
            np.linalg.norm(mine - exact) / np.linalg.norm(exact)
            for mine, exact in ((found.stiffness, stiffness), (found.damping, damping))
        ]
        figures = "".join(f"{100.0 * error:10.4f}" for error in (moved, *parts))
        print(f"{what:34}{name:12}{figures}   {found.outcome.name.lower()}")


def against_finest(what, film, load, grid):
    """Rows against the engine on a fine grid."""
    exact = solve_journal(film, load, grid)
    lines(what, film, load, exact.position, exact.minimum_film_thickness, exact.stiffness, exact.damping)


def convergence():
    """Error of the force at one place, per cent, against intervals and against unknowns across."""
    place = tuple(np.array(INDEPENDENT["mass-conserving"]["position"]) * BEARING.clearance)

    def force(unknowns, intervals):
        return film_at_position(BEARING, place, resolution=Resolution(unknowns, intervals)).force

    for what, finest, grids in (
        ("intervals", (4, 1536), [(4, n) for n in (24, 48, 96, 192)]),
        ("unknowns", (12, 384), [(m, 384) for m in (2, 3, 4, 5)]),
    ):
        exact = force(*finest)
        errors = [np.linalg.norm(force(*grid) - exact) / np.linalg.norm(exact) for grid in grids]
        print(
            f"force, {what}: "
            + ", ".join(f"{m} x {n} {100.0 * e:.2g}" for (m, n), e in zip(grids, errors, strict=True))
        )


def pocket_flow(film):
    """Error of the flow from all supplies, per cent."""
    exact = solve_journal(film, LOAD, FINEST_SURFACE).supply_flow.sum()
    errors = {
        name: solve_journal(film, LOAD, grid).supply_flow.sum() / exact - 1.0 for name, grid in GRIDS.items()
    }
    print("supply flow: " + ", ".join(f"{name} {100.0 * error:.2g}" for name, error in errors.items()))


def main():
    """Print the tables."""
    print(f"{'':46}{'position':>10}{'K':>10}{'C':>10}   per cent")
    for name, cavitation in (("mass-conserving", Cavitation.MASS_CONSERVING), ("reynolds", Cavitation.REYNOLDS)):
        film, exact = replace(BEARING, cavitation=cavitation), INDEPENDENT[name]
        place = np.array(exact["position"]) * film.clearance
        least = film.clearance - math.hypot(*place)
        lines(f"{name}, independent", film, LOAD, place, least, exact["stiffness"], exact["damping"])
    for number in (0.1, 1.0, 5.0, 20.0):
        load = (0.0, -2.0 * number * Scales.of(BEARING, BEARING.angular_speed).force)
        against_finest(f"mass-conserving, So = {number:g}", BEARING, load, FINEST)
    ring = (Land(0.0, 2.0 * math.pi),)
    pockets = tuple(Pocket(angle, math.radians(20.0), 0.16, pressure=1e5) for angle in (0.0, math.pi))
    for what, film in (
        ("tilt", replace(BEARING, misalignment=(2e-4, 1e-4))),
        ("axial viscosity", replace(BEARING, axial_viscosity=(0.8, 1.1, 0.8))),
        ("two pockets", replace(BEARING, lands=ring, film_start=FilmStart.PERIODIC, pockets=pockets)),
    ):
        against_finest(what, film, LOAD, FINEST_SURFACE)
    pocket_flow(film)
    convergence()


if __name__ == "__main__":
    main()
