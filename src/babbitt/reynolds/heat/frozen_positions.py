"""A film with its own temperatures at other positions of the journal, its viscosity as it was at rest."""

from __future__ import annotations

import math
from copy import deepcopy

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.equilibrium.many_positions import PositionCoefficients, require_finite
from babbitt.reynolds.stability.load_slope import EquilibriumNodes
from babbitt.reynolds.surface.surface_equilibrium import SurfaceState

__all__ = ["FrozenPositions"]

Array = NDArray[np.float64]

ROUNDS = 200
"""Films at one position until its active set has converged."""


class FrozenPositions:
    """A film at rest, node by node with the viscosity that every node has, for other positions of its journal.

    Parameters
    ----------
    nodes : EquilibriumNodes
        They stay as they are; every call works on a copy.
    """

    def __init__(self, nodes: EquilibriumNodes) -> None:
        self.nodes = nodes

    def forces(self, places: Array) -> PositionCoefficients:
        """Forces, stiffness and damping at rows of x, y (m) and their rates (m/s), shape (n, 4).

        Raises
        ------
        InputError
            E101 for what is not finite.
        """
        return self.coefficients(places)

    def coefficients(self, places: Array) -> PositionCoefficients:
        """The same."""
        require_finite(places)
        scales, frame = self.nodes.scales, self.nodes.frame
        count = len(places)
        found = PositionCoefficients(
            np.zeros(count, dtype=bool), np.zeros(count, dtype=bool), np.full((count, 2), np.nan),
            np.full((count, 2, 2), np.nan), np.full((count, 2, 2), np.nan),
        )  # fmt: skip
        sample = deepcopy(self.nodes.ring.sample)
        wet = sample.work.wet.copy()
        c, s = math.cos(frame.angle), math.sin(frame.angle)
        turn = np.array([[c, s], [-s, c]]) @ np.diag(scales.sense)
        unit = scales.force / scales.length
        for row, (x, y, x_rate, y_rate) in enumerate(places):
            at = np.asarray(frame.place((x, y))) * scales.sense / scales.length
            rate = np.asarray(frame.place((x_rate, y_rate))) * scales.sense / (scales.length * scales.rate)
            if not sample.gap(at) > 0.0:
                found.outside[row] = True
                continue
            found.settled[row] = _settled(sample, wet, at, rate)
            found.force[row] = turn @ sample.force * scales.force
            found.stiffness[row] = turn @ sample.stiffness @ turn.T * unit
            found.damping[row] = turn @ sample.damping @ turn.T * (unit / scales.rate)
        return found


def _settled(sample: SurfaceState, wet: NDArray[np.bool_], at: Array, rate: Array) -> bool:
    """Let the active set settle from that at rest, else from a full film; whether it did."""
    for start in (wet, np.ones_like(wet)):
        sample.work.wet[:] = start
        for _ in range(ROUNDS):
            if sample.evaluate(at, rate) == 0:
                sample.evaluate(at, rate, smooth=True)
                return True
    return False
