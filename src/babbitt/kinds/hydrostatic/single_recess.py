"""Pads with one recess: state at a gap or under a load, stiffness and damping, by closed forms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.closed_forms import Lands
from babbitt.kinds.hydrostatic.gap_search import gap_for_load
from babbitt.kinds.hydrostatic.impedance import static_coefficients
from babbitt.kinds.hydrostatic.network import Feeding, NetworkState, solve_network
from babbitt.reynolds.recess.recess_film import RecessResponse

__all__ = ["WIDEST", "PadState", "gap_under", "pad_at"]

Array = NDArray[np.float64]
TYPICAL, WIDEST = 3e-5, 1.0
"""Gaps at which the search begins and ends, m."""


@dataclass(frozen=True, eq=False)
class PadState:
    """A pad at a gap.

    Attributes
    ----------
    lands : Lands
    gap : float
        m.
    response : RecessResponse
        With one motion, z.
    network : NetworkState
    """

    lands: Lands
    gap: float
    response: RecessResponse
    network: NetworkState

    @property
    def load(self) -> float:
        """N."""
        return float(self.response.force[0])

    @property
    def recess_pressure(self) -> float:
        """Gauge, Pa."""
        return float(self.network.pressures[0])

    @property
    def flow(self) -> float:
        """m3/s."""
        return float(self.network.flows[0])


def pad_at(lands: Lands, feeding: Feeding, viscosity: float, gap: float) -> PadState:
    """State of a pad at a gap.

    Parameters
    ----------
    lands : Lands
    feeding : Feeding
        With one restrictor.
    viscosity : float
        Of the film, Pa s.
    gap : float
        m.

    Returns
    -------
    PadState
    """
    conductance = lands.conductance(gap, viscosity)
    guess = feeding.nominal_pressure or 1e6
    network = solve_network(feeding, np.array([[conductance]]), np.zeros(1), np.zeros(1), guess)
    p, area = network.pressures, lands.effective_area
    response = RecessResponse(
        force=area * p,
        outflow=conductance * p,
        stiffness=np.zeros((1, 1)),
        damping=np.array([[lands.squeeze_damping(gap, viscosity)]]),
        conductance=np.array([[conductance]]),
        opening=np.array([3.0 * conductance * p / gap]),
        area=np.array([[area]]),
        changed=0,
    )
    return PadState(lands, gap, response, network)


def gap_under(lands: Lands, feeding: Feeding, viscosity: float, load: float, thinnest: float) -> float:
    """Gap under a load, m; 0 where the load is beyond what the thinnest gap carries, infinite below the widest.

    The load falls as the gap grows wherever the network is stable.
    """

    def carried(gap: float) -> tuple[float, float]:
        state = pad_at(lands, feeding, viscosity, gap)
        return state.load, float(static_coefficients(state.response, state.network)[0][0, 0])

    return gap_for_load(carried, load, (thinnest, WIDEST), TYPICAL, 1e-12)
