"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.journal.case import methods

Quantity: TypeAlias = str | SupportsFloat

class Film(OwnPart, methods.FilmMethod):
    def __init__(
        self,
        *,
        thermal: Literal["isothermal", "global", "adiabatic", "full"] | Enum | None = ...,
        axial_temperature: Literal["mean", "resolved"] | Enum | None = ...,
        carry_over: Quantity | None = ...,
        temperature_coefficients: Literal["frozen", "following"] | Enum | None = ...,
        cavitation: Literal["mass_conserving", "reynolds", "half_sommerfeld"] | Enum | None = ...,
        film_start: Literal["groove", "widest_gap", "periodic"] | Enum | None = ...,
        turbulence: Literal["laminar", "ng_pan", "constantinescu"] | Enum | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        error_estimate: bool | None = ...,
        equilibria: Literal["auto", "all", "first"] | Enum | None = ...,
        limiting_speeds: bool | None = ...,
        tilt_coefficients: bool | None = ...,
        kind: Literal["film"] | Enum | None = ...,
    ) -> None: ...

class Iso7902(OwnPart, methods.Iso7902Method):
    def __init__(
        self,
        *,
        characteristics: Literal["computed", "closed_form"] | Enum | None = ...,
        kind: Literal["iso7902"] | Enum | None = ...,
    ) -> None: ...

class LongFilm(OwnPart, methods.LongFilmMethod):
    def __init__(
        self,
        *,
        nusselt: Quantity | Mapping[str, Any] | Part | None = ...,
        discretisation: Literal["consistent", "published_mean", "published_literal"] | Enum | None = ...,
        exchange_zone: Literal["liquid_fraction", "all_around", "film"] | Enum | None = ...,
        kind: Literal["long_film"] | Enum | None = ...,
    ) -> None: ...

class Segments(OwnPart, methods.SegmentsMethod):
    def __init__(
        self,
        *,
        kind: Literal["segments"] | Enum | None = ...,
    ) -> None: ...
