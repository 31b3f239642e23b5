"""What bearing and journal are made of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from babbitt.cases.fields import Name
from babbitt.cases.part import Complaint, Part, exactly_one, refused, rule
from babbitt.cases.shorthand import Shorthand
from babbitt.materials import bearing_metal, structural_material
from babbitt.units import si


class Structure(Part):
    """Material of a shell or a shaft: a name of the catalogue, or its thermal expansion."""

    name: Name | None = Field(None, description="Name in the catalogue, see `babbitt list materials`.")
    thermal_expansion: Annotated[float, si("1/K", "0 1/K", "100e-6 1/K")] | None = Field(
        None, description="Coefficient of linear thermal expansion."
    )

    @rule
    def _name_or_number(self) -> Iterator[Complaint]:
        yield from exactly_one(self, "name", "thermal_expansion")

    @rule
    def _name_is_known(self) -> Iterator[Complaint]:
        name = self.name
        if name is not None:
            yield from refused(("name",), lambda: structural_material(name))

    def expansion(self) -> float:
        """Give the coefficient of linear thermal expansion in 1/K."""
        if self.thermal_expansion is not None:
            return self.thermal_expansion
        return structural_material(self.name or "").thermal_expansion


def _named(given: Any) -> Any:
    return {"name": given} if isinstance(given, str) else given


StructureGiven = Annotated[Structure, Shorthand(_named, "a name in the catalogue")]


class Materials(Part):
    """Materials. A bearing may give single fields and take the others from its machine."""

    example: ClassVar[str] = "{bearing: C10, journal: 42CrMo4}"

    bearing_metal: Name | None = Field(
        None, description="Bearing metal, a name of the catalogue. Without it no limits of the metal are checked."
    )
    load_character: Literal["calm", "shock"] | None = Field(
        None, description="How the load acts on the bearing metal. calm if not given."
    )
    bearing: StructureGiven | None = Field(
        None, description="Material of shell or housing, whose thermal expansion widens the bore."
    )
    journal: StructureGiven | None = Field(None, description="Material of the journal.")

    @rule
    def _metal_is_known(self) -> Iterator[Complaint]:
        name = self.bearing_metal
        if name is not None:
            yield from refused(("bearing_metal",), lambda: bearing_metal(name))
