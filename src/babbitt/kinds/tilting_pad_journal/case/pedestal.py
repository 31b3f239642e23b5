"""What the housing of a tilting-pad bearing stands on."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Part
from babbitt.core.units import si
from babbitt.reynolds.tilting_pads.pedestal import Pedestal

__all__ = ["PedestalInput"]

Stiffness = Annotated[float, si("N/m", "1 kN/m", "1000 GN/m")]
Damping = Annotated[float, si("N s/m", "0 N s/m", "1000 MN s/m")]


class PedestalInput(Part):
    """Pedestal and housing that give way under the bearing."""

    example: ClassVar[str] = "{stiffness_x: 0.6 GN/m, stiffness_y: 1 GN/m, damping_y: 50 kN s/m, mass: 800 kg}"

    stiffness_x: Stiffness = Field(description="Stiffness along x, horizontally.")
    stiffness_y: Stiffness = Field(description="Stiffness along y, vertically.")
    damping_x: Damping = Field(0.0, description="Damping along x.")
    damping_y: Damping = Field(0.0, description="Damping along y.")
    mass: Annotated[float, si("kg", "0 kg", "10000 t")] = Field(
        0.0, description="Mass that moves with the housing, without the pads."
    )

    def pedestal(self) -> Pedestal:
        """Give the pedestal of the calculation."""
        return Pedestal((self.stiffness_x, self.stiffness_y), (self.damping_x, self.damping_y), self.mass)
