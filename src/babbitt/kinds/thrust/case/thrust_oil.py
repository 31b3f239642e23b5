"""How warm, and so how viscous, the oil of thrust pads is."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.error_messages import MISSING
from babbitt.case.part import Issue, Part
from babbitt.case.parts.lubricant import LubricantInput
from babbitt.case.parts.supply import OilTemperature
from babbitt.core.units import ZERO_CELSIUS, si
from babbitt.kinds.thrust.design import Oil
from babbitt.kinds.thrust.heat import USUAL_CARRY_OVER
from babbitt.properties.lubricants import ConstantViscosity, Lubricant, OilProperties, lubricant_from_law


class PrescribedViscosity(Part):
    """The viscosity of the films is known."""

    kind: Literal["viscosity"] = Field(description="Viscosity of the films is given.")
    viscosity: Annotated[float, si("Pa s", "0.01 mPa s", "100 Pa s")] = Field(description="Effective viscosity.")
    density: Annotated[float, si("kg/m3", "100 kg/m3", "3000 kg/m3")] = Field(
        880.0, description="Density, which only the Reynolds number needs."
    )

    def oil(self, lubricant: LubricantInput | None, supplied_at: float | None) -> Oil:
        """Give the oil of the calculation."""
        name = f"oil of {1e3 * self.viscosity:.4g} mPa s"
        known = OilProperties(density=self.density)
        return Oil(lubricant_from_law(name, ConstantViscosity(self.viscosity), known, source="given in the case"))


class OilAtTemperature(Part):
    """The effective temperature of the films is known."""

    kind: Literal["temperature"] = Field(description="Temperature of the films is given.")
    temperature: OilTemperature = Field(description="Effective temperature of the films.")

    def oil(self, lubricant: LubricantInput | None, supplied_at: float | None) -> Oil:
        """Give the oil of the calculation."""
        return Oil(_known(lubricant), effective_temperature=self.temperature)


class OilByBalance(Part):
    """The effective temperature follows from friction and flow."""

    kind: Literal["heat_balance"] = Field(description="Temperature of each pad by its heat balance.")
    carry_over: Annotated[float, si("1", "0", "0.99")] = Field(
        USUAL_CARRY_OVER,
        description="Share of the hot oil leaving a pad over its trailing edge that enters the next one. 0.75 "
        "is an "
        "assumption; 0.7 to 0.9 are found at usual speeds, less with sprayed or scraped grooves.",
    )

    def oil(self, lubricant: LubricantInput | None, supplied_at: float | None) -> Oil:
        """Give the oil of the calculation."""
        return Oil(_known(lubricant), supply_temperature=supplied_at, carry_over=self.carry_over)


def _known(lubricant: LubricantInput | None) -> Lubricant:
    if lubricant is None:
        raise ValueError("a case that was not validated: the lubricant is missing")
    return lubricant.lubricant()


def issues_of(oil: ThrustOil, lubricant: LubricantInput | None, supplied_at: float | None) -> Iterator[Issue]:
    """Complain of a lubricant or a temperature that is missing, or that do not go together."""
    if isinstance(oil, PrescribedViscosity):
        return
    if lubricant is None:
        hint = "needed: The lubricant, such as ISO VG 100"
        yield Issue(("lubricant",), MISSING, hint=hint, code="E003")
    if isinstance(oil, OilByBalance) and supplied_at is None:
        hint = "needed: Temperature of the fresh oil, such as '45 degC'"
        yield Issue(("supply", "temperature"), MISSING, hint=hint, code="E003")
    if lubricant is not None and isinstance(oil, OilAtTemperature):
        yield from _covered(lubricant, oil.temperature, "oil", "temperature")
    if lubricant is not None and isinstance(oil, OilByBalance) and supplied_at is not None:
        yield from _covered(lubricant, supplied_at, "supply", "temperature")


def _covered(given: LubricantInput, temperature: float, *path: str) -> Iterator[Issue]:
    oil = given.lubricant()
    if not oil.covers(temperature):
        low, high = (kelvin - ZERO_CELSIUS for kelvin in oil.temperature_range)
        yield Issue(
            path,
            f"{temperature - ZERO_CELSIUS:.4g} degC lies outside the data of {oil.name}",
            f"{low:.4g} degC to {high:.4g} degC",
            code="E006",
        )


ThrustOil = Annotated[PrescribedViscosity | OilAtTemperature | OilByBalance, Discriminator("kind")]
