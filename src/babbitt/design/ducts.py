"""Pressure lost between the supply system and the supply element."""

from __future__ import annotations

import math
from dataclasses import dataclass

LAMINAR_UP_TO, TURBULENT_FROM = 2300.0, 4000.0
"""Reynolds numbers of pipe flow between which the friction factor is blended linearly."""


def pipe_friction_factor(reynolds_number: float) -> float:
    """Darcy friction factor of a smooth pipe: Hagen-Poiseuille, Blasius, and a linear blend between.

    >>> pipe_friction_factor(800.0)
    0.08
    """
    if reynolds_number <= LAMINAR_UP_TO:
        return 64.0 / reynolds_number
    if reynolds_number >= TURBULENT_FROM:
        return 0.3164 * math.pow(reynolds_number, -0.25)
    share = (reynolds_number - LAMINAR_UP_TO) / (TURBULENT_FROM - LAMINAR_UP_TO)
    return (1.0 - share) * 64.0 / LAMINAR_UP_TO + share * 0.3164 * math.pow(TURBULENT_FROM, -0.25)


@dataclass(frozen=True)
class Duct:
    """A tube or a hole on the way of the oil.

    Attributes
    ----------
    diameter, length : float
        In m.
    loss_coefficient : float
        Sum of the local loss coefficients (a hole: 0.5 entrance + 1 exit).
    number : float
        Equal ducts in parallel that share the flow.
    """

    diameter: float
    length: float = 0.0
    loss_coefficient: float = 0.0
    number: float = 1.0

    def reynolds_number(self, flow: float, kinematic_viscosity: float) -> float:
        """Of a flow in m³/s, with the mean velocity and the diameter."""
        return 4.0 * flow / (self.number * math.pi * self.diameter * kinematic_viscosity)

    def pressure_loss(self, flow: float, density: float, kinematic_viscosity: float) -> float:
        """Pressure loss in Pa of a flow in m³/s.

        ``Δp = (λ l/d + Σζ) ρ v²/2`` with the mean velocity v (Darcy-Weisbach).
        """
        velocity = flow / self.number / (math.pi / 4.0 * self.diameter**2)
        reynolds_number = velocity * self.diameter / kinematic_viscosity
        if reynolds_number <= 0.0:
            return 0.0
        friction = pipe_friction_factor(reynolds_number) * self.length / self.diameter
        return (friction + self.loss_coefficient) * density * velocity**2 / 2.0
