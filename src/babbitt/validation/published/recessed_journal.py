"""A recessed journal bearing: its limits, and the refinement of its grid."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.hydrostatic.geometry import RecessedJournal
from babbitt.kinds.hydrostatic.lines import Grid
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.restrictors import Capillary
from babbitt.kinds.hydrostatic.supply import FixedPressure
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import INK, MARKERS, draw_deviations
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from babbitt.kinds.hydrostatic.state import RecessState

CLEARANCE, SUPPLY = 50e-6, 5e6
BEARING = RecessedJournal(
    0.1,
    0.1,
    CLEARANCE,
    tuple(math.radians(angle) for angle in (-90.0, 0.0, 90.0, 180.0)),
    math.radians(60.0),
    0.07,
)
FEEDING = Feeding((Capillary(0.8e-3, 0.1, 0.02),) * 4, FixedPressure(SUPPLY))
LINES = (96, 192, 384)
EXTRAPOLATED = (14916.07, 5.02398e8, 5.04790e-5)
"""Load in N, stiffness in N/m and flow in m3/s at eps = 0.5 on a recess, at rest: finite volumes on cosine-graded
grids up to 768 lines, extrapolated; a program of our own, independent of the engine."""


def state(eps: float, lines: int, speed: float = 0.0) -> RecessState:
    """Journal moved towards the lowest recess."""
    from babbitt.kinds.hydrostatic.state import state_at
    from babbitt.kinds.hydrostatic.surfaces import FilmOil, journal_surface

    oil = FilmOil(0.02, speed, SUPPLY)
    at = np.array([0.0, -eps * CLEARANCE])
    return state_at(lambda grid: journal_surface(BEARING, oil, grid), FEEDING, at, Grid(lines, 10))


@lru_cache
def at_half(lines: int) -> tuple[float, float, float]:
    """Load, stiffness and flow at half the clearance."""
    from babbitt.kinds.hydrostatic.impedance import static_coefficients

    found = state(0.5, lines)
    stiffness, _ = static_coefficients(found.response, found.network)
    return float(found.force[1]), float(stiffness[1, 1]), float(found.network.flows.sum())


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Limits and refinement."""
    return tuple(rows())


def rows() -> Iterator[Comparison]:
    """All comparisons."""
    names = (("F", 1.0, "N", 1), ("K", 1e-6, "MN/m", 3), ("Q", 6e4, "L/min", 5))
    tight, loose = Within(relative=2e-4), Within(relative=5e-3)
    fine, half = np.array(at_half(LINES[-1])), np.array(at_half(LINES[-2]))
    for place, (name, scale, unit, decimals) in enumerate(names):
        wanted = scale * EXTRAPOLATED[place]
        for lines in LINES:
            got = scale * at_half(lines)[place]
            where = f"ε = 0.5, {lines} lines"
            yield Comparison(name, where, wanted, got, loose, unit, "extrapolated, own program", decimals)
        got = scale * float(fine[place] + (fine[place] - half[place]) / 3.0)
        where = "ε = 0.5, extrapolated"
        yield Comparison(name, where, wanted, got, tight, unit, "extrapolated, own program", decimals)
    yield from limits()


def limits() -> Iterator[Comparison]:
    """Concentric and without rotation."""
    from babbitt.kinds.hydrostatic.impedance import static_coefficients

    centred = state(0.0, 96)
    stiffness, damping = static_coefficients(centred.response, centred.network)
    size, none = float(stiffness[0, 0]), Within(absolute=1e-6)
    yield Comparison("K_xx/K_yy", "concentric", 1.0, size / float(stiffness[1, 1]), none, "", "symmetry", 6)
    yield Comparison("C_xx/C_yy", "concentric", 1.0, float(damping[0, 0] / damping[1, 1]), none, "", "symmetry", 6)
    yield Comparison(
        "K_xy/K_xx", "concentric, at rest", 0.0, float(stiffness[0, 1]) / size, none, "", "symmetry", 6
    )
    spread = float(np.ptp(centred.network.pressures)) / SUPPLY
    yield Comparison("Δp_r/p_s", "concentric", 0.0, spread, none, "", "symmetry", 6)
    spinning = state(0.0, 96, 157.08)
    turning, _ = static_coefficients(spinning.response, spinning.network)
    skew = float(turning[0, 1] + turning[1, 0]) / size
    yield Comparison("(K_xy+K_yx)/K_xx", "concentric, 1500 rpm", 0.0, skew, none, "", "symmetry", 6)
    for eps in (0.3, 0.8):
        dry = state(eps, 96).dry_share
        yield Comparison("dry share", f"at rest, ε = {eps:g}", 0.0, dry, none, "", "maximum principle", 6)


def draw(figure: Figure) -> None:
    """Error over lines, and all deviations."""
    figure.set_size_inches(7.2, 3.0)
    left, right = figure.subplots(1, 2)
    lines = np.array([64, *LINES])
    for place, (name, marker) in enumerate(zip(("F", "K", "Q"), MARKERS, strict=False)):
        errors = [abs(at_half(int(n))[place] / EXTRAPOLATED[place] - 1.0) for n in lines]
        left.plot(lines, errors, marker=marker, color=INK, markerfacecolor="none", linestyle=":", label=name)
    left.plot(lines, 40.0 / lines.astype(float) ** 2, color="0.6", label="lines$^{-2}$")
    left.set(xscale="log", yscale="log", xlabel="lines around the bearing", ylabel="relative error")
    left.set_xticks(lines, [str(n) for n in lines])
    left.minorticks_off()
    left.legend()
    found = run()
    draw_deviations(right, found)
    right.set_title(f"all {len(found)} values")


CASE = ValidationCase(
    name="recessed_journal",
    title="Recessed journal bearing: refinement of the grid, and its limits",
    story=Story(
        what=(
            "Four recesses, each behind its capillary, carry a spindle at rest. The film between them has "
            "singular "
            "corners, and the recess pressures are unknowns of a network: grid refinement shows what an answer is "
            "worth."
        ),
        source=(
            "No worked example with all data is public. The reference is a second program of ours in finite "
            "volumes on "
            "graded grids, extrapolated; symmetry and the maximum principle are exact."
        ),
        assumptions=(
            "D = B = 100 mm, c = 50 µm, four recesses of 70 mm and 60°, capillaries 0.8 × 100 mm, 20 mPa s, 5 MPa."
        ),
        tolerances="0.5 % on every grid, 2e-4 extrapolated; limits to 1e-6.",
        differences=(
            "Errors fall with the square of the number of lines, for these crowd towards the corners of the "
            "recesses. "
            "The default grid of 192 lines has 0.01 % in load, 0.1 % in stiffness, 0.04 % in flow."
        ),
    ),
    run=run,
    draw=draw,
    caption="Relative error of load, stiffness and flow over the number of lines, and every deviation in units of "
    "its tolerance.",
)
