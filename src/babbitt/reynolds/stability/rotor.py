"""The rotor that the film carries, rigid or on an elastic shaft: stable masses, and how fast a whirl grows."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from babbitt.reynolds.stability.routh import StableMasses

__all__ = ["RIGID", "critical_mass_of_rotor", "growth_rates", "stable_masses_of_rotor"]

Array = NDArray[np.float64]

RIGID = math.inf
"""Stiffness of a shaft that does not bend, N/m."""


def stable_masses_of_rotor(stiffness: Any, damping: Any, shaft_stiffness: float = RIGID) -> StableMasses:
    """Masses of a rotor, kg per bearing, for which every motion dies away.

    Parameters
    ----------
    stiffness, damping : array_like, shape (2, 2)
        Of the film, N/m and N s/m.
    shaft_stiffness : float
        Between the mass and the journal, N/m.

    Returns
    -------
    StableMasses

    Notes
    -----
    On the threshold everything oscillates with the frequency Ω. The mass m at the end of a shaft of stiffness k
    moves k / (k - m Ω²) times as far as the journal and pushes it as the effective mass ``m k / (k - m Ω²)`` at
    the journal would. That mass is the critical one of the rigid rotor, m_0, at the same Ω:
    ``m = m_0 / (1 + m_0 Ω² / k)``. A film that only a heavy journal bears (det C < 0) bears none on a shaft that
    bends: the journal, which has no mass of its own there, leaves at once.
    """
    from babbitt.reynolds.stability.routh import NO_MASS, StableMasses, stable_masses, whirl_frequency

    film = np.asarray(stiffness, dtype=float), np.asarray(damping, dtype=float)
    rigid = stable_masses(*film)
    if math.isinf(shaft_stiffness):
        return rigid
    if rigid.least > 0.0:
        return NO_MASS
    if math.isinf(rigid.greatest):
        return rigid
    return StableMasses(
        0.0, rigid.greatest / (1.0 + rigid.greatest * whirl_frequency(*film) ** 2 / shaft_stiffness)
    )


def critical_mass_of_rotor(stiffness: Any, damping: Any, shaft_stiffness: float = RIGID) -> float:
    """Mass above which a rotor whirls, kg per bearing; infinite if a heavy one never does, zero if any does.

    Parameters
    ----------
    stiffness, damping : array_like, shape (2, 2)
        Of the film, N/m and N s/m.
    shaft_stiffness : float
        Between the mass and the journal, N/m.

    Returns
    -------
    float

    Examples
    --------
    >>> film = [[2e8, 1e8], [-3e8, 4e8]], [[1e6, 0.0], [0.0, 2e6]]
    >>> round(critical_mass_of_rotor(*film)), round(critical_mass_of_rotor(*film, shaft_stiffness=1e9))
    (25263, 19945)
    """
    return stable_masses_of_rotor(stiffness, damping, shaft_stiffness).greatest


def growth_rates(mass: Any, stiffness: Any, damping: Any, shaft_stiffness: float = RIGID) -> Array:
    """Rate at which the least damped motion of a rotor grows: positive where it whirls.

    Parameters
    ----------
    mass : array_like, shape (...)
        Per bearing, kg.
    stiffness, damping : array_like, shape (..., 2, 2)
        Of the film, N/m and N s/m; not a number where there is none.
    shaft_stiffness : float
        N/m.

    Returns
    -------
    ndarray, shape (...)
        Largest real part of the eigenvalues, 1/s; not a number where a coefficient is none.

    Notes
    -----
    Rigid: ``m r'' + C r' + K r = 0``, four eigenvalues. Elastic, with the journal r of no mass and the rotor s:
    ``m s'' + k (s - r) = 0``, ``C r' + K r + k (r - s) = 0``, six eigenvalues.

    Examples
    --------
    >>> import numpy as np
    >>> growth_rates(2.0, 8.0 * np.eye(2), 4.0 * np.eye(2)).round(6).item()
    -1.0
    """
    k, c = np.asarray(stiffness, dtype=float), np.asarray(damping, dtype=float)
    m = np.asarray(mass, dtype=float)[..., None, None]
    m, k, c = np.broadcast_arrays(m, k, c)
    known = np.isfinite(m + k + c).all(axis=(-1, -2))
    rates = np.full(known.shape, np.nan)
    build = _rigid if math.isinf(shaft_stiffness) else _elastic
    if known.any():
        eigenvalues = np.linalg.eigvals(build(m[known], k[known], c[known], shaft_stiffness))
        rates[known] = eigenvalues.real.max(axis=-1)
    return rates


def _rigid(m: Array, k: Array, c: Array, shaft: float) -> Array:
    nothing, one = np.zeros_like(k), np.broadcast_to(np.eye(2), k.shape)
    return np.block([[nothing, one], [-k / m, -c / m]])


def _elastic(m: Array, k: Array, c: Array, shaft: float) -> Array:
    nothing, one = np.zeros_like(k), np.broadcast_to(np.eye(2), k.shape)
    spring = shaft * one
    pulled = np.linalg.solve(c, spring)
    return np.block(
        [
            [nothing, one, nothing],  # rotor: place
            [-spring / m, nothing, spring / m],  # rotor: speed
            [pulled, nothing, -np.linalg.solve(c, k + spring)],  # journal: place
        ]
    )
