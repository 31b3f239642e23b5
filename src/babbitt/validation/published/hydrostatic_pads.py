"""Hydrostatic pads: an exercise with printed answers, and the film against closed forms."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RectangularPad
from babbitt.kinds.hydrostatic.lines import REFERENCE
from babbitt.numerics.roots import bracketed_root
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, draw_deviations
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LOAD, FLOW, GAP, VISCOSITY = 60e3, 4e-6, 30e-6, 0.08
"""N, m3/s, m, Pa s of the exercise; its pad has a radius of 50 mm."""

CIRCULAR = CircularPad(0.05, 0.025)
ANNULAR = AnnularPad(0.05, 0.065, 0.085, 0.1)
EXACT, CORNERS = Within(relative=1e-5), Within(relative=2e-4)


def exercise() -> Iterator[Comparison]:
    """Recess radius and power of the pad that carries the load at the flow given."""

    def excess(recess: float) -> float:
        lands = lands_of(CircularPad(0.05, recess))
        return lands.effective_area * FLOW / lands.conductance(GAP, VISCOSITY) - LOAD

    found = bracketed_root(excess, 0.01, 0.045)
    yield Comparison("R₀", "exercise", 28.5, 1e3 * found, Within(absolute=0.1), "mm", "printed answer", 1)
    pressure = LOAD / lands_of(CircularPad(0.05, 28.5e-3)).effective_area
    yield Comparison("p_r Q", "exercise", 50.89, pressure * FLOW, Within(absolute=0.05), "W", "printed answer", 2)


def film_of(pad: CircularPad | AnnularPad | RectangularPad) -> tuple[float, float]:
    """Flow factor q_s and effective area (m2) of a pad by its film."""
    from babbitt.kinds.hydrostatic.surfaces import FilmOil, pad_surface, ring_surface
    from babbitt.reynolds.recess.recess_film import RecessFilm

    oil, gap, pressure = FilmOil(0.02, 0.0, 1e6), 50e-6, np.array([1e6])
    rectangular = isinstance(pad, RectangularPad)
    surface = (
        pad_surface(pad, gap, oil, REFERENCE)
        if isinstance(pad, RectangularPad)
        else ring_surface(pad, gap, oil, REFERENCE)
    )
    response = RecessFilm.on(surface).evaluate(np.zeros(1 if rectangular else 3), pressure)
    return 12.0 * 0.02 / gap**3 * float(response.outflow[0]) / 1e6, float(response.force[0]) / 1e6


def closed_forms() -> Iterator[Comparison]:
    """Film against closed form."""
    pads: dict[str, CircularPad | AnnularPad | RectangularPad] = {
        "round pad 50/25 mm": CIRCULAR,
        "ring 50/65/85/100 mm": ANNULAR,
    }
    for sides, land in ((2.0, 0.1), (2.0, 0.2), (3.0, 0.25)):
        pads[f"rectangle {sides:g} × 1, land {land:g}"] = RectangularPad(
            0.1 * sides, 0.1, 0.1 * (sides - 2.0 * land), 0.1 * (1.0 - 2.0 * land)
        )
    for name, pad in pads.items():
        lands, (flow, area) = lands_of(pad), film_of(pad)
        within = CORNERS if isinstance(pad, RectangularPad) else EXACT
        yield Comparison("q_s", name, lands.flow_factor, flow, within, "", "closed form", 4)
        yield Comparison("A_e", name, 1e4 * lands.effective_area, 1e4 * area, within, "cm²", "closed form", 4)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Exercise and closed forms."""
    return (*exercise(), *closed_forms())


def draw(figure: Figure) -> None:
    """Load of a round pad over its recess, and all deviations."""
    figure.set_size_inches(7.2, 3.0)
    left, right = figure.subplots(1, 2)
    radii = np.linspace(5e-3, 45e-3, 81)
    loads = [
        lands_of(CircularPad(0.05, r)).effective_area
        * FLOW
        / lands_of(CircularPad(0.05, r)).conductance(GAP, VISCOSITY)
        for r in radii
    ]
    left.plot(1e3 * radii, 1e-3 * np.array(loads), color=GREY)
    left.plot([28.5], [60.0], "o", color=INK)
    left.set_xlabel("recess radius in mm")
    left.set_ylabel("load in kN at 0.24 L/min")
    rows = run()
    draw_deviations(right, rows)
    right.set_title(f"all {len(rows)} values")


CASE = ValidationCase(
    name="hydrostatic_pads",
    title="Hydrostatic pads: printed exercise and closed forms",
    story=Story(
        what=(
            "A pad floats on oil that is pumped into its recess. Flow and load of round, annular and rectangular "
            "lands have closed forms; the film in two dimensions must give the same numbers, corners included."
        ),
        source=(
            "An exercise with printed answers from a study-help page (a pump that holds 20 MPa, a pad of 0.1 m, "
            "80 cP, 30 µm, 60 kN); its textbook is not named, and the power of ten of the flow, damaged on the "
            "page, "
            "is the only one that gives the answers. Closed forms: radial flow between parallel discs; strips "
            "with "
            "corners, 1 - 2 ln 2/π squares each (conformal map)."
        ),
        assumptions=(
            "Laminar, isoviscous film of uniform thickness; the recess stands at one pressure. The power of the "
            "exercise is recess pressure times flow, not supply pressure times flow."
        ),
        tolerances="The exercise as printed; 1e-5 for rings, 2e-4 for rectangles, whose corners are singular.",
        differences=(
            "Rings agree to round-off, for the elements across them carry the logarithm. Rectangles agree to some "
            "1e-4: the pressure gradient at the corner of a recess grows as r^-1/3."
        ),
    ),
    run=run,
    draw=draw,
    caption="Load of the exercise's pad over the recess radius (filled: the printed answer), and every "
    "deviation in "
    "units of its tolerance.",
)
