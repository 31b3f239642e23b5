"""How the oil of the film method flows and thickens: turbulence, viscosity under pressure."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.part import Part
from babbitt.core.units import si
from babbitt.kinds.journal.film.model import OilUnderPressure, PressureLaw
from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN, TurbulenceLaw

__all__ = ["LAWS_OF_TURBULENCE", "PressureViscosityInput", "TurbulenceInput"]

TurbulenceInput = Literal["laminar", "ng_pan", "constantinescu"]

LAWS_OF_TURBULENCE: dict[str, TurbulenceLaw | None] = {
    "laminar": None,
    "ng_pan": NG_PAN,
    "constantinescu": CONSTANTINESCU,
}


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
