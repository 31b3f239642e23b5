"""Laws of the restrictors between supply and recess: flow, and how it answers to both pressures.

``law(recess_pressure, supply_pressure)`` gives the flow into the recess in m3/s and its slopes in both
pressures in m3/(s Pa). Pressures are gauge, Pa.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.core.notices import InputError
from babbitt.kinds.hydrostatic.geometry import positive

__all__ = [
    "Capillary",
    "CheckValve",
    "ConstantFlow",
    "FlowValve",
    "MembraneValve",
    "MeteredFlow",
    "Orifice",
    "Restrictor",
    "Slot",
]

Law = tuple[float, float, float]
"""Flow, its slope in the recess pressure, its slope in the supply pressure."""

SMOOTHING = 1e-4
"""Over the supply pressure: where the square root of an orifice is made smooth. Below 3e-5 of the flow from one
hundredth of the supply pressure on."""


@dataclass(frozen=True)
class Capillary:
    """A round tube, or several alike side by side (Hagen-Poiseuille).

    Attributes
    ----------
    diameter, length : float
        m.
    viscosity : float
        Of the oil in it, Pa s.
    tubes : int
    entry_loss : float
        Loss at the entry and of the running-in over rho U^2/2; zero: none. Usual 2.24.
    density : float
        kg/m3, for the entry loss.
    """

    diameter: float
    length: float
    viscosity: float
    tubes: int = 1
    entry_loss: float = 0.0
    density: float = 870.0

    def __post_init__(self) -> None:
        positive(diameter=self.diameter, length=self.length, viscosity=self.viscosity, density=self.density)
        if self.tubes < 1 or not 0.0 <= self.entry_loss < math.inf:
            raise InputError("E101", f"tubes is {self.tubes} and entry_loss {self.entry_loss}; at least one tube, "
                             "and a loss of zero or more.")  # fmt: skip

    @property
    def conductance(self) -> float:
        """Flow over pressure drop without entry loss, all tubes, m3/(s Pa)."""
        return self.tubes * math.pi * self.diameter**4 / (128.0 * self.viscosity * self.length)

    def reynolds_number(self, flow: float) -> float:
        """Of one tube at a flow through all."""
        return 4.0 * self.density * abs(flow) / (self.tubes * math.pi * self.diameter * self.viscosity)

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes; dp = A Q + B Q^2 with entry loss, odd about zero."""
        drop, whole = supply_pressure - recess_pressure, self.conductance
        if self.entry_loss == 0.0:
            return whole * drop, -whole, whole
        linear = 1.0 / whole
        square = 8.0 * self.density * self.entry_loss / (math.pi**2 * self.diameter**4 * self.tubes**2)
        size = (-linear + math.sqrt(linear**2 + 4.0 * square * abs(drop))) / (2.0 * square)
        slope = 1.0 / (linear + 2.0 * square * size)
        return math.copysign(size, drop), -slope, slope


@dataclass(frozen=True)
class Orifice:
    """A sharp-edged hole: Q = C_d (pi d^2/4) sqrt(2 dp/rho).

    Attributes
    ----------
    diameter : float
        m.
    density : float
        kg/m3.
    discharge : float
        C_d, up to 1.
    """

    diameter: float
    density: float
    discharge: float = 0.6

    def __post_init__(self) -> None:
        positive(diameter=self.diameter, density=self.density)
        if not 0.0 < self.discharge <= 1.0:
            raise InputError("E101", f"discharge is {self.discharge}; it must lie above 0 and up to 1.")

    @property
    def factor(self) -> float:
        """Flow over the root of the pressure drop, m3/(s Pa^0.5)."""
        return self.discharge * 0.25 * math.pi * self.diameter**2 * math.sqrt(2.0 / self.density)

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes, smooth and odd about zero."""
        drop, width = supply_pressure - recess_pressure, SMOOTHING * max(abs(supply_pressure), 1.0)
        square = drop * drop + width * width
        flow = self.factor * drop / square**0.25
        slope = self.factor * (square - 0.5 * drop * drop) / square**1.25
        return flow, -slope, slope


@dataclass(frozen=True)
class Slot:
    """A flat slot of width w, gap s and length l: Q = w s^3 dp/(12 mu l); SI."""

    width: float
    gap: float
    length: float
    viscosity: float

    def __post_init__(self) -> None:
        positive(width=self.width, gap=self.gap, length=self.length, viscosity=self.viscosity)

    @property
    def conductance(self) -> float:
        """Flow over pressure drop, m3/(s Pa)."""
        return self.width * self.gap**3 / (12.0 * self.viscosity * self.length)

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes."""
        whole = self.conductance
        return whole * (supply_pressure - recess_pressure), -whole, whole


@dataclass(frozen=True)
class ConstantFlow:
    """A pump for every recess: Q = Q_p - k p. It spends the pressure of its recess.

    Attributes
    ----------
    flow : float
        m3/s.
    leakage : float
        m3/(s Pa).
    """

    flow: float
    leakage: float = 0.0

    def __post_init__(self) -> None:
        positive(flow=self.flow)
        if not 0.0 <= self.leakage < math.inf:
            raise InputError("E101", f"leakage is {self.leakage} m3/(s Pa); it must be zero or positive.")

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes; the supply pressure has no say."""
        return self.flow - self.leakage * recess_pressure, -self.leakage, 0.0


@dataclass(frozen=True)
class MeteredFlow:
    """A metering stage before every recess: a constant flow, m3/s, throttled from the pressure of the supply."""

    flow: float

    def __post_init__(self) -> None:
        positive(flow=self.flow)

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes; neither pressure has a say."""
        return self.flow, 0.0, 0.0


@dataclass(frozen=True)
class FlowValve:
    """A valve that lets more oil pass the higher the recess pressure, within what its open ports pass.

    Q = min(Q_0 + k p, G_max (p_s - p)).

    Attributes
    ----------
    flow : float
        Q_0, m3/s.
    gain : float
        k, m3/(s Pa).
    open_conductance : float
        G_max, m3/(s Pa).
    """

    flow: float
    gain: float
    open_conductance: float

    def __post_init__(self) -> None:
        positive(flow=self.flow, gain=self.gain, open_conductance=self.open_conductance)

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes."""
        controlled = self.flow + self.gain * recess_pressure
        passed = self.open_conductance * (supply_pressure - recess_pressure)
        if controlled <= passed:
            return controlled, self.gain, 0.0
        return passed, -self.open_conductance, self.open_conductance


@dataclass(frozen=True)
class MembraneValve:
    """A membrane whose gap opens with the recess pressure: Q = G_m (1 + s p)^3 (p_s - p).

    Attributes
    ----------
    conductance : float
        G_m, m3/(s Pa).
    compliance : float
        s, of the gap over the gap at p = 0, 1/Pa.
    """

    conductance: float
    compliance: float

    def __post_init__(self) -> None:
        positive(conductance=self.conductance, compliance=self.compliance)

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes."""
        opening = max(1.0 + self.compliance * recess_pressure, 0.0)
        own = self.conductance * opening**3
        drop = supply_pressure - recess_pressure
        return own * drop, -own + 3.0 * self.compliance * self.conductance * opening**2 * drop, own


@dataclass(frozen=True)
class CheckValve:
    """A restrictor behind a valve that lets no oil back."""

    restrictor: Capillary | Orifice | Slot

    def law(self, recess_pressure: float, supply_pressure: float) -> Law:
        """Flow and slopes; nothing where the recess stands above the supply."""
        if recess_pressure >= supply_pressure:
            return 0.0, 0.0, 0.0
        return self.restrictor.law(recess_pressure, supply_pressure)


Restrictor = Capillary | Orifice | Slot | ConstantFlow | MeteredFlow | FlowValve | MembraneValve | CheckValve
"""All laws."""
