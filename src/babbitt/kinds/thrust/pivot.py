"""Where plane pads balance on their pivot, and which of its two places is at fault where they do not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.equilibrium import pad_state
from babbitt.kinds.thrust.load_curve import REFERENCE_SHARE
from babbitt.kinds.thrust.pad import Pivot, ThrustPad
from babbitt.kinds.thrust.state import PadState

__all__ = ["PivotFault", "pivot_fault"]

HALVINGS = 9
"""Of the way from a place that balances to the edge of the pad."""
TRIED = (0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.52, 0.85)
"""Fractions at which a balance is sought."""


@dataclass(frozen=True)
class PivotFault:
    """Why a plane pad does not balance.

    Attributes
    ----------
    field : {"radius", "fraction"}
        Which place of the pivot is at fault.
    low, high : float
        Between which values of it, the other unchanged, the pad balances, m or 1; both zero where none was found.
    """

    field: str
    low: float
    high: float


@lru_cache(maxsize=64)
def pivot_fault(pad: ThrustPad) -> PivotFault | None:
    """Say whether and why a plane laminar pad does not balance; None where it does.

    Parameters
    ----------
    pad : ThrustPad
        By similarity one film decides for all.
    """
    if _balances(pad):
        return None
    along = replace(pad, pivot=Pivot.LINE)
    if pad.pivot is Pivot.POINT and _balances(along):
        state = _state(along)
        centre = pad.pivot_radius + state.moments[0] / state.load  # of the pressure under a pad that stays level
        if pad.inner_radius < centre < pad.outer_radius and _balances(replace(pad, pivot_radius=centre)):
            low = _last(lambda at: _balances(replace(pad, pivot_radius=at)), centre, pad.inner_radius)
            high = _last(lambda at: _balances(replace(pad, pivot_radius=at)), centre, pad.outer_radius)
            return PivotFault("radius", low, high)
    good = next((one for one in TRIED if _balances(replace(pad, pivot_fraction=one))), None)
    if good is None:
        return PivotFault("radius" if pad.pivot is Pivot.POINT and _balances(along) else "fraction", 0.0, 0.0)
    low = _last(lambda at: _balances(replace(pad, pivot_fraction=at)), good, 0.5)
    high = _last(lambda at: _balances(replace(pad, pivot_fraction=at)), good, 1.0)
    return PivotFault("fraction", low, high)


def _state(pad: ThrustPad) -> PadState:
    return pad_state(pad, REFERENCE_SHARE * pad.pivot_radius, 1.0, 1.0)


def _balances(pad: ThrustPad) -> bool:
    try:
        return bool(_state(pad).load > 0.0)
    except InputError:
        return False


def _last(balances: Callable[[float], bool], good: float, beyond: float) -> float:
    """The place farthest from one that balances that does, too; not the edge itself."""
    for _ in range(HALVINGS):
        middle = 0.5 * (good + beyond)
        good, beyond = (middle, beyond) if balances(middle) else (good, middle)
    return good
