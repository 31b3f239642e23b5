"""The methods of a journal bearing and their choices: the mapping `method` of a case."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from babbitt.case.method_choices import MethodChoices, MethodInput
from babbitt.case.method_mapping import MethodMapping
from babbitt.case.parts.turbulence import TurbulenceInput
from babbitt.kinds.journal.case.film_heat import (
    AxialTemperatureInput,
    CarryOverInput,
    CoefficientsInput,
    ThermalInput,
)
from babbitt.kinds.journal.case.heat_exchange import LongFilmChoices

__all__ = [
    "KNOWN_TO",
    "METHOD_MAPPING",
    "FilmChoices",
    "FilmMethod",
    "Iso7902Choices",
    "Iso7902Method",
    "LongFilmMethod",
    "SegmentsMethod",
]


class FilmChoices(MethodChoices):
    """Choices of the film in two dimensions."""

    thermal: ThermalInput | None = Field(
        None,
        description="Temperature of the film method: prescribed (isothermal), one for the whole film from the "
        "heat balance (global), or varying around the journal and across the gap, with walls that take no heat "
        "(adiabatic) or with bush, housing and journal that conduct (full). global if not given, isothermal with "
        "an effective_temperature.",
    )
    axial_temperature: AxialTemperatureInput = Field(
        "mean",
        description="Whether temperatures of an adiabatic or full film are means over the width, or resolved "
        "along it. Between pockets and holes they are always resolved.",
    )
    carry_over: CarryOverInput = Field(
        1.0,
        description="Hot oil carry-over of an adiabatic or full film: share, 0 to 1, of the oil that the film "
        "brings to a groove, pocket or hole and that goes on with the next film; fresh oil flushes out the rest. "
        "1 where the next film takes all of it that it can: the hottest.",
    )
    temperature_coefficients: CoefficientsInput = Field(
        "frozen",
        description="Whether the stiffness of an adiabatic or full film answers displacements at frozen "
        "temperatures, or with temperatures that follow.",
    )
    cavitation: Literal["mass_conserving", "reynolds", "half_sommerfeld"] = Field(
        "mass_conserving",
        description="What the film method does where the film breaks up: conserve the oil (JFO), or let "
        "pressure and "
        "its gradient vanish (Reynolds, as in most published tables), or count suctions of the full film as "
        "nothing (half-Sommerfeld, as in closed forms: a plain ring without feeding, no flows and no stiffness).",
    )
    film_start: Literal["groove", "widest_gap", "periodic"] | None = Field(
        None,
        description="Where the film method lets the film begin: at what feeds it, or at the widest gap of "
        "a full round "
        "bore (as the characteristics of the standard), or nowhere, for it closes around the journal (periodic). "
        "groove if not given; periodic with cavitation: half_sommerfeld.",
    )
    turbulence: TurbulenceInput = Field(
        "laminar",
        description="Turbulence of the film method where the local Reynolds number exceeds 41.3 sqrt(D/C): none, "
        "whatever the Reynolds number, or flow factors by Ng and Pan or Constantinescu.",
    )
    accuracy: Literal["draft", "engineering", "reference"] = Field(
        "engineering", description="How fine the grid of the film method is."
    )
    error_estimate: bool = Field(
        False,
        description="Solve the film on a finer grid, too, and say how far film thickness, position, stiffness and "
        "damping may be wrong by the grid. Film method.",
    )
    equilibria: Literal["auto", "all", "first"] = Field(
        "auto",
        description="Whether the film method looks for further equilibrium positions: always, never, "
        "or in lobed bores and between grooves whose pressure rivals that of the wedge.",
    )
    limiting_speeds: bool = Field(
        True,
        description="Whether the film method finds the speed of transition to mixed friction and the threshold "
        "speed of whirl, for each of which it solves about ten films.",
    )
    tilt_coefficients: bool = Field(
        False, description="Stiffness and damping against tilt of the journal, too, by the film method."
    )


class Iso7902Choices(MethodChoices):
    """Choices of the procedure of ISO 7902."""

    characteristics: Literal["computed", "closed_form"] = Field(
        "computed",
        description="Own solutions of the Reynolds equation, or the closed forms of DIN 31652 (360 deg).",
    )


class FilmMethod(FilmChoices, MethodInput):
    """The film in two dimensions."""

    kind: Literal["film"] = Field(description="The film in two dimensions.")


class Iso7902Method(Iso7902Choices, MethodInput):
    """The procedure of ISO 7902."""

    kind: Literal["iso7902"] = Field(description="The procedure of ISO 7902.")


class LongFilmMethod(LongFilmChoices, MethodInput):
    """The infinitely long film with heat exchange."""

    read_in: ClassVar[tuple[str, ...]] = ("heat_exchange",)

    kind: Literal["long_film"] = Field(description="The infinitely long film with heat exchange.")


class SegmentsMethod(MethodInput):
    """The heat balance by segments of an infinitely long film with a groove."""

    kind: Literal["segments"] = Field(description="The heat balance by segments.")


FILM = (
    "attitude_angle", "bore", "cavitation_pressure", "compliance", "crowning", "displacement", "dynamic_load",
    "grooves", "holes", "misalignment", "mixed_friction", "pockets", "position", "pressure_viscosity",
    "shaft_stiffness", "side_pressures", "steps", "walls",
)  # fmt: skip
FILM_OR_STANDARD = (
    "bearing_speed", "effective_temperature", "friction", "rotor_mass", "span", "supply_element",
)  # fmt: skip

KNOWN_TO = {
    **dict.fromkeys(FILM, ("film",)),
    **dict.fromkeys(FILM_OR_STANDARD, ("iso7902", "film")),
    "heat_exchange": ("long_film",),
    "segments": ("segments",),
}
"""Fields of a journal bearing that not every method reads, and the methods that do; others refuse them, or tell
that they do not read them."""

METHOD_MAPPING = MethodMapping((Iso7902Method, FilmMethod, LongFilmMethod, SegmentsMethod))
