"""Figures of one bearing by ISO 7902: friction and film over speed and load, load capacity, clearance, spans."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.kinds.journal.iso7902.model import DesignCase, PrescribedLoad
from babbitt.kinds.journal.report import plots
from babbitt.report.drawing import Drawing, rendered, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["ClearanceRange", "clearance_range", "draw"]

SUPPOSED_TOLERANCE = 0.3
"""Relative width of the clearance shown on either side where the case gives no tolerance."""

WIDE = ("speed-and-load", "spans")
"""Figures that take the width of a page."""


@dataclass(frozen=True)
class ClearanceRange:
    """Smallest and largest relative clearance at 20 °C, and whether the case itself gives them."""

    smallest: float
    largest: float
    given: bool


def clearance_range(case: DesignCase) -> ClearanceRange:
    """Range of the relative clearance of a bearing: its tolerance, or a supposed one."""
    given = case.bearing.clearance_tolerance
    if given is not None:
        return ClearanceRange(*given, given=True)
    middle = case.bearing.relative_clearance
    return ClearanceRange((1.0 - SUPPOSED_TOLERANCE) * middle, (1.0 + SUPPOSED_TOLERANCE) * middle, given=False)


def draw(
    case: DesignCase, result: Result, clearance: ClearanceRange, image_format: str = "svg"
) -> tuple[Drawing, ...]:
    """All figures of a solved bearing.

    Parameters
    ----------
    case : DesignCase
    result : Result
        Its answer; an unsolved one has no figures.
    clearance : ClearanceRange
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Drawing
    """
    if not result.outcome.solved:
        return ()
    loaded = replace(case, duty=PrescribedLoad(result.load))
    figures: tuple[tuple[str, str, Callable[[], Figure]], ...] = (
        ("speed-and-load", _speed_and_load_caption(case, result), lambda: plots.speed_and_load(loaded, result)),
        (
            "load-capacity",
            "Sommerfeld number over eccentricity for the span of this bearing and, paler, for the others of the "
            f"same B/D = {case.bearing.part_width_ratio:.3g}.",
            lambda: plots.load_capacity(case, result),
        ),
        (
            "clearance",
            _clearance_caption(clearance),
            lambda: plots.clearance(loaded, result, clearance.smallest, clearance.largest),
        ),
        (
            "spans",
            "The same bearing with other angular spans, supply element unchanged; the span of this bearing "
            "filled. Spans without a mark have no operating point.",
            lambda: plots.spans(loaded, result),
        ),
    )
    with style():
        return tuple(
            Drawing(name, caption, rendered(paint(), image_format), wide=name in WIDE)
            for name, caption, paint in figures
        )


def _speed_and_load_caption(case: DesignCase, result: Result) -> str:
    balanced = case.effective_temperature is None
    heat = "each point with its own heat balance" if balanced else "all at the effective temperature prescribed"
    text = (
        "Friction coefficient and minimum film thickness over speed at the given load, and over load at the given "
        f"speed, {heat}. Filled: the operating point. Hydrodynamic only: the rise of friction by asperities that "
        "touch is left out."
    )
    if "transition_speed" in result.values:
        text += " Dotted: transition to mixed friction at the viscosity of the operating point."
    return text


def _clearance_caption(clearance: ClearanceRange) -> str:
    shown = "Effective temperature and minimum film thickness over the relative clearance at 20 °C, "
    if clearance.given:
        return f"{shown}from the smallest to the largest clearance of the case."
    about = f"{shown}±{SUPPOSED_TOLERANCE:.0%} about the one computed"
    return f"{about} (the case gives no tolerance)."
