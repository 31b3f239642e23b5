"""Speed of the ISO 7902 design check and of the command line.

Run ``python benchmarks/design_check_speed.py`` on a quiet machine. Medians; processes are started afresh with
warm file caches. Targets: one bearing under 1 ms, a million evaluations of So per second, ``babbitt --help`` under
0.4 s, ``babbitt solve`` of the eleven-bearing reverse gear under 1.5 s.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import babbitt
from babbitt.kinds.journal.iso7902 import check
from babbitt.kinds.journal.iso7902.characteristics import curves, sommerfeld_number

ROOT = Path(__file__).resolve().parents[1]
REVERSE_GEAR = ROOT / "examples" / "marine_reverse_gear.yaml"


def median_seconds(work: Callable[[], object], repeats: int) -> float:
    """Median time of one call in s, after one call to warm up."""
    work()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def process(*arguments: str) -> Callable[[], object]:
    """A fresh interpreter that runs the command line."""
    command = [sys.executable, "-m", "babbitt", *arguments]
    return lambda: subprocess.run(command, check=True, capture_output=True)


def main() -> None:
    """Print measured figures beside their targets."""
    design = babbitt.load_case(REVERSE_GEAR).problems()[0]
    points = np.random.default_rng(1).uniform(0.01, 0.99, 1_000_000)
    widths = np.random.default_rng(2).uniform(0.1, 1.5, 1_000_000)
    shape = curves(180, 0.604)
    one = median_seconds(lambda: check(design), 300)
    curve = 1e6 / median_seconds(lambda: shape.sommerfeld_number(points), 7)
    surface = 1e6 / median_seconds(lambda: sommerfeld_number(180, points, widths), 7)
    print(f"one bearing with temperature iteration  {one * 1e3:9.3f} ms    target 1 ms")
    print(f"So over eccentricity, one B/D           {curve:9.3g} 1/s   target 1e6 1/s")
    print(f"So over eccentricity and B/D            {surface:9.3g} 1/s   target 1e6 1/s")
    print(
        f"babbitt --help                          {median_seconds(process('--help'), 7):9.3f} s     target 0.4 s"
    )
    whole = median_seconds(process("solve", str(REVERSE_GEAR)), 7)
    print(f"babbitt solve, eleven bearings, table   {whole:9.3f} s     target 1.5 s")
    bare = [sys.executable, "-c", "import babbitt"]
    light = median_seconds(lambda: subprocess.run(bare, check=True), 7)
    print(f"import babbitt, whole process           {light:9.3f} s     target 0.25 s")


if __name__ == "__main__":
    main()
