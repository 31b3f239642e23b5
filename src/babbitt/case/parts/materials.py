"""What bearing and journal are made of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, exactly_one, refused, rule
from babbitt.case.parts.fields import Name
from babbitt.case.shorthand import Shorthand
from babbitt.core.notices import InputError, Notice
from babbitt.core.units import si
from babbitt.properties.materials import (
    AlloyFamily,
    BearingMetal,
    SourcedText,
    SourcedValue,
    bearing_metal,
    structural_material,
)

OWN = "metal of the case"
"""Source of the limits of a metal of one's own."""

Family = Literal[
    "tin-based", "lead-based", "copper-lead", "copper-tin", "copper-aluminium", "copper-zinc", "aluminium-tin",
    "aluminium-zinc", "aluminium-silicon", "other",
]  # fmt: skip
"""Values of `AlloyFamily`."""


class Structure(Part):
    """Material of a shell or a shaft: a name of the catalogue, or its thermal expansion."""

    name: Name | None = Field(None, description="Name in the catalogue, see `babbitt list materials`.")
    thermal_expansion: Annotated[float, si("1/K", "0 1/K", "100e-6 1/K")] | None = Field(
        None, description="Coefficient of linear thermal expansion."
    )

    @rule
    def _name_or_number(self) -> Iterator[Issue]:
        yield from exactly_one(self, "name", "thermal_expansion")

    @rule
    def _name_is_known(self) -> Iterator[Issue]:
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


StructureInput = Annotated[Structure, Shorthand(_named, "a name in the catalogue")]


class Metal(Part):
    """A bearing metal: a name of the catalogue, or a metal of one's own with its limits.

    Limits beside a name of the catalogue stand in place of the catalogue's; its others remain.
    """

    example: ClassVar[str] = "{name: Own bronze, family: copper-tin, specific_load: 12 MPa, temperature: 140 degC}"

    name: Name = Field(description="Name in the catalogue, see `babbitt list materials`; of one's own metal any.")
    family: Family | None = Field(
        None, description="Family of one's own metal, whose general limits hold where it has none. None: other."
    )
    specific_load: Annotated[float, si("Pa", "0 MPa", "200 MPa")] | None = Field(
        None, description="Largest specific load of one's own metal."
    )
    sliding_speed: Annotated[float, si("m/s", "0 m/s", "300 m/s")] | None = Field(
        None, description="Largest surface speed of one's own metal."
    )
    load_times_speed: Annotated[float, si("Pa m/s", "0 MPa m/s", "10000 MPa m/s")] | None = Field(
        None, description="Largest specific load times surface speed of one's own metal."
    )
    temperature: Annotated[float, si("K", "0 degC", "400 degC")] | None = Field(
        None, description="Highest temperature of one's own metal."
    )

    @rule
    def _name_is_known(self) -> Iterator[Issue]:
        if not self._is_own():
            own = "a metal of one's own has its family or one of its limits beside the name"
            yield from (replace(issue, hint=own) for issue in refused(("name",), lambda: bearing_metal(self.name)))

    def in_the_catalogue(self) -> BearingMetal | None:
        """The metal of the catalogue of that name; None for one of one's own."""
        try:
            return bearing_metal(self.name)
        except InputError:
            if not self._is_own():
                raise
            return None

    def _with_own_limits(self, known: BearingMetal) -> BearingMetal:
        own = {
            "specific_load": self.specific_load,
            "sliding_speed": self.sliding_speed,
            "pv": self.load_times_speed,
        }
        loads = {name: SourcedValue(value, OWN) for name, value in own.items() if value is not None}
        heat = known.limiting_temperature if self.temperature is None else SourcedValue(self.temperature, OWN)
        return replace(
            known,
            family=known.family if self.family is None else AlloyFamily(self.family),
            calm=replace(known.calm, **loads),
            shock=replace(known.shock, **loads),
            limiting_temperature=heat,
            stands_for=known,
        )

    def _is_own(self) -> bool:
        own = (self.family, self.specific_load, self.sliding_speed, self.load_times_speed, self.temperature)
        return any(value is not None for value in own)

    def metal(self) -> BearingMetal:
        """Give the metal with its limits, those of one's own for loads of every character."""
        known = self.in_the_catalogue()
        if known is None:
            family = AlloyFamily(self.family or AlloyFamily.OTHER)
            known = BearingMetal(self.name, family, OWN, SourcedText("not given", OWN))
        return self._with_own_limits(known) if self._is_own() else known


def warnings_about_family(metal: Metal) -> Iterator[Notice]:
    """Question a metal of the catalogue that is given another family: limits of both would be mixed."""
    known = metal.in_the_catalogue()
    if known is not None and metal.family is not None and known.family.value != metal.family:
        yield Notice("W175", values={"metal": known.name, "known": known.family.value, "given": metal.family})


MetalInput = Annotated[Metal, Shorthand(_named, "a name in the catalogue")]


class LinedMaterials(Part):
    """Bearing metal, and how the load acts on it."""

    bearing_metal: MetalInput | None = Field(
        None, description="Bearing metal. Without it no specific load is checked, and no bearing passes."
    )
    load_character: Literal["calm", "shock"] | None = Field(
        None, description="How the load acts on the bearing metal. calm if not given."
    )

    def metal(self) -> BearingMetal | None:
        """Give the bearing metal; None where it is not named."""
        return None if self.bearing_metal is None else self.bearing_metal.metal()


class Materials(LinedMaterials):
    """Materials. A bearing may give single fields and take the others from its machine."""

    example: ClassVar[str] = "{bearing: C10, journal: 42CrMo4}"

    bearing: StructureInput | None = Field(
        None, description="Material of shell or housing, whose thermal expansion widens the bore."
    )
    journal: StructureInput | None = Field(None, description="Material of the journal.")
