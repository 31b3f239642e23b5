"""A thrust bearing as an engineer writes it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.aliases import FormerWords
from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.method_choices import MethodChoices, MethodInput
from babbitt.case.method_mapping import MethodMapping
from babbitt.case.part import Issue, exactly_one, not_read, rule
from babbitt.case.parts.fields import Name, Prose
from babbitt.case.parts.lubricant import LUBRICANT, LubricantInput
from babbitt.case.parts.supply import SuppliedAt
from babbitt.core.notices import InputError, Notice
from babbitt.core.solution import Calculation
from babbitt.core.units import either_sense, si
from babbitt.core.units import written as written_plainly
from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.case.runout import RUNOUT, Runout, RunoutInput, describe_runout, waves_given_twice
from babbitt.kinds.thrust.case.thrust_oil import OilByBalance, PrescribedViscosity, ThrustOil, issues_of
from babbitt.kinds.thrust.case.thrust_pads import (
    PadMaterials,
    Stiffness,
    ThrustLimits,
    ThrustPads,
    Tilt,
    TiltingPivot,
)
from babbitt.kinds.thrust.design import (
    USUAL_FILM_LIMIT,
    USUAL_FILM_SOURCE,
    PrescribedFilm,
    PrescribedThrust,
    ThrustDesign,
)
from babbitt.kinds.thrust.methods import THRUST_FILM
from babbitt.kinds.thrust.pad import Pivot, ThrustPad
from babbitt.kinds.thrust.state import TiltInertia
from babbitt.kinds.thrust.temperature_limits import TemperatureLimits
from babbitt.kinds.thrust.thermal_crown import ASSUMED_DIFFERENCE
from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN, FilmTurbulence, TurbulenceLaw

Thrust = Annotated[float, si("N", "1 N", "1000 MN")]
LAWS: dict[str, TurbulenceLaw] = {"ng_pan": NG_PAN, "constantinescu": CONSTANTINESCU}
TURBULENT_BETWEEN = (500.0, 1000.0)
"""Local Reynolds numbers between which turbulence sets in: the usual choice with Ng and Pan's theory."""
INERTIAS = ("pads.inertia_radial", "pads.inertia_along")


class ThrustFilmChoices(MethodChoices):
    """Choices of the film of thrust pads."""

    thermal: Literal["isothermal", "global", "adiabatic"] | None = Field(
        None,
        description="Temperature of the films: one that is given (isothermal, with oil of kind viscosity or "
        "temperature), one per pad from its own heat balance (global), or one that varies along the pads and "
        "across "
        "the gap with no heat to pads and collar (adiabatic), the two with oil of kind heat_balance. None: global "
        "where the oil is of that kind, else isothermal.",
    )
    radial_temperature: Literal["mean", "resolved"] = Field(
        "mean", description="Whether the temperature of an adiabatic film varies across the pads, too."
    )
    turbulence: Literal["none", "ng_pan", "constantinescu"] = Field("none", description="Turbulence of the films.")


class ThrustFilmMethod(ThrustFilmChoices, MethodInput):
    """The film in two dimensions on every pad."""

    kind: Literal["film"] = Field(description="The film in two dimensions.")


class ThrustBearingInputs(ThrustFilmChoices):
    """What bearing and oil of a thrust bearing are, alone or in a shaft line."""

    former_words: ClassVar[FormerWords] = {
        "thrust": "load",
        "oil.lubricant": "lubricant",
        "oil.supply_temperature": "supply.temperature",
        "film_limit": "limits.minimum_film_thickness",
        "temperature_limit": "limits.temperature",
    }

    method: Annotated[Literal["film"], MethodMapping((ThrustFilmMethod,))] = Field(
        "film", description="The film in two dimensions on every pad."
    )
    pads: ThrustPads = Field(description="The pads.")
    speed: Annotated[float, either_sense("rad/s", "0.01 rpm", "1000000 rpm")] = Field(
        description="Speed of the collar, positive counter-clockwise, towards growing pad numbers. Negative: "
        "the pads "
        "run backward."
    )
    lubricant: LubricantInput | None = Field(
        None, description=f"{LUBRICANT} Needed unless the viscosity of the films is given."
    )
    supply: SuppliedAt | None = Field(None, description="Fresh oil; needed with oil of kind heat_balance.")
    oil: ThrustOil = Field(
        default_factory=lambda: OilByBalance(kind="heat_balance"),
        description="How viscous the films are. By their heat balance if not given.",
    )
    ring_stiffness: Stiffness | None = Field(
        None, description="Stiffness of the backing ring under each pad, c. None: rigid."
    )
    tilt: Tilt | None = Field(None, description="Tilt of the housing against the collar.")
    materials: PadMaterials | None = Field(None, description="Materials of the pads.")
    limits: ThrustLimits | None = Field(None, description="Limits of your own.")
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @rule
    def _balanced_pivot(self) -> Iterator[Issue]:
        pivot = self.pads.pivot
        if isinstance(pivot, TiltingPivot) and self.pads.face is None and self.pads.crown_at_work() == 0.0:
            fraction = pivot.fraction if self.speed > 0.0 else 1.0 - pivot.fraction
            if fraction <= 0.5:
                yield Issue(
                    ("pads", "pivot", "fraction"),
                    f"at this sense of rotation the pivot lies at "
                    f"{fraction:g} of the pad from its leading edge, where no plane pad balances",
                    "more than 0.5, behind the middle",
                    "give a crown, or turn the other way; at 0.5 without any crown heat is taken to give one",
                )
                return
            yield from self._balance_of_plane_pads()

    def _balance_of_plane_pads(self) -> Iterator[Issue]:
        """Seek the balance of plane laminar pads, which any film, oil and speed share."""
        from babbitt.kinds.thrust.pivot import pivot_fault  # numba is imported when the first film is solved

        try:
            pad = self._pad()
        except InputError:
            return  # reported for the radii and angles themselves
        fault = pivot_fault(replace(pad, turbulence=None))
        if fault is None:
            return
        sense = self.speed > 0.0
        low, high = (
            (fault.low, fault.high) if sense or fault.field == "radius" else (1 - fault.high, 1 - fault.low)
        )
        if fault.field == "radius":
            given, unit = written(pad.pivot_radius, "mm"), "mm"
            allowed = f"about {written(low, unit)} to {written(high, unit)}, the fraction unchanged"
        else:
            given = f"{pad.pivot_fraction if sense else 1.0 - pad.pivot_fraction:g}"
            allowed = f"about {low:.3f} to {high:.3f}, the radius unchanged"
        yield Issue(
            ("pads", "pivot", fault.field),
            f"with the pivot at {given} no tilt balances these plane pads",
            allowed if fault.high > 0.0 else "another radius and fraction; the mean radius and 0.6 are usual",
            code="E202",
        )

    @rule
    def _fixed_pads_run_one_way(self) -> Iterator[Issue]:
        pads = self.pads
        faced = pads.face is not None and pads.crown == 0.0 and not isinstance(pads.pivot, TiltingPivot)
        if pads.face is not None and faced and self.speed < 0.0:
            yield Issue(
                ("speed",),
                f"backward, the {pads.face.kind} of fixed pads lies behind the land, where the film diverges and "
                "carries nothing",
                "a positive speed",
                "turn the other way, or give the pads a crown",
            )

    @rule
    def _oil_is_known(self) -> Iterator[Issue]:
        yield from issues_of(self.oil, self.lubricant, None if self.supply is None else self.supply.temperature)

    @rule
    def _thermal_goes_with_the_oil(self) -> Iterator[Issue]:
        balance = isinstance(self.oil, OilByBalance)
        if self.thermal in ("global", "adiabatic") and not balance:
            says = f"thermal: {self.thermal} finds the temperature from friction and fresh oil"
            yield Issue(("oil", "kind"), says, "heat_balance, with lubricant and supply.temperature")
        if self.thermal == "isothermal" and balance:
            says = "an isothermal film needs its viscosity or temperature, oil of kind heat_balance finds it"
            yield Issue(("oil", "kind"), says, "viscosity or temperature, or thermal: global")
        if self.thermal == "adiabatic" and self.turbulence != "none":
            yield Issue(
                ("turbulence",), "a film with its own temperatures is laminar", "thermal: global, or no turbulence"
            )
        if self.thermal != "adiabatic" and self.radial_temperature == "resolved":
            says = "the films have one temperature"
            yield Issue(("radial_temperature",), says, "mean, or thermal: adiabatic")

    def _pad(self) -> ThrustPad:
        """Give the laminar pad of the calculation, seen by a collar that turns forward."""
        pads, pivot = self.pads, self.pads.pivot
        tilting = pivot if isinstance(pivot, TiltingPivot) else None
        radii = pads.radii()
        pad = ThrustPad(
            *radii,
            pads.extent,
            tilting.radius if tilting else 0.5 * sum(radii),
            tilting.fraction if tilting else 0.5,
            Pivot(tilting.kind) if tilting else Pivot.FIXED,
            pads.plane_or_face(),
            pads.crown_at_work(),
        )
        return pad if self.speed > 0.0 else pad.mirrored()

    def design(
        self, name: str, duty: PrescribedThrust | PrescribedFilm, runouts: tuple[Runout, ...]
    ) -> ThrustDesign:
        """Give the bearing of the calculation."""
        pads = self.pads
        law = LAWS.get(self.turbulence)
        oil = self.oil.oil(self.lubricant, None if self.supply is None else self.supply.temperature)
        limits = self.limits or ThrustLimits()
        if self.thermal == "adiabatic":
            oil = replace(oil, own_temperatures=True, resolved=self.radial_temperature == "resolved")
        turbulence = None
        if law is not None:
            at = oil.effective_temperature or oil.supply_temperature or 323.15
            turbulence = FilmTurbulence(law, float(oil.lubricant.density(at)), *TURBULENT_BETWEEN)
        pad = replace(self._pad(), turbulence=turbulence)
        sense = math.copysign(1.0, self.speed)
        bearing = ThrustBearing(
            pad,
            pads.number,
            math.inf if self.ring_stiffness is None else self.ring_stiffness,
            pads.mass,
            TiltInertia(pads.inertia_radial, pads.inertia_along),
            HousingTilt() if self.tilt is None else self.tilt.tilt(),
            pads.heights,
            sense,
        )
        return ThrustDesign(
            name,
            bearing,
            duty,
            abs(self.speed),
            oil,
            tuple(one.harmonic() for one in runouts),
            USUAL_FILM_LIMIT if limits.minimum_film_thickness is None else limits.minimum_film_thickness,
            USUAL_FILM_SOURCE if limits.minimum_film_thickness is None else "given in the case",
            TemperatureLimits(limits.temperature, None if self.materials is None else self.materials.metal()),
            law,
            (*words_of(self), *describe_runout(runouts)),
            self.assumptions,
            (*about_grouped_digits(self), *self._fields_not_read(), *self._assumed_crown()),
        )

    def _fields_not_read(self) -> Iterator[Notice]:
        """Report fields that make no difference to this bearing."""
        pivot = self.pads.pivot
        if not isinstance(pivot, TiltingPivot):
            yield from not_read(self, "fixed_pads", *INERTIAS)
        elif pivot.kind == "line":
            yield from not_read(self, "line_pivot", INERTIAS[0])
        if isinstance(self.oil, PrescribedViscosity):
            yield from not_read(self, "no_temperature", "limits.temperature")
            yield from not_read(self, "films_given", "lubricant", "supply.temperature")

    def _assumed_crown(self) -> Iterator[Notice]:
        """Report the crown that plane pads on a pivot in their middle are taken to have."""
        if self.pads.crowned_by_heat:
            yield Notice("W214", values={"crown": self.pads.crown_at_work(), "difference": ASSUMED_DIFFERENCE})


class ThrustCase(ThrustBearingInputs, CaseFile):
    """A file with one thrust bearing."""

    kind: Literal["thrust"] = Field(description="One thrust bearing.")
    name: Name = Field(description="Name of the bearing.")
    load: Thrust | None = Field(None, description="Thrust F_0, in place of the film.")
    film: Annotated[float, si("m", "0.1 um", "5 mm", "um")] | None = Field(
        None, description="Mean film at the pivots, in place of the load, which is then found."
    )
    runout: RunoutInput = Field((), max_length=20, description=RUNOUT)

    @rule
    def _load_or_film(self) -> Iterator[Issue]:
        yield from exactly_one(self, "load", "film")

    @rule
    def _every_wave_once(self) -> Iterator[Issue]:
        yield from waves_given_twice(self.runout)

    def _fields_not_read(self) -> Iterator[Notice]:
        """As of every thrust bearing; a mass swings in a shaft line alone."""
        yield from not_read(self, "steady_thrust", "pads.mass")
        yield from super()._fields_not_read()

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the one calculation of the file."""
        return (Calculation(self.thrust_design(), THRUST_FILM),)

    def thrust_design(self) -> ThrustDesign:
        """Give the bearing of the calculation."""
        duty = PrescribedFilm(self.film) if self.film is not None else PrescribedThrust(self.load or 0.0)
        return self.design(self.name, duty, self.runout)


def written(value: float, unit: str) -> str:
    """Write an SI value in an everyday unit, as it looks on paper."""
    return written_plainly(value, unit).replace(" um", " µm").replace(" deg", "°")


def words_of(case: ThrustBearingInputs) -> Iterator[tuple[str, str]]:
    """Say how a case gave its numbers."""
    pads, pivot = case.pads, case.pads.pivot
    inner, outer = pads.radii()
    yield (
        "Pads",
        (
            f"{pads.number} of {written(pads.extent, 'deg')}, radii {written(inner, 'mm')} to "
            f"{written(outer, 'mm')}"
        ),
    )
    if isinstance(pivot, TiltingPivot):
        yield (
            "Pivot",
            f"{pivot.kind} at radius {written(pivot.radius, 'mm')}, {pivot.fraction:g} of the pad from its "
            f"leading edge",
        )
    else:
        yield "Pivot", "none, fixed pads"
    if pads.face is not None:
        yield (
            "Face",
            f"{pads.face.kind} {written(pads.face.depth, 'um')} deep over {pads.face.fraction:g} of the pad",
        )
    if pads.crown:
        yield "Crown", written(pads.crown, "um")
    elif pads.crowned_by_heat:
        yield "Crown", f"{written(pads.crown_at_work(), 'um')}, an assumption"
    if pads.mass:
        yield "Mass of a pad", written(pads.mass, "kg")
    if pads.inertia_radial or pads.inertia_along:
        yield "Inertias of a pad", f"{pads.inertia_radial:g} and {pads.inertia_along:g} kg m²"
    if pads.heights:
        yield "Heights of the pads", ", ".join(f"{1e6 * height:g}" for height in pads.heights) + " µm"
    yield "Speed", written(case.speed, "rpm")
    ring = case.ring_stiffness
    yield "Backing ring", "rigid" if ring is None else f"{written(ring, 'GN/m')} per pad"
    if case.tilt is not None:
        yield (
            "Tilt of the housing",
            (
                f"{written(case.tilt.offset, 'um')} at the outer radius, closest at "
                f"{math.degrees(case.tilt.direction):g}°"
            ),
        )
    if case.turbulence != "none":
        yield "Turbulence", LAWS[case.turbulence].name
