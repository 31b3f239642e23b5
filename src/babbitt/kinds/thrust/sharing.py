"""How pads share a steady thrust: tilt of the housing, heights of the pads, and a ring that gives way."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.face import SteppedFace
from babbitt.kinds.thrust.failures import (
    ConcavePadError,
    OverloadedPadsError,
    PadsTouchError,
    TiltedPadAtFilmError,
    TiltedPadError,
    TiltedPadsTouchAtFilmError,
    TiltedPadsTouchError,
)
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.load_sharing import THINNEST, LoadLaw, approach_at_film, approach_under, heights_at
from babbitt.kinds.thrust.pad_attitude import PadAttitude, attitude_at_rest
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.tilt import settled, states_at

__all__ = ["Share", "exactly_shared", "share_at_film", "share_of"]

Array = NDArray[np.float64]

EXACT, MOST_CORRECTIONS = 1e-9, 6
"""Of the thrust: what the loads of interpolated films may miss once they are corrected, and in how many rounds."""
CARRIED = 2e-3
"""Of the thrust: what tables of films may miss."""


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
    def moment(self) -> complex:
        """Sum of the pressures times their levers, N m: real part along the radius of pad 1, imaginary along 90°.

        sum (W_i r_p + M_x,i + j M_y,i) exp(j gamma_i), with the moments of the pads about their pivots, M_y in the
        sense of rotation.
        """
        bearing = self.bearing
        if all(state is self.states[0] for state in self.states):
            return 0j  # pads loaded alike: not what round-off leaves
        moments = np.array([state.moments for state in self.states])
        levers = self.loads * bearing.pad.pivot_radius + moments @ np.array([1.0, 1j * bearing.sense])
        return complex((levers * np.exp(1j * bearing.angles)).sum())

    @property
    def collar_moment(self) -> float:
        """Moment of uneven pads on the collar, N m, the size of `moment`."""
        return abs(self.moment)

    @property
    def largest_over_mean(self) -> float:
        """Largest pad load over the mean."""
        return float(self.loads.max() / self.mean_load)


def share_of(
    films: LoadCurve, bearing: ThrustBearing, thrust: float, standing: PadAttitude | None = None
) -> Share:
    """Position of the collar at which the pads together carry the thrust (S3).

    Parameters
    ----------
    films : LoadCurve
        Of one pad.
    bearing : ThrustBearing
    thrust : float
        F0, N, positive.
    standing : PadAttitude, optional
        How the pads stand to the collar; as the bearing has it at rest when omitted.

    Raises
    ------
    InputError
        E201 if the thrust is not positive.
    OverloadedPadsError
        If the pads carry less, however thin their films.
    TiltedPadsTouchError, TiltedPadError
        See `babbitt.kinds.thrust.tilt.settled`.
    """
    if not (math.isfinite(thrust) and thrust > 0.0):
        raise InputError("E201", f"thrust is {thrust:g} N; it must be positive.")
    stands = attitude_at_rest(bearing) if standing is None else standing
    away, c = stands.departures, bearing.ring_stiffness
    if stands.is_even:
        return _evenly(films, bearing, thrust, float(away[0]))
    thinnest = np.full(bearing.number, THINNEST)
    _require_carried(films, thrust, float(films.load(thinnest).sum()))
    mean = films.height_for(thrust / bearing.number)

    def place(law: LoadLaw) -> Array:
        if not float(law.load(thinnest).sum()) > thrust:
            return thinnest
        return heights_at(law, c, approach_under(law, c, away, thrust, mean) + away)

    heights, states = _found(films, stands, place(films), place)
    loads = np.array([state.load for state in states])
    _require_carried(films, thrust, float(loads.sum()))
    return Share(bearing, thrust, _approach(heights, loads, bearing, away), heights, loads, states)


def exactly_shared(films: LoadCurve, share: Share) -> Share:
    """A share made exact: its films are solved, and the load curve is drawn through them.

    Parameters
    ----------
    films : LoadCurve
    share : Share
        Of pads that stand level.

    Returns
    -------
    Share
        Whose loads make up the thrust to 1e-9, where a few rounds reach that.
    """
    bearing, stands = share.bearing, attitude_at_rest(share.bearing)
    if stands.is_even or stands.is_tilted:
        return share
    c, away = bearing.ring_stiffness, stands.departures
    for _ in range(MOST_CORRECTIONS):
        if abs(float(share.loads.sum()) / share.thrust - 1.0) < EXACT:
            break
        law = _Corrected(films, share.loads / films.load(share.heights))
        mean = films.height_for(share.mean_load)
        heights = heights_at(law, c, approach_under(law, c, away, share.thrust, mean) + away)
        states = states_at(films, heights, stands, share.states)
        loads = np.array([state.load for state in states])
        share = Share(bearing, share.thrust, _approach(heights, loads, bearing, away), heights, loads, states)
    return share


@dataclass(frozen=True, eq=False)
class _Corrected:
    """Loads of a curve times a factor for each pad."""

    films: LoadCurve
    factors: Array

    def load(self, height: Array) -> Array:
        """N."""
        return np.asarray(self.factors * self.films.load(height))

    def slope(self, height: Array) -> Array:
        """N/m."""
        return np.asarray(self.factors * self.films.slope(height))


def share_at_film(films: LoadCurve, bearing: ThrustBearing, film: float) -> Share:
    """The share at which the films at the pivots have a mean, whatever the ring gives way.

    Parameters
    ----------
    films : LoadCurve
        Of one pad.
    bearing : ThrustBearing
    film : float
        Mean of the films at the pivots, m, positive.

    Raises
    ------
    PadsTouchError
        If tilt and heights bring a pad on a rigid ring nearer than the mean film.
    TiltedPadsTouchAtFilmError, TiltedPadAtFilmError
        If faces that lean touch the collar, or a pad does not converge.
    """
    stands = attitude_at_rest(bearing)
    away, c = stands.departures, bearing.ring_stiffness

    def place(law: LoadLaw) -> Array:
        if math.isinf(c):
            return np.asarray(film + away - away.mean())
        return heights_at(law, c, approach_at_film(law, c, away, film) + away)

    heights = np.full(bearing.number, film) if stands.is_even else place(films)
    if not float(heights.min()) > 0.0:
        raise PadsTouchError(film, film - float(heights.min()), 1 + int(heights.argmin()))
    try:
        heights, states = _found(films, stands, heights, place)
    except TiltedPadsTouchError as touching:
        raise TiltedPadsTouchAtFilmError(touching.pad, film) from None
    except TiltedPadError as restless:
        raise TiltedPadAtFilmError(restless.pad, film, restless.thinnest) from None
    loads = np.array([state.load for state in states])
    return Share(bearing, float(loads.sum()), _approach(heights, loads, bearing, away), heights, loads, states)


def _found(
    films: LoadCurve, stands: PadAttitude, heights: Array, place: Callable[[LoadLaw], Array]
) -> tuple[Array, tuple[PadState, ...]]:
    """Heights and films of the pads, from the heights at which level ones share."""
    if stands.is_tilted:
        return settled(films, stands, heights, place)
    return heights, states_at(films, heights, stands)


def _approach(heights: Array, loads: Array, bearing: ThrustBearing, away: Array) -> float:
    """s of h_i - W_i/c = s + e_i, m."""
    return float((heights - loads / bearing.ring_stiffness - away).mean())


def _require_carried(films: LoadCurve, thrust: float, carried: float) -> None:
    """Pads of a face carry no more than a bound, where a table continued goes on."""
    if not carried > (1.0 - CARRIED) * thrust:
        raise OverloadedPadsError(thrust, carried, isinstance(films.pad.face, SteppedFace))


def _evenly(films: LoadCurve, bearing: ThrustBearing, thrust: float, away: float) -> Share:
    """Pads that all stand alike carry alike."""
    try:
        height, state = _alone(films, thrust / bearing.number)
    except ConcavePadError as failure:
        raise ConcavePadError(failure.crown, failure.most, thrust, bearing.number) from None
    _require_carried(films, thrust, bearing.number * state.load)
    yielding = 0.0 if math.isinf(bearing.ring_stiffness) else state.load / bearing.ring_stiffness
    even = np.ones(bearing.number)
    approach = height - yielding - away
    return Share(bearing, thrust, approach, height * even, state.load * even, (state,) * bearing.number)


@lru_cache(maxsize=16)
def _alone(films: LoadCurve, load: float) -> tuple[float, PadState]:
    """Height and film of a pad under a load; kept, since rings of any stiffness load even pads alike."""
    height = films.height_for(load)
    return height, films.state(height)
