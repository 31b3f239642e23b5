"""The films of all pads in equilibrium."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.design.pad_heat import Temperatures
from babbitt.reynolds.tilting_pads.solution import TiltingPadSolution
from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution

__all__ = ["PadFilms"]


@dataclass(frozen=True, eq=False)
class PadFilms:
    """Films of all pads, at one temperature or with their own, SI.

    Attributes
    ----------
    temperature, density, viscosity, volumetric_heat_capacity : float
        Of the oil in the films, the temperature as a mean where films have their own.
    relative_clearance : float
        Machined clearance of the pads over the radius, to which the Reynolds number belongs.
    solution : TiltingPadSolution
        Its bearing is that which runs: with clearances and bores as growth and bending leave them, and with the
        viscosity of every pad at the mean temperature of its film where films have their own.
    fresh_flow : float
        Oil that the leading edges draw in besides what is carried over, m3/s.
    temperatures : Temperatures or None
        Of the mixing between the pads; None where the temperature of the films is given, or they have their own.
    """

    temperature: float
    density: float
    viscosity: float
    volumetric_heat_capacity: float
    relative_clearance: float
    solution: TiltingPadSolution
    fresh_flow: float
    temperatures: Temperatures | None

    @property
    def thermal(self) -> ThermalTiltingPadSolution | None:
        """The films with their own temperatures; None where all have one."""
        return self.solution if isinstance(self.solution, ThermalTiltingPadSolution) else None

    @property
    def load(self) -> float:
        """Force of the films, N."""
        return self.solution.load

    @property
    def friction_power(self) -> float:
        """W."""
        return self.solution.friction_power

    @property
    def total_flow(self) -> float:
        """Fresh oil, m3/s."""
        return self.fresh_flow
