"""Random tilting-pad bearings without heat: every one is solved, or one of its pads is at its limit.

    python benchmarks/tilting_pad_robustness.py [number [seed]]

3 to 6 pads, pivots at 50 to 60 %, preload 0 to 0.6, L/D 0.3 to 1.2, three decades of load in any direction, half
of them on pivots that give way; 48 intervals a pad, from the middle. A pad at its limit must have to carry less
than it does at its fold, whose load is told within 3 %. Marks: no other end, none slower than 1 s.
"""

import math
import statistics
import sys
import time
from collections import Counter

import numpy as np

from babbitt.core.result import Outcome
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import Pivot, RigidPivot, SpringPivot
from babbitt.reynolds.tilting_pads.solution import TiltingPadSolution
from babbitt.reynolds.tilting_pads.solve import fold_of, solve_tilting_pads

NUMBER, SLOWEST = 360, 1.0
GRID = Resolution(4, 48)


def random_bearing(rng: np.random.Generator) -> tuple[TiltingPadBearing, tuple[float, float]]:
    """A bearing with unit radius, clearance and force (mu omega (R/c)^2 R L), and its load."""
    count = int(rng.integers(3, 7))
    fraction = float(rng.choice([0.5, rng.uniform(0.5, 0.6)]))
    preload, width_ratio = rng.uniform(0.0, 0.6), rng.uniform(0.3, 1.2)
    extent = min(rng.uniform(0.6, 0.92) * 2.0 * math.pi / count, math.radians(100.0))
    first, direction = rng.uniform(0.0, 2.0 * math.pi, 2)
    load = 10.0 ** rng.uniform(-1.5, 1.5)
    pivot: Pivot = RigidPivot() if rng.random() < 0.5 else SpringPivot(10.0 ** rng.uniform(0.5, 3.0))
    pads = tuple(
        TiltingPad(first + 2.0 * math.pi * k / count, extent, 1.0, 1.0 - preload, 0.1, fraction, pivot=pivot)
        for k in range(count)
    )
    width = 2.0 * width_ratio
    bearing = TiltingPadBearing(2.0, width, 1.0 / width, 1.0, pads)
    return bearing, (load * math.cos(direction), load * math.sin(direction))


def is_end(found: TiltingPadSolution) -> bool:
    """Whether a search ended as it may: solved, or with a pad that would have to carry less than at its fold."""
    if found.outcome is Outcome.PAD_AT_LIMIT and found.limit_pad is not None:
        need, least = found.limit_loads
        return 0.0 < need < least < 1.03 * fold_of(found.bearing, found.limit_pad, GRID).load
    return found.outcome.solved


def main() -> int:
    number = int(sys.argv[1]) if len(sys.argv) > 1 else NUMBER
    rng = np.random.default_rng(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    solve_tilting_pads(*random_bearing(np.random.default_rng(0)), GRID)
    ends: Counter[str] = Counter()
    steps, films, times, bad = [], [], [], 0
    for trial in range(number):
        bearing, load = random_bearing(rng)
        begun = time.perf_counter()
        found = solve_tilting_pads(bearing, load, GRID)
        times.append(time.perf_counter() - begun)
        ends[found.outcome.name] += 1
        steps.append(found.iterations)
        films.append(found.films)
        if not is_end(found):
            bad += 1
            print(f"trial {trial}: {found.outcome.name}, residual {found.residual / math.hypot(*load):.1e} of the "
                  f"load, limit {found.limit_loads}")  # fmt: skip
    print(dict(ends))
    print(f"steps: median {statistics.median(steps)}, most {max(steps)}")
    print(f"films: median {statistics.median(films)}, most {max(films)}")
    print(f"time: median {1e3 * statistics.median(times):.2f} ms, slowest {1e3 * max(times):.1f} ms")
    return 0 if bad == 0 and max(times) < SLOWEST else 1


if __name__ == "__main__":
    sys.exit(main())
