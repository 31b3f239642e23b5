"""The same bits from threads and processes, however they are started; a folder that cannot be written."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

import babbitt as bb

SCRIPT = """
import json, multiprocessing, sys

import babbitt as bb

def numbers(text):
    result = bb.parse_case(text).solve()
    film = result.film.force(1e-5, -2e-5, 1e-3, 0.0)
    return [value.hex() for value in (result.minimum_film_thickness, *result.stiffness.flat, *film)]

if __name__ == "__main__":
    text, told = sys.stdin.read(), {}
    told["main"] = numbers(text)
    for method in multiprocessing.get_all_start_methods():
        with multiprocessing.get_context(method).Pool(2) as pool:
            first, second = pool.map(numbers, [text, text])
            assert first == second
            told[method] = first
    print(json.dumps(told))
"""

FILM = bb.JournalBearing(
    diameter="200 mm", width="120 mm", clearance=bb.relative_clearance(1.5e-3), bore=bb.Lobes(preload=0.3),
    grooves=bb.grooves(["0 deg", "180 deg"], extent="20 deg", pressure="0 Pa"), lubricant="ISO VG 46",
    supply=bb.Supply(temperature="45 degC", pressure="0 Pa"), materials=bb.Materials(bearing="C45", journal="C45"),
    method=bb.Film(accuracy="draft"), load="10 kN", speed="3000 rpm",
)  # fmt: skip


def run(tmp_path, **environment):
    (tmp_path / "script.py").write_text(SCRIPT)
    return subprocess.run(
        [sys.executable, str(tmp_path / "script.py")], input=FILM.to_yaml(), capture_output=True, text=True,
        check=True, env=os.environ | environment, timeout=600,
    )  # fmt: skip


@pytest.mark.slow
def test_every_way_to_start_a_process_gives_the_same_bits(tmp_path):
    found = json.loads(run(tmp_path).stdout)
    assert {"main", "spawn"} <= {*found}
    assert len({tuple(numbers) for numbers in found.values()}) == 1
    assert len(found["main"]) == 7


@pytest.mark.solves_anew
def test_threads_give_the_same_bits():
    cases = [FILM.replace(load=load) for load in (5e3, 10e3, 20e3, 40e3)]
    alone = [case.solve() for case in cases]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda case: case.solve(), cases))
    assert alone == together
    for one, other in zip(alone, together, strict=True):
        assert one.stiffness.tobytes() == other.stiffness.tobytes()


@pytest.mark.thorough
@pytest.mark.slow
def test_a_folder_that_cannot_be_written_costs_a_line(tmp_path):
    """A folder for machine code that is a file: nobody can write in it, whoever he is."""
    (tmp_path / "blocked").write_text("")
    code = (
        "from babbitt.api.batch import solve_batch\n"
        "found = solve_batch(diameter=0.2, width=0.12, radial_clearance=15e-5, viscosity=0.02, speed=300.0,\n"
        "                    load=(0.0, -1e4), accuracy='draft')\n"
        "print(found.minimum_film_thickness[0].hex())\n"
    )
    blocked = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "blocked")}
    commands = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=one)
                for one in (dict(os.environ), blocked)]  # fmt: skip
    usual, uncached = commands
    assert usual.stdout == uncached.stdout
    told = uncached.stderr.splitlines()
    assert sum("cannot be written" in line for line in told) == 1
    (line,) = (line for line in told if "cannot be written" in line)
    assert "compiled anew in every process" in line
    assert "NUMBA_CACHE_DIR" in line
    assert "cannot be written" not in usual.stderr
