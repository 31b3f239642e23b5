"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.footstep.case import footstep_parts

Quantity: TypeAlias = str | SupportsFloat

class Heel(OwnPart, footstep_parts.HeelInput):
    def __init__(
        self,
        *,
        length: Quantity | None = ...,
        diameter: Quantity | None = ...,
        recess_diameter: Quantity | None = ...,
        inner_diameter: Quantity | None = ...,
        recess_depth: Quantity | None = ...,
    ) -> None: ...

class FootstepGroove(OwnPart, footstep_parts.GroovePart):
    def __init__(
        self,
        *,
        angle: Quantity | None = ...,
        depth: Quantity | None = ...,
        groove_width: Quantity | None = ...,
        land_width: Quantity | None = ...,
        starts: SupportsIndex | None = ...,
        accept_misfit: bool | None = ...,
    ) -> None: ...

class FootstepOil(OwnPart, footstep_parts.FootstepOilInput):
    def __init__(
        self,
        *,
        viscosity: Quantity | None = ...,
        viscosity_exponent: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        density: Quantity | None = ...,
    ) -> None: ...

class FootstepWall(OwnPart, footstep_parts.WallPart):
    def __init__(
        self,
        *,
        temperature: Quantity | None = ...,
        conductance: Quantity | None = ...,
    ) -> None: ...

class FootstepOptions(OwnPart, footstep_parts.FootstepOptionsInput):
    def __init__(
        self,
        *,
        friction_viscosity: Literal["mean", "mixed"] | Enum | None = ...,
        face_outlet: Literal["consistent", "printed"] | Enum | None = ...,
        backflow_viscosity: Literal["inlet", "groove"] | Enum | None = ...,
        local_loss_coefficient: Quantity | None = ...,
        speed_reduction: Quantity | None = ...,
    ) -> None: ...

class FigureRanges(OwnPart, footstep_parts.FigureRanges):
    def __init__(
        self,
        *,
        face_gap_from: Quantity | None = ...,
        face_gap_to: Quantity | None = ...,
        clearance_from: Quantity | None = ...,
        clearance_to: Quantity | None = ...,
        map_points: SupportsIndex | None = ...,
    ) -> None: ...
