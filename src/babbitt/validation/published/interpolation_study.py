"""What error the old way of interpolating Sommerfeld numbers carries, and what ours does."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, logarithmic_axis
from babbitt.validation.research.interpolation_study import (
    WIDTH_RATIOS,
    InterpolationStudy,
    coarse_tables,
    interpolation_study,
)
from babbitt.validation.tolerance import AtLeast, AtMost, SetBy, Within

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_STUDY = "the study, text"
_INDEPENDENT = "independent computation"
_B_OVER_D = 0.604
# Mean and largest round-trip error in %, linear and logarithmic, and the largest ratio X.
_OTHER_COLUMNS = {
    (0.25, 0.5, 1.0): (7.1, 13.2, 3.7, 8.5, 1.27),
    (0.5, 2.0 / 3.0, 1.0): (3.1, 7.5, 1.0, 3.6, 1.21),
}
# The same with B/D 0.25, 0.5, 0.75, 1, and the forward errors in %: least and largest, linear and logarithmic.
_FOUR_COLUMNS = {
    360: (5.0138, 11.6755, 1.9417, 5.9380, 1.2287, -1.7313, 26.1894, -7.8308, 3.7824),
    180: (4.8613, 11.5040, 1.8194, 5.6356, 1.2283, -1.8622, 25.9888, -7.8568, 3.6978),
}


@lru_cache
def study(span: int = 360, columns: tuple[float, ...] = WIDTH_RATIOS) -> InterpolationStudy:
    """The study repeated with our own Sommerfeld numbers."""
    return interpolation_study(span, _B_OVER_D, columns)


def run() -> tuple[Comparison, ...]:
    """Compare with the statements of the study, with an independent repetition, and ours with zero."""
    return (*_statements(), *_four_columns(), *_other_columns(), *_ours())


def _largest(errors: np.typing.NDArray[np.float64]) -> float:
    return 100.0 * float(np.abs(errors).max())


def _mean(errors: np.typing.NDArray[np.float64]) -> float:
    return 100.0 * float(np.abs(errors).mean())


def _statements() -> Iterator[Comparison]:
    full = study()
    linear, logarithmic = full.round_trip_linear, full.round_trip_logarithmic
    place = "full bearing"
    yield Comparison("linear, largest |δ|", place, 8.0, _largest(linear), AtLeast(SetBy.SOURCE), "%", _STUDY, 0)
    yield Comparison("logarithmic, mean |δ|", place, 3.0, _mean(logarithmic), AtMost(SetBy.SOURCE), "%", _STUDY, 0)
    reason = (
        "The study speaks of single points with 5 %; the largest error depends on its table, which is not printed."
    )
    yield Comparison(
        "logarithmic, largest |δ|", place, 5.0, _largest(logarithmic), None, "%", _STUDY, 0, information=reason
    )
    yield Comparison("largest X", place, 1.18, full.largest_ratio, Within(absolute=0.05), "", _STUDY, 2)


def _four_columns() -> Iterator[Comparison]:
    for span, expected in _FOUR_COLUMNS.items():
        ours = study(span)
        place = f"{span}°, B/D 0.25, 0.5, 0.75, 1"
        inner = (ours.eccentricity_ratios > 0.2 - 1e-9) & (ours.eccentricity_ratios < 0.9 + 1e-9)
        forward = (ours.forward_error_linear[inner], ours.forward_error_logarithmic[inner])
        found = (
            *_round_trips(ours),
            *(100.0 * float(extreme) for errors in forward for extreme in (errors.min(), errors.max())),
        )
        names = (
            *_ROUND_TRIP_NAMES,
            "linear, least forward error",
            "linear, largest forward error",
            "logarithmic, least forward error",
            "logarithmic, largest forward error",
        )
        for name, value, our_value in zip(names, expected, found, strict=True):
            ratio = name == "largest X"
            points = 0.01 if "forward" in name else 0.001
            tolerance = Within(absolute=0.0002 if ratio else points)
            yield Comparison(name, place, value, our_value, tolerance, "" if ratio else "%", _INDEPENDENT, 4)


_ROUND_TRIP_NAMES = (
    "linear, mean |δ|",
    "linear, largest |δ|",
    "logarithmic, mean |δ|",
    "logarithmic, largest |δ|",
    "largest X",
)


def _round_trips(ours: InterpolationStudy) -> tuple[float, ...]:
    linear, logarithmic = ours.round_trip_linear, ours.round_trip_logarithmic
    return (_mean(linear), _largest(linear), _mean(logarithmic), _largest(logarithmic), ours.largest_ratio)


def _other_columns() -> Iterator[Comparison]:
    for columns, expected in _OTHER_COLUMNS.items():
        place = f"360°, B/D {', '.join(f'{x:.3g}' for x in columns)}"
        found = _round_trips(study(360, columns))
        for name, value, our_value in zip(_ROUND_TRIP_NAMES, expected, found, strict=True):
            ratio = name == "largest X"
            tolerance = Within(absolute=0.005 if ratio else 0.1)
            decimals = 2 if ratio else 1
            yield Comparison(
                name, place, value, our_value, tolerance, "" if ratio else "%", _INDEPENDENT, decimals
            )


def _ours() -> Iterator[Comparison]:
    for span in (360, 180, 150, 120, 90):
        error = _largest(study(span).round_trip_spline)
        tolerance = Within(absolute=1e-7)
        yield Comparison("Babbitt, largest |δ|", f"{span}°", 0.0, error, tolerance, "%", "identity")


def draw(figure: Figure) -> None:
    """Round-trip error of all three ways, what both old ways make of So, also over B/D, and how to correct it."""
    figure.set_size_inches(7.2, 7.4)
    panels = figure.subplot_mosaic(
        [["trip", "forward"], ["ours", "forward"], ["width", "correction"]], height_ratios=[3, 1, 4]
    )
    _draw_over_width(panels["width"])
    _draw_correction(panels["correction"])
    trip, ours, forward = panels["trip"], panels["ours"], panels["forward"]
    full = study()
    loads = full.sommerfeld_numbers
    trip.plot(loads, 100.0 * np.abs(full.round_trip_linear), color=INK, label="linear")
    trip.plot(loads, 100.0 * np.abs(full.round_trip_logarithmic), "--", color=INK, label="logarithmic")
    trip.set_ylim(0.0, 15.0)
    trip.set_ylabel("|δ| in %")
    trip.set_title("forth and back: δ = So(ε(So))/So - 1")
    trip.legend(loc="upper left", ncols=2)
    ours.plot(loads, 100.0 * np.abs(full.round_trip_spline) * 1e13, ".", color=INK, markersize=3.0)
    ours.set_ylim(0.0, 1.5)
    ours.set_ylabel("|δ| in 10⁻¹³ %")
    ours.set_title("Babbitt: round-off")
    for axes in (trip, ours):
        logarithmic_axis(axes, (0.3, 0.5, 1.0, 1.5))
    ours.set_xlabel("Sommerfeld number So")
    for errors, line, label in (
        (full.forward_error_linear, "-", "linear"),
        (full.forward_error_logarithmic, "--", "logarithmic"),
    ):
        forward.plot(full.eccentricity_ratios, 100.0 * errors, linestyle=line, color=INK, label=label)
    forward.axhline(0.0, color=GREY, linewidth=0.8)
    forward.set_xlabel("eccentricity ratio ε")
    forward.set_ylabel("error of So in %")
    forward.set_title("forward, against the dense solution")
    forward.legend()


def _draw_over_width(axes: Axes) -> None:
    """So over B/D by both old ways and by the dense solution: at a row of the table, and where X is largest."""
    ratios = np.linspace(WIDTH_RATIOS[0], WIDTH_RATIOS[-1], 151)
    linear, logarithmic = coarse_tables()
    for eccentricity in (linear.eccentricity_ratios[3], study().eccentricity_ratio_of_largest_ratio):
        at = np.array([eccentricity])
        old = [float(linear.level(at, x)[0]) for x in ratios]
        older = [float(np.exp(logarithmic.level(at, x))[0]) for x in ratios]
        exact = [curves(360, float(x)).sommerfeld_number(float(eccentricity)) for x in ratios]
        first = eccentricity == linear.eccentricity_ratios[3]
        for values, line, colour, label in (
            (exact, "-", GREY, "dense solution"),
            (old, "-", INK, "linear"),
            (older, "--", INK, "logarithmic"),
        ):
            axes.plot(ratios, values, linestyle=line, color=colour, label=label if first else None)
        axes.annotate(f"ε = {eccentricity:.2g}", (ratios[-1], exact[-1]), (-4.0, 4.0), textcoords="offset points",
                      ha="right", fontsize=8.0)  # fmt: skip
    axes.axvline(_B_OVER_D, color=GREY, linewidth=0.8)
    axes.set_yscale("log")
    axes.set_yticks((0.1, 0.2, 0.5, 1.0, 2.0), ["0.1", "0.2", "0.5", "1", "2"])
    axes.set_yticks([], minor=True)
    axes.set_xlabel("B/D")
    axes.set_ylabel("Sommerfeld number So")
    axes.set_title("So between the columns B/D 0.25, 0.5, 0.75, 1")
    axes.legend(loc="lower right")


def _draw_correction(axes: Axes) -> None:
    """What So by the old ways must be multiplied with, over X, which an engineer can form from both."""
    full = study()
    inner = full.eccentricity_ratios > 0.2 - 1e-9
    for values, line, label in ((full.linear, "-", "linear"), (full.logarithmic, "--", "logarithmic")):
        axes.plot(full.ratio[inner], (full.reference / values)[inner], linestyle=line, color=INK, label=label)
    axes.axhline(1.0, color=GREY, linewidth=0.8)
    axes.set_xlabel("X, linear over logarithmic So")
    axes.set_ylabel("So of the dense solution over the read one")
    axes.set_title("correction over X, ε = 0.2 to 0.95")
    axes.legend(loc="lower left")


CASE = ValidationCase(
    name="interpolation_study",
    title="Interpolating Sommerfeld numbers: what the old way costs",
    story=Story(
        what=(
            "Tables of bearing characteristics have few columns, and a bearing seldom falls on one. A published "
            "study compares linear with logarithmic interpolation of So at B/D = 0.604: it looks up an "
            "eccentricity for a load and then a load for that eccentricity, which should return the load it "
            "started from. δ is by how much it does not. X is linear over logarithmic So."
        ),
        source=(
            "Published gearbox study (Russian journal, 2023, vol. 15, no. 5, p. 825 ff.): linear "
            "interpolation errs by more than 8 %, logarithmic on average by not more than 3 % with single "
            "points of 5 %, X up to 1.18. The values with decimals are an independent repetition by another "
            "program."
        ),
        assumptions=(
            "The table of the study is not printed. Ours is cut from our own solution: ε = 0.1, 0.2, 0.4, "
            "0.6, 0.8, 0.9, 0.95 and B/D = 0.25, 0.5, 0.75, 1; two other choices of columns show how much "
            "depends on it. Forward: a straight line in ε within each column, then one in B/D between "
            "columns, of So or of ln So. Backward: a straight line in So or ln So within each column, then "
            "in B/D. 200 loads from So = 0.25 to 1.8."
        ),
        tolerances=(
            "The statements of the study as bounds; its X within 0.05, since its table is unknown. The "
            "independent repetition: 0.001 points of a per cent, 0.01 of forward errors and 0.0002 in X where it "
            "has four decimals, 0.1 points and 0.005 where it has one. Its forward errors are the extremes from "
            "ε = 0.2 to 0.9. Ours: 1e-7 %."
        ),
        differences=(
            "**Most of δ is no error of the table.** The two old ways are not inverse to each other, "
            "neither linear nor logarithmic: between columns, the mean of two eccentricities is not the "
            "eccentricity of the mean load. δ measures that contradiction. One interpolant, inverted by "
            "finding its root, returns to where it started, however coarse its table.\n\n"
            "**δ also hides the true error.** Against the dense solution, linear interpolation "
            "overestimates the load by up to 26 % (near ε = 0.69, between two rows far apart); logarithmic "
            "interpolation is off by -8 to +4 % from ε = 0.2 to 0.9, and by -9 % below.\n\n"
            "Babbitt interpolates ln So by bicubic splines over ln(ε/(1 - ε)) and ln B/D in a dense table, "
            "and finds ε as the root of that same function: δ is round-off, and the error against fresh "
            "solutions of the Reynolds equation is below 0.1 %."
        ),
    ),
    run=run,
    draw=draw,
    caption="Full bearing, above B/D = 0.604. Left: what is lost by looking up ε for a load and the load for that "
    "ε. Right: error of So itself by both old ways. Below: So between the columns of the table, at one of its "
    "rows and where X is largest; and the factor by which So of both ways is to be corrected, over X.",
)
