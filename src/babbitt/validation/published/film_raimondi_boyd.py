"""Raimondi and Boyd's full bearing (1958), solved film by film with the engine."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.kinds.journal.iso7902.characteristics.friction import film_around
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.published.film_bearings import (
    CLEARANCE,
    DIAMETER,
    SPEED,
    VISCOSITY,
    at_position,
    round_film,
)
from babbitt.validation.published.raimondi_boyd_1958 import COARSE_GRID, COLUMNS, draw_charts
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDE = (8.0, 16.0)
_TOLERANCES = {
    "S": Within(relative=0.015),
    "φ": Within(absolute=0.6),
    "f/ψ": Within(relative=0.01),
    "Q": Within(relative=0.005),
    "Qs/Q": Within(absolute=0.005),
    "p/p_max": Within(relative=0.025),
}
_WIDE_FLOW = (
    "The flow follows from the gap at the rupture, Q/(R c N L) = π h/c; quadrature of the one-dimensional film "
    "gives our value within 0.1 %."
)
_WIDE_FLOW_FILMS = (0.6, 0.2, 0.1)


@lru_cache(maxsize=256)
def characteristics(width_ratio: float, eccentricity_ratio: float) -> dict[str, float]:
    """S, attitude angle in degrees, friction variable, Q/(R c N L), Qs/Q and p/p_max."""
    force, flow, side, peak = _per_width(width_ratio, eccentricity_ratio)
    load, attitude = math.hypot(*force), math.atan2(force[0], force[1])
    turns = SPEED / (2.0 * math.pi)
    psi = 2.0 * CLEARANCE / DIAMETER
    so = load * psi**2 / (DIAMETER * VISCOSITY * SPEED)
    return {
        "S": 1.0 / (2.0 * math.pi * so),
        "φ": math.degrees(attitude),
        "f/ψ": film_around(so, eccentricity_ratio, attitude),
        "Q": flow / (0.5 * DIAMETER * CLEARANCE * turns),
        "Qs/Q": side / flow,
        "p/p_max": load / DIAMETER / peak,
    }


def _per_width(width_ratio: float, eccentricity_ratio: float) -> tuple[tuple[float, float], float, float, float]:
    """Force, inflow and side flow per width, and the largest pressure, of a journal below the bore's middle.

    What the rims cost is the same for every bearing wide enough that they do not feel each other; two of them give
    the film far from any rim.
    """
    if not math.isinf(width_ratio):
        film = at_position(round_film(width_ratio), 0.0, -eccentricity_ratio * CLEARANCE)
        width = film.film.width
        force = (float(film.force[0]) / width, float(film.force[1]) / width)
        return (
            force,
            float(film.inflow.sum()) / width,
            float(film.side_flow.sum()) / width,
            film.maximum_pressure,
        )
    (narrow, flow, _, _), (wide, wide_flow, _, peak) = (_per_width(x, eccentricity_ratio) for x in _WIDE)
    share = _WIDE[1] / (_WIDE[1] - _WIDE[0])
    force = (narrow[0] + share * (wide[0] - narrow[0]), narrow[1] + share * (wide[1] - narrow[1]))
    return force, flow + share * (wide_flow - flow), 0.0, peak


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare all three tables."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    data = reference_data("raimondi_boyd_1958")
    coarse = data["suspect"][0]["reason"]
    for name, ratio in COLUMNS.items():
        width = "∞" if math.isinf(ratio) else f"{ratio:g}"
        for film, *printed in data[name]:
            ours = characteristics(ratio, 1.0 - film)
            for quantity, value in zip(_TOLERANCES, printed, strict=True):
                if value:
                    yield Comparison(
                        quantity,
                        f"h₀/c = {film:g}, L/D = {width}",
                        value,
                        ours[quantity],
                        _TOLERANCES[quantity],
                        "°" if quantity == "φ" else "",
                        f"table, L/D = {width}",
                        len(f"{value:.6f}".rstrip("0").partition(".")[2]),
                        suspect=_warning(quantity, film, ratio, coarse),
                    )


def _warning(quantity: str, film: float, ratio: float, coarse: str) -> str:
    if quantity == "Q" and math.isinf(ratio) and film in _WIDE_FLOW_FILMS:
        return _WIDE_FLOW
    return coarse if (film, ratio, quantity) in COARSE_GRID else ""


def draw(figure: Figure) -> None:
    """Three charts of the paper with the engine's curves, and all deviations."""
    charts = (("S", 1, "bearing number S"), ("φ", 2, "attitude angle φ in °"), ("Q", 4, "flow Q/(R c N L)"))
    draw_charts(figure, charts, characteristics, run(), "L/D (print)")


CASE = ValidationCase(
    name="film_raimondi_boyd",
    title="Film engine: the tables of Raimondi and Boyd (1958)",
    story=Story(
        what=(
            "The tables behind the charts of American textbooks, solved anew by the film engine: bearing number, "
            "attitude angle, friction, flow in all and by the sides, and largest pressure over the smallest film."
        ),
        source=(
            "A. A. Raimondi and J. Boyd, *A solution for the finite journal bearing and its application to "
            "analysis and design* I–III, ASLE Transactions 1 (1958) 159–209, full bearing with the Reynolds "
            "condition; numbers as reproduced in the public Python package MecaPy."
        ),
        assumptions=(
            "S = η N (R/c)²/p with N in revolutions per second. The film starts at the widest gap; Q is what "
            "enters there. The friction variable is that of a film all around the journal, π/(So √(1 - ε²)) + "
            "(ε/2) sin φ, with So and φ of the engine. The infinitely wide bearing is extrapolated from L/D = 8 "
            "and 16."
        ),
        tolerances=(
            "S 1.5 %, angle 0.6°, friction 1 %, flow 0.5 %, side share 0.005, p/p_max 2.5 %: the tables were "
            "computed in 1958 on grids of that accuracy, as the scatter of single entries shows."
        ),
        differences=(
            "S at h₀/c = 0.6 and L/D = 1 is printed 0.264 where the engine, our other solver and Butenschoen "
            "find 0.260; its neighbours agree to 0.1 %. Four entries at h₀/c = 0.03 are set aside, for the grid "
            "of the authors does not resolve the film there. Three flows of the infinitely wide bearing are set "
            "aside as well: the flow follows from the gap at the rupture, Q/(R c N L) = π h/c, and quadrature of "
            "the one-dimensional film gives the engine's values."
        ),
    ),
    run=run,
    draw=draw,
    caption="Bearing number, attitude angle and flow: the engine (grey) through the printed points, and every "
    "deviation in units of its tolerance. Crosses are suspect prints.",
)
