"""Tilting-pad bearings of one layout at random preload and clearance: bands, and the rate beside one by one.

    python benchmarks/tilting_pad_batch.py [number [seed]]

A thousand times the four pads of Fillon, Bligoud and Frene (1992) at 4000 rpm under a flexible rotor, machined
clearance 148 +- 8 um and preload 0.47 +- 0.07 (uniform), in films of one temperature and in films with their own.
One by one: a sweep of the case language, on a sample. Marks: every bearing has a status, the sample the numbers of
the batch within 1e-9, and the batch takes less processor time for each bearing (other work on the machine does not
count).
"""

from __future__ import annotations

import os
import sys
import time
from collections import Counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

import babbitt
from babbitt.api.pad_batch import PadBatch

NUMBER, SAMPLE, SAME = 1000, 20, 1e-9
SHOWN = {
    "maximum_temperature": ("T_max in degC", 1.0, -273.15),
    "effective_temperature": ("film in degC", 1.0, -273.15),
    "minimum_film_thickness": ("h_min in um", 1e6, 0.0),
    "stiffness": ("K in MN/m", 1e-6, 0.0),
    "damping": ("C in kN s/m", 1e-3, 0.0),
    "log_decrement": ("log decrement", 1.0, 0.0),
}


def bearing(thermal: str) -> babbitt.TiltingPadBearing:
    """The bearing with one of its thermal models."""
    return babbitt.TiltingPadBearing(
        diameter="100 mm",
        pads=babbitt.JournalPads(
            number=4,
            first_pivot="45 deg",
            extent="75 deg",
            width="70 mm",
            thickness="20 mm",
            clearance=babbitt.radial_clearance("148 um"),
            preload=0.47,
            inertia="0.0011 kg m2",
        ),
        load="10 kN",
        speed="4000 rpm",
        lubricant="ISO VG 32",
        supply=babbitt.PadOilSupply(temperature="40 degC"),
        rotor_mass="1020 kg",
        shaft_stiffness="150 MN/m",
        method=babbitt.Film(thermal=thermal),
    )


def one_by_one(
    chosen: babbitt.TiltingPadBearing, clearance: NDArray[np.float64], preload: NDArray[np.float64]
) -> list[Any]:
    """The same bearings as a sweep."""
    return [
        chosen.solve({"pads.clearance": babbitt.radial_clearance(float(own)), "pads.preload": float(one)})
        for own, one in zip(clearance, preload, strict=True)
    ]


def show(found: PadBatch) -> None:
    """Mean, 5 % and 95 % of what is shown."""
    for name, (label, scale, shift) in SHOWN.items():
        band = found.band(name)
        if not band.count:
            continue
        places: dict[str, tuple[int, ...]] = {"_xx": (0, 0), "_yy": (1, 1)} if np.ndim(band.mean) else {"": ()}
        for axes, place in places.items():
            mean, low, high = (
                scale * float(np.asarray(one)[place]) + shift for one in (band.mean, band.low, band.high)
            )
            print(f"    {label}{axes}: mean {mean:.4g}, 5 % {low:.4g}, 95 % {high:.4g}")


def main() -> int:
    number = int(sys.argv[1]) if len(sys.argv) > 1 else NUMBER
    rng = np.random.default_rng(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    clearance, preload = rng.uniform(140e-6, 156e-6, number), rng.uniform(0.40, 0.54, number)
    missed = False
    for thermal in ("isothermal", "full"):
        chosen = bearing(thermal)
        babbitt.solve_pad_batch(chosen)
        clock, cpu = time.perf_counter(), time.process_time()
        found = babbitt.solve_pad_batch(chosen, clearance=clearance, preload=preload)
        wall, used = (time.perf_counter() - clock) / number, (time.process_time() - cpu) / number
        count = min(SAMPLE, number)
        chosen.solve()
        clock, cpu = time.perf_counter(), time.process_time()
        single = one_by_one(chosen, clearance[:count], preload[:count])
        alone, busy = (time.perf_counter() - clock) / count, (time.process_time() - cpu) / count
        stiffness = np.array([one.stiffness for one in single])
        apart = np.abs(found.stiffness[:count] - stiffness).max() / stiffness.max()
        ends = dict(Counter(one.name for one in found.outcomes))
        print(f"{thermal}: {number} bearings, {ends}, {os.cpu_count()} cores")
        print(
            f"    batch {1.0 / wall:.0f} a second, {1e3 * used:.2f} ms of processor time each; one by one "
            f"{1.0 / alone:.0f} a second, {1e3 * busy:.2f} ms ({busy / used:.1f} times); K apart by {apart:.0e}"
        )
        show(found)
        missed = missed or apart > SAME or used > busy or len(found.outcomes) != number
    return int(missed)


if __name__ == "__main__":
    sys.exit(main())
