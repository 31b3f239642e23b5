"""Figures of a tilting-pad bearing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.solution import Solution
from babbitt.kinds.tilting_pad_journal.check import PadSolutionState, least_decrement
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.report.drawing import Drawing, rendered, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["pad_figures"]

Painted = tuple[str, str, "Figure", bool]


def pad_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Every figure of a solved bearing; an unsolved one has none.

    Parameters
    ----------
    solution : Solution
    image_format : {"svg", "pdf", "png"}
    """
    if not solution.result.outcome.solved:
        return ()
    with style():
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), wide)
            for name, caption, figure, wide in _painted(solution.problem, solution.state)
        )


def _painted(case: PadCase, state: PadSolutionState) -> Iterator[Painted]:
    from babbitt.kinds.tilting_pad_journal.report import maps, plots, seen_along, stability, temperatures

    films, dynamics = state.films.solution, state.dynamics
    enlarged = seen_along.FILM * 0.5 * case.bearing.diameter / case.bearing.pad_clearance
    yield (
        "bearing",
        "Journal among its pads, seen along the shaft, to scale but for the films, which are drawn "
        f"{enlarged:.0f} times too thick. Outside: pressure in the middle of every pad and its load. Blank pads "
        "carry nothing.",
        seen_along.seen_along_shaft(case, films),
        False,
    )
    yield (
        "pad-curve",
        "Load of a pad that is free to tilt over the eccentricity ratio at its pivot, film alone, at one "
        "temperature. Filled: the pads by number; tick: where a pad unloads.",
        plots.pad_curve(case, films, state.margins),
        False,
    )
    yield (
        "pad-pressure",
        "Pressure over the unrolled pads; circles: pivots, crosses: highest pressure of a pad.",
        maps.pressure_map(case, films),
        True,
    )
    yield "pad-loads", "Load and thinnest film of every pad.", plots.pad_loads(films), True
    if (thermal := state.films.thermal) is not None:
        yield (
            "pad-temperatures",
            "Temperatures of bores and films over the angle, numbers at the pivots; groove, trailing edge, "
            "probe and highest of every pad, from the temperature of the fresh oil on.",
            temperatures.pad_temperatures(case, thermal),
            True,
        )
    yield (
        "whirl-ratio",
        "Stiffness and damping over the whirl ratio, xx and xy broad, yy and yx narrow; dots: ratios of the case, "
        "dotted: fit of stiffness, damping and virtual mass. At 1 they are synchronous.",
        plots.coefficients_over_whirl(case, dynamics),
        True,
    )
    if dynamics.motions is not None:
        yield (
            "root-locus",
            "Free motions of rotor and pads as the mass of the rotor grows from a tenth (pale) to ten times "
            "(dark) that of the case; filled: the case, with log decrements. Motions of pads that die within a "
            "cycle are left out. Right of the dashed line motions grow.",
            plots.root_locus(case, dynamics),
            True,
        )
    if state.cross_coupling is not None:
        yield (
            "cross-coupling",
            "Left: log decrement over the destabilising cross-coupling of the whole rotor, by the motions of "
            "rotor and pads together and by synchronously reduced coefficients; filled: with that anticipated; "
            "line: the least that is asked up to it. Right: over the speed, with that anticipated (black) and "
            "without (grey). Below zero a motion grows.",
            stability.log_decrements(case, state.cross_coupling, least_decrement(case)[0]),
            True,
        )
