"""A bush or housing as a thick elastic ring in plane strain, harmonic by harmonic of the pressure in its bore.

Displacements U(r) cos(n theta) outwards and V(r) sin(n theta) around solve Navier's equations as powers r^s with
s = n + 1, n - 1, 1 - n, -1 - n (Michell; Timoshenko and Goodier, Theory of Elasticity, 3rd ed., article 43), and
r, 1/r for n = 0 (Lame, article 28). Their four (two) factors follow from the tractions in the bore and what holds
the outside.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.deformation.compliance import BoreGrid, check_elastic

__all__ = ["ElasticRing", "RingSupport"]

Array = NDArray[np.float64]


class RingSupport(Enum):
    """What holds the outside of a ring."""

    FREE = "nothing but the reaction to the load"
    CLAMPED = "a rigid body that it is bonded to"


@dataclass(frozen=True)
class ElasticRing:
    """A thick ring under the mean pressure over its width; its bore stays straight along the shaft.

    The first harmonic of the pressure carries the load. Its displacement shifts the bore as a whole, and what it
    bends depends on how the housing is held, which no ring knows: it is left out, so that positions of the journal
    count from the displaced centre of the bore.

    Attributes
    ----------
    inner_radius, outer_radius : float
        m.
    elastic_modulus : float
        Pa.
    poisson_ratio : float
    support : RingSupport
    """

    inner_radius: float
    outer_radius: float
    elastic_modulus: float
    poisson_ratio: float
    support: RingSupport = RingSupport.FREE

    def __post_init__(self) -> None:
        check_elastic(self.elastic_modulus, self.poisson_ratio)
        if not 0.0 < self.inner_radius < self.outer_radius < math.inf:
            raise InputError("E101", f"the ring reaches from {self.inner_radius} to {self.outer_radius} m; the "
                             "outer radius must be the greater one.")  # fmt: skip

    @property
    def premise(self) -> str:
        """See `babbitt.reynolds.deformation.compliance.Compliance`."""
        held = "free outside" if self.support is RingSupport.FREE else "bonded to a rigid body outside"
        return (
            f"Elastic ring up to {2e3 * self.outer_radius:.4g} mm, {held}, in plane strain under the mean "
            "pressure over the width; positions of the journal count from the shifted centre of its bore."
        )

    def response(self, harmonic: int) -> float:
        """Displacement of the bore outwards per pressure there, both cos(n theta), m/Pa; zero for n = 1."""
        if harmonic == 1:
            return 0.0
        a, b = self.inner_radius, self.outer_radius
        powers = (
            (1.0, -1.0) if harmonic == 0 else (harmonic + 1.0, harmonic - 1.0, 1.0 - harmonic, -1.0 - harmonic)
        )
        # every power is one where it is largest, so that no harmonic overflows
        terms = [(_term(self, harmonic, s), s, b if s > 0.0 else a) for s in powers]
        inside = [_at(term, s, a, base) for term, s, base in terms]
        outside = [_at(term, s, b, base) for term, s, base in terms]
        rows = 1 if harmonic == 0 else 2
        held = slice(0, rows) if self.support is RingSupport.CLAMPED else slice(2, 2 + rows)
        system = np.vstack((np.array(inside).T[2 : 2 + rows], np.array(outside).T[held]))
        pressed = np.zeros(2 * rows)
        pressed[0] = -1.0  # sigma_rr = -p in the bore
        scale = np.abs(system).max(axis=1)
        factors = np.linalg.solve(system / scale[:, None], pressed / scale)
        return float(np.array(inside).T[0] @ factors)

    def displacement(self, bore: BoreGrid, pressure: Array) -> Array:
        """See `babbitt.reynolds.deformation.compliance.Compliance`."""
        spectrum = np.fft.rfft(pressure @ bore.shares)
        return bore.across(np.fft.irfft(spectrum * _responses(self, spectrum.size), bore.rows))


@lru_cache(maxsize=16)
def _responses(ring: ElasticRing, count: int) -> Array:
    return np.array([ring.response(harmonic) for harmonic in range(count)])


def _term(ring: ElasticRing, n: int, s: float) -> tuple[float, float, float, float]:
    """U, V, sigma_rr r, sigma_rt r of the solution that goes with r^s, where r is one.

    The balances s S_rr - S_tt + n S_rt = 0 and (s + 1) S_rt - n S_tt = 0 are one equation in U and V at these
    powers; the one with the larger coefficients tells their ratio.
    """
    mu = 0.5 * ring.elastic_modulus / (1.0 + ring.poisson_ratio)
    lam = 2.0 * mu * ring.poisson_ratio / (1.0 - 2.0 * ring.poisson_ratio)
    stiff = lam + 2.0 * mu
    radial = np.array([stiff * s + lam, lam * n])
    hoop = np.array([lam * s + stiff, stiff * n])
    shear = np.array([-mu * n, mu * (s - 1.0)])
    if n == 0:
        return 1.0, 0.0, float(radial[0]), 0.0
    balances = (s * radial - hoop + n * shear, (s + 1.0) * shear - n * hoop)
    row = max(balances, key=lambda one: float(np.abs(one).sum()))
    motion = np.array([-row[1], row[0]]) / np.abs(row).max()
    return float(motion[0]), float(motion[1]), float(radial @ motion), float(shear @ motion)


def _at(term: tuple[float, float, float, float], s: float, r: float, base: float) -> list[float]:
    """Displacements and tractions at a radius, for (r / base)^s."""
    size = (r / base) ** s
    return [term[0] * size, term[1] * size, term[2] * size / r, term[3] * size / r]
