"""A shaft line on its thrust bearing as an engineer writes it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.case_file import CaseFile
from babbitt.case.part import Issue, Part, exactly_one, rule
from babbitt.case.parts.fields import Name, WholeNumber
from babbitt.case.parts.uniform_piece import UniformPiece, words_of_material
from babbitt.core.solution import Calculation
from babbitt.core.units import si
from babbitt.core.units import written as written_plainly
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.excitation import WITHOUT_WOBBLE, WOBBLE_LEFT_OUT, ThrustHarmonic
from babbitt.kinds.shaft_line.line import Rod, Seating, ShaftLine
from babbitt.kinds.shaft_line.methods import FREQUENCY_DOMAIN
from babbitt.kinds.thrust.case.runout import RUNOUT, RunoutInput, given_twice, waves_given_twice
from babbitt.kinds.thrust.case.thrust import Thrust, ThrustBearingInputs, written
from babbitt.kinds.thrust.case.thrust_pads import Damping, PartMass, Stiffness, ThrustLimits
from babbitt.kinds.thrust.design import PrescribedThrust

Weight = Annotated[float, si("kg", "0.1 kg", "10000 t")]
Phase = Annotated[float, si("rad", "-360 deg", "360 deg")]


class Propeller(Part):
    """The propeller."""

    mass: Weight = Field(description="Mass with entrained water, m_1.")
    damping: Damping = Field(0.0, description="Axial damping, b_0: slope of thrust against inflow speed.")
    blades: Annotated[int, WholeNumber(1, 20)] = Field(description="Number of blades.")


class ShaftPiece(UniformPiece):
    """A uniform piece of the shaft line."""

    end_mass: PartMass = Field(
        0.0,
        description="Point mass at the end towards the collar, such as a flange or a gear; not on the last piece.",
    )

    def rod(self) -> Rod:
        """Give the rod of the calculation."""
        area = 0.25 * math.pi * (self.diameter**2 - self.inner_diameter**2)
        return Rod(self.length, area, self.modulus, self.density)


class SeatingInput(Part):
    """What carries the housing of the thrust block."""

    stiffness: Stiffness = Field(description="Axial stiffness to the hull, k_f.")
    damping: Damping = Field(0.0, description="Damping, d_f.")
    housing_mass: PartMass = Field(0.0, description="Mass of the housing, m_h.")


class ThrustRipple(Part):
    """One harmonic of the thrust."""

    amplitude: Annotated[float, si("N", "0 N", "100 MN")] | None = Field(None, description="Amplitude, Q_m.")
    share: Annotated[float, si("1", "0", "2")] | None = Field(
        None, description="Amplitude over the thrust, in place of the amplitude."
    )
    blade_multiple: Annotated[int, WholeNumber(1, 20)] | None = Field(
        None, description="1 is blade frequency, 2 twice that. 1 unless an order is given."
    )
    order: Annotated[float, si("1", "0.01", "1000")] | None = Field(
        None, description="Frequency over that of the shaft, in place of blade_multiple: 1, or a gear ratio."
    )
    phase: Phase = Field(0.0, description="Phase, gamma.")

    @rule
    def _one_amplitude(self) -> Iterator[Issue]:
        yield from exactly_one(self, "amplitude", "share")

    @rule
    def _one_order(self) -> Iterator[Issue]:
        if self.blade_multiple is not None and self.order is not None:
            yield Issue(("order",), "given together with blade_multiple", "one of the two", "remove one")


class SpeedRange(Part):
    """Speeds at which the line is solved, with a Campbell map."""

    lowest: Annotated[float, si("rad/s", "0.01 rpm", "1000000 rpm")] = Field(description="Lowest speed.")
    highest: Annotated[float, si("rad/s", "0.01 rpm", "1000000 rpm")] = Field(description="Highest speed.")
    number: Annotated[int, WholeNumber(2, 200)] = Field(21, description="How many speeds.")

    @rule
    def _in_order(self) -> Iterator[Issue]:
        if self.highest <= self.lowest:
            yield Issue(
                ("highest",),
                f"{written_plainly(self.highest, 'rpm')} is not above {written_plainly(self.lowest, 'rpm')}",
                "more than lowest",
            )

    def speeds(self) -> tuple[float, ...]:
        """Give the speeds, rad/s."""
        step = (self.highest - self.lowest) / (self.number - 1)
        return tuple(self.lowest + step * k for k in range(self.number))


class LineLimits(ThrustLimits):
    """Limits in place of those by experience, and the admissible motion."""

    example: ClassVar[str] = "{axial_amplitude: 200 um}"

    axial_amplitude: Annotated[float, si("m", "0.1 um", "10 mm", "um")] | None = Field(
        None, description="Admissible amplitude of axial vibration along the shaft, half of peak to peak."
    )


class ThrustLineCase(ThrustBearingInputs, CaseFile):
    """A file with a shaft line: propeller, shaft, collar, thrust bearing, seating, and what shakes them."""

    kind: Literal["thrust_line"] = Field(description="Axial vibration of a shaft line on its thrust bearing.")
    name: Name = Field(description="Name of the line.")
    load: Thrust = Field(description="Steady thrust, F_0.")
    propeller: Propeller | None = Field(
        None, description="The propeller. None: the shaft ends free, as that of a feed pump."
    )
    shaft: tuple[ShaftPiece, ...] = Field(
        min_length=1, max_length=20, description="Pieces of the shaft from the propeller to the collar."
    )
    collar_mass: Weight = Field(description="Mass of the collar with all that is axially rigid to it, m_2.")
    seating: SeatingInput | None = Field(None, description="What carries the housing. None: rigid.")
    ripple: tuple[ThrustRipple, ...] = Field(
        (), max_length=20, description="Harmonics of the thrust. Empty: none."
    )
    runout: RunoutInput = Field((), max_length=20, description=RUNOUT)
    loss_limit: Annotated[float, si("1", "0.01", "5")] | None = Field(
        None, description="Limit of dynamic over mean static pad load. None: 50 %, usual in industry."
    )
    limits: LineLimits | None = Field(None, description="Limits of your own in addition to loss_limit.")
    speeds: SpeedRange | None = Field(None, description="Speeds of a Campbell map. None: no map.")
    nonlinear: bool = Field(
        False, description="Solve the nonlinear motion, too: takes seconds, and needs plane laminar pads."
    )

    @rule
    def _seating_on_a_ring(self) -> Iterator[Issue]:
        if self.seating is not None and self.ring_stiffness is None:
            yield Issue(
                ("seating",),
                "a seating needs a ring of finite stiffness between pads and housing",
                "ring_stiffness with it, such as '1000 GN/m' for a stiff ring",
            )

    @rule
    def _blades_of_a_propeller(self) -> Iterator[Issue]:
        for place, one in enumerate(self.ripple):
            if self.propeller is None and one.order is None:
                yield Issue(
                    ("ripple", place, "order"),
                    "without a propeller there is no blade frequency",
                    "order: the frequency over that of the shaft, such as the number of vanes",
                    "or give the propeller",
                )

    @rule
    def _every_harmonic_once(self) -> Iterator[Issue]:
        yield from waves_given_twice(self.runout)
        harmonics = [self._thrust_harmonic(one) for one in self.ripple]
        parts = [(one.order, cmath.rect(one.amplitude, one.phase)) for one in harmonics]
        yield from given_twice("ripple", "harmonic", "times the shaft frequency", parts, "kN")

    @rule
    def _nothing_behind_the_last_piece(self) -> Iterator[Issue]:
        if self.shaft[-1].end_mass:
            yield Issue(
                ("shaft", len(self.shaft) - 1, "end_mass"),
                "the collar follows the last piece",
                "no end_mass here; add it to collar_mass",
            )

    @rule
    def _similar_films_for_the_nonlinear_motion(self) -> Iterator[Issue]:
        own = self.pads.face is not None or self.pads.crown_at_work() or self.turbulence != "none"
        if self.nonlinear and (own or self.thermal == "adiabatic"):
            yield Issue(
                ("nonlinear",),
                "the nonlinear motion is for plane laminar pads of one viscosity, whose films are similar",
                "false, or pads without face, crown, turbulence and thermal: adiabatic",
            )

    @rule
    def _held_tilts_feel_a_face_that_leans(self) -> Iterator[Issue]:
        leans = any(one.lobes == 1 and one.amplitude > 0.0 for one in self.runout)
        if self.nonlinear and leans and self.pads.pivot.kind == "line":
            yield Issue(
                ("nonlinear",),
                WOBBLE_LEFT_OUT,
                f"false, or {WITHOUT_WOBBLE}",
            )

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the one calculation of the file."""
        return (Calculation(self.line_design(), FREQUENCY_DOMAIN),)

    def line_design(self) -> LineDesign:
        """Give the line of the calculation."""
        line = ShaftLine(
            0.0 if self.propeller is None else self.propeller.mass,
            0.0 if self.propeller is None else self.propeller.damping,
            tuple(piece.rod() for piece in self.shaft),
            self.collar_mass,
            tuple(piece.end_mass for piece in self.shaft[:-1]),
            None
            if self.seating is None
            else Seating(self.seating.stiffness, self.seating.damping, self.seating.housing_mass),
        )
        given = self.design(self.name, PrescribedThrust(self.load), self.runout)
        from dataclasses import replace

        return LineDesign(
            replace(given, given=(*given.given, *_words(self))),
            line,
            tuple(self._thrust_harmonic(one) for one in self.ripple),
            given.runouts,
            0.5 if self.loss_limit is None else self.loss_limit,
            "assumption: 50 % of the static load, said to be usual in industry"
            if self.loss_limit is None
            else "given in the case",
            None if self.limits is None else self.limits.axial_amplitude,
            () if self.speeds is None else self.speeds.speeds(),
            self.nonlinear,
        )

    def _thrust_harmonic(self, one: ThrustRipple) -> ThrustHarmonic:
        blades = 1 if self.propeller is None else self.propeller.blades
        order = one.order if one.order is not None else float(blades * (one.blade_multiple or 1))
        amplitude = one.amplitude if one.amplitude is not None else (one.share or 0.0) * self.load
        return ThrustHarmonic(order, amplitude, one.phase)


def _words(case: ThrustLineCase) -> Iterator[tuple[str, str]]:
    propeller = case.propeller
    yield (
        "Propeller",
        "none, the shaft ends free"
        if propeller is None
        else f"{written(propeller.mass, 't')} with entrained water, {propeller.blades} blades",
    )
    if propeller is not None:
        yield "Damping of the propeller", written(propeller.damping, "kN s/m")
    for place, piece in enumerate(case.shaft, start=1):
        bore = f", bore {written(piece.inner_diameter, 'mm')}" if piece.inner_diameter else ""
        mass = f", then {written(piece.end_mass, 'kg')}" if piece.end_mass else ""
        yield (
            f"Shaft, piece {place}",
            f"{written(piece.length, 'm')}, diameter {written(piece.diameter, 'mm')}{bore}{mass}",
        )
    yield from words_of_material(case.shaft)
    yield "Collar and what is rigid to it", written(case.collar_mass, "t")
    if case.seating is None:
        yield "Seating", "rigid"
    else:
        yield "Seating", written(case.seating.stiffness, "GN/m")
        yield "Mass of the housing", written(case.seating.housing_mass, "t")
        yield "Damping of the seating", written(case.seating.damping, "kN s/m")
    if not case.pads.mass:
        yield "Mass of a pad", "none"
    if not (case.pads.inertia_radial or case.pads.inertia_along):
        yield "Inertias of a pad", "none"
    if not case.ripple:
        yield "Thrust ripple", "none"
    for number, one in enumerate(case.ripple, start=1):
        harmonic = case._thrust_harmonic(one)
        yield (
            "Thrust ripple",
            f"{written(harmonic.amplitude, 'kN')} at {harmonic.order:g} times the shaft frequency",
        )
        yield f"Phase of the thrust ripple, harmonic {number}", written(harmonic.phase, "deg")
