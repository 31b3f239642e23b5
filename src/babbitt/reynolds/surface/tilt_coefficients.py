"""What a film sets against the tilt of its journal: moments, and stiffness and damping in four motions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.lands._equilibrium import CONVERGED
from babbitt.reynolds.model import ENGINEERING, Cavitation, FilmStart, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.surface_equilibrium import ring_at
from babbitt.reynolds.surface.surface_solution import mirrored

__all__ = ["TiltCoefficients", "tilt_coefficients"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class TiltCoefficients:
    """Answer of a film to its journal moving and leaning.

    The motions are q = (x, y, dx/dz, dy/dz) of the journal axis, m and rad, and Q = (F_x, F_y, M_x, M_y) what the
    film does work with on them: M_x = int z dF_x and M_y = int z dF_y, N m, z from the mid-plane. As moments about
    the axes x and y these are -M_y and M_x.

    Attributes
    ----------
    outcome : Outcome
    forces : ndarray, shape (4,)
        Q of the film with the oil in grooves and pockets.
    stiffness, damping : ndarray, shape (4, 4)
        dQ = -(K dq + C dq'). Units N/m, N/rad, N m/m, N m/rad, and these times seconds.
    """

    outcome: Outcome
    forces: Array
    stiffness: Array
    damping: Array

    @property
    def moment(self) -> Array:
        """M_x and M_y, N m, shape (2,)."""
        return self.forces[2:]


def tilt_coefficients(solution: FilmSolution, resolution: Resolution = ENGINEERING) -> TiltCoefficients:
    """Moments and coefficients of tilt of a solved film, at its position and with its misalignment.

    Parameters
    ----------
    solution : FilmSolution
        At rest; a velocity that it was given does not count.
    resolution : Resolution

    Returns
    -------
    TiltCoefficients

    Raises
    ------
    InputError
        E101 for a film that was not solved, and for films without a place of their own to begin or without
        coefficients (widest gap, half-Sommerfeld).
    """
    film = solution.film
    check_film(solution)
    scales = Scales.of(film, abs(film.angular_speed))
    seen = mirrored(film) if film.angular_speed < 0.0 else film
    at = np.zeros(4)  # the misalignment is in the gap already
    at[:2] = solution.position * scales.sense / scales.length
    settled = ring_at(seen, scales.pressure, at, np.zeros(4), resolution)
    sample = settled.sample
    arm = np.array([1.0, 1.0, 0.5 * film.width, 0.5 * film.width])
    sense = np.tile(scales.sense, 2)
    to_forces, to_motions = (arm * sense)[:, None], (arm * sense)[None, :]
    unit = scales.force / scales.length
    return TiltCoefficients(
        Outcome.CONVERGED if settled.status == CONVERGED else Outcome.NOT_CONVERGED,
        arm * sense * sample.force * scales.force,
        to_forces * sample.stiffness * to_motions * unit,
        to_forces * sample.damping * to_motions * (unit / scales.rate),
    )


def check_film(solution: FilmSolution) -> None:
    """Refuse films for which tilt has no coefficients."""
    film = solution.film
    if not solution.outcome.solved:
        raise InputError("E101", "the film was not solved; tilt coefficients need a position that is an answer.")
    if film.angular_speed == 0.0:
        raise InputError("E101", "angular_speed is zero; tilt coefficients need a film that turns.")
    if film.film_start is FilmStart.WIDEST_GAP or film.cavitation is Cavitation.HALF_SOMMERFELD:
        raise InputError("E101", "tilt coefficients need a film that begins at a groove, pocket or hole, and the "
                         "mass-conserving or the Reynolds condition.")  # fmt: skip
