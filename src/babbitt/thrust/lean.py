"""What a tilt of the housing does to the faces of pads that cannot follow it, laid on their films."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from babbitt.thrust.bearing import ThrustBearing
from babbitt.thrust.sharing import Share

__all__ = ["held_leans", "leaning_films"]

Array = NDArray[np.float64]


def held_leans(bearing: ThrustBearing) -> Array:
    """Slopes that the tilt of the housing gives to the gap of each pad where its pivot holds them.

    The tilt adds -(e_o/r_o) r cos(theta - theta_t) to the film (S1); along the radius of pad i its slope is
    -(e_o/r_o) cos(gamma_i - theta_t), along the motion (e_o/r_o) sin(gamma_i - theta_t) times the sense of
    rotation.

    Returns
    -------
    ndarray, shape (z, 2)
        To be added to alpha_x and alpha_y; zero for tilts that the pivot leaves free.
    """
    away = bearing.angles - bearing.tilt.direction
    steep = bearing.tilt.offset / bearing.pad.outer_radius
    leans = steep * np.column_stack([-np.cos(away), bearing.sense * np.sin(away)])
    leans[:, [tilt - 1 for tilt in bearing.pad.free_tilts]] = 0.0
    return leans


def leaning_films(share: Share) -> Array:
    """Thinnest film of each pad with its face leaning as the housing does, pivots and loads as they are, m.

    Returns
    -------
    ndarray, shape (z,)
    """
    basis = share.bearing.pad.watched()[0]
    leans = held_leans(share.bearing)
    return np.array(
        [
            float((state.watched_films() + basis[:, 1:] @ lean).min())
            for state, lean in zip(share.states, leans, strict=True)
        ]
    )
