"""Recessed journal bearings, hydrostatic or hybrid."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.aliases import FormerWords, Moved
from babbitt.case.load_components import load_or_components
from babbitt.case.part import Issue, exactly_one, is_given, not_read, rule
from babbitt.case.parts.clearance import LIMITS, ClearanceInput, mean_assumed, mean_radial
from babbitt.core.notices import Notice
from babbitt.core.units import si
from babbitt.kinds.hydrostatic.case.hydrostatic_file import HydrostaticFile
from babbitt.kinds.hydrostatic.case.recess_parts import Angle, Length, RecessRow, Speed
from babbitt.kinds.hydrostatic.case.recess_rules import clearance_is_usable, in_order, lands_between
from babbitt.kinds.hydrostatic.geometry import RecessedJournal
from babbitt.kinds.hydrostatic.model import HydrostaticCase, OperatingConditions


class HydrostaticJournalCase(HydrostaticFile):
    """A recessed journal bearing, hydrostatic or hybrid."""

    former_words: ClassVar[FormerWords] = {
        **HydrostaticFile.former_words,
        "radial_clearance": Moved("clearance.mean", kind="radial"),
    }

    known_to: ClassVar[Mapping[str, tuple[str, ...]]] = {"cavitation_pressure": ("film",)}

    kind: Literal["hydrostatic_journal"] = Field(description="Recessed journal bearing, at rest or turning.")
    diameter: Length = Field(description="Bore.")
    width: Length = Field(description="Width of the bearing.")
    clearance: ClearanceInput = Field(description="Clearance at 20 degC; its mean is computed.")
    recesses: RecessRow = Field(description="The recesses.")
    recess_length: Length = Field(description="Axial length of the recesses.")
    speed: Speed = Field(0.0, description="Rotational speed; positive counter-clockwise.")
    load: Annotated[float, load_or_components("N", "1 N", "1000 MN")] | None = Field(
        None, description="Load, or its components, such as {x: 22 kN, y: -35 kN}. Without it a position is given."
    )
    load_angle: Angle = Field(-0.5 * math.pi, description="Direction of the load, from +x.")
    eccentricity_ratio: Annotated[float, si("1", "0", "0.999")] | None = Field(
        None, description="Eccentricity over clearance, in place of the load."
    )
    attitude_angle: Angle = Field(
        0.0, description="From the direction of the load to that of the eccentricity, in the sense of rotation."
    )
    cavitation_pressure: Annotated[float, si("Pa", "-0.1 MPa", "0 MPa")] = Field(
        0.0, description="Gauge pressure at which the film breaks."
    )

    rotor_mass: Annotated[float, si("kg", "1 g", "10000 t")] | None = Field(
        None,
        description="Part of the mass of the rotor that the bearing carries, for the threshold of whirl. Without "
        "it the load is taken as weight.",
    )
    shaft_stiffness: Annotated[float, si("N/m", "1 kN/m", "1000 GN/m")] | None = Field(
        None,
        description="Stiffness of the shaft between the rotor mass and this bearing, for the threshold of whirl. "
        "Rigid if not given.",
    )

    @rule
    def _load_or_position(self) -> Iterator[Issue]:
        yield from exactly_one(self, "load", "eccentricity_ratio")
        if is_given(self, "load") and is_given(self, "attitude_angle"):
            says = "attitude_angle is of a given position, but the load is given"
            yield Issue(("attitude_angle",), says, "eccentricity_ratio in place of the load", "remove one")

    @property
    def recess_count(self) -> int:
        """Number of recesses."""
        return self.recesses.number

    def misfits(self) -> Iterator[Issue]:
        """Complain of recesses that leave the bearing or no land between them."""
        yield from clearance_is_usable(self.clearance, self.diameter)
        yield from in_order(self, "recess_length", "width")
        yield from lands_between("recesses", self.recesses)

    def radial_clearance(self) -> float:
        """Give the clearance of the calculation, m."""
        return mean_radial(self.clearance, self.diameter)

    def shape(self) -> RecessedJournal:
        """Give the shape of the calculation."""
        row = self.recesses
        return RecessedJournal(
            self.diameter, self.width, self.radial_clearance(), row.middles, row.extent, self.recess_length,
            row.drain_groove,
        )  # fmt: skip

    def duty(self) -> OperatingConditions:
        """Give the duty of the calculation."""
        e = (self.eccentricity_ratio or 0.0) * self.radial_clearance()
        angle = self.load_angle + math.copysign(1.0, self.speed) * self.attitude_angle
        return OperatingConditions(
            self.load,
            self.load_angle,
            position=(e * math.cos(angle), e * math.sin(angle)),
            angular_speed=self.speed,
        )

    def _fields_not_read(self) -> Iterator[Notice]:
        """As of all hydrostatic bearings; lumped lands do not rupture."""
        yield from super()._fields_not_read()
        yield from not_read(self, "mean_clearance", *LIMITS)
        if self.method == "quick":
            yield from not_read(self, "full_lands", "cavitation_pressure")

    def design(self) -> HydrostaticCase:
        """Give the case of the calculation."""
        made = super().design()
        return replace(
            made,
            assumptions=(*made.assumptions, *mean_assumed(self.clearance, self.diameter)),
            cavitation_pressure=self.cavitation_pressure,
            rotor_mass=self.rotor_mass,
            shaft_stiffness=self.shaft_stiffness,
        )
