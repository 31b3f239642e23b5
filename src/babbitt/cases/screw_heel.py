"""A footstep of a screw pump: heel, groove, oil, pressures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from babbitt.cases.case_file import CaseFile
from babbitt.cases.fields import Name, Prose, WholeNumber
from babbitt.cases.part import Complaint, Part, rule
from babbitt.footstep.case import HeelCase
from babbitt.footstep.model import (
    PITCH_TOLERANCE,
    BackflowViscosity,
    FaceOutlet,
    Footstep,
    FrictionViscosity,
    HeelGeometry,
    HeelOil,
    HeelOptions,
    LoadReference,
    ScrewGroove,
    Wall,
)
from babbitt.footstep.states import Method
from babbitt.units import si, written

Gap = Annotated[float, si("m", "0.5 um", "1 mm")]
Radius = Annotated[float, si("m", "0.1 mm", "1 m")]


class HeelPart(Part):
    """Lengths of the heel and of the recess in its face."""

    length: Annotated[float, si("m", "1 mm", "1 m")] = Field(description="Length of the cylindrical heel L.")
    radius: Radius = Field(description="Radius of the heel r1.")
    recess_radius: Radius = Field(description="Outer radius of the recess r3.")
    bore_radius: Radius = Field(description="Radius of the bore that feeds the recess r2.")
    recess_depth: Annotated[float, si("m", "0.01 mm", "100 mm")] = Field(description="Depth of the recess H.")

    @rule
    def _radii_in_order(self) -> Iterator[Complaint]:
        pairs = (("recess_radius", "bore_radius"), ("radius", "recess_radius"))
        for larger, smaller in pairs:
            if not getattr(self, larger) > getattr(self, smaller):
                says = f"{smaller} is {written(getattr(self, smaller), 'm')}, not less than {larger}"
                yield Complaint((smaller,), says, "bore_radius < recess_radius < radius")


class GroovePart(Part):
    """The screw groove on the heel."""

    angle: Annotated[float, si("rad", "0.5 deg", "89.5 deg")] = Field(
        description="Angle of the groove, from the circumferential direction."
    )
    depth: Annotated[float, si("m", "1 um", "20 mm")] = Field(description="Depth of the groove h_k.")
    groove_width: Annotated[float, si("m", "0.01 mm", "200 mm")] = Field(
        description="Width of a groove a, normal to it."
    )
    land_width: Annotated[float, si("m", "0.01 mm", "200 mm")] = Field(
        description="Width of a land b, normal to the groove."
    )
    starts: Annotated[int, WholeNumber(1, 1000)] = Field(description="Number of starts z_n.")
    accept_misfit: bool = Field(
        False, description="Accept grooves and lands that do not close around the heel within 3 %."
    )


class HeelOilPart(Part):
    """Oil whose viscosity falls exponentially: mu = viscosity exp(-exponent (T - temperature))."""

    viscosity: Annotated[float, si("Pa s", "0.01 mPa s", "1000 Pa s")] = Field(
        description="Dynamic viscosity at the temperature."
    )
    temperature: Annotated[float, si("K", "-60 degC", "300 degC")] = Field(
        description="Temperature of the oil that comes in, in the bore and at the groove inlet."
    )
    viscosity_exponent: Annotated[float, si("1/K", "0 1/K", "0.2 1/K")] = Field(
        description="Exponent of the viscosity; 0 for a viscosity that does not change."
    )
    volumetric_heat_capacity: Annotated[float, si("J/(m3 K)", "0.1 MJ/(m3 K)", "10 MJ/(m3 K)")] = Field(
        1.76e6, description="Density times heat capacity."
    )
    density: Annotated[float, si("kg/m3", "400 kg/m3", "2000 kg/m3")] = Field(
        880.0, description="Density, for Reynolds numbers, entry loss and centrifugal pressure."
    )


class WallPart(Part):
    """Metal that takes heat from the films (`method: narrow_groove`)."""

    temperature: Annotated[float, si("K", "-60 degC", "300 degC")] = Field(description="Temperature of the metal.")
    conductance: Annotated[float, si("W/K", "0 W/K", "100000 W/K")] = Field(
        description="Heat conductance from the films into the metal, shared by both films in equal halves."
    )


class HeelOptionsPart(Part):
    """What the study leaves open, or prints otherwise; the defaults are the consistent choices."""

    friction_viscosity: Literal["mean", "mixed"] = Field(
        "mean",
        description="Viscosity of the friction in the clearance: mean of inlet and groove end, or at the mixed "
        "rim.",
    )
    face_outlet: Literal["consistent", "printed"] = Field(
        "consistent",
        description="Outlet temperature of the face: by its pressure loss, or as the study prints it.",
    )
    backflow_viscosity: Literal["inlet", "groove"] = Field(
        "inlet", description="Viscosity in the face gap where the rim feeds the recess."
    )
    local_loss_coefficient: Annotated[float, si("1", "0", "100")] = Field(
        0.0, description="Local loss coefficient at the groove inlet; the study lists 1 and uses none."
    )
    speed_reduction: Annotated[float, si("1", "0", "10")] = Field(
        0.0, description="Factor beta of the groove speed omega/(1 + beta), which the study never defines."
    )


class FigureRanges(Part):
    """Ranges of the curves in report and plots."""

    face_gap_from: Gap = Field(5e-6, description="Smallest face gap drawn.")
    face_gap_to: Gap = Field(60e-6, description="Largest face gap drawn.")
    clearance_from: Gap = Field(6e-6, description="Smallest clearance drawn.")
    clearance_to: Gap = Field(60e-6, description="Largest clearance drawn.")

    map_points: Annotated[int, WholeNumber(0, 200)] = Field(
        0,
        description="Face gaps and clearances of a map of load and steady states, such as 60; 0: no map. A point "
        "takes about a millisecond.",
    )

    @rule
    def _in_order(self) -> Iterator[Complaint]:
        for name in ("face_gap", "clearance"):
            low, high = getattr(self, f"{name}_from"), getattr(self, f"{name}_to")
            if not high > 1.05 * low:
                says = f"{name}_to is {written(high, 'm')}, {name}_from {written(low, 'm')}"
                yield Complaint((f"{name}_to",), says, f"more than {name}_from")


class ScrewHeelCase(CaseFile):
    """The hydrostatic footstep of a pump's screw, with a smooth or a screw-grooved heel."""

    kind: Literal["screw_heel"] = Field(description="Footstep with a smooth or screw-grooved heel.")
    name: Name = Field(description="Name of the footstep.")
    method: Literal["superposition", "narrow_groove"] = Field(
        "superposition",
        description="The study's equations (adiabatic groove beside a full slit), or narrow-groove theory.",
    )
    variants: Literal["both", "smooth", "grooved"] = Field("both", description="Which heels to compute.")
    heel: HeelPart = Field(description="Lengths of heel and recess.")
    groove: GroovePart | None = Field(None, description="Screw groove on the heel.")
    face_gap: Gap = Field(description="Face gap h.")
    clearance: Gap = Field(description="Radial clearance delta of the heel.")
    oil: HeelOilPart = Field(description="Oil.")
    wall: WallPart | None = Field(None, description="Metal that takes heat from the films.")
    speed: Annotated[float, si("rad/s", "0.1 rpm", "1000000 rpm")] = Field(description="Speed of the screw.")
    supply_pressure: Annotated[float, si("Pa", "1 Pa", "500 MPa")] = Field(
        description="Pressure in the recess p2; absolute, or as `pressures` says."
    )
    ambient_pressure: Annotated[float, si("Pa", "100 Pa", "100 MPa")] = Field(
        101325.0, description="Pressure at the outer end of the heel p_a, always absolute."
    )
    pressures: Literal["absolute", "gauge"] = Field(
        "absolute", description="What `supply_pressure` is; a gauge pressure is counted from ambient."
    )
    load_reference: Literal["absolute", "gauge"] = Field(
        "absolute",
        description="Whether the load counts absolute pressures, as the study does, or those above ambient.",
    )
    eccentricity_ratio: Annotated[float, si("1", "0", "0.99")] = Field(
        0.0, description="Eccentricity of the heel in its cup over the clearance, at half length."
    )
    tilt: Annotated[float, si("rad", "-2 deg", "2 deg")] = Field(
        0.0, description="Slope of the heel in the plane of the eccentricity; positive: the rim lies farther out."
    )
    options: HeelOptionsPart = Field(HeelOptionsPart(), description="Choices of the study's equations.")
    figures: FigureRanges = Field(FigureRanges(), description="Ranges of the curves.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @property
    def absolute_supply(self) -> float:
        """p2, Pa absolute."""
        return self.supply_pressure + (self.ambient_pressure if self.pressures == "gauge" else 0.0)

    @rule
    def _supply_above_ambient(self) -> Iterator[Complaint]:
        if self.pressures == "absolute" and not self.supply_pressure > self.ambient_pressure:
            says = (
                f"the supply, {written(self.supply_pressure, 'Pa')} absolute, is not above ambient, "
                f"{written(self.ambient_pressure, 'Pa')}"
            )
            yield Complaint(("supply_pressure",), says, "more than ambient_pressure", "write pressures: gauge")

    @rule
    def _grooved_heels_have_grooves(self) -> Iterator[Complaint]:
        if self.variants != "smooth" and self.groove is None:
            yield Complaint(
                ("groove",), f"variants: {self.variants} needs a groove", "groove, or variants: smooth"
            )

    @rule
    def _grooves_close(self) -> Iterator[Complaint]:
        groove = self.groove
        if groove is None or groove.accept_misfit:
            return
        misfit = self._groove().misfit(self.heel.radius)
        if abs(misfit) > PITCH_TOLERANCE:
            says = (
                f"grooves and lands take {1.0 + misfit:.4g} of the way around the heel, starts (groove_width + "
                f"land_width)/(2 pi radius sin angle), a misfit of {100.0 * misfit:+.2g} %"
            )
            hint = "both widths are normal to the groove; accept_misfit: true takes the numbers as they are"
            yield Complaint(("groove",), says, f"at most {100.0 * PITCH_TOLERANCE:.0f} %", hint)

    @rule
    def _heel_fits_the_cup(self) -> Iterator[Complaint]:
        reach = abs(self.eccentricity_ratio) + 0.5 * abs(self.tilt) * self.heel.length / self.clearance
        if reach >= 1.0:
            says = f"eccentricity and tilt bring the heel to {reach:.3g} of the clearance at one end"
            yield Complaint(("tilt",) if self.tilt else ("eccentricity_ratio",), says, "less than 1 at both ends")

    @rule
    def _wall_is_used(self) -> Iterator[Complaint]:
        if self.wall is not None and self.method == "superposition":
            yield Complaint(
                ("wall",), "superposition knows no heat to the metal", "method: narrow_groove with a wall"
            )

    def _groove(self) -> ScrewGroove:
        part = self.groove
        assert part is not None, "asked for a groove that is not given"
        return ScrewGroove(part.angle, part.depth, part.groove_width, part.land_width, part.starts)

    def footstep(self, grooved: bool) -> Footstep:
        """Give the footstep of one variant."""
        heel, oil, chosen = self.heel, self.oil, self.options
        return Footstep(
            geometry=HeelGeometry(
                heel.length, heel.radius, heel.recess_radius, heel.bore_radius, heel.recess_depth
            ),
            oil=HeelOil(
                oil.viscosity, oil.temperature, oil.viscosity_exponent, oil.volumetric_heat_capacity, oil.density
            ),
            angular_speed=self.speed,
            supply_pressure=self.absolute_supply,
            ambient_pressure=self.ambient_pressure,
            face_gap=self.face_gap,
            clearance=self.clearance,
            groove=self._groove() if grooved else None,
            options=HeelOptions(
                friction_viscosity=FrictionViscosity[chosen.friction_viscosity.upper()],
                face_outlet=FaceOutlet[chosen.face_outlet.upper()],
                backflow_viscosity=BackflowViscosity[chosen.backflow_viscosity.upper()],
                load_reference=LoadReference[self.load_reference.upper()],
                entry_loss=chosen.local_loss_coefficient,
                speed_reduction=chosen.speed_reduction,
                any_pitch=self.groove is not None and self.groove.accept_misfit,
            ),
            wall=Wall(self.wall.temperature, self.wall.conductance) if self.wall is not None else None,
            eccentricity_ratio=self.eccentricity_ratio,
            tilt=self.tilt,
        )


def heel_cases(case: ScrewHeelCase) -> tuple[HeelCase, ...]:
    """Design cases of a footstep: the smooth heel, the grooved one, or both."""
    wanted = {"both": (False, True), "smooth": (False,), "grooved": (True,)}[case.variants]
    made = {grooved: case.footstep(grooved) for grooved in wanted}
    ranges = case.figures
    return tuple(
        HeelCase(
            case.name,
            footstep,
            Method(case.method),
            made.get(not grooved),
            (ranges.face_gap_from, ranges.face_gap_to),
            (ranges.clearance_from, ranges.clearance_to),
            ranges.map_points,
            tuple(_given(case)),
            assumptions=case.assumptions,
        )
        for grooved, footstep in made.items()
    )


def _given(case: ScrewHeelCase) -> Iterator[tuple[str, str]]:
    """How the case put what it may put in several ways."""
    yield "Supply pressure", f"{1e-6 * case.supply_pressure:.6g} MPa, {case.pressures}"
    if case.groove is not None:
        misfit = case._groove().misfit(case.heel.radius)
        share = 1.0 / (math.sin(case.groove.angle) * 2.0 * math.pi * case.heel.radius)
        width = case.groove.starts * (case.groove.groove_width + case.groove.land_width)
        yield (
            "Grooves and lands around the heel",
            f"{width * share:.4f} of the circumference ({100 * misfit:+.2f} %)",
        )
