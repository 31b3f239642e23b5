"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.kinds.tilting_pad_journal.case import bearing, heat, materials, pads, pedestal, pivots

Quantity: TypeAlias = str | SupportsFloat

class JournalPads(OwnPart, pads.JournalPads):
    def __init__(
        self,
        *,
        number: SupportsIndex | None = ...,
        pivot_angles: Iterable[Quantity] | None = ...,
        first_pivot: Quantity | None = ...,
        extent: Quantity | None = ...,
        width: Quantity | None = ...,
        thickness: Quantity | None = ...,
        clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        preload: Quantity | None = ...,
        assembled_clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        pivot: Mapping[str, Any] | Part | None = ...,
        mass: Quantity | None = ...,
        inertia: Quantity | None = ...,
        mass_offset: Quantity | None = ...,
        mass_inset: Quantity | None = ...,
        probe_fraction: Quantity | None = ...,
        each: Iterable[Any] | None = ...,
    ) -> None: ...

class OnePad(OwnPart, pads.OnePad):
    def __init__(
        self,
        *,
        extent: Quantity | None = ...,
        width: Quantity | None = ...,
        thickness: Quantity | None = ...,
        clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        preload: Quantity | None = ...,
        assembled_clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        pivot: Mapping[str, Any] | Part | None = ...,
        mass: Quantity | None = ...,
        inertia: Quantity | None = ...,
        mass_offset: Quantity | None = ...,
        mass_inset: Quantity | None = ...,
        material: Quantity | Mapping[str, Any] | Part | None = ...,
        probe_fraction: Quantity | None = ...,
    ) -> None: ...

class RigidPivot(OwnPart, pivots.RigidPivotInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        kind: Literal["rigid"] | Enum | None = ...,
    ) -> None: ...

class SpringPivot(OwnPart, pivots.SpringPivotInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        damping: Quantity | None = ...,
        housing_stiffness: Quantity | None = ...,
        kind: Literal["spring"] | Enum | None = ...,
        stiffness: Quantity | None = ...,
    ) -> None: ...

class PointPivot(OwnPart, pivots.PointPivotInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        damping: Quantity | None = ...,
        housing_stiffness: Quantity | None = ...,
        pivot_radius: Quantity | None = ...,
        housing_radius: Quantity | None = ...,
        elastic_modulus: Quantity | None = ...,
        poisson_ratio: Quantity | None = ...,
        housing_elastic_modulus: Quantity | None = ...,
        housing_poisson_ratio: Quantity | None = ...,
        yield_strength: Quantity | None = ...,
        kind: Literal["point"] | Enum | None = ...,
    ) -> None: ...

class LinePivot(OwnPart, pivots.LinePivotInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        damping: Quantity | None = ...,
        housing_stiffness: Quantity | None = ...,
        pivot_radius: Quantity | None = ...,
        housing_radius: Quantity | None = ...,
        elastic_modulus: Quantity | None = ...,
        poisson_ratio: Quantity | None = ...,
        housing_elastic_modulus: Quantity | None = ...,
        housing_poisson_ratio: Quantity | None = ...,
        yield_strength: Quantity | None = ...,
        kind: Literal["line"] | Enum | None = ...,
        length: Quantity | None = ...,
        depth: Quantity | None = ...,
        housing_depth: Quantity | None = ...,
    ) -> None: ...

class RockerPivot(OwnPart, pivots.RockerPivotInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        damping: Quantity | None = ...,
        housing_stiffness: Quantity | None = ...,
        kind: Literal["rocker"] | Enum | None = ...,
        length: Quantity | None = ...,
    ) -> None: ...

class TablePivot(OwnPart, pivots.TablePivotInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        kind: Literal["table"] | Enum | None = ...,
        points: Iterable[Any] | None = ...,
        damping: Quantity | None = ...,
    ) -> None: ...

class PivotPoint(OwnPart, pivots.PivotPoint):
    def __init__(
        self,
        *,
        load: Quantity | None = ...,
        displacement: Quantity | None = ...,
    ) -> None: ...

class FlexurePivot(OwnPart, pivots.FlexureInput):
    def __init__(
        self,
        *,
        fraction: Quantity | None = ...,
        kind: Literal["flexure"] | Enum | None = ...,
        rotational_stiffness: Quantity | None = ...,
        rotational_damping: Quantity | None = ...,
        stiffness: Quantity | None = ...,
        damping: Quantity | None = ...,
        tangential_stiffness: Quantity | None = ...,
        tangential_damping: Quantity | None = ...,
        rest_tilt: Quantity | None = ...,
    ) -> None: ...

class PadOilSupply(OwnPart, bearing.PadOilSupply):
    def __init__(
        self,
        *,
        temperature: Quantity | None = ...,
        flow: Quantity | None = ...,
        circulation_time: Quantity | None = ...,
    ) -> None: ...

class PadJournalMaterials(OwnPart, materials.PadJournalMaterials):
    def __init__(
        self,
        *,
        bearing_metal: Quantity | Mapping[str, Any] | Part | None = ...,
        load_character: Literal["calm", "shock"] | Enum | None = ...,
        pads: Quantity | Mapping[str, Any] | Part | None = ...,
        journal: Quantity | Mapping[str, Any] | Part | None = ...,
        housing: Quantity | Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class PadStructure(OwnPart, materials.PadStructure):
    def __init__(
        self,
        *,
        name: str | None = ...,
        elastic_modulus: Quantity | None = ...,
        thermal_expansion: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        poisson_ratio: Quantity | None = ...,
    ) -> None: ...

class PadJournalWalls(OwnPart, heat.PadJournalWalls):
    def __init__(
        self,
        *,
        pads: Mapping[str, Any] | Part | None = ...,
        housing: Mapping[str, Any] | Part | None = ...,
        journal: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class ConductingPads(OwnPart, heat.ConductingPadsInput):
    def __init__(
        self,
        *,
        conductivity: Quantity | None = ...,
        heat_transfer_coefficient: Quantity | None = ...,
        edge_coefficient: Quantity | None = ...,
        temperature: Quantity | None = ...,
    ) -> None: ...

class PadHousing(OwnPart, heat.PadHousingInput):
    def __init__(
        self,
        *,
        temperature: Quantity | None = ...,
    ) -> None: ...

class PadJournalLimits(OwnPart, bearing.PadJournalLimits):
    def __init__(
        self,
        *,
        minimum_film_thickness: Quantity | None = ...,
        specific_load: Quantity | None = ...,
        temperature: Quantity | None = ...,
        transition_film_thickness: Quantity | None = ...,
        log_decrement: Quantity | None = ...,
        probe_alarm: Quantity | None = ...,
        probe_trip: Quantity | None = ...,
    ) -> None: ...

class PadPedestal(OwnPart, pedestal.PedestalInput):
    def __init__(
        self,
        *,
        stiffness_x: Quantity | None = ...,
        stiffness_y: Quantity | None = ...,
        damping_x: Quantity | None = ...,
        damping_y: Quantity | None = ...,
        mass: Quantity | None = ...,
    ) -> None: ...

class PadOperatingPoint(OwnPart, bearing.PadOperatingPoint):
    def __init__(
        self,
        *,
        name: str | None = ...,
        load: Quantity | Mapping[str, Any] | None = ...,
        position: Mapping[str, Any] | Part | None = ...,
        load_angle: Quantity | None = ...,
        speed: Quantity | None = ...,
        supply_temperature: Quantity | None = ...,
    ) -> None: ...
