"""The closed forms of DIN 31652 against the table they were fitted to: how far off they are."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.kinds.journal.iso7902.characteristics import ClosedFormCurves
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import DEVIATIONS
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import BAND, GREY, INK, LINES, MARKERS, eccentricity_axis
from babbitt.validation.published.butenschoen_1976 import (
    SYMBOLS,
    UNITS,
    Entry,
    computed,
    entries,
    value_of,
    width_label,
)
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TOLERANCES = {
    "sommerfeld_number": Within(relative=0.07),
    "attitude_angle_degrees": Within(absolute=2.5),
    "side_flow": Within(relative=0.032),
}
_BETWEEN = {
    "sommerfeld_number": Within(relative=DEVIATIONS["sommerfeld_number"]),
    "attitude_angle_degrees": Within(absolute=DEVIATIONS["attitude_angle_degrees"]),
    "side_flow": Within(relative=DEVIATIONS["side_flow"]),
}
WIDTHS_BETWEEN = (0.145, 0.29, 0.41, 0.7, 0.84)
"""B/D between those of the table, the last one where So is worst."""
ECCENTRICITIES = (0.1, 0.37, 0.6, 0.9)


def run() -> tuple[Comparison, ...]:
    """Compare the closed forms with the whole table, and with our curves between its widths."""
    return (*_at_the_widths_of_the_table(), *_between_them())


def _between_them() -> Iterator[Comparison]:
    for quantity, tolerance in _BETWEEN.items():
        for ratio in WIDTHS_BETWEEN:
            for eccentricity in ECCENTRICITIES:
                yield Comparison(
                    SYMBOLS[quantity],
                    f"ε = {eccentricity:g}, B/D = {ratio:g}",
                    computed(quantity, ratio, eccentricity),
                    value_of(quantity, ClosedFormCurves(ratio), eccentricity),
                    tolerance,
                    UNITS.get(quantity, ""),
                    "our curves",
                )


def _at_the_widths_of_the_table() -> tuple[Comparison, ...]:
    return tuple(
        Comparison(
            SYMBOLS[entry.quantity],
            entry.place,
            entry.printed,
            _closed_form(entry),
            _TOLERANCES[entry.quantity],
            UNITS.get(entry.quantity, ""),
            "table of pure rotation",
            entry.decimals,
            remark=entry.warning,
        )
        for entry in entries()
    )


def _closed_form(entry: Entry) -> float:
    return value_of(entry.quantity, ClosedFormCurves(entry.width_ratio), entry.eccentricity_ratio)


def draw(figure: Figure) -> None:
    """Deviation of each quantity over eccentricity, with the band of the tolerance."""
    figure.set_size_inches(7.4, 3.6)
    panels = figure.subplots(1, 3)
    table = list(entries())
    for axes, quantity in zip(panels, SYMBOLS, strict=True):
        tolerance = _TOLERANCES[quantity]
        edge = 100.0 * tolerance.relative or tolerance.absolute
        axes.axhspan(-edge, edge, color=BAND)
        axes.axhline(0.0, color=GREY, linewidth=0.8)
        ratios = dict.fromkeys(entry.width_ratio for entry in table)
        for ratio, line, marker in zip(ratios, LINES, MARKERS, strict=False):
            points = [e for e in table if e.quantity == quantity and e.width_ratio == ratio]
            misses = [_closed_form(e) - e.printed for e in points]
            if tolerance.relative:
                misses = [100.0 * miss / e.printed for miss, e in zip(misses, points, strict=True)]
            axes.plot(
                [e.eccentricity_ratio for e in points],
                misses,
                linestyle=line,
                marker=marker,
                markersize=3.0,
                color=INK,
                markerfacecolor="none",
                label=width_label(ratio),
            )
        eccentricity_axis(axes)
    panels[0].set_ylabel("deviation of So in %")
    panels[1].set_ylabel("deviation of β in °")
    panels[2].set_ylabel("deviation of Q₃* in %")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, [f"B/D = {label}" for label in labels], loc="outside upper center", ncols=len(labels))


CASE = ValidationCase(
    name="closed_forms_din31652",
    title="Full bearing: accuracy of the closed forms of DIN 31652",
    story=Story(
        what=(
            "DIN 31652-2 gives polynomials for load, attitude angle and side flow, fitted by Butenschoen to his "
            "own table. Many programs use them, and Babbitt offers them (`characteristics: closed_form`) so that "
            "such a calculation can be repeated. How far off they are is shown here, and is why they are not "
            "the default."
        ),
        source=(
            "Coefficients as in DIN 31652-2 and in the public source of the multibody code MBDyn; the table as on "
            "the page of Butenschoen's table."
        ),
        assumptions="None: both the polynomials and the table are for the full bearing under constant load.",
        tolerances=(
            "These are not tolerances of ours but the accuracy that we state for the closed forms, in the "
            "documentation and in warning W113: at the widths of the table So 7 %, attitude angle 2.5°, side flow "
            "3.2 %; between them So 11 %, 2.5° (for ε from 0.1 on), 4.2 %. The case fails if the statement became "
            "wrong. Between the widths of the table they are held against our curves, which agree with the table "
            "(page of Butenschoen's table)."
        ),
        differences=(
            "The closed forms are worst at large B/D and at both ends of eccentricity, and the side flow is a "
            "straight line in ε where the true one bends. Doubtful entries of the table (named below) are off by "
            "less than a tenth of the accuracy stated here and are judged like the others."
        ),
    ),
    run=run,
    draw=draw,
    caption="Deviation of the closed forms from the table over eccentricity; the grey band is the accuracy "
    "stated for them at the widths of the table.",
)
