"""The manifold before the restrictors: at a given pressure, or fed by a pump with leakage and relief valve."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.core.notices import InputError
from babbitt.kinds.hydrostatic.geometry import positive

__all__ = ["FixedPressure", "Pump", "Supply"]


@dataclass(frozen=True)
class FixedPressure:
    """A manifold that always stands at its pressure, gauge Pa: a relief valve that always overflows."""

    pressure: float

    def __post_init__(self) -> None:
        positive(supply_pressure=self.pressure)


@dataclass(frozen=True)
class Pump:
    """One pump for all restrictors: Q = Q_p - k p_s.

    Attributes
    ----------
    flow : float
        Q_p, m3/s.
    leakage : float
        k, m3/(s Pa).
    relief_pressure : float
        Gauge, Pa; infinite: no relief valve.
    """

    flow: float
    leakage: float = 0.0
    relief_pressure: float = math.inf

    def __post_init__(self) -> None:
        positive(pump_flow=self.flow)
        if not 0.0 <= self.leakage < math.inf:
            raise InputError("E101", f"leakage is {self.leakage} m3/(s Pa); it must be zero or positive.")
        if not self.relief_pressure > 0.0:
            raise InputError("E101", f"relief_pressure is {self.relief_pressure} Pa; it must be positive.")

    def delivers(self, pressure: float) -> float:
        """Flow at a pressure, m3/s."""
        return self.flow - self.leakage * pressure


Supply = FixedPressure | Pump
"""What feeds the restrictors."""
