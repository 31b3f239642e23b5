"""How fast the characteristics answer: one number, a million numbers, forward and inverse.

Run from the repository root: ``python benchmarks/characteristics_speed.py``. Exit status 1 if So is evaluated at
fewer than a million points per second.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from time import perf_counter
from timeit import repeat

import numpy as np

COUNT = 10**6


def best(call: Callable[[], object], number: int) -> float:
    """Seconds per call, best of five."""
    return min(repeat(call, number=number, repeat=5)) / number


def main() -> int:
    start = perf_counter()
    from babbitt.kinds.journal.iso7902.characteristics import ClosedFormCurves, curves, sommerfeld_number

    imported = perf_counter()
    shape = curves(180, 0.604)
    ready = perf_counter()
    eccentricities = np.random.default_rng(1).uniform(0.0, 0.99, COUNT)
    width_ratios = np.random.default_rng(2).uniform(0.1, 1.5, COUNT)
    loads = shape.sommerfeld_number(eccentricities)
    load, fit = shape.sommerfeld_number(0.63), ClosedFormCurves(0.604)
    fresh = iter(np.linspace(0.2, 1.4, 10_000).tolist())

    print(f"import, numpy included        {1e3 * (imported - start):9.1f} ms")
    print(f"first curves (table is read)  {1e3 * (ready - imported):9.1f} ms")
    print(f"further curves                {1e6 * best(lambda: curves(180, next(fresh)), 200):9.1f} us")
    for name in ("sommerfeld_number", "attitude_angle", "side_flow_number", "pressure_ratio"):
        print(f"{name:30}{1e6 * best(lambda name=name: getattr(shape, name)(0.63), 20_000):9.2f} us")
    print(f"eccentricity_ratio            {1e6 * best(lambda: shape.eccentricity_ratio(load), 20_000):9.2f} us")
    print(f"   of the closed forms        {1e6 * best(lambda: fit.eccentricity_ratio(load), 2_000):9.2f} us")
    rate = COUNT / best(lambda: shape.sommerfeld_number(eccentricities), 1)
    print(f"So of an array                {rate / 1e6:9.1f} million/s")
    print(f"eps of an array               {1 / best(lambda: shape.eccentricity_ratio(loads), 1):9.1f} million/s")
    both = best(lambda: sommerfeld_number(180, eccentricities, width_ratios), 1)
    print(f"So, every point its own B/D   {1 / both:9.1f} million/s")
    return 0 if rate >= 1e6 else 1


if __name__ == "__main__":
    sys.exit(main())
