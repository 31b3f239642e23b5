"""Pads that take in the hot oil of their neighbour: a bearing whose pads differ.

`babbitt.kinds.thrust.thermal_films` feeds every pad with the oil of a pad like itself. Under a tilt of the
housing, or with
pads of different heights, the oil comes from the pad before:

    Q_in,i T_in,i = lambda Q_t,i-1 T_t,i-1 + (Q_in,i - lambda Q_t,i-1) T_s.

Heights and temperatures of all pads are found together: every pad is solved at its inlet temperature, and the
thrust is shared on stiffnesses near the heights until nothing changes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.equilibrium import UnbalancedPadError
from babbitt.kinds.thrust.failures import UnsettledPadError
from babbitt.kinds.thrust.pad_attitude import PadAttitude, attitude_at_rest
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import PadState, condensed
from babbitt.kinds.thrust.thermal import InitialState, PadOil, thermal_pad
from babbitt.kinds.thrust.thermal_films import ThermalLoadCurve
from babbitt.numerics.anderson import AndersonOptions, fixed_point

__all__ = ["COMBINED", "MOST_ROUNDS", "Rounds", "common_heights", "mixed_inlets", "share_with_neighbours"]

Array = NDArray[np.float64]

MOST_ROUNDS = 60
SETTLED = 1e-7
"""Change of the heights, over them, and of the inlet temperatures, over 1000 K, at most."""
REPRODUCED = 1e-6
"""The same of the best round of a search that has used up its rounds: films of pads with temperatures of their own
come back no nearer (2e-7 to 1e-6), and a closer end would be chance."""
STRAY = 1e-5
"""The same of that round solved again, from which on its films are others (an assumption)."""
CLOSED = 1e-8
"""Change of the inlet temperatures, K, at which the heat of the bearing is closed."""
STEP = 0.8
"""Share of a new inlet temperature that a round takes."""
FOLLOWING = 0.8
"""Stiffness when temperatures follow over that at frozen temperatures; only the number of rounds depends on it."""
REACH, WARMER = 0.3, 20.0
"""Largest change in a round of a height, over it, and of an inlet temperature, K."""
COMBINED = AndersonOptions(most_evaluations=MOST_ROUNDS, memory=6)
"""How rounds are combined: heat goes round the bearing in small shares; plain ones would follow it for long."""


@dataclass(eq=False)
class Rounds:
    """Rounds in which pads share the thrust and feed each other, as a map of heights and inlet temperatures.

    Attributes
    ----------
    share : Share
        From which the search begins, then of the last round.
    standing : PadAttitude
    mean_film : float or None
        Mean film at the pivots that is kept, m, in place of the thrust.
    films_at : callable
        Films at heights (m) and inlet temperatures (K); None where a pad has none.
    inlets_of : callable
        Inlet temperatures that films give each other, K.
    tolerance : float
        Change of the heights, over them, and of the inlet temperatures, over 1000 K, that ends the search.
    moved, best
        That of the last round, and the least with its heights and inlets.
    """

    share: Share
    standing: PadAttitude
    mean_film: float | None
    films_at: Callable[[Array, Array], tuple[PadState, ...] | None]
    inlets_of: Callable[[tuple[PadState, ...]], Array]
    tolerance: float
    moved: float = math.inf
    best: tuple[float, Array | None] = (math.inf, None)

    def run(self, options: AndersonOptions) -> Share | None:
        """The share at which nothing changes; None where the rounds do not end there."""
        start = np.concatenate([np.log(self.share.heights), 1e-3 * self.inlets_of(self.share.states)])
        found = fixed_point(self._residual, lambda *_: self.moved < self.tolerance, start, options, self._bounded)
        if found.converged:
            return self.share
        least, state = self.best
        if state is None or least > REPRODUCED or self._residual(state) is None:
            return None
        return self.share if self.moved <= STRAY else None

    def _residual(self, state: Array) -> Array | None:
        """Change of the logarithms of the heights and of the inlet temperatures over 1000 K, of which STEP."""
        share = self.share
        heights, inlets = np.exp(state[: share.heights.size]), 1e3 * state[share.heights.size :]
        states = self.films_at(heights, inlets)
        if states is None:
            return None
        loads = np.array([one.load for one in states])
        stiffness = FOLLOWING * np.array([condensed(one, 0.0).real if one.load > 0.0 else 0.0 for one in states])
        thrust = share.thrust if self.mean_film is None else float(loads.sum())
        approach, new = common_heights(
            share.bearing, self.standing, thrust, self.mean_film, heights, loads, stiffness
        )
        warmer = self.inlets_of(states) - inlets
        self.moved = max(float(np.abs(new / heights - 1.0).max()), 1e-3 * float(np.abs(warmer).max()))
        self.share = Share(share.bearing, thrust, approach, heights, loads, states)
        if self.moved < self.best[0]:
            self.best = self.moved, state
        return np.concatenate([np.log(new / heights), 1e-3 * STEP * warmer])

    def _bounded(self, _: Array, move: Array) -> Array:
        bound = np.repeat([REACH, 1e-3 * WARMER], self.share.heights.size)
        return np.clip(move, -bound, bound)


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
        As of `Rounds`.

    Raises
    ------
    UnsettledPadError
        If the pads go on to change each other.
    """
    bearing, oil = share.bearing, films.oil
    stands = attitude_at_rest(bearing) if standing is None else standing
    leans = [stands.lean(place) for place in range(bearing.number)]
    pads = [_first(films, state) for state in share.states]

    def films_at(heights: Array, inlets: Array) -> tuple[PadState, ...] | None:
        nonlocal pads
        try:
            pads = [
                thermal_pad(
                    films.pad, _fed_at(oil, inlet), films.angular_speed, float(height), None, pad, lean=lean
                )
                for inlet, height, pad, lean in zip(inlets, heights, pads, leans, strict=True)
            ]
        except UnbalancedPadError:
            return None
        return tuple(pad.state for pad in pads)

    def inlets_of(states: tuple[PadState, ...]) -> Array:
        return _inlets(oil, list(states), bearing.sense)

    found = Rounds(share, stands, mean_film, films_at, inlets_of, tolerance).run(COMBINED)
    if found is None:
        raise UnsettledPadError
    return replace(found, states=_closed(oil, pads, bearing.sense))


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
