"""What a film costs: against intervals and axial unknowns, in memory, and beside the arithmetic of the machine.

    python benchmarks/film_cost.py

One evaluation is force, stiffness and damping of the two lands of the reference bearing (``film_speed.py``) at one
position with a settled wet set. Marks: cost ~ intervals^1.1 (48 to 384) and ~ axial unknowns^2 (5 to 12; m = 4
has kernels of its own with unrolled loops) at most.

The floor is the time a matrix product of the same number of operations takes (DGEMM, one thread, same run).
Operations of one evaluation are counted from the loops, a division as one: per interval 60 for the film and 25 m
for the forces, per full line 31 m and 6 m^2 for both turns into modes, per broken line 4 m^3 + 18 m^2, per line
2 m^2 for the axial flow.
"""

from __future__ import annotations

import math
import os
import resource
import sys
import time
from dataclasses import replace

os.environ["OPENBLAS_NUM_THREADS"] = os.environ["MKL_NUM_THREADS"] = "1"  # read when numpy is imported

import numpy as np
from film_speed import BEARING, kernel_call
from numba import njit

from babbitt.reynolds.lands._equilibrium import evaluate
from babbitt.reynolds.lands._grids import new_film, new_lines
from babbitt.reynolds.model import Cavitation, Resolution

INTERVALS, UNKNOWNS = (48, 96, 192, 384), (4, 5, 6, 8, 10, 12)
MARKS = {"intervals": 1.1, "axial unknowns": 2.0}


def fastest(repeat, bursts=7, seconds=0.02):
    """Seconds of one turn of a function that repeats something a number of times, the best of some bursts."""
    repeat(1)
    begun = time.perf_counter()
    repeat(10)
    turns = max(1, int(10 * seconds / (time.perf_counter() - begun)))
    best = math.inf
    for _ in range(bursts):
        begun = time.perf_counter()
        repeat(turns)
        best = min(best, (time.perf_counter() - begun) / turns)
    return best


@njit
def evaluations(turns, axial, bearing, grid, film, lines, x, y, result):
    """The same evaluation again and again, without the way in and out of Python."""
    for _ in range(turns):
        evaluate(axial, bearing, grid, film, lines, x, y, 0.0, 0.0, False, result)


def evaluation(cavitation, unknowns, intervals):
    """Function that repeats one evaluation, its bytes of grid and workspace, its operations."""
    settled = kernel_call(replace(BEARING, cavitation=cavitation), Resolution(unknowns, intervals))
    axial, bearing = settled.args[:2]
    x, y, _, _, _, grid = settled()
    film, lines, result = new_film(intervals), new_lines(intervals, unknowns), np.zeros(10)
    size = sum(array.nbytes for part in (grid, film, lines) for array in part)
    count = grid.wet[:, 1:-1].sum(axis=2)
    full = sum(int(np.argmin(np.append(land == unknowns, False))) for land in count)
    broken = int((count > 0).sum()) - full
    m, lands = unknowns, grid.step.shape[0]
    operations = lands * intervals * (60 + 25 * m + 2 * m**2)
    operations += full * (31 * m + 6 * m**2) + broken * (4 * m**3 + 18 * m**2)
    return lambda turns: evaluations(turns, axial, bearing, grid, film, lines, x, y, result), size, operations


def slope(sizes, seconds):
    """Exponent of a power law through the figures."""
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def table(what, sizes, calls):
    """Print cost against a size; returns whether the exponent keeps its mark."""
    seconds = [fastest(repeat) for repeat, _, _ in calls]
    shown = "".join(f"{size:6d}: {1e6 * time_:6.2f} us" for size, time_ in zip(sizes, seconds, strict=True))
    counted = [pair for pair in zip(sizes, seconds, strict=True) if what == "intervals" or pair[0] > 4]
    exponent = slope(*map(np.array, zip(*counted, strict=True)))
    print(f"  {what:15}{shown}   exponent {exponent:.2f} (at most {MARKS[what]})")
    return exponent <= MARKS[what]


def product_rate(size=512):
    """Operations per second of a matrix product."""
    rng = np.random.default_rng(1)
    a, b = rng.random((2, size, size))

    def multiply(turns):
        for _ in range(turns):
            a @ b

    return 2.0 * size**3 / fastest(multiply)


def main():
    """Print the tables."""
    print(f"load average {os.getloadavg()[0]:.2f}, {os.cpu_count()} cores; one evaluation of two lands")
    kept, rate = True, product_rate()
    for cavitation in (Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING):
        print(cavitation.name.lower())
        kept &= table("intervals", INTERVALS, [evaluation(cavitation, 4, n) for n in INTERVALS])
        kept &= table("axial unknowns", UNKNOWNS, [evaluation(cavitation, m, 96) for m in UNKNOWNS])
        for m, n in ((4, 48), (4, 96), (6, 192)):
            repeat, size, operations = evaluation(cavitation, m, n)
            seconds, floor = fastest(repeat), operations / rate
            print(f"  {m} x {n:3d}: {size / 1e3:5.0f} kB of grid and workspace, {operations / 1e3:4.0f} kflop, "
                  f"floor {1e6 * floor:.2f} us, {seconds / floor:.1f} times that")  # fmt: skip
    print(f"floor: {rate / 1e9:.0f} Gflop/s of a matrix product of 512")
    print("between: the elimination is a chain from line to line, a division in every link; blocks of m x m fill")
    print("vector registers in part; a product multiplies and adds at once on full registers and never divides")
    print(f"peak of the process {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")
    return int(not kept)


if __name__ == "__main__":
    sys.exit(main())
