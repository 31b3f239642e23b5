"""The line over the stiffness of its ring and over its speed."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

from babbitt.shaft_line.model import LineDuty, LineState, state_of
from babbitt.shaft_line.natural import undamped_frequencies
from babbitt.thrust.carrying import Carrying
from babbitt.thrust.failures import NoPadFilmError

__all__ = ["CampbellPoint", "RingPoint", "barred_ranges", "ring_point", "ring_sweep", "speed_sweep", "usual_rings"]

BARRED_WITHIN = 0.2
"""Relative distance from a natural frequency that a barred speed range covers."""
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


def ring_point(duty: LineDuty, films: Carrying, stiffness: float) -> RingPoint:
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


def ring_sweep(duty: LineDuty, films: Carrying, stiffnesses: Sequence[float]) -> tuple[RingPoint, ...]:
    """Solve the line on rings of several stiffnesses (N/m per pad); without those on which pads find no film."""
    points = []
    for stiffness in stiffnesses:
        with suppress(NoPadFilmError):
            points.append(ring_point(duty, films, stiffness))
    return tuple(points)


@dataclass(frozen=True, eq=False)
class CampbellPoint:
    """The line at one speed.

    Attributes
    ----------
    speed : float
        rad/s.
    frequencies : tuple of float
        Undamped, rad/s.
    state : LineState
    """

    speed: float
    frequencies: tuple[float, ...]
    state: LineState


def speed_sweep(
    duty: LineDuty, films_at: Callable[[LineDuty], Carrying], speeds: Sequence[float]
) -> tuple[CampbellPoint, ...]:
    """Solve the line at several speeds, thrust and ripple growing with the square of the speed.

    Speeds at which pads find no film are left out.

    Parameters
    ----------
    duty : LineDuty
        At the speed at which its thrust holds.
    films_at : callable
        Gives the films of a duty: at a fixed viscosity, or by the heat balance.
    speeds : sequence of float
        rad/s.
    """
    points = []
    for speed in speeds:
        at = duty.at_speed(speed)
        with suppress(NoPadFilmError):
            state = state_of(at, films_at(at))
            points.append(
                CampbellPoint(
                    speed,
                    undamped_frequencies(duty.line, state.pads, MODES),
                    state,
                )
            )
    return tuple(points)


def barred_ranges(points: Sequence[CampbellPoint]) -> tuple[tuple[float, float, float], ...]:
    """Speeds at which an excitation comes within 20 % of the first natural frequency: from, to (rad/s), order.

    Interpolated between the points of a sweep; a range that begins or ends with the sweep is cut there.
    """
    orders = sorted({part.harmonic.order for point in points for part in point.state.forced.parts})
    found = []
    for order in orders:
        inside: list[float] = []
        for first, second in itertools.pairwise(points):
            for step in range(21):
                speed = first.speed + (second.speed - first.speed) * step / 20.0
                natural = first.frequencies[0] + (second.frequencies[0] - first.frequencies[0]) * step / 20.0
                if abs(order * speed / natural - 1.0) < BARRED_WITHIN:
                    inside.append(speed)
        if inside:
            found.append((min(inside), max(inside), order))
    return tuple(found)


def usual_rings(duty: LineDuty, state: LineState, number: int = 40) -> tuple[float, ...]:
    """Stiffnesses from a hundredth of the film to a hundred times it, N/m per pad, as many as asked for."""
    film = float(state.pads.static_stiffness.mean())
    low, high = math.log(0.01 * film), math.log(100.0 * film)
    return tuple(math.exp(low + (high - low) * k / (number - 1)) for k in range(number))
