"""Pads with one temperature each that take in the hot oil of their neighbour.

    Q_in,i T_in,i = lambda Q_t,i-1 T_t,i-1 + (Q_in,i - lambda Q_t,i-1) T_s.

Of a neighbour that sends off more than the leading edge draws in, only as much as it draws in is taken. Heights
and temperatures are found together, as `babbitt.kinds.thrust.neighbours` does for films whose temperature varies.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.balanced_films import BalancedFilms
from babbitt.kinds.thrust.failures import UnsettledFeedError
from babbitt.kinds.thrust.neighbours import COMBINED, MOST_ROUNDS, Rounds, mixed_inlets
from babbitt.kinds.thrust.pad_attitude import PadAttitude, attitude_at_rest
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import PadState

__all__ = ["share_of_fed_pads"]

Array = NDArray[np.float64]

SETTLED = 1e-9
"""Change of the heights, over them, and of the inlet temperatures, over 1000 K: heat is then closed to 1e-8."""
RETURNING = replace(COMBINED, least_damping=COMBINED.damping, most_failures=MOST_ROUNDS)
"""Rounds that go half-way back from where a pad has no film."""


def share_of_fed_pads(
    films: BalancedFilms, share: Share, mean_film: float | None = None, standing: PadAttitude | None = None
) -> Share:
    """The share of pads that take in the oil of the pad before.

    Parameters
    ----------
    films : BalancedFilms
    share : Share
        Of pads that take in that of their like, from which the search begins.
    mean_film : float, optional
        Mean film at the pivots that is kept, m, in place of the thrust.
    standing : PadAttitude, optional
        How the pads stand to the collar; as the bearing has it at rest when omitted.

    Raises
    ------
    UnsettledFeedError
        If the pads go on to change each other.
    ThermalRunawayError
    """
    bearing, states = share.bearing, share.states
    stands = attitude_at_rest(bearing) if standing is None else standing

    def films_at(heights: Array, inlets: Array) -> tuple[PadState, ...] | None:
        nonlocal states
        try:
            states = tuple(
                films.fed(float(height), float(inlet), stands.lean(place), states[place])
                for place, (height, inlet) in enumerate(zip(heights, inlets, strict=True))
            )
        except InputError:  # a pad that leans has no balance so near
            return None
        return states

    def inlets_of(states: tuple[PadState, ...]) -> Array:
        return _inlets(films, states, bearing.sense)

    found = Rounds(share, stands, mean_film, films_at, inlets_of, SETTLED).run(RETURNING)
    if found is None:
        raise UnsettledFeedError
    return found


def _inlets(films: BalancedFilms, states: tuple[PadState, ...], sense: float) -> Array:
    """Temperatures of the mixtures that the pads take in, K."""
    leaving = np.array([state.trailing_flow for state in states])
    entering = leaving + np.array([state.side_flow for state in states])
    sent = np.array([state.balance.trailing for state in states if state.balance is not None])
    balance = films.balance
    return mixed_inlets(balance.carry_over * leaving, sent, entering, balance.supply_temperature, sense)
