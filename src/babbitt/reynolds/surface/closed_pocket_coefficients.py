"""Stiffness and damping of a film with closed pockets, whose pressure follows the journal.

The oil in a closed pocket cannot go elsewhere: moved by da, the journal changes the pressures p such that the net
flows q(a, a', p) keep vanishing, q_p dp = -q_a da - q_a' da'. With K = -F_a and C = -F_a' at standing pressures

    K_closed = K + F_p q_p^-1 q_a,    C_closed = C + F_p q_p^-1 q_a',

at the active set of the film. Oil is incompressible, pockets are full.
"""

from __future__ import annotations

import copy

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.model import FilmStart
from babbitt.reynolds.surface.surface_equilibrium import SurfaceEquilibrium

__all__ = ["closed_coefficients"]

Array = NDArray[np.float64]

STEP = 1e-5
"""Of the journal in least gaps; pressures and velocities act linearly."""


def closed_coefficients(settled: SurfaceEquilibrium) -> tuple[Array, Array]:
    """Stiffness and damping, dimensionless, of a converged film whose pockets may be closed.

    Parameters
    ----------
    settled : SurfaceEquilibrium
        Stays as it is.

    Returns
    -------
    tuple of ndarray, shape (2, 2)
        As they are without closed pockets.
    """
    film, sample = settled.film, settled.sample
    grooves = 0 if film.film_start is FilmStart.PERIODIC else len(film.lands)
    closed = [grooves + number for number, pocket in enumerate(film.pockets) if pocket.closed]
    seen = [sample.ring.supply == number for number in closed]
    nodes = [one for one in seen if one.any()]  # of two images in the mid-plane, one is not seen
    if not nodes or not sample.work.pressure.any():  # a film without pressure has nothing to answer
        return sample.stiffness, sample.damping
    trial, at = copy.deepcopy(sample), settled.position
    wet, held = trial.work.wet.copy(), trial.ring.surface.held_pressure
    rest = np.zeros(at.size)

    def response(place: Array, rate: Array) -> Array:
        """Force and net flows."""
        trial.work.wet[:] = wet
        trial.evaluate(place, rate)
        return np.concatenate((trial.force[:2], [trial.work.row[one].sum() for one in nodes]))

    here = response(at, rest)
    by_pressure = []
    unit = float(np.abs(trial.work.pressure).max())
    for one in nodes:
        held[one] += unit
        by_pressure.append((response(at, rest) - here) / unit)
        held[one] -= unit
    force_by_pressure, flow_by_pressure = np.array(by_pressure)[:, :2].T, np.array(by_pressure)[:, 2:].T
    step, added = STEP * settled.gap, []
    for direction in np.eye(at.size)[:2]:
        moved = (response(at + step * direction, rest) - response(at - step * direction, rest)) / (2.0 * step)
        added.append((moved[2:], response(at, direction)[2:] - here[2:]))
    by_place, by_rate = (np.array([pair[kind] for pair in added]).T for kind in (0, 1))
    answer = force_by_pressure @ np.linalg.inv(flow_by_pressure)
    return sample.stiffness + answer @ by_place, sample.damping + answer @ by_rate
