"""Lund and Thomsen (1978): position, stiffness and damping of the grooved and of the elliptical bearing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.reynolds.model import JournalFilm, Land, grooved_bore
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, LINES, MARKERS, draw_deviations, logarithmic_axis
from babbitt.validation.published.film_bearings import CLEARANCE, at_rest, coefficients, film_of, load_of
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_GROOVE = math.radians(20.0)
_POSITION = {
    "ε": (Within(absolute=1e-3), Within(absolute=1.5e-3)),
    "φ": (Within(absolute=0.1), Within(absolute=0.1)),
}
"""On the clearance of the lands, for the grooved and the elliptical bearing."""

_COEFFICIENT = Within(relative=0.03, absolute=0.005)
_NAMES = ("Kxx", "Kxy", "Kyx", "Kyy", "Bxx", "Bxy", "Byx", "Byy")
_TABLES = {"two_grooves": "two grooves", "elliptical": "elliptical"}


def two_lobes(preload: float, groove: float) -> tuple[Land, Land]:
    """Lower and upper lobe of clearance `CLEARANCE` between two grooves of the given extent (rad)."""
    half, shift = 0.5 * groove, preload * CLEARANCE
    lower = Land(math.pi + half, 2.0 * math.pi - half, clearance=CLEARANCE, centre=(0.0, shift))
    upper = Land(half, math.pi - half, clearance=CLEARANCE, centre=(0.0, -shift))
    return lower, upper


def bearing(table: str) -> tuple[JournalFilm, float]:
    """The bearing of a table, and its L/D."""
    if table == "two_grooves":
        return film_of(0.5, grooved_bore((0.0, math.pi), _GROOVE)), 0.5
    return film_of(1.0, two_lobes(0.5, _GROOVE), 0.5 * CLEARANCE), 1.0


@lru_cache(maxsize=128)
def computed(table: str, bearing_number: float) -> tuple[float, ...]:
    """Eccentricity ratio, angle in degrees and the eight coefficients, all on the clearance of the lands."""
    film, ratio = bearing(table)
    load = load_of(bearing_number, ratio)
    found = at_rest(film, load)
    stiffness, damping = coefficients(found, load)
    position = (math.hypot(*found.position) / CLEARANCE, math.degrees(found.attitude_angle))
    return (*position, *stiffness.ravel().tolist(), *damping.ravel().tolist())


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare both tables row by row."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    data = reference_data("lund_thomsen_1978")
    apart = {(d["table"], d["bearing_number"], d["quantity"]): d["reason"] for d in data["set_apart"]}
    for table, name in _TABLES.items():
        for number, *printed in data[table]:
            ours = computed(table, number)
            quantities = zip((*_POSITION, *_NAMES), printed, ours, data["decimals"][1:], strict=True)
            for quantity, value, our, decimals in quantities:
                if value is None:
                    continue
                both = _POSITION.get(quantity)
                yield Comparison(
                    quantity,
                    f"{name}, S = {number:g}",
                    value,
                    our,
                    both[table == "elliptical"] if both else _COEFFICIENT,
                    "°" if quantity == "φ" else "",
                    f"table of the bearing with {name}"
                    if table == "two_grooves"
                    else "table of the elliptical bearing",
                    2 if quantity == "ε" and table == "elliptical" else decimals,
                    information=apart.get((table, number, quantity), ""),
                )


def draw(figure: Figure) -> None:
    """Stiffness and damping of the grooved bearing over S, and all deviations."""
    figure.set_size_inches(7.2, 6.0)
    panels = figure.subplots(2, 2).ravel()
    rows = reference_data("lund_thomsen_1978")["two_grooves"]
    numbers = np.geomspace(0.08, 7.0, 60).tolist()
    ours = [computed("two_grooves", number) for number in numbers]
    charts = ((0, 1, "eccentricity ratio ε"), (2, 6, "stiffness K c/W"), (6, 10, "damping B c ω/W"))
    for axes, (first, last, label) in zip(panels, charts, strict=False):
        for column, line, marker in zip(range(first, last), LINES, MARKERS, strict=False):
            axes.plot(numbers, [each[column] for each in ours], linestyle=line, color=GREY)
            axes.plot(
                [row[0] for row in rows],
                [row[column + 1] for row in rows],
                marker=marker,
                color=INK,
                markerfacecolor="none",
                linestyle="none",
                label=("ε", "φ", *_NAMES)[column],
            )
        logarithmic_axis(axes, (0.1, 0.3, 1.0, 3.0))
        axes.set_xlabel("bearing number S")
        axes.set_ylabel(label)
        if last - first > 1:
            axes.legend(ncols=2, fontsize=7, loc="lower left" if first == 2 else "upper center")
    panels[1].set_yscale("symlog", linthresh=1.0)
    panels[2].set_yscale("log")
    draw_deviations(panels[3], run())
    panels[3].set_title("both bearings")


CASE = ValidationCase(
    name="lund_thomsen_1978",
    title="Film engine: coefficients of Lund and Thomsen (1978)",
    story=Story(
        what=(
            "Whether a rotor whirls is decided by eight numbers, the stiffness and damping of its films. The "
            "paper that showed how to compute them consistently, with the rupture free to move, tabulates them "
            "for two common bearings: round with two axial grooves, and elliptical."
        ),
        source=(
            "J. W. Lund and K. K. Thomsen, *A calculation method and data for the dynamic coefficients of "
            "oil-lubricated journal bearings*, in: Topics in Fluid Film Bearing and Rotor Bearing System Design "
            "and Optimization, ASME (1978) 1–28. Rows as reproduced in the public repositories "
            "VictorLier/Tribology (two grooves of 20°, L/D = 0.5) and petrobras/ross (elliptical: L/D = 1, "
            "preload 0.5, two pads of 160°)."
        ),
        assumptions=(
            "Grooves as wide as the bearing at ambient pressure, load halfway between them, Reynolds condition. x "
            "points along the load, y 90° ahead in the sense of rotation. For the elliptical bearing "
            "S, ε, K and B are taken on the clearance of the pads; no other reading of the table fits. "
            "8 unknowns across half the width, 768 intervals on every land."
        ),
        tolerances=(
            "Coefficients 3 % or half a unit of the last printed digit where that is larger; ε 0.001 and for the "
            "elliptical bearing, where it is printed to two decimals only, 0.0015; angle 0.1°."
        ),
        differences=(
            "Three coefficients stay out, each where it passes through zero, so that a relative tolerance asks "
            "for more than the table can hold: Kyx at S = 0.58 and 0.244 and Bxy of the second elliptical row. "
            "None differs by more than 1 % of the largest coefficient of its row. A third elliptical row in "
            "circulation, S = 0.161, stays out altogether: its angle, 83.29°, is out of line with its neighbours "
            "by almost 2°. Everything else agrees; Bxy and Byy of the grooved bearing are printed 1 to 2.3 % "
            "below ours from S = 0.58 down, probably for the print's coarser grid."
        ),
    ),
    run=run,
    draw=draw,
    caption="Position, stiffness and damping of the bearing with two grooves: the engine (grey) through the "
    "printed points (damping: Bxy and Byx coincide), and the deviations of both bearings in units of their "
    "tolerances; crosses are not judged.",
)
