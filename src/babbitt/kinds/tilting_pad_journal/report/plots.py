"""Loads of the pads, coefficients over the whirl ratio, free motions over the mass, load of a pad over its way."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.language import listed
from babbitt.kinds.tilting_pad_journal.dynamics import PadDynamics, chain_of, motions_of_the_rotor
from babbitt.kinds.tilting_pad_journal.margins import PadMargin
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.report.drawing import GREY, INK, Array, Sheet, mark
from babbitt.report.us_words import numbers_in_us_units
from babbitt.reynolds.tilting_pads.dynamics import condensed_over
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pivots import RigidPivot
from babbitt.reynolds.tilting_pads.rotor import Mode, rotor_modes
from babbitt.reynolds.tilting_pads.solution import TiltingPadSolution
from babbitt.reynolds.tilting_pads.solve import tilting_pads_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["coefficients_over_whirl", "pad_curve", "pad_loads", "root_locus"]

BROAD, CHAIN = "0.68", (0, (6, 2, 1, 2))
ENTRIES = (("xx", 0, 0, BROAD, "-", 2.6), ("yy", 1, 1, INK, (0, (5, 2)), 0.9), ("xy", 0, 1, BROAD, CHAIN, 2.6),
           ("yx", 1, 0, INK, CHAIN, 0.7))  # fmt: skip
"""Entries of a matrix with colour, stroke and width: narrow and dark on broad and pale, for they may coincide."""

WITHIN_A_CYCLE = math.tau
"""Log decrement above which the locus leaves motions out: they die within a cycle, as motions of pads do."""

MASSES = np.geomspace(0.1, 10.0, 41)
"""Masses over that of the rotor along the locus."""

SLOW = 3.0
"""Growth and frequency over the angular speed that the locus shows."""

NEAREST = 0.05
"""Film at the pivot over the machined clearance at which the curve of a pad ends."""

SIDE_BY_SIDE, ABOVE_EACH_OTHER = 0.04, 0.1
"""Ratio, and share of the largest load, within which pads are named together: their names would touch."""

CLOSE = 0.12, 0.07
"""Shares of the width and the height of the locus within which motions are named together."""

NEAR_THE_END = 0.22
"""Share of the width of the locus at its right end where a name stands to the left of its point."""

AT_THE_EDGE = 0.1
"""Share of the width of a panel at its left edge where a name stands to the right of its point."""

POINTS = 45
"""Of that curve."""


def pad_loads(solution: TiltingPadSolution) -> Figure:
    """Load and thinnest film of every pad as bars; words stand upright, clear of those of neighbours."""
    figure, ((left, right),) = Sheet(166.0, 48.0, 1, 2, across=16.0).panels()
    numbers = np.arange(1, len(solution.pads) + 1)
    loads = np.array([state.load for state in solution.pads]) / 1e3
    films = np.array([state.minimum_film_thickness for state in solution.pads]) * 1e6
    carries = loads > 0.0
    for panel, heights, unit in ((left, loads, "kN"), (right, films, "µm")):
        panel.bar(numbers[carries], heights[carries], 0.6, facecolor="0.8", edgecolor=INK, linewidth=0.7)
        if not carries.all():
            panel.bar(
                numbers[~carries],
                heights[~carries],
                0.6,
                facecolor="white",
                edgecolor=GREY,
                linewidth=0.7,
                hatch="///",
            )
        for number, height, has in zip(numbers, heights, carries, strict=True):
            shown = has or panel is right
            text = numbers_in_us_units(f"{height:.3g}", unit) if shown else "unloaded"
            panel.annotate(text, (number, height), xytext=(0, 1.5), textcoords="offset points", fontsize=7,
                           ha="center", va="bottom", rotation=0.0 if shown else 90.0)  # fmt: skip
        panel.set_xticks(numbers)
        panel.set_xlabel("pad")
        panel.tick_params(axis="x", length=0.0)
        panel.set_ylim(0.0, 1.15 * float(heights.max()))
    left.set_ylabel("$W$ in kN")
    right.set_ylabel("$h_\\mathrm{min}$ in µm")
    return figure


def coefficients_over_whirl(case: PadCase, dynamics: PadDynamics) -> Figure:
    """Stiffness and damping over the whirl ratio, with what is fitted."""
    figure, ((left, right),) = Sheet(166.0, 58.0, 1, 2, across=17.0).panels()
    ends = min(case.whirl_ratios), max(case.whirl_ratios)
    low, high = (0.9 * ends[0], 1.1 * ends[1]) if ends[1] > ends[0] else (0.5 * ends[0], 1.5 * ends[0])
    ratios = np.linspace(max(low, 0.02), max(high, 0.05), 81)
    found = condensed_over(dynamics.full, ratios.tolist())
    fit, speed = dynamics.fit, dynamics.full.speed
    for name, i, j, colour, stroke, width in ENTRIES:
        stiffness = 1e-6 * np.array([one.stiffness[i, j] for one in found])
        damping = 1e-3 * np.array([one.damping[i, j] for one in found])
        drawn = {"color": colour, "linestyle": stroke, "linewidth": width}
        left.plot(ratios, stiffness, **drawn)
        right.plot(ratios, damping, **drawn, label=name)
        for one in dynamics.over_whirl:
            left.plot([one.whirl_ratio], [1e-6 * one.stiffness[i, j]], ".", color=INK, markersize=3.5)
            right.plot([one.whirl_ratio], [1e-3 * one.damping[i, j]], ".", color=INK, markersize=3.5)
        if fit is not None:
            fitted = 1e-6 * (fit.stiffness[i, j] - (ratios * speed) ** 2 * fit.mass[i, j])
            left.plot(ratios, fitted, color=GREY, linestyle=":", linewidth=0.8)
            right.axhline(1e-3 * fit.damping[i, j], color=GREY, linestyle=":", linewidth=0.8)
    left.set(xlabel="whirl ratio $ν$", ylabel="$K$ in MN/m")
    right.set(xlabel="whirl ratio $ν$", ylabel="$C$ in kN s/m")
    right.legend(frameon=False, fontsize=7, ncols=4, loc="best", handlelength=3.4, columnspacing=1.0)
    for panel in (left, right):
        panel.axvline(1.0, color="0.8", linewidth=0.6, zorder=0)
        _room(panel)
    return figure


def _room(panel: Axes) -> None:
    """Some space above and below the curves."""
    low, high = panel.get_ylim()
    panel.set_ylim(low - 0.04 * (high - low), high + 0.14 * (high - low))


def root_locus(case: PadCase, dynamics: PadDynamics) -> Figure:
    """Free motions in the plane of growth and frequency while the mass of the rotor grows tenfold both ways."""
    assert case.rotor_mass is not None
    figure, ((panel,),) = Sheet(166.0, 64.0, left=12.0).panels()
    chain = chain_of(case, dynamics.full)
    own = rotor_modes(chain, case.rotor_mass)
    bound = max(SLOW * chain.speed, *(1.25 * one.frequency for one in motions_of_the_rotor(own)))
    for place, share in enumerate(MASSES):
        shade = str(round(0.82 - 0.62 * place / (MASSES.size - 1), 3))
        modes = [one for one in rotor_modes(chain, share * case.rotor_mass) if shown(one, bound)]
        panel.plot([one.growth for one in modes], [one.frequency / math.tau for one in modes], ".", color=shade,
                   markersize=2.5, markeredgewidth=0.0)  # fmt: skip
    rotor = motions_of_the_rotor(own)
    own = tuple(one for one in own if shown(one, bound) or one in rotor)
    for mode in own:
        mark(panel, mode.growth, mode.frequency / math.tau)
    panel.axvline(0.0, color=GREY, linewidth=0.7, linestyle=(0, (5, 2)), zorder=1)
    low, high = panel.get_xlim()
    panel.set_xlim(low, max(high, 0.15 * (high - low)))
    panel.set_ylim(bottom=0.0)
    left, right = panel.get_xlim()
    for modes in close_together(own, panel):
        before = modes[0].growth > right - NEAR_THE_END * (right - left)
        panel.annotate(
            f"δ {listed(f'{one.log_decrement:.2g}' for one in modes)}",
            (modes[0].growth, modes[0].frequency / math.tau), xytext=(-5, 3) if before else (5, 3),
            textcoords="offset points", ha="right" if before else "left", fontsize=6.5,
        )  # fmt: skip
    panel.set(xlabel="growth Re $λ$ in 1/s", ylabel="frequency Im $λ$/2π in Hz")
    return figure


def close_together(modes: Iterable[Mode], panel: Axes) -> list[list[Mode]]:
    """Motions whose names would touch, together."""
    (left, right), (bottom, top) = panel.get_xlim(), panel.get_ylim()
    across, up = CLOSE[0] * (right - left), CLOSE[1] * (top - bottom)
    groups: list[list[Mode]] = []
    for mode in modes:
        near = (
            group for group in groups
            if abs(group[0].growth - mode.growth) < across
            and abs(group[0].frequency - mode.frequency) < up * math.tau
        )  # fmt: skip
        found = next(near, None)
        if found is None:
            groups.append([mode])
        else:
            found.append(mode)
    return groups


def shown(mode: Mode, bound: float) -> bool:
    """Whether a motion swings in the range of the locus and outlasts a cycle."""
    return 0.0 < mode.frequency < bound and abs(mode.growth) < bound and mode.log_decrement < WITHIN_A_CYCLE


def pad_curve(case: PadCase, solution: TiltingPadSolution, margins: tuple[PadMargin, ...]) -> Figure:
    """Load of a pad free to tilt over the eccentricity ratio at its pivot, with every pad and its fold."""
    figure, ((panel,),) = Sheet(81.0, 60.0, left=12.0).panels()
    strokes = ("-", (0, (5, 2)), (0, (1, 1.5)), (0, (6, 2, 1, 2)))
    alike: dict[TiltingPad, list[int]] = {}
    for number, pad in enumerate(solution.bearing.pads):
        alike.setdefault(replace(pad, pivot_angle=0.0, pivot=RigidPivot()), []).append(number)
    for place, (pad, numbers) in enumerate(alike.items()):
        ratios, loads = curve_of(case, solution, pad, margins[numbers[0]])
        panel.plot(ratios, 1e-3 * loads, color=INK, linestyle=strokes[place % len(strokes)], linewidth=0.9)
        fold = margins[numbers[0]].fold
        if math.isfinite(fold):
            panel.plot([ratios[0]], [1e-3 * loads[0]], "|", color=INK, markersize=7)
    largest = max(1e-3 * state.load for state in solution.pads)
    for state in solution.pads:
        mark(panel, state.eccentricity_ratio, 1e-3 * state.load)
    low, high = panel.get_xlim()
    for first, numbers in pads_side_by_side(solution).items():
        at = solution.pads[first].eccentricity_ratio, 1e-3 * solution.pads[first].load
        right = at[0] < low + AT_THE_EDGE * (high - low)
        up = 6 if at[1] < 0.1 * largest else 3
        panel.annotate(", ".join(str(number + 1) for number in numbers), at, xytext=(4, 6) if right else (-4, up),
                       textcoords="offset points", fontsize=7, ha="left" if right else "right", zorder=7,
                       bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6})  # fmt: skip
    panel.set_ylim(0.0, 1.6 * largest if largest > 0.0 else None)
    panel.set(xlabel="$ε_\\mathrm{p}$", ylabel="$W_\\mathrm{p}$ in kN")
    return figure


def pads_side_by_side(solution: TiltingPadSolution) -> dict[int, list[int]]:
    """Numbers of the pads whose points in the curve nearly touch, by the first of them."""
    pads, groups = solution.pads, dict[int, list[int]]()
    reach = ABOVE_EACH_OTHER * max(state.load for state in pads)
    for number, state in enumerate(pads):
        near = (
            first for first in groups
            if abs(pads[first].eccentricity_ratio - state.eccentricity_ratio) < SIDE_BY_SIDE
            and abs(pads[first].load - state.load) <= reach
        )  # fmt: skip
        groups.setdefault(next(near, number), []).append(number)
    return groups


def curve_of(
    case: PadCase, solution: TiltingPadSolution, pad: TiltingPad, margin: PadMargin
) -> tuple[Array, Array]:
    """Eccentricity ratios at the pivot and loads of one pad, from where it unloads on; N."""
    alone = replace(solution.bearing, pads=(pad,))
    least = margin.fold + 1e-4 if math.isfinite(margin.fold) else -0.5
    ratios = least + (1.0 - NEAREST - least) * np.linspace(0.0, 1.0, POINTS) ** 1.3
    loads = []
    for ratio in ratios:
        way = (float(ratio) - pad.preload) * pad.clearance
        found = tilting_pads_at(alone, (way, 0.0), case.accuracy.resolution)
        loads.append(found.pads[0].load if found.outcome.solved else math.nan)
    return ratios, np.array(loads)
