"""Butenschoen's table of the squeezed bearing (1976), solved film by film with the engine."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.reynolds.model import Land
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, LINES, MARKERS, draw_deviations
from babbitt.validation.published.butenschoen_1976 import width_label
from babbitt.validation.published.film_bearings import (
    CLEARANCE,
    DIAMETER,
    VISCOSITY,
    at_position,
    film_of,
)
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH_RATIOS = (1.0, 1.0 / 3.0, 0.125)
_TOLERANCE = Within(relative=0.01)
_RATE = 1e-3  # m/s; the film is linear in it
_CUT = (Land(0.5 * math.pi, 2.5 * math.pi),)
"""One land around the bore, cut opposite to the motion, where the film is ruptured."""


def squeeze_number(width_ratio: float, eccentricity_ratio: float) -> float:
    """So_V = F ψ²/(B D η |dε/dt|), eccentricity positive where the journal moves towards the smaller gap."""
    film = replace(film_of(width_ratio, _CUT), angular_speed=0.0)
    found = at_position(film, 0.0, -eccentricity_ratio * CLEARANCE, 0.0, -_RATE)
    psi = 2.0 * CLEARANCE / DIAMETER
    return found.load * psi**2 / (film.width * DIAMETER * VISCOSITY * _RATE / CLEARANCE)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare the whole table."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    data = reference_data("butenschoen_1976_squeeze")
    warnings = {(d["eccentricity_ratio"], d["width_ratio"]): d["reason"] for d in data["suspect"]}
    for column, ratio in enumerate(_WIDTH_RATIOS, start=1):
        for row in data["rows"]:
            yield Comparison(
                "So_V",
                f"ε = {row[0]:g}, B/D = {width_label(ratio)}",
                row[column],
                squeeze_number(ratio, row[0]),
                _TOLERANCE,
                "",
                "table of pure squeeze",
                _decimals(row[column]),
                suspect=warnings.get((row[0], ratio), ""),
            )


def _decimals(printed: float) -> int:
    """Decimals of the print: five figures, at most four decimals."""
    return min(4, max(0, 4 - math.floor(math.log10(printed))))


def draw(figure: Figure) -> None:
    """The engine's curves through the printed points, and all deviations."""
    figure.set_size_inches(7.2, 3.6)
    left, right = figure.subplots(1, 2)
    data, eccentricities = reference_data("butenschoen_1976_squeeze"), np.linspace(-0.99, 0.99, 67).tolist()
    for column, (ratio, line, marker) in enumerate(zip(_WIDTH_RATIOS, LINES, MARKERS, strict=False), start=1):
        left.plot(eccentricities, [squeeze_number(ratio, e) for e in eccentricities], linestyle=line, color=GREY)
        left.plot(
            [row[0] for row in data["rows"]],
            [row[column] for row in data["rows"]],
            marker=marker,
            color=INK,
            markerfacecolor="none",
            linestyle="none",
            label=width_label(ratio),
        )
    left.set_yscale("log")
    left.set_xlabel("ε, positive towards the smaller gap")
    left.set_ylabel("squeeze number So_V")
    left.legend(title="B/D (print)", title_fontsize=8)
    rows = run()
    draw_deviations(right, rows)
    right.set_title(f"all {len(rows)} values")


CASE = ValidationCase(
    name="film_butenschoen_squeeze",
    title="Film engine: Butenschoen's full bearing in squeeze (1976)",
    story=Story(
        what=(
            "A journal that does not turn but moves straight through the clearance: the film's other source of "
            "force, on which damping, impact and the orbits of engine bearings depend. From the far side of the "
            "bore, where it hardly feels the wall, to a hundredth of the clearance before it, the force grows "
            "ten thousand times."
        ),
        source=(
            "H.-J. Butenschoen, *Das hydrodynamische, zylindrische Gleitlager endlicher Breite unter "
            "instationärer Belastung*, dissertation, Universität Karlsruhe, 1976, pure squeeze; numbers as "
            "reproduced in the public repository octave-user/mboct-mbdyn-pkg, columns B/D = 1, 1/3 and 1/8."
        ),
        assumptions=(
            "An isoviscous film without rotation; pressure and its slope vanish together where the film ends. The "
            "ring is cut opposite to the motion, where there is no film to be cut."
        ),
        tolerances="1 % for every entry of the table but the one that is held to be a misprint.",
        differences=(
            "Most values agree within 0.2 %. The print lies below us by 0.4 % at ε = 0.97 and 0.7 % at ε = 0.99 "
            "with B/D = 1, the trend of its table of rotation: a grid that is too coarse for the thin film. At "
            "B/D = 1/8 the print has two or three figures where the journal is far from the wall, which makes "
            "half a per cent. One entry is a misprint and set aside. The table's column of the side flow is not "
            "compared: the engine counts the oil that the opening half draws in at the rims, the table does not."
        ),
    ),
    run=run,
    draw=draw,
    caption="Force of the squeezed film: the engine (grey) through the printed points, and every deviation in "
    "units of its tolerance. The cross is a suspect print.",
)
