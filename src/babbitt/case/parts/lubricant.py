"""The lubricant: a name of the catalogue, or what a data sheet or a law says of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, at_most_one, exactly_one, is_given, refused, rule
from babbitt.case.parts.fields import Name, WholeNumber
from babbitt.case.parts.own_lubricant import (
    DynamicPoint,
    DynamicViscosity,
    KinematicPoint,
    KinematicViscosity,
    OwnLubricant,
    ViscosityPoint,
    VolumetricHeatCapacity,
)
from babbitt.case.shorthand import Shorthand
from babbitt.core.notices import InputError
from babbitt.core.units import si, written
from babbitt.properties.lubricants import (
    AstmD341,
    ConstantViscosity,
    Exponential,
    Lubricant,
    PowerLaw,
    TabulatedViscosity,
    ViscosityKind,
    Vogel,
    Walther,
    lubricant,
    lubricant_from_law,
    lubricant_from_points,
    lubricant_from_viscosity_index,
)

_AT_40, _AT_100 = 313.15, 373.15
USUAL_AT_50 = (0.1e-6, 1e5 * 1e-6)
"""m2/s at 50 degC, the range of all viscosities in a case; outside, constants of a law were mistaken."""

LUBRICANT = (
    "The lubricant: a name of the catalogue such as ISO VG 46, or viscosities of a data sheet. "
    "`babbitt list lubricants` lists all names, and so does the workbench under Oils and metals."
)
"""What a case field for a lubricant is for."""

ViscosityIndex = Annotated[float, si("1", "-100", "400")]


class CatalogueLubricant(Part):
    """A lubricant of the catalogue. Its name alone will do."""

    kind: Literal["catalogue"] = Field(description="Lubricant of the catalogue.")
    name: Name = Field(description="Name in the catalogue, see `babbitt list lubricants`.")
    volumetric_heat_capacity: VolumetricHeatCapacity | None = Field(
        None, description="Constant density times heat capacity in place of the catalogue's."
    )

    @rule
    def _included(self) -> Iterator[Issue]:
        yield from refused(("name",), lambda: lubricant(self.name))

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        found = lubricant(self.name)
        if self.volumetric_heat_capacity is None:
            return found
        return found.with_volumetric_heat_capacity(self.volumetric_heat_capacity)


class IsoVgLubricant(OwnLubricant):
    """An ISO viscosity grade of ISO 3448."""

    kind: Literal["iso_vg"] = Field(description="ISO viscosity grade.")
    grade: Annotated[int, WholeNumber(2, 3200)] = Field(description="ISO VG number, nu at 40 degC in mm2/s.")
    viscosity_index: ViscosityIndex = Field(95.0, description="Viscosity index. 95 as of a plain mineral oil.")

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        name = self.name if is_given(self, "name") else f"ISO VG {self.grade}"
        return lubricant_from_viscosity_index(
            name, self.grade * 1e-6, self.viscosity_index, self.properties, source=self.source
        )


class ViscosityIndexLubricant(OwnLubricant):
    """An oil by its viscosity at 40 degC and its viscosity index."""

    kind: Literal["viscosity_index"] = Field(description="By nu40 and viscosity index (ISO 2909).")
    nu40: KinematicViscosity = Field(description="Kinematic viscosity at 40 degC.")
    viscosity_index: ViscosityIndex = Field(description="Viscosity index.")

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        return lubricant_from_viscosity_index(
            self.name, self.nu40, self.viscosity_index, self.properties, source=self.source
        )


class TwoPointLubricant(OwnLubricant):
    """An oil by two kinematic viscosities, at 40 and 100 degC or at other temperatures."""

    kind: Literal["two_points"] = Field(description="By two kinematic viscosities (Walther, ASTM D341).")
    nu40: KinematicViscosity | None = Field(None, description="Kinematic viscosity at 40 degC.")
    nu100: KinematicViscosity | None = Field(None, description="Kinematic viscosity at 100 degC.")
    points: tuple[KinematicPoint, KinematicPoint] | None = Field(
        None, description="Two viscosities at other temperatures, in place of nu40 and nu100."
    )
    form: Literal["walther", "astm_d341"] = Field(
        "walther",
        description="Law through the points: lg lg (nu + 0.7), or ASTM D341 with its term for oils below 2 mm2/s.",
    )

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        if self.points is not None:
            colder, warmer = (point.pair for point in self.points)
        else:
            colder, warmer = (_AT_40, self.nu40 or 0.0), (_AT_100, self.nu100 or 0.0)
        law = AstmD341 if self.form == "astm_d341" else Walther
        return lubricant_from_points(self.name, colder, warmer, self.properties, source=self.source, law=law)

    @rule
    def _lubricant_can_be_made(self) -> Iterator[Issue]:
        yield from at_most_one(self, "points", "nu40")
        yield from at_most_one(self, "points", "nu100")
        if self.points is not None:
            yield from refused(("points",), self.lubricant)
            return
        for name in ("nu40", "nu100"):
            if not is_given(self, name):
                yield Issue((name,), "is missing", "nu40 and nu100, or points", code="E003")
        if self.nu40 is None or self.nu100 is None:
            return
        if self.nu100 >= self.nu40:
            thick, thin = written(self.nu40, "mm2/s"), written(self.nu100, "mm2/s")
            says = f"nu100 {thin} is not below nu40 {thick}: an oil is thinner at 100 degC"
            yield Issue(("nu100",), says, f"less than {thick}", "are the two exchanged?")
            return
        yield from refused(("nu100",), self.lubricant)


class WaltherLubricant(OwnLubricant):
    """An oil by the constants of Walther's law, as studies and older data sheets print them."""

    kind: Literal["walther"] = Field(description="Walther's law, lg lg (nu + a) = A - B lg T, nu in mm2/s.")
    intercept: Annotated[float, si("1", "1", "40")] = Field(description="Constant A, for nu in mm2/s and T in K.")
    slope: Annotated[float, si("1", "0.1", "15")] = Field(description="Constant B.")
    additive: Annotated[float, si("m2/s", "0 mm2/s", "1 mm2/s")] = Field(
        0.7e-6,
        description="Constant a that is added to nu: 0.6 mm2/s in Walther's older form, 0.8 mm2/s in DIN 51563. "
        "0.7 mm2/s as in ASTM D341 if not given.",
    )

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        law = Walther(self.intercept, self.slope, self.additive * 1e6)
        return lubricant_from_law(self.name, law, self.properties, source=self.source)

    @rule
    def _is_an_oil(self) -> Iterator[Issue]:
        thinnest, thickest = USUAL_AT_50
        law = Walther(self.intercept, self.slope, self.additive * 1e6)
        try:
            found = float(law(323.15))
        except (InputError, OverflowError):
            found = math.inf
        if not thinnest <= found <= thickest:
            says = f"A = {self.intercept:g} and B = {self.slope:g} give no oil: at 50 degC "
            says += f"{written(found, 'mm2/s')}" if math.isfinite(found) else "no viscosity at all"
            allowed = f"{written(thinnest, 'mm2/s')} to {written(thickest, 'mm2/s')} at 50 degC"
            yield Issue(("intercept",), says, allowed, "decimal logarithms, nu in mm2/s, T in K?")


class VogelLubricant(OwnLubricant):
    """An oil by Vogel's law, through three points or by its constants."""

    kind: Literal["vogel"] = Field(description="Vogel's law, eta = a exp(b/(T - c)).")
    points: tuple[DynamicPoint, DynamicPoint, DynamicPoint] | None = Field(
        None, description="Three dynamic viscosities that the law passes through."
    )
    factor: Annotated[float, si("Pa s", "1e-9 Pa s", "10 Pa s")] | None = Field(None, description="Constant a.")
    activation: Annotated[float, si("K difference", "1 K", "20000 K")] | None = Field(
        None, description="Constant b, a temperature difference."
    )
    pole: Annotated[float, si("K", "-273.15 degC", "100 degC")] | None = Field(
        None, description="Constant c, about -95 degC for mineral oils."
    )

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        if self.points is not None:
            law = Vogel.through(*(point.pair for point in self.points))
        else:
            law = Vogel(self.factor or 0.0, self.activation or 0.0, self.pole or 0.0)
        return lubricant_from_law(self.name, law, self.properties, source=self.source)

    @rule
    def _lubricant_can_be_made(self) -> Iterator[Issue]:
        yield from exactly_one(self, "points", "factor")
        constants = [name for name in ("factor", "activation", "pole") if is_given(self, name)]
        if self.points is None and len(constants) < 3:
            if constants:
                yield Issue((), "Vogel's law needs all its constants", "factor, activation, pole", code="E003")
            return
        yield from refused((), self.lubricant)


class ExponentialLubricant(OwnLubricant):
    """An oil by Reynolds' exponential law through two points, good between them only."""

    kind: Literal["exponential"] = Field(description="Exponential law through two points.")
    points: tuple[DynamicPoint, DynamicPoint] = Field(description="Two dynamic viscosities.")

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        law = Exponential.through(*(point.pair for point in self.points))
        return lubricant_from_law(self.name, law, self.properties, source=self.source)


class TableLubricant(OwnLubricant):
    """An oil by a table of viscosities, with Andrade's law from point to point."""

    kind: Literal["table"] = Field(description="By viscosities at several temperatures (Andrade between them).")
    points: tuple[ViscosityPoint, ...] = Field(
        min_length=3,
        max_length=500,
        description="Viscosities at rising temperatures, all dynamic or all kinematic; good from the first to the "
        "last.",
    )

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        dynamic = self.points[0].dynamic_viscosity is not None
        kind = ViscosityKind.DYNAMIC if dynamic else ViscosityKind.KINEMATIC
        law = TabulatedViscosity(tuple(point.pair for point in self.points), kind)
        return lubricant_from_law(self.name, law, self.properties, source=self.source)

    @rule
    def _lubricant_can_be_made(self) -> Iterator[Issue]:
        if len({point.dynamic_viscosity is None for point in self.points}) > 1:
            says = "some viscosities are dynamic, others kinematic"
            yield Issue(("points",), says, "dynamic_viscosity, or kinematic_viscosity, in all of them")
            return
        yield from refused(("points",), self.lubricant)


class PowerLawLubricant(OwnLubricant):
    """An oil by the power law nu = nu50 (50/t)^m with t in degC."""

    kind: Literal["power_law"] = Field(description="Power law, nu = nu50 (50/t)^m.")
    nu50: KinematicViscosity = Field(description="Kinematic viscosity at 50 degC.")
    exponent: Annotated[float, si("1", "0.1", "10")] = Field(description="Exponent m, 1.8 to 2.6 for usual oils.")

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        law = PowerLaw(self.nu50, self.exponent, ViscosityKind.KINEMATIC)
        return lubricant_from_law(self.name, law, self.properties, source=self.source)


class ConstantLubricant(OwnLubricant):
    """A fluid of the same viscosity at every temperature."""

    kind: Literal["constant"] = Field(description="The same viscosity at every temperature.")
    dynamic_viscosity: DynamicViscosity | None = Field(None, description="Dynamic viscosity.")
    kinematic_viscosity: KinematicViscosity | None = Field(None, description="Kinematic viscosity.")

    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""
        if self.dynamic_viscosity is not None:
            law = ConstantViscosity(self.dynamic_viscosity)
        else:
            law = ConstantViscosity(self.kinematic_viscosity or 0.0, ViscosityKind.KINEMATIC)
        return lubricant_from_law(self.name, law, self.properties, source=self.source)

    @rule
    def _lubricant_can_be_made(self) -> Iterator[Issue]:
        yield from exactly_one(self, "dynamic_viscosity", "kinematic_viscosity")


def _named(given: Any) -> Any:
    return {"kind": "catalogue", "name": given} if isinstance(given, str) else given


LubricantInput = Annotated[
    CatalogueLubricant
    | IsoVgLubricant
    | ViscosityIndexLubricant
    | TwoPointLubricant
    | WaltherLubricant
    | VogelLubricant
    | ExponentialLubricant
    | TableLubricant
    | PowerLawLubricant
    | ConstantLubricant,
    Discriminator("kind"),
    Shorthand(_named, "a name in the catalogue of lubricants"),
]
