"""What shafts, shells and housings are made of."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from babbitt.core.notices import InputError


@dataclass(frozen=True)
class StructuralMaterial:
    """Material of a shaft, a shell or a housing, about room temperature.

    Attributes
    ----------
    name, kind : str
        Designation and what it is.
    thermal_expansion : float
        Coefficient of linear expansion in 1/K.
    thermal_conductivity : float
        In W/(m K).
    elastic_modulus : float
        Young's modulus in Pa.
    poisson_ratio : float
        Dimensionless, above 0 and below 0.5.
    density : float
        In kg/m3.
    source : str
        Where the numbers come from.
    aliases : tuple of str
        Other names it is found by.
    origin : str
        File of the user's own catalogue that it stands in; empty for all others.

    Raises
    ------
    InputError
        E003 if a property is not a positive finite number or Poisson's ratio is not below 0.5.
    """

    name: str
    kind: str
    thermal_expansion: float
    thermal_conductivity: float
    elastic_modulus: float
    poisson_ratio: float
    density: float
    source: str
    aliases: tuple[str, ...] = ()
    origin: str = ""

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, int | float) and not (math.isfinite(value) and value > 0.0):
                raise InputError("E003", f"{field.name} of {self.name} must be a positive number, given {value!r}")
        if self.poisson_ratio >= 0.5:
            raise InputError(
                "E003", f"poisson_ratio of {self.name} must be below 0.5, given {self.poisson_ratio!r}"
            )
