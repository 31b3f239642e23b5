"""What the files of all hydrostatic pads, rings and journal bearings have."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.aliases import FormerWords
from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import Issue, exactly_one, is_given, not_read, refused, rule
from babbitt.case.parts.fields import Name, Prose
from babbitt.case.parts.lubricant import LUBRICANT, LubricantInput
from babbitt.core.notices import Notice
from babbitt.core.solution import Calculation
from babbitt.core.units import si
from babbitt.kinds.hydrostatic.case.methods import METHOD_MAPPING, FilmChoices
from babbitt.kinds.hydrostatic.case.recess_parts import Frequency, GapLimits, HydrostaticOil, Load, RecessOil
from babbitt.kinds.hydrostatic.case.restrictors import (
    ConstantFlowInput,
    MeteredFlowInput,
    RestrictorInput,
)
from babbitt.kinds.hydrostatic.case.supply import HydrostaticSupply
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad
from babbitt.kinds.hydrostatic.impedance import Compressibility
from babbitt.kinds.hydrostatic.methods import METHODS
from babbitt.kinds.hydrostatic.model import HydrostaticCase, Oil, OperatingConditions, Recesses, Shape, beyond_data


class HydrostaticFile(FilmChoices, CaseFile):
    """What all hydrostatic bearings have."""

    shaped_by: ClassVar[tuple[str, ...]] = ("recesses",)
    """Field to blame where the shape cannot be."""

    former_words: ClassVar[FormerWords] = {
        "oil.lubricant": "lubricant",
        "oil.supply_temperature": "supply.temperature",
        "oil.film_temperature": "film_temperature",
        "least_gap": "limits.minimum_film_thickness",
    }

    kind: str = Field(description="What the file describes.")
    name: Name = Field(description="Name of the bearing.")
    method: Annotated[Literal["film", "quick"], METHOD_MAPPING] = Field(
        "film", description="The film in two dimensions with the recess network, or closed forms and lumped lands."
    )
    restrictor: RestrictorInput | None = Field(None, description="The restrictor before every recess.")
    restrictors: tuple[RestrictorInput, ...] = Field(
        (), max_length=60, description="One for every recess in their order, where they are not alike."
    )
    supply: HydrostaticSupply = Field(description="Oil before the restrictors.")
    lubricant: LubricantInput | None = Field(None, description=f"{LUBRICANT} In place of oil by its numbers.")
    oil: HydrostaticOil = Field(HydrostaticOil(), description="The oil by its numbers, in place of a lubricant.")
    film_temperature: Annotated[float, si("K", "-30 degC", "250 degC")] | None = Field(
        None,
        description="Temperature of a lubricant in the film. Where it is not given it is found: that of the "
        "supply, warmed by what is lost in the film.",
    )
    recess_oil: RecessOil = Field(description="Depth of the recesses and the oil in them.")
    load: Load | None = Field(None, description="Load. Without it a position is given.")
    frequencies: tuple[Frequency, ...] = Field(
        (), max_length=200, description="Frequencies at which stiffness and damping are wanted."
    )
    limits: GapLimits | None = Field(None, description="Limits of your own.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @abstractmethod
    def shape(self) -> Shape:
        """Give the shape of the calculation."""

    @abstractmethod
    def duty(self) -> OperatingConditions:
        """Give the duty of the calculation."""

    @property
    def recess_count(self) -> int:
        """Number of recesses."""
        return 1

    def misfits(self) -> Iterator[Issue]:
        """Complain of lengths and angles that do not fit each other."""
        yield from ()

    @rule
    def _shape_can_be_made(self) -> Iterator[Issue]:
        issues = list(self.misfits())
        yield from issues or refused(self.shaped_by, self.shape)

    @rule
    def _oil_reaches(self) -> Iterator[Issue]:
        viscous, named = is_given(self.oil, "viscosity"), is_given(self, "lubricant")
        if not (viscous or named):
            says = "none of lubricant, oil.viscosity is given"
            yield Issue((), says, "exactly one of lubricant, oil.viscosity", code="E003", lacks=("lubricant",))
        if viscous and named:
            yield Issue(("lubricant",), "given together with oil.viscosity", "one of the two", "remove one")
        if named and not is_given(self.supply, "temperature"):
            yield Issue(
                ("supply", "temperature"), "the lubricant has no temperature", "supply.temperature",
                code="E003", lacks=(),
            )  # fmt: skip
        elif viscous or named:
            yield from refused(("lubricant",), self.oils)

    @rule
    def _restrictors_fit(self) -> Iterator[Issue]:
        yield from exactly_one(self, "restrictor", "restrictors")
        given, count = self.restrictors, self.recess_count
        if is_given(self, "restrictors") and len(given) != count:
            says = f"{len(given)} restrictor{'s' * (len(given) != 1)} for {count} recess{'es' * (count > 1)}"
            yield Issue(("restrictors",), says, "one for every recess", "restrictor is for all alike")
        pumped = [isinstance(one, ConstantFlowInput | MeteredFlowInput) for one in given]
        if any(pumped) and not all(pumped):
            kind = given[pumped.index(True)].kind
            says = f"{kind} has a flow of its own for its recess, and other recesses hang on the supply"
            allowed = f"{kind} for all recesses, or other restrictors for all"
            yield Issue(("restrictors", pumped.index(True)), says, allowed)

    @rule
    def _one_pump_too_many(self) -> Iterator[Issue]:
        own = self.restrictors[0] if self.restrictors else self.restrictor
        if not is_given(self.supply, "pump_flow"):
            return
        if isinstance(own, ConstantFlowInput):
            says = "constant_flow has a pump for every recess, and the supply names one pump for all"
            hint = "the pressure that the pumps of the recesses can reach; restrictor.flow is what each delivers"
            yield Issue(("supply", "pump_flow"), says, "pressure", hint)
        if isinstance(own, MeteredFlowInput):
            says = "metered_flow needs a supply that stands at its pressure, and this one delivers a flow"
            yield Issue(("supply", "pump_flow"), says, "pressure", "that of the pump's relief valve")

    def _fields_not_read(self) -> Iterator[Notice]:
        """Report fields that make no difference to this bearing."""
        if self.method == "quick":
            yield from not_read(self, "no_grid", "accuracy")
        if self.lubricant is not None:
            yield from not_read(self, "own_of_lubricant", "oil.density", "oil.heat_capacity")
        else:
            yield from not_read(self, "given_viscosity", "supply.temperature", "film_temperature")

    def oils(self) -> tuple[Oil, Oil]:
        """Give the oil in the film and that in the restrictors."""
        supplied_at = self.supply.temperature
        if self.lubricant is None or supplied_at is None:
            oil = Oil(self.oil.viscosity or 0.0, self.oil.density, self.oil.heat_capacity)
            return oil, oil
        supplied = Oil(1.0, 1.0, 1.0, self.lubricant.lubricant(), supplied_at).at(supplied_at)
        if self.film_temperature is None:
            return supplied, supplied
        film = replace(supplied.at(self.film_temperature), film_temperature=self.film_temperature)
        return film, supplied

    def _beyond_data(self) -> Iterator[Notice]:
        """Report temperatures outside the data of the lubricant; a film's own is known with its heat balance."""
        if self.lubricant is None or self.supply.temperature is None:
            return
        lubricant = self.lubricant.lubricant()
        yield from beyond_data(lubricant, self.supply.temperature, "supply")
        if self.film_temperature is not None:
            yield from beyond_data(lubricant, self.film_temperature, "film")

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the one calculation of the file."""
        problem = self.design()
        return (Calculation(problem, METHODS[problem.method]),)

    def design(self) -> HydrostaticCase:
        """Give the case of the calculation."""
        film, supplied = self.oils()
        shape = self.shape()
        own = self.recess_oil
        turning = isinstance(shape, CircularPad | AnnularPad)
        factor = own.friction_factor or (1.0 if turning else 4.0)
        given = self.restrictors or (self.restrictor,) * self.recess_count
        restrictors = [one.restrictor(supplied.viscosity, supplied.density) for one in given if one is not None]
        assumptions = list(self.assumptions)
        if self.recess_oil.friction_factor is None:
            assumptions.append(f"Friction factor {factor:g} in the recesses, by their shape.")
        if not is_given(own, "bulk_modulus"):
            assumptions.append("Bulk modulus of the oil 1.4 GPa, without air.")
        if self.lubricant is None and not {"density", "heat_capacity"} <= self.oil.model_fields_set:
            assumptions.append("Density 870 kg/m³ and specific heat 2000 J/(kg K) where not given.")
        return HydrostaticCase(
            name=self.name,
            kind=self.kind,
            method=self.method,
            shape=shape,
            feeding=self.supply.feeding(restrictors),
            oil=film,
            duty=self.duty(),
            recesses=Recesses(own.depth, factor),
            compressibility=Compressibility(
                shape.recess_area * own.depth + own.line_volume,
                own.bulk_modulus,
                self.supply.manifold_volume,
                own.line_volume,
            ),
            frequencies=self.frequencies,
            pump_efficiency=self.supply.pump_efficiency,
            least_gap=None if self.limits is None else self.limits.minimum_film_thickness,
            highest_supply_pressure=self.supply.highest_pressure,
            accuracy=self.accuracy,
            assumptions=tuple(assumptions),
            warnings=(*about_grouped_digits(self), *self._fields_not_read(), *self._beyond_data()),
        )
