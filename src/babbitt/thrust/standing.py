"""How the pads stand to the collar: what tilt, heights and runout add to the height and the slopes of their gaps.

A tilt of the housing is a plane: at (r, theta) it adds -(e_o/r_o) r cos(theta - theta_t) to the gap (S1), also all
over a pad. A pivot lets the pad follow the slopes about the axes of its free tilts; the others it holds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.thrust.bearing import ThrustBearing
from babbitt.thrust.pad import ThrustPad

__all__ = ["LEVEL", "Lean", "Standing", "standing_at_rest", "standing_on_runout"]

Array = NDArray[np.float64]

Lean = tuple[float, float]
"""Parts of alpha_x and alpha_y that a pad which does not follow keeps."""
LEVEL: Lean = (0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Standing:
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
        return float(np.ptp(self.departures)) == 0.0 and not self.is_leaning

    @property
    def is_leaning(self) -> bool:
        """Whether the face of a pad is held at a slope."""
        return bool(self.leans.any())

    def lean(self, place: int) -> Lean:
        """Of one pad, from 0."""
        return float(self.leans[place, 0]), float(self.leans[place, 1])


def standing_at_rest(bearing: ThrustBearing) -> Standing:
    """Under the tilt of the housing, on a collar that is square to the shaft."""
    away = bearing.angles - bearing.tilt.direction
    steep = bearing.tilt.offset / bearing.pad.outer_radius
    slopes = steep * np.column_stack([-np.cos(away), bearing.sense * np.sin(away)])
    return Standing(bearing.departures(), _held(bearing.pad, slopes))


def standing_on_runout(bearing: ThrustBearing, amplitude: float, turned: float) -> Standing:
    """The same with a collar that leans, and has turned.

    Under pad i the face stands out by xi_i (1 + X/r_p - j Y/r_p), see `babbitt.thrust.state.wobble_answer`.

    Parameters
    ----------
    bearing : ThrustBearing
    amplitude : float
        Of the runout at the pivot radius, m: the high spot thins the film under it.
    turned : float
        Angle of the high spot from pad 1 in the sense of rotation, rad.
    """
    still = standing_at_rest(bearing)
    passed = turned - bearing.phases()
    slopes = -amplitude / bearing.pad.pivot_radius * np.column_stack([np.cos(passed), np.sin(passed)])
    return Standing(
        still.departures - amplitude * np.cos(passed),
        still.leans + _held(bearing.pad, slopes),
    )


def _held(pad: ThrustPad, slopes: Array) -> Array:
    slopes[:, [tilt - 1 for tilt in pad.free_tilts]] = 0.0
    return slopes
