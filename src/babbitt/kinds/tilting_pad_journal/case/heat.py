"""What takes heat from the films of pads, what of it deforms them, and what is assumed where a case is silent."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field

from babbitt.case.error_messages import MISSING
from babbitt.case.part import Issue, Part, is_given, refused
from babbitt.case.parts.walls import ConductingJournalInput, Conductivity, HeatTransfer, Surroundings
from babbitt.core.units import si, written
from babbitt.kinds.tilting_pad_journal.model import HeatChoices, Thermal
from babbitt.reynolds.heat.heat_model import JournalHeat
from babbitt.reynolds.tilting_pads.pad_heat import (
    HEAT_TRANSFER,
    STEEL_CONDUCTIVITY,
    STEEL_EXPANSION,
    PadBending,
    PadGrowth,
    PadWalls,
)

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase

__all__ = [
    "PadJournalWalls",
    "ReferenceTemperature",
    "heat_assumptions",
    "heat_choices",
    "heat_goes_with_the_films",
]

ReferenceTemperature = Annotated[float, si("K", "-30 degC", "200 degC")]


class ConductingPadsInput(Part):
    """The pads, which conduct heat from the films to their backs and edges."""

    example: ClassVar[str] = "{heat_transfer_coefficient: 100 W/(m2 K), temperature: 40 degC}"

    conductivity: Conductivity | None = Field(
        None, description="Thermal conductivity. That of materials.pads if not given, else 50 W/(m K) of steel."
    )
    heat_transfer_coefficient: HeatTransfer | None = Field(
        None, description="On the backs. 100 W/(m2 K) if not given, an assumption."
    )
    edge_coefficient: HeatTransfer | None = Field(
        None,
        description="Heat transfer coefficient on both edges, to the oil of their grooves. 100 W/(m2 K) if not "
        "given, an assumption.",
    )
    temperature: Surroundings | None = Field(
        None, description="Of the oil behind the pads. That of the fresh oil if not given, an assumption."
    )


class PadHousingInput(Part):
    """The housing around the pads, which makes room as it grows."""

    example: ClassVar[str] = "{temperature: 45 degC}"

    temperature: Surroundings | None = Field(
        None, description="Its temperature. That of the fresh oil if not given, an assumption."
    )


class PadJournalWalls(Part):
    """Pads, housing and journal, which take heat from full thermal films."""

    example: ClassVar[str] = "{pads: {temperature: 40 degC}, housing: {temperature: 45 degC}}"

    pads: ConductingPadsInput | None = Field(None, description="The pads. They take no heat if not given.")
    housing: PadHousingInput = Field(PadHousingInput(), description="The housing, for growth.")
    journal: ConductingJournalInput = Field(ConductingJournalInput(), description="The journal.")


def heat_goes_with_the_films(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of walls, materials and deformation that do not go with the films, and of what they lack."""
    if is_given(case, "walls") and case.thermal_model != "full":
        yield Issue(("walls",), "walls take heat from full thermal films only", "thermal: full")
        return
    if case.deformation and case.thermal_model != "full":
        says = "pads bend and grow by the temperatures of full thermal films"
        yield Issue(("deformation",), says, "thermal: full, with walls.pads")
        return
    if len(set(case.deformation)) < len(case.deformation):
        yield Issue(("deformation",), "names one word twice", "growth and bending, each once")
        return
    yield from refused(("walls", "pads"), lambda: pad_walls(case))
    yield from lacking(case)
    yield from idle(case)


def lacking(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """What deformation needs and the case does not give."""
    if not case.deformation:
        return
    words = " and ".join(case.deformation)
    if case.walls.pads is None:
        hint = f"{words} of pads needs their temperatures: pads that conduct, such as {{}}"
        yield Issue(("walls", "pads"), MISSING, hint=hint, code="E003")
    growing, bending = ("growth" in case.deformation, "bending" in case.deformation)
    if growing and case.reference_temperature is None:
        hint = "growth needs the temperature at which the clearances were measured, such as '20 degC'"
        yield Issue(("reference_temperature",), MISSING, hint=hint, code="E003")
    material = case.materials.pads
    if material is None:
        hint = f"{words} of pads needs their material, such as C45, or its expansion and elastic modulus"
        yield Issue(("materials", "pads"), MISSING, hint=hint, code="E003")
        return
    if bending and material.modulus() is None:
        hint = "bending needs the elastic modulus of the pads, such as '210 GPa', or materials.pads by its name"
        yield Issue(("materials", "pads", "elastic_modulus"), MISSING, hint=hint, code="E003")
    if material.expansion() is None:
        hint = f"{words} needs the expansion of the pads, such as '12e-6 1/K', or materials.pads by its name"
        yield Issue(("materials", "pads", "thermal_expansion"), MISSING, hint=hint, code="E003")


def idle(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """What is given and would make no difference."""
    growing, bending = ("growth" in case.deformation, "bending" in case.deformation)
    grow = f"{growth_with_what_it_needs(case)}, or leave it out"
    if case.reference_temperature is not None and not growing:
        says = "the temperature of the clearances counts for growth alone"
        yield Issue(("reference_temperature",), says, grow)
    if not growing:
        for name in ("journal", "housing"):
            if getattr(case.materials, name) is not None:
                says = f"the material of the {name} counts for growth alone"
                yield Issue(("materials", name), says, grow)
        if case.walls.housing.temperature is not None:
            says = "the temperature of the housing counts for growth alone"
            yield Issue(("walls", "housing", "temperature"), says, grow)
    journal = case.walls.journal
    if journal.ambient_temperature is not None and not journal.shaft_conductance:
        says = "the surroundings of a shaft that conducts no heat make no difference"
        yield Issue(("walls", "journal", "ambient_temperature"), says, "shaft_conductance, or leave it out")
    material = case.materials.pads
    if material is None:
        return
    if case.walls.pads is None and not case.deformation:
        says = "the material of pads that take no heat makes no difference"
        yield Issue(("materials", "pads"), says, "walls.pads such as {}, or leave it out")
    elif is_given(material, "elastic_modulus") and not bending:
        says = "the elastic modulus counts for bending alone"
        yield Issue(("materials", "pads", "elastic_modulus"), says, "deformation: [bending], or leave it out")
    elif is_given(material, "thermal_expansion") and not case.deformation:
        says = "thermal expansion counts for growth and bending alone"
        yield Issue(("materials", "pads", "thermal_expansion"), says, "deformation: [growth], or leave it out")


def growth_with_what_it_needs(case: TiltingPadJournalCase) -> str:
    """The choice of growth, with what else a case must give for it."""
    needs = [name for name, given in (
        ("thermal: full", case.thermal_model == "full"),
        ("walls.pads", case.walls.pads is not None),
        ("reference_temperature", case.reference_temperature is not None),
        ("materials.pads", case.materials.pads is not None),
    ) if not given]  # fmt: skip
    listed = " and ".join((", ".join(needs[:-1]), needs[-1]) if len(needs) > 1 else needs)
    return "deformation: [growth]" + (f" (which needs {listed}, too)" if needs else "")


def heat_choices(case: TiltingPadJournalCase, supply: float | None) -> HeatChoices:
    """What takes heat from the films at a temperature of the fresh oil, and what of it deforms the pads."""
    if Thermal(case.thermal_model) is not Thermal.FULL or supply is None:
        return HeatChoices()
    housing = case.walls.housing.temperature
    return HeatChoices(
        journal_heat(case.walls.journal, supply if housing is None else housing),
        pad_walls(case),
        pad_bending(case),
        pad_growth(case),
    )


def journal_heat(given: ConductingJournalInput, ambient: float) -> JournalHeat:
    """The journal, in surroundings of a temperature unless it has its own."""
    around = ambient if given.ambient_temperature is None else given.ambient_temperature
    return JournalHeat(given.temperature, given.shaft_conductance, around)


def pad_walls(case: TiltingPadJournalCase) -> PadWalls | None:
    """How the pads conduct; None where they take no heat."""
    pads, material = case.walls.pads, case.materials.pads
    if pads is None:
        return None
    named = None if material is None else material.conductivity()
    chosen = (pads.conductivity, named, STEEL_CONDUCTIVITY)
    return PadWalls(
        next(one for one in chosen if one is not None),
        HEAT_TRANSFER if pads.heat_transfer_coefficient is None else pads.heat_transfer_coefficient,
        HEAT_TRANSFER if pads.edge_coefficient is None else pads.edge_coefficient,
        pads.temperature,
    )


def pad_bending(case: TiltingPadJournalCase) -> PadBending | None:
    """How the pads bend; None where they do not."""
    material = case.materials.pads
    if "bending" not in case.deformation or material is None:
        return None
    modulus, expansion = material.modulus(), material.expansion()
    assert modulus is not None
    assert expansion is not None
    return PadBending(modulus, expansion)


def pad_growth(case: TiltingPadJournalCase) -> PadGrowth | None:
    """How pads, journal and housing grow; None where they do not."""
    materials = case.materials
    if "growth" not in case.deformation or materials.pads is None or case.reference_temperature is None:
        return None
    expansion = materials.pads.expansion()
    assert expansion is not None
    return PadGrowth(
        case.reference_temperature,
        expansion,
        STEEL_EXPANSION if materials.journal is None else materials.journal.expansion(),
        STEEL_EXPANSION if materials.housing is None else materials.housing.expansion(),
        case.walls.housing.temperature,
    )


def heat_assumptions(case: TiltingPadJournalCase) -> Iterator[str]:
    """Numbers of walls and growth that the case does not give."""
    if case.thermal_model != "full":
        return
    pads = case.walls.pads
    if pads is not None:
        usual = f"{HEAT_TRANSFER:g} W/(m2 K)"
        if pads.heat_transfer_coefficient is None:
            yield f"Heat transfer of {usual} on the backs of the pads."
        if pads.edge_coefficient is None:
            yield f"Heat transfer of {usual} on the edges of the pads."
        if pads.temperature is None:
            yield "The oil behind the pads is as warm as the fresh oil."
        named = None if case.materials.pads is None else case.materials.pads.conductivity()
        if pads.conductivity is None and named is None:
            yield f"The pads conduct heat as steel, {STEEL_CONDUCTIVITY:g} W/(m K)."
    if "growth" in case.deformation:
        if case.walls.housing.temperature is None:
            yield "The housing is as warm as the fresh oil; it decides how much clearance growth leaves."
        for name in ("journal", "housing"):
            if getattr(case.materials, name) is None:
                yield f"The {name} expands as steel, {1e6 * STEEL_EXPANSION:g}e-6 1/K."
    if case.walls.journal.shaft_conductance > 0.0 and case.walls.journal.ambient_temperature is None:
        around = case.walls.housing.temperature
        says = "the fresh oil" if around is None else f"the housing, {written(around, 'degC')}"
        yield f"The surroundings of the shaft are as warm as {says}."
