"""Pads that take in the hot oil of their neighbour: a bearing whose pads differ.

`babbitt.kinds.thrust.thermal_films` feeds every pad with the oil of a pad like itself. Under a tilt of the
housing, or with
pads of different heights, the oil comes from the pad before:

    Q_in,i T_in,i = lambda Q_t,i-1 T_t,i-1 + (Q_in,i - lambda Q_t,i-1) T_s.

Heights and temperatures of all pads are found together: every pad is solved at its inlet temperature, and the
thrust is shared on stiffnesses near the heights until nothing changes.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.equilibrium import UnbalancedPadError
from babbitt.kinds.thrust.failures import UnsettledPadError
from babbitt.kinds.thrust.pad_attitude import PadAttitude, attitude_at_rest
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import PadState, condensed
from babbitt.kinds.thrust.thermal import InitialState, PadOil, warm_pad
from babbitt.kinds.thrust.thermal_films import ThermalLoadCurve

__all__ = ["Mixing", "common_heights", "mixed_inlets", "share_with_neighbours"]

Array = NDArray[np.float64]

MOST_ROUNDS = 60
SETTLED = 1e-7
"""Change of the heights, over them, and of the inlet temperatures, over 1000 K, at most."""
CLOSED = 1e-8
"""Change of the inlet temperatures, K, at which the heat of the bearing is closed."""
STEP = 0.8
"""Share of a new inlet temperature that a round takes."""
FOLLOWING = 0.8
"""Stiffness when temperatures follow over that at frozen temperatures; only the number of rounds depends on it."""
REACH, WARMER = 0.3, 20.0
"""Largest change in a round of a height, over it, and of an inlet temperature, K."""
REMEMBERED = 6
"""Rounds from whose changes the next one is chosen."""


class Mixing:
    """Heights and inlet temperatures of the next round, from the changes of the last ones (D. G. Anderson, 1965).

    Heat goes round the bearing in small shares, and plain rounds would follow it for long.
    """

    def __init__(self) -> None:
        self._results: list[Array] = []
        self._changes: list[Array] = []

    def forget(self) -> None:
        """Begin anew, where the last round led nowhere."""
        self._results.clear()
        self._changes.clear()

    def following(self, heights: Array, new: Array, inlets: Array, mixed: Array) -> tuple[Array, Array]:
        """Those of the next round.

        Parameters
        ----------
        heights, new : ndarray, shape (z,)
            Of this round and what it gives, m.
        inlets, mixed : ndarray, shape (z,)
            Of this round and what it gives, K.
        """
        result = np.concatenate([np.log(new), 1e-3 * mixed])
        self._results.append(result)
        self._changes.append(result - np.concatenate([np.log(heights), 1e-3 * inlets]))
        del self._results[: -1 - REMEMBERED], self._changes[: -1 - REMEMBERED]
        if len(self._changes) > 1:
            shares = np.linalg.lstsq(np.diff(self._changes, axis=0).T, self._changes[-1], rcond=1e-10)[0]
            result = result - np.diff(self._results, axis=0).T @ shares
        bounded = np.exp(np.clip(result[: heights.size] - np.log(heights), -REACH, REACH))
        warmer = np.clip(1e3 * result[heights.size :] - inlets, -WARMER, WARMER)
        return np.asarray(heights * bounded), np.asarray(inlets + warmer)


def share_with_neighbours(
    films: ThermalLoadCurve,
    share: Share,
    mean_film: float | None = None,
    standing: PadAttitude | None = None,
    tolerance: float = SETTLED,
) -> Share:
    """The share of pads that take in the oil of the pad before.

    Parameters
    ----------
    films : ThermalLoadCurve
    share : Share
        Of pads that take in that of their like, from which the search begins.
    mean_film : float, optional
        Mean film at the pivots that is kept, m, in place of the thrust.
    standing : PadAttitude, optional
        How the pads stand to the collar; as the bearing has it at rest when omitted.
    tolerance : float
        Change of the heights, over them, and of the inlet temperatures, over 1000 K, that ends the search.

    Raises
    ------
    UnsettledPadError
        If the pads go on to change each other.
    """
    bearing, oil = share.bearing, films.oil
    stands = attitude_at_rest(bearing) if standing is None else standing
    leans = [stands.lean(place) for place in range(bearing.number)]
    pads = [_first(films, state) for state in share.states]
    inlets = _inlets(oil, [pad.state for pad in pads], bearing.sense)
    heights, mixing = share.heights.copy(), Mixing()
    for _ in range(MOST_ROUNDS):
        try:
            pads = [
                warm_pad(films.pad, _fed_at(oil, inlet), films.angular_speed, float(height), None, pad, lean=lean)
                for inlet, height, pad, lean in zip(inlets, heights, pads, leans, strict=True)
            ]
        except UnbalancedPadError:
            raise UnsettledPadError from None
        states = tuple(pad.state for pad in pads)
        loads = np.array([state.load for state in states])
        stiffness = FOLLOWING * np.array([condensed(one, 0.0).real for one in states])
        thrust = share.thrust if mean_film is None else float(loads.sum())
        approach, new = common_heights(bearing, stands, thrust, mean_film, heights, loads, stiffness)
        wanted = _inlets(oil, list(states), bearing.sense)
        moved = max(float(np.abs(new / heights - 1.0).max()), 1e-3 * float(np.abs(wanted - inlets).max()))
        if moved < tolerance:
            return Share(bearing, thrust, approach, heights, loads, _closed(oil, pads, bearing.sense))
        heights, inlets = mixing.following(heights, new, inlets, inlets + STEP * (wanted - inlets))
    raise UnsettledPadError


def _closed(oil: PadOil, pads: list[InitialState], sense: float) -> tuple[PadState, ...]:
    """The pads with their films as they flow, and the heat that goes from one to the next closed."""
    states = [pad.state for pad in pads]
    last = np.zeros(len(pads))
    for _ in range(MOST_ROUNDS):
        inlets = _inlets(oil, states, sense)
        if np.abs(inlets - last).max() < CLOSED:
            break
        last = inlets
        for place, (inlet, pad) in enumerate(zip(inlets, pads, strict=True)):
            states[place] = replace(pad.state, heat=pad.sector.refed(float(inlet)))
    return tuple(states)


def _first(films: ThermalLoadCurve, state: PadState) -> InitialState:
    """The solved pad that is nearest."""
    return min(films.starts, key=lambda start: abs(np.log(start.state.height / state.height)))


def _fed_at(oil: PadOil, inlet: float) -> PadOil:
    """Oil of a pad whose leading edge takes in a mixture of one temperature."""
    at = oil.property_temperature if oil.property_temperature is not None else oil.supply_temperature
    return replace(oil, supply_temperature=float(inlet), carry_over=0.0, property_temperature=at)


def _inlets(oil: PadOil, states: list[PadState], sense: float) -> Array:
    """Temperatures of the mixtures that the pads take in, K."""
    carried = oil.carry_over * np.array([state.trailing_flow for state in states])
    sent = np.array([state.heat.sent if state.heat is not None else oil.supply_temperature for state in states])
    entering = np.array([state.leading_flow for state in states])
    return mixed_inlets(carried, sent, entering, oil.supply_temperature, sense)


def mixed_inlets(carried: Array, sent: Array, entering: Array, cold: float, sense: float) -> Array:
    """Temperatures of mixtures of fresh oil and of what the pads before send on, K.

    Parameters
    ----------
    carried, sent : ndarray, shape (z,)
        Hot oil that every pad sends on, m3/s, and its temperature, K.
    entering : ndarray, shape (z,)
        What every pad takes in, m3/s: of hot oil not more than that.
    cold : float
        Temperature of the fresh oil, K.
    sense : float
        Positive where the pad before is that of the lower number.
    """
    step = 1 if sense > 0.0 else -1
    kept = np.minimum(np.roll(carried, step), entering)
    return np.asarray(cold + kept * (np.roll(sent, step) - cold) / entering)


def common_heights(
    bearing: ThrustBearing,
    stands: PadAttitude,
    thrust: float,
    mean_film: float | None,
    heights: Array,
    loads: Array,
    stiffness: Array,
) -> tuple[float, Array]:
    """Position of the collar and heights at which pads of given stiffness share the thrust.

    From h_i + dh_i - (W_i - k_i dh_i)/c = s + e_i and sum (W_i - k_i dh_i) = F_0, or the mean of h_i + dh_i given.

    Parameters
    ----------
    bearing : ThrustBearing
    stands : PadAttitude
    thrust : float
        F_0, N.
    mean_film : float or None
        Given in place of the thrust, m.
    heights, loads, stiffness : ndarray, shape (z,)
        h_i m, W_i N, k_i N/m.
    """
    giving = 1.0 + stiffness / bearing.ring_stiffness
    at_rest = heights - loads / bearing.ring_stiffness - stands.departures
    together = stiffness / giving
    if mean_film is None:
        approach = float((loads.sum() - thrust + together @ at_rest) / together.sum())
    else:
        missing = mean_film * heights.size - heights.sum()
        approach = float((missing + (at_rest / giving).sum()) / (1.0 / giving).sum())
    change = (approach - at_rest) / giving
    return approach, heights + np.clip(change, -REACH * heights, REACH * heights)
