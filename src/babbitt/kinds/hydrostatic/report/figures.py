"""Figures of hydrostatic bearings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.result import Result
from babbitt.core.solution import Solution
from babbitt.kinds.hydrostatic.answer import Answer
from babbitt.kinds.hydrostatic.geometry import CircularPad, RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.report.pressure_field import pressure_field
from babbitt.kinds.hydrostatic.restrictors import CheckValve
from babbitt.kinds.hydrostatic.supply import Pump
from babbitt.report.drawing import GREY, INK, PALE, Array, Drawing, Sheet, limit_line, mark, rendered, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Painted = tuple[str, str, "Figure", bool]


def hydrostatic_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """All figures of a solved bearing.

    Parameters
    ----------
    solution : Solution
        Of a hydrostatic bearing or of jacking pockets; an unsolved one has no figures.
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Drawing
    """
    problem, result = solution.problem, solution.result
    if not result.outcome.solved:
        return ()
    with style():
        painted = of_jacking(problem, result) if isinstance(problem, JackingCase) else of_bearing(solution)
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), wide) for name, caption, figure, wide in painted
        )


def of_bearing(solution: Solution) -> Iterator[Painted]:
    """Load curves, pressures, coefficients over frequency, power."""
    case, found, result = solution.state.case, solution.state.found, solution.result
    what = "eccentricity" if case.is_journal else "gap"
    steps = []
    if any(isinstance(one, CheckValve) for one in case.feeding.restrictors):
        steps.append("a check valve closes")
    if isinstance(case.feeding.supply, Pump) and math.isfinite(case.feeding.supply.relief_pressure):
        steps.append("the relief valve opens")
    yield (
        "load-curve",
        f"Load and stiffness over the {what}: film (line) and quick method (dashed)"
        + (
            ", the journal moving from the centre through where it stands"
            if case.is_journal
            else ", the runner being level"
        )
        + ". Filled: the operating point."
        + "".join(f" The stiffness steps where {one}." for one in steps),
        load_curve(case, found),
        True,
    )
    if found.film is not None:
        if case.count > 1:
            yield (
                "recess-pressures",
                "Pressure along the middle of the recesses over the angle; grey: recesses with their numbers.",
                around(case, found),
                False,
            )
        yield "pressure-map", "Pressure over the film; outlined: recesses.", pressure_map(case, found), False
    yield (
        "stiffness-frequency",
        "Stiffness and damping over the frequency of vibration: the oil in recess and line gives way"
        + (" (ink: xx, dashed: yy; grey: xy, dashed: yx)." if case.is_journal else "."),
        frequency_curves(case, found),
        True,
    )
    if result.values["friction_power"] > 0.0:
        yield (
            "power-map",
            "Pumping plus friction power over gap and viscosity at these pressures, restrictors made to suit. "
            "Dashed: friction over pumping power 1 (least power for a free viscosity) and 3 (for a free gap).",
            powers(result),
            False,
        )


def load_curve(case: HydrostaticCase, found: Answer) -> Figure:
    """Load and stiffness over gap or eccentricity, by film and quick method."""
    from babbitt.kinds.hydrostatic.impedance import impedance
    from babbitt.kinds.hydrostatic.sweeps import over_gap

    figure, ((left, right),) = Sheet(166.0, 58.0, 1, 2, across=16.0).panels()
    scale = 1.0 if case.is_journal else 1e6
    for method, line in (("film", "-"), ("quick", (0, (5, 2)))):
        curve = over_gap(case, found, method)
        colour = INK if method == case.method else GREY
        left.plot(scale * curve.at, 1e-3 * curve.load, color=colour, linestyle=line)
        right.plot(scale * curve.at, 1e-6 * curve.stiffness, color=colour, linestyle=line)
    stiffness = impedance(found.response, found.network, case.compressibility, 0.0)[0]
    force = found.response.force
    if case.is_journal:
        size = float(np.hypot(*found.at))
        towards = found.at / size if size > 1e-9 * found.rest_gap else np.array([0.0, -1.0])
        here, load, own = size / found.rest_gap, float(np.hypot(*force)), float(towards @ stiffness @ towards)
        label = "$ε$"
    else:
        here, load, own = 1e6 * (found.rest_gap + float(found.at[0])), float(force[0]), float(stiffness[0, 0])
        label = "$h$ in µm"
    mark(left, here, 1e-3 * load)
    mark(right, here, 1e-6 * own)
    left.set(xlabel=label, ylabel="$F$ in kN")
    right.set(xlabel=label, ylabel="$K$ in MN/m")
    left.set_ylim(bottom=0.0)
    return figure


def around(case: HydrostaticCase, found: Answer) -> Figure:
    """Pressure over the angle through the recesses."""
    assert found.film is not None
    of, pressure = found.film.film.of, found.film.film.pressures()
    figure, ((panel,),) = Sheet(81.0, 56.0, left=12.0, bottom=10.0).panels()
    row = 0
    if isinstance(case.shape, ThrustRing):
        r = case.shape.radii
        mean = 0.5 * (r.recess_inner_radius + r.recess_outer_radius) / r.outer_radius
        row = int(np.abs(of.mesh.nodes - mean).argmin())
    lines = of.recess.shape[0]
    theta, values = of.theta[:lines], pressure[:, row]
    if of.surface.cyclic:
        theta, values = of.theta, np.append(values, values[0])
    degrees = np.degrees(theta)
    panel.plot(degrees, 1e-6 * values, color=INK)
    shape = case.shape
    assert isinstance(shape, RecessedJournal | ThrustRing)
    start = float(degrees[0])
    for k, angle in enumerate(shape.recess_angles):
        half = 0.5 * math.degrees(shape.recess_extent)
        middle = start + (math.degrees(angle) - start) % 360.0
        panel.axvspan(middle - half, middle + half, color="0.9", linewidth=0.0, zorder=0)
        top = 1e-6 * float(found.network.pressures[k])
        panel.annotate(
            f"{k + 1}", (middle, top), xytext=(0, 2), textcoords="offset points", ha="center", fontsize=7
        )
    supply = 1e-6 * found.network.supply_pressure
    limit_line(panel, supply, "$p_s$")
    panel.set(xlabel="$θ$ in °", ylabel="$p$ in MPa", xlim=(degrees[0], degrees[-1]))
    panel.set_xticks(np.arange(90.0 * math.ceil(degrees[0] / 90.0), degrees[-1] + 1.0, 90.0))
    panel.set_ylim(0.0, 1.12 * max(supply, 1e-6 * float(values.max())))
    return figure


def pressure_map(case: HydrostaticCase, found: Answer) -> Figure:
    """Pressure over the unrolled bore, the ring or the pad."""
    x, y, values = pressure_field(case, found)
    figure, ((panel,),) = Sheet(81.0, 62.0, left=12.0, bottom=10.0).panels()
    if case.is_journal:
        x, y = np.degrees(x), 1e3 * y
        panel.set(xlabel="$θ$ in °", ylabel="$z$ in mm")
    else:
        x, y = 1e3 * x, 1e3 * y
        panel.set(xlabel="$x$ in mm", ylabel="$y$ in mm", aspect="equal")
    values = 1e-6 * values
    filled = panel.contourf(x, y, values, 12, cmap="Greys")
    for edge in ("top", "right"):
        panel.spines[edge].set_visible(False)
    bar = figure.colorbar(filled, ax=panel, shrink=0.9)
    bar.set_label("$p$ in MPa")
    bar.outline.set_linewidth(0.4)
    outline(panel, case, x[:, 0])
    return figure


def outline(panel: Axes, case: HydrostaticCase, degrees: Array) -> None:
    """Edges of the recesses, those of a bore over its angles."""
    shape = case.shape
    if isinstance(shape, RecessedJournal):
        start = float(degrees[0])
        side, half = 500.0 * shape.recess_length, 0.5 * math.degrees(shape.recess_extent)
        for angle in shape.recess_angles:
            middle = start + (math.degrees(angle) - start) % 360.0
            panel.plot(
                middle + half * np.array([-1, 1, 1, -1, -1]), side * np.array([-1, -1, 1, 1, -1]), color=INK,
                linewidth=0.7,
            )  # fmt: skip
    elif isinstance(shape, RectangularPad):
        x, y = 500.0 * shape.recess_length, 500.0 * shape.recess_width
        panel.plot(x * np.array([-1, 1, 1, -1, -1]), y * np.array([-1, -1, 1, 1, -1]), color=INK, linewidth=0.7)
    elif isinstance(shape, ThrustRing):
        for angle in shape.recess_angles:
            arc = angle + shape.recess_extent * np.linspace(-0.5, 0.5, 41)
            path = np.concatenate((arc, arc[::-1], arc[:1]))
            inner, outer = 1e3 * shape.radii.recess_inner_radius, 1e3 * shape.radii.recess_outer_radius
            radius = np.concatenate((np.full(41, inner), np.full(41, outer), [inner]))
            panel.plot(radius * np.cos(path), radius * np.sin(path), color=INK, linewidth=0.7)
    else:
        edges = (
            [shape.recess_radius]
            if isinstance(shape, CircularPad)
            else [shape.recess_inner_radius, shape.recess_outer_radius]
        )
        turn = np.linspace(0.0, 2.0 * math.pi, 181)
        for edge in edges:
            panel.plot(1e3 * edge * np.cos(turn), 1e3 * edge * np.sin(turn), color=INK, linewidth=0.7)


def frequency_curves(case: HydrostaticCase, found: Answer) -> Figure:
    """Stiffness and damping over frequency."""
    from babbitt.kinds.hydrostatic.sweeps import over_frequency

    curve = over_frequency(case, found)
    hertz = curve.frequency / (2.0 * math.pi)
    figure, ((left, right),) = Sheet(166.0, 58.0, 1, 2, across=16.0).panels()
    lines: tuple[tuple[tuple[int, int], str, object], ...] = (((0, 0), INK, "-"),)
    if case.is_journal:
        lines = (
            ((0, 0), INK, "-"), ((1, 1), INK, (0, (5, 2))), ((0, 1), GREY, "-"), ((1, 0), GREY, (0, (5, 2))),
        )  # fmt: skip
    for (i, j), colour, line in lines:
        left.plot(hertz, 1e-6 * curve.stiffness[:, i, j], color=colour, linestyle=line)
        right.plot(hertz, 1e-3 * curve.damping[:, i, j], color=colour, linestyle=line)
    for panel in (left, right):
        panel.set(xscale="log", xlabel="frequency in Hz")
        for frequency in case.frequencies:
            panel.axvline(frequency / (2.0 * math.pi), color=PALE, linewidth=0.5, zorder=0)
    left.set(ylabel="$K$ in MN/m")
    right.set(ylabel="$C$ in kN s/m")
    if not case.is_journal or (curve.stiffness > 0.0).all():
        left.set_yscale("log")
    return figure


def powers(result: Result) -> Figure:
    """Total power over gap and viscosity."""
    from babbitt.kinds.hydrostatic.sweeps import power_map

    named = result.values
    pumping, friction = named["pumping_power"], named["friction_power"]
    gap = named["least_power_gap"] * (3.0 * pumping / friction) ** 0.25
    found = power_map(gap, named["effective_viscosity"], pumping, friction)
    figure, ((panel,),) = Sheet(81.0, 62.0, left=12.0, bottom=10.0).panels()
    total = found.pumping + found.friction
    x, y = 1e6 * found.gap, 1e3 * found.viscosity
    levels = total.min() * np.geomspace(1.05, 20.0, 9)
    drawn = panel.contour(x, y, total, levels, colors=INK, linewidths=0.6)
    unit, name, digits = (1e-3, "kW", 2) if total.min() > 200.0 else (1.0, "W", 0)
    panel.clabel(drawn, fmt=lambda value: f"{unit * value:.{digits}f}", fontsize=6)
    panel.set(xscale="log", yscale="log", xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))
    for wanted in (1.0, 3.0):  # P_f/P_p falls with (h/h_0)^-4 (mu/mu_0)^2
        share = np.sqrt(pumping / friction * wanted) * (x / (1e6 * gap)) ** 2
        line = 1e3 * named["effective_viscosity"] * share
        panel.plot(x, line, color=GREY, linewidth=0.9, linestyle=(0, (5, 2)))
        left = wanted > 1.0  # each label on the outer side of the pair of lines
        place = int(np.abs(np.log(line / ((0.93 if left else 0.35) * y[-1]))).argmin())
        panel.annotate(
            f"$P_f/P_p = {wanted:.0f}$", (x[place], line[place]), xytext=(-3 if left else 3, 0),
            textcoords="offset points", ha="right" if left else "left", va="center", fontsize=6, color="0.3",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.2},
        )  # fmt: skip
    mark(panel, 1e6 * gap, 1e3 * named["effective_viscosity"])
    panel.set(xlabel="$h$ in µm", ylabel=f"$η$ in mPa s   (lines: power in {name})")
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter("{x:g}")
    panel.tick_params(which="minor", labelsize=6)
    return figure


def of_jacking(case: JackingCase, result: Result) -> Iterator[Painted]:
    """Pressure and flow over the lift."""
    from babbitt.kinds.hydrostatic.jacking import lift_curve

    points = lift_curve(case)
    figure, ((left, right),) = Sheet(166.0, 58.0, 1, 2, across=16.0).panels()
    gaps = [1e6 * point.gap for point in points]
    left.plot(gaps, [1e-6 * point.pressure for point in points], color=INK)
    right.plot(gaps, [6e4 * point.flow for point in points], color=INK)
    here = 1e6 * result.values["minimum_film_thickness"]
    mark(left, here, 1e-6 * result.values["pocket_pressure"])
    mark(right, here, 6e4 * result.values["total_flow"])
    if case.relief_pressure is not None:
        limit_line(left, 1e-6 * case.relief_pressure, "relief valve")
    limit_line(left, 1e-6 * result.values["breakaway_pressure"], "breakaway without seepage")
    left.set(xlabel="$h_\\mathrm{min}$ in µm", ylabel="$p$ in MPa")
    left.set_ylim(bottom=0.0)
    right.set(xlabel="$h_\\mathrm{min}$ in µm", ylabel="$Q$ in L/min", yscale="log")
    yield "lift", "Pocket pressure and flow over the smallest gap. Filled: the lifted shaft.", figure, True
