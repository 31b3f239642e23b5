"""Jacking pockets of a plain journal bearing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.aliases import FormerWords, Moved
from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import Issue, is_given, not_read, refused, rule
from babbitt.case.parts.clearance import LIMITS, ClearanceInput, mean_assumed, mean_radial
from babbitt.case.parts.fields import Name, Prose
from babbitt.case.parts.own_lubricant import DynamicViscosity
from babbitt.core.notices import Notice
from babbitt.core.solution import Calculation
from babbitt.core.units import si, written
from babbitt.kinds.hydrostatic.case.methods import METHOD_MAPPING, FilmChoices
from babbitt.kinds.hydrostatic.case.recess_parts import Gap, Length, Load, RecessRow
from babbitt.kinds.hydrostatic.case.recess_rules import clearance_is_usable, in_order, lands_between
from babbitt.kinds.hydrostatic.case.restrictors import FlowRate
from babbitt.kinds.hydrostatic.case.supply import SupplyPressure
from babbitt.kinds.hydrostatic.geometry import RecessedJournal
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.methods import JACKING_METHODS as METHODS


class JackingPocketCase(FilmChoices, CaseFile):
    """Pockets that lift a shaft before it turns."""

    former_words: ClassVar[FormerWords] = {"radial_clearance": Moved("clearance.mean", kind="radial")}

    kind: Literal["jacking_pocket"] = Field(description="Jacking pockets of a plain journal bearing at rest.")
    name: Name = Field(description="Name of the bearing.")
    method: Annotated[Literal["film", "quick"], METHOD_MAPPING] = Field(
        "film", description="The film in two dimensions, or strips."
    )
    diameter: Length = Field(description="Bore.")
    width: Length = Field(description="Width of the bearing.")
    clearance: ClearanceInput = Field(description="Clearance at 20 degC; its mean is computed.")
    pockets: RecessRow = Field(description="The pockets; the load acts at -90 deg.")
    pocket_length: Length = Field(description="Axial length of the pockets.")
    viscosity: DynamicViscosity = Field(description="Viscosity of the cold oil.")
    load: Load = Field(description="Weight of the shaft on this bearing.")
    lift_gap: Gap | None = Field(None, description="Wanted smallest gap.")
    pump_flow: FlowRate | None = Field(None, description="Flow of the jacking pump, all pockets together.")
    relief_pressure: SupplyPressure | None = Field(None, description="Relief valve of the jacking pump.")
    pump_efficiency: Annotated[float, si("1", "0.05", "1")] = Field(0.8, description="Efficiency of the pump.")
    roughness: Annotated[float, si("m", "0.05 um", "50 um")] = Field(
        1e-6, description="Composite roughness height, on which the shaft lies. 1 um is an assumption."
    )
    own_restrictors: bool = Field(
        True,
        description="Whether every pocket has a restrictor or its stage of a flow divider, as is assumed "
        "where this is not given.",
    )
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @rule
    def _can_be_made(self) -> Iterator[Issue]:
        issues = [*self._misfits(), *self._useless_pockets()]
        yield from issues or refused(("pockets",), self.design)

    def _misfits(self) -> Iterator[Issue]:
        if not (is_given(self, "lift_gap") or is_given(self, "pump_flow")):
            says = "nothing says how far to lift"
            yield Issue((), says, "lift_gap, or pump_flow", code="E003", lacks=("lift_gap",))
        unusable = tuple(clearance_is_usable(self.clearance, self.diameter))
        yield from unusable
        yield from in_order(self, "pocket_length", "width")
        for name in () if unusable else ("lift_gap", "roughness"):
            if getattr(self, name) is not None:
                yield from self._within_the_clearance(name)
        if self.lift_gap is not None and not self.lift_gap > self.roughness:
            says = f"{written(self.lift_gap, 'um')} do not lift the shaft off its roughness"
            allowed = f"more than roughness, {written(self.roughness, 'um')}"
            yield Issue(("lift_gap",), says, allowed, "roughness is the height on which the shaft lies")
        yield from lands_between("pockets", self.pockets)

    def _within_the_clearance(self, name: str) -> Iterator[Issue]:
        own, clearance = getattr(self, name), self.radial_clearance()
        if not own < clearance:
            says = f"{name} is {written(own, 'um')}, the radial clearance {written(clearance, 'um')}"
            yield Issue((name,), says, f"{name} less than the radial clearance")

    def radial_clearance(self) -> float:
        """Give the clearance of the calculation, m."""
        return mean_radial(self.clearance, self.diameter)

    def _useless_pockets(self) -> Iterator[Issue]:
        if not any(math.sin(angle) < 0.0 for angle in self.pockets.middles):
            field = "angles" if self.pockets.angles else "first"
            yield Issue(("pockets", field), "no pocket lies in the lower half, where the shaft lies",
                            "angles below the horizontal, such as -90 deg")  # fmt: skip

    def _fields_not_read(self) -> Iterator[Notice]:
        """Report fields that make no difference to these pockets."""
        yield from not_read(self, "mean_clearance", *LIMITS)
        if self.method == "quick":
            yield from not_read(self, "strips",
                                "accuracy", "pockets.drain_groove")  # fmt: skip
        if self.pockets.number == 1:
            yield from not_read(self, "single_pocket", "own_restrictors")

    def _restrictors_assumed(self) -> Iterator[Notice]:
        """Tell that the pockets count as fed one by one, where the case does not say so."""
        if self.pockets.number > 1 and not is_given(self, "own_restrictors"):
            yield Notice("W329", values={"pockets": self.pockets.number})

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the one calculation of the file."""
        problem = self.design()
        return (Calculation(problem, METHODS[problem.method]),)

    def design(self) -> JackingCase:
        """Give the case of the calculation."""
        row = self.pockets
        bearing = RecessedJournal(
            self.diameter, self.width, self.radial_clearance(), row.middles, row.extent, self.pocket_length,
            row.drain_groove,
        )  # fmt: skip
        assumed = () if "roughness" in self.model_fields_set else ("Composite roughness height 1 µm.",)
        return JackingCase(
            self.name, self.method, bearing, self.viscosity, self.load, self.lift_gap, self.pump_flow,
            self.relief_pressure, self.roughness, self.pump_efficiency, self.accuracy, self.own_restrictors,
            assumptions=(*self.assumptions, *assumed, *mean_assumed(self.clearance, self.diameter)),
            warnings=(*about_grouped_digits(self), *self._fields_not_read(), *self._restrictors_assumed()),
        )  # fmt: skip
