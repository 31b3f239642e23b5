"""The methods of hydrostatic bearings and jacking pockets and their choices: the mapping `method` of a case."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from babbitt.case.method_choices import MethodChoices, MethodInput
from babbitt.case.method_mapping import MethodMapping

__all__ = ["METHOD_MAPPING", "FilmChoices", "HydrostaticFilmMethod", "QuickMethod"]


class FilmChoices(MethodChoices):
    """Choices of the film in two dimensions."""

    accuracy: Literal["draft", "engineering", "reference"] = Field(
        "engineering",
        description="Grid of the film. Under pads, rings and turning journals a full film of reference accuracy "
        "is solved on half the lines as well and extrapolated.",
    )


class HydrostaticFilmMethod(FilmChoices, MethodInput):
    """The film in two dimensions with the recess network."""

    kind: Literal["film"] = Field(description="The film in two dimensions.")


class QuickMethod(MethodInput):
    """Closed forms and lumped lands, or strips."""

    kind: Literal["quick"] = Field(description="Closed forms and lumped lands, or strips.")


METHOD_MAPPING = MethodMapping((HydrostaticFilmMethod, QuickMethod))
