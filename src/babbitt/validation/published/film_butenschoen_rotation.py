"""Butenschoen's table of the full bearing (1976), solved film by film with the engine."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.published.butenschoen_1976 import compared, draw_table, entries
from babbitt.validation.published.film_bearings import CLEARANCE, at_position, round_film, side_flow_ratio
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TOLERANCES = {
    "sommerfeld_number": Within(relative=0.004, absolute=0.5e-4),
    "attitude_angle_degrees": Within(absolute=0.1),
    "side_flow": Within(relative=0.006),
}


def computed(quantity: str, width_ratio: float, eccentricity_ratio: float) -> float:
    """The engine's value of a printed quantity, in the unit of the table."""
    film = at_position(round_film(width_ratio), 0.0, -eccentricity_ratio * CLEARANCE)
    match quantity:
        case "sommerfeld_number":
            return film.sommerfeld_number
        case "attitude_angle_degrees":
            return math.degrees(film.attitude_angle)
        case _:
            return 2.0 * width_ratio * side_flow_ratio(film)  # over R² c ω instead of R c ω L


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare all three quantities over the whole table."""
    return tuple(compared(entry, computed, _TOLERANCES[entry.quantity]) for entry in entries())


def draw(figure: Figure) -> None:
    """The engine's curves through the printed points, and all deviations."""
    draw_table(figure, computed, 60, run())


CASE = ValidationCase(
    name="film_butenschoen_rotation",
    title="Film engine: Butenschoen's full bearing in rotation (1976)",
    story=Story(
        what=(
            "The film engine against the table behind the German standards: load, attitude and side flow of the "
            "round bearing. Our characteristics, which another solver computed, stand beside the same table on "
            "a page of their own; the engine shares no line of code with that solver."
        ),
        source=(
            "H.-J. Butenschoen, *Das hydrodynamische, zylindrische Gleitlager endlicher Breite unter "
            "instationärer Belastung*, dissertation, Universität Karlsruhe, 1976, pure rotation; numbers as "
            "reproduced in the public repository octave-user/mboct-mbdyn-pkg."
        ),
        assumptions=(
            "An isoviscous film that starts at the widest gap with zero pressure (`FilmStart.WIDEST_GAP`) and "
            "ends where pressure and its slope vanish together (`Cavitation.REYNOLDS`). 8 unknowns across half "
            "the width, 768 intervals around."
        ),
        tolerances=(
            "So 0.4 % or half a unit of the last printed digit where that is coarser, attitude angle 0.1°, side "
            "flow 0.6 %."
        ),
        differences=(
            "The print lies below us towards large eccentricity and wide bearings, in the steady way of a grid "
            "that is too coarse: at B/D = 1 by 0.4 % at ε = 0.98 and 0.55 % at 0.99. Those two entries are held "
            "to be the table's and not judged; doubling the intervals moves the engine by 0.005 % there. The "
            "angle nowhere differs by more than 0.03°. Three flows stick out among their neighbours by half a "
            "per cent; they are judged all the same."
        ),
    ),
    run=run,
    draw=draw,
    caption="Load, attitude and side flow of the full bearing: the engine (grey) through the printed points, and "
    "every deviation in units of its tolerance. Crosses are suspect prints.",
)
