"""How many rows a second studies compute, and what plan, store and progress cost.

Run ``python benchmarks/study_speed.py [ROWS] [WORKERS]`` on a quiet machine. The case is the bearing of
``examples/studies`` by ISO 7902, heat balance included, over fit, oil, load, speed and inlet temperature. Targets:
50 000 bearings a second on two cores, 10^6 in less than 40 s, plan, store and progress less than a tenth of the
work.
"""

from __future__ import annotations

import resource
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from babbitt.case.loading import load_case
from babbitt.case.parts.study import StudyBlock
from babbitt.core.units import AS_WRITTEN
from babbitt.study import grids
from babbitt.study.plan import plan
from babbitt.study.rows import solved_one_by_one, solved_rows
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


def main(rows: int, workers: int) -> None:
    """Time both samples: one process over chunks, single rows, and the whole study with its store."""
    for name, given in (("tolerances of one bearing", TOLERANCE), ("bearings of all sorts", WIDE)):
        block = StudyBlock.model_validate({**given, "samples": rows, "sampling": "random"}, context=AS_WRITTEN)
        made = plan(load_case(CASE), block)
        values, groups = grids.joint_sample(made.task.inputs, block)
        chunk = {
            "row": np.arange(4096),
            "group": groups[:4096],
            **{key: one[:4096] for key, one in values.items()},
        }
        few = {key: one[:40] for key, one in chunk.items()}
        solved_rows(made.task, few)
        begin = time.process_time()
        found = solved_rows(made.task, chunk)
        of_chunk = time.process_time() - begin
        begin = time.process_time()
        solved_one_by_one(made.task, few)
        alone = (time.process_time() - begin) / 40.0
        unsolved = int((found["status"] != "converged").sum())
        rate = f"{4096 / of_chunk:.0f} rows a second of one core, {1.0 / alone:.0f} one by one"
        print(f"{name}: {rate}; {unsolved} unsolved")
        with tempfile.TemporaryDirectory() as folder:
            begin = time.perf_counter()
            made = plan(load_case(CASE), block)
            planned = time.perf_counter() - begin
            study = run_study(made, workers=workers, folder=Path(folder) / "a.study")
            spent = time.perf_counter() - begin
        work = study.rows * of_chunk / 4096 / workers
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
        told = f"{spent:.1f} s (plan {planned:.2f} s), work {work:.1f} s, {study.rows / spent:.0f} rows a second"
        print(f"  study of {study.rows} rows in {workers} processes, stored: {told}; at most {memory:.2f} GB here")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100_000, int(sys.argv[2]) if len(sys.argv) > 2 else 2)
