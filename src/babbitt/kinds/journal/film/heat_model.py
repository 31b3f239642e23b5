"""How a film with its own temperatures is to be solved, as its case says it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from babbitt.reynolds.heat.heat_model import ConductingWalls
    from babbitt.reynolds.heat.thermal_growth import RingGrowth

__all__ = ["AxialTemperature", "HeatModel", "TemperatureCoefficients"]


class AxialTemperature(Enum):
    """How the temperature varies along the width."""

    MEAN = "mean"
    RESOLVED = "resolved"


class TemperatureCoefficients(Enum):
    """Whether temperatures follow the motion to which the stiffness answers."""

    FROZEN = "frozen"
    FOLLOWING = "following"


@dataclass(frozen=True)
class HeatModel:
    """Choices of a film with its own temperatures.

    Attributes
    ----------
    walls : ConductingWalls or None
        None: no heat leaves through bush and journal (adiabatic).
    axial_temperature : AxialTemperature
    coefficients : TemperatureCoefficients
    carry_over : float
        Share of the oil brought to a supply that goes on with the next film, see
        `babbitt.reynolds.heat.heat_model.FilmHeat`.
    growth : RingGrowth or None
        What distorts the bore by the uneven temperature of its bush; None: the bore keeps its form.
    """

    walls: ConductingWalls | None = None
    axial_temperature: AxialTemperature = AxialTemperature.MEAN
    coefficients: TemperatureCoefficients = TemperatureCoefficients.FROZEN
    carry_over: float = 1.0
    growth: RingGrowth | None = None

    @property
    def name(self) -> str:
        """``adiabatic`` or ``full``, as in the case language."""
        return "adiabatic" if self.walls is None else "full"
