"""Seconds of the film force of a solved bearing: one position in a call, and a hundred thousand in one.

Run ``python benchmarks/film_force_speed.py`` on a quiet machine; medians, warm, one core, all through the public
call. A round bore with two grooves, D = 200 mm, B = 120 mm, 30 kN, 3000 rpm; the last one is fed under pressure.
"""

import math
import os
import time

import numpy as np

from babbitt.api.results import BearingResult
from babbitt.case import parse_case
from babbitt.solving import solve

CASE = """
babbitt: 1
kind: journal
name: Bearing
method: film
diameter: 200 mm
width: 120 mm
clearance: {{kind: relative, mean: 1.5 permille}}
grooves:
  - {{angle: 0 deg, extent: 20 deg, pressure: {pressure}}}
  - {{angle: 180 deg, extent: 20 deg, pressure: {pressure}}}
materials: {{bearing_metal: SnSb8Cu4, bearing: C10, journal: C45}}
lubricant: ISO VG 46
supply: {{temperature: 45 degC, pressure: 0.15 MPa}}
cavitation: {cavitation}
accuracy: {accuracy}
load: 30 kN
speed: 3000 rpm
"""
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


def measure(pressure, cavitation, accuracy, positions):
    """One line of the table."""
    text = CASE.format(pressure=pressure, cavitation=cavitation, accuracy=accuracy)
    film = BearingResult(solve(parse_case(text)).solutions[0]).film
    angles, depths = np.random.default_rng(7).uniform((-math.pi, 0.1), (math.pi, 0.8), (positions, 2)).T
    x, y = 150e-6 * depths * np.cos(angles), 150e-6 * depths * np.sin(angles)
    single = median_seconds(lambda: film.force(1e-5, -7e-5, 0.0, 0.0), REPEATS)
    coefficients = median_seconds(lambda: film.linearise(1e-5, -7e-5), REPEATS)
    begun = time.perf_counter()
    force = film.force(x, y)
    each = (time.perf_counter() - begun) / positions
    times = f"one call {1e3 * single:.4f} ms, with K and C {1e3 * coefficients:.4f} ms, each of {positions}"
    unsettled = int(np.isnan(force[:, 0]).sum())
    print(f"{cavitation:<16} {accuracy:<12} {pressure:<9} {times} {1e3 * each:.4f} ms, unsettled {unsettled}")


def main():
    """Measure and print."""
    print(f"load average {os.getloadavg()[0]:.2f}, {os.cpu_count()} cores; draft is 4x48, engineering 4x96")
    for cavitation in ("reynolds", "mass_conserving"):
        for accuracy in ("draft", "engineering"):
            measure("0 MPa", cavitation, accuracy, POSITIONS)
    measure("0.15 MPa", "mass_conserving", "draft", POSITIONS // 200)


if __name__ == "__main__":
    main()
