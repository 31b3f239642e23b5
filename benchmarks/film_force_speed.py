"""Seconds of the film force of a solved bearing: one position in a call, and a hundred thousand in one.

Run ``python benchmarks/film_force_speed.py`` on a quiet machine; medians, warm, one core. A grooved round bore,
D = 200 mm, B = 120 mm, 30 kN, 3000 rpm, fed from grooves full of oil at ambient pressure.
"""

import math
import os
import time

import numpy as np

from babbitt.reynolds.equilibrium.many_positions import FilmPositions
from babbitt.reynolds.model import DRAFT, ENGINEERING, Cavitation, JournalFilm, grooved_bore

LANDS = grooved_bore((0.0, math.pi), math.radians(20.0))
POSITIONS, REPEATS = 100_000, 400


def median_seconds(call, repeats):
    """Median wall time of a call after one warm-up."""
    call()
    seconds = []
    for _ in range(repeats):
        begun = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - begun)
    return float(np.median(seconds))


def main():
    """Measure and print."""
    print(f"load average {os.getloadavg()[0]:.2f}, {os.cpu_count()} cores")
    places = np.zeros((POSITIONS, 4))
    angles, depths = np.random.default_rng(7).uniform((-math.pi, 0.1), (math.pi, 0.8), (POSITIONS, 2)).T
    places[:, 0], places[:, 1] = depths * np.cos(angles), depths * np.sin(angles)
    for cavitation in (Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING):
        film = JournalFilm(0.2, 0.12, 150e-6, 0.02, 3000.0 * math.pi / 30.0, LANDS, cavitation)
        for resolution in (DRAFT, ENGINEERING):
            prepared = FilmPositions(film, resolution)
            rows = places * film.clearance
            one = np.ascontiguousarray(rows[:1]) * 0.0 + np.array([[1e-5, -7e-5, 0.0, 0.0]])
            size = f"{resolution.axial_unknowns}x{resolution.intervals}"
            single = median_seconds(lambda at=one, by=prepared: by.forces(at), REPEATS)
            coefficients = median_seconds(lambda at=one, by=prepared: by.coefficients(at), REPEATS)
            begun = time.perf_counter()
            found = prepared.forces(rows)
            each = (time.perf_counter() - begun) / POSITIONS
            name = f"{cavitation.name.lower():<16} {size:<5}"
            print(f"{name} one call {1e3 * single:.4f} ms, with K and C {1e3 * coefficients:.4f} ms, "
                  f"each of {POSITIONS} {1e3 * each:.4f} ms, settled {found.settled.mean():.4f}")  # fmt: skip


if __name__ == "__main__":
    main()
