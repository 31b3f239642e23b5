"""A footstep of a screw pump: heel, groove, oil, pressures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.aliases import FormerWords, Moved
from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import Issue, not_read, refused, rule
from babbitt.case.parts.clearance import LIMITS, ClearanceInput, is_bare, mean_assumed, mean_radial
from babbitt.case.parts.fields import Name, Prose
from babbitt.core.notices import Notice
from babbitt.core.solution import Calculation
from babbitt.core.units import si, written
from babbitt.kinds.footstep.case.footstep_parts import (
    METHOD_MAPPING,
    FigureRanges,
    FootstepOilInput,
    FootstepOptionsInput,
    FootstepSupply,
    Gap,
    GroovePart,
    HeelInput,
    WallPart,
)
from babbitt.kinds.footstep.methods import METHODS
from babbitt.kinds.footstep.model import (
    PITCH_TOLERANCE,
    BackflowViscosity,
    FaceOutlet,
    Footstep,
    FootstepGeometry,
    FootstepOil,
    FootstepOptions,
    FrictionViscosity,
    LoadReference,
    ScrewGroove,
    Wall,
)
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.states import Method

LEAST_CLEARANCE, GREATEST_CLEARANCE = 0.5e-6, 1e-3
"""m, radial: as of the face gap."""
OF_GROOVES = ("friction_viscosity", "backflow_viscosity", "local_loss_coefficient")
"""Options that only a grooved heel reads."""


class FootstepCase(CaseFile):
    """The hydrostatic footstep of a pump's screw, with a smooth or a screw-grooved heel."""

    former_words: ClassVar[FormerWords] = {
        "clearance": Moved("clearance.mean", kind="radial", where=is_bare),
        "oil.temperature": "supply.temperature",
        "supply_pressure": "supply.pressure",
    }

    kind: Literal["screw_heel"] = Field(description="Footstep with a smooth or screw-grooved heel.")
    name: Name = Field(description="Name of the footstep.")
    method: Annotated[Literal["superposition", "narrow_groove"], METHOD_MAPPING] = Field(
        "superposition",
        description="The study's equations (adiabatic groove beside a full slit), or narrow-groove theory.",
    )
    variants: Literal["both", "smooth", "grooved"] = Field("both", description="Which heels to compute.")
    heel: HeelInput = Field(description="Lengths of heel and recess.")
    groove: GroovePart | None = Field(None, description="Screw groove on the heel.")
    face_gap: Gap = Field(description="Face gap h_f.")
    clearance: ClearanceInput = Field(
        description="Clearance of the heel at 20 degC; its mean is computed. A length alone is that on the radius."
    )
    supply: FootstepSupply = Field(description="Oil that comes in.")
    oil: FootstepOilInput = Field(description="Oil.")
    wall: WallPart | None = Field(None, description="Metal that takes heat from the films.")
    speed: Annotated[float, si("rad/s", "0.1 rpm", "1000000 rpm")] = Field(
        description="Speed of the screw, without a sign: it turns so that the groove drags oil from its outer end "
        "to the rim. A groove of the other hand, or the other sense of rotation, drains the rim and is not "
        "computed."
    )
    ambient_pressure: Annotated[float, si("Pa", "100 Pa", "100 MPa")] = Field(
        101325.0, description="Pressure at the outer end of the heel p_a, always absolute."
    )
    pressures: Literal["absolute", "gauge"] = Field(
        "absolute", description="What `supply.pressure` is; a gauge pressure is counted from ambient."
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
    options: FootstepOptionsInput = Field(FootstepOptionsInput(), description="Choices of the study's equations.")
    figures: FigureRanges = Field(FigureRanges(), description="Ranges of the curves.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @property
    def absolute_supply(self) -> float:
        """p2, Pa absolute."""
        return self.supply.pressure + (self.ambient_pressure if self.pressures == "gauge" else 0.0)

    @rule
    def _supply_above_ambient(self) -> Iterator[Issue]:
        if self.pressures == "absolute" and not self.supply.pressure > self.ambient_pressure:
            says = (
                f"the supply, {written(self.supply.pressure, 'MPa')} absolute, is not above ambient, "
                f"{written(self.ambient_pressure, 'MPa')}"
            )
            yield Issue(("supply", "pressure"), says, "more than ambient_pressure", "write pressures: gauge")

    @rule
    def _grooved_heels_have_grooves(self) -> Iterator[Issue]:
        if self.variants != "smooth" and self.groove is None:
            says = f"variants: {self.variants} needs a groove"
            yield Issue(("groove",), says, "groove, or variants: smooth", lacks=())

    @rule
    def _grooves_close(self) -> Iterator[Issue]:
        groove = self.groove
        if groove is None or groove.accept_misfit:
            return
        misfit = self._groove().misfit(0.5 * self.heel.diameter)
        if abs(misfit) > PITCH_TOLERANCE:
            says = (
                f"grooves and lands take {1.0 + misfit:.4g} of the way around the heel, starts (groove_width + "
                f"land_width)/(2 pi radius sin angle), a misfit of {100.0 * misfit:+.2g} %"
            )
            hint = "both widths are normal to the groove; accept_misfit: true takes the numbers as they are"
            yield Issue(("groove",), says, f"at most {100.0 * PITCH_TOLERANCE:.0f} %", hint)

    def radial_clearance(self) -> float:
        """Give the clearance of the calculation, m."""
        return mean_radial(self.clearance, self.heel.diameter)

    @rule
    def _clearance_is_usable(self) -> Iterator[Issue]:
        yield from refused(("clearance",), self.radial_clearance)
        clearance = self.radial_clearance()
        if not LEAST_CLEARANCE <= clearance <= GREATEST_CLEARANCE:
            says = f"the radial clearance is {written(clearance, 'um')}"
            allowed = f"{written(LEAST_CLEARANCE, 'um')} to {written(GREATEST_CLEARANCE, 'mm')}"
            yield Issue(("clearance",), says, allowed, code="E003")

    @rule
    def _heel_fits_the_cup(self) -> Iterator[Issue]:
        reach = abs(self.eccentricity_ratio) + 0.5 * abs(self.tilt) * self.heel.length / self.radial_clearance()
        if reach >= 1.0:
            says = f"eccentricity and tilt bring the heel to {reach:.3g} of the clearance at one end"
            yield Issue(("tilt",) if self.tilt else ("eccentricity_ratio",), says, "less than 1 at both ends")

    @rule
    def _wall_is_used(self) -> Iterator[Issue]:
        if self.wall is not None and self.method == "superposition":
            yield Issue(("wall",), "superposition knows no heat to the metal", "method: narrow_groove with a wall")

    @rule
    def _options_are_used(self) -> Iterator[Issue]:
        if self.method == "narrow_groove":
            for name in sorted(self.options.model_fields_set):
                yield Issue(
                    ("options", name),
                    "belongs to the study's equations; narrow_groove does not know it",
                    "nothing with method: narrow_groove",
                    "leave it out, or method: superposition",
                )

    def _groove(self) -> ScrewGroove:
        part = self.groove
        assert part is not None, "asked for a groove that is not given"
        return ScrewGroove(part.angle, part.depth, part.groove_width, part.land_width, part.starts)

    def footstep(self, grooved: bool) -> Footstep:
        """Give the footstep of one variant."""
        heel, oil, chosen = self.heel, self.oil, self.options
        return Footstep(
            geometry=FootstepGeometry(
                heel.length,
                0.5 * heel.diameter,
                0.5 * heel.recess_diameter,
                0.5 * heel.inner_diameter,
                heel.recess_depth,
            ),
            oil=FootstepOil(
                oil.viscosity,
                self.supply.temperature,
                oil.viscosity_exponent,
                oil.volumetric_heat_capacity,
                oil.density,
            ),
            angular_speed=self.speed,
            supply_pressure=self.absolute_supply,
            ambient_pressure=self.ambient_pressure,
            face_gap=self.face_gap,
            clearance=self.radial_clearance(),
            groove=self._groove() if grooved else None,
            options=FootstepOptions(
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

    @property
    def diameter(self) -> float:
        """Diameter about which the clearance is, m."""
        return self.heel.diameter

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the smooth heel, the grooved one, or both."""
        return tuple(Calculation(problem, METHODS[problem.method.value]) for problem in heel_cases(self))


def heel_cases(case: FootstepCase) -> tuple[FootstepProblem, ...]:
    """Design cases of a footstep: the smooth heel, the grooved one, or both."""
    wanted = {"both": (False, True), "smooth": (False,), "grooved": (True,)}[case.variants]
    made = {grooved: case.footstep(grooved) for grooved in wanted}
    ranges = case.figures
    return tuple(
        FootstepProblem(
            case.name,
            footstep,
            Method(case.method),
            made.get(not grooved),
            (ranges.face_gap_from, ranges.face_gap_to),
            (ranges.clearance_from, ranges.clearance_to),
            ranges.map_points,
            tuple(_given(case)),
            (*about_grouped_digits(case), *_fields_not_read(case)),
            assumptions=(*case.assumptions, *mean_assumed(case.clearance, case.heel.diameter)),
        )
        for grooved, footstep in made.items()
    )


def _fields_not_read(case: FootstepCase) -> Iterator[Notice]:
    """Report limits of the clearance, and of what makes no difference to a smooth heel computed alone."""
    yield from not_read(case, "mean_footstep", *LIMITS)
    if case.variants == "smooth":
        yield from not_read(case, "smooth_heel", "groove", *(f"options.{one}" for one in OF_GROOVES))


def _given(case: FootstepCase) -> Iterator[tuple[str, str]]:
    """How the case put what it may put in several ways."""
    yield "Supply pressure", f"{1e-6 * case.supply.pressure:.6g} MPa, {case.pressures}"
    if case.groove is not None:
        misfit = case._groove().misfit(0.5 * case.heel.diameter)
        share = 1.0 / (math.sin(case.groove.angle) * math.pi * case.heel.diameter)
        width = case.groove.starts * (case.groove.groove_width + case.groove.land_width)
        yield (
            "Grooves and lands around the heel",
            f"{width * share:.4f} of the circumference ({100 * misfit:+.2f} %)",
        )
