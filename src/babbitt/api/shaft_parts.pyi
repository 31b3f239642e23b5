"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.shaft.case import bearings, parts

Quantity: TypeAlias = str | SupportsFloat

class Gear(OwnPart, parts.GearInput):
    def __init__(
        self,
        *,
        name: str | None = ...,
        station: Quantity | None = ...,
        role: Literal["driver", "driven"] | Enum | None = ...,
        torque: Quantity | None = ...,
        power: Quantity | None = ...,
        mass: Quantity | None = ...,
        pitch_diameter: Quantity | None = ...,
        teeth: SupportsIndex | None = ...,
        normal_module: Quantity | None = ...,
        pressure_angle: Quantity | None = ...,
        helix_angle: Quantity | None = ...,
        helix: Literal["right", "left", "double"] | Enum | None = ...,
        mesh_angle: Quantity | None = ...,
    ) -> None: ...

class Coupling(OwnPart, parts.CouplingInput):
    def __init__(
        self,
        *,
        name: str | None = ...,
        station: Quantity | None = ...,
        role: Literal["driver", "driven"] | Enum | None = ...,
        torque: Quantity | None = ...,
        power: Quantity | None = ...,
        mass: Quantity | None = ...,
    ) -> None: ...

class ShaftMass(OwnPart, parts.MassInput):
    def __init__(
        self,
        *,
        name: str | None = ...,
        station: Quantity | None = ...,
        mass: Quantity | None = ...,
    ) -> None: ...

class ShaftForce(OwnPart, parts.ForceInput):
    def __init__(
        self,
        *,
        name: str | None = ...,
        station: Quantity | None = ...,
        x: Quantity | None = ...,
        y: Quantity | None = ...,
        z: Quantity | None = ...,
        moment_x: Quantity | None = ...,
        moment_y: Quantity | None = ...,
    ) -> None: ...

class ShaftSupport(OwnPart, bearings.SupportInput):
    def __init__(
        self,
        *,
        station: Quantity | None = ...,
        stiffness: Quantity | None = ...,
        offset: Mapping[str, Any] | Part | None = ...,
        kind: Literal["radial", "axial", "radial_axial"] | Enum | None = ...,
        name: str | None = ...,
    ) -> None: ...
