"""How far the interpolated characteristics are from fresh Reynolds solutions, at random points between the nodes.

Run from the repository root: ``python benchmarks/characteristics_accuracy.py``. Prints the errors at 200 points
over all spans, B/D 0.1 ... 1.5 and eps 0.01 ... 0.99, half of the points even in eps and half even in
ln(eps/(1 - eps)), and for a tenth of them the error of the solver itself against twice the cells. Exit status 1 if
a promise is broken.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np

from babbitt.kinds.journal.iso7902.characteristics import SPANS_DEGREES, curves
from babbitt.validation.research.arc_film import DEFAULT_CELLS, ArcSolution, solve_arc

# name, unit, promised largest error
QUANTITIES = (
    ("sommerfeld_number", "%", 0.1),
    ("attitude_angle", "deg", 0.08),
    ("side_flow_number", "%", 0.2),
    ("pressure_ratio", "%", 0.2),
)


def random_points(count: int, seed: int) -> list[tuple[int, float, float]]:
    """Span [deg], B/D, eps; logarithmic in B/D, alternately even in eps and in ln(eps/(1 - eps))."""
    rng = np.random.default_rng(seed)
    points = []
    for index in range(count):
        width_ratio = math.exp(rng.uniform(math.log(0.1), math.log(1.5)))
        place = rng.uniform(-math.log(99), math.log(99))
        eps = rng.uniform(0.01, 0.99) if index % 2 else 1 / (1 + math.exp(-place))
        points.append((int(rng.choice(SPANS_DEGREES)), width_ratio, float(eps)))
    return points


def differences(value: ArcSolution, reference: ArcSolution) -> list[float]:
    """Per cent or degrees, in the order of QUANTITIES."""
    found = []
    for name, unit, _ in QUANTITIES:
        ours, theirs = getattr(value, name), getattr(reference, name)
        found.append(math.degrees(ours - theirs) if unit == "deg" else 100 * (ours / theirs - 1))
    return found


def interpolated(span: int, width_ratio: float, eps: float) -> ArcSolution:
    shape = curves(span, width_ratio)
    return ArcSolution(*(getattr(shape, name)(eps) for name, _, _ in QUANTITIES), film_end_angle=math.nan)


def report(title: str, errors: list[list[float]], points: list[tuple[int, float, float]]) -> bool:
    """Print percentiles; whether all promises are kept."""
    print(f"\n{title}")
    print(f"{'':20}{'median':>10}{'90 %':>10}{'99 %':>10}{'largest':>10}{'promised':>10}   at (span, B/D, eps)")
    kept = True
    for (name, unit, promise), column in zip(QUANTITIES, np.abs(errors).T, strict=True):
        span, width_ratio, eps = points[int(column.argmax())]
        figures = "".join(f"{value:10.5f}" for value in (*np.percentile(column, [50, 90, 99]), column.max()))
        print(f"{name:20}{figures}{promise:10.2f} {unit}   ({span}, {width_ratio:.4f}, {eps:.4f})")
        kept &= bool(column.max() <= promise)
    return kept


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=200)
    parser.add_argument("--seed", type=int, default=2)
    options = parser.parse_args()
    points = random_points(options.points, options.seed)
    start = time.perf_counter()
    fresh = [solve_arc(math.radians(span), x, eps) for span, x, eps in points]
    each = (time.perf_counter() - start) / len(points)
    errors = [differences(interpolated(*point), film) for point, film in zip(points, fresh, strict=True)]
    kept = report(
        f"Interpolation against {len(points)} fresh solutions ({1e3 * each:.0f} ms each)", errors, points
    )

    some = slice(None, None, 10)
    cells = (2 * DEFAULT_CELLS[0], 2 * DEFAULT_CELLS[1])
    finer = [solve_arc(math.radians(span), x, eps, cells=cells) for span, x, eps in points[some]]
    errors = [differences(film, fine) for film, fine in zip(fresh[some], finer, strict=True)]
    kept &= report(f"Solver with {DEFAULT_CELLS} coarse cells against {cells}", errors, points[some])
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
