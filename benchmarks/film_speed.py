"""Seconds of the film engine: one equilibrium with coefficients, dense lines, a batch over all cores.

Run ``python benchmarks/film_speed.py`` on a quiet machine; medians, warm, one thread but for the batch. The
reference bearing: two lands of 176 degrees, D = 0.4 m, B = 0.263 m, c = 195 um, 900 rpm, 112.8 kN, 20.75 mPa s.
"""

import math
import os
import time
from dataclasses import replace
from functools import partial

import numpy as np

from babbitt.reynolds.equilibrium.cavitating_film import kernel_bearing
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.lands._equilibrium import find_equilibrium
from babbitt.reynolds.lands.batch import solve_batch
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Pocket, Resolution, grooved_bore
from babbitt.reynolds.scales import Scales

LOAD = (0.0, -112.8e3)
LANDS = grooved_bore((0.0, math.pi), math.radians(4.0))
BEARING = JournalFilm(0.4, 0.263, 195e-6, 20.75e-3, 900.0 * math.pi / 30.0, LANDS)


def median_seconds(call, repeats):
    """Median wall time of a call after one warm-up."""
    call()
    seconds = []
    for _ in range(repeats):
        begun = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - begun)
    return float(np.median(seconds))


def kernel_call(film, resolution):
    """The compiled equilibrium with its dispatch, without a result object."""
    scales = Scales.of(film, film.angular_speed)
    bearing, axial = kernel_bearing(film, scales), kernel_operator(resolution.axial_unknowns)
    weight, result = LOAD[1] / scales.force, np.zeros(10)
    return partial(
        find_equilibrium, axial, bearing, resolution.coarse_intervals, resolution.intervals, 0.0, weight, 0.0, 0.0,
        resolution.tolerance, 80, result,
    )  # fmt: skip


def report(what, seconds, target=None):
    """One line of the table."""
    limit = "" if target is None else f"   (at most {1e3 * target:g} ms)"
    print(f"{what:<58}{1e3 * seconds:9.3f} ms{limit}")


def main():
    """Measure and print."""
    print(f"load average {os.getloadavg()[0]:.2f}, {os.cpu_count()} cores")
    for cavitation, target in ((Cavitation.REYNOLDS, 0.15e-3), (Cavitation.MASS_CONSERVING, 0.4e-3)):
        film = replace(BEARING, cavitation=cavitation)
        for axial, intervals in ((4, 48), (4, 64), (4, 96), (6, 96), (6, 192), (8, 384)):
            grid = Resolution(axial, intervals)
            report(
                f"kernel, {cavitation.name}, {axial} x {intervals}",
                median_seconds(kernel_call(film, grid), 300),
                target,
            )
        report(
            f"solve_journal, {cavitation.name}",
            median_seconds(lambda film=film: solve_journal(film, LOAD), 200),
            1e-3,
        )
    ring = (Land(0.0, 2.0 * math.pi),)
    pockets = tuple(Pocket(angle, math.radians(20.0), 0.16, pressure=1e5) for angle in (0.0, math.pi))
    for what, film in (
        ("tilt", replace(BEARING, misalignment=(2e-4, 1e-4))),
        ("axial viscosity", replace(BEARING, axial_viscosity=(0.8, 1.1, 0.8))),
        ("two pockets", replace(BEARING, lands=ring, film_start=FilmStart.PERIODIC, pockets=pockets)),
    ):
        report(f"dense lines, {what}", median_seconds(lambda film=film: solve_journal(film, LOAD), 30), 10e-3)
    rng = np.random.default_rng(1)
    count = 10_000
    width = rng.uniform(0.4, 1.2, count)
    size = 0.1 * 10.0 ** rng.uniform(0.0, 2.5, count)
    angle = -0.5 * math.pi + rng.uniform(-0.5, 0.5, count)
    load = size[:, None] * np.stack((np.cos(angle), np.sin(angle)), axis=1)
    one = np.ones(count)
    for cavitation in (Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING):
        for intervals in (48, 96):
            grid = Resolution(4, intervals)

            def call(cavitation=cavitation, grid=grid):
                scale = 0.5 * width  # R B mu omega (R/c)^2 with all else one
                return solve_batch(
                    one,
                    width,
                    0.5,
                    one,
                    one,
                    load * scale[:, None],
                    grooved_bore((0.0, math.pi), 0.35),
                    cavitation,
                    grid,
                )

            seconds = median_seconds(call, 5)
            print(f"batch, {cavitation.name}, 4 x {intervals}: {count / seconds:,.0f} per second, "
                  f"{int((~call().solved).sum())} unsolved")  # fmt: skip


if __name__ == "__main__":
    main()
