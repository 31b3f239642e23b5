"""What pads, journal and housing are made of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar

from pydantic import Field

from babbitt.case.part import Issue, Part, is_given, refused, rule
from babbitt.case.parts.fields import Name
from babbitt.case.parts.materials import LinedMaterials, StructureInput
from babbitt.case.shorthand import Shorthand
from babbitt.core.units import si
from babbitt.properties.materials import structural_material

__all__ = ["PadJournalMaterials", "PadStructureInput"]


class PadStructure(Part):
    """Material of the pads behind their lining: a name of the catalogue, or numbers."""

    example: ClassVar[str] = "{elastic_modulus: 210 GPa, thermal_expansion: 12e-6 1/K}"

    name: Name | None = Field(None, description="Name in the catalogue, see `babbitt list materials`.")
    elastic_modulus: Annotated[float, si("Pa", "1 GPa", "1000 GPa")] | None = Field(
        None, description="Young's modulus. That of the name if not given."
    )
    thermal_expansion: Annotated[float, si("1/K", "0 1/K", "100e-6 1/K")] | None = Field(
        None, description="Coefficient of linear thermal expansion. That of the name if not given."
    )

    conductivity: Annotated[float, si("W/(m K)", "0.1 W/(m K)", "1000 W/(m K)")] | None = Field(
        None, description="Thermal conductivity. That of the name if not given."
    )
    poisson_ratio: Annotated[float, si("1", "0", "0.5")] | None = Field(
        None, description="Poisson's ratio, of pads that bend as plates. That of the name if not given."
    )

    @rule
    def _name_is_known(self) -> Iterator[Issue]:
        name = self.name
        if name is not None:
            yield from refused(("name",), lambda: structural_material(name))

    def known(self, field: str) -> float | None:
        """A number of the material, by its field here: its own, else that of its name; None where neither is."""
        if is_given(self, field):
            return float(getattr(self, field))
        named = {"conductivity": "thermal_conductivity"}.get(field, field)
        return None if self.name is None else float(getattr(structural_material(self.name), named))


def _named(given: Any) -> Any:
    return {"name": given} if isinstance(given, str) else given


PadStructureInput = Annotated[PadStructure, Shorthand(_named, "a name in the catalogue")]


class PadJournalMaterials(LinedMaterials):
    """What pads, their lining, journal and housing are made of."""

    example: ClassVar[str] = "{bearing_metal: SnSb12Cu6Pb, pads: C45}"

    pads: PadStructureInput | None = Field(
        None, description="Material of the pads, which bends, grows and conducts heat."
    )
    journal: StructureInput | None = Field(
        None, description="Material of the journal, which grows. Steel if not given, an assumption."
    )
    housing: StructureInput | None = Field(
        None, description="Material of the housing, which grows. Steel if not given, an assumption."
    )
