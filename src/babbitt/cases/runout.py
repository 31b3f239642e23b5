"""Runout of a collar face: one length, or a list of waves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field

from babbitt.cases.fields import WholeNumber
from babbitt.cases.part import Part
from babbitt.cases.shorthand import Shorthand
from babbitt.thrust.runout import RunoutHarmonic
from babbitt.units import si, written

if TYPE_CHECKING:
    from collections.abc import Iterator

    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

__all__ = ["RUNOUT", "Runout", "RunoutGiven", "said_of_runout"]

RUNOUT = (
    "Runout of the collar face at the pivot radius: an amplitude, half the indicator reading, for a face with one "
    "high spot; or a list of waves, each with amplitude, lobes and phase. Empty: none."
)


class Runout(Part):
    """Runout or waviness of the collar face."""

    amplitude: Annotated[float, si("m", "0 um", "5 mm")] = Field(
        description="Amplitude at the pivot radius, A_R: half the indicator reading."
    )
    lobes: Annotated[int, WholeNumber(1, 50)] = Field(1, description="Waves around the face. 1 is runout.")
    phase: Annotated[float, si("rad", "-360 deg", "360 deg")] = Field(0.0, description="Phase.")

    def harmonic(self) -> RunoutHarmonic:
        """Give the wave of the calculation."""
        return RunoutHarmonic(float(self.lobes), self.amplitude, self.phase)


class _OneLength(Shorthand):
    """A length in place of the list: one wave with one high spot."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Tell editors that a length will do."""
        written = super().__get_pydantic_json_schema__(schema, handler)
        return {"anyOf": [*written["anyOf"][:1], {"type": "number"}, *written["anyOf"][1:]]}


def _waves(given: Any) -> Any:
    waves = given if isinstance(given, list | tuple) else [given]
    return [{"amplitude": one} if isinstance(one, str | int | float) else one for one in waves]


RunoutGiven = Annotated[tuple[Runout, ...], _OneLength(_waves, "an amplitude such as '5 um', or a list of waves")]


def said_of_runout(runouts: tuple[Runout, ...]) -> Iterator[tuple[str, str]]:
    """Tell how a case gave its runout, also that it gave none."""
    if not runouts:
        yield "Runout of the collar", "none"
    for face in runouts:
        waves = "" if face.lobes == 1 else f", {face.lobes} waves"
        yield "Runout of the collar", f"amplitude {written(face.amplitude, 'um').replace(' um', ' µm')}{waves}"
