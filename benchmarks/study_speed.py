"""How many rows a second studies compute, and what plan, store and progress cost.

Run ``python benchmarks/study_speed.py [SET] [ROWS] [WORKERS]`` on a quiet machine; sets are

- ``tolerances``, ``bearings``: the bearing of ``examples/studies`` by ISO 7902, heat balance included, over fit,
  oil, load, speed and inlet temperature, or over clearance, width and the like. Targets: 50 000 bearings a second
  on two cores, 10^6 in less than 40 s.
- ``films``: films of one temperature between two grooves (4 x 48) over load, width, speed, clearance and
  temperature. Target: 10^6 in less than 90 s on two cores, in less than 1 GB.
- ``adiabatic``: films with temperatures of their own (4 x 48). Target: 10^5 in less than 240 s on two cores.

Plan, store and progress are to take less than a tenth of the work, which is the processor time of a chunk times
their number.
"""

from __future__ import annotations

import resource
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.loading import case_from_dict, load_case
from babbitt.case.parts.study import StudyBlock
from babbitt.core.units import AS_WRITTEN
from babbitt.study import grids
from babbitt.study.engine import MOST_IN_CHUNK
from babbitt.study.plan import plan
from babbitt.study.rows import Columns, solved_as_arrays, solved_one_by_one, solved_rows
from babbitt.study.study import run_study

CASE = Path(__file__).parents[1] / "examples" / "studies" / "bearing.yaml"

TOLERANCE = {
    "kind": "tolerance",
    "vary": {
        "clearance": {"fit": "H7/e7"},
        "lubricant": {"scatter": "vg"},
        "supply.temperature": {"normal": ["58 degC", "2 K"]},
        "load": {"uniform": ["20 kN", "30 kN"]},
        "speed": {"uniform": ["1500 rpm", "2500 rpm"]},
    },
}
WIDE = {
    "kind": "tolerance",
    "vary": {
        "clearance.mean": {"uniform": ["0.8 permille", "2.4 permille"]},
        "width": {"uniform": ["45 mm", "110 mm"]},
        "supply.temperature": {"uniform": ["35 degC", "60 degC"]},
        "load": {"uniform": ["2 kN", "90 kN"]},
        "speed": {"uniform": ["300 rpm", "5000 rpm"]},
    },
}


FILM = {
    "kind": "journal",
    "name": "Two lands",
    "diameter": "200 mm",
    "width": "120 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "grooves": [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"}],
    "lubricant": "ISO VG 32",
    "materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "42CrMo4"},
    "supply": {"temperature": "45 degC", "pressure": "0 Pa"},
    "load": "20 kN",
    "speed": "1500 rpm",
    "method": {"kind": "film", "accuracy": "draft"},
}
FILMS = {
    "kind": "tolerance",
    "vary": {
        "load": {"uniform": ["5 kN", "60 kN"]},
        "width": {"uniform": ["80 mm", "190 mm"]},
        "speed": {"uniform": ["600 rpm", "4000 rpm"]},
        "clearance.mean": {"uniform": ["0.8 permille", "2.5 permille"]},
    },
}
GIVEN = {"effective_temperature": {"uniform": ["40 degC", "80 degC"]}}

SETS = {
    "tolerances": (CASE, TOLERANCE),
    "bearings": (CASE, WIDE),
    "films": ({**FILM, "effective_temperature": "55 degC"}, {**FILMS, "vary": FILMS["vary"] | GIVEN}),
    "adiabatic": (
        {**FILM, "method": {"kind": "film", "accuracy": "draft", "thermal": "adiabatic"}},
        {**FILMS, "vary": {name: FILMS["vary"][name] for name in ("load", "speed")}},
    ),
}

ALONE = 20
"""Rows that are timed one by one."""


def main(name: str, rows: int, workers: int) -> None:
    """Time a set: one process over a chunk, single rows, and the whole study with its store."""
    given, asked = SETS[name]
    case = load_case(given) if isinstance(given, Path) else case_from_dict(given)
    block = StudyBlock.model_validate({**asked, "samples": rows, "sampling": "random"}, context=AS_WRITTEN)
    made = plan(case, block)
    values, groups = grids.joint_sample(made.task.inputs, block)
    size = min(
        rows, MOST_IN_CHUNK if solved_as_arrays(made.task, _first(values, groups, 64)) is not None else ALONE
    )
    chunk = _first(values, groups, size)
    of_chunk, found = _timed(lambda: solved_rows(made.task, chunk))
    alone, _ = _timed(lambda: solved_one_by_one(made.task, _first(values, groups, ALONE)))
    rate = f"{size / of_chunk:.0f} rows a second of one core, {ALONE / alone:.0f} one by one"
    print(f"{name}: {rate}; {int((found['status'] != 'converged').sum())} of {size} unsolved")
    with tempfile.TemporaryDirectory() as folder:
        begin, before = time.perf_counter(), time.process_time()
        made = plan(case, block)
        planned = time.perf_counter() - begin
        study = run_study(made, workers=workers, folder=Path(folder) / "a.study")
        spent = time.perf_counter() - begin
    work = study.rows * of_chunk / size
    here, there = time.process_time() - before, sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    memory = [resource.getrusage(who).ru_maxrss / 1e6 for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    told = f"{spent:.1f} s (plan {planned:.2f} s), {study.rows / spent:.0f} rows a second"
    print(f"  study of {study.rows} rows in {workers} processes, stored: {told}")
    each = f"{here:.1f} s here, {there:.1f} s in processes: {(here + there) / workers:.1f} s on {workers} cores"
    print(f"  work {work:.1f} s of processor; used: {each}")
    print(f"  memory: {memory[0]:.2f} GB here, {memory[1]:.2f} GB in the largest process")


def _first(values: Columns, groups: NDArray[Any], count: int) -> Columns:
    return {
        "row": np.arange(count),
        "group": groups[:count],
        **{key: one[:count] for key, one in values.items()},
    }


def _timed(work: Callable[[], Columns]) -> tuple[float, Columns]:
    """Processor time of some work in s, and what it gives."""
    begin = time.process_time()
    found = work()
    return time.process_time() - begin, found


if __name__ == "__main__":
    names = sys.argv[1:2] if len(sys.argv) > 1 else list(SETS)
    for chosen in names:
        few = 1_000 if chosen == "adiabatic" else 100_000
        main(chosen, int(sys.argv[2]) if len(sys.argv) > 2 else few, int(sys.argv[3]) if len(sys.argv) > 3 else 2)
