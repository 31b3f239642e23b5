"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.hydrostatic.case import pad_shapes, recess_parts, restrictors, supply

Quantity: TypeAlias = str | SupportsFloat

class Capillary(OwnPart, restrictors.CapillaryInput):
    def __init__(
        self,
        *,
        check_valve: bool | None = ...,
        kind: Literal["capillary"] | Enum | None = ...,
        diameter: Quantity | None = ...,
        length: Quantity | None = ...,
        tubes: SupportsIndex | None = ...,
        entry_loss: Quantity | None = ...,
        viscosity: Quantity | None = ...,
    ) -> None: ...

class Orifice(OwnPart, restrictors.OrificeInput):
    def __init__(
        self,
        *,
        check_valve: bool | None = ...,
        kind: Literal["orifice"] | Enum | None = ...,
        diameter: Quantity | None = ...,
        discharge: Quantity | None = ...,
    ) -> None: ...

class Slot(OwnPart, restrictors.SlotInput):
    def __init__(
        self,
        *,
        check_valve: bool | None = ...,
        kind: Literal["slot"] | Enum | None = ...,
        width: Quantity | None = ...,
        gap: Quantity | None = ...,
        length: Quantity | None = ...,
        viscosity: Quantity | None = ...,
    ) -> None: ...

class ConstantFlow(OwnPart, restrictors.ConstantFlowInput):
    def __init__(
        self,
        *,
        kind: Literal["constant_flow"] | Enum | None = ...,
        flow: Quantity | None = ...,
        leakage: Quantity | None = ...,
    ) -> None: ...

class MeteredFlow(OwnPart, restrictors.MeteredFlowInput):
    def __init__(
        self,
        *,
        kind: Literal["metered_flow"] | Enum | None = ...,
        flow: Quantity | None = ...,
    ) -> None: ...

class FlowValve(OwnPart, restrictors.FlowValveInput):
    def __init__(
        self,
        *,
        kind: Literal["flow_valve"] | Enum | None = ...,
        flow: Quantity | None = ...,
        gain: Quantity | None = ...,
        open_conductance: Quantity | None = ...,
    ) -> None: ...

class MembraneValve(OwnPart, restrictors.MembraneValveInput):
    def __init__(
        self,
        *,
        kind: Literal["membrane_valve"] | Enum | None = ...,
        conductance: Quantity | None = ...,
        compliance: Quantity | None = ...,
    ) -> None: ...

class HydrostaticSupply(OwnPart, supply.HydrostaticSupply):
    def __init__(
        self,
        *,
        temperature: Quantity | None = ...,
        pressure: Quantity | None = ...,
        pump_flow: Quantity | None = ...,
        leakage: Quantity | None = ...,
        relief_pressure: Quantity | None = ...,
        highest_pressure: Quantity | None = ...,
        pump_efficiency: Quantity | None = ...,
        manifold_volume: Quantity | None = ...,
    ) -> None: ...

class HydrostaticOil(OwnPart, recess_parts.HydrostaticOil):
    def __init__(
        self,
        *,
        viscosity: Quantity | None = ...,
        density: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
    ) -> None: ...

class RecessOil(OwnPart, recess_parts.RecessOil):
    def __init__(
        self,
        *,
        depth: Quantity | None = ...,
        line_volume: Quantity | None = ...,
        bulk_modulus: Quantity | None = ...,
        friction_factor: Quantity | None = ...,
    ) -> None: ...

class RecessRow(OwnPart, recess_parts.RecessRow):
    def __init__(
        self,
        *,
        number: SupportsIndex | None = ...,
        extent: Quantity | None = ...,
        first: Quantity | None = ...,
        angles: Iterable[Quantity] | None = ...,
        drain_groove: Quantity | None = ...,
    ) -> None: ...

class CircularPad(OwnPart, pad_shapes.CircularInput):
    def __init__(
        self,
        *,
        kind: Literal["circular"] | Enum | None = ...,
        diameter: Quantity | None = ...,
        recess_diameter: Quantity | None = ...,
    ) -> None: ...

class AnnularPad(OwnPart, pad_shapes.AnnularInput):
    def __init__(
        self,
        *,
        kind: Literal["annular"] | Enum | None = ...,
        inner_diameter: Quantity | None = ...,
        recess_inner_diameter: Quantity | None = ...,
        recess_outer_diameter: Quantity | None = ...,
        outer_diameter: Quantity | None = ...,
    ) -> None: ...

class RectangularPad(OwnPart, pad_shapes.RectangularInput):
    def __init__(
        self,
        *,
        kind: Literal["rectangular"] | Enum | None = ...,
        length: Quantity | None = ...,
        width: Quantity | None = ...,
        recess_length: Quantity | None = ...,
        recess_width: Quantity | None = ...,
    ) -> None: ...
