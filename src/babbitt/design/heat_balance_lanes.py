"""The lumped heat balance of many bearings at once, by the steps of `babbitt.design.heat_balance`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.design.heat_balance import CEILING, FINE_SEARCH, MOST_STEPS
from babbitt.numerics.lane_roots import find_roots
from babbitt.numerics.scalar_or_array import Array

__all__ = ["coolest_temperatures"]

Index = NDArray[np.intp]


def coolest_temperatures(surplus: Callable[[Index, Array], Array], coolest: Array) -> Array:
    """Temperatures in K of the coolest equilibria, by the steps of `FINE_SEARCH`.

    Parameters
    ----------
    surplus : callable
        Numbers of lanes and a temperature in each -> heat made less heat carried away; NaN without a film.
    coolest : ndarray, shape (n,)
        Temperatures below which there is no equilibrium.

    Returns
    -------
    ndarray, shape (n,)
        NaN where the way is not plain: the film gives way on it, the surplus has a dip between two steps, or there
        is no equilibrium. Such lanes are for `babbitt.design.heat_balance.coolest_equilibrium`, one by one.
    """
    found = np.full(coolest.shape, np.nan)
    lanes = np.arange(coolest.size)
    low, at_low = coolest, surplus(lanes, coolest)
    found[at_low <= 0.0] = coolest[at_low <= 0.0]  # the coolest film already gives away all its heat
    on = at_low > 0.0
    lanes, low, at_low = lanes[on], low[on], at_low[on]
    before = at_low
    brackets: list[tuple[NDArray[Any], ...]] = []
    while lanes.size:
        high = np.minimum(low + FINE_SEARCH.step, CEILING)
        at_high = surplus(lanes, high)
        closed = at_high <= 0.0
        brackets.append((lanes[closed], low[closed], high[closed], at_low[closed], at_high[closed]))
        dips = (before > at_low) & (at_low < at_high)
        on = (at_high > 0.0) & ~dips & (high < CEILING)
        lanes, before, low, at_low = lanes[on], at_low[on], high[on], at_high[on]
    if brackets:
        columns = [np.concatenate(column) for column in zip(*brackets, strict=True)]
        index, below, above, at_below, at_above = columns
        found[index] = find_roots(
            lambda chosen, places: surplus(index[chosen], places),
            below,
            above,
            at_below,
            at_above,
            absolute=FINE_SEARCH.tolerance,
            most_steps=MOST_STEPS,
        )
    return found
