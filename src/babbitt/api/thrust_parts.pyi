"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.shaft_line.case import shaft_line
from babbitt.kinds.thrust.case import runout, thrust_oil, thrust_pads

Quantity: TypeAlias = str | SupportsFloat

class TiltingPivot(OwnPart, thrust_pads.TiltingPivot):
    def __init__(
        self,
        *,
        kind: Literal["point", "line"] | Enum | None = ...,
        radius: Quantity | None = ...,
        fraction: Quantity | None = ...,
    ) -> None: ...

class FixedPad(OwnPart, thrust_pads.FixedPad):
    def __init__(
        self,
        *,
        kind: Literal["fixed"] | Enum | None = ...,
    ) -> None: ...

class Taper(OwnPart, thrust_pads.TaperFace):
    def __init__(
        self,
        *,
        kind: Literal["taper"] | Enum | None = ...,
        depth: Quantity | None = ...,
        fraction: Quantity | None = ...,
    ) -> None: ...

class StepFace(OwnPart, thrust_pads.StepFace):
    def __init__(
        self,
        *,
        kind: Literal["step"] | Enum | None = ...,
        depth: Quantity | None = ...,
        fraction: Quantity | None = ...,
    ) -> None: ...

class Pads(OwnPart, thrust_pads.ThrustPads):
    def __init__(
        self,
        *,
        number: SupportsIndex | None = ...,
        inner_diameter: Quantity | None = ...,
        outer_diameter: Quantity | None = ...,
        extent: Quantity | None = ...,
        pivot: Mapping[str, Any] | Part | None = ...,
        face: Mapping[str, Any] | Part | None = ...,
        crown: Quantity | None = ...,
        mass: Quantity | None = ...,
        inertia_radial: Quantity | None = ...,
        inertia_along: Quantity | None = ...,
        heights: Iterable[Quantity] | None = ...,
    ) -> None: ...

class PadMaterials(OwnPart, thrust_pads.PadMaterials):
    def __init__(
        self,
        *,
        bearing_metal: Quantity | Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class Tilt(OwnPart, thrust_pads.Tilt):
    def __init__(
        self,
        *,
        offset: Quantity | None = ...,
        direction: Quantity | None = ...,
    ) -> None: ...

class FilmViscosity(OwnPart, thrust_oil.PrescribedViscosity):
    def __init__(
        self,
        *,
        kind: Literal["viscosity"] | Enum | None = ...,
        viscosity: Quantity | None = ...,
        density: Quantity | None = ...,
    ) -> None: ...

class FilmTemperature(OwnPart, thrust_oil.OilAtTemperature):
    def __init__(
        self,
        *,
        kind: Literal["temperature"] | Enum | None = ...,
        temperature: Quantity | None = ...,
    ) -> None: ...

class FilmHeatBalance(OwnPart, thrust_oil.OilByBalance):
    def __init__(
        self,
        *,
        kind: Literal["heat_balance"] | Enum | None = ...,
        carry_over: Quantity | None = ...,
    ) -> None: ...

class Runout(OwnPart, runout.Runout):
    def __init__(
        self,
        *,
        amplitude: Quantity | None = ...,
        lobes: SupportsIndex | None = ...,
        phase: Quantity | None = ...,
    ) -> None: ...

class Propeller(OwnPart, shaft_line.Propeller):
    def __init__(
        self,
        *,
        mass: Quantity | None = ...,
        damping: Quantity | None = ...,
        blades: SupportsIndex | None = ...,
    ) -> None: ...

class ShaftPiece(OwnPart, shaft_line.ShaftPiece):
    def __init__(
        self,
        *,
        length: Quantity | None = ...,
        diameter: Quantity | None = ...,
        inner_diameter: Quantity | None = ...,
        modulus: Quantity | None = ...,
        density: Quantity | None = ...,
        end_mass: Quantity | None = ...,
    ) -> None: ...

class Seating(OwnPart, shaft_line.SeatingInput):
    def __init__(
        self,
        *,
        stiffness: Quantity | None = ...,
        damping: Quantity | None = ...,
        housing_mass: Quantity | None = ...,
    ) -> None: ...

class ThrustRipple(OwnPart, shaft_line.ThrustRipple):
    def __init__(
        self,
        *,
        amplitude: Quantity | None = ...,
        share: Quantity | None = ...,
        blade_multiple: SupportsIndex | None = ...,
        order: Quantity | None = ...,
        phase: Quantity | None = ...,
    ) -> None: ...

class SpeedRange(OwnPart, shaft_line.SpeedRange):
    def __init__(
        self,
        *,
        lowest: Quantity | None = ...,
        highest: Quantity | None = ...,
        number: SupportsIndex | None = ...,
    ) -> None: ...

class LineLimits(OwnPart, shaft_line.LineLimits):
    def __init__(
        self,
        *,
        minimum_film_thickness: Quantity | None = ...,
        temperature: Quantity | None = ...,
        axial_amplitude: Quantity | None = ...,
    ) -> None: ...
