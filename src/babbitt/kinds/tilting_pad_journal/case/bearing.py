"""A tilting-pad journal bearing as an engineer writes it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.case_file import CaseFile
from babbitt.case.load_components import load_or_components
from babbitt.case.part import Issue, Part, exactly_one, is_given, named_once, rule
from babbitt.case.parts.choices import FilmLimitsInput
from babbitt.case.parts.fields import Name, Prose
from babbitt.case.parts.lubricant import LUBRICANT, LubricantInput
from babbitt.case.parts.position import PositionInput
from babbitt.case.parts.supply import GaugePressure, OilTemperature, SupplyFlow
from babbitt.case.parts.surfaces import SurfacesInput
from babbitt.core.solution import Calculation
from babbitt.core.units import either_sense, si
from babbitt.kinds.tilting_pad_journal.case import rules
from babbitt.kinds.tilting_pad_journal.case.heat import (
    PadJournalWalls,
    ReferenceTemperature,
    heat_goes_with_the_films,
)
from babbitt.kinds.tilting_pad_journal.case.materials import PadJournalMaterials
from babbitt.kinds.tilting_pad_journal.case.methods import METHOD_MAPPING, PadFilmChoices
from babbitt.kinds.tilting_pad_journal.case.pads import JournalPads
from babbitt.kinds.tilting_pad_journal.case.pedestal import PedestalInput
from babbitt.kinds.tilting_pad_journal.methods import PAD_FILM
from babbitt.kinds.tilting_pad_journal.model import WHIRL_RATIOS

__all__ = [
    "PadJournalLimits",
    "PadOilSupply",
    "PadOperatingPoint",
    "TiltingPadJournalCase",
]

Load = Annotated[float, load_or_components("N", "1 N", "1000 MN")]
Speed = Annotated[float, either_sense("rad/s", "0.1 rpm", "1000000 rpm")]
ProbeTemperature = Annotated[float, si("K", "20 degC", "250 degC")]
LoadAngle = Annotated[float, si("rad", "-360 deg", "360 deg")]


WITHOUT_LOAD = "a bearing without load, as of a vertical shaft, has position: {x: 0 um, y: 0 um} in place of load"
"""Hint where a load is refused."""


class PadOilSupply(Part):
    """Fresh oil of the pads."""

    example: ClassVar[str] = "{temperature: 40 degC, flow: 30 L/min}"
    hints: ClassVar[Mapping[str, str]] = {
        "pressure": "the pressure of the oil between the pads is groove_pressure, a field of the bearing; what "
        "feeds the pads is supply.flow, or what they draw in"
    }

    temperature: OilTemperature | None = Field(None, description="Temperature of the fresh oil.")
    flow: SupplyFlow | None = Field(
        None, description="Flow of the fresh oil. If not given, the pads get what they draw in."
    )
    circulation_time: Annotated[float, si("s", "1 s", "100 h")] | None = Field(
        None,
        description="Whole oil volume over the whole flow of the supply system; above 5 min a higher oil "
        "temperature is permissible.",
    )


class PadJournalLimits(FilmLimitsInput):
    """Limits in place of those by experience."""

    example: ClassVar[str] = "{minimum_film_thickness: 15 um, temperature: 100 degC, log_decrement: 0.1}"

    temperature: Annotated[float, si("K", "20 degC", "250 degC")] | None = Field(
        None, description="Greatest permissible temperature of the hottest oil known."
    )
    log_decrement: Annotated[float, si("1", "0", "10")] | None = Field(
        None, description="Least permissible log decrement of the rotor. 0.1 if not given."
    )
    probe_alarm: ProbeTemperature | None = Field(
        None,
        description="Alarm of a probe in a pad, at its probe_fraction, of films with their own temperatures.",
    )
    probe_trip: ProbeTemperature | None = Field(
        None, description="Temperature of such a probe at which the machine is shut down."
    )


class PadOperatingPoint(Part):
    """One of several operating points. What it does not give is taken from the bearing."""

    hints: ClassVar[Mapping[str, str]] = {"load": WITHOUT_LOAD}

    name: Name = Field(description="Name of the operating point.")
    load: Load | None = Field(None, description="Load of the bearing, or its components: {x: 22 kN, y: -35 kN}.")
    position: PositionInput | None = Field(None, description="Place of the journal centre, in place of the load.")
    load_angle: LoadAngle | None = Field(None, description="Direction of the load, from +x.")
    speed: Speed | None = Field(
        None,
        description="Rotational speed, positive counter-clockwise. Against the sense of the bearing's: the pads "
        "run backward.",
    )
    supply_temperature: OilTemperature | None = Field(None, description="Temperature of the fresh oil.")


class TiltingPadJournalCase(PadFilmChoices, CaseFile):
    """A file with one journal bearing of tilting pads."""

    hints: ClassVar[Mapping[str, str]] = {"load": WITHOUT_LOAD}

    kind: Literal["tilting_pad_journal"] = Field(description="Journal bearing of tilting pads.")
    name: Name = Field(description="Name of the bearing.")
    method: Annotated[Literal["film"], METHOD_MAPPING] = Field(
        "film", description="The films of all pads in two dimensions, with their tilts and pivots."
    )
    diameter: Annotated[float, si("m", "1 mm", "3 m")] = Field(description="Diameter of the journal.")
    pads: JournalPads = Field(description="The pads.")
    clearance_cases: Literal["mean", "all"] = Field(
        "mean",
        description="Calculate with the mean clearances, or with minimum, mean and maximum of every clearance "
        "that has limits; a preload stays what it is.",
    )
    groove_pressure: GaugePressure = Field(0.0, description="Gauge pressure of the oil between the pads.")
    lubricant: LubricantInput = Field(description=LUBRICANT)
    supply: PadOilSupply = Field(PadOilSupply(), description="Fresh oil.")
    feed: Literal["flooded", "leading_edge_groove", "spray_bar"] = Field(
        "flooded",
        description="What brings oil to the pads. It sets carry_over where that is not given: 1 flooded, 0.7 for "
        "grooves in the leading edges, 0.8 for spray bars, which are assumptions.",
    )
    effective_temperature: Annotated[float, si("K", "-30 degC", "290 degC")] | None = Field(
        None,
        description="Temperature of isothermal films. That of the fresh oil if not given.",
    )
    walls: PadJournalWalls = Field(
        PadJournalWalls(), description="Pads, housing and journal that take heat, of full thermal films."
    )
    reference_temperature: ReferenceTemperature | None = Field(
        None, description="Temperature at which the clearances are those given, for growth."
    )
    materials: PadJournalMaterials = Field(
        PadJournalMaterials(), description="Materials of lining, pads, journal and housing."
    )
    surfaces: SurfacesInput | None = Field(None, description="Roughness, tilt and waviness of the surfaces.")

    load: Load | None = Field(None, description="Load of the bearing, or its components: {x: 22 kN, y: -35 kN}.")
    position: PositionInput | None = Field(
        None, description="Place of the journal centre, in place of the load, which is then found."
    )
    load_angle: LoadAngle = Field(
        -0.5 * math.pi,
        description="Direction of the load, counter-clockwise from the x axis. -90 deg is downward.",
    )
    speed: Speed | None = Field(
        None,
        description="Rotational speed of the journal, positive counter-clockwise. Its sense says which edges "
        "lead.",
    )
    operating_points: tuple[PadOperatingPoint, ...] = Field(
        (), max_length=200, description="Operating points, each with what differs from the bearing."
    )

    whirl_ratios: tuple[Annotated[float, si("1", "0", "10")], ...] = Field(
        WHIRL_RATIOS,
        min_length=1,
        max_length=50,
        description="Frequencies over that of the rotation, rising, at which coefficients are given and over "
        "which stiffness, damping and virtual mass are fitted.",
    )
    rotor_mass: Annotated[float, si("kg", "1 g", "10000 t")] | None = Field(
        None, description="Part of the mass of the rotor that the bearing carries, for the log decrement."
    )
    shaft_stiffness: Annotated[float, si("N/m", "1 kN/m", "1000 GN/m")] | None = Field(
        None,
        description="Stiffness of the shaft between that mass and this bearing (for a shaft on two equal bearings "
        "half its stiffness in the middle). Rigid if not given.",
    )
    anticipated_cross_coupling: Annotated[float, si("N/m", "1 N/m", "1000 GN/m")] | None = Field(
        None,
        description="Destabilising cross-coupled stiffness that seals and wheels are anticipated to have on the "
        "whole rotor, which stands on two such bearings (Q_A of API 617). For the cross-coupling at which the log "
        "decrement vanishes, and the decrement with that anticipated.",
    )
    pedestal: PedestalInput | None = Field(
        None, description="What the housing stands on. Stiffness and damping are then those of both in series."
    )
    limits: PadJournalLimits = Field(PadJournalLimits(), description="Limits in place of those by experience.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    def duties(self) -> Iterator[tuple[tuple[str | int, ...], PadOperatingPoint | None]]:
        """Give every operating point with the path to it; the bearing as such where there is none."""
        if not self.operating_points:
            yield (), None
        for index, point in enumerate(self.operating_points):
            yield ("operating_points", index), point

    @property
    def thermal_model(self) -> str:
        """Word of the thermal model, chosen by what is given where the case does not say it."""
        if self.thermal is not None:
            return self.thermal
        points = all(point.supply_temperature is not None for point in self.operating_points)
        known = self.supply.temperature is not None or (bool(self.operating_points) and points)
        return "global" if known and self.effective_temperature is None else "isothermal"

    @property
    def sense(self) -> float:
        """Sense of rotation that says which edges lead: of the bearing, else of its first operating point."""
        speeds = (self.speed, *(point.speed for point in self.operating_points))
        return math.copysign(1.0, next((speed for speed in speeds if speed is not None), 1.0))

    @rule
    def _load_or_position(self) -> Iterator[Issue]:
        for path, point in self.duties():
            given = (
                point if point is not None and (is_given(point, "load") or is_given(point, "position")) else self
            )
            for issue in exactly_one(given, "load", "position"):
                yield issue.under(*path) if given is point else issue

    @rule
    def _one_speed(self) -> Iterator[Issue]:
        yield from rules.speed_is_given(self)

    @rule
    def _clearances_fit(self) -> Iterator[Issue]:
        yield from rules.clearances_fit(self)

    @rule
    def _pads_have_room(self) -> Iterator[Issue]:
        yield from rules.pads_have_room(self)

    @rule
    def _centres_of_gravity(self) -> Iterator[Issue]:
        yield from rules.centres_of_gravity(self)

    @rule
    def _inertia_holds_the_mass(self) -> Iterator[Issue]:
        yield from rules.inertia_holds_the_mass(self)

    @rule
    def _inertia_fits_the_pad(self) -> Iterator[Issue]:
        yield from rules.inertia_fits_the_pad(self)

    @rule
    def _pivots_fit_the_pads(self) -> Iterator[Issue]:
        yield from rules.pivots_fit_the_pads(self)

    @rule
    def _position_within_the_pads(self) -> Iterator[Issue]:
        yield from rules.position_within_the_pads(self)

    @rule
    def _temperature_is_known(self) -> Iterator[Issue]:
        yield from rules.temperature_is_known(self)

    @rule
    def _turbulent_films_have_one_temperature(self) -> Iterator[Issue]:
        if self.turbulence != "laminar" and self.thermal_model in ("adiabatic", "full"):
            says = f"{self.thermal_model} films, which have their own temperatures, are laminar"
            yield Issue(("turbulence",), says, "thermal: global or isothermal, or turbulence: laminar")

    @rule
    def _heat_goes_with_the_films(self) -> Iterator[Issue]:
        yield from heat_goes_with_the_films(self)

    @rule
    def _assumptions_are_made(self) -> Iterator[Issue]:
        if self.assumption_sensitivity and self.thermal_model == "isothermal":
            says = "of films at a given temperature nothing is assumed of their heat"
            yield Issue(("assumption_sensitivity",), says, "thermal: global, adiabatic or full, or leave it out")

    @rule
    def _alarm_before_the_trip(self) -> Iterator[Issue]:
        yield from rules.alarm_before_the_trip(self)

    @rule
    def _surface_speed(self) -> Iterator[Issue]:
        yield from rules.surface_speed_is_plausible(self)

    @rule
    def _ratios_rise(self) -> Iterator[Issue]:
        for place, (before, here) in enumerate(pairwise(self.whirl_ratios), 1):
            if not here > before:
                yield Issue(("whirl_ratios", place), f"{here:g} is not above {before:g}", "ratios that rise")
                return

    @rule
    def _shaft_carries_a_rotor(self) -> Iterator[Issue]:
        if is_given(self, "shaft_stiffness") and not is_given(self, "rotor_mass"):
            yield Issue(("shaft_stiffness",), "no mass of a rotor is given that the shaft would carry",
                        "rotor_mass besides it")  # fmt: skip

    @rule
    def _cross_coupling_drives_a_rotor(self) -> Iterator[Issue]:
        if is_given(self, "anticipated_cross_coupling") and not is_given(self, "rotor_mass"):
            yield Issue(("anticipated_cross_coupling",), "no mass of a rotor is given that it would drive",
                        "rotor_mass besides it")  # fmt: skip

    @rule
    def _decrement_of_a_rotor(self) -> Iterator[Issue]:
        if self.limits.log_decrement is not None and not is_given(self, "rotor_mass"):
            yield Issue(("limits", "log_decrement"), "no mass of a rotor is given that would have it",
                        "rotor_mass besides it")  # fmt: skip

    @rule
    def _points_have_names_of_their_own(self) -> Iterator[Issue]:
        yield from named_once((one.name for one in self.operating_points), "operating point", "operating_points")

    def calculations(self) -> tuple[Calculation, ...]:
        """Give one problem for each operating point and clearance."""
        from babbitt.kinds.tilting_pad_journal.case.build import pad_cases

        return tuple(Calculation(problem, PAD_FILM) for problem in pad_cases(self))
