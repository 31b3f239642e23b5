"""Time of hydrostatic bearings: a four-recess hybrid bearing at given load with coefficients, and others.

Run from the repository root: ``python benchmarks/hydrostatic_speed.py``. Prints median and least processor time of
repeated runs after one that compiles. Exit status 1 if a promise is broken by the least time.
"""

from __future__ import annotations

import math
import os
import sys
import time
from collections.abc import Callable

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np

from babbitt.kinds.hydrostatic.answer import answer
from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, ThrustRing
from babbitt.kinds.hydrostatic.impedance import Compressibility, impedance
from babbitt.kinds.hydrostatic.lines import DRAFT, ENGINEERING, REFERENCE, Grid
from babbitt.kinds.hydrostatic.lumped import lumped_at, lumped_under
from babbitt.kinds.hydrostatic.lumps import journal_lumps
from babbitt.kinds.hydrostatic.model import HydrostaticCase, Oil, OperatingConditions, Recesses
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.restrictors import Capillary
from babbitt.kinds.hydrostatic.single_recess import gap_under, pad_at
from babbitt.kinds.hydrostatic.state import SearchOutcome, equilibrium_under
from babbitt.kinds.hydrostatic.supply import FixedPressure
from babbitt.kinds.hydrostatic.surfaces import FilmOil, journal_surface, ring_surface

SPEED = 1500.0 * math.pi / 30.0
JOURNAL = RecessedJournal(
    0.1, 0.1, 50e-6, tuple(math.radians(angle) for angle in (-90.0, 0.0, 90.0, 180.0)), math.radians(60.0), 0.07
)
FEEDING = Feeding((Capillary(0.8e-3, 0.1, 0.02),) * 4, FixedPressure(5e6))
RING = ThrustRing(
    AnnularPad(0.05, 0.065, 0.085, 0.1), tuple(math.radians(45.0 + 90.0 * k) for k in range(4)), math.radians(60.0)
)
RING_FEEDING = Feeding((Capillary(0.8e-3, 0.06, 0.02),) * 4, FixedPressure(3e6))
OIL = Compressibility(3.7e-6, 1e9)
QUICK_RING = HydrostaticCase(
    "Ring", "hydrostatic_thrust_ring", "quick", RING, RING_FEEDING, Oil(0.02, 870.0, 2000.0),
    OperatingConditions(25e3, moments=(200.0, 0.0), angular_speed=1000.0 * math.pi / 30.0), Recesses(1e-3), OIL,
)  # fmt: skip


def journal(load: float, grid: Grid) -> None:
    oil = FilmOil(0.02, SPEED, 5e6)
    state = equilibrium_under(
        lambda own: journal_surface(JOURNAL, oil, own), FEEDING, np.array([0.0, -load]), np.zeros(2), grid, 5e-7
    )
    if not state.solved:
        raise RuntimeError(f"{load} N: {state.ending}")
    impedance(state.response, state.network, OIL, 0.0)


def ring() -> None:
    oil = FilmOil(0.02, 1000.0 * math.pi / 30.0, 3e6)
    load = np.array([-25e3, 200.0, 0.0])
    state = equilibrium_under(
        lambda own: ring_surface(RING, 48e-6, oil, own), RING_FEEDING, load, np.zeros(3), ENGINEERING, 1e-6
    )
    impedance(state.response, state.network, OIL, 0.0)


def quick() -> None:
    lands = lands_of(CircularPad(0.05, 0.025))
    fed = Feeding((Capillary(0.6e-3, 0.06, 0.03),), FixedPressure(5e6))
    state = pad_at(lands, fed, 0.03, 40e-6)
    impedance(state.response, state.network, OIL, 600.0)


def quick_gap() -> None:
    lands = lands_of(CircularPad(0.05, 0.025))
    gap_under(lands, Feeding((Capillary(0.6e-3, 0.06, 0.03),), FixedPressure(5e6)), 0.03, 15e3, 1e-6)


def quick_journal() -> None:
    lumps = journal_lumps(JOURNAL, 0.02, SPEED)
    state = lumped_under(lumps, FEEDING, np.array([0.0, -20e3]), lumped_at(lumps, FEEDING, np.zeros(2)))
    impedance(state.response, state.network, OIL, 0.0)


def quick_ring() -> None:
    found = answer(QUICK_RING)
    if found.ending is not SearchOutcome.SOLVED:
        raise RuntimeError(f"quick ring: {found.ending}")
    impedance(found.response, found.network, OIL, 0.0)


# what, promised milliseconds (none: shown), how often
RUNS: tuple[tuple[str, Callable[[], None], float | None, int], ...] = (
    ("hybrid journal, 20 kN, coefficients", lambda: journal(20e3, ENGINEERING), 20.0, 40),
    ("hybrid journal, 30 kN, ruptured film", lambda: journal(30e3, ENGINEERING), 20.0, 40),
    ("hybrid journal, 20 kN, draft", lambda: journal(20e3, DRAFT), None, 40),
    ("hybrid journal, 20 kN, reference", lambda: journal(20e3, REFERENCE), None, 5),
    ("thrust ring under load and moment", ring, None, 20),
    ("round pad at a gap, closed form", quick, 1.0, 200),
    ("gap of a round pad under load, closed form", quick_gap, 1.0, 100),
    ("hybrid journal, 20 kN, lumped lands", quick_journal, 1.0, 100),
    ("ring under load and moment, lumped lands", quick_ring, 1.0, 100),
    ("ring under load and moment, lumped, result", lambda: hydrostatic_check(QUICK_RING), None, 100),
)


def main() -> int:
    """Measure all; 1 if a promise is broken."""
    broken = False
    print(f"{'':44}{'median ms':>10}{'least ms':>10}{'promise':>9}")
    for what, run, promise, count in RUNS:
        run()
        times = []
        for _ in range(count):
            begun = time.process_time()
            run()
            times.append(1e3 * (time.process_time() - begun))
        least = min(times)
        late = promise is not None and least > promise
        broken |= late
        said = "" if promise is None else f"{promise:g}"
        print(f"{what:44}{np.median(times):10.2f}{least:10.2f}{said:>9}{'  BROKEN' if late else ''}")
    return int(broken)


if __name__ == "__main__":
    sys.exit(main())
