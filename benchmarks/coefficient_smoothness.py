"""How smooth stiffness and damping are along a load sweep: 200 loads, two grooves, one groove, three lobes.

    python benchmarks/coefficient_smoothness.py [axial unknowns, intervals]

A jump is what a step between two neighbouring loads exceeds the mean of the steps before and behind it by:
    J_i = | (v_i+1 - v_i) - ((v_i - v_i-1) + (v_i+2 - v_i+1)) / 2 |,
half the third difference. A discontinuity of height J reads J, a smooth curve over 200 loads next to nothing
(the finest grid shows how little). v is every entry of K and of C in dimensionless form, and J counts in parts of
the largest entry of its matrix at that load. Mark: 0.3 %.
"""

import math
import sys
from dataclasses import replace

import numpy as np

from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, JournalFilm, Land, Resolution, grooved_bore
from babbitt.reynolds.scales import Scales

LOADS, MARK = 200, 0.003
TWO = grooved_bore((0.0, math.pi), math.radians(20.0))
BEARING = JournalFilm(0.1, 0.08, 80e-6, 0.02, 300.0, TWO, Cavitation.REYNOLDS)


def lobed(film, count, preload):
    """Lobes of the same bore in a row, grooves of 20 degrees between them, none below."""
    lobe = film.clearance / (1.0 - preload)
    out = lobe - film.clearance
    lands = grooved_bore(tuple(0.5 * math.pi + 2.0 * math.pi / count * np.arange(count)), math.radians(20.0))
    middles = [0.5 * (land.start_angle + land.end_angle) for land in lands]
    return replace(film, lands=tuple(
        replace(land, clearance=lobe, centre=(-out * math.cos(middle), -out * math.sin(middle)))
        for land, middle in zip(lands, middles, strict=True)
    ))  # fmt: skip


BEARINGS = {
    "two grooves": BEARING,
    "two grooves, B/D 0.5": replace(BEARING, width=0.05),
    "groove above": replace(BEARING, lands=grooved_bore((0.5 * math.pi,), math.radians(20.0))),
    "three lobes": lobed(BEARING, 3, 0.5),
    "lemon bore": lobed(replace(BEARING, lands=TWO), 2, 0.4),
    "arc of 150 degrees": replace(BEARING, lands=(Land(math.radians(-165.0), math.radians(-15.0)),)),
}


def sweep(film, resolution, first=0.02, last=20.0):
    """Sommerfeld numbers, K and C in c/F and c omega/F of the solved loads, shape (loads, 8)."""
    scales = Scales.of(film, film.angular_speed)
    numbers = np.geomspace(first, last, LOADS)
    rows = np.full((LOADS, 8), np.nan)
    for row, number in zip(rows, numbers, strict=True):
        found = solve_journal(film, (0.0, -2.0 * number * scales.force), resolution)
        if found.outcome.solved:
            unit = scales.force / scales.length
            row[:4], row[4:] = found.stiffness.ravel() / unit, found.damping.ravel() * film.angular_speed / unit
    return numbers, rows


def jumps(rows):
    """Largest jump of the four entries of K and of C between each pair of loads, shape (loads - 3, 2)."""
    third = 0.5 * np.abs(np.diff(rows, n=3, axis=0)).reshape(-1, 2, 4).max(axis=2)
    return third / np.abs(rows[1:-2]).reshape(-1, 2, 4).max(axis=2)


def main():
    """Print a row per bearing and condition."""
    axial, intervals = (int(word) for word in (sys.argv[1:3] or ("4", "96")))
    worst = 0.0
    print(f"grid {axial} x {intervals}\n{'':24}{'condition':18}{'jump K':>9}{'at So':>8}{'jump C':>9}{'at So':>8}"
          f"{'above mark':>12}")  # fmt: skip
    for name, plain in BEARINGS.items():
        for cavitation in (Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING):
            numbers, rows = sweep(replace(plain, cavitation=cavitation), Resolution(axial, intervals))
            found = jumps(rows)
            words = ""
            for part in (0, 1):
                at = int(np.nanargmax(found[:, part]))
                worst = max(worst, found[at, part])
                words += f"{100.0 * found[at, part]:8.3f}%{numbers[at + 1]:8.3f}"
            print(f"{name:24}{cavitation.name.lower():18}{words}{int((found > MARK).any(axis=1).sum()):12}")
    print(f"largest jump {100.0 * worst:.3f} % (mark {100.0 * MARK} %)")
    return int(worst > MARK)


if __name__ == "__main__":
    sys.exit(main())
