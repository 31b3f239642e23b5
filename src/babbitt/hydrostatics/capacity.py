"""Load that a bearing carries at the least gap that its user allows."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from babbitt.design.roots import bracketed_root, find_root
from babbitt.hydrostatics.answer import MOST_OPEN, Answer, answer_at, load_vector
from babbitt.hydrostatics.geometry import RecessedJournal, RectangularPad
from babbitt.hydrostatics.model import HydrostaticCase
from babbitt.hydrostatics.pumping import held_pressure, highest_pressure, is_pumped
from babbitt.hydrostatics.state import Ending

__all__ = ["capacity"]


def capacity(case: HydrostaticCase) -> float | None:
    """Load at the least gap, or where pumps of the recesses come to their pressure, N; None where not found."""
    least = case.least_gap or 0.0
    if isinstance(case.shape, RecessedJournal):
        return journal_capacity(replace(case, accuracy="draft"), max(case.shape.clearance - least, 0.0))
    at = np.zeros(1 if isinstance(case.shape, RectangularPad) else 3)

    def excess(log_gap: float) -> float:
        return excess_pressure(case, answer_at(case, at, math.exp(log_gap)))

    low, high = math.log(least), math.log(MOST_OPEN)
    if is_pumped(case) and excess(low) > 0.0 > excess(high):
        least = math.exp(bracketed_root(excess, low, high, 1e-6))
    state = answer_at(case, at, least)
    return float(state.response.force[0]) if state.ending is Ending.SOLVED else None


def excess_pressure(case: HydrostaticCase, found: Answer) -> float:
    """Pressure that a pump must hold over what it can, less one."""
    limit = highest_pressure(case, found.network)
    return -1.0 if limit is None else held_pressure(case, found.network) / limit - 1.0


def journal_capacity(case: HydrostaticCase, depth: float) -> float | None:
    """Load in its given direction up to an eccentricity; none where the least gap leaves no room for one."""
    if depth == 0.0:
        return 0.0
    state = straight_at(case, depth)
    if state is not None and is_pumped(case) and excess_pressure(case, state) > 0.0:

        def excess(place: float) -> float:
            found = straight_at(case, place)
            return math.nan if found is None else excess_pressure(case, found)

        if not excess(0.0) < 0.0:
            return None
        state = straight_at(case, bracketed_root(excess, 0.0, depth, 1e-4 * depth))
    return None if state is None else -float(state.response.force @ towards_load(case)[0])


def towards_load(case: HydrostaticCase) -> tuple[np.ndarray, float]:
    """Direction of the load, as a vector and rad."""
    load = load_vector(case)
    angle = math.atan2(load[1], load[0]) if float(np.hypot(*load)) else -0.5 * math.pi
    return np.array([math.cos(angle), math.sin(angle)]), angle


def straight_at(case: HydrostaticCase, depth: float) -> Answer | None:
    """State at an eccentricity where the film pushes straight against the load; None where there is none."""
    towards, angle = towards_load(case)
    sense = math.copysign(1.0, case.duty.angular_speed)

    def state(attitude: float) -> Answer:
        turned = angle + sense * attitude
        return answer_at(case, depth * np.array([math.cos(turned), math.sin(turned)]), case.rest_gap)

    def aside(attitude: float) -> float:
        found = state(attitude)
        force = found.response.force
        return float(towards[0] * force[1] - towards[1] * force[0]) if found.ending is Ending.SOLVED else math.nan

    attitude = 0.0
    if case.duty.angular_speed and depth and aside(0.0) * aside(0.5 * math.pi) < 0.0:
        root = find_root(aside, 0.0, 0.5 * math.pi, 1e-3)
        if not root.converged:  # there is no state on the way
            return None
        attitude = root.value
    found = state(attitude)
    return found if found.ending is Ending.SOLVED else None
