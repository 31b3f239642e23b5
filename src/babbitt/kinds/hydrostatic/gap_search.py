"""The gap at which pressed oil carries a load: Newton on the logarithms of both, between bounds.

Over the logarithm of the gap that of the load falls from zero slope where the recess has the supply pressure to a
slope of -3 where the restrictor gives a constant flow, and bends one way: from the wide side Newton comes down
without passing the root.
"""

from __future__ import annotations

import math
from collections.abc import Callable

__all__ = ["gap_for_load"]

LONGEST = 1.5
"""Of a step, in the logarithm of the gap."""
MOST_NEWTON, MOST_STEPS = 30, 200
NARROWEST = 1e-14
"""Between the bounds, in the logarithm of the gap: round-off is left."""


def gap_for_load(
    carried: Callable[[float], tuple[float, float]],
    load: float,
    bounds: tuple[float, float],
    start: float,
    tolerance: float,
) -> float:
    """Gap at which a load is carried.

    Parameters
    ----------
    carried : callable
        Load (N) and stiffness (N/m) at a gap (m).
    load : float
        N.
    bounds : tuple of float
        Least and widest gap, m.
    start : float
        Gap to begin with, m.
    tolerance : float
        Of the load, relative.

    Returns
    -------
    float
        m; 0 where the load is too heavy for the least gap, infinite where it is too light for the widest, nan
        where the search does not end.
    """
    low, high = math.log(bounds[0]), math.log(bounds[1])
    tried_low = tried_high = False
    place = min(max(math.log(start), low), high)
    for count in range(MOST_STEPS):
        gap = math.exp(place)
        found, stiffness = carried(gap)
        excess = _excess(found, load)
        if abs(excess) < tolerance or (tried_low and tried_high and high - low < NARROWEST):
            return gap
        if excess > 0.0:
            low, tried_low = place, True
        else:
            high, tried_high = place, True
        if low >= high:  # still too much at the widest gap, or too little at the least
            return math.inf if excess > 0.0 else 0.0
        step = math.copysign(LONGEST, excess)
        if found > 0.0 and stiffness > 0.0:
            step = min(max(excess * found / (stiffness * gap), -LONGEST), LONGEST)
        place += step
        if count > MOST_NEWTON or not low < place < high:
            end, tried = (high, tried_high) if step > 0.0 else (low, tried_low)
            place = 0.5 * (low + high) if tried else end
    return math.nan


def _excess(found: float, load: float) -> float:
    """Logarithm of what is carried over the load; no load is too light for every gap."""
    if not load > 0.0:
        return math.inf
    return math.log(found / load) if found > 0.0 else -math.inf
