"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.journal.case.journal import JournalBearing

Quantity: TypeAlias = str | SupportsFloat

class MethodOptions(OwnPart):
    method: ClassVar[str]

class Film(MethodOptions):
    method: ClassVar[str]
    def __init__(
        self,
        *,
        thermal: Literal["isothermal", "global", "adiabatic", "full"] | Enum | None = ...,
        walls: Mapping[str, Any] | Part | None = ...,
        axial_temperature: Literal["mean", "resolved"] | Enum | None = ...,
        carry_over: Quantity | None = ...,
        temperature_coefficients: Literal["frozen", "following"] | Enum | None = ...,
        cavitation: Literal["mass_conserving", "reynolds", "half_sommerfeld"] | Enum | None = ...,
        cavitation_pressure: Quantity | None = ...,
        film_start: Literal["groove", "widest_gap", "periodic"] | Enum | None = ...,
        turbulence: Literal["laminar", "ng_pan", "constantinescu"] | Enum | None = ...,
        pressure_viscosity: Mapping[str, Any] | Part | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        error_estimate: bool | None = ...,
        equilibria: Literal["auto", "all", "first"] | Enum | None = ...,
        tilt_coefficients: bool | None = ...,
    ) -> None: ...

class Iso7902(MethodOptions):
    method: ClassVar[str]
    def __init__(
        self,
        *,
        characteristics: Literal["computed", "closed_form"] | Enum | None = ...,
    ) -> None: ...

class LongFilm(MethodOptions):
    method: ClassVar[str]
    def __init__(
        self,
        *,
        heat_exchange: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class Segments(MethodOptions):
    method: ClassVar[str]
    def __init__(
        self,
        *,
        segments: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

METHODS: Mapping[str, type[MethodOptions]]
