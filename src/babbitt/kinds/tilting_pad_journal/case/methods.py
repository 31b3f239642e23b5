"""The method of tilting-pad journal bearings and its choices: the mapping `method` of a case."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.method_choices import MethodChoices, MethodInput
from babbitt.case.method_mapping import MethodMapping
from babbitt.case.parts.turbulence import TurbulenceInput
from babbitt.core.units import si

__all__ = ["METHOD_MAPPING", "PadFilmChoices", "PadFilmMethod"]


class PadFilmChoices(MethodChoices):
    """Choices of the films of tilting pads."""

    thermal: Literal["isothermal", "global", "adiabatic", "full"] | None = Field(
        None,
        description="Temperature of the films: given (isothermal), one for all films from friction and fresh oil "
        "(global), or their own, with journal and pads that take no heat (adiabatic), or with a journal of one "
        "temperature and the walls given (full). global where supply.temperature alone is given, else isothermal.",
    )
    carry_over: Annotated[float, si("1", "0", "1")] | None = Field(
        None,
        description="Share of the hot oil leaving a pad over its trailing edge that enters the next one; the rest "
        "leaves.",
    )
    turbulence: TurbulenceInput = Field(
        "laminar",
        description="Turbulence of films of one temperature where the local Reynolds number exceeds "
        "41.3 sqrt(R/c) of the widest pad: none, whatever the Reynolds number, or flow factors by Ng and Pan or "
        "Constantinescu.",
    )
    deformation: tuple[Literal["growth", "bending"], ...] = Field(
        (),
        max_length=2,
        description="What heat and pressure deform: growth of pads, journal and housing, bending of the pads. "
        "Full films with walls.pads bend by heat and pressure; films of one temperature bend pads by pressure, at "
        "rest and in motion.",
    )
    pad_bending: Literal["beam", "plate"] = Field(
        "beam",
        description="Pads bend as beams, with the elastic modulus E, or as plates, with E/(1 - nu^2).",
    )
    assumption_sensitivity: bool = Field(
        False,
        description="Whether the bearing is solved with less and more of what is assumed of its heat, too: "
        "carry-over 0.2, heat transfer on the backs a third and three times, housing 10 K. Up to six more "
        "solutions.",
    )
    accuracy: Literal["draft", "engineering", "reference"] = Field(
        "engineering", description="How fine the grid of every pad is."
    )


class PadFilmMethod(PadFilmChoices, MethodInput):
    """The films of all pads in two dimensions."""

    kind: Literal["film"] = Field(description="The film in two dimensions.")


METHOD_MAPPING = MethodMapping((PadFilmMethod,))
