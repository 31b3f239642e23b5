"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.part import OwnPart
from babbitt.case.part import Part
from babbitt.case.parts import choices, clearance, compliance, cooling, lubricant, materials, supply, surfaces

Quantity: TypeAlias = str | SupportsFloat

class RelativeClearance(OwnPart, clearance.RelativeClearance):
    def __init__(
        self,
        *,
        mean: Quantity | None = ...,
        minimum: Quantity | None = ...,
        maximum: Quantity | None = ...,
        kind: Literal["relative"] | Enum | None = ...,
    ) -> None: ...

class RadialClearance(OwnPart, clearance.RadialClearance):
    def __init__(
        self,
        *,
        mean: Quantity | None = ...,
        minimum: Quantity | None = ...,
        maximum: Quantity | None = ...,
        kind: Literal["radial"] | Enum | None = ...,
    ) -> None: ...

class DiametralClearance(OwnPart, clearance.DiametralClearance):
    def __init__(
        self,
        *,
        mean: Quantity | None = ...,
        minimum: Quantity | None = ...,
        maximum: Quantity | None = ...,
        kind: Literal["diametral"] | Enum | None = ...,
    ) -> None: ...

class Fit(OwnPart, clearance.FitClearance):
    def __init__(
        self,
        *,
        kind: Literal["fit"] | Enum | None = ...,
        bore: str | None = ...,
        journal: str | None = ...,
    ) -> None: ...

class SizeLimits(OwnPart, clearance.LimitsClearance):
    def __init__(
        self,
        *,
        bore: Iterable[Quantity] | None = ...,
        journal: Iterable[Quantity] | None = ...,
        kind: Literal["limits"] | Enum | None = ...,
    ) -> None: ...

class Deviations(OwnPart, clearance.DeviationsClearance):
    def __init__(
        self,
        *,
        bore: Iterable[Quantity] | None = ...,
        journal: Iterable[Quantity] | None = ...,
        kind: Literal["deviations"] | Enum | None = ...,
    ) -> None: ...

class Supply(OwnPart, supply.Supply):
    def __init__(
        self,
        *,
        temperature: Quantity | None = ...,
        pressure: Quantity | None = ...,
        flow: Quantity | None = ...,
        tubes: Iterable[Any] | None = ...,
        holes: Iterable[Any] | None = ...,
        circulation_time: Quantity | None = ...,
    ) -> None: ...

class Tube(OwnPart, supply.Tube):
    def __init__(
        self,
        *,
        diameter: Quantity | None = ...,
        length: Quantity | None = ...,
        loss_coefficient: Quantity | None = ...,
        number: SupportsIndex | None = ...,
    ) -> None: ...

class FeedHole(OwnPart, supply.FeedHole):
    def __init__(
        self,
        *,
        diameter: Quantity | None = ...,
        length: Quantity | None = ...,
        loss_coefficient: Quantity | None = ...,
        number: SupportsIndex | None = ...,
    ) -> None: ...

class Cooling(OwnPart, cooling.Cooling):
    def __init__(
        self,
        *,
        ambient_temperature: Quantity | None = ...,
        heat_transfer_coefficient: Quantity | None = ...,
        air_speed: Quantity | None = ...,
        surface: Quantity | None = ...,
        housing: Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class CylinderHousing(OwnPart, cooling.CylinderHousing):
    def __init__(
        self,
        *,
        kind: Literal["cylinder"] | Enum | None = ...,
        diameter: Quantity | None = ...,
        width: Quantity | None = ...,
    ) -> None: ...

class PedestalHousing(OwnPart, cooling.PedestalHousing):
    def __init__(
        self,
        *,
        kind: Literal["pedestal"] | Enum | None = ...,
        height: Quantity | None = ...,
        width: Quantity | None = ...,
    ) -> None: ...

class InMachine(OwnPart, cooling.InMachine):
    def __init__(
        self,
        *,
        kind: Literal["in_machine"] | Enum | None = ...,
        factor: Quantity | None = ...,
    ) -> None: ...

class Materials(OwnPart, materials.Materials):
    def __init__(
        self,
        *,
        bearing_metal: Quantity | Mapping[str, Any] | Part | None = ...,
        load_character: Literal["calm", "shock"] | Enum | None = ...,
        bearing: Quantity | Mapping[str, Any] | Part | None = ...,
        journal: Quantity | Mapping[str, Any] | Part | None = ...,
    ) -> None: ...

class Structure(OwnPart, materials.Structure):
    def __init__(
        self,
        *,
        name: str | None = ...,
        thermal_expansion: Quantity | None = ...,
    ) -> None: ...

class Metal(OwnPart, materials.Metal):
    def __init__(
        self,
        *,
        name: str | None = ...,
        family: Literal["tin-based", "lead-based", "copper-lead", "copper-tin", "copper-aluminium", "copper-zinc", "aluminium-tin", "aluminium-zinc", "aluminium-silicon", "other"] | Enum | None = ...,
        specific_load: Quantity | None = ...,
        sliding_speed: Quantity | None = ...,
        load_times_speed: Quantity | None = ...,
        temperature: Quantity | None = ...,
    ) -> None: ...

class Surfaces(OwnPart, surfaces.DirectSurfaces):
    def __init__(
        self,
        *,
        roughness_bearing: Quantity | None = ...,
        roughness_journal: Quantity | None = ...,
        mean_deflection: Quantity | None = ...,
        wave_factor: Quantity | None = ...,
        kind: Literal["direct"] | Enum | None = ...,
        tilt_offset: Quantity | None = ...,
        waviness: Quantity | None = ...,
    ) -> None: ...

class DrawingSurfaces(OwnPart, surfaces.DrawingSurfaces):
    def __init__(
        self,
        *,
        roughness_bearing: Quantity | None = ...,
        roughness_journal: Quantity | None = ...,
        mean_deflection: Quantity | None = ...,
        wave_factor: Quantity | None = ...,
        kind: Literal["drawing"] | Enum | None = ...,
        profile_tolerance_bearing: Quantity | None = ...,
        profile_tolerance_journal: Quantity | None = ...,
        roundness_tolerance_bearing: Quantity | None = ...,
        roundness_tolerance_journal: Quantity | None = ...,
    ) -> None: ...

class Column(OwnPart, compliance.ColumnInput):
    def __init__(
        self,
        *,
        kind: Literal["column"] | Enum | None = ...,
        thickness: Quantity | None = ...,
        elastic_modulus: Quantity | None = ...,
        poisson_ratio: Quantity | None = ...,
        displacement_per_pressure: Quantity | None = ...,
    ) -> None: ...

class Ring(OwnPart, compliance.RingInput):
    def __init__(
        self,
        *,
        kind: Literal["ring"] | Enum | None = ...,
        outer_diameter: Quantity | None = ...,
        elastic_modulus: Quantity | None = ...,
        poisson_ratio: Quantity | None = ...,
        support: Literal["free", "clamped"] | Enum | None = ...,
    ) -> None: ...

class HalfSpace(OwnPart, compliance.HalfSpaceInput):
    def __init__(
        self,
        *,
        kind: Literal["half_space"] | Enum | None = ...,
        elastic_modulus: Quantity | None = ...,
        poisson_ratio: Quantity | None = ...,
    ) -> None: ...

class ComplianceMatrix(OwnPart, compliance.MatrixInput):
    def __init__(
        self,
        *,
        kind: Literal["file"] | Enum | None = ...,
        angles: Iterable[Quantity] | None = ...,
        values: Iterable[Quantity] | None = ...,
        file: str | None = ...,
    ) -> None: ...

class Friction(OwnPart, choices.FrictionInput):
    def __init__(
        self,
        *,
        model: Literal["full", "arc", "curve360"] | Enum | None = ...,
        factor: Quantity | None = ...,
    ) -> None: ...

class Limits(OwnPart, choices.LimitsInput):
    def __init__(
        self,
        *,
        minimum_film_thickness: Quantity | None = ...,
        specific_load: Quantity | None = ...,
        temperature: Quantity | None = ...,
        transition_film_thickness: Quantity | None = ...,
        tables: str | None = ...,
    ) -> None: ...

class CatalogueLubricant(OwnPart, lubricant.CatalogueLubricant):
    def __init__(
        self,
        *,
        kind: Literal["catalogue"] | Enum | None = ...,
        name: str | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
    ) -> None: ...

class IsoVgLubricant(OwnPart, lubricant.IsoVgLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["iso_vg"] | Enum | None = ...,
        grade: SupportsIndex | None = ...,
        viscosity_index: Quantity | None = ...,
    ) -> None: ...

class ViscosityIndexLubricant(OwnPart, lubricant.ViscosityIndexLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["viscosity_index"] | Enum | None = ...,
        nu40: Quantity | None = ...,
        viscosity_index: Quantity | None = ...,
    ) -> None: ...

class TwoPointLubricant(OwnPart, lubricant.TwoPointLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["two_points"] | Enum | None = ...,
        nu40: Quantity | None = ...,
        nu100: Quantity | None = ...,
        points: Iterable[Any] | None = ...,
        form: Literal["walther", "astm_d341"] | Enum | None = ...,
    ) -> None: ...

class WaltherLubricant(OwnPart, lubricant.WaltherLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["walther"] | Enum | None = ...,
        intercept: Quantity | None = ...,
        slope: Quantity | None = ...,
        additive: Quantity | None = ...,
    ) -> None: ...

class VogelLubricant(OwnPart, lubricant.VogelLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["vogel"] | Enum | None = ...,
        points: Iterable[Any] | None = ...,
        factor: Quantity | None = ...,
        activation: Quantity | None = ...,
        pole: Quantity | None = ...,
    ) -> None: ...

class ExponentialLubricant(OwnPart, lubricant.ExponentialLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["exponential"] | Enum | None = ...,
        points: Iterable[Any] | None = ...,
    ) -> None: ...

class TableLubricant(OwnPart, lubricant.TableLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["table"] | Enum | None = ...,
        points: Iterable[Any] | None = ...,
    ) -> None: ...

class PowerLawLubricant(OwnPart, lubricant.PowerLawLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["power_law"] | Enum | None = ...,
        nu50: Quantity | None = ...,
        exponent: Quantity | None = ...,
    ) -> None: ...

class ConstantLubricant(OwnPart, lubricant.ConstantLubricant):
    def __init__(
        self,
        *,
        name: str | None = ...,
        source: str | None = ...,
        density: Quantity | None = ...,
        density_temperature: Quantity | None = ...,
        density_slope: Quantity | None = ...,
        heat_capacity: Quantity | None = ...,
        heat_capacity_temperature: Quantity | None = ...,
        heat_capacity_slope: Quantity | None = ...,
        conductivity: Quantity | None = ...,
        volumetric_heat_capacity: Quantity | None = ...,
        kind: Literal["constant"] | Enum | None = ...,
        dynamic_viscosity: Quantity | None = ...,
        kinematic_viscosity: Quantity | None = ...,
    ) -> None: ...
