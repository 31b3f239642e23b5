"""Figures of the films of one dimension: temperature and pressure along the film, heat, the groove beside none."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase, SegmentFilm
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.report import around_bore
from babbitt.report.drawing import (
    GREY,
    INK,
    PALE,
    Array,
    Drawing,
    Sheet,
    axis_label,
    in_engineers_unit,
    mark,
    rendered,
    spread_levels,
    style,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

OneDimension = LongFilmCase | SegmentCase

TEMPERATURE, PRESSURE = QUANTITIES["film_temperature"], QUANTITIES["specific_load"]
"""In whose units temperatures and specific loads are drawn."""

DASHED, DOTTED = (0, (6, 1.5)), (0, (1.5, 1.5))
BAND = "0.88"
"""Of the groove."""

SHOWN_ECCENTRICITIES = (0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.84, 0.88, 0.91, 0.94, 0.96, 0.98)


def figures_along_the_film(case: OneDimension, result: Result, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Every figure of a solved film of one dimension.

    Parameters
    ----------
    case : LongFilmCase or SegmentCase
    result : Result
        Its answer; an unsolved one has no figures.
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Drawing
    """
    if not result.outcome.solved:
        return ()
    with style():
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), wide)
            for name, caption, figure, wide in _painted(case, result)
        )


def _painted(case: OneDimension, result: Result) -> Iterator[tuple[str, str, Figure, bool]]:
    if isinstance(case, LongFilmCase):
        yield (
            "along-the-film",
            "Temperatures (above), pressure and film thickness (below, broken line) around the film, angles from "
            "the widest gap in the direction of rotation. Dotted line: the film breaks; cross: hottest oil.",
            _along(case, result),
            True,
        )
        yield (
            "heat-split",
            "Where the friction heat goes.",
            _heat_split(result),
            False,
        )
        return
    yield (
        "along-the-film",
        "Temperatures (above), pressure and film thickness (below, broken line) around the film, from the widest "
        "gap in the direction of rotation. Each segment has one mean temperature (broken line), by which its "
        "oil is as viscous; points: the oil that enters and leaves it; shaded: the groove; dotted line: the film "
        "breaks.",
        _along(case, result),
        True,
    )
    if not case.profile:
        yield (
            "temperature-around-bore",
            "Temperature of the film around the bore, from the load line in the direction of rotation, with a "
            f"through groove, with a blind one and without: {around_bore.common(case)}. Shaded: the groove.",
            around_bore.drawn(case, result),
            True,
        )
    if case.groove is not None and not case.profile and not case.compliance:
        yield (
            "groove-beside-none",
            "Specific load over eccentricity, and the temperature of the oil that leaves over specific load: with "
            "the groove, without it, and cut in two at the same angle. Filled: the operating point.",
            _ungrooved_figure(case, result),
            True,
        )


def _row(result: Result, name: str) -> Array:
    return np.asarray(result.arrays[name][0])


def _along(case: OneDimension, result: Result) -> Figure:
    figure, axes = Sheet(166.0, 92.0, 2, 1, left=13.0, between=5.0).panels(sharex=True)
    figure.subplots_adjust(right=1.0 - 14.0 / 166.0)
    warm, bottom = axes[0][0], axes[1][0]
    angles = np.degrees(_row(result, "film_angle"))
    first = float(angles[0]) if isinstance(case, LongFilmCase) else 0.0  # a long film starts where oil enters
    if isinstance(case, LongFilmCase):
        _temperatures_of_long_film(warm, result, angles)
    else:
        film = in_engineers_unit("film_temperature", _row(result, "film_temperature"))
        ended = math.degrees(result.rupture_angle)
        warm.plot(angles[angles <= ended], film[angles <= ended], color=INK)
        _temperatures_of_segments(warm, case, result)
    warm.set_ylabel(axis_label(QUANTITIES["film_temperature"]))
    bottom.plot(angles, in_engineers_unit("film_pressure", _row(result, "film_pressure")), color=INK)
    bottom.set_ylabel(axis_label(QUANTITIES["film_pressure"]))
    bottom.set_ylim(bottom=0.0)
    bottom.set_xlabel("$θ$ in °")
    thick = bottom.twinx()
    thick.spines["right"].set_visible(True)
    thick.plot(
        angles, in_engineers_unit("film_thickness", _row(result, "film_thickness")), color=GREY, linestyle=DASHED
    )
    thick.set_ylabel(axis_label(QUANTITIES["film_thickness"]), color="0.3")
    thick.set_ylim(bottom=0.0)
    for panel in (warm, bottom):
        panel.axvline(math.degrees(result.rupture_angle), color=GREY, linewidth=0.8, linestyle=DOTTED)
        if isinstance(case, SegmentCase) and case.groove is not None:
            panel.axvspan(*_edges(case, result), color=BAND, zorder=0)
        panel.set_xlim(first, first + 360.0)
        panel.set_xticks(range(30 * math.ceil(first / 30.0), round(first) + 361, 30))
    return figure


def _temperatures_of_long_film(panel: Axes, result: Result, angles: Array) -> None:
    film = in_engineers_unit("film_temperature", _row(result, "film_temperature"))
    panel.plot(angles, film, color=INK)
    hottest = int(film.argmax())
    panel.plot([angles[hottest]], [film[hottest]], "x", color=INK, markersize=5)
    ends = [(float(film[-1]), "film")]
    if "journal_temperature" in result.values:
        journal = TEMPERATURE.shown(result.journal_temperature)
        panel.axhline(journal, color=GREY, linestyle=DASHED)
        ends.append((journal, "journal"))
    if "bush_temperature" in result.arrays:
        bush = in_engineers_unit("bush_temperature", _row(result, "bush_temperature"))
        middles = 0.5 * (angles[1:] + angles[:-1])
        panel.plot(middles, bush, color=GREY)
        ends.append((float(bush[-1]), "bush"))
    _named(panel, float(angles[-1]), ends)


def _named(panel: Axes, edge: float, ends: list[tuple[float, str]]) -> None:
    """Names of curves at the right edge, so far apart that they can be read."""
    low, high = panel.get_ylim()
    ends = sorted(ends)
    levels = spread_levels([value for value, _ in ends], 0.09 * (high - low))
    for (_, name), level in zip(ends, levels, strict=True):
        panel.annotate(
            name, (edge, level), xytext=(3, 0), textcoords="offset points", fontsize=7, va="center",
            annotation_clip=False,
        )  # fmt: skip


def _temperatures_of_segments(panel: Axes, case: SegmentCase, result: Result) -> None:
    start, end = math.degrees(case.start), math.degrees(result.rupture_angle)
    if case.groove is None:
        spans = [(start, end, result.supply_temperature, result.effective_temperature, result.outlet_temperature)]
    else:
        before, behind = _edges(case, result)
        spans = [(start, before, *_of_segment(result, 1)), (behind, max(end, behind), *_of_segment(result, 2))]
    for left, right, *kelvins in spans:
        inlet, mean, outlet = map(TEMPERATURE.shown, kelvins)
        panel.plot([left, right], [inlet, outlet], "o", color=INK, markersize=3)
        panel.plot([left, right], [mean] * 2, color=GREY, linestyle=DASHED)
        panel.annotate(
            "mean", (0.5 * (left + right), mean), xytext=(0, 2), textcoords="offset points",
            fontsize=7, ha="center", va="bottom",
        )  # fmt: skip
        into_groove = right < spans[-1][1]  # beside the band, clear of the curve behind it
        panel.annotate(
            f"leaves at {outlet:.0f} {TEMPERATURE.display.label}", (right, outlet),
            xytext=(-6, 4) if into_groove else (4, 0), textcoords="offset points", fontsize=7,
            ha="right" if into_groove else "left", va="bottom" if into_groove else "center",
        )  # fmt: skip
    low, high = panel.get_ylim()
    panel.set_ylim(low, high + 0.12 * (high - low))


def _edges(case: SegmentCase, result: Result) -> Iterator[float]:
    """Angles of the edges of the groove from the widest gap, where it came to lie, degrees."""
    return map(math.degrees, case.film.with_groove_at(result.groove_angle_from_gap).groove_edges())


def _of_segment(result: Result, place: int) -> tuple[float, float, float]:
    """Temperature at the inlet of a segment, its mean, and at its outlet, K."""
    at = result.values
    return (
        at[f"segment_{place}_inlet_temperature"],
        at[f"segment_{place}_mean_temperature"],
        at[f"segment_{place}_outlet_temperature"],
    )


def _heat_split(result: Result) -> Figure:
    figure, ((panel,),) = Sheet(81.0, 36.0, left=24.0).panels()
    parts = [
        ("oil", result.heat_to_oil),
        ("housing", result.heat_to_surroundings),
        ("shaft", result.heat_to_shaft),
    ]
    shades = (INK, GREY, PALE)
    for place, ((_, heat), shade) in enumerate(zip(parts, shades, strict=True)):
        panel.barh(place, heat, color=shade, height=0.62)
        percent = f"{heat / result.friction_heat:.0%}"
        panel.annotate(
            percent, (max(heat, 0.0), place), xytext=(3, 0), textcoords="offset points", fontsize=7, va="center"
        )
    panel.set_yticks(range(3), [name for name, _ in parts])
    panel.set_ylim(2.6, -0.6)
    highest = max(heat for _, heat in parts)
    panel.set_xlim(min(0.0, *(heat for _, heat in parts)), 1.2 * highest)
    panel.axvline(0.0, color=INK, linewidth=0.5)
    panel.set_xlabel("heat in W")
    return figure


def _ungrooved_figure(case: SegmentCase, result: Result) -> Figure:
    figure, axes = Sheet(166.0, 56.0, 1, 2, across=16.0).panels()
    left, right = axes[0]
    film = case.film
    lines = (
        (film, "with groove", INK, "-"),
        (film.without_groove(), "without", GREY, "-"),
        (film.cut(), "cut in two", GREY, DASHED),
    )
    for one, name, colour, line in lines:
        eccentricities, pressure, outlet = _swept(one)
        left.plot(eccentricities, pressure, color=colour, linestyle=line, label=name)
        right.plot(pressure, outlet, color=colour, linestyle=line)
    pressure_here, outlet_here = PRESSURE.shown(result.specific_load), TEMPERATURE.shown(result.outlet_temperature)
    mark(left, result.eccentricity_ratio, pressure_here)
    mark(right, pressure_here, outlet_here)
    left.legend(frameon=False, fontsize=7, loc="upper left")
    left.set(xlabel=axis_label(QUANTITIES["eccentricity_ratio"]), ylabel=axis_label(PRESSURE))
    right.set(xlabel=axis_label(PRESSURE), ylabel=axis_label(QUANTITIES["outlet_temperature"]))
    left.set_ylim(bottom=0.0)
    right.set_xlim(left=0.0)
    return figure


def _swept(film: SegmentFilm) -> tuple[Array, Array, Array]:
    """Eccentricity, specific load and outlet temperature in engineers' units, as far as the film goes."""
    from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity

    found, state = [], None
    for eccentricity in SHOWN_ECCENTRICITIES:
        try:
            state = film_at_eccentricity(film, eccentricity, state)
        except NoFilmError:
            break
        pressure, outlet = PRESSURE.shown(state.specific_load), TEMPERATURE.shown(state.outlet_temperature)
        found.append((eccentricity, pressure, outlet))
    columns = np.array(found).T
    return columns[0], columns[1], columns[2]
