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

from babbitt.hydrostatics.network import NetworkState

if TYPE_CHECKING:
    from babbitt.film.recess import RecessResponse  # the film compiles kernels; whoever describes a case does not

__all__ = ["Compressibility", "damping_loss", "impedance", "static_coefficients"]

Array = NDArray[np.float64]


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
    """

    recess_volume: float = 0.0
    bulk_modulus: float = 1.4e9
    manifold_volume: float = 0.0

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
    """Largest share of the damping of a motion that compressibility takes away in slow motion.

    Motions that nothing damps, such as tilts of a ring whose lumped lands have one recess, do not count.
    """
    full = np.diag(static_coefficients(film, network)[1])
    lost = np.diag(lost_damping(film, network, oil))
    damped = full > 0.0
    return float((lost[damped] / full[damped]).max(initial=0.0))
