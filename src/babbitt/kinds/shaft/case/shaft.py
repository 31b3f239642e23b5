"""A shaft with gears, couplings and bearings as an engineer writes it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field

from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import Issue, Part, broken_rules, rule
from babbitt.case.parts.fields import Name, Prose
from babbitt.case.parts.shared import SharedInputs
from babbitt.case.parts.uniform_piece import UniformPiece
from babbitt.core.solution import Calculation
from babbitt.core.units import either_sense, si, written
from babbitt.kinds.journal.case.completeness import issues_of
from babbitt.kinds.journal.case.machine import JournalFile
from babbitt.kinds.shaft.answer import ShaftAnswer, answered
from babbitt.kinds.shaft.case.as_given import words_of
from babbitt.kinds.shaft.case.bearings import ShaftBearing, ShaftJournal, ShaftThrust, SupportInput, holding_issues
from babbitt.kinds.shaft.case.machine import bearing_calculations
from babbitt.kinds.shaft.case.parts import CouplingInput, ForceInput, GearInput, MassInput, weight
from babbitt.kinds.shaft.case.torque import Station, TorquePart, torque_issues, torques
from babbitt.kinds.shaft.gears import Gear
from babbitt.kinds.shaft.methods import method_of
from babbitt.kinds.shaft.model import Piece, Shaft
from babbitt.kinds.shaft.problem import ShaftLimits, ShaftProblem
from babbitt.kinds.shaft.statics import thrust

__all__ = ["ShaftCase"]

LEAST_THRUST = 1e-9
"""Share of the largest force on the shaft below which a thrust is the round-off of others that cancel."""


class ShaftLimitsInput(Part):
    """What is permissible."""

    slope: Annotated[float, si("rad", "0.001 mrad", "50 mrad")] | None = Field(
        None, description="Slope of the shaft in its bearings, such as 1 mrad."
    )
    deflection: Annotated[float, si("m", "1 um", "100 mm")] | None = Field(
        None, description="Deflection of the shaft from its unloaded line, the give of its bearings included."
    )


class ShaftCase(SharedInputs, JournalFile):
    """A shaft: what acts on it, and what its bearings carry."""

    kind: Literal["shaft"] = Field(description="Shaft with gears, couplings and masses: loads of its bearings.")
    name: Name = Field(description="Name of the shaft.")
    speed: Annotated[float, either_sense("rad/s", "0.01 rpm", "1000000 rpm")] = Field(
        description="Speed of the shaft, positive counter-clockwise, seen against z."
    )
    bearings: tuple[ShaftBearing, ...] = Field(
        min_length=2,
        max_length=50,
        description="Bearings: radial, axial, radial_axial (load alone), or a whole journal or thrust bearing.",
    )
    gears: tuple[GearInput, ...] = Field((), max_length=50, description="Spur and helical gears.")
    couplings: tuple[CouplingInput, ...] = Field((), max_length=10, description="Couplings.")
    masses: tuple[MassInput, ...] = Field((), max_length=100, description="Masses on the shaft.")
    forces: tuple[ForceInput, ...] = Field((), max_length=100, description="Other forces and couples.")
    shaft: tuple[UniformPiece, ...] = Field(
        (),
        max_length=200,
        description="Pieces of the shaft along z, for its weight and bending. Without them two bearings alone.",
    )
    start: Station = Field(0.0, description="Station at which the first piece begins.")
    clearance_cases: Literal["mean", "all"] = Field(
        "mean", description="Of journal bearings: the mean clearance, or minimum, mean and maximum."
    )
    limits: ShaftLimitsInput = Field(ShaftLimitsInput(), description="What is permissible.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @rule
    def _names_are_their_own(self) -> Iterator[Issue]:
        seen: set[str] = set()
        for index, bearing in enumerate(self.bearings):
            if bearing.name in seen:
                says = f"another bearing is named '{bearing.name}' too"
                yield Issue(("bearings", index, "name"), says, "each name once")
            seen.add(bearing.name)

    @rule
    def _bearings_hold_the_shaft(self) -> Iterator[Issue]:
        yield from holding_issues(self.bearings, bool(self.shaft))

    @rule
    def _bending_needs_pieces(self) -> Iterator[Issue]:
        if self.shaft:
            return
        for index, bearing in enumerate(self.bearings):
            for name in ("stiffness", "offset"):
                if name in bearing.model_fields_set:
                    says = "makes a difference where the shaft bends, and its pieces are not given"
                    yield Issue(("bearings", index, name), says, "shaft: pieces of the shaft, or no such field")

    @rule
    def _pieces_reach_everything(self) -> Iterator[Issue]:
        if not self.shaft:
            return
        first, last = self.start, self.start + sum(piece.length for piece in self.shaft)
        slack = 1e-9 * (last - first)
        for group in ("bearings", "gears", "couplings", "masses", "forces"):
            for index, one in enumerate(getattr(self, group)):
                if not first - slack <= one.station <= last + slack:
                    says = f"{written(one.station, 'mm')} lies outside the pieces of the shaft"
                    reach = f"{written(first, 'mm')} to {written(last, 'mm')}"
                    yield Issue((group, index, "station"), says, reach, "start, or a longer piece")

    @rule
    def _torques_balance(self) -> Iterator[Issue]:
        gears = [(("gears", index), one) for index, one in enumerate(self.gears)]
        couplings = [(("couplings", index), one) for index, one in enumerate(self.couplings)]
        yield from torque_issues([*gears, *couplings], self.speed)

    @rule
    def _thrust_is_carried(self) -> Iterator[Issue]:
        if not self._gears_have_diameters:
            return  # a gear without diameter is refused for itself
        shaft = self.loaded_shaft()
        axial = thrust(shaft)
        largest = max((abs(one) for load in shaft.loads for one in load.force), default=0.0)
        if abs(axial) > LEAST_THRUST * largest and not any(one.axial for one in shaft.supports):
            says = f"the thrust of the shaft, {written(abs(axial), 'kN')}, finds no bearing"
            yield Issue(("bearings",), says, "one bearing of kind axial or radial_axial")

    @rule
    def _nothing_is_missing(self) -> Iterator[Issue]:
        lacking: dict[tuple[Any, str], Issue] = {}
        for index, bearing in enumerate(self.bearings):
            if isinstance(bearing, ShaftJournal):
                for issue in issues_of(bearing, self, "bearings", index):
                    lacking.setdefault((issue.path, issue.says), issue)
        yield from lacking.values()

    @rule
    def _loaded_bearings_are_usable(self) -> Iterator[Issue]:
        unsound = any(True for _ in holding_issues(self.bearings, bool(self.shaft)))
        if unsound or not self._gears_have_diameters:
            return
        answer = self.answer
        for index, bearing in enumerate(self.bearings):
            if isinstance(bearing, SupportInput):
                continue
            loaded = (
                bearing.loaded(answer, index, self.speed)
                if isinstance(bearing, ShaftJournal)
                else bearing.loaded(answer)
            )
            of_itself = set(broken_rules(bearing))
            yield from (issue.under("bearings", index) for issue in broken_rules(loaded) if issue not in of_itself)

    @rule
    def _collar_turns_with_the_shaft(self) -> Iterator[Issue]:
        for index, bearing in enumerate(self.bearings):
            if not isinstance(bearing, ShaftThrust):
                continue
            if not math.isclose(abs(bearing.speed), abs(self.speed), rel_tol=1e-6):
                says = f"the shaft turns at {written(abs(self.speed), 'rpm')}"
                yield Issue(
                    ("bearings", index, "speed"), says, f"{written(abs(self.speed), 'rpm')}, with either sign"
                )
            if self._gears_have_diameters and thrust(self.loaded_shaft()) == 0.0:
                yield Issue(
                    ("bearings", index, "kind"), "the shaft has no thrust", "gears with a helix, or a force z"
                )

    @property
    def _gears_have_diameters(self) -> bool:
        """Whether every gear has one: a gear without is refused for itself, and carries no force that is known."""
        return all(gear.diameter for gear in self.gears)

    @property
    def answer(self) -> ShaftAnswer:
        """The solved shaft: statics and a small beam, at once."""
        return answered(self.loaded_shaft())

    def loaded_gears(self) -> tuple[Gear, ...]:
        """Give the gears of the calculation, each with its torque."""
        found = torques(self.torque_parts, self.speed)
        return tuple(one.gear(torque) for one, torque in zip(self.gears, found, strict=False))

    @property
    def torque_parts(self) -> tuple[TorquePart, ...]:
        """Gears, then couplings."""
        return (*self.gears, *self.couplings)

    def loaded_shaft(self) -> Shaft:
        """Give the shaft of the calculation with all that acts on it."""
        heavy: tuple[TorquePart | MassInput, ...] = (*self.torque_parts, *self.masses)
        of_couplings = torques(self.torque_parts, self.speed)[len(self.gears) :]
        return Shaft(
            tuple(one.as_support() for one in self.bearings),
            (
                *(gear.load() for gear in self.loaded_gears()),
                *(one.load(torque) for one, torque in zip(self.couplings, of_couplings, strict=True)),
                *(one.load() for one in self.forces),
                *(weight(one) for one in heavy if one.mass),
            ),
            tuple(
                Piece(one.length, one.diameter, one.inner_diameter, one.modulus, one.density) for one in self.shaft
            ),
            self.start,
        )

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the calculation of the shaft, then those of its bearings."""
        problem = self.shaft_problem()
        return (Calculation(problem, method_of(problem.shaft)), *bearing_calculations(self, self.answer))

    def shaft_problem(self) -> ShaftProblem:
        """Give the shaft as a problem."""
        return ShaftProblem(
            self.name,
            self.kind,
            self.loaded_shaft(),
            self.speed,
            self.loaded_gears(),
            ShaftLimits(self.limits.slope, self.limits.deflection),
            tuple(words_of(self)),
            tuple(about_grouped_digits(self)),
            self.assumptions,
            tuple(one.name for one in self.bearings if isinstance(one, SupportInput)),
        )
