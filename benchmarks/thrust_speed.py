"""How long thrust pads and a shaft line take, and the 12 pads of a hydro-generator beside ROSS.

Marks: one tilting pad with its tilt and all coefficients, load within 0.2 % of a fine mesh, 5 ms; the base case
of the
trawler line (pad, share, both harmonics, losses, films, frequencies, damping ratios) 0.2 s; a sweep of 40 rings
2 s; fifty
times as fast as the thermal `ThrustPad` of ROSS where that is installed.

    python benchmarks/thrust_speed.py
    BABBITT_ROSS_PYTHON=/path/to/python python benchmarks/thrust_speed.py     where ROSS lives elsewhere

ROSS solves a temperature field on 10 x 10 cells, Babbitt one on 64 intervals along the pad, 7 columns across and
8 layers across the gap, the pressure with polynomials of degree 8: what is compared is the time to films, flows,
temperatures, stiffness and damping. Times are those of the fastest warm calls, which other work on the machine
disturbs least. Exit status 1 when a mark is missed.
"""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from collections.abc import Callable

from babbitt.kinds.shaft_line.damped import damped_modes
from babbitt.kinds.shaft_line.model import state_of
from babbitt.kinds.shaft_line.natural import modes
from babbitt.kinds.shaft_line.sweeps import ring_sweep, usual_rings
from babbitt.kinds.thrust.equilibrium import pad_state
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.validation.published.thrust_hydro_generator import solved
from babbitt.validation.published.trawler_line import PAD, SPEED, VISCOSITY, duty

BY_ROSS = """
import time
import ross
from ross.bearings.thrust_pad import ThrustPad
from ross.units import Q_
def make():
    return ThrustPad(n=1, pad_inner_radius=Q_(1150, "mm"), pad_outer_radius=Q_(1725, "mm"),
        pad_pivot_radius=Q_(1442.5, "mm"), pad_arc=Q_(26, "deg"), pivot_angle=Q_(15, "deg"),
        oil_supply_temperature=Q_(40, "degC"), lubricant="ISOVG68", n_pads=12, n_theta=10, n_radial=10,
        speed=Q_([90], "RPM"), equilibrium_position_mode="calculate", model_type="thermo_hydro_dynamic",
        axial_load=13.320e6, radial_inclination_angle=Q_(-2.75e-04, "rad"),
        circumferential_inclination_angle=Q_(-1.70e-05, "rad"), initial_film_thickness=Q_(0.2, "mm"))
make()
start = time.perf_counter()
make()
print("seconds", time.perf_counter() - start)
"""


def fastest(call: Callable[[], object], repeats: int) -> float:
    """Seconds of the fastest warm call."""
    call()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def pad() -> object:
    return pad_state(PAD, 50e-6, VISCOSITY, SPEED)


def base_case() -> object:
    films = carrying(PAD, VISCOSITY, SPEED)
    state = state_of(duty(), films)
    line = state.duty.line
    return damped_modes(line, state.pads, modes(line, state.pads, 4)), state.losses


def seconds_of_ross() -> float | None:
    interpreter = os.environ.get("BABBITT_ROSS_PYTHON", sys.executable)
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(
        [interpreter, "-c", BY_ROSS], env=environment, capture_output=True, text=True, check=False
    )
    if "No module named 'ross'" in done.stderr:
        return None
    line = next((line for line in done.stdout.splitlines() if line.startswith("seconds ")), "")
    if not line:
        raise RuntimeError(f"ROSS failed:\n{done.stderr[-3000:]}")
    return float(line.split()[1])


def main() -> int:
    fine = [pad_state(PAD, 50e-6, VISCOSITY, SPEED, intervals=n, degree=12).load for n in (96, 192)]
    limit = fine[1] + (fine[1] - fine[0]) / 3.0
    error = abs(pad_state(PAD, 50e-6, VISCOSITY, SPEED).load / limit - 1.0)
    films = carrying(PAD, VISCOSITY, SPEED)
    rings = usual_rings(duty(), state_of(duty(), films))
    hydro = fastest(lambda: solved(0.0, own=True, resolved=True), 9)
    one_viscosity = fastest(lambda: solved(0.0), 9)
    rows = [
        ("one pad, tilt and all coefficients", fastest(pad, 51), 5e-3),
        ("base case of the trawler line", fastest(base_case, 9), 0.2),
        ("40 rings", fastest(lambda: ring_sweep(duty(), films, rings), 3), 2.0),
    ]
    missed = error > 2e-3
    print(f"load of the pad: {100.0 * error:.3f} % from the limit of fine meshes (mark 0.2 %)")
    for name, seconds, mark in rows:
        missed = missed or seconds > mark
        print(f"{name:36s} {1e3 * seconds:9.2f} ms   mark {1e3 * mark:6.0f} ms")
    print(f"{'12 pads, one viscosity':36s} {1e3 * one_viscosity:9.2f} ms")
    print(f"{'12 pads, temperature field':36s} {1e3 * hydro:9.2f} ms")
    theirs = seconds_of_ross()
    if theirs is None:
        print("ROSS is not installed; name its interpreter in BABBITT_ROSS_PYTHON")
    else:
        ratio = theirs / hydro
        missed = missed or not ratio >= 50.0 or not math.isfinite(ratio)
        print(f"{'the same in ROSS, temperature field':36s} {1e3 * theirs:9.2f} ms   ratio {ratio:.0f} (mark 50)")
    return int(missed)


if __name__ == "__main__":
    sys.exit(main())
