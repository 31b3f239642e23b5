"""Times of tilting-pad bearings without heat, warm, from the middle: kernels alone, and with all that is reported.

    python benchmarks/tilting_pad_speed.py

Five centred pads of 60 degrees and four of 75 degrees with their pivots at 55 %; the least of many runs. Marks:
the kernels of 48 intervals a pad within 1 ms, and all that is reported within half as much again.
"""

import math
import sys
import time
from collections.abc import Callable

from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads._pads import find_pads
from babbitt.reynolds.tilting_pads._place import new_places
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales, kernel_pads
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.solve import no_total, solve_tilting_pads

INTERVALS, MARKED, MARK, WHOLE, RUNS = (24, 48, 96), 48, 1e-3, 1.5, 200


def bearing(
    angles: tuple[float, ...], extent: float, fraction: float, preload: float, ratio: float
) -> TiltingPadBearing:
    """Pads at angles in degrees, in units of clearance, radius and mu omega (R/c)^2 R L."""
    pads = tuple(
        TiltingPad(math.radians(angle), math.radians(extent), 1.0, 1.0 - preload, 0.1, fraction)
        for angle in angles
    )
    return TiltingPadBearing(2.0, 2.0 * ratio, 0.5 / ratio, 1.0, pads)


CASES = {
    "five pads": (bearing((-126, -54, 18, 90, 162), 60.0, 0.5, 0.3, 0.5), (0.0, -2.0)),
    "four pads": (bearing((-90, 0, 90, 180), 75.0, 0.55, 0.4, 0.7), (1.026060, -2.819078)),
}


def least_time(run: Callable[[], object]) -> float:
    """Shortest of many runs, s."""
    run()
    best = math.inf
    for _ in range(RUNS):
        begun = time.perf_counter()
        run()
        best = min(best, time.perf_counter() - begun)
    return best


def main() -> int:
    slow = False
    for name, (chosen, load) in CASES.items():
        pads, axial = kernel_pads(chosen, PadScales(chosen)), kernel_operator(4)
        for intervals in INTERVALS:
            grid = Resolution(4, intervals)

            def kernels(pads=pads, axial=axial, n=intervals, load=load) -> object:
                return find_pads(axial, pads, n, *load, 0.0, 0.0, 1e-6, 100, new_places(pads), no_total())

            found = solve_tilting_pads(chosen, load, grid)
            alone = least_time(kernels)
            whole = least_time(lambda chosen=chosen, load=load, grid=grid: solve_tilting_pads(chosen, load, grid))
            moving = least_time(lambda found=found: condensed_at(full_coefficients(found), 1.0))
            slow = slow or (intervals == MARKED and (alone > MARK or whole > WHOLE * alone))
            took = f"whole {1e3 * whole:.2f} ms, coefficients {1e3 * moving:.2f} ms"
            print(f"{name}, 4 x {intervals}: kernels {1e3 * alone:.2f} ms ({found.iterations} steps, "
                  f"{found.films} films), {took}")  # fmt: skip
    return int(slow)


if __name__ == "__main__":
    sys.exit(main())
