"""Compile the kernels of the film engine in two processes, before tests ask for them.

    python tests/compile_kernels.py

Workers that begin with an empty cache would each compile the same kernels. The halves take about the same time and
have few kernels in common: bearings with temperatures or misalignment, whose films differ across the width, and
tilting pads on the finest grid; tilting pads on the usual one, batches, and films of grooved bores, which find
some of what they need compiled by the first half.
"""

from __future__ import annotations

import gc
import subprocess
import sys
from dataclasses import replace
from typing import Any

Fields = dict[str, Any]

BEARING: Fields = {
    "kind": "journal",
    "name": "Bearing",
    "method": "film",
    "diameter": "200 mm",
    "width": "120 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "45 degC", "pressure": "0.15 MPa"},
    "grooves": [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"}],
    "load": "30 kN",
    "speed": "3000 rpm",
}
WARM: Fields = {
    "thermal": "full",
    "accuracy": "draft",
    "walls": {"bush": {"outer_diameter": "260 mm", "conductivity": "45 W/(m K)"}},
}
POCKET: Fields = {"grooves": None, "pockets": [{"angle": "90 deg", "extent": "20 deg", "width": "60 mm"}]}
WIDEST: Fields = {"grooves": None, "film_start": "widest_gap", "cavitation": "reynolds"}
TILTED: Fields = {"misalignment": {"x": "0.05 mrad", "y": "0 mrad"}}
FINE: Fields = {"accuracy": "reference"}
REYNOLDS: Fields = {"cavitation": "reynolds"}
FOLLOWING: Fields = {"temperature_coefficients": "following"}
HALVES: tuple[tuple[Fields, ...], ...] = (
    (TILTED, POCKET, WARM, WARM | TILTED | FOLLOWING),
    ({}, REYNOLDS, WIDEST, FINE, FINE | REYNOLDS, FINE | WIDEST),
)


def compile_pads(unknowns: int) -> None:
    """Solve a bearing of tilting pads with so many unknowns across half a pad; of 4 also on flexures at a place,
    and behind a search that ends too soon and goes on along the load, and with its temperatures."""
    from babbitt.reynolds.model import Resolution
    from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
    from babbitt.reynolds.tilting_pads.pad_heat import PadHeat
    from babbitt.reynolds.tilting_pads.solve import fold_of, solve_tilting_pads, tilting_pads_at
    from babbitt.reynolds.tilting_pads.thermal_pads import find_thermal_tilting_pads

    pads = tuple(TiltingPad(angle, 1.2, 1e-4, 6e-5, 0.02, 0.55) for angle in (0.8, 2.4, 4.0, 5.6))
    bearing = TiltingPadBearing(0.1, 0.07, 0.02, 300.0, pads)
    solve_tilting_pads(bearing, (0.0, -5e3), Resolution(unknowns, 24))
    fold_of(bearing, 0, Resolution(unknowns, 24))
    if unknowns != 4:
        return
    flexed = replace(bearing, pads=tuple(replace(pad, rotational_stiffness=1e4) for pad in pads))
    solve_tilting_pads(flexed, (0.0, -5e3), Resolution(4, 24), max_steps=1)
    tilting_pads_at(flexed, (0.0, 0.0), Resolution(4, 24))
    heat = PadHeat(lambda temperature: 0.02 + 0.0 * temperature, 1.7e6, 0.14, 313.15)
    find_thermal_tilting_pads(bearing, (0.0, -5e3), heat, Resolution(4, 24))


def compile_batch() -> None:
    """Solve a batch on the usual grid."""
    from babbitt.reynolds.lands.batch import solve_batch
    from babbitt.reynolds.model import Resolution, grooved_bore

    lands = grooved_bore((0.0, 3.0), 0.35)
    solve_batch(0.2, 0.12, [140e-6, 150e-6], 0.02, 300.0, (0.0, -3e4), lands, resolution=Resolution(4, 48))


def compile_half(half: int) -> None:
    """Solve bearings whose films need the kernels of one half."""
    from babbitt.case import case_from_dict
    from babbitt.solving import solve

    gc.set_threshold(100_000)  # else a tenth of the time is spent in search of garbage
    if half == 1:
        compile_pads(4)
        compile_batch()
    for changes in HALVES[half]:
        fields = {name: value for name, value in (BEARING | changes).items() if value is not None}
        solve(case_from_dict(fields))
    if half == 0:
        compile_pads(6)


def main() -> int:
    """Run both halves side by side; the first exit status that is not zero, or zero."""
    halves = [subprocess.Popen([sys.executable, __file__, str(half)]) for half in range(len(HALVES))]
    return next((half.returncode for half in halves if half.wait()), 0)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        compile_half(int(sys.argv[1]))
    else:
        sys.exit(main())
