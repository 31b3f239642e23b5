"""Turbulent films: linearised flow factors of the mean flow, and the friction that goes with them.

The mean flow along and across the motion is U h / 2 - h^3 / (k_x mu) dp/dx and -h^3 / (k_z mu) dp/dz with k = 12
in a laminar film and k = 12 + a Re^b in a turbulent one; Re = rho U h / mu is local, with the viscosity at ambient
pressure. The shear stress on the walls is (1 + a Re^b) mu U / h -+ h/2 dp/dx. The exchange of momentum is that of
the sliding motion: flow by supply pressure alone is not made turbulent.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError

__all__ = ["CONSTANTINESCU", "NG_PAN", "FilmTurbulence", "TurbulenceLaw"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TurbulenceLaw:
    """Flow factors 12 + a Re^b along and across the motion, and shear factor 1 + a Re^b, Re = rho U h / mu.

    Attributes
    ----------
    name : str
    along, across, shear : tuple of float
        a and b.
    source : str
    """

    name: str
    along: tuple[float, float]
    across: tuple[float, float]
    shear: tuple[float, float]
    source: str


SHEAR_SOURCE = (
    "Constantinescu, Galetuse, On the determination of friction forces in turbulent lubrication, "
    "ASLE Transactions 8 (1965) 367-380"
)
NG_PAN = TurbulenceLaw(
    "Ng and Pan",
    along=(0.0136, 0.90),
    across=(0.0043, 0.96),
    shear=(0.0012, 0.94),
    source="Ng, Pan, A linearized turbulent lubrication theory, J. Basic Engineering 87 (1965) 675-682, in the "
    f"power laws commonly fitted to it; shear: {SHEAR_SOURCE}",
)
CONSTANTINESCU = TurbulenceLaw(
    "Constantinescu",
    along=(0.0260, 0.8265),
    across=(0.0198, 0.741),
    shear=(0.0012, 0.94),
    source="Constantinescu, On turbulent lubrication, Proc. IMechE 173 (1959) 881-900, in the power laws fitted "
    f"to its mixing-length solution; shear: {SHEAR_SOURCE}",
)


@dataclass(frozen=True)
class FilmTurbulence:
    """Turbulence of a film: its law, the density, and between which local Reynolds numbers it sets in.

    Attributes
    ----------
    law : TurbulenceLaw
    density : float
        kg/m3.
    onset, end : float
        Local Reynolds numbers: laminar below the first, fully turbulent above the second; between them the excess
        over the laminar factor is weighted by 3 t^2 - 2 t^3.
    """

    law: TurbulenceLaw
    density: float
    onset: float
    end: float

    def __post_init__(self) -> None:
        if not (self.density > 0.0 and 0.0 < self.onset < self.end):
            raise InputError("E101", f"turbulence: density {self.density}, onset {self.onset}, end {self.end}; "
                             "density and onset must be positive, the end above the onset.")  # fmt: skip

    def kernel_row(self, unit_reynolds: float) -> Array:
        """What the kernels need; ``unit_reynolds`` is that of one clearance at the reference viscosity."""
        return np.array([unit_reynolds, self.onset, self.end, *self.law.along, *self.law.across, *self.law.shear])

    def shear_factor(self, reynolds: Array) -> Array:
        """Turbulent over laminar Couette shear at local Reynolds numbers."""
        factor, exponent = self.law.shear
        t = np.clip((reynolds - self.onset) / (self.end - self.onset), 0.0, 1.0)
        excess = factor * np.maximum(reynolds, 0.0) ** exponent
        return np.asarray(1.0 + t * t * (3.0 - 2.0 * t) * excess)
