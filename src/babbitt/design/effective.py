"""The oil of a film of many temperatures at their mean, for the numbers that every method gives."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.design.conditions import CheckedProblem
from babbitt.design.oil import properties_at


@dataclass(frozen=True)
class EffectiveFilm:
    """What `babbitt.design.values` needs of a film, with the oil at one temperature; SI."""

    temperature: float
    relative_clearance: float
    density: float
    viscosity: float
    volumetric_heat_capacity: float
    load: float
    friction_power: float
    total_flow: float

    @classmethod
    def of(
        cls,
        case: CheckedProblem,
        temperature: float,
        clearance: float,
        load: float,
        friction_power: float,
        flow: float,
    ) -> EffectiveFilm:
        """Film of a case with the properties of its oil at the mean temperature (K); `clearance` is relative.

        Raises
        ------
        NoFilmError
            When a law of the lubricant has no usable value there.
        """
        density, viscosity, heat_capacity = properties_at(case.lubricant, temperature)
        return cls(temperature, clearance, density, viscosity, heat_capacity, load, friction_power, flow)
