"""The line over the stiffness of its ring and over its speed."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

from babbitt.kinds.shaft_line.losses import separation
from babbitt.kinds.shaft_line.model import LineOperation, LineState, state_of
from babbitt.kinds.shaft_line.natural import undamped_frequencies
from babbitt.kinds.shaft_line.resonance import NEAR, Resonances, lobes_of, resonances_about
from babbitt.kinds.thrust.failures import NoPadFilmError
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.work import WorkBoundError

__all__ = ["CampbellPoint", "RingPoint", "barred_ranges", "ring_point", "ring_sweep", "speed_sweep", "usual_rings"]

STEPS = 40
"""Into which the way between two speeds of a map is divided to find where a barred range begins and ends."""
SHOWN_ABOVE = 1.3
"""Frequency up to which damped modes are shown, over that of the fastest excitation."""
MODES = 4


@dataclass(frozen=True)
class RingPoint:
    """The line on a ring of one stiffness.

    Attributes
    ----------
    stiffness : float
        N/m per pad.
    runout, ripple, bound : float
        L1 of runout alone, of ripple alone, of both.
    film_amplitude : float
        Of the film at a pivot from runout, m.
    thinnest_film : float
        Dynamic, bound, m.
    first_frequency : float
        rad/s.
    largest_over_mean : float
        Static.
    """

    stiffness: float
    runout: float
    ripple: float
    bound: float
    film_amplitude: float
    thinnest_film: float
    first_frequency: float
    largest_over_mean: float


def ring_point(duty: LineOperation, films: LoadCurve, stiffness: float) -> RingPoint:
    """Solve the line on a ring of one stiffness (N/m)."""
    state = state_of(duty.with_ring(stiffness), films)
    first = undamped_frequencies(duty.line, state.pads, 1)[0]
    return RingPoint(
        stiffness,
        state.loss_of(runout=True),
        state.loss_of(runout=False),
        state.losses.mean_bound,
        state.runout_film_amplitude,
        float(state.film.thinnest_bound.min()),
        first,
        state.share.largest_over_mean,
    )


def ring_sweep(duty: LineOperation, films: LoadCurve, stiffnesses: Sequence[float]) -> tuple[RingPoint, ...]:
    """Solve the line on rings of several stiffnesses (N/m per pad).

    The points stand in the order of the stiffnesses. Those on which pads find no film are left out, and what is
    left when the work that is allowed ends: solved from the stiffest on, so that one which reaches a loss is the
    stiffest that does.
    """
    points = {}
    for stiffness in sorted(stiffnesses, reverse=True):
        with suppress(NoPadFilmError, WorkBoundError):
            points[stiffness] = ring_point(duty, films, stiffness)
    return tuple(points[stiffness] for stiffness in stiffnesses if stiffness in points)


@dataclass(frozen=True, eq=False)
class CampbellPoint:
    """The line at one speed.

    Attributes
    ----------
    speed : float
        rad/s.
    frequencies : tuple of float
        Undamped, rad/s, on the stiffness of films at rest.
    resonances : Resonances
        About each excitation.
    state : LineState
    """

    speed: float
    frequencies: tuple[float, ...]
    resonances: Resonances
    state: LineState


def speed_sweep(
    duty: LineOperation, films_at: Callable[[LineOperation], LoadCurve], speeds: Sequence[float]
) -> tuple[CampbellPoint, ...]:
    """Solve the line at several speeds, thrust and ripple growing with the square of the speed.

    Speeds at which pads find no film are left out, and what is left when the work that is allowed ends.

    Parameters
    ----------
    duty : LineOperation
        At the speed at which its thrust holds.
    films_at : callable
        Gives the films of a duty: at a fixed viscosity, or by the heat balance.
    speeds : sequence of float
        rad/s.
    """
    points = []
    orders = [one.order for one in duty.thrusts if one.amplitude > 0.0]
    orders += [one.order for one in duty.runouts if one.amplitude > 0.0]
    shown = SHOWN_ABOVE * max(orders, default=0.0) * max(speeds, default=0.0)
    for speed in speeds:
        at = duty.at_speed(speed)
        with suppress(NoPadFilmError, WorkBoundError):
            state = state_of(at, films_at(at))
            natural = undamped_frequencies(duty.line, state.pads, MODES)
            points.append(CampbellPoint(speed, natural, resonances_about(state, shown), state))
    return tuple(points)


def barred_ranges(points: Sequence[CampbellPoint]) -> tuple[tuple[float, float, float], ...]:
    """Speeds at which an excitation comes within 20 % of a resonance: from, to (rad/s), order.

    Interpolated between the points of a sweep; a range that begins or ends with the sweep is cut there.
    """
    causes = sorted(
        {
            (part.harmonic.order, lobes_of(part.harmonic))
            for point in points
            for part in point.state.forced.parts
            if part.harmonic.amplitude > 0.0
        }
    )
    found = []
    for order, lobes in causes:
        low = high = 0.0
        for first, second in itertools.pairwise(points):
            pairs = _followed(first.resonances.frequencies(lobes), second.resonances.frequencies(lobes))
            for step in range(STEPS + 1):
                part = step / STEPS
                speed = first.speed + (second.speed - first.speed) * part
                met = any(separation(order * speed, a + (b - a) * part) < NEAR for a, b in pairs)
                if met:
                    low, high = low or speed, speed
                elif low:
                    found.append((low, high, order))
                    low = 0.0
        if low:
            found.append((low, high, order))
    return tuple(found)


def _followed(first: Sequence[float], second: Sequence[float]) -> list[tuple[float, float]]:
    """Resonances at two neighbouring speeds in pairs; one that has no like at the other is taken to stay."""
    pairs, left = [], list(second)
    for frequency in first:
        near = min(left, key=lambda one: abs(one / frequency - 1.0), default=None)
        if near is not None and abs(near / frequency - 1.0) < NEAR:
            left.remove(near)
            pairs.append((frequency, near))
        else:
            pairs.append((frequency, frequency))
    return pairs + [(one, one) for one in left]


def usual_rings(duty: LineOperation, state: LineState, number: int = 40) -> tuple[float, ...]:
    """Stiffnesses from a hundredth of the film to a hundred times it, N/m per pad, as many as asked for."""
    film = float(state.pads.static_stiffness.mean())
    low, high = math.log(0.01 * film), math.log(100.0 * film)
    return tuple(math.exp(low + (high - low) * k / (number - 1)) for k in range(number))
