"""How far every pad is from being unloaded."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pivots import displacement_of
from babbitt.reynolds.tilting_pads.solution import PadStatus, TiltingPadSolution
from babbitt.reynolds.tilting_pads.solve import fold_of, tilting_pads_at

__all__ = ["LIGHTLY_LOADED", "NEAR_FOLD", "PadMargin", "loaded_at_fold", "loading_preload", "pad_margins"]

NEAR_FOLD = 0.1
"""Eccentricity ratio at the pivot above that at which the pad unloads, below which it is reported: tolerances of a
tenth of the machined clearance move it by as much (assumption)."""

LIGHTLY_LOADED = 0.02
"""Share of the load of the bearing below which a loaded pad is reported, too (assumption)."""


@dataclass(frozen=True)
class PadMargin:
    """Distance of a pad from being unloaded.

    Attributes
    ----------
    number : int
        From 1.
    margin : float
        Eccentricity ratio at the pivot less that at which the pad unloads; infinite where it does so nowhere (a
        flexure, or an offset pivot that carries at any place), nan where that was not found.
    fold : float
        That at which it unloads.
    loaded : bool
    """

    number: int
    margin: float
    fold: float
    loaded: bool


def pad_margins(case: PadCase, solution: TiltingPadSolution) -> tuple[PadMargin, ...]:
    """The margin of every pad; pads that differ in their place alone unload at one ratio, sought once."""
    folds: dict[TiltingPad, float] = {}
    found = []
    for number, (pad, state) in enumerate(zip(solution.bearing.pads, solution.pads, strict=True)):
        alike = replace(pad, pivot_angle=0.0)
        if alike not in folds:
            folds[alike] = fold_ratio(case, solution, number)
        fold = folds[alike]
        loaded = state.status is not PadStatus.UNLOADED
        found.append(PadMargin(number + 1, state.eccentricity_ratio - fold, fold, loaded))
    return tuple(found)


def fold_ratio(case: PadCase, solution: TiltingPadSolution, number: int) -> float:
    """Eccentricity ratio at the pivot at which a pad unloads; minus infinity: nowhere, nan: not found."""
    if solution.bearing.pads[number].rotational_stiffness > 0.0:
        return -math.inf
    fold = fold_of(solution.bearing, number, case.accuracy.resolution)
    return fold.eccentricity_ratio if fold.outcome.solved else math.nan


def loading_preload(pad: TiltingPad, solution: TiltingPadSolution, fold: float) -> float:
    """Preload from which on a pad would carry where the journal stands: that at which eps_p is that of its fold,
    eps_p,fold - (x, y).n/c_p."""
    return fold - float(solution.position @ pad.normal()) / pad.clearance


BEHIND_FOLD = 1e-5
"""Of the clearance: how far from its fold a pad is shown that just carries."""


def loaded_at_fold(case: PadCase, solution: TiltingPadSolution, margin: PadMargin) -> TiltingPadSolution:
    """The films with the journal moved away from a pad until that pad stands at its fold and carries."""
    number = margin.number - 1
    pad, state = solution.bearing.pads[number], solution.pads[number]
    least = next(one.least for one in solution.light if one.number == number)
    gap = (margin.fold + BEHIND_FOLD - state.eccentricity_ratio) * pad.clearance + displacement_of(
        pad.pivot, least
    )
    x, y = solution.position + gap * pad.normal()
    return tilting_pads_at(solution.bearing, (float(x), float(y)), case.accuracy.resolution)
