"""How the oil of the film method thickens under pressure."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.part import Part
from babbitt.core.units import si
from babbitt.kinds.journal.film.model import OilUnderPressure, PressureLaw

__all__ = ["PressureViscosityInput"]


class PressureViscosityInput(Part):
    """How the viscosity grows with the pressure in the film."""

    kind: Literal["barus", "roelands"] = Field(
        description="exp(alpha p) by Barus, or the law of Roelands, which grows less at high pressure."
    )
    coefficient: Annotated[float, si("1/Pa", "0.1 1/GPa", "100 1/GPa")] = Field(
        description="Slope alpha of ln(viscosity) over pressure, at ambient pressure and film temperature."
    )

    def law(self) -> OilUnderPressure:
        """Give the law of the calculation."""
        return OilUnderPressure(PressureLaw(self.kind), self.coefficient)
