"""Figures of a footstep: its steady states over the clearance and over the face gap."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.states import Method, NoSteadyStateError, StateName, SteadyState, steady_states
from babbitt.kinds.footstep.study.sweep import FootstepSweep, sweep_heel
from babbitt.report.drawing import (
    GREY,
    INK,
    Array,
    Drawing,
    Sheet,
    axis_label,
    in_engineers_unit,
    rendered,
    spread_levels,
    style,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

CLEARANCE, GAP = QUANTITIES["heel_clearance"], QUANTITIES["face_gap"]
POINTS = 121
UNSTABLE = (0, (3.5, 1.8))
DOTTED = (0, (1.0, 1.6))
End = tuple[float, float, str, str]
"""Of a curve: its last value, where that is, its name and colour."""
WORDS = {
    StateName.SMOOTH: "smooth",
    StateName.HOT: "hot",
    StateName.COLD: "cold",
    StateName.MIDDLE: "middle",
    StateName.ONLY: "grooved",
    StateName.FOLD: "fold",
    StateName.DRAINING: "draining",
}


OVER_CLEARANCE = (
    "rim_pressure", "maximum_temperature", "rim_temperature", "heel_leakage", "load", "friction_power",
)  # fmt: skip
OVER_GAP = ("rim_temperature", "heel_leakage", "load", "friction_power")
"""Quantities of the panels; temperature of the mixed oil and leakage are curves of the study's Figs. 2 and 3."""


def heel_figures(case: FootstepProblem, result: Result, image_format: str = "svg") -> tuple[Drawing, ...]:
    """The figures of a footstep; they stand with one of its results, the first of the grooved heel if it has one.

    Parameters
    ----------
    case : FootstepProblem
    result : Result
        One of its answers; those of a heel without steady state show where there is one.
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Drawing
    """
    if not _shows_figures(case, result):
        return ()
    with style():
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), wide=True)
            for name, caption, figure in _painted(case)
        )


def _shows_figures(case: FootstepProblem, result: Result) -> bool:
    if not case.is_grooved:
        return case.other is None
    return (
        result.settings.get("state", "") in ("", "hot", "grooved", "fold", "draining")
        and ". " not in result.name[-14:]
    )


def _painted(case: FootstepProblem) -> Iterator[tuple[str, str, Figure]]:
    marked = case.is_grooved and case.method is Method.SUPERPOSITION
    marks = " Dotted: critical clearance (Q₂ = 0) and the fold." if marked else ""
    smooth = "; grey: smooth heel" if case.other is not None or not case.is_grooved else ""
    yield (
        "steady-states",
        "Steady states over the clearance at the face gap of the case: pressure at the rim, hottest oil, mixed "
        "oil at the rim, leakage, load and friction power, those of Figs. 2 and 3 of the study among them. Full "
        f"lines: stable; broken: not stable{smooth}. Filled: the case.{marks}",
        _over_clearance(case),
    )
    yield (
        "load-over-gap",
        "Mixed oil at the rim, leakage, load and friction power over the face gap at the clearance of the case, "
        f"those of Figs. 2 and 3 of the study. Full lines: stable; broken: not stable{smooth}. A load that rises "
        "with the gap is a negative stiffness.",
        _over_gap(case),
    )
    if case.map_points > 1 and case.is_grooved:
        yield (
            "state-map",
            f"Load in {QUANTITIES['load'].display.label} of the grooved heel over clearance and face gap: the "
            "stable state, the hottest where there are several. Hatched: no steady state. Filled: the case.",
            _map(case),
        )


def _map(case: FootstepProblem) -> Figure:
    """Contours of the load over clearance and face gap, with the region without a steady state."""
    figure, ((panel,),) = Sheet(166.0, 92.0, left=14.0).panels()
    gaps = np.linspace(*case.gap_range, case.map_points)
    clearances = np.linspace(*case.clearance_range, case.map_points)
    sweep = sweep_heel(case.footstep, gaps.tolist(), clearances.tolist(), case.method, _watch)
    loads = np.array([[_stable_load(states) for states in row] for row in sweep.states])
    x, y = in_engineers_unit("heel_clearance", clearances), in_engineers_unit("face_gap", gaps)
    shown = in_engineers_unit("load", loads)
    lines = panel.contour(x, y, np.ma.masked_invalid(shown), 12, colors=INK, linewidths=0.8)
    panel.clabel(lines, fontsize=7, fmt="%.2f")
    if (sweep.counts == 0).any():
        panel.contourf(x, y, (sweep.counts == 0).astype(float), [0.5, 1.5], colors="none", hatches=["////"])
    panel.plot(
        [CLEARANCE.shown(case.footstep.clearance)], [GAP.shown(case.footstep.face_gap)], "o", color=INK, zorder=5
    )
    panel.set(xlabel=axis_label(CLEARANCE), ylabel=axis_label(GAP))
    return figure


def _stable_load(states: tuple[SteadyState, ...]) -> float:
    return next((state.load for state in states if state.stable), float("nan"))


def _sweeps(case: FootstepProblem, gaps: Array, clearances: Array) -> list[FootstepSweep]:
    """Of the smooth heel, then of the grooved one if there is one."""
    wanted: list[Footstep] = [case.smooth] if case.other is not None or not case.is_grooved else []
    if case.is_grooved:
        wanted.append(case.footstep)
    return [sweep_heel(step, gaps.tolist(), clearances.tolist(), case.method, _watch) for step in wanted]


def _watch(places: Any) -> Any:
    from babbitt.report.progress import shown

    return shown("steady states of the footstep")(places)


def _over_clearance(case: FootstepProblem) -> Figure:
    figure, axes = Sheet(166.0, 148.0, 3, 2, left=14.0, across=22.0, between=6.0).panels(sharex=True)
    figure.subplots_adjust(right=1.0 - 11.0 / 166.0)
    clearances = np.geomspace(*case.clearance_range, POINTS)
    fold = _fold(case)
    if fold is not None:  # both branches end there with a vertical tangent
        near = fold + np.geomspace(1e-4, 0.03, 12) * fold
        clearances = np.union1d(clearances, near[(near > clearances[0]) & (near < clearances[-1])])
    sweeps = _sweeps(case, np.array([case.footstep.face_gap]), clearances)
    at, places = CLEARANCE.shown(case.footstep.clearance), in_engineers_unit("heel_clearance", clearances)
    for panel, name in zip(axes.ravel(), OVER_CLEARANCE, strict=True):
        _name(panel, [end for sweep in sweeps for end in _branches(panel, places, sweep, name)])
        _marks(panel, case, at, name)
        panel.set_ylabel(axis_label(QUANTITIES[name]))
        _verticals(panel, case)
    for panel in axes[-1]:
        panel.set_xlabel(axis_label(CLEARANCE))
    axes[0][0].set_xlim(*map(CLEARANCE.shown, case.clearance_range))
    return figure


def _over_gap(case: FootstepProblem) -> Figure:
    figure, axes = Sheet(166.0, 100.0, 2, 2, left=14.0, across=22.0, between=6.0).panels(sharex=True)
    figure.subplots_adjust(right=1.0 - 11.0 / 166.0)
    gaps = np.linspace(*case.gap_range, POINTS)
    places = in_engineers_unit("face_gap", gaps)
    sweeps = _sweeps(case, gaps, np.array([case.footstep.clearance]))
    for panel, name in zip(axes.ravel(), OVER_GAP, strict=True):
        _name(panel, [end for sweep in sweeps for end in _branches(panel, places, sweep, name)])
        _marks(panel, case, GAP.shown(case.footstep.face_gap), name)
        panel.set_ylabel(axis_label(QUANTITIES[name]))
        panel.set_xlim(*map(GAP.shown, case.gap_range))
    for panel in axes[-1]:
        panel.set_xlabel(axis_label(GAP))
    return figure


def _branches(panel: Axes, places: Array, sweep: FootstepSweep, name: str) -> list[End]:
    """One quantity along every branch, its stable part full and its unstable part broken; where each ends."""
    ends: list[End] = []
    for branch in sweep.names:
        if branch is StateName.FOLD:
            continue
        values = in_engineers_unit(name, sweep.values(_attribute(name), branch).ravel())
        stable = sweep.values("stable", branch).ravel()
        colour = GREY if branch is StateName.SMOOTH else INK
        for wanted, line in ((1.0, "-"), (0.0, UNSTABLE)):
            shown = np.where(stable == wanted, values, np.nan)
            panel.plot(
                places, shown, color=colour, linestyle=line, linewidth=0.9 if branch is StateName.SMOOTH else 1.2
            )
        there = np.flatnonzero(np.isfinite(values))
        if there.size:
            ends.append((float(values[there[-1]]), float(places[there[-1]]), WORDS[branch], colour))
    return ends


def _name(panel: Axes, ends: list[End]) -> None:
    """Names of curves beside their last points, so far apart that they can be read."""
    low, high = panel.get_ylim()
    ends = sorted(ends)
    levels = spread_levels([value for value, *_ in ends], 0.075 * (high - low))
    for (_, place, name, colour), level in zip(ends, levels, strict=True):
        panel.annotate(
            name, (place, level), xytext=(3, 0), textcoords="offset points", fontsize=7, va="center", color=colour,
            annotation_clip=False,
        )  # fmt: skip


def _attribute(name: str) -> str:
    """Name of a quantity in a steady state."""
    return {"heel_leakage": "leakage"}.get(name, name)


def _marks(panel: Axes, case: FootstepProblem, at: float, name: str) -> None:
    """The states of the case itself, open where they are not stable."""
    for state in _states(case):
        value = float(in_engineers_unit(name, np.array(getattr(state, _attribute(name)))))
        filled = INK if state.stable else "white"
        panel.plot([at], [value], "o", color=INK, markerfacecolor=filled, zorder=5, clip_on=False)


def _states(case: FootstepProblem) -> tuple[SteadyState, ...]:
    try:
        return steady_states(case.footstep, case.method)
    except NoSteadyStateError:
        return ()


def _fold(case: FootstepProblem) -> float | None:
    from babbitt.kinds.footstep.clearances import fold_clearance

    if not case.is_grooved or case.method is not Method.SUPERPOSITION:
        return None
    return fold_clearance(case.footstep)


def _verticals(panel: Axes, case: FootstepProblem) -> None:
    """Critical clearance of the hot branch, and fold."""
    if not case.is_grooved or case.method is not Method.SUPERPOSITION:
        return
    from babbitt.kinds.footstep.clearances import critical_clearances

    critical = critical_clearances(case.footstep)
    places = {r"$δ_\mathrm{cr}$": critical[0].clearance if critical else None}
    places[r"$δ_\mathrm{f}$"] = _fold(case)
    low, high = case.clearance_range
    for text, place in places.items():
        if place is not None and low < place < high:
            panel.axvline(CLEARANCE.shown(place), color=GREY, linewidth=0.7, linestyle=DOTTED, zorder=0)
            panel.annotate(
                text, (CLEARANCE.shown(place), 1.0), xycoords=panel.get_xaxis_transform(), xytext=(2, -1),
                textcoords="offset points", fontsize=7, va="top", color="0.3",
                ha="left" if "cr" in text else "right",
            )  # fmt: skip
