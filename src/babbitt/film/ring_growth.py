"""What the temperature of a ring does to the form of its bore.

Steady conduction without sources leaves a free ring without stress in all harmonics but 0 and 1 (Boley and Weiner,
Theory of Thermal Stresses, 1960, section 4.7): with z = r exp(i theta) and T = Re f(z), the displacement is
alpha times the integral of f. The mean (n = 0) is the growth of the clearance; n = 1 shifts the bore as a whole.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.film.elastic import BoreGrid
from babbitt.notices import InputError

__all__ = ["RingGrowth"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RingGrowth:
    """A ring of one material, free to grow (plane stress), that conducts heat.

    Attributes
    ----------
    inner_radius, outer_radius : float
        m.
    expansion : float
        Linear thermal expansion, 1/K.
    conductivity : float
        W/(m K).
    """

    inner_radius: float
    outer_radius: float
    expansion: float
    conductivity: float

    def __post_init__(self) -> None:
        if not 0.0 < self.inner_radius < self.outer_radius < math.inf:
            raise InputError("E101", f"the ring reaches from {self.inner_radius} to {self.outer_radius} m; the "
                             "outer radius must be the greater one.")  # fmt: skip
        if not (math.isfinite(self.expansion) and self.conductivity > 0.0):
            raise InputError("E101", "expansion of a ring must be finite and its conductivity positive.")

    def mean_growth(self, temperature: float, flux: float) -> float:
        """Growth of the bore's radius, m, by a bore temperature above that of assembly (K) and the flux (W/m2).

        u = alpha a T_m with the mean over the area of T_a - (q a / k) ln(r / a)  (Timoshenko and Goodier, article
        151).
        """
        a, square = self.inner_radius, (self.outer_radius / self.inner_radius) ** 2
        mean_log = 0.5 * square * math.log(square) / (square - 1.0) - 0.5
        return self.expansion * a * (temperature - flux * a / self.conductivity * mean_log)

    def distortion(self, bore: BoreGrid, temperature: Array, flux: Array) -> Array:
        """Gain of the gap by the harmonics from 2 on, m, shape (rows, columns).

        T = (C r^n + D / r^n) cos n theta  gives  u(a) = alpha a (C a^n / (n + 1) - D a^-n / (n - 1)) cos n theta.

        Parameters
        ----------
        bore : BoreGrid
        temperature : ndarray, shape (rows,)
            In the bore, K.
        flux : ndarray, shape (rows,)
            From the film into the ring, W/m2.

        Returns
        -------
        ndarray, shape (rows, columns)
        """
        hot, passing = np.fft.rfft(temperature), np.fft.rfft(flux)
        n = np.arange(2, hot.size)
        slope = passing[2:] * self.inner_radius / (self.conductivity * n)
        rising, falling = 0.5 * (hot[2:] - slope), 0.5 * (hot[2:] + slope)
        grown = np.zeros_like(hot)
        grown[2:] = self.expansion * self.inner_radius * (rising / (n + 1.0) - falling / (n - 1.0))
        return bore.across(np.fft.irfft(grown, bore.rows))
