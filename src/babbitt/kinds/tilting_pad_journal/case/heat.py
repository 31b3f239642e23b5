"""What takes heat from the films of pads, what of it deforms them, and what is assumed where a case is silent."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field

from babbitt.case.error_messages import MISSING
from babbitt.case.part import Issue, Part, is_given, refused
from babbitt.case.parts.walls import ConductingJournalInput, Conductivity, HeatTransfer, Surroundings
from babbitt.core.units import si, written
from babbitt.kinds.tilting_pad_journal.case.materials import PadStructure
from babbitt.kinds.tilting_pad_journal.case.pads import own_path
from babbitt.kinds.tilting_pad_journal.model import HeatChoices, Thermal
from babbitt.properties.fits import REFERENCE_TEMPERATURE
from babbitt.reynolds.heat.heat_model import JournalHeat
from babbitt.reynolds.tilting_pads.bending_mode import bending_stiffness
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pad_heat import (
    HEAT_TRANSFER,
    STEEL_CONDUCTIVITY,
    STEEL_EXPANSION,
    STEEL_MODULUS,
    PadBending,
    PadGrowth,
    PadMaterial,
    PadWalls,
)

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase

__all__ = [
    "PadJournalWalls",
    "ReferenceTemperature",
    "fuller_choices",
    "heat_assumptions",
    "heat_choices",
    "heat_goes_with_the_films",
    "heat_not_read",
    "mode_stiffness",
]

STEEL_POISSON = 0.3
"""Poisson's ratio of steel."""

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
        None,
        description="Its temperature. That of the fresh oil if not given, an assumption; it then follows the oil "
        "from operating point to operating point and in sweeps.",
    )


class PadJournalWalls(Part):
    """Pads, housing and journal, which take heat from full thermal films."""

    example: ClassVar[str] = "{pads: {temperature: 40 degC}, housing: {temperature: 45 degC}}"

    pads: ConductingPadsInput | None = Field(None, description="The pads. They take no heat if not given.")
    housing: PadHousingInput = Field(
        PadHousingInput(), description="The housing, for growth, counted or left out."
    )
    journal: ConductingJournalInput = Field(ConductingJournalInput(), description="The journal.")


def heat_goes_with_the_films(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of deformation that does not go with the films, of what it lacks, and of walls that say nothing."""
    if (says := without_films(case)) is not None:
        yield Issue(("deformation",), says, "thermal: full, with walls.pads")
        return
    if len(set(case.deformation)) < len(case.deformation):
        yield Issue(("deformation",), "names one word twice", "growth and bending, each once")
        return
    yield from refused(("walls", "pads"), lambda: pad_walls(case))
    yield from lacking(case)
    journal = case.walls.journal
    if journal.ambient_temperature is not None and not journal.shaft_conductance:
        says = "the surroundings of a shaft that conducts no heat make no difference"
        yield Issue(("walls", "journal", "ambient_temperature"), says, "shaft_conductance, or leave it out")


def without_films(case: TiltingPadJournalCase) -> str | None:
    """Why the films of a case do not deform pads as it asks; None where they do."""
    if case.thermal_model == "full":
        return None
    if "growth" in case.deformation:
        return "pads grow by the temperatures of full thermal films"
    if case.deformation and case.thermal_model == "adiabatic":
        return "adiabatic films, whose pads take no heat, leave them rigid"
    return None


def lacking(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """What deformation needs and the case does not give."""
    if not case.deformation:
        return
    words = " and ".join(case.deformation)
    full = case.thermal_model == "full"
    if full and case.walls.pads is None:
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
    if bending and material.known("elastic_modulus") is None:
        hint = "bending needs the elastic modulus of the pads, such as '210 GPa', or materials.pads by its name"
        yield Issue(("materials", "pads", "elastic_modulus"), MISSING, hint=hint, code="E003")
    if full and material.known("thermal_expansion") is None:
        hint = f"{words} needs the expansion of the pads, such as '12e-6 1/K', or materials.pads by its name"
        yield Issue(("materials", "pads", "thermal_expansion"), MISSING, hint=hint, code="E003")


def heat_not_read(case: TiltingPadJournalCase) -> Iterator[str]:
    """Paths of what is given for another thermal model, and makes no difference here.

    Walls and materials count for what films with temperatures of their own make of the bearing (W422), where the
    fresh oil is known and films are laminar.
    """
    if case.turbulence != "laminar" or case.supply.temperature is None:
        if case.walls.pads is not None and is_given(case.walls.pads, "edge_coefficient"):
            yield "walls.pads.edge_coefficient"
        for name in ("shaft_conductance", "ambient_temperature"):
            if is_given(case.walls.journal, name):
                yield f"walls.journal.{name}"
    if case.thermal_model in ("isothermal", "global"):  # probes are read in films with temperatures of their own
        if is_given(case.pads, "probe_fraction"):
            yield "pads.probe_fraction"
        for number, one in enumerate(case.pads.each):
            if is_given(one, "probe_fraction"):
                yield f"{own_path(number)}.probe_fraction"
    if case.pad_bending == "plate":
        return
    if case.materials.pads is not None and is_given(case.materials.pads, "poisson_ratio"):
        yield "materials.pads.poisson_ratio"
    for number, one in enumerate(case.pads.each):
        if one.material is not None and is_given(one.material, "poisson_ratio"):
            yield f"{own_path(number)}.material.poisson_ratio"


def heat_choices(case: TiltingPadJournalCase, supply: float | None) -> HeatChoices:
    """What takes heat from the films at a temperature of the fresh oil, and what of it deforms the pads."""
    if Thermal(case.thermal_model) is not Thermal.FULL or supply is None:
        return HeatChoices()
    every = fuller_choices(case, supply)
    return replace(
        every,
        walls=None if case.walls.pads is None else every.walls,
        bending=every.bending if "bending" in case.deformation else None,
        growth=every.growth if "growth" in case.deformation else None,
    )


def fuller_choices(case: TiltingPadJournalCase, supply: float | None) -> HeatChoices:
    """Journal, walls, bending and growth as given, else of steel, whether the films of the case count them or not.

    ``supply`` is the temperature of the fresh oil in K; None: not known, and a shaft conducts no heat.
    """
    housing = case.walls.housing.temperature
    around = supply if housing is None else housing
    given = case.walls.journal
    journal = JournalHeat(given.temperature) if around is None else journal_heat(given, around)
    return HeatChoices(journal, pad_walls(case), pad_bending(case), pad_growth(case), pad_materials(case))


def journal_heat(given: ConductingJournalInput, ambient: float) -> JournalHeat:
    """The journal, in surroundings of a temperature unless it has its own."""
    around = ambient if given.ambient_temperature is None else given.ambient_temperature
    return JournalHeat(given.temperature, given.shaft_conductance, around)


def pad_walls(case: TiltingPadJournalCase) -> PadWalls:
    """How the pads conduct, or would where they take no heat."""
    pads, material = case.walls.pads or ConductingPadsInput(), case.materials.pads
    named = None if material is None else material.known("conductivity")
    chosen = (pads.conductivity, named, STEEL_CONDUCTIVITY)
    return PadWalls(
        next(one for one in chosen if one is not None),
        HEAT_TRANSFER if pads.heat_transfer_coefficient is None else pads.heat_transfer_coefficient,
        HEAT_TRANSFER if pads.edge_coefficient is None else pads.edge_coefficient,
        pads.temperature,
    )


def known_of_pads(case: TiltingPadJournalCase, field: str, of_steel: float) -> float:
    """A number of the material of the pads; that of steel where it is not given."""
    known = None if case.materials.pads is None else case.materials.pads.known(field)
    return of_steel if known is None else known


def pad_bending(case: TiltingPadJournalCase) -> PadBending:
    """How the pads bend, or would."""
    return PadBending(
        known_of_pads(case, "elastic_modulus", STEEL_MODULUS),
        known_of_pads(case, "thermal_expansion", STEEL_EXPANSION),
        poisson_ratio(case, case.materials.pads),
    )


def poisson_ratio(case: TiltingPadJournalCase, material: PadStructure | None) -> float:
    """Poisson's ratio of pads that bend as plates, 0 of beams."""
    if case.pad_bending == "beam":
        return 0.0
    known = None if material is None else material.known("poisson_ratio")
    return STEEL_POISSON if known is None else known


def pad_materials(case: TiltingPadJournalCase) -> tuple[PadMaterial, ...]:
    """What the pads have of their own; empty where they are alike."""
    own = [case.pads.fields_of(number)["material"] for number in range(case.pads.count)]
    if not any(own):
        return ()
    return tuple(PadMaterial() if one is None else PadMaterial(
        one.known("conductivity"), one.known("elastic_modulus"), one.known("thermal_expansion"),
        poisson_ratio(case, one) if one.known("poisson_ratio") is not None else None,
    ) for one in own)  # fmt: skip


def mode_stiffness(case: TiltingPadJournalCase, number: int, pad: TiltingPad) -> float:
    """Stiffness of a pad of films of one temperature against bending, N/m; infinite where it does not bend."""
    common = case.materials.pads
    if "bending" not in case.deformation or case.thermal_model == "full" or common is None:
        return math.inf
    own = case.pads.fields_of(number)["material"]
    known = [material.known("elastic_modulus") for material in (own, common) if material is not None]
    modulus = next(one for one in known if one is not None)
    ratio = poisson_ratio(case, common if own is None or own.known("poisson_ratio") is None else own)
    width = case.pads.width if pad.width is None else pad.width
    bending = PadBending(modulus, poisson_ratio=ratio)
    return bending_stiffness(pad, 0.5 * case.diameter + pad.clearance, width, bending.plate_modulus)


def pad_growth(case: TiltingPadJournalCase) -> PadGrowth:
    """How pads, journal and housing grow, or would."""
    reference, materials = case.reference_temperature, case.materials
    return PadGrowth(
        REFERENCE_TEMPERATURE if reference is None else reference,
        known_of_pads(case, "thermal_expansion", STEEL_EXPANSION),
        STEEL_EXPANSION if materials.journal is None else materials.journal.expansion(),
        STEEL_EXPANSION if materials.housing is None else materials.housing.expansion(),
        case.walls.housing.temperature,
    )


def heat_assumptions(case: TiltingPadJournalCase) -> Iterator[str]:
    """Numbers of walls, bending and growth that the case does not give."""
    material = case.materials.pads
    if case.pad_bending == "plate" and material is not None and material.known("poisson_ratio") is None:
        yield f"Poisson's ratio of the pads is that of steel, {STEEL_POISSON:g}."
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
            yield "The oil behind the pads is as warm as the fresh oil, and follows it."
        named = None if case.materials.pads is None else case.materials.pads.known("conductivity")
        if pads.conductivity is None and named is None:
            yield f"The pads conduct heat as steel, {STEEL_CONDUCTIVITY:g} W/(m K)."
    if "growth" in case.deformation:
        if case.walls.housing.temperature is None:
            yield (
                "The housing is as warm as the fresh oil, and follows it where the supply temperature is varied; "
                "it decides how much clearance growth leaves."
            )
        for name in ("journal", "housing"):
            if getattr(case.materials, name) is None:
                yield f"The {name} expands as steel, {1e6 * STEEL_EXPANSION:g}e-6 1/K."
    if case.walls.journal.shaft_conductance > 0.0 and case.walls.journal.ambient_temperature is None:
        around = case.walls.housing.temperature
        says = "the fresh oil" if around is None else f"the housing, {written(around, 'degC')}"
        yield f"The surroundings of the shaft are as warm as {says}."
