"""The circular cylindrical journal bearing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, PrivateAttr

from babbitt.case.part import Issue, at_most_one, exactly_one, is_given, named_once, rule
from babbitt.case.parts import clearance, cooling
from babbitt.case.parts.choices import FrictionInput, LimitsInput
from babbitt.case.parts.clearance import ClearanceInput
from babbitt.case.parts.compliance import ComplianceInput
from babbitt.case.parts.fields import Name, Prose, Span
from babbitt.case.parts.load_and_speed import LOADS, SPEEDS
from babbitt.case.parts.shared import SharedInputs
from babbitt.case.parts.surfaces import SurfacesInput
from babbitt.core.units import si, written
from babbitt.kinds.journal.case import film_rules, film_shape_rules, one_dimension, standard_rules, supply_element
from babbitt.kinds.journal.case.dynamic_load import DynamicLoadInput
from babbitt.kinds.journal.case.film_features import (
    BoreInput,
    GrooveInput,
    MisalignmentInput,
    PocketInput,
    SupplyHoleInput,
    issues_of_feeds,
)
from babbitt.kinds.journal.case.film_heat import (
    WallsInput,
    heat_goes_with_the_film,
)
from babbitt.kinds.journal.case.film_oil import PressureViscosityInput
from babbitt.kinds.journal.case.film_surface import (
    CrowningInput,
    DisplacementInput,
    SidePressure,
    StepInput,
)
from babbitt.kinds.journal.case.grooved_segments import SegmentsInput
from babbitt.kinds.journal.case.heat_exchange import HeatExchangeInput
from babbitt.kinds.journal.case.load_direction import DOWNWARD
from babbitt.kinds.journal.case.methods import KNOWN_TO, METHOD_MAPPING, FilmChoices, Iso7902Choices
from babbitt.kinds.journal.case.mixed_friction import MixedFrictionInput
from babbitt.kinds.journal.case.operating_point import LoadAndSpeed, LoadAngle, OperatingPoint
from babbitt.kinds.journal.case.supply_element import SupplyElementInput, UnevenPockets
from babbitt.reynolds.model import FilmStart

LEAST_SPECIFIC_LOAD = 1e3
"""Pa. Assumption: a smaller load is a slip of unit."""

GREATEST_SURFACE_SPEED = 200.0
"""m/s. Assumption: a faster plain bearing is a slip of unit."""


class JournalBearing(LoadAndSpeed, SharedInputs, FilmChoices, Iso7902Choices):
    """A circular cylindrical journal bearing."""

    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = (*LoadAndSpeed.alternatives, ("width", "width_ratio"))
    known_to: ClassVar[Mapping[str, tuple[str, ...]]] = KNOWN_TO

    _slope: tuple[float, float] = PrivateAttr((0.0, 0.0))

    kind: Literal["journal"] = Field(description="Circular cylindrical journal bearing.")
    name: Name = Field(description="Name of the bearing in tables and reports.")
    method: Annotated[Literal["iso7902", "film", "long_film", "segments"], METHOD_MAPPING] = Field(
        "iso7902",
        description="Method of calculation: the procedure of ISO 7902, the film in two dimensions, or one of two "
        "published models in one dimension: the long film with heat exchange, or its heat balance by segments.",
    )

    diameter: Annotated[float, si("m", "1 mm", "3 m")] = Field(description="Nominal bearing inside diameter D.")
    width: Annotated[float, si("m", "0.1 mm", "4.5 m")] | None = Field(None, description="Bearing width B.")
    width_ratio: Annotated[float, si("1", "0.1", "10")] | None = Field(
        None, description="Relative width B/D, in place of the width."
    )
    clearance: ClearanceInput = Field(
        description="Clearance at 20 degC. An ISO 286 fit may be written in short, such as H7/e8."
    )
    clearance_cases: Literal["mean", "all"] | None = Field(
        None,
        description="Calculate with the mean clearance, or with minimum, mean and maximum. mean if not given.",
    )
    span: Span | None = Field(
        None, description="Angular span of the loaded arc. Uneven pockets set it if it is not given."
    )
    supply_element: SupplyElementInput | None = Field(None, description="What feeds the film.")
    grooves: tuple[GrooveInput, ...] = Field(
        (),
        max_length=12,
        description="Axial grooves as wide as the bearing. Film method, in place of supply_element.",
    )
    pockets: tuple[PocketInput, ...] = Field(
        (),
        max_length=12,
        description="Pockets and circumferential grooves. Film method, in place of supply_element.",
    )
    holes: tuple[SupplyHoleInput, ...] = Field(
        (), max_length=24, description="Holes in the bore. Film method, in place of supply_element."
    )
    bore: BoreInput | None = Field(None, description="Form of the bore, for the film method. round if not given.")
    misalignment: MisalignmentInput | None = Field(
        None, description="Slopes of the journal axis in the bore, for the film method."
    )
    steps: tuple[StepInput, ...] = Field(
        (),
        max_length=24,
        description="Rectangles of the bore that lie deeper and belong to the film. Film method.",
    )
    crowning: CrowningInput | None = Field(
        None, description="What the radius of the journal lacks along its axis, for the film method."
    )
    displacement: DisplacementInput | None = Field(
        None, description="What the gap gains by displacement of its surfaces, for the film method."
    )
    compliance: tuple[ComplianceInput, ...] = Field(
        (),
        max_length=4,
        description="What the bore gives way by under the pressure of the film; all of it adds up. Film method.",
    )
    side_pressures: tuple[SidePressure, SidePressure] | None = Field(
        None,
        description="Gauge pressures at the sides z = -B/2 and B/2, for the film method. Ambient if not given.",
    )
    surfaces: SurfacesInput | None = Field(None, description="Roughness, tilt and waviness of the surfaces.")
    heat_exchange: HeatExchangeInput = Field(
        HeatExchangeInput(), description="Heat exchange of the long film (method: long_film)."
    )
    segments: SegmentsInput = Field(
        SegmentsInput(), description="Groove and wall of the heat balance by segments (method: segments)."
    )

    bearing_speed: Annotated[float, si("rad/s", "-1000000 rpm", "1000000 rpm")] = Field(
        0.0, description="Rotational speed of the bearing, positive counter-clockwise as that of the journal."
    )
    load_angle: LoadAngle = Field(
        DOWNWARD,
        description="Direction of the load, counter-clockwise from the x axis. -90 deg is downward. "
        "ISO 7902 takes the load through the middle of the arc, whatever its direction, and counts what feeds the "
        "film from the load.",
    )
    rotor_mass: Annotated[float, si("kg", "1 g", "10000 t")] | None = Field(
        None,
        description="Part of the mass of the rotor that the bearing carries, for the threshold of whirl "
        "by the film "
        "method. Without it the load is taken as weight.",
    )
    shaft_stiffness: Annotated[float, si("N/m", "1 kN/m", "1000 GN/m")] | None = Field(
        None,
        description="Stiffness of the shaft between the rotor mass and this bearing (for a shaft on two equal "
        "bearings half its stiffness in the middle), for the threshold of whirl by the film method. Rigid if not "
        "given.",
    )
    effective_temperature: Annotated[float, si("K", "-30 degC", "290 degC")] | None = Field(
        None,
        description="Effective temperature of the film, in place of a heat balance: no outlet temperature and no "
        "heat to the oil is then given.",
    )
    operating_points: tuple[OperatingPoint, ...] = Field(
        (), max_length=200, description="Operating points, each with what differs from the bearing."
    )

    friction: FrictionInput = Field(FrictionInput(), description="Where the film rubs.")
    mixed_friction: MixedFrictionInput | None = Field(
        None,
        description="Asperities that touch where the film is thin, for a Stribeck curve with its mixed branch by "
        "the film method. Hydrodynamic friction only if not given.",
    )
    cavitation_pressure: Annotated[float, si("Pa", "-1 MPa", "0 Pa")] = Field(
        0.0, description="Gauge pressure at which the film breaks, for the film method."
    )
    pressure_viscosity: PressureViscosityInput | None = Field(
        None, description="Growth of the viscosity with pressure, for the film method."
    )
    walls: WallsInput | None = Field(
        None,
        description="Bush, housing and journal of a full thermal film. What is not given is assumed and listed.",
    )
    dynamic_load: DynamicLoadInput | None = Field(
        None,
        description="Load that changes while the journal turns, added to the load, for the film method: the orbit "
        "of the journal is found.",
    )
    limits: LimitsInput = Field(LimitsInput(), description="Limits in place of those by experience.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @property
    def actual_width(self) -> float | None:
        """Bearing width in m, None while it cannot be known."""
        if self.width is not None:
            return self.width
        return None if self.width_ratio is None else self.width_ratio * self.diameter

    @rule
    def _one_width(self) -> Iterator[Issue]:
        yield from exactly_one(self, "width", "width_ratio")

    @rule
    def _width_makes_sense(self) -> Iterator[Issue]:
        yield from standard_rules.width_is_plausible(self)

    @rule
    def _one_load(self) -> Iterator[Issue]:
        if self.method == "segments" and self.segments.profile:
            yield from one_dimension.issues_of_loads(self)
        else:
            yield from _one_of(self, LOADS)

    @rule
    def _loads_make_sense(self) -> Iterator[Issue]:
        width = self.actual_width
        for path, duty in self.duties():
            if duty.load is None or width is None:
                continue
            pressure = duty.load / (width * self.diameter)
            # A missing "kN" shows here. A load beyond what any film carries is answered by the calculation.
            if pressure < LEAST_SPECIFIC_LOAD:
                says = f"{written(duty.load, 'kN')} is a specific load of {written(pressure, 'kPa')}"
                yield Issue((*path, "load"), says, f"at least {written(LEAST_SPECIFIC_LOAD, 'kPa')}")

    @rule
    def _one_speed(self) -> Iterator[Issue]:
        yield from _one_of(self, SPEEDS)

    @rule
    def _speeds_make_sense(self) -> Iterator[Issue]:
        for path, duty in self.duties():
            speed = duty.speed
            if speed is None and duty.surface_speed is not None:
                speed = 2.0 * duty.surface_speed / self.diameter
            if speed is None:
                continue
            if (fast := abs(speed) * self.diameter / 2.0) > GREATEST_SURFACE_SPEED * 1.000001:
                says = f"{written(speed, 'rpm')} is a surface speed of {fast:.4g} m/s"
                yield Issue((*path, "speed"), says, f"up to {GREATEST_SURFACE_SPEED:g} m/s")
            yield from self._film_in_the_sense_of_the_journal(speed)

    def _film_in_the_sense_of_the_journal(self, speed: float) -> Iterator[Issue]:
        """Complain about a bearing that turns so fast against the journal that it stops or turns back the film."""
        turns = speed + self.bearing_speed
        if turns * speed > 0.0:
            return
        journal, bearing = written(speed, "rpm"), written(self.bearing_speed, "rpm")
        why, hint = "their sum, which draws the oil in, is zero", ""
        if turns != 0.0:
            why = "their sum turns against the journal, in whose sense friction and places before the load count"
            hint = f"speed: {bearing} with bearing_speed: {journal} has the same film, both exchanged"
        says = f"the speeds build no film: journal {journal}, bearing {bearing}: {why}"
        yield Issue(("bearing_speed",), says, "a sum of both in the sense of the journal", hint)

    @rule
    def _points_have_names_of_their_own(self) -> Iterator[Issue]:
        yield from named_once((one.name for one in self.operating_points), "operating point", "operating_points")

    @rule
    def _clearance_fits(self) -> Iterator[Issue]:
        yield from clearance.issues_of(self.clearance, self.diameter)

    @rule
    def _housing_fits(self) -> Iterator[Issue]:
        if self.cooling is not None:
            yield from cooling.issues_of(self.cooling, self.diameter)

    @rule
    def _elements_fit(self) -> Iterator[Issue]:
        width = self.actual_width
        if width is None:
            return
        if self.supply_element is not None:
            yield from supply_element.issues_of(self.supply_element, width)
        for index, point in enumerate(self.operating_points):
            if point.supply_element is not None:
                for issue in supply_element.issues_of(point.supply_element, width):
                    yield issue.under("operating_points", index)

    @rule
    def _one_dimension_suffices(self) -> Iterator[Issue]:
        yield from one_dimension.issues_of(self)

    @rule
    def _span_is_known(self) -> Iterator[Issue]:
        if self.method in one_dimension.METHODS:
            return
        if self.method == "film" and (self.feeds() or self.film_starts() is not FilmStart.GROOVE):
            return
        for point in self.operating_points or (None,):
            if self.span_at(point) is None:
                besides = ", or grooves, pockets or holes" if self.method == "film" else ""
                yield Issue(
                    ("span",),
                    "is missing",
                    f"360, 180, 150, 120, 90 deg, or a supply_element of kind uneven_pockets{besides}",
                    code="E003",
                )
                return

    @rule
    def _closed_forms_are_of_the_full_bearing(self) -> Iterator[Issue]:
        spans = (self.span_at(point) for point in self.operating_points or (None,))
        others = [span for span in spans if span not in (None, 360)]
        if self.characteristics == "closed_form" and others:
            says = f"closed forms exist for a span of 360 deg, not {others[0]} deg"
            yield Issue(("characteristics",), says, "computed, or span 360 deg")

    @rule
    def _feeds_fit(self) -> Iterator[Issue]:
        yield from issues_of_feeds(self.feeds(), self.actual_width, self.diameter)

    _standard_knows_the_bearing = standard_rules.standard_knows_the_bearing
    _tilt_leaves_a_film = film_shape_rules.tilt_leaves_a_film
    _departures_are_of_the_size_of_the_clearance = film_shape_rules.departures_are_of_the_size_of_the_clearance
    _steps_fit = film_shape_rules.steps_fit
    _dam_stays_on_its_land = film_shape_rules.dam_stays_on_its_land
    _displacement_is_of_the_size_of_the_clearance = film_shape_rules.displacement_is_of_the_size_of_the_clearance
    _own_bore_is_the_whole_bore = film_shape_rules.own_bore_is_the_whole_bore
    _compliance_fits = film_shape_rules.compliance_fits
    _lobes_lie_between_grooves = film_shape_rules.lobes_lie_between_grooves
    _position_is_near_the_bearing = film_rules.position_is_near_the_bearing
    _changing_load_is_added_to_a_load = film_rules.changing_load_is_added_to_a_load
    _mixed_friction_goes_with_the_film = film_rules.mixed_friction_goes_with_the_film
    _half_sommerfeld_is_of_a_plain_ring = film_rules.half_sommerfeld_is_of_a_plain_ring
    _closed_ring_is_plain = film_rules.closed_ring_is_plain
    _sides_stand_above_cavitation = film_rules.sides_stand_above_cavitation
    _widest_gap_is_of_a_plain_bore = film_rules.widest_gap_is_of_a_plain_bore
    _given_flows_are_counted = film_rules.given_flows_are_counted
    _grooves_stand_still = film_rules.grooves_stand_still
    _heat_goes_with_the_film = heat_goes_with_the_film

    def without_friction_factor(self) -> JournalBearing:
        """The same bearing for a method that knows no factor on friction."""
        return self.model_copy(update={"friction": self.friction.model_copy(update={"factor": 1.0})})

    def film_starts(self) -> FilmStart:
        """Where the film begins: as given, else nowhere under the half-Sommerfeld condition, else at grooves."""
        unfed = "periodic" if self.cavitation == "half_sommerfeld" else "groove"
        return FilmStart[(self.film_start or unfed).upper()]

    def feeds(self) -> list[tuple[tuple[str | int, ...], GrooveInput | PocketInput | SupplyHoleInput]]:
        """Grooves, pockets and holes, each with its path in the case."""
        return [
            ((name, index), feed)
            for name in ("grooves", "pockets", "holes")
            for index, feed in enumerate(getattr(self, name))
        ]

    def feeds_itself(self) -> bool:
        """Whether every groove, pocket and hole of the film method has a pressure or a flow of its own."""
        feeds = self.feeds() if self.method == "film" else []
        return bool(feeds) and all(one.pressure is not None or one.flow is not None for _, one in feeds)

    def span_at(self, point: OperatingPoint | None) -> int | None:
        """Angular span in degrees at an operating point (None: the bearing as such), None while unknown."""
        if point is not None and point.span is not None:
            return point.span
        element = self.element_at(point)
        own_element = point is not None and point.supply_element is not None
        if isinstance(element, UnevenPockets) and (self.span is None or own_element):
            return element.conventional_span().tabulated
        return self.span

    @property
    def slope_of_shaft(self) -> tuple[float, float]:
        """Slopes dx/dz and dy/dz in rad of the shaft that the bearing is part of, beside `misalignment`."""
        return self._slope

    def on_sloping_shaft(self, slope: tuple[float, float]) -> Self:
        """The bearing on a shaft that slopes in it, rad."""
        sloping = self.model_copy()
        sloping._slope = slope
        return sloping

    def element_at(self, point: OperatingPoint | None) -> SupplyElementInput | None:
        """Supply element at an operating point (None: the bearing as such)."""
        return self.supply_element if point is None else point.supply_element or self.supply_element

    def duties(self) -> Iterator[tuple[tuple[str | int, ...], LoadAndSpeed]]:
        """The bearing and its operating points, with their loads and speeds, each with its path in the case."""
        yield (), self
        for index, point in enumerate(self.operating_points):
            yield ("operating_points", index), point


def _one_of(bearing: JournalBearing, names: tuple[str, ...]) -> Iterator[Issue]:
    """Complain unless each operating point has exactly one of some fields, its own or the bearing's."""
    on_bearing = any(is_given(bearing, name) for name in names)
    points = vars(bearing).get("operating_points", ())
    if not points and not is_given(bearing, "operating_points"):
        yield from exactly_one(bearing, *names)
        return
    yield from at_most_one(bearing, *names)
    for index, point in enumerate(points):
        issues = at_most_one(point, *names) if on_bearing else exactly_one(point, *names)
        for issue in issues:
            yield issue.under("operating_points", index)
