"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.case.parts import position, walls
from babbitt.kinds.journal.case import dynamic_load, film_features, film_heat, film_oil, film_surface, grooved_segments, heat_exchange, mixed_friction, oil_system, operating_point, supply_element

Quantity: TypeAlias = str | SupportsFloat

class Groove(OwnPart, film_features.GrooveInput):
    def __init__(
        self,
        *,
        angle: Quantity | None = ...,
        extent: Quantity | None = ...,
        pressure: Quantity | None = ...,
        flow: Quantity | None = ...,
    ) -> None: ...

class Pocket(OwnPart, film_features.PocketInput):
    def __init__(
        self,
        *,
        angle: Quantity | None = ...,
        extent: Quantity | None = ...,
        width: Quantity | None = ...,
        axial_position: Quantity | None = ...,
        pressure: Quantity | None = ...,
        flow: Quantity | None = ...,
    ) -> None: ...

class Hole(OwnPart, film_features.SupplyHoleInput):
    def __init__(
        self,
        *,
        angle: Quantity | None = ...,
        diameter: Quantity | None = ...,
        axial_position: Quantity | None = ...,
        pressure: Quantity | None = ...,
        flow: Quantity | None = ...,
    ) -> None: ...

class Misalignment(OwnPart, film_features.MisalignmentInput):
    def __init__(
        self,
        *,
        x: Quantity | None = ...,
        y: Quantity | None = ...,
    ) -> None: ...

class RoundBore(OwnPart, film_features.RoundBoreInput):
    def __init__(
        self,
        *,
        kind: Literal["round"] | Enum | None = ...,
    ) -> None: ...

class Lobes(OwnPart, film_features.LobedBoreInput):
    def __init__(
        self,
        *,
        kind: Literal["lobes"] | Enum | None = ...,
        preload: Quantity | None = ...,
        offset: Quantity | None = ...,
    ) -> None: ...

class TaperedBore(OwnPart, film_features.TaperedBoreInput):
    def __init__(
        self,
        *,
        kind: Literal["taper_land"] | Enum | None = ...,
        depth: Quantity | None = ...,
        share: Quantity | None = ...,
    ) -> None: ...

class Relief(OwnPart, film_features.ReliefInput):
    def __init__(
        self,
        *,
        angle: Quantity | None = ...,
        extent: Quantity | None = ...,
        width: Quantity | None = ...,
        depth: Quantity | None = ...,
    ) -> None: ...

class PressureDam(OwnPart, film_features.PressureDamBoreInput):
    def __init__(
        self,
        *,
        kind: Literal["pressure_dam"] | Enum | None = ...,
        angle: Quantity | None = ...,
        extent: Quantity | None = ...,
        width: Quantity | None = ...,
        depth: Quantity | None = ...,
        relief: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class WornBore(OwnPart, film_features.WornBoreInput):
    def __init__(
        self,
        *,
        kind: Literal["wear"] | Enum | None = ...,
        depth: Quantity | None = ...,
        angle: Quantity | None = ...,
    ) -> None: ...

class MeasuredBore(OwnPart, film_features.MeasuredBoreInput):
    def __init__(
        self,
        *,
        kind: Literal["measured"] | Enum | None = ...,
        departures: Iterable[Quantity] | None = ...,
        file: str | None = ...,
        start: Quantity | None = ...,
    ) -> None: ...

class Step(OwnPart, film_surface.StepInput):
    def __init__(
        self,
        *,
        angle: Quantity | None = ...,
        extent: Quantity | None = ...,
        width: Quantity | None = ...,
        depth: Quantity | None = ...,
        axial_position: Quantity | None = ...,
    ) -> None: ...

class ParabolicCrowning(OwnPart, film_surface.ParabolicCrowningInput):
    def __init__(
        self,
        *,
        kind: Literal["parabolic"] | Enum | None = ...,
        drop: Quantity | None = ...,
    ) -> None: ...

class EdgeCrowning(OwnPart, film_surface.EdgeCrowningInput):
    def __init__(
        self,
        *,
        kind: Literal["edges"] | Enum | None = ...,
        drop: Quantity | None = ...,
        length: Quantity | None = ...,
    ) -> None: ...

class TableCrowning(OwnPart, film_surface.TableCrowningInput):
    def __init__(
        self,
        *,
        kind: Literal["table"] | Enum | None = ...,
        drops: Iterable[Quantity] | None = ...,
    ) -> None: ...

class Displacement(OwnPart, film_surface.DisplacementInput):
    def __init__(
        self,
        *,
        angles: Iterable[Quantity] | None = ...,
        places: Iterable[Quantity] | None = ...,
        values: Iterable[Quantity] | None = ...,
        file: str | None = ...,
        form: str | None = ...,
    ) -> None: ...

class Liner(OwnPart, film_heat.LinerInput):
    def __init__(
        self,
        *,
        thickness: Quantity | None = ...,
        conductivity: Quantity | None = ...,
    ) -> None: ...

class ConductingBush(OwnPart, film_heat.ConductingBushInput):
    def __init__(
        self,
        *,
        outer_diameter: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        liner: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class ConductingHousing(OwnPart, film_heat.ConductingHousingInput):
    def __init__(
        self,
        *,
        outer_diameter: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        contact_coefficient: Quantity | None = ...,
        heat_transfer_coefficient: Quantity | None = ...,
        ambient_temperature: Quantity | None = ...,
    ) -> None: ...

class ConductingJournal(OwnPart, walls.ConductingJournalInput):
    def __init__(
        self,
        *,
        temperature: Quantity | None = ...,
        shaft_conductance: Quantity | None = ...,
        ambient_temperature: Quantity | None = ...,
    ) -> None: ...

class Walls(OwnPart, film_heat.WallsInput):
    def __init__(
        self,
        *,
        bush: Mapping[str, Any] | Part | None = ...,
        housing: Mapping[str, Any] | Part | None = ...,
        journal: Mapping[str, Any] | Part | None = ...,
        thermal_distortion: bool | None = ...,
    ) -> None: ...

class PressureViscosity(OwnPart, film_oil.PressureViscosityInput):
    def __init__(
        self,
        *,
        kind: Literal["barus", "roelands"] | Enum | None = ...,
        coefficient: Quantity | None = ...,
    ) -> None: ...

class HoleElement(OwnPart, supply_element.HoleElement):
    def __init__(
        self,
        *,
        kind: Literal["hole"] | Enum | None = ...,
        diameter: Quantity | None = ...,
        place: Literal["opposite", "side", "both_sides"] | Enum | None = ...,
        number: SupportsIndex | None = ...,
    ) -> None: ...

class SlotElement(OwnPart, supply_element.SlotElement):
    def __init__(
        self,
        *,
        kind: Literal["slot"] | Enum | None = ...,
        length: Quantity | None = ...,
        width: Quantity | None = ...,
        place: Literal["opposite", "side", "both_sides"] | Enum | None = ...,
    ) -> None: ...

class PocketElement(OwnPart, supply_element.PocketElement):
    def __init__(
        self,
        *,
        kind: Literal["pocket"] | Enum | None = ...,
        width: Quantity | None = ...,
        place: Literal["opposite", "side", "both_sides"] | Enum | None = ...,
        extent: Quantity | None = ...,
    ) -> None: ...

class GrooveElement(OwnPart, supply_element.GrooveElement):
    def __init__(
        self,
        *,
        kind: Literal["groove_360", "groove_180"] | Enum | None = ...,
        width: Quantity | None = ...,
    ) -> None: ...

class UnevenPockets(OwnPart, supply_element.UnevenPockets):
    def __init__(
        self,
        *,
        kind: Literal["uneven_pockets"] | Enum | None = ...,
        width: Quantity | None = ...,
        entry_angle: Quantity | None = ...,
        exit_angle: Quantity | None = ...,
        extent: Quantity | None = ...,
        rounding: Literal["down", "nearest"] | Enum | None = ...,
    ) -> None: ...

class RotatingLoad(OwnPart, dynamic_load.RotatingLoadInput):
    def __init__(
        self,
        *,
        kind: Literal["rotating"] | Enum | None = ...,
        magnitude: Quantity | None = ...,
        speed_ratio: Quantity | None = ...,
        phase: Quantity | None = ...,
        moving_mass: Quantity | None = ...,
    ) -> None: ...

class LoadTable(OwnPart, dynamic_load.LoadTableInput):
    def __init__(
        self,
        *,
        kind: Literal["table"] | Enum | None = ...,
        cycle: Quantity | None = ...,
        angle: Iterable[Quantity] | None = ...,
        fx: Iterable[Quantity] | None = ...,
        fy: Iterable[Quantity] | None = ...,
        file: str | None = ...,
        moving_mass: Quantity | None = ...,
    ) -> None: ...

class MixedFriction(OwnPart, mixed_friction.MixedFrictionInput):
    def __init__(
        self,
        *,
        boundary_friction: Quantity | None = ...,
        composite_roughness: Quantity | None = ...,
        asperity_density: Quantity | None = ...,
        asperity_sharpness: Quantity | None = ...,
        contact_modulus: Quantity | None = ...,
    ) -> None: ...

class OilSystem(OwnPart, oil_system.OilSystemInput):
    def __init__(
        self,
        *,
        pump: Mapping[str, Any] | Part | None = ...,
        lines: Iterable[Any] | None = ...,
        margin: Quantity | None = ...,
    ) -> None: ...

class OilPump(OwnPart, oil_system.PumpInput):
    def __init__(
        self,
        *,
        flow: Quantity | None = ...,
        curve: Iterable[Any] | None = ...,
        relief_pressure: Quantity | None = ...,
    ) -> None: ...

class PumpPoint(OwnPart, oil_system.PumpPoint):
    def __init__(
        self,
        *,
        pressure: Quantity | None = ...,
        flow: Quantity | None = ...,
    ) -> None: ...

class OilLine(OwnPart, oil_system.LineInput):
    def __init__(
        self,
        *,
        bearing: str | None = ...,
        orifice_diameter: Quantity | None = ...,
        discharge_coefficient: Quantity | None = ...,
        tube: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class OperatingPoint(OwnPart, operating_point.OperatingPoint):
    def __init__(
        self,
        *,
        load: Quantity | Mapping[str, Any] | None = ...,
        specific_load: Quantity | None = ...,
        eccentricity_ratio: Quantity | None = ...,
        attitude_angle: Quantity | None = ...,
        position: Mapping[str, Any] | Part | None = ...,
        speed: Quantity | None = ...,
        surface_speed: Quantity | None = ...,
        name: str | None = ...,
        load_angle: Quantity | None = ...,
        supply_temperature: Quantity | None = ...,
        supply_pressure: Quantity | None = ...,
        supply_flow: Quantity | None = ...,
        span: Quantity | None = ...,
        supply_element: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class Position(OwnPart, position.PositionInput):
    def __init__(
        self,
        *,
        x: Quantity | None = ...,
        y: Quantity | None = ...,
    ) -> None: ...

class HeatExchange(OwnPart, heat_exchange.HeatExchangeInput):
    def __init__(
        self,
        *,
        nusselt: Quantity | Mapping[str, Any] | Part | None = ...,
        discretisation: Literal["consistent", "published_mean", "published_literal"] | Enum | None = ...,
        exchange_zone: Literal["liquid_fraction", "all_around", "film"] | Enum | None = ...,
        bush: Mapping[str, Any] | Part | None = ...,
        ambient: Mapping[str, Any] | Part | None = ...,
        shaft_conductance: Quantity | None = ...,
        supply_angle: Quantity | None = ...,
    ) -> None: ...

class SegmentOptions(OwnPart, grooved_segments.SegmentsInput):
    def __init__(
        self,
        *,
        groove: Mapping[str, Any] | Part | None = ...,
        film_start: Quantity | None = ...,
        compliance: Quantity | None = ...,
        profile: Iterable[Any] | None = ...,
        roughness: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...
