"""Hydrostatic and hybrid bearings: pads, thrust rings, journal bearings."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.cases.bare_numbers import about_load, about_speed
from babbitt.cases.case_file import CaseFile
from babbitt.cases.fields import Name, Prose, WholeNumber
from babbitt.cases.lubricant import LubricantGiven
from babbitt.cases.own_lubricant import DynamicViscosity
from babbitt.cases.part import Complaint, Part, exactly_one, is_given, refused, rule
from babbitt.cases.recess_rules import clearance_is_small, in_order, lands_between
from babbitt.cases.restrictors import ConstantFlowGiven, HydrostaticSupply, RestrictorGiven
from babbitt.hydrostatics.geometry import (
    AnnularPad,
    CircularPad,
    PadShape,
    RecessedJournal,
    RectangularPad,
    ThrustRing,
)
from babbitt.hydrostatics.impedance import Compressibility
from babbitt.hydrostatics.model import Duty, HydrostaticCase, Oil, Recesses, Shape
from babbitt.units import either_sense, si, written

Length = Annotated[float, si("m", "0.1 mm", "20 m")]
Gap = Annotated[float, si("m", "1 um", "2 mm")]
Load = Annotated[float, si("N", "1 N", "1000 MN")]
Angle = Annotated[float, si("rad", "-360 deg", "360 deg")]
Extent = Annotated[float, si("rad", "0.5 deg", "359 deg")]
Groove = Annotated[float, si("rad", "0 deg", "180 deg")]
Speed = Annotated[float, either_sense("rad/s", "0 rpm", "200000 rpm")]
Frequency = Annotated[float, si("rad/s", "0 Hz", "100 kHz")]


class HydrostaticOil(Part):
    """The oil: its numbers, or a lubricant at a temperature."""

    example: ClassVar[str] = "{viscosity: 20 mPas, density: 870 kg/m3, heat_capacity: 2000 J/(kg K)}"

    viscosity: DynamicViscosity | None = Field(None, description="Viscosity in the film.")
    density: Annotated[float, si("kg/m3", "500 kg/m3", "2500 kg/m3")] = Field(
        870.0, description="Density. Used with viscosity; a lubricant has its own."
    )
    heat_capacity: Annotated[float, si("J/(kg K)", "500 J/(kg K)", "10 kJ/(kg K)")] = Field(
        2000.0, description="Specific heat. Used with viscosity; a lubricant has its own."
    )
    lubricant: LubricantGiven | None = Field(None, description="A lubricant in place of viscosity.")
    supply_temperature: Annotated[float, si("K", "-30 degC", "200 degC")] | None = Field(
        None, description="Temperature of a lubricant before the restrictors."
    )
    film_temperature: Annotated[float, si("K", "-30 degC", "250 degC")] | None = Field(
        None,
        description="Temperature of a lubricant in the film. Where it is not given it is found: that of the "
        "supply, "
        "warmed by what is lost in the film.",
    )

    @rule
    def _one_way(self) -> Iterator[Complaint]:
        yield from exactly_one(self, "viscosity", "lubricant")
        if is_given(self, "lubricant") and self.supply_temperature is None:
            yield Complaint(("supply_temperature",), "the lubricant has no temperature", "supply_temperature",
                            code="E003")  # fmt: skip

    def oils(self) -> tuple[Oil, Oil]:
        """Give the oil in the film and that in the restrictors."""
        if self.lubricant is None or self.supply_temperature is None:
            oil = Oil(self.viscosity or 0.0, self.density, self.heat_capacity)
            return oil, oil
        supplied = Oil(1.0, 1.0, 1.0, self.lubricant.lubricant(), self.supply_temperature).at(
            self.supply_temperature
        )
        if self.film_temperature is None:
            return supplied, supplied
        film = supplied.at(self.film_temperature)
        return Oil(film.viscosity, film.density, film.heat_capacity, None, self.supply_temperature), supplied


DIAMETERS = ("inner_diameter", "recess_inner_diameter", "recess_outer_diameter", "outer_diameter")
"""Edges of a ring and of its recess, from inside to outside."""


class RecessOil(Part):
    """Depth of the recesses and the oil that gives way in them."""

    example: ClassVar[str] = "{depth: 1 mm, line_volume: 2 mL}"

    depth: Annotated[float, si("m", "10 um", "100 mm")] = Field(description="Depth of the recesses.")
    line_volume: Annotated[float, si("m3", "0 mL", "100 L")] = Field(
        0.0, description="Oil between one restrictor and its recess, besides the recess itself."
    )
    bulk_modulus: Annotated[float, si("Pa", "1 MPa", "10 GPa")] = Field(
        1.4e9, description="Bulk modulus of the oil with its air."
    )
    friction_factor: Annotated[float, si("1", "1", "8")] | None = Field(
        None,
        description="Wall shear in the recess over mu U/depth: 1 where the oil turns with the runner (round and "
        "annular recesses), 4 in closed recesses with recirculation. Chosen by the shape if not given.",
    )


class HydrostaticFile(CaseFile):
    """What all hydrostatic bearings have."""

    shaped_by: ClassVar[tuple[str, ...]] = ("recesses",)
    """Field to blame where the shape cannot be."""

    kind: str = Field(description="What the file describes.")
    name: Name = Field(description="Name of the bearing.")
    method: Literal["film", "quick"] = Field(
        "film", description="The film in two dimensions with the recess network, or closed forms and lumped lands."
    )
    accuracy: Literal["draft", "engineering", "reference"] = Field(
        "engineering",
        description="Grid of the film. A full film of reference accuracy is solved on half the lines as well and "
        "extrapolated.",
    )
    restrictor: RestrictorGiven = Field(description="The restrictor before every recess.")
    supply: HydrostaticSupply = Field(description="Oil before the restrictors.")
    oil: HydrostaticOil = Field(description="The oil.")
    recess_oil: RecessOil = Field(description="Depth of the recesses and the oil in them.")
    load: Load | None = Field(None, description="Load. Without it a position is given.")
    frequencies: tuple[Frequency, ...] = Field(
        (), max_length=200, description="Frequencies at which stiffness and damping are wanted."
    )
    least_gap: Gap | None = Field(None, description="Least permissible gap.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @abstractmethod
    def shape(self) -> Shape:
        """Give the shape of the calculation."""

    @abstractmethod
    def duty(self) -> Duty:
        """Give the duty of the calculation."""

    @property
    def recess_count(self) -> int:
        """Number of recesses."""
        return 1

    def misfits(self) -> Iterator[Complaint]:
        """Complain of lengths and angles that do not fit each other."""
        yield from ()

    @rule
    def _shape_can_be_made(self) -> Iterator[Complaint]:
        told = list(self.misfits())
        yield from told or refused(self.shaped_by, self.shape)

    @rule
    def _oil_reaches(self) -> Iterator[Complaint]:
        yield from refused(("oil",), self.oil.oils)

    @rule
    def _one_pump_too_many(self) -> Iterator[Complaint]:
        if isinstance(self.restrictor, ConstantFlowGiven) and is_given(self.supply, "pump_flow"):
            says = "constant_flow has a pump for every recess, and the supply names one pump for all"
            hint = "the pressure that the pumps of the recesses can reach; restrictor.flow is what each delivers"
            yield Complaint(("supply", "pump_flow"), says, "pressure", hint)

    def designs(self) -> tuple[HydrostaticCase, ...]:
        """Give the case of the calculation."""
        return (self.design(),)

    def design(self) -> HydrostaticCase:
        """Give the case of the calculation."""
        film, supplied = self.oil.oils()
        shape = self.shape()
        own = self.recess_oil
        turning = isinstance(shape, CircularPad | AnnularPad)
        factor = own.friction_factor or (1.0 if turning else 4.0)
        restrictor = self.restrictor.restrictor(supplied.viscosity, supplied.density)
        assumptions = list(self.assumptions)
        if self.recess_oil.friction_factor is None:
            assumptions.append(f"Friction factor {factor:g} in the recesses, by their shape.")
        if not is_given(own, "bulk_modulus"):
            assumptions.append("Bulk modulus of the oil 1.4 GPa, without air.")
        if self.oil.lubricant is None and not {"density", "heat_capacity"} <= self.oil.model_fields_set:
            assumptions.append("Density 870 kg/m³ and specific heat 2000 J/(kg K) where not given.")
        return HydrostaticCase(
            name=self.name,
            kind=self.kind,
            method=self.method,
            shape=shape,
            feeding=self.supply.feeding(restrictor, self.recess_count),
            oil=film,
            duty=self.duty(),
            recesses=Recesses(own.depth, factor),
            compressibility=Compressibility(
                shape.recess_area * own.depth + own.line_volume, own.bulk_modulus, self.supply.manifold_volume
            ),
            frequencies=self.frequencies,
            pump_efficiency=self.supply.pump_efficiency,
            least_gap=self.least_gap,
            highest_supply_pressure=self.supply.highest_pressure,
            accuracy=self.accuracy,
            assumptions=tuple(assumptions),
            doubts=(*about_speed(self, "speed"), *about_load(self)),
        )


class CircularGiven(Part):
    """A round pad with a round recess in the middle."""

    example: ClassVar[str] = "{kind: circular, diameter: 100 mm, recess_diameter: 50 mm}"

    kind: Literal["circular"] = Field(description="Round pad.")
    diameter: Length = Field(description="Outer diameter.")
    recess_diameter: Length = Field(description="Diameter of the recess.")

    @rule
    def _recess_inside(self) -> Iterator[Complaint]:
        yield from in_order(self, "recess_diameter", "diameter")

    def pad(self) -> PadShape:
        """Give the pad of the calculation."""
        return CircularPad(0.5 * self.diameter, 0.5 * self.recess_diameter)


class AnnularGiven(Part):
    """A ring with an annular recess."""

    kind: Literal["annular"] = Field(description="Ring with one annular recess.")
    inner_diameter: Length = Field(description="Inner edge of the ring.")
    recess_inner_diameter: Length = Field(description="Inner edge of the recess.")
    recess_outer_diameter: Length = Field(description="Outer edge of the recess.")
    outer_diameter: Length = Field(description="Outer edge of the ring.")

    @rule
    def _diameters_in_order(self) -> Iterator[Complaint]:
        yield from in_order(self, *DIAMETERS)

    def pad(self) -> AnnularPad:
        """Give the pad of the calculation."""
        return AnnularPad(
            0.5 * self.inner_diameter,
            0.5 * self.recess_inner_diameter,
            0.5 * self.recess_outer_diameter,
            0.5 * self.outer_diameter,
        )


class RectangularGiven(Part):
    """A rectangle with a rectangular recess in the middle."""

    kind: Literal["rectangular"] = Field(description="Rectangular pad.")
    length: Length = Field(description="Side along the sliding, if it slides.")
    width: Length = Field(description="Other side.")
    recess_length: Length = Field(description="Side of the recess along length.")
    recess_width: Length = Field(description="Other side of the recess.")

    @rule
    def _recess_inside(self) -> Iterator[Complaint]:
        yield from in_order(self, "recess_length", "length")
        yield from in_order(self, "recess_width", "width")

    def pad(self) -> PadShape:
        """Give the pad of the calculation."""
        return RectangularPad(self.length, self.width, self.recess_length, self.recess_width)


class HydrostaticPadCase(HydrostaticFile):
    """A pad with one recess."""

    shaped_by: ClassVar[tuple[str, ...]] = ("pad",)

    kind: Literal["hydrostatic_pad"] = Field(description="Pad with one recess: round, annular, rectangular.")
    pad: Annotated[CircularGiven | AnnularGiven | RectangularGiven, Discriminator("kind")] = Field(
        description="Shape of the pad."
    )
    gap: Gap | None = Field(None, description="Gap, in place of the load.")
    speed: Speed = Field(0.0, description="Rotational speed of round and annular pads about their axis.")
    sliding_speed: Annotated[float, si("m/s", "0 m/s", "200 m/s")] = Field(
        0.0, description="Sliding speed of rectangular pads."
    )

    @rule
    def _load_or_gap(self) -> Iterator[Complaint]:
        yield from exactly_one(self, "load", "gap")

    @rule
    def _motion_fits(self) -> Iterator[Complaint]:
        rectangular = isinstance(self.pad, RectangularGiven)
        if rectangular and is_given(self, "speed"):
            yield Complaint(("speed",), "a rectangular pad does not turn", "sliding_speed", "write sliding_speed")
        if not rectangular and is_given(self, "sliding_speed"):
            yield Complaint(("sliding_speed",), "a round pad does not slide", "speed", "write speed")

    @rule
    def _closed_forms_reach(self) -> Iterator[Complaint]:
        pad = self.pad
        if self.method != "quick" or not isinstance(pad, RectangularGiven):
            return
        along, aside = 0.5 * (pad.length - pad.recess_length), 0.5 * (pad.width - pad.recess_width)
        shorter = min(pad.recess_length, pad.recess_width)
        if math.isclose(along, aside, rel_tol=1e-6) and shorter < along:
            says = (
                f"the shorter side of the recess, {written(shorter, 'mm')}, is less than its land, "
                f"{written(along, 'mm')}: the corners touch and the closed forms end"
            )
            yield Complaint(("method",), says, "method: film, or a larger recess")

    def shape(self) -> PadShape:
        """Give the shape of the calculation."""
        return self.pad.pad()

    def duty(self) -> Duty:
        """Give the duty of the calculation."""
        return Duty(self.load, gap=self.gap or 0.0, angular_speed=self.speed, sliding_speed=self.sliding_speed)


class RecessRow(Part):
    """Equal recesses around the axis."""

    example: ClassVar[str] = "{number: 4, extent: 60 deg, first: -90 deg}"

    number: Annotated[int, WholeNumber(1, 60)] = Field(description="Number of recesses.")
    extent: Extent = Field(description="Angle that each takes.")
    first: Angle = Field(-0.5 * math.pi, description="Middle of the first, from +x counter-clockwise.")
    angles: tuple[Angle, ...] = Field(
        (), max_length=60, description="Middles of all recesses, where they do not stand at equal distances."
    )
    drain_groove: Groove = Field(
        0.0, description="Angle of drain grooves at ambient pressure halfway between the recesses; zero: none."
    )

    @rule
    def _all_angles(self) -> Iterator[Complaint]:
        if self.angles and len(self.angles) != self.number:
            yield Complaint(("angles",), f"{len(self.angles)} angles for {self.number} recesses", "one for each")

    @property
    def middles(self) -> tuple[float, ...]:
        """Middles of the recesses, rad."""
        return self.angles or tuple(self.first + 2.0 * math.pi * k / self.number for k in range(self.number))


class HydrostaticThrustRingCase(HydrostaticFile):
    """A thrust ring with several recesses."""

    kind: Literal["hydrostatic_thrust_ring"] = Field(description="Thrust ring with several recesses, with tilt.")
    inner_diameter: Length = Field(description="Inner edge of the ring.")
    recess_inner_diameter: Length = Field(description="Inner edge of the recesses.")
    recess_outer_diameter: Length = Field(description="Outer edge of the recesses.")
    outer_diameter: Length = Field(description="Outer edge of the ring.")
    recesses: RecessRow = Field(description="The recesses.")
    moments: tuple[
        Annotated[float, si("N m", "-1e9 N m", "1e9 N m")], Annotated[float, si("N m", "-1e9 N m", "1e9 N m")]
    ] = Field((0.0, 0.0), description="Moments of the load about x and y, that tilt the runner.")
    gap: Gap | None = Field(None, description="Gap on the axis, in place of the load.")
    tilt: tuple[Annotated[float, si("1", "-0.1", "0.1")], Annotated[float, si("1", "-0.1", "0.1")]] = Field(
        (0.0, 0.0), description="Tilt about x and y with a given gap, rad."
    )
    speed: Speed = Field(0.0, description="Rotational speed of the runner; positive counter-clockwise.")

    @rule
    def _load_or_gap(self) -> Iterator[Complaint]:
        yield from exactly_one(self, "load", "gap")
        if is_given(self, "tilt") and self.gap is None:
            yield Complaint(("tilt",), "a tilt is given without the gap", "gap and tilt, or load and moments")
        if is_given(self, "moments") and self.load is None:
            yield Complaint(
                ("moments",), "moments are given without the load", "load and moments, or gap and tilt"
            )

    @rule
    def _tilt_leaves_a_gap(self) -> Iterator[Complaint]:
        tilt, edge = math.hypot(*self.tilt), 0.5 * self.outer_diameter
        if self.gap is not None and tilt * edge >= self.gap:
            where = math.degrees(math.atan2(-self.tilt[0], self.tilt[1]))
            says = (
                f"a tilt of {1e3 * tilt:.4g} mm/m closes the gap of {written(self.gap, 'um')} on the outer "
                f"edge at {where:.4g} deg"
            )
            yield Complaint(
                ("tilt",), says, f"less than {1e3 * self.gap / edge:.4g} mm/m in all", "or a wider gap"
            )

    @property
    def recess_count(self) -> int:
        """Number of recesses."""
        return self.recesses.number

    def misfits(self) -> Iterator[Complaint]:
        """Complain of edges out of order and of recesses without lands between them."""
        yield from in_order(self, *DIAMETERS)
        yield from lands_between("recesses", self.recesses)

    def shape(self) -> ThrustRing:
        """Give the shape of the calculation."""
        radii = AnnularPad(
            0.5 * self.inner_diameter,
            0.5 * self.recess_inner_diameter,
            0.5 * self.recess_outer_diameter,
            0.5 * self.outer_diameter,
        )
        row = self.recesses
        return ThrustRing(radii, row.middles, row.extent, row.drain_groove)

    def duty(self) -> Duty:
        """Give the duty of the calculation."""
        return Duty(self.load, moments=self.moments, gap=self.gap or 0.0, tilt=self.tilt, angular_speed=self.speed)


class HydrostaticJournalCase(HydrostaticFile):
    """A recessed journal bearing, hydrostatic or hybrid."""

    kind: Literal["hydrostatic_journal"] = Field(description="Recessed journal bearing, at rest or turning.")
    diameter: Length = Field(description="Bore.")
    width: Length = Field(description="Width of the bearing.")
    radial_clearance: Gap = Field(description="Radial clearance.")
    recesses: RecessRow = Field(description="The recesses.")
    recess_length: Length = Field(description="Axial length of the recesses.")
    speed: Speed = Field(0.0, description="Rotational speed; positive counter-clockwise.")
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

    @rule
    def _load_or_position(self) -> Iterator[Complaint]:
        yield from exactly_one(self, "load", "eccentricity_ratio")

    @property
    def recess_count(self) -> int:
        """Number of recesses."""
        return self.recesses.number

    def misfits(self) -> Iterator[Complaint]:
        """Complain of recesses that leave the bearing or no land between them."""
        yield from clearance_is_small(self.radial_clearance, self.diameter)
        yield from in_order(self, "recess_length", "width")
        yield from lands_between("recesses", self.recesses)

    def shape(self) -> RecessedJournal:
        """Give the shape of the calculation."""
        row = self.recesses
        return RecessedJournal(
            self.diameter, self.width, self.radial_clearance, row.middles, row.extent, self.recess_length,
            row.drain_groove,
        )  # fmt: skip

    def duty(self) -> Duty:
        """Give the duty of the calculation."""
        e = (self.eccentricity_ratio or 0.0) * self.radial_clearance
        angle = self.load_angle + math.copysign(1.0, self.speed) * self.attitude_angle
        return Duty(
            self.load,
            self.load_angle,
            position=(e * math.cos(angle), e * math.sin(angle)),
            angular_speed=self.speed,
        )

    def design(self) -> HydrostaticCase:
        """Give the case of the calculation."""
        return replace(super().design(), cavitation_pressure=self.cavitation_pressure)
