"""The drawing of each figure of a bearing."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.core.solution import Calculation
from babbitt.design.span import TABULATED_SPANS
from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.kinds.journal.iso7902.film import curves_of
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase
from babbitt.kinds.journal.methods import METHODS
from babbitt.kinds.journal.study.design_sweep import sweep_design
from babbitt.report.drawing import (
    GREY,
    INK,
    PALE,
    Array,
    Sheet,
    axis_label,
    in_engineers_unit,
    limit_line,
    mark,
    mathematics,
)
from babbitt.report.verdict import governing
from babbitt.study.sweep import Sweep

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

POINTS = 61
"""Of each sweep; odd, so that the operating point is one of them."""

STANDARD = METHODS["iso7902"]


def speed_and_load(case: DesignCase, result: Result) -> Figure:
    """Friction coefficient and minimum film thickness over speed and over load (Stribeck)."""
    speed, load = abs(case.journal_speed), result.load
    by_speed = speed_sweep(case, result)
    by_load = sweep_design(Calculation(case, STANDARD), "duty.load", _about(load, load / 10.0, 4.0 * load))
    figure, axes = Sheet(166.0, 78.0, 2, 2).panels(sharex="col", sharey="row")
    for column, (swept, name, here) in enumerate(((by_speed, "angular_speed", speed), (by_load, "load", load))):
        quantity = QUANTITIES[name]
        for row, found in enumerate(("friction_coefficient", "minimum_film_thickness")):
            panel = axes[row][column]
            shown = QUANTITIES[found]
            panel.set(xscale="log", yscale="log")
            panel.plot(
                in_engineers_unit(name, np.abs(swept.points)), in_engineers_unit(found, swept[found]), color=INK
            )
            mark(panel, quantity.shown(here), shown.shown(result.values[found]))
            if column == 0:
                panel.set_ylabel(axis_label(shown))
        axes[1][column].set_xlabel(
            f"{mathematics('N')} in {quantity.display.label}" if name == "angular_speed" else axis_label(quantity)
        )
        plain_ticks(axes[1][column].xaxis)
    _film_limit(axes[1][0], result)
    _film_limit(axes[1][1], result, at=0.01)
    for panel in axes[:, 0]:
        plain_ticks(panel.yaxis)
    if "transition_speed" in result.values:
        slow = journal_speed_of(case, result.transition_speed)
        _transition(axes[0][0], axes[1][0], QUANTITIES["transition_speed"].shown(slow))
    return figure


def speed_sweep(case: DesignCase, result: Result) -> Sweep:
    """The design check over the speed of the journal, which keeps its sense: the bearing may turn, too."""
    speed, sense = abs(case.journal_speed), math.copysign(1.0, case.journal_speed)
    transition = result.values.get("transition_speed")
    slow = 0.0 if transition is None else 0.6 * journal_speed_of(case, transition)
    slowest = max(min(slow if slow > 0.0 else speed / 10.0, speed / 4.0), speed / 100.0)
    against = max(-sense * case.bearing_speed, 0.0)  # no film below the speed at which the bearing turns back
    if slowest <= against:
        slowest = against + 0.05 * (speed - against)
    return sweep_design(Calculation(case, STANDARD), "journal_speed", sense * _about(speed, slowest, 2.0 * speed))


def journal_speed_of(case: DesignCase, hydrodynamic_speed: float) -> float:
    """Speed of the journal in rad/s, positive in its sense, at a hydrodynamic speed of journal and bearing."""
    return hydrodynamic_speed - math.copysign(1.0, case.journal_speed) * case.bearing_speed


def _about(centre: float, low: float, high: float) -> Array:
    """Geometric points from `low` to `high`, the centre among them."""
    half = POINTS // 2 + 1
    return np.concatenate([np.geomspace(low, centre, half), np.geomspace(centre, high, half)[1:]])


def _transition(top: Axes, bottom: Axes, rpm: float) -> None:
    for panel in (top, bottom):
        panel.axvline(rpm, color=GREY, linewidth=0.8, linestyle=":")
    low, high = top.get_xlim()
    beyond_middle = rpm > (low * high) ** 0.5  # of a logarithmic axis
    top.annotate(
        f"{mathematics('N_tr')} = {rpm:.0f} {QUANTITIES['transition_speed'].display.label}",
        (rpm, 1.0),
        xycoords=top.get_xaxis_transform(),
        xytext=(-2 if beyond_middle else 2, -1),
        textcoords="offset points",
        ha="right" if beyond_middle else "left",
        va="top",
        fontsize=7,
        color="0.3",
    )


def _film_limit(panel: Axes, result: Result, *, at: float = 0.99) -> None:
    check = governing(result, "minimum_film_thickness")
    if check is not None:
        shown = QUANTITIES["minimum_film_thickness"]
        label = f"{mathematics('h_lim')} = {shown.format(check.limit)} {shown.display.label}"
        limit_line(panel, shown.shown(check.limit), label, at=at)


def load_capacity(case: DesignCase, result: Result) -> Figure:
    """Sommerfeld number over eccentricity for the span of the bearing, other spans beside it."""
    figure, ((panel,),) = Sheet(81.0, 62.0).panels()
    ratio = case.bearing.part_width_ratio
    eccentricity = np.concatenate([np.linspace(0.05, 0.9, 60), 1.0 - np.geomspace(0.1, 0.02, 25)[1:]])
    starts: list[tuple[float, int]] = []
    own = curves_of(case)
    if case.curves is Curves.COMPUTED:
        for span in TABULATED_SPANS:
            if span != case.bearing.span:
                beside = curves(span, ratio).sommerfeld_number(eccentricity)
                panel.plot(eccentricity, beside, color=PALE, linewidth=0.8)
                starts.append((float(beside[0]), span))
    load_number = own.sommerfeld_number(eccentricity)
    panel.plot(eccentricity, load_number, color=INK)
    starts.append((float(load_number[0]), case.bearing.span))
    _label_starts(panel, float(eccentricity[0]), starts)
    mark(panel, result.eccentricity_ratio, result.sommerfeld_number)
    panel.annotate(  # the corner that no curve reaches, as the load number rises with the eccentricity
        f"{case.bearing.span}°: ε = {result.eccentricity_ratio:.3f}, So = {result.sommerfeld_number:.3g}",
        (0.03, 0.97),
        xycoords="axes fraction",
        va="top",
        fontsize=7,
    )
    panel.set(
        yscale="log",
        xlim=(-0.13, 1.0),
        xticks=[0.0, 0.2, 0.4, 0.6, 0.8, 1.0],
        xlabel=axis_label(QUANTITIES["eccentricity_ratio"]),
    )
    panel.set_ylabel(axis_label(QUANTITIES["sommerfeld_number"]))
    plain_ticks(panel.yaxis)
    return figure


def _label_starts(panel: Axes, x: float, starts: list[tuple[float, int]]) -> None:
    """Name curves at their left end; those too close for a name of their own share one."""
    groups: list[list[tuple[float, int]]] = []
    for start in sorted(starts, reverse=True):
        if groups and groups[-1][-1][0] / start[0] < 1.35:
            groups[-1].append(start)
        else:
            groups.append([start])
    for group in groups:
        height = float(np.exp(np.mean([np.log(load_number) for load_number, _ in group])))
        spans = [span for _, span in group]
        text = f"{spans[0]}°" if len(spans) == 1 else f"{max(spans)}–{min(spans)}°"
        panel.annotate(
            text, (x, height), xytext=(-2, 0), textcoords="offset points", ha="right", va="center", fontsize=6.5,
            color="0.3",
        )  # fmt: skip


def clearance(case: DesignCase, result: Result, smallest: float, largest: float) -> Figure:
    """Effective temperature and minimum film thickness from the smallest to the largest clearance."""
    points = np.linspace(smallest, largest, 41)
    swept = sweep_design(Calculation(case, STANDARD), "bearing.relative_clearance", points)
    figure, axes = Sheet(81.0, 62.0, 2, 1).panels(sharex=True)
    here = 1e3 * case.bearing.relative_clearance
    for panel, name in zip(axes[:, 0], ("effective_temperature", "minimum_film_thickness"), strict=True):
        quantity = QUANTITIES[name]
        panel.plot(1e3 * points, in_engineers_unit(name, swept[name]), color=INK)
        mark(panel, here, quantity.shown(result.values[name]))
        panel.set_ylabel(axis_label(quantity))
        panel.margins(y=0.15)
    _film_limit(axes[1][0], result)
    axes[1][0].set_xlabel(f"{mathematics('ψ_20')} in ‰")
    return figure


def spans(case: DesignCase, result: Result) -> Figure:
    """Film thickness, temperature, power and flow of the same bearing with other angular spans."""
    tried = [span for span in TABULATED_SPANS if case.curves is Curves.COMPUTED or span == case.bearing.span]
    swept = sweep_design(Calculation(case, STANDARD), "bearing.span", [float(span) for span in tried])
    known = ("outlet_temperature", "bearing_temperature", "effective_temperature")
    temperature = next(name for name in known if name in result.values)
    names = ("minimum_film_thickness", temperature, "friction_power", "total_flow")
    figure, axes = Sheet(166.0, 42.0, 1, 4, across=15.5).panels()
    places = np.arange(len(tried))
    own = np.array([span == case.bearing.span for span in tried])
    for panel, name in zip(axes[0], names, strict=True):
        quantity = QUANTITIES[name]
        shown = in_engineers_unit(name, swept[name])
        panel.plot(places, shown, color=PALE, linewidth=0.8, zorder=1)
        panel.plot(
            places[~own], shown[~own], "o", markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.7
        )
        panel.plot(places[own], shown[own], "o", color=INK)
        panel.set_xticks(places, [str(span) for span in tried])
        panel.set(xlabel=f"{mathematics('Ω')} in °", ylabel=axis_label(quantity))
        panel.margins(x=0.12, y=0.15)
    _film_limit_if_near(axes[0][0], result)
    return figure


def _film_limit_if_near(panel: Axes, result: Result) -> None:
    """Show the limit only where it does not squeeze the points into a corner."""
    check = governing(result, "minimum_film_thickness")
    low, high = panel.get_ylim()
    if (
        check is not None
        and low - 0.5 * (high - low) < QUANTITIES["minimum_film_thickness"].shown(check.limit) < high
    ):
        _film_limit(panel, result)


def plain_ticks(axis: Axis) -> None:
    """Numbers instead of powers on a logarithmic axis of about a decade or two."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    low, high = axis.get_view_interval()
    decades = np.log10(high / low) if low > 0 else 3.0
    subs = (1.0, 2.0, 5.0) if decades < 2.5 else (1.0,)
    axis.set_major_locator(LogLocator(subs=subs))
    axis.set_major_formatter(FuncFormatter(lambda number, _: f"{number:g}"))
    axis.set_minor_locator(NullLocator())
