"""How far the shaft line swings along its axis, as an indicator in sea trials reads it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.model import LineState
from babbitt.kinds.shaft_line.natural import along

__all__ = ["AxialAmplitudes", "axial_amplitudes"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class AxialAmplitudes:
    """Amplitudes of axial vibration, half of peak to peak.

    Attributes
    ----------
    places : ndarray, shape (p,)
        Distance from the propeller, m.
    each : ndarray, shape (n, p)
        Of each excitation, m.
    """

    places: Array
    each: Array

    @property
    def collar(self) -> float:
        """Of the collar for any phases, m: the sum over the excitations."""
        return float(self.each[:, -1].sum())

    @property
    def far_end(self) -> float:
        """Of the propeller, or the free end of the shaft, for any phases, m."""
        return float(self.each[:, 0].sum())

    @property
    def largest(self) -> float:
        """Largest along the shaft for any phases, m."""
        return float(self.each.sum(axis=0).max())


def axial_amplitudes(state: LineState) -> AxialAmplitudes:
    """Amplitudes along the shaft under every excitation.

    Between the ends of a piece of shaft the wave through the motion of both is taken.

    Parameters
    ----------
    state : LineState
    """
    line, rows = state.duty.line, []
    places = np.zeros(1)
    for part in state.forced.parts:
        response = part.response
        places, real = along(line, response.shaft.real, response.frequency)
        _, imaginary = along(line, response.shaft.imag, response.frequency)
        rows.append(np.hypot(real, imaginary))
    return AxialAmplitudes(places, np.array(rows))
