"""How pads share a steady thrust: tilt of the housing, heights of the pads, and a ring that gives way."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.design.roots import bracketed_root
from babbitt.notices import InputError
from babbitt.thrust.bearing import ThrustBearing
from babbitt.thrust.carrying import Carrying
from babbitt.thrust.face import SteppedFace
from babbitt.thrust.failures import OverloadedPadsError, PadsTouchError
from babbitt.thrust.state import PadState

__all__ = ["Share", "share_at_film", "share_of"]

Array = NDArray[np.float64]

NEWTON_STEPS = 80
SETTLED = 1e-12
"""Of a film; the step after it would change nothing, since Newton's method squares the error."""
CARRIED = 2e-3
"""Of the thrust: what tables of films may miss."""
THINNEST = 1e-9
"""Least film of the search, m."""


@dataclass(frozen=True, eq=False)
class Share:
    """Static loads and films.

    Attributes
    ----------
    bearing : ThrustBearing
    thrust : float
        F0, N.
    approach : float
        s: where the collar stands, m.
    heights, loads : ndarray, shape (z,)
        Films at the pivots, m, and loads of the pads, N.
    states : tuple of PadState
        The film of each pad.
    """

    bearing: ThrustBearing
    thrust: float
    approach: float
    heights: Array
    loads: Array
    states: tuple[PadState, ...]

    @property
    def mean_load(self) -> float:
        """F0/z, N."""
        return self.thrust / self.bearing.number

    @property
    def collar_moment(self) -> float:
        """Moment of uneven pad loads on the collar, N m: size of the sum of W_i r_p exp(j gamma_i)."""
        turned = self.loads * np.exp(1j * self.bearing.angles)
        return float(self.bearing.pad.pivot_radius * abs(turned.sum()))

    @property
    def largest_over_mean(self) -> float:
        """Largest pad load over the mean."""
        return float(self.loads.max() / self.mean_load)


def heights_at(films: Carrying, ring_stiffness: float, positions: Array) -> Array:
    """Films of pads over a ring: the roots of h - W(h)/c = position (S2), one each since W falls with h.

    Newton's method on ln h, kept between bounds.
    """
    if math.isinf(ring_stiffness):
        return np.maximum(positions, THINNEST)
    reach = np.cbrt(float(films.load(np.array(1e-4))) * 1e-8 / ring_stiffness)
    low = np.full(positions.shape, THINNEST)
    high = np.maximum(positions, 0.0) + reach + THINNEST
    while np.any(short := high - films.load(high) / ring_stiffness < positions):
        high = np.where(short, 2.0 * high, high)
    height = np.sqrt(low * high)
    height = np.where(positions > 0.3 * reach, high, np.maximum(height, 0.5 * reach))
    for _ in range(NEWTON_STEPS):
        miss = height - films.load(height) / ring_stiffness - positions
        high, low = np.where(miss > 0.0, height, high), np.where(miss > 0.0, low, height)
        new = height - miss / (1.0 - films.slope(height) / ring_stiffness)
        new = np.where((new >= low) & (new <= high), new, 0.5 * (low + high))
        if np.all(np.abs(new - height) <= SETTLED * new):
            return np.asarray(new)
        height = new
    return np.asarray(height)


def share_of(films: Carrying, bearing: ThrustBearing, thrust: float, departures: Array | None = None) -> Share:
    """Position of the collar at which the pads together carry the thrust (S3).

    Parameters
    ----------
    films : Carrying
        Of one pad.
    bearing : ThrustBearing
    thrust : float
        F0, N, positive.
    departures : ndarray, optional
        What is added to the film under each pad, m; those of the bearing when omitted.

    Raises
    ------
    InputError
        E201 if the thrust is not positive.
    OverloadedPadsError
        If the pads carry less, however thin their films.
    """
    if not (math.isfinite(thrust) and thrust > 0.0):
        raise InputError("E201", f"thrust is {thrust:g} N; it must be positive.")
    away = bearing.departures() if departures is None else departures
    c = bearing.ring_stiffness
    if float(np.ptp(away)) == 0.0:
        return _evenly(films, bearing, thrust, float(away[0]))
    most = float(films.load(np.full(bearing.number, THINNEST)).sum())
    _require_carried(films, thrust, most)
    mean = films.height_for(thrust / bearing.number)

    def excess(approach: float) -> float:
        heights = heights_at(films, c, approach + away)
        return math.log(float(films.load(heights).sum()) / thrust)

    yielding = 0.0 if math.isinf(c) else thrust / c
    low, high = -float(away.max()) - yielding - mean, mean - float(away.min())
    if math.isinf(c):  # the closest pad alone carries all at sqrt(A/F0)
        low = -float(away.min()) + 0.5 * films.height_for(thrust)
        low = min(low, high)
    while excess(low) < 0.0:
        low -= mean + yielding
    while excess(high) > 0.0:
        high += mean + yielding
    approach = bracketed_root(excess, low, high)
    heights = heights_at(films, c, approach + away)
    states = _states(films, heights)
    loads = np.array([state.load for state in states])
    _require_carried(films, thrust, float(loads.sum()))
    return Share(bearing, thrust, approach, heights, loads, states)


def share_at_film(films: Carrying, bearing: ThrustBearing, film: float) -> Share:
    """The share at which the films at the pivots have a mean, whatever the ring gives way.

    Parameters
    ----------
    films : Carrying
        Of one pad.
    bearing : ThrustBearing
    film : float
        Mean of the films at the pivots, m, positive.

    Raises
    ------
    PadsTouchError
        If tilt and heights bring a pad on a rigid ring nearer than the mean film.
    """
    away, c = bearing.departures(), bearing.ring_stiffness
    if float(np.ptp(away)) == 0.0:
        heights = np.full(bearing.number, film)
    elif math.isinf(c):
        heights = film + away - away.mean()
        if not float(heights.min()) > 0.0:
            raise PadsTouchError(film, film - float(heights.min()), 1 + int(heights.argmin()))
    else:
        low = -float(away.max())
        high = film - float(away.min())  # there every pad stands farther than the mean film

        def excess(approach: float) -> float:
            return float(heights_at(films, c, approach + away).mean()) - film

        while excess(low) > 0.0:
            low -= film + float(films.load(np.array(film))) / c
        heights = heights_at(films, c, bracketed_root(excess, low, high) + away)
    states = _states(films, heights)
    loads = np.array([state.load for state in states])
    approach = float((heights - loads / c - away).mean())
    return Share(bearing, float(loads.sum()), approach, heights, loads, states)


def _require_carried(films: Carrying, thrust: float, carried: float) -> None:
    """Pads of a face carry no more than a bound, where a table continued goes on."""
    if not carried > (1.0 - CARRIED) * thrust:
        raise OverloadedPadsError(thrust, carried, isinstance(films.pad.face, SteppedFace))


def _evenly(films: Carrying, bearing: ThrustBearing, thrust: float, away: float) -> Share:
    """Pads that all stand alike carry alike."""
    height = films.height_for(thrust / bearing.number)
    state = films.state(height)
    _require_carried(films, thrust, bearing.number * state.load)
    yielding = 0.0 if math.isinf(bearing.ring_stiffness) else state.load / bearing.ring_stiffness
    even = np.ones(bearing.number)
    approach = height - yielding - away
    return Share(bearing, thrust, approach, height * even, state.load * even, (state,) * bearing.number)


def _states(films: Carrying, heights: Array) -> tuple[PadState, ...]:
    """Films at the heights; pads at the same height share one."""
    found: dict[float, PadState] = {}
    states = []
    for height in heights:
        key = float(f"{height:.12e}")
        if key not in found:
            found[key] = films.state(float(height))
        states.append(found[key])
    return tuple(states)
