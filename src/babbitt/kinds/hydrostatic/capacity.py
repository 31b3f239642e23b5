"""Load that a bearing carries at the least gap that its user allows."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from babbitt.kinds.hydrostatic.answer import MOST_OPEN, Answer, answer, answer_at, thinnest_film
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.model import HydrostaticCase, OperatingConditions
from babbitt.kinds.hydrostatic.pumping import held_pressure, highest_pressure, is_pumped
from babbitt.kinds.hydrostatic.state import SearchOutcome
from babbitt.numerics.roots import bracketed_root

__all__ = ["capacity"]

STRIDE, MOST_STRIDES = 1.3, 60
"""Ratio of two loads that are tried one after the other, and how many: nearly seven orders of magnitude."""
TOLERANCE, ROUGH = 1e-5, 2e-3
"""Of the load, relative; of that of a draft which a finer grid follows."""
NEXT = 1.01
"""Ratio of the loads on both sides of a draft's capacity between which that of a finer grid is sought first."""
CONTACT = -1.0
"""Margin of a load that no film carries: less than any film's."""


def capacity(case: HydrostaticCase, found: Answer) -> float | None:
    """Load whose equilibrium has the least gap, or where pumps of the recesses come to their pressure.

    Its direction is that of the case's load, and moments stand as they are; of a prescribed position those of the
    force that was found there. Films of journals and rings are sought on the draft's grid, and found on that of
    the case.

    Parameters
    ----------
    case : HydrostaticCase
    found : Answer
        Of the case.

    Returns
    -------
    float or None
        N; None where no load was found that keeps the least gap.
    """
    if isinstance(case.shape, RecessedJournal | ThrustRing):
        asked = replace(case, duty=carried(case, found))
        if case.method != "film" or case.accuracy == "draft":  # no finer grid follows
            return loaded_capacity(asked, TOLERANCE)
        rough = loaded_capacity(replace(asked, accuracy="draft"), ROUGH)
        return None if rough is None else refined(asked, rough)
    return level_capacity(case)


def refined(case: HydrostaticCase, rough: float) -> float | None:
    """Capacity on the grid of the case, N, next to that of the draft."""
    kept, lost = rough / NEXT, rough * NEXT
    if margin(case, kept) >= 0.0 > margin(case, lost):
        return between(case, kept, lost, TOLERANCE)
    return loaded_capacity(replace(case, duty=replace(case.duty, load=rough)), TOLERANCE)


def level_capacity(case: HydrostaticCase) -> float | None:
    """Of a pad, which has no other motion than to rise."""
    at = np.zeros(1 if isinstance(case.shape, RectangularPad) else 3)
    least = case.least_gap or 0.0

    def excess(log_gap: float) -> float:
        return excess_pressure(case, answer_at(case, at, math.exp(log_gap)))

    low, high = math.log(least), math.log(MOST_OPEN)
    if is_pumped(case) and excess(low) > 0.0 > excess(high):
        least = math.exp(bracketed_root(excess, low, high, 1e-6))
    state = answer_at(case, at, least)
    return float(state.response.force[0]) if state.ending is SearchOutcome.SOLVED else None


def carried(case: HydrostaticCase, found: Answer) -> OperatingConditions:
    """Duty under the load of the case, or under that which it carries at a prescribed position."""
    duty, force = case.duty, found.response.force
    if duty.load is not None:
        return duty
    if case.is_journal:
        angle = math.atan2(-float(force[1]), -float(force[0]))
        return replace(duty, load=float(np.hypot(*force)), load_angle=angle)
    return replace(duty, load=float(force[0]), moments=(-float(force[1]), -float(force[2])), gap=found.minimum_gap)


def loaded_capacity(case: HydrostaticCase, tolerance: float) -> float | None:
    """Greatest load next to that of the case whose equilibrium keeps the least gap."""
    load = case.duty.load or first_load(case)
    here = margin(case, load)
    if here < 0.0:
        kept = towards_kept(case, load, here)
        return None if kept is None else between(case, *kept, tolerance)
    for _ in range(MOST_STRIDES):
        if margin(case, load * STRIDE) < 0.0:
            return between(case, load, load * STRIDE, tolerance)
        load *= STRIDE
    return None


def towards_kept(case: HydrostaticCase, load: float, here: float) -> tuple[float, float] | None:
    """Two loads of which the lighter keeps the least gap and the heavier does not; None where none keeps it.

    A lighter load has the thicker film, but for a runner that a moment tilts the more the less it is pressed
    on: there heavier ones come first, up to the thickest film.
    """
    heavier = margin(case, load * STRIDE)
    if heavier > here:
        while here < heavier < 0.0:
            load, here, heavier = load * STRIDE, heavier, margin(case, load * STRIDE**2)
        while heavier >= 0.0:
            load, heavier = load * STRIDE, margin(case, load * STRIDE**2)
            if heavier < 0.0:
                return load, load * STRIDE
        return None
    lightest = float(np.hypot(*case.duty.moments)) / case.reach  # films push: their resultant lies within the edge
    for _ in range(MOST_STRIDES):
        if load / STRIDE < lightest:
            return None
        if margin(case, load / STRIDE) >= 0.0:
            return load / STRIDE, load
        load /= STRIDE
    return None


def between(case: HydrostaticCase, kept: float, lost: float, tolerance: float) -> float:
    """Load between one that keeps the least gap and one that does not, N."""
    bounds = math.log(kept), math.log(lost)
    return math.exp(bracketed_root(lambda log_load: margin(case, math.exp(log_load)), *bounds, tolerance))


def first_load(case: HydrostaticCase) -> float:
    """A small load to begin with where the case has none, N."""
    return 1e-2 * (case.feeding.nominal_pressure or 1e6) * case.recess_area


def margin(case: HydrostaticCase, load: float) -> float:
    """Gap above the least under a load, over the gap at rest, or what a pump's pressure leaves: the less."""
    found = answer(replace(case, duty=replace(case.duty, load=load)))
    if found.ending is SearchOutcome.LIFTED_OFF:
        return 1.0
    if found.ending is not SearchOutcome.SOLVED:
        return CONTACT
    gap = (thinnest_film(case, found) - (case.least_gap or 0.0)) / case.rest_gap
    return min(gap, -excess_pressure(case, found)) if is_pumped(case) else gap


def excess_pressure(case: HydrostaticCase, found: Answer) -> float:
    """Pressure that a pump must hold over what it can, less one."""
    limit = highest_pressure(case, found.network)
    return -1.0 if limit is None else held_pressure(case, found.network) / limit - 1.0
