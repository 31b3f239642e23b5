"""Speed of the screw-grooved footstep: all steady states of a case warm, and a sweep of 60 by 60 points.

Promised: all states of one case in under 10 ms warm, the sweep in under 20 s, with a bar where somebody looks.
"""

from __future__ import annotations

import statistics
from dataclasses import replace
from time import perf_counter

import numpy as np

from babbitt.case import parse_case, template
from babbitt.kinds.footstep.check import heel_results
from babbitt.kinds.footstep.model import Wall
from babbitt.kinds.footstep.states import Method, steady_states
from babbitt.kinds.footstep.study.sweep import sweep_heel
from babbitt.report.progress import shown

REPEATS = 50
POINTS = 60


def milliseconds(work) -> tuple[float, float]:
    """Median and least time of a warm call."""
    work()
    times = []
    for _ in range(REPEATS):
        begun = perf_counter()
        work()
        times.append(1e3 * (perf_counter() - begun))
    return statistics.median(times), min(times)


def main() -> None:
    smooth, grooved = parse_case(template("screw_heel")).problems()
    warm = replace(grooved.footstep, wall=Wall(298.15, 10.0))
    for what, work in (
        ("states by superposition, both heels",
         lambda: (steady_states(smooth.footstep), steady_states(grooved.footstep))),
        ("states by narrow-groove theory, both heels",
         lambda: (steady_states(replace(warm, groove=None), Method.NARROW_GROOVE),
                  steady_states(warm, Method.NARROW_GROOVE))),
        ("results with critical and fold clearance", lambda: (heel_results(smooth), heel_results(grooved))),
    ):  # fmt: skip
        median, least = milliseconds(work)
        print(f"{what:<46} median {median:6.2f} ms, least {least:6.2f} ms")
    gaps, clearances = np.linspace(5e-6, 60e-6, POINTS), np.linspace(7e-6, 60e-6, POINTS)
    for method, step in ((Method.SUPERPOSITION, grooved.footstep), (Method.NARROW_GROOVE, warm)):
        begun = perf_counter()
        sweep = sweep_heel(step, gaps.tolist(), clearances.tolist(), method, shown("sweep of the footstep"))
        took = perf_counter() - begun
        counts = {int(n): int((sweep.counts == n).sum()) for n in np.unique(sweep.counts)}
        print(
            f"sweep of {POINTS} x {POINTS}, {method.value:<16}          {took:6.2f} s, points by states: {counts}"
        )


if __name__ == "__main__":
    main()
