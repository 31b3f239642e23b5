"""Babbitt's side: warm calls of the compiled kernel, and of the public functions with all that is reported."""

from __future__ import annotations

from functools import partial
from math import radians
from time import process_time
from typing import Any

from five_pads import (
    ANGLES,
    ARC,
    ASSEMBLED,
    DIAMETER,
    LOAD,
    PRELOAD,
    SPEED,
    THICKNESS,
    VISCOSITY,
    WIDTH,
    answer,
    processor_times,
    row,
)

import babbitt
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads._pads import find_pads
from babbitt.reynolds.tilting_pads._place import new_places
from babbitt.reynolds.tilting_pads.dynamics import CondensedCoefficients, condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales, kernel_pads
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.solve import no_total, solve_tilting_pads

GRIDS = {"4 x 24": Resolution(4, 24), "4 x 48": Resolution(4, 48), "4 x 96": Resolution(4, 96)}
COARSE, FINE = Resolution(6, 192, tolerance=1e-9), Resolution(6, 384, tolerance=1e-9)
"""From which the limit is extrapolated, of second order."""

PADS = tuple(
    TiltingPad(radians(angle), radians(ARC), ASSEMBLED / (1.0 - PRELOAD), ASSEMBLED, THICKNESS) for angle in ANGLES
)
BEARING = TiltingPadBearing(DIAMETER, WIDTH, VISCOSITY, SPEED, PADS)


def solved(resolution: Resolution) -> CondensedCoefficients:
    """Position, films and synchronous coefficients."""
    return condensed_at(full_coefficients(solve_tilting_pads(BEARING, (0.0, -LOAD), resolution)), 1.0)


def numbers_of(found: CondensedCoefficients) -> dict[str, float]:
    """The diagonals."""
    k, c = found.stiffness, found.damping
    return {"kxx": float(k[0, 0]), "kyy": float(k[1, 1]), "cxx": float(c[0, 0]), "cyy": float(c[1, 1])}


def limit() -> dict[str, float]:
    """Of ever finer grids."""
    coarse, fine = numbers_of(solved(COARSE)), numbers_of(solved(FINE))
    return {name: fine[name] + (fine[name] - coarse[name]) / 3.0 for name in fine}


def kernel(resolution: Resolution) -> Any:
    """The compiled equilibrium from the middle, without a result object."""
    scales = PadScales(BEARING)
    pads, axial = kernel_pads(BEARING, scales), kernel_operator(resolution.axial_unknowns)

    def call() -> object:
        return find_pads(
            axial, pads, resolution.intervals, 0.0, -LOAD / scales.force, 0.0, 0.0, resolution.tolerance, 100,
            new_places(pads), no_total(),
        )  # fmt: skip

    return call


def main() -> None:
    begun = process_time()
    solved(GRIDS["4 x 48"])
    first = process_time() - begun
    rows = []
    for name, resolution in GRIDS.items():
        found = numbers_of(solved(resolution))
        rows.append(row("Babbitt kernel", "own", name, processor_times(kernel(resolution), 0.4, 20), **found))
        whole = processor_times(partial(solved, resolution), 0.4, 20)
        rows.append(row("Babbitt whole", "own", name, whole, **found))
    answer({"version": babbitt.__version__, "first": first, "rows": rows, "limit": limit()})


if __name__ == "__main__":
    main()
