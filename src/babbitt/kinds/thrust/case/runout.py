"""Runout of a collar face: one length, or a list of waves."""

from __future__ import annotations

import cmath
import math
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field

from babbitt.case.part import Issue, Part
from babbitt.case.parts.fields import WholeNumber
from babbitt.case.shorthand import Shorthand
from babbitt.core.units import si, written
from babbitt.kinds.thrust.runout import RunoutHarmonic

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

__all__ = ["RUNOUT", "Runout", "RunoutInput", "given_twice", "describe_runout", "waves_given_twice"]

RUNOUT = (
    "Runout of the collar face at the pivot radius: an amplitude, half the indicator reading, for a face with one "
    "high spot; or a list of waves, each with amplitude, lobes and phase. Empty: none."
)


class Runout(Part):
    """Runout or waviness of the collar face."""

    amplitude: Annotated[float, si("m", "0 um", "5 mm", "um")] = Field(
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


RunoutInput = Annotated[tuple[Runout, ...], _OneLength(_waves, "an amplitude such as '5 um', or a list of waves")]


def describe_runout(runouts: tuple[Runout, ...]) -> Iterator[tuple[str, str]]:
    """Say how a case gave its runout, also that it gave none."""
    if not runouts:
        yield "Runout of the collar", "none"
    for number, face in enumerate(runouts, start=1):
        waves = "" if face.lobes == 1 else f", {face.lobes} waves"
        yield "Runout of the collar", f"amplitude {written(face.amplitude, 'um').replace(' um', ' µm')}{waves}"
        yield f"Phase of the runout, wave {number}", written(face.phase, "deg").replace(" deg", "°")


def waves_given_twice(runouts: tuple[Runout, ...]) -> Iterator[Issue]:
    """Complain of two waves with the same number of lobes."""
    waves = [(float(one.lobes), cmath.rect(one.amplitude, one.phase)) for one in runouts]
    yield from given_twice("runout", "wave", "lobes", waves, "um")


def given_twice(
    field: str, what: str, of: str, parts: Sequence[tuple[float, complex]], unit: str
) -> Iterator[Issue]:
    """Complain of two entries that swing alike: they are one, the sum of both with their phases.

    Parameters
    ----------
    field : str
    what, of : str
        What an entry is, and what tells one from the other.
    parts : sequence of (float, complex)
        That number and the amplitude with its phase, in SI.
    unit : str
        In which amplitudes are given.
    """
    first: dict[float, int] = {}
    for place, (order, amplitude) in enumerate(parts):
        if order in first:
            together = parts[first[order]][1] + amplitude
            phase = math.degrees(cmath.phase(together)) if abs(together) > 0.0 else 0.0
            yield Issue(
                (field, place),
                f"a second {what} of {order:g} {of}",
                f"one {what} of each number of {of}" if of == "lobes" else f"one {what} of each order",
                f"write both as one, their sum with the phases given: amplitude {written(abs(together), unit)}, "
                f"phase {phase:.4g} deg",
            )
        else:
            first[order] = place
