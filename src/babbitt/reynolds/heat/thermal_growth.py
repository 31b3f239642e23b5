"""What the uneven temperature of a bush does to the form of its bore.

Steady conduction without sources leaves a free ring of one material without stress in all harmonics but 0 and 1
(Boley and Weiner, Theory of Thermal Stresses, 1960, section 4.7): with z = r exp(i theta) and T = Re f(z), the
displacement is alpha times the integral of f. The mean (n = 0) is left to the growth of the clearance; n = 1
shifts the bore as a whole. The rest depends on temperature and flux at the inner surface of the ring alone,
wherever the heat goes outside; f is that of one conductivity, so that no other ring may count as part of the body.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.deformation.compliance import BoreGrid
from babbitt.reynolds.heat.heat_model import BushRing

__all__ = ["RingGrowth"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RingGrowth:
    """The bush itself, of one material and free to grow (plane stress), among the rings that conduct heat.

    Layers within it (a liner) follow its inner surface; what lies around it (contact, housing) takes its heat and
    does not hold it.

    Attributes
    ----------
    walls : BushRing
        All rings.
    ring : int
        Which of them is the bush, from 0 at the bore.
    expansion : float
        Its linear thermal expansion, 1/K.
    """

    walls: BushRing
    ring: int
    expansion: float

    def __post_init__(self) -> None:
        count = len(self.walls.conductivities)
        if not 0 <= self.ring < count:
            raise InputError(
                "E101", f"ring {self.ring} is to grow, and there are {count}, counted from 0 at the bore."
            )
        if not math.isfinite(self.expansion):
            raise InputError("E101", f"the expansion of a ring is {self.expansion} 1/K; it must be finite.")

    @property
    def premise(self) -> str:
        """What is taken for granted, a sentence for the report."""
        outside = 2e3 * self.walls.radii[self.ring + 1]
        return (
            "The uneven temperature of the bush distorts the bore as that of a free ring of one material, up to "
            f"{outside:.5g} mm, in plane stress: a liner follows it, the housing does not hold it; positions of "
            "the journal count from the shifted centre of its bore."
        )

    def distortion(self, bore: BoreGrid, temperature: Array) -> Array:
        """Gain of the gap by the harmonics from 2 on, m, shape (rows, columns).

        T = (C r^n + D / r^n) cos n theta  gives  u(a) = alpha a (C a^n / (n + 1) - D a^-n / (n - 1)) cos n theta
        at the inner radius a of the bush; C and D follow from temperature and flux there (`BushRing.behind`).

        Parameters
        ----------
        bore : BoreGrid
        temperature : ndarray, shape (rows,)
            Of the bore, K.

        Returns
        -------
        ndarray, shape (rows, columns)
        """
        on_bore = np.fft.rfft(temperature)
        shares, impedances = self.walls.behind(self.ring, on_bore.size - 1)
        radius, conductivity = self.walls.radii[self.ring], self.walls.conductivities[self.ring]
        n = np.arange(2, on_bore.size)
        hot = shares[2:] * on_bore[2:]
        slope = hot / impedances[2:] * radius / (conductivity * n)
        rising, falling = 0.5 * (hot - slope), 0.5 * (hot + slope)
        grown = np.zeros_like(on_bore)
        grown[2:] = self.expansion * radius * (rising / (n + 1.0) - falling / (n - 1.0))
        return bore.across(np.fft.irfft(grown, bore.rows))
