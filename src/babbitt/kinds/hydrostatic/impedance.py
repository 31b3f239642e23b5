"""Stiffness and damping of a film with recesses, against frequency.

    K + i nu C = K_D + i nu C_D + B (G - dQ/dp + i nu V/B_oil)^-1 (N + i nu B^T)

K_D, C_D at standing recess pressures, B = dF/dp, N = dq/da; V is the oil between restrictor and film. The
inertia of the oil is not in it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.network import NetworkState

if TYPE_CHECKING:
    from babbitt.reynolds.recess.recess_film import (
        RecessResponse,  # the film compiles kernels; whoever describes a case does not
    )

__all__ = ["Compressibility", "damping_loss", "impedance", "static_coefficients"]

Array = NDArray[np.float64]

UNDAMPED = 1e-9
"""Damping of a motion, over that along the axes, up to which it is round-off."""


@dataclass(frozen=True)
class Compressibility:
    """Oil that gives way.

    Attributes
    ----------
    recess_volume : float
        Recess, line and ports behind one restrictor, m3.
    bulk_modulus : float
        Of the oil with its air, Pa.
    manifold_volume : float
        Before the restrictors, m3; matters behind a pump only.
    line_volume : float
        That part of `recess_volume` which is in line and ports, m3.
    """

    recess_volume: float = 0.0
    bulk_modulus: float = 1.4e9
    manifold_volume: float = 0.0
    line_volume: float = 0.0

    @property
    def recess(self) -> float:
        """V/B, m3/Pa."""
        return self.recess_volume / self.bulk_modulus

    @property
    def manifold(self) -> float:
        """V_m/B, m3/Pa."""
        return self.manifold_volume / self.bulk_modulus


def impedance(
    film: RecessResponse, network: NetworkState, oil: Compressibility, frequency: float
) -> tuple[Array, Array]:
    """Stiffness and damping at an angular frequency.

    Parameters
    ----------
    film : RecessResponse
    network : NetworkState
    oil : Compressibility
    frequency : float
        rad/s; zero gives the limit of slow motion.

    Returns
    -------
    stiffness, damping : ndarray, shape (motions, motions)
        dF = -(K da + C da').
    """
    if frequency == 0.0:
        stiffness, damping = static_coefficients(film, network)
        return stiffness, damping - lost_damping(film, network, oil)
    nu = 1j * frequency
    matrix = (
        film.conductance
        + network.moved_restrictor_matrix(nu * oil.manifold)
        + nu * oil.recess * np.eye(film.outflow.size)
    )
    whole = film.stiffness + nu * film.damping
    whole = whole + film.area @ np.linalg.solve(matrix, film.opening + nu * film.area.T)
    return whole.real, whole.imag / frequency


def static_coefficients(film: RecessResponse, network: NetworkState) -> tuple[Array, Array]:
    """Stiffness and damping of slow motion with oil that does not give way."""
    matrix = film.conductance + network.restrictor_matrix()
    answered = np.linalg.solve(matrix, np.column_stack((film.opening, film.area.T)))
    motions = film.force.size
    return film.stiffness + film.area @ answered[:, :motions], film.damping + film.area @ answered[:, motions:]


def lost_damping(film: RecessResponse, network: NetworkState, oil: Compressibility) -> Array:
    """Damping of slow motion that the compressibility takes away."""
    matrix = film.conductance + network.restrictor_matrix()
    give = np.diag(np.full(film.outflow.size, oil.recess))
    if np.isfinite(network.manifold_slope):
        give = give + np.outer(network.supply_slope, network.slope) * oil.manifold / network.manifold_slope**2
    return np.asarray(film.area @ np.linalg.solve(matrix, give @ np.linalg.solve(matrix, film.opening)))


def damping_loss(film: RecessResponse, network: NetworkState, oil: Compressibility) -> float:
    """Largest share of the damping of any motion that compressibility takes away in slow motion.

    The largest eigenvalue of ``C_lost v = s C v``, symmetric parts: of all motions v the one that loses most of
    the power that damping takes from it, whatever the axes in which motions are counted. Motions that nothing
    damps, such as tilts of a ring whose lumped lands have one recess, do not count.
    """
    full, lost = static_coefficients(film, network)[1], lost_damping(film, network, oil)
    scale = np.sqrt(np.maximum(np.diag(full), 0.0))  # makes translations and tilts comparable
    scale = np.divide(1.0, scale, out=np.zeros_like(scale), where=scale > 0.0)
    full, lost = (scale[:, None] * 0.5 * (one + one.T) * scale for one in (full, lost))
    damping, motions = np.linalg.eigh(full)
    damped = damping > UNDAMPED
    basis = motions[:, damped] / np.sqrt(damping[damped])
    return float(np.linalg.eigvalsh(basis.T @ lost @ basis).max(initial=0.0))
