"""Our own characteristics of ISO 7902 for 360° and 180°, solved anew by the film engine."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.reynolds.model import Land
from babbitt.reynolds.solution import FilmSolution
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import INK, MARKERS, eccentricity_axis
from babbitt.validation.published.film_bearings import CLEARANCE, at_position, film_of, round_film
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH_RATIOS = (0.25, 0.5, 1.0, 1.5)
_ECCENTRICITIES = (0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98)
_LOAD, _ANGLE = Within(relative=0.001), Within(absolute=0.05)
_HALF = (Land(math.pi, 2.0 * math.pi),)


@lru_cache(maxsize=256)
def film(span: int, width_ratio: float, eccentricity_ratio: float) -> FilmSolution:
    """The engine's film at a depth; on the half bearing with the load on the middle of the arc."""
    if span == 360:
        return at_position(round_film(width_ratio), 0.0, -eccentricity_ratio * CLEARANCE)
    bearing, radius = film_of(width_ratio, _HALF), eccentricity_ratio * CLEARANCE
    angle, before = curves(span, width_ratio).attitude_angle(eccentricity_ratio), 0.5 * math.pi
    last = at_position(bearing, radius * math.sin(before), -radius * math.cos(before))
    for _ in range(20):
        found = at_position(bearing, radius * math.sin(angle), -radius * math.cos(angle))
        aside, aside_before = found.force[0] / found.force[1], last.force[0] / last.force[1]
        if abs(aside) < 1e-9:
            break
        before, angle = angle, angle - float(aside) * (angle - before) / float(aside - aside_before)
        last = found
    return found


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare both spans over width and eccentricity."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    for span in (360, 180):
        for ratio in _WIDTH_RATIOS:
            shape = curves(span, ratio)
            for eccentricity in _ECCENTRICITIES:
                ours = film(span, ratio, eccentricity)
                place = f"{span}°, ε = {eccentricity:g}, B/D = {ratio:g}"
                source = "our tables of the characteristics"
                so, angle = shape.sommerfeld_number(eccentricity), shape.attitude_angle(eccentricity)
                yield Comparison("So", place, so, ours.sommerfeld_number, _LOAD, "", source)
                yield Comparison(
                    "β", place, math.degrees(angle), math.degrees(ours.attitude_angle), _ANGLE, "°", source, 4
                )


def draw(figure: Figure) -> None:
    """Both deviations over eccentricity."""
    figure.set_size_inches(7.2, 3.4)
    left, right = figure.subplots(1, 2)
    for span, face in ((360, "none"), (180, INK)):
        for ratio, marker in zip(_WIDTH_RATIOS, MARKERS, strict=False):
            shape = curves(span, ratio)
            ours = [film(span, ratio, e) for e in _ECCENTRICITIES]
            pairs = list(zip(ours, _ECCENTRICITIES, strict=True))
            loads = [100.0 * (each.sommerfeld_number / shape.sommerfeld_number(e) - 1.0) for each, e in pairs]
            angles = [math.degrees(each.attitude_angle - shape.attitude_angle(e)) for each, e in pairs]
            label = f"{span}°, B/D = {ratio:g}"
            for axes, values in ((left, loads), (right, angles)):
                axes.plot(
                    _ECCENTRICITIES,
                    values,
                    marker=marker,
                    color=INK,
                    markerfacecolor=face,
                    linestyle="none",
                    label=label,
                )
    for axes, label in ((left, "So: engine less tables, in %"), (right, "β: engine less tables, in °")):
        eccentricity_axis(axes)
        axes.set_xlim(0.08, 0.985)
        axes.set_ylabel(label)
    left.set_ylim(-0.0125, 0.0125)
    right.set_ylim(-0.00125, 0.00125)
    left.legend(ncols=2, fontsize=6.5, loc="upper left", handlelength=1.0, columnspacing=1.0)


CASE = ValidationCase(
    name="film_characteristics",
    title="Film engine: the characteristics of the standard, solved anew",
    story=Story(
        what=(
            "The ISO 7902 procedure of Babbitt reads load and attitude from tables that ship with the package. "
            "One solver of ours made them; the film engine, written apart from it with another discretisation, "
            "solves the same films here. Two solvers that agree to a part in ten thousand leave little room for "
            "an error in either."
        ),
        source=(
            "Babbitt's own tables of the full and of the half bearing, read by interpolation. No print is "
            "involved: this page says how far our two answers differ."
        ),
        assumptions=(
            "360°: the film starts at the widest gap. 180°: the film starts at the edge of the arc at ambient "
            "pressure, and the load points to the middle of the arc, which fixes the angle of the line of "
            "centres. Reynolds condition at the rupture; 8 unknowns across half the width, 768 intervals."
        ),
        tolerances="So 0.1 %, attitude angle 0.05°, at every width and eccentricity of the comparison.",
        differences=(
            "So differs by 0.009 % at most and the angle by less than 0.001°: what interpolation and both grids "
            "leave, with room of a factor of ten and fifty."
        ),
    ),
    run=run,
    draw=draw,
    caption="Engine less tables: So in per cent and β in degrees over eccentricity, full bearing (open) and half "
    "bearing (filled). The tolerances, 0.1 % and 0.05°, lie far outside the frames.",
    evidence=Evidence.REGRESSION,
)
