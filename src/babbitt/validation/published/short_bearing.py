"""The short bearing of Ocvirk and DuBois: the exact limit of vanishing width."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, LINES, MARKERS, logarithmic_axis
from babbitt.validation.research.arc_film import FULL, solve_arc
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ECCENTRICITIES = (0.2, 0.5, 0.8)
_WIDTH_RATIO = 0.05
_CELLS = (360, 14)  # along the film twice as fine as usual, since the angle is to be seen to 0.001°
_NARROW = {"So": Within(relative=0.01), "β": Within(absolute=0.05), "Q₃*": Within(relative=0.002)}
_LIMIT = {"So": Within(relative=1e-4), "β": Within(absolute=0.002), "Q₃*": Within(relative=2e-5)}


def closed_form(width_ratio: float, eccentricity_ratio: float) -> dict[str, float]:
    """So, attitude angle in degrees and Q3* of the short bearing with a film over 180° (Ocvirk and DuBois).

    ``So = x² ε/(2 (1-ε²)²) sqrt(π² (1-ε²) + 16 ε²)``, ``tan β = π sqrt(1-ε²)/(4 ε)``, ``Q3* = x ε/4``.
    """
    rest = 1.0 - eccentricity_ratio**2
    root = math.sqrt(math.pi**2 * rest + 16.0 * eccentricity_ratio**2)
    return {
        "So": width_ratio**2 * eccentricity_ratio / (2.0 * rest**2) * root,
        "β": math.degrees(math.atan2(math.pi * math.sqrt(rest), 4.0 * eccentricity_ratio)),
        "Q₃*": width_ratio * eccentricity_ratio / 4.0,
    }


@lru_cache
def solved(width_ratio: float, eccentricity_ratio: float) -> dict[str, float]:
    """The same by our solution of the whole Reynolds equation."""
    film = solve_arc(FULL, width_ratio, eccentricity_ratio, cells=_CELLS)
    return {
        "So": film.sommerfeld_number,
        "β": math.degrees(film.attitude_angle),
        "Q₃*": film.side_flow_number,
    }


def in_the_limit(quantity: str, eccentricity_ratio: float) -> float:
    """Our value over the closed one (for the angle: less the closed one) as the width vanishes.

    Both differ by a term in x², which the widths x and x/2 eliminate.
    """
    full, half = (_against(quantity, x, eccentricity_ratio) for x in (_WIDTH_RATIO, _WIDTH_RATIO / 2.0))
    return half + (half - full) / 3.0


def _against(quantity: str, width_ratio: float, eccentricity_ratio: float) -> float:
    ours, exact = solved(width_ratio, eccentricity_ratio), closed_form(width_ratio, eccentricity_ratio)
    return ours[quantity] - exact[quantity] if quantity == "β" else ours[quantity] / exact[quantity] - 1.0


def run() -> tuple[Comparison, ...]:
    """Compare at B/D = 0.05 and in the limit."""
    return (*_narrow_bearing(), *_limit())


def _narrow_bearing() -> Iterator[Comparison]:
    for eccentricity in _ECCENTRICITIES:
        ours, exact = solved(_WIDTH_RATIO, eccentricity), closed_form(_WIDTH_RATIO, eccentricity)
        for quantity, tolerance in _NARROW.items():
            yield Comparison(
                quantity,
                f"ε = {eccentricity:g}, B/D = {_WIDTH_RATIO:g}",
                exact[quantity],
                ours[quantity],
                tolerance,
                "°" if quantity == "β" else "",
                "closed form",
            )


def _limit() -> Iterator[Comparison]:
    for eccentricity in _ECCENTRICITIES:
        exact = closed_form(_WIDTH_RATIO, eccentricity)
        for quantity, tolerance in _LIMIT.items():
            miss = in_the_limit(quantity, eccentricity)
            angle = quantity == "β"
            yield Comparison(
                quantity if angle else f"{quantity} over closed form",
                f"ε = {eccentricity:g}, B/D → 0",
                exact[quantity] if angle else 1.0,
                exact[quantity] + miss if angle else 1.0 + miss,
                tolerance,
                "°" if angle else "",
                "closed form",
            )


def draw(figure: Figure) -> None:
    """Distance from the closed form over width: straight lines of slope two."""
    figure.set_size_inches(7.2, 3.4)
    widths = [0.025 * 2.0 ** (k / 2.0) for k in range(9)]
    panels = figure.subplots(1, 3)
    labels = ("deviation of So in %", "deviation of β in °", "deviation of Q₃* in %")
    for axes, (quantity, tolerance), label in zip(panels, _NARROW.items(), labels, strict=True):
        scale = 1.0 if quantity == "β" else 100.0
        for eccentricity, line, marker in zip(_ECCENTRICITIES, LINES, MARKERS, strict=False):
            misses = [scale * abs(_against(quantity, x, eccentricity)) for x in widths]
            axes.plot(
                widths,
                misses,
                linestyle=line,
                marker=marker,
                color=INK,
                markerfacecolor="none",
                label=f"ε = {eccentricity:g}",
            )
        edge = tolerance.absolute or 100.0 * tolerance.relative
        axes.plot(_WIDTH_RATIO, edge, marker="_", markersize=16.0, color=INK, linestyle="none", label="tolerance")
        anchor = scale * abs(_against(quantity, 0.1, 0.5)) / 0.1**2
        axes.plot(widths, [0.35 * anchor * x**2 for x in widths], color=GREY, linewidth=0.8, label="slope 2")
        logarithmic_axis(axes, (0.025, 0.05, 0.1, 0.2, 0.4))
        axes.set_yscale("log")
        axes.set_xlabel("width ratio B/D")
        axes.set_ylabel(label)
    panels[0].legend(fontsize=7)


CASE = ValidationCase(
    name="short_bearing",
    title="Full bearing: the limit of the short bearing",
    story=Story(
        what=(
            "When a bearing becomes narrow, oil is pressed out sideways long before it can flow back along the "
            "circumference, and the Reynolds equation has a closed solution. Our numerical solution knows nothing "
            "of it and must run into it, with a distance that falls as the square of the width."
        ),
        source=(
            "F. W. Ocvirk, *Short-bearing approximation for full journal bearings*, NACA TN 2808 (1952); G. B. "
            "DuBois and F. W. Ocvirk, NACA Report 1157 (1953). Film over the converging half only."
        ),
        assumptions=(
            "In the limit the film ends exactly at the narrowest gap; the rupture condition of Reynolds "
            "tends to it."
        ),
        tolerances=(
            "At B/D = 0.05, where theory itself is off by what the width still matters: So 1 %, angle 0.05°, flow "
            "0.2 %. Extrapolated to vanishing width from B/D = 0.05 and 0.025: So 0.01 %, angle 0.002°, flow "
            "0.002 %, about the accuracy of the numerical solution."
        ),
        differences=(
            "Nothing beyond the finite width: all deviations lie on lines of slope two in the figure, which is "
            "what the next term of the theory asks for. At ε = 0.8 the loaded region is short, so that the same "
            "width is a larger share of it and theory is off by 0.8 % at B/D = 0.05 already, and by a third at "
            "B/D = 0.4: the reason why the short-bearing theory is not offered for design."
        ),
    ),
    run=run,
    draw=draw,
    caption="Distance of our solution from the short-bearing theory over the width ratio; the thin grey line "
    "has slope two, the bars mark the tolerance at B/D = 0.05.",
)
