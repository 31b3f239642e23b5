"""The circular cylindrical journal bearing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.cases import clearance, cooling, supply_element
from babbitt.cases.choices import FrictionGiven, LimitsGiven
from babbitt.cases.clearance import ClearanceGiven
from babbitt.cases.fields import Name, Prose, Span
from babbitt.cases.film_features import (
    MOST_DEPARTURE,
    BoreGiven,
    GrooveGiven,
    LobedBoreGiven,
    MeasuredBoreGiven,
    MisalignmentGiven,
    PocketGiven,
    SupplyHoleGiven,
    WornBoreGiven,
    complaint_about_tilt,
    complaints_about_hollows,
)
from babbitt.cases.film_oil import PressureViscosityGiven, TurbulenceGiven
from babbitt.cases.operating_point import LOADS, SPEEDS, Duty, OperatingPoint
from babbitt.cases.part import Complaint, at_most_one, exactly_one, is_bare, is_given, rule
from babbitt.cases.shared import SharedInputs
from babbitt.cases.supply_element import SupplyElementGiven, UnevenPockets
from babbitt.cases.surfaces import SurfacesGiven
from babbitt.units import si, written

WIDTH_RATIOS = (0.1, 1.5)
"""Range of B/D for which the characteristics are on board."""

LEAST_SPECIFIC_LOAD = 1e3
"""Pa. Assumption: a smaller load is a slip of unit."""

GREATEST_SURFACE_SPEED = 200.0
"""m/s. Assumption: a faster plain bearing is a slip of unit."""


class JournalBearing(Duty, SharedInputs):
    """A circular cylindrical journal bearing."""

    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = (*Duty.alternatives, ("width", "width_ratio"))

    kind: Literal["journal"] = Field(description="Circular cylindrical journal bearing.")
    name: Name = Field(description="Name of the bearing in tables and reports.")
    method: Literal["iso7902", "film"] = Field(
        "iso7902", description="Method of calculation: the procedure of ISO 7902, or the film in two dimensions."
    )

    diameter: Annotated[float, si("m", "1 mm", "3 m")] = Field(description="Nominal bearing inside diameter D.")
    width: Annotated[float, si("m", "0.1 mm", "4.5 m")] | None = Field(None, description="Bearing width B.")
    width_ratio: Annotated[float, si("1", "0.1", "1.5")] | None = Field(
        None, description="Relative width B/D, in place of the width."
    )
    clearance: ClearanceGiven = Field(
        description="Clearance at 20 degC. An ISO 286 fit may be written in short, such as H7/e8."
    )
    clearance_cases: Literal["mean", "all"] | None = Field(
        None,
        description="Calculate with the mean clearance, or with minimum, mean and maximum. mean if not given.",
    )
    span: Span | None = Field(
        None, description="Angular span of the loaded arc. Uneven pockets set it if it is not given."
    )
    supply_element: SupplyElementGiven | None = Field(None, description="What feeds the film.")
    grooves: tuple[GrooveGiven, ...] = Field(
        (),
        max_length=12,
        description="Axial grooves as wide as the bearing. Film method, in place of supply_element.",
    )
    pockets: tuple[PocketGiven, ...] = Field(
        (),
        max_length=12,
        description="Pockets and circumferential grooves. Film method, in place of supply_element.",
    )
    holes: tuple[SupplyHoleGiven, ...] = Field(
        (), max_length=24, description="Holes in the bore. Film method, in place of supply_element."
    )
    bore: BoreGiven | None = Field(None, description="Form of the bore, for the film method. round if not given.")
    misalignment: MisalignmentGiven | None = Field(
        None, description="Slopes of the journal axis in the bore, for the film method."
    )
    surfaces: SurfacesGiven | None = Field(None, description="Roughness, tilt and waviness of the surfaces.")

    bearing_speed: Annotated[float, si("rad/s", "-1000000 rpm", "1000000 rpm")] = Field(
        0.0, description="Rotational speed of the bearing, positive counter-clockwise as that of the journal."
    )
    load_angle: Annotated[float, si("rad", "-360 deg", "360 deg")] = Field(
        -math.pi / 2.0,
        description="Direction of the load, counter-clockwise from the x axis. -90 deg is downward. "
        "ISO 7902 takes the load through the middle of the arc, whatever its direction.",
    )
    rotor_mass: Annotated[float, si("kg", "1 g", "10000 t")] | None = Field(
        None,
        description="Part of the mass of the rotor that the bearing carries, for the threshold of whirl "
        "by the film "
        "method. Without it the load is taken as weight.",
    )
    effective_temperature: Annotated[float, si("K", "-30 degC", "290 degC")] | None = Field(
        None, description="Effective temperature of the film, in place of a heat balance."
    )
    operating_points: tuple[OperatingPoint, ...] = Field(
        (), max_length=200, description="Operating points, each with what differs from the bearing."
    )

    friction: FrictionGiven = Field(FrictionGiven(), description="Where the film rubs.")
    characteristics: Literal["computed", "closed_form"] = Field(
        "computed",
        description="Own solutions of the Reynolds equation, or the closed forms of DIN 31652 (360 deg).",
    )
    cavitation: Literal["mass_conserving", "reynolds"] = Field(
        "mass_conserving",
        description="What the film method does where the film breaks up: conserve the oil (JFO), or let "
        "pressure and "
        "its gradient vanish (Reynolds, as in most published tables).",
    )
    cavitation_pressure: Annotated[float, si("Pa", "-1 MPa", "0 Pa")] = Field(
        0.0, description="Gauge pressure at which the film breaks, for the film method."
    )
    turbulence: TurbulenceGiven = Field(
        "laminar",
        description="Turbulence of the film method where the local Reynolds number exceeds 41.3 sqrt(D/C): none, "
        "whatever the Reynolds number, or flow factors by Ng and Pan or Constantinescu.",
    )
    pressure_viscosity: PressureViscosityGiven | None = Field(
        None, description="Growth of the viscosity with pressure, for the film method."
    )
    film_start: Literal["groove", "widest_gap"] | None = Field(
        None,
        description="Where the film method lets the film begin: at what feeds it, or at the widest gap of "
        "a full round "
        "bore (as the characteristics of the standard). groove if not given.",
    )
    accuracy: Literal["draft", "engineering", "reference"] = Field(
        "engineering", description="How fine the grid of the film method is."
    )
    limits: LimitsGiven = Field(LimitsGiven(), description="Limits in place of those by experience.")
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
    def _one_width(self) -> Iterator[Complaint]:
        yield from exactly_one(self, "width", "width_ratio")

    @rule
    def _width_in_tables(self) -> Iterator[Complaint]:
        lowest, highest = WIDTH_RATIOS
        if self.width is not None and not lowest <= self.width / self.diameter <= highest:
            allowed = f"{written(lowest * self.diameter, 'mm')} to {written(highest * self.diameter, 'mm')}"
            says = f"width {written(self.width, 'mm')} is {self.width / self.diameter:.3g} of the diameter"
            yield Complaint(("width",), says, f"{allowed} (B/D {lowest:g} to {highest:g})")

    @rule
    def _one_load(self) -> Iterator[Complaint]:
        yield from _one_of(self, LOADS)

    @rule
    def _loads_make_sense(self) -> Iterator[Complaint]:
        width = self.actual_width
        for path, duty in self._duties():
            if duty.load is None or width is None:
                continue
            pressure = duty.load / (width * self.diameter)
            # A missing "kN" shows here. A load beyond what any film carries is answered by the calculation.
            if pressure < LEAST_SPECIFIC_LOAD:
                says = f"{written(duty.load, 'kN')} is a specific load of {written(pressure, 'kPa')}"
                hint = f"write '{duty.load:.12g} kN'" if is_bare(duty, "load") else ""
                yield Complaint((*path, "load"), says, f"at least {written(LEAST_SPECIFIC_LOAD, 'kPa')}", hint)

    @rule
    def _one_speed(self) -> Iterator[Complaint]:
        yield from _one_of(self, SPEEDS)

    @rule
    def _speeds_make_sense(self) -> Iterator[Complaint]:
        for path, duty in self._duties():
            speed = duty.speed
            if speed is None and duty.surface_speed is not None:
                speed = 2.0 * duty.surface_speed / self.diameter
            if speed is None:
                continue
            if (fast := abs(speed) * self.diameter / 2.0) > GREATEST_SURFACE_SPEED * 1.000001:
                says = f"{written(speed, 'rpm')} is a surface speed of {fast:.4g} m/s"
                hint = f"write '{speed:.12g} rpm'" if is_bare(duty, "speed") else ""
                yield Complaint((*path, "speed"), says, f"up to {GREATEST_SURFACE_SPEED:g} m/s", hint)
            if (speed + self.bearing_speed) * speed <= 0.0:
                both = f"journal {written(speed, 'rpm')}, bearing {written(self.bearing_speed, 'rpm')}"
                says = f"the speeds build no film: {both}"
                yield Complaint(("bearing_speed",), says, "a sum of both in the sense of the journal")

    @rule
    def _points_have_names_of_their_own(self) -> Iterator[Complaint]:
        seen: set[str] = set()
        for index, point in enumerate(self.operating_points):
            if point.name in seen:
                says = f"another operating point is named '{point.name}' too"
                yield Complaint(("operating_points", index, "name"), says, "each name once")
            seen.add(point.name)

    @rule
    def _clearance_fits(self) -> Iterator[Complaint]:
        yield from clearance.complaints_about(self.clearance, self.diameter)

    @rule
    def _housing_fits(self) -> Iterator[Complaint]:
        if self.cooling is not None:
            yield from cooling.complaints_about(self.cooling, self.diameter)

    @rule
    def _elements_fit(self) -> Iterator[Complaint]:
        width = self.actual_width
        if width is None:
            return
        if self.supply_element is not None:
            yield from supply_element.complaints_about(self.supply_element, width, self.diameter)
        for index, point in enumerate(self.operating_points):
            if point.supply_element is not None:
                for told in supply_element.complaints_about(point.supply_element, width, self.diameter):
                    yield told.under("operating_points", index)

    @rule
    def _span_is_known(self) -> Iterator[Complaint]:
        if self.method == "film" and (self.hollows() or self.film_start == "widest_gap"):
            return
        for point in self.operating_points or (None,):
            if self.span_at(point) is None:
                besides = ", or grooves, pockets or holes" if self.method == "film" else ""
                yield Complaint(
                    ("span",),
                    "is missing",
                    f"360, 180, 150, 120, 90 deg, or a supply_element of kind uneven_pockets{besides}",
                    code="E003",
                )
                return

    @rule
    def _closed_forms_are_of_the_full_bearing(self) -> Iterator[Complaint]:
        spans = (self.span_at(point) for point in self.operating_points or (None,))
        others = [span for span in spans if span not in (None, 360)]
        if self.characteristics == "closed_form" and others:
            says = f"closed forms exist for a span of 360 deg, not {others[0]} deg"
            yield Complaint(("characteristics",), says, "computed, or span 360 deg")

    @rule
    def _hollows_fit(self) -> Iterator[Complaint]:
        yield from complaints_about_hollows(self.hollows(), self.actual_width, self.diameter)

    @rule
    def _method_knows_the_bearing(self) -> Iterator[Complaint]:
        if self.method == "film":
            return
        if self.bore is not None and self.bore.kind != "round":
            yield Complaint(("bore",), f"ISO 7902 knows round bores only, not {self.bore.kind}", "method: film")
        if self.misalignment is not None:
            yield Complaint(("misalignment",), "ISO 7902 knows no misaligned journal", "method: film")
        if self.turbulence != "laminar":
            yield Complaint(("turbulence",), "ISO 7902 knows laminar films only", "method: film")
        if self.pressure_viscosity is not None:
            yield Complaint(("pressure_viscosity",), "ISO 7902 knows no viscosity under pressure", "method: film")
        for path, duty in self._duties():
            if duty.attitude_angle is not None:
                says = "ISO 7902 finds the attitude angle itself"
                yield Complaint((*path, "attitude_angle"), says, "method: film, or leave it out")

    @rule
    def _tilt_leaves_a_film(self) -> Iterator[Complaint]:
        width = self.actual_width
        if self.misalignment is None or width is None:
            return
        play = self.clearance.at_20_degrees(self.diameter).relative(self.diameter).minimum * self.diameter / 2.0
        offset = math.hypot(self.misalignment.x, self.misalignment.y) * width / 2.0
        if offset >= play:
            says = f"the journal touches at the edges: it leans {written(offset, 'um')} there"
            yield Complaint(("misalignment",), says, f"less than the radial clearance, {written(play, 'um')}")

    @rule
    def _tilt_needs_narrow_supplies(self) -> Iterator[Complaint]:
        width = self.actual_width
        if self.misalignment is None or self.method != "film" or width is None or self.film_start == "widest_gap":
            return
        from babbitt.cases.film_layout import film_layout  # it reads this model

        if not self.hollows() and any(self.span_at(point) is None for point in self.operating_points or (None,)):
            return
        layouts = (film_layout(self, point, width, 1.0) for point in self.operating_points or (None,))
        yield from complaint_about_tilt(any(hollow.width is None for at in layouts for hollow in at.hollows))

    @rule
    def _departures_are_of_the_size_of_the_clearance(self) -> Iterator[Complaint]:
        if not isinstance(self.bore, WornBoreGiven | MeasuredBoreGiven):
            return
        largest = self.bore.largest_departure
        clearance = self.clearance.at_20_degrees(self.diameter).mean / 2.0
        if largest > MOST_DEPARTURE * clearance:
            says = f"the bore departs by {written(largest, 'um')} from its circle"
            allowed = f"up to {MOST_DEPARTURE:g} times the radial clearance of {written(clearance, 'um')}"
            yield Complaint(("bore",), says, allowed)

    @rule
    def _lobes_lie_between_grooves(self) -> Iterator[Complaint]:
        if isinstance(self.bore, LobedBoreGiven) and len(self.grooves) < 2:
            says = f"lobes lie between grooves; {len(self.grooves)} given"
            yield Complaint(("bore",), says, "as many grooves as lobes, at least two")

    @rule
    def _widest_gap_is_of_a_plain_bore(self) -> Iterator[Complaint]:
        if self.film_start != "widest_gap" or self.method != "film":
            return
        if self.hollows():
            says = "a film that starts at the widest gap has no grooves, pockets or holes"
            yield Complaint(("film_start",), says, "groove")
        if (self.bore is not None and self.bore.kind != "round") or self.misalignment is not None:
            says = "a film that starts at the widest gap needs a round bore and an aligned journal"
            yield Complaint(("film_start",), says, "groove")
        if self.span not in (None, 360):
            says = f"a film that starts at the widest gap surrounds the journal; span is {self.span} deg"
            yield Complaint(("film_start",), says, "groove, or span 360 deg")
        for name in ("turbulence", "pressure_viscosity"):
            if getattr(self, name) not in (None, "laminar"):
                says = "a film that starts at the widest gap is laminar and of constant viscosity"
                yield Complaint((name,), says, "film_start: groove")
        if self.cavitation == "mass_conserving":
            says = "a film that starts at the widest gap does not conserve the oil"
            yield Complaint(("cavitation",), says, "reynolds")

    @rule
    def _given_flows_are_counted(self) -> Iterator[Complaint]:
        for path, hollow in self.hollows():
            if hollow.flow is None:
                continue
            if self.method == "film" and self.cavitation != "mass_conserving":
                says = "the Reynolds condition does not count the oil that a supply of given flow delivers"
                yield Complaint((*path, "flow"), says, "cavitation: mass_conserving, or a pressure")

    @rule
    def _grooves_stand_still(self) -> Iterator[Complaint]:
        if self.method == "film" and self.bearing_speed and self.film_start != "widest_gap":
            says = "grooves and pockets that turn with the bearing leave no steady film"
            yield Complaint(("bearing_speed",), says, "0 rpm, or film_start: widest_gap")

    def hollows(self) -> list[tuple[tuple[str | int, ...], GrooveGiven | PocketGiven | SupplyHoleGiven]]:
        """Grooves, pockets and holes, each with its path in the case."""
        return [
            ((name, index), hollow)
            for name in ("grooves", "pockets", "holes")
            for index, hollow in enumerate(getattr(self, name))
        ]

    def span_at(self, point: OperatingPoint | None) -> int | None:
        """Angular span in degrees at an operating point (None: the bearing as such), None while unknown."""
        if point is not None and point.span is not None:
            return point.span
        element = self.element_at(point)
        own_element = point is not None and point.supply_element is not None
        if isinstance(element, UnevenPockets) and (self.span is None or own_element):
            return element.conventional_span().tabulated
        return self.span

    def element_at(self, point: OperatingPoint | None) -> SupplyElementGiven | None:
        """Supply element at an operating point (None: the bearing as such)."""
        return self.supply_element if point is None else point.supply_element or self.supply_element

    def _duties(self) -> Iterator[tuple[tuple[str | int, ...], Duty]]:
        yield (), self
        for index, point in enumerate(self.operating_points):
            yield ("operating_points", index), point


def _one_of(bearing: JournalBearing, names: tuple[str, ...]) -> Iterator[Complaint]:
    """Complain unless each operating point has exactly one of some fields, its own or the bearing's."""
    on_bearing = any(is_given(bearing, name) for name in names)
    points = vars(bearing).get("operating_points", ())
    if not points and not is_given(bearing, "operating_points"):
        yield from exactly_one(bearing, *names)
        return
    yield from at_most_one(bearing, *names)
    for index, point in enumerate(points):
        complaints = at_most_one(point, *names) if on_bearing else exactly_one(point, *names)
        for told in complaints:
            yield told.under("operating_points", index)
