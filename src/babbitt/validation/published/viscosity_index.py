"""Viscosity index: examples of the standard, its table, and the ranges the gearbox study derives."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.properties.lubricants import nu40_from_viscosity_index, nu100_from_viscosity_index, viscosity_index
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import BAND, GREY, INK, logarithmic_axis
from babbitt.validation.tolerance import Tolerance, Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MM2 = 1e-6  # m²/s

_ASTM, _TABLE, _STUDY = "ASTM D2270, example", "ASTM D2270, table 1", "the study, text"
_INDEPENDENT = "independent computation"
_TABLE_TOLERANCE = Within(relative=0.001)

# nu100, L, H in mm²/s: one line of table 1 of ASTM D2270 in each range of the quadratic equations, as held by the
# MIT-licensed Python package `chemicals` 1.5.2
_REFERENCE_OILS = (
    (2.9, 14.63, 11.5),
    (4.1, 26.5, 20.37),
    (4.7, 35.13, 25.63),
    (5.7, 52.64, 35.29),
    (6.7, 71.29, 45.33),
    (7.3, 84.53, 51.78),
    (8.3, 106.9, 63.05),
    (10.5, 160.6, 88.95),
    (13.5, 247.4, 128.4),
    (16.5, 350.3, 172.3),
    (20.0, 493.2, 229.5),
    (25.0, 736.5, 320.9),
    (34.0, 1286.0, 509.6),
    (47.5, 2380.0, 849.2),
    (62.5, 3966.0, 1303.0),
    (70.0, 4905.0, 1558.0),
)


def run() -> tuple[Comparison, ...]:
    """Compare examples, reference oils and the ranges of the study."""
    return (*_examples(), *_reference_oils(), *_ranges_of_the_study())


def _index(nu40: float, nu100: float) -> float:
    return viscosity_index(nu40 * MM2, nu100 * MM2)


def _at_40(index: float, nu100: float) -> float:
    return nu40_from_viscosity_index(index, nu100 * MM2) / MM2


def _examples() -> Iterator[Comparison]:
    half, whole = Within(absolute=0.005), Within(absolute=0.5)
    entries: tuple[tuple[str, str, float, float, Tolerance, str, str, int], ...] = (
        ("VI", "73.30 and 8.86 mm²/s", 92.0, _index(73.30, 8.86), whole, "", _ASTM, 0),
        ("VI", "22.83 and 5.05 mm²/s, method B", 156.0, _index(22.83, 5.05), whole, "", _ASTM, 0),
        ("VI", "73.30 and 8.86 mm²/s", 92.43, _index(73.30, 8.86), half, "", _INDEPENDENT, 2),
        ("VI", "63.5 and 8.0 mm²/s", 90.33, _index(63.5, 8.0), half, "", _INDEPENDENT, 2),
        ("VI", "63.5 and 8.0 mm²/s", 90.347, _index(63.5, 8.0), Within(absolute=0.02), "", _STUDY, 3),
        ("ν40", "VI 90, ν100 = 8 mm²/s", 63.63, _at_40(90.0, 8.0), half, "mm²/s", _INDEPENDENT, 2),
        ("ν40", "VI 90, ν100 = 8 mm²/s", 63.5, _at_40(90.0, 8.0), Within(absolute=0.15), "mm²/s", _STUDY, 1),
        (
            "ν100",
            "VI 90, ν40 = 50 mm²/s",
            6.874,
            nu100_from_viscosity_index(90.0, 50.0 * MM2) / MM2,
            Within(absolute=0.0005),
            "mm²/s",
            _INDEPENDENT,
            3,
        ),
    )
    for quantity, place, value, ours, tolerance, unit, source, decimals in entries:
        yield Comparison(quantity, place, value, ours, tolerance, unit, source, decimals)


def _reference_oils() -> Iterator[Comparison]:
    for nu100, low, high in _REFERENCE_OILS:
        place = f"ν100 = {nu100:g} mm²/s"
        yield Comparison("L", place, low, _at_40(0.0, nu100), _TABLE_TOLERANCE, "mm²/s", _TABLE)
        yield Comparison("H", place, high, _at_40(100.0, nu100), _TABLE_TOLERANCE, "mm²/s", _TABLE)


def _ranges_of_the_study() -> Iterator[Comparison]:
    whole = Within(absolute=1.0)
    yield Comparison("VI", "61.2 and 6 mm²/s", -16.0, _index(61.2, 6.0), whole, "", _STUDY, 0)
    yield Comparison("VI", "61.2 and 8 mm²/s", 96.0, _index(61.2, 8.0), whole, "", _STUDY, 0)
    yield Comparison("VI", "41 and 6 mm²/s", 85.0, _index(41.0, 6.0), whole, "", _STUDY, 0)
    method = "Method A continued above an index of 100, where the standard prescribes method B."
    yield Comparison("VI", "41 and 8 mm²/s", 146.0, _index(41.0, 8.0), whole, "", _STUDY, 0, suspect=method)
    limit = (
        "Lower end of a range that the study forms with the lower limit of ν40 only; the upper limit gives less."
    )
    yield Comparison("VI", "74.8 and 6 mm²/s", -16.0, _index(74.8, 6.0), whole, "", _STUDY, 0, suspect=limit)
    yield Comparison("VI", "50 and 6 mm²/s", 85.0, _index(50.0, 6.0), whole, "", _STUDY, 0, suspect=limit)


def draw(figure: Figure) -> None:
    """The reference oils over nu100 with the table, and how far the quadratics are from it."""
    figure.set_size_inches(7.2, 3.4)
    curves, misses = figure.subplots(1, 2)
    grid = [2.0 * 35.0 ** (k / 200.0) for k in range(201)]
    nu100s = [line[0] for line in _REFERENCE_OILS]
    misses.axhspan(-0.1, 0.1, color=BAND)
    misses.axhline(0.0, color=GREY, linewidth=0.8)
    for index, column, name, line, marker in ((0.0, 1, "L (VI 0)", "-", "o"), (100.0, 2, "H (VI 100)", "--", "s")):
        printed = [each[column] for each in _REFERENCE_OILS]
        curves.plot(grid, [_at_40(index, y) for y in grid], linestyle=line, color=GREY)
        curves.plot(nu100s, printed, marker, color=INK, markerfacecolor="none", label=name)
        off = [100.0 * (_at_40(index, y) / value - 1.0) for y, value in zip(nu100s, printed, strict=True)]
        misses.plot(nu100s, off, marker, color=INK, markerfacecolor="none", label=name)
    for axes in (curves, misses):
        logarithmic_axis(axes, (2, 5, 10, 20, 50))
        axes.set_xlabel("ν100 in mm²/s")
    curves.set_yscale("log")
    curves.set_ylabel("ν40 of the reference oil in mm²/s")
    curves.legend()
    misses.set_ylabel("quadratic less table in %")


CASE = ValidationCase(
    name="viscosity_index",
    title="Viscosity index: ISO 2909 and ASTM D2270",
    story=Story(
        what=(
            "The viscosity index says how much an oil thins with temperature, by comparison with two "
            "reference oils. Oils are often specified by it, so that it decides the viscosity at operating "
            "temperature. Compared are the examples of the standard, its table of reference oils, the way "
            "back from the index to a viscosity, and the ranges a published study derives for turbine oil "
            "TP-46."
        ),
        source=(
            "ASTM D2270 / ISO 2909: examples of methods A and B; table 1 (one line in each range of the quadratic "
            "equations), as held by the MIT-licensed Python package `chemicals`. Published gearbox study (Russian "
            "journal, 2023, vol. 15, no. 5, p. 825 ff.) for TP-46. Independent values with decimals by another "
            "program."
        ),
        assumptions=(
            "Babbitt evaluates the quadratic equations of the standard, not its table, and does not round "
            "the index; the standard reports whole numbers."
        ),
        tolerances=(
            "Whole numbers of the standard 0.5, independent values half of their last digit, reference oils "
            "0.1 % (how far the standard's quadratics lie from its table at most). The index of the study "
            "0.02, since it uses the rounded L = 100.0 and H = 59.6 of the table; its ν40 of 63.5, rounded, "
            "0.15 mm²/s. Its ranges 1: it cuts off decimals."
        ),
        differences=(
            "The study gives TP-46 by GOST 9972-74 (61.2 to 74.8 mm²/s at 40 °C, 6 to 8 at 100 °C) indices "
            "from -16 to 96, and by the manufacturer's standard (41 to 50, 6 to 8) from 85 to 146. Both "
            "ranges use the lower limit of ν40 alone: the true lower ends are -85 and 40. And 146 is method "
            "A continued above 100, where the standard prescribes method B, which gives 172. These three "
            "are shown and not judged.\n\n"
            "The example of method B works with the rounded H = 28.97 of the table and finds 156.37; the "
            "quadratic gives H = 28.979 and 156.46. Both are reported as 156."
        ),
    ),
    run=run,
    draw=draw,
    caption="Left: viscosity at 40 °C of the two reference oils, our curves (grey) through the table of the "
    "standard. Right: deviation, with the tolerance as band.",
)
