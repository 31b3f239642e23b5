"""Stability of a rotor in a film, whatever the film: critical mass, whirl frequency, threshold speed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from babbitt.numerics.roots import find_root

if TYPE_CHECKING:
    from babbitt.reynolds.stability.routh import StableMasses

__all__ = [
    "SPEED_TOLERANCE",
    "STANDARD_GRAVITY",
    "ElasticWhirl",
    "Threshold",
    "Whirl",
    "crossing",
    "rotor_mass",
    "stability_excess",
]

STANDARD_GRAVITY = 9.80665
"""m/s²."""

FASTEST = 10.0
"""The threshold is sought up to this many times the speed, and down to its inverse."""

SPEED_TOLERANCE = 1e-4
"""Relative, of a speed sought: a tenth of what the grid leaves open."""
EXCESS_DECIMALS = 9
"""Of the excess while its change of sign is sought."""
SEARCH_STEP = 1.25
"""Ratio of the speeds at which the search looks."""
LARGEST_STEP = 0.5
"""Of the excess beside a crossing; more is a jump (`stability_excess` goes from -2 to 2)."""
LARGEST_RISE = 0.05
"""Of the excess between two speeds of which it falls beside a crossing; more, and it goes to and fro.

Assumption: a soft bore whose thresholds in two frames differ by 2 % rises by 0.07 in one, by 1.6 in the other."""


@dataclass(frozen=True)
class Threshold:
    """Where stability changes over the speed, rad/s, or why no such speed is known.

    `speed` is None where no speed within the search changes what the journal does, where it `jumps`, for the films
    then leave open at which speed, and where a film on the way there `is_lost`: none was found.
    """

    speed: float | None = None
    jumps: bool = False
    is_lost: bool = False


@dataclass(frozen=True)
class Whirl:
    """Stability of a rotor in this film: kg, ratio to the speed, rad/s.

    Without `elastic` the rotor is rigid; with it, the same for the shaft as stiff as the case says.
    """

    stable: StableMasses
    frequency_ratio: float
    rotor_mass: float
    threshold: Threshold
    elastic: ElasticWhirl | None = None


@dataclass(frozen=True)
class ElasticWhirl:
    """Stable masses in kg and threshold of a rotor on its elastic shaft."""

    stable: StableMasses
    threshold: Threshold


def rotor_mass(given: float | None, load: float) -> float:
    """Mass of the rotor in kg: the one given, or that whose weight is the load in N."""
    return given if given is not None else load / STANDARD_GRAVITY


def stability_excess(reserve: float) -> float:
    """How far a rotor is from its threshold: positive where it is stable, smooth about zero, never infinite.

    Parameters
    ----------
    reserve : float
        `babbitt.reynolds.stability.routh.StableMasses.reserve` of its mass; no number where no film is found, and
        none comes of it.
    """
    if math.isnan(reserve):
        return math.nan
    if 0.0 < reserve < math.inf:
        return math.atan(math.log(reserve))
    return math.copysign(2.0, reserve - 1.0)


def crossing(excess: Callable[[float], float], speed: float, blur: float = 0.0) -> Threshold:
    """Speed at which a function turns from positive to negative: above a stable speed, below an unstable one.

    No speed where there is none in sight, or the function has no value on the way. Values up to ``blur`` count as
    zero. Where there is such a blur a function that jumps past zero, or goes to and fro on the way there, has no
    crossing.
    All are rounded far below what a grid leaves open: where they jump, round-off would decide which of the
    neighbouring crossings is found.
    """

    looked: dict[float, float] = {}

    def seen(at: float) -> float:
        value = round(excess(at), EXCESS_DECIMALS)
        looked[at] = 0.0 if abs(value) <= blur else value
        return looked[at]

    here = seen(speed)
    if math.isnan(here):
        return Threshold(is_lost=True)
    step = SEARCH_STEP if here > 0.0 else 1.0 / SEARCH_STEP
    near, earlier = speed, None
    last = speed * (FASTEST if here > 0.0 else 1.0 / FASTEST)
    while near != last:
        far = min(near * step, last) if here > 0.0 else max(near * step, last)
        there = seen(far)
        if math.isnan(there):
            return Threshold(is_lost=True)
        if here * there <= 0.0:
            root = find_root(seen, min(near, far), max(near, far), relative=SPEED_TOLERANCE, beyond=earlier)
            if not root.converged:
                return Threshold(is_lost=any(map(math.isnan, looked.values())))
            if blur > 0.0 and _is_rough(seen, looked, (min(near, far), root.value, max(near, far))):
                return Threshold(jumps=True)
            return Threshold(root.value)
        earlier, near, here = (near, here), far, there
    return Threshold()


def _is_rough(
    seen: Callable[[float], float], looked: dict[float, float], ends: tuple[float, float, float]
) -> bool:
    """Whether values that were looked at jump at a root, or rise on the way to it; low end, root, high end."""
    low, root, high = ends
    beside = (seen(root * (1.0 - SPEED_TOLERANCE)), seen(root * (1.0 + SPEED_TOLERANCE)))
    way = [looked[at] for at in sorted(looked) if low <= at <= high]
    rises = max(after - before for before, after in pairwise(way))
    return not max(map(abs, beside)) <= LARGEST_STEP or rises > LARGEST_RISE
