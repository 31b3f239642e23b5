"""Random plausible bearings of all kinds: no traceback, no hang, no silent imbalance, no choice of axes or units.

    python benchmarks/robustness/bearings.py [number [seed [family]]] [--from index]

Draws `number` cases (1500) in turns from every family of `FAMILIES`, prints what is wrong with any, and at the end
(or at Ctrl-C) how the cases of every family ended and the slowest of them. Ends with 1 where anything is wrong.
A case is known by seed and index: a long series may be run in parts, and a case that was found be run alone.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from harness import (
    BY_DIFFERENCES,
    OF_THERMAL_FILMS,
    OF_TURBULENT_FILMS,
    OF_WET_NODES,
    SAME,
    SAME_WARM,
    SHARED,
    SLOWEST,
    Family,
    Outcome,
    faults_of,
    in_other_units,
    reordered,
)
from journal_cases import JOURNALS
from journal_frames import mirrored, turned
from pumped_trial import MAKERS, faults
from thrust_cases import on_other_pads, thrust_case, thrust_line_case

from babbitt.core.result import Outcome as Ending

__all__ = ["FAMILIES"]

WRITTEN = {"order": reordered, "units": in_other_units}
IN_OTHER_AXES = {"turned": turned, "mirrored": mirrored, **WRITTEN}

Trial = Callable[[str], Outcome]


def pumped_trial(kind: str, seed: str) -> Outcome:
    """How a random hydrostatic bearing, jacking pocket or footstep went, by the rules of its own kind."""
    case, begun = MAKERS[kind](random.Random(seed)), time.process_time()
    said = tuple(faults(case))
    return Outcome(said, "faulty" if said else "sound", time.process_time() - begun)


BOUNDS = (
    ("turbulent", OF_TURBULENT_FILMS, OF_WET_NODES),
    ("elastic", SAME_WARM, BY_DIFFERENCES),
    ("thermal", SAME_WARM, OF_THERMAL_FILMS),
)
"""Part of the name of a family, bound on what is the same, and wider bounds of single values."""


def bounds_of(name: str) -> tuple[float, Mapping[str, float]]:
    """Bounds of a family of journal bearings."""
    return next(((same, wider) for part, same, wider in BOUNDS if part in name), (SAME, {}))


FAMILIES: dict[str, Trial] = {
    name: partial(faults_of, Family(draw, IN_OTHER_AXES if name.startswith("film") else WRITTEN, *bounds_of(name)))
    for name, draw in JOURNALS.items()
} | {kind: partial(pumped_trial, kind) for kind in MAKERS}
"""Trial of a seed for every family; every kind of bearing adds its own."""

ON_OTHER_PADS = {"turned": on_other_pads, **WRITTEN}
NOT_CARRIED = frozenset({Ending.OVERLOADED, Ending.NOT_CONVERGED, Ending.WORK_BOUND})
"""Of too large a thrust: whether the pad that is lost first touches the collar or falls over, or the search for it
ends at the bound of its work, may turn on last digits (1 of 94)."""
FAMILIES |= {
    "thrust": partial(
        faults_of, Family(thrust_case, ON_OTHER_PADS, SAME_WARM, {"collar_moment": SHARED}, NOT_CARRIED)
    ),
    "shaft line": partial(faults_of, Family(thrust_line_case, ON_OTHER_PADS, SAME_WARM, {}, NOT_CARRIED)),
}


def main(indices: Iterable[int], seed: int, only: str) -> int:
    """Run cases, print what is wrong, and return an exit status."""
    families = {name: trial for name, trial in FAMILIES.items() if only in name}
    ended: dict[str, Counter[str]] = defaultdict(Counter)
    slowest: dict[str, float] = defaultdict(float)
    wrong = 0
    for index in indices:
        name = list(families)[index % len(families)]
        try:
            outcome = families[name](f"{seed} {name} {index}")
        except KeyboardInterrupt:
            break
        ended[name][outcome.status] += 1
        slowest[name] = max(slowest[name], outcome.seconds)
        slow = (f"took {outcome.seconds:.0f} s",) if outcome.seconds > SLOWEST else ()
        for fault in (*outcome.faults, *slow):
            wrong += 1
            print(f"{name} {index}: {fault}", flush=True)
    for name, counts in ended.items():
        print(f"{name}: {dict(counts)}, slowest {slowest[name]:.1f} s")
    return 1 if wrong else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Solve random bearings and print what is wrong with any.")
    parser.add_argument("number", nargs="?", type=int, default=1500, help="of cases; %(default)s where left out")
    parser.add_argument("seed", nargs="?", type=int, default=1, help="%(default)s where left out")
    parser.add_argument("family", nargs="?", default="", help="part of its name; all where left out")
    parser.add_argument("--from", dest="first", type=int, default=0, metavar="INDEX", help="of the first case")
    asked = parser.parse_args()
    sys.exit(main(range(asked.first, asked.first + asked.number), asked.seed, asked.family))
