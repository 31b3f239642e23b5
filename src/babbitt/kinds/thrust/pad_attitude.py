"""How the pads stand to the collar: what tilt, heights and runout add to the height and the slopes of their gaps.

A tilt of the housing is a plane: at (r, theta) it adds -(e_o/r_o) r cos(theta - theta_t) to the gap (S1), also all
over a pad. A pivot lets the pad follow the slopes about the axes of its free tilts; the others it holds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.runout import RunoutHarmonic

__all__ = ["PARALLEL", "PadAttitude", "attitude_at_rest", "attitude_on_runout"]

Array = NDArray[np.float64]

PadTilt = tuple[float, float]
"""Parts of alpha_x and alpha_y that a pad which does not follow keeps."""
PARALLEL: PadTilt = (0.0, 0.0)
DIGITS = 12
"""Of a slope over the steepest: by round-off pads that lean alike would differ, and level ones lean."""


@dataclass(frozen=True, eq=False)
class PadAttitude:
    """What is added to the gaps of the pads.

    Attributes
    ----------
    departures : ndarray, shape (z,)
        To the film at the pivot, m.
    leans : ndarray, shape (z, 2)
        To alpha_x and alpha_y; zero for tilts that the pivot leaves free.
    """

    departures: Array
    leans: Array

    @property
    def is_even(self) -> bool:
        """Whether all pads stand alike."""
        return float(np.ptp(self.departures)) == 0.0 and not self.is_tilted

    @property
    def is_tilted(self) -> bool:
        """Whether the face of a pad is held at a slope."""
        return bool(self.leans.any())

    def lean(self, place: int) -> PadTilt:
        """Of one pad, from 0."""
        return float(self.leans[place, 0]), float(self.leans[place, 1])


def attitude_at_rest(bearing: ThrustBearing) -> PadAttitude:
    """Under the tilt of the housing, on a collar that is square to the shaft."""
    away = bearing.angles - bearing.tilt.direction
    steep = bearing.tilt.offset / bearing.pad.outer_radius
    slopes = steep * _rounded(-np.cos(away), bearing.sense * np.sin(away))
    return PadAttitude(bearing.departures(), _held(bearing.pad, slopes))


def attitude_on_runout(bearing: ThrustBearing, runouts: Sequence[RunoutHarmonic], turned: float) -> PadAttitude:
    """The same with a collar whose face is not square to the shaft, and has turned.

    Of one high spot the face is a plane: under pad i it stands out by xi_i (1 + X/r_p - j Y/r_p), see
    `babbitt.kinds.thrust.state.face_runout_response`. Of waves only the height at the pivot counts.

    Parameters
    ----------
    bearing : ThrustBearing
    runouts : sequence of RunoutHarmonic
        High spots thin the film under them.
    turned : float
        Angle of the collar in the sense of rotation, rad; at 0 without a phase a high spot is under pad 1.
    """
    still = attitude_at_rest(bearing)
    departures, leans = still.departures.copy(), still.leans.copy()
    for one in runouts:
        passed = one.order * (turned - bearing.phases()) + one.phase
        departures -= one.amplitude * np.cos(passed)
        if one.leans:
            steep = -one.amplitude / bearing.pad.pivot_radius
            leans += _held(bearing.pad, steep * _rounded(np.cos(passed), np.sin(passed)))
    return PadAttitude(departures, leans)


def _rounded(x: Array, y: Array) -> Array:
    return np.column_stack([x, y]).round(DIGITS)


def _held(pad: ThrustPad, slopes: Array) -> Array:
    slopes[:, [tilt - 1 for tilt in pad.free_tilts]] = 0.0
    return slopes
