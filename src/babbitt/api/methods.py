"""Methods for journal bearings with their options, in place of a name and of fields of the bearing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from pydantic import Field, create_model

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.journal.case.journal import JournalBearing

__all__ = ["METHODS", "Film", "Iso7902", "LongFilm", "MethodOptions", "Segments"]

FILM_OPTIONS = (
    "thermal",
    "walls",
    "axial_temperature",
    "carry_over",
    "temperature_coefficients",
    "cavitation",
    "cavitation_pressure",
    "film_start",
    "turbulence",
    "pressure_viscosity",
    "accuracy",
    "error_estimate",
    "equilibria",
    "tilt_coefficients",
)
"""Fields of a journal bearing that are choices of the film method."""


def _options(name: str, fields: tuple[str, ...]) -> Any:
    """The part of a case that has some fields of a journal bearing only."""
    chosen: dict[str, Any] = {}
    for one in fields:
        known = JournalBearing.model_fields[one]
        chosen[one] = known.rebuild_annotation(), Field(known.default, description=known.description)
    return create_model(name, __base__=Part, __module__=__name__, __doc__="Options of a method.", **chosen)


_FilmOptions = _options("_FilmOptions", FILM_OPTIONS)
_Iso7902Options = _options("_Iso7902Options", ("characteristics",))
_LongFilmOptions = _options("_LongFilmOptions", ("heat_exchange",))
_SegmentsOptions = _options("_SegmentsOptions", ("segments",))


class MethodOptions(OwnPart):
    """A method and its options."""

    method: ClassVar[str]


class Film(MethodOptions, _FilmOptions):  # type: ignore[valid-type, misc]  # made of the fields of the bearing
    """The film in two dimensions."""

    method: ClassVar[str] = "film"


class Iso7902(MethodOptions, _Iso7902Options):  # type: ignore[valid-type, misc]  # made of the fields of the bearing
    """The procedure of ISO 7902."""

    method: ClassVar[str] = "iso7902"


class LongFilm(MethodOptions, _LongFilmOptions):  # type: ignore[valid-type, misc]  # made of the fields of the bearing
    """The long film with heat exchange."""

    method: ClassVar[str] = "long_film"


class Segments(MethodOptions, _SegmentsOptions):  # type: ignore[valid-type, misc]  # made of the fields of the bearing
    """The heat balance by segments of a grooved long bearing."""

    method: ClassVar[str] = "segments"


METHODS: Mapping[str, type[MethodOptions]] = {one.method: one for one in (Film, Iso7902, LongFilm, Segments)}
