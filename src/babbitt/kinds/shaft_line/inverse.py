"""What a line can bear: the largest runout, tilt and ripple within all limits, the ring for a film or a load."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, partial

from babbitt.kinds.shaft_line.admissible_amplitude import Excess
from babbitt.kinds.shaft_line.model import LineOperation, LineState, state_of
from babbitt.kinds.shaft_line.sweeps import RingPoint, ring_point
from babbitt.kinds.thrust.failures import NoPadFilmError
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.sharing import share_of
from babbitt.kinds.thrust.work import WorkBoundError
from babbitt.numerics.roots import bracketed_root

__all__ = [
    "Admissible",
    "AdmissibleAmplitude",
    "admissible",
    "ring_for_loss",
]

FIRST, WIDEST = 0.25, 2.0**12
"""Factors from which and up to which a limit is sought, each twice the one before."""
RELATIVE = 1e-6
NO_FILM: Excess = (1e6, "")
"""Stands for a bearing without a film."""
SHOWN_LENGTH, SHOWN_FORCE = 1e-7, 100.0
"""Steps in which amplitudes are given, m and N: what is found is rounded down, so that all limits are kept."""
SHORTER = 50
"""Steps by which what is found is lowered at most, until it keeps them."""

LimitMargin = Callable[[LineState], Excess]


@dataclass(frozen=True)
class AdmissibleAmplitude:
    """How large one cause may be with the others as they are.

    Attributes
    ----------
    largest : float
        Largest amplitude that keeps all limits, rounded down; 0 where none does, infinite where no amplitude was
        found that misses one.
    code : str
        Of the check that is missed first beyond it; empty where the pads find no film, or nothing is missed.
    sought : float
        Amplitude up to which a limit was sought.
    """

    largest: float
    code: str
    sought: float


@dataclass(frozen=True)
class Admissible:
    """Largest amplitudes within all limits, each with the others as they are.

    Attributes
    ----------
    runout : AdmissibleAmplitude or None
        Of the face at the pivot radius, m; of several waves the first, all in proportion. None without runout.
    tilt : AdmissibleAmplitude
        Of the housing at the outer radius of the pads, m.
    ripple : AdmissibleAmplitude or None
        Of the thrust, N, as the runout. None without ripple.
    """

    runout: AdmissibleAmplitude | None
    tilt: AdmissibleAmplitude
    ripple: AdmissibleAmplitude | None


def admissible(duty: LineOperation, films: LoadCurve, margin: LimitMargin) -> Admissible:
    """Largest runout, tilt and ripple that keep all limits.

    Parameters
    ----------
    duty : LineOperation
    films : LoadCurve
    margin : callable
        Says by how much a state misses its worst check, see
        `babbitt.kinds.shaft_line.admissible_amplitude.limit_margin`.
    """
    share = share_of(films, duty.bearing, duty.thrust)
    tilt = duty.bearing.tilt.offset or films.height_for(duty.thrust / duty.bearing.number)
    runout = ripple = None
    if duty.runout:
        runout = _largest(
            lambda a: margin(state_of(duty.with_runout(a / duty.runout), films, share)), duty.runout, SHOWN_LENGTH
        )
    if duty.ripple:
        ripple = _largest(
            lambda a: margin(state_of(duty.with_ripple(a / duty.ripple), films, share)), duty.ripple, SHOWN_FORCE
        )
    return Admissible(
        runout, _largest(lambda e: _margin_of(duty.with_tilt(e), films, margin), tilt, SHOWN_LENGTH), ripple
    )


def _margin_of(duty: LineOperation, films: LoadCurve, margin: LimitMargin) -> Excess:
    try:
        return margin(state_of(duty, films))
    except NoPadFilmError:
        return NO_FILM


def _largest(of: Callable[[float], Excess], scale: float, shown: float) -> AdmissibleAmplitude:
    """Largest amplitude from 0 up to which all limits are kept, sought from a scale."""
    of = cache(of)  # the search for the edge begins at two amplitudes that are known
    missed, code = of(0.0)
    if missed > 0.0:
        return AdmissibleAmplitude(0.0, code, 0.0)
    low, high = 0.0, FIRST * scale
    while (found := of(high))[0] <= 0.0:
        low, high = high, 2.0 * high
        if high > WIDEST * scale:
            return AdmissibleAmplitude(math.inf, "", low)
    edge = bracketed_root(lambda a: of(a)[0], low, high, relative=RELATIVE)
    largest = rounded_down(edge, shown)
    for _ in range(SHORTER):
        if of(largest)[0] <= 0.0:
            break
        largest = rounded_down(largest * (1.0 - 2.0 * RELATIVE), shown)
    return AdmissibleAmplitude(largest, _beyond(of, edge, found), high)


def _beyond(of: Callable[[float], Excess], edge: float, found: Excess) -> str:
    """Code of the check that is missed a little beyond the edge."""
    missed, code = of(edge * (1.0 + 10.0 * RELATIVE))
    return code if missed > 0.0 else found[1]


def rounded_down(value: float, step: float) -> float:
    """A positive number rounded down to a step; below one to two digits.

    >>> rounded_down(2.46, 0.1) < 2.4001, rounded_down(0.0129, 1.0)
    (True, 0.012)
    """
    if value < 10.0 * step:
        step = 10.0 ** (math.floor(math.log10(value)) - 1) if value > 0.0 else step
    return float(f"{math.floor(value / step * (1.0 + 1e-12)) * step:.12g}")


def ring_for_loss(
    duty: LineOperation, films: LoadCurve, loss: float, points: Sequence[RingPoint]
) -> RingPoint | None:
    """The stiffest ring on which L1 (bound) falls to ``loss``; None where no ring of a sweep reaches it.

    Where the pads find no film on rings between two of the sweep, or the work that is allowed ends, it is the
    stiffest of those that reach it.

    Parameters
    ----------
    duty : LineOperation
    films : LoadCurve
    loss : float
    points : sequence of RingPoint
        The line on the rings of a sweep, see `babbitt.kinds.shaft_line.sweeps.ring_sweep`.
    """
    at = cache(partial(ring_point, duty, films))
    stiff: RingPoint | None = None
    for point in sorted(points, key=lambda one: one.stiffness, reverse=True):
        if point.bound <= loss:
            if stiff is None:
                return point
            with suppress(NoPadFilmError, WorkBoundError):
                between = (point.stiffness, stiff.stiffness)
                return at(bracketed_root(lambda c: at(c).bound - loss, *between, relative=1e-6))
            return point
        stiff = point
    return None
