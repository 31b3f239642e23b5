"""Written by scripts/write_stubs.py: what the public classes take."""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, ClassVar, Literal, SupportsFloat, SupportsIndex, TypeAlias

from babbitt.api.case import Case
from babbitt.api.machine_bearings import by_itself
from babbitt.api.other_packages import class_of
from babbitt.api.own_bore import Gap, with_own_bore, with_own_bore_in_words, without_own_bore
from babbitt.api.words import of_machine
from babbitt.case.case_file import CaseFile
from babbitt.case.part import Part
from babbitt.core.kind import find_kind
from babbitt.core.solution import Calculation
from babbitt.kinds.footstep.case.footstep import FootstepCase
from babbitt.kinds.hydrostatic.case.hydrostatic_journal import HydrostaticJournalCase
from babbitt.kinds.hydrostatic.case.hydrostatic_pad import HydrostaticPadCase
from babbitt.kinds.hydrostatic.case.hydrostatic_thrust_ring import HydrostaticThrustRingCase
from babbitt.kinds.hydrostatic.case.jacking import JackingPocketCase
from babbitt.kinds.journal.case import files
from babbitt.kinds.shaft.case.overhung_coupling import OverhungCouplingCase
from babbitt.kinds.shaft.case.shaft import ShaftCase
from babbitt.kinds.shaft_line.case.shaft_line import ThrustLineCase
from babbitt.kinds.thrust.case.thrust import ThrustCase
from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase

Quantity: TypeAlias = str | SupportsFloat

class JournalBearing(Case, files.JournalCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        characteristics: Literal["computed", "closed_form"] | Enum | None = ...,
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
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        cooling: Mapping[str, Any] | Part | None = ...,
        materials: Mapping[str, Any] | Part | None = ...,
        load: Quantity | Mapping[str, Any] | None = ...,
        specific_load: Quantity | None = ...,
        eccentricity_ratio: Quantity | None = ...,
        attitude_angle: Quantity | None = ...,
        position: Mapping[str, Any] | Part | None = ...,
        speed: Quantity | None = ...,
        surface_speed: Quantity | None = ...,
        kind: Literal["journal"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["iso7902", "film", "long_film", "segments"] | Enum | Mapping[str, Any] | Part | None = ...,
        diameter: Quantity | None = ...,
        width: Quantity | None = ...,
        width_ratio: Quantity | None = ...,
        clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        clearance_cases: Literal["mean", "all"] | Enum | None = ...,
        span: Quantity | None = ...,
        supply_element: Mapping[str, Any] | Part | None = ...,
        grooves: Iterable[Any] | None = ...,
        pockets: Iterable[Any] | None = ...,
        holes: Iterable[Any] | None = ...,
        bore: Mapping[str, Any] | Part | Gap | None = ...,
        misalignment: Mapping[str, Any] | Part | None = ...,
        steps: Iterable[Any] | None = ...,
        crowning: Mapping[str, Any] | Part | None = ...,
        displacement: Mapping[str, Any] | Part | None = ...,
        compliance: Iterable[Any] | None = ...,
        side_pressures: Iterable[Quantity] | None = ...,
        surfaces: Mapping[str, Any] | Part | None = ...,
        heat_exchange: Mapping[str, Any] | Part | None = ...,
        segments: Mapping[str, Any] | Part | None = ...,
        bearing_speed: Quantity | None = ...,
        load_angle: Quantity | None = ...,
        rotor_mass: Quantity | None = ...,
        shaft_stiffness: Quantity | None = ...,
        effective_temperature: Quantity | None = ...,
        operating_points: Iterable[Any] | None = ...,
        friction: Mapping[str, Any] | Part | None = ...,
        mixed_friction: Mapping[str, Any] | Part | None = ...,
        cavitation_pressure: Quantity | None = ...,
        pressure_viscosity: Mapping[str, Any] | Part | None = ...,
        walls: Mapping[str, Any] | Part | None = ...,
        dynamic_load: Mapping[str, Any] | Part | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

class Machine(Case, files.Machine):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    bearings: tuple[JournalBearing, ...]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        cooling: Mapping[str, Any] | Part | None = ...,
        materials: Mapping[str, Any] | Part | None = ...,
        kind: Literal["machine"] | Enum | None = ...,
        name: str | None = ...,
        clearance_cases: Literal["mean", "all"] | Enum | None = ...,
        bearings: Iterable[Any] | None = ...,
        oil_system: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

class ThrustBearing(Case, ThrustCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        thermal: Literal["isothermal", "global", "adiabatic"] | Enum | None = ...,
        radial_temperature: Literal["mean", "resolved"] | Enum | None = ...,
        turbulence: Literal["none", "ng_pan", "constantinescu"] | Enum | None = ...,
        method: Literal["film"] | Enum | Mapping[str, Any] | Part | None = ...,
        pads: Mapping[str, Any] | Part | None = ...,
        speed: Quantity | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        oil: Mapping[str, Any] | Part | None = ...,
        ring_stiffness: Quantity | None = ...,
        tilt: Mapping[str, Any] | Part | None = ...,
        materials: Mapping[str, Any] | Part | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
        kind: Literal["thrust"] | Enum | None = ...,
        name: str | None = ...,
        load: Quantity | None = ...,
        film: Quantity | None = ...,
        runout: Quantity | Iterable[Any] | None = ...,
    ) -> None: ...

class ThrustLine(Case, ThrustLineCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        thermal: Literal["isothermal", "global", "adiabatic"] | Enum | None = ...,
        radial_temperature: Literal["mean", "resolved"] | Enum | None = ...,
        turbulence: Literal["none", "ng_pan", "constantinescu"] | Enum | None = ...,
        method: Literal["film"] | Enum | Mapping[str, Any] | Part | None = ...,
        pads: Mapping[str, Any] | Part | None = ...,
        speed: Quantity | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        oil: Mapping[str, Any] | Part | None = ...,
        ring_stiffness: Quantity | None = ...,
        tilt: Mapping[str, Any] | Part | None = ...,
        materials: Mapping[str, Any] | Part | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
        kind: Literal["thrust_line"] | Enum | None = ...,
        name: str | None = ...,
        load: Quantity | None = ...,
        propeller: Mapping[str, Any] | Part | None = ...,
        shaft: Iterable[Any] | None = ...,
        collar_mass: Quantity | None = ...,
        seating: Mapping[str, Any] | Part | None = ...,
        ripple: Iterable[Any] | None = ...,
        runout: Quantity | Iterable[Any] | None = ...,
        loss_limit: Quantity | None = ...,
        speeds: Mapping[str, Any] | Part | None = ...,
        nonlinear: bool | None = ...,
    ) -> None: ...

class TiltingPadBearing(Case, TiltingPadJournalCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        thermal: Literal["isothermal", "global", "adiabatic", "full"] | Enum | None = ...,
        carry_over: Quantity | None = ...,
        turbulence: Literal["laminar", "ng_pan", "constantinescu"] | Enum | None = ...,
        deformation: Iterable[Any] | None = ...,
        pad_bending: Literal["beam", "plate"] | Enum | None = ...,
        assumption_sensitivity: bool | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        kind: Literal["tilting_pad_journal"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["film"] | Enum | Mapping[str, Any] | Part | None = ...,
        diameter: Quantity | None = ...,
        pads: Mapping[str, Any] | Part | None = ...,
        clearance_cases: Literal["mean", "all"] | Enum | None = ...,
        groove_pressure: Quantity | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        feed: Literal["flooded", "leading_edge_groove", "spray_bar"] | Enum | None = ...,
        effective_temperature: Quantity | None = ...,
        walls: Mapping[str, Any] | Part | None = ...,
        reference_temperature: Quantity | None = ...,
        materials: Mapping[str, Any] | Part | None = ...,
        surfaces: Mapping[str, Any] | Part | None = ...,
        load: Quantity | Mapping[str, Any] | None = ...,
        position: Mapping[str, Any] | Part | None = ...,
        load_angle: Quantity | None = ...,
        speed: Quantity | None = ...,
        operating_points: Iterable[Any] | None = ...,
        whirl_ratios: Iterable[Quantity] | None = ...,
        rotor_mass: Quantity | None = ...,
        shaft_stiffness: Quantity | None = ...,
        anticipated_cross_coupling: Quantity | None = ...,
        pedestal: Mapping[str, Any] | Part | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

class HydrostaticJournal(Case, HydrostaticJournalCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        kind: Literal["hydrostatic_journal"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["film", "quick"] | Enum | Mapping[str, Any] | Part | None = ...,
        restrictor: Mapping[str, Any] | Part | None = ...,
        restrictors: Iterable[Any] | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        oil: Mapping[str, Any] | Part | None = ...,
        film_temperature: Quantity | None = ...,
        recess_oil: Mapping[str, Any] | Part | None = ...,
        load: Quantity | Mapping[str, Any] | None = ...,
        frequencies: Iterable[Quantity] | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
        diameter: Quantity | None = ...,
        width: Quantity | None = ...,
        clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        recesses: Mapping[str, Any] | Part | None = ...,
        recess_length: Quantity | None = ...,
        speed: Quantity | None = ...,
        load_angle: Quantity | None = ...,
        eccentricity_ratio: Quantity | None = ...,
        attitude_angle: Quantity | None = ...,
        cavitation_pressure: Quantity | None = ...,
        rotor_mass: Quantity | None = ...,
        shaft_stiffness: Quantity | None = ...,
    ) -> None: ...

class HydrostaticPad(Case, HydrostaticPadCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        kind: Literal["hydrostatic_pad"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["film", "quick"] | Enum | Mapping[str, Any] | Part | None = ...,
        restrictor: Mapping[str, Any] | Part | None = ...,
        restrictors: Iterable[Any] | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        oil: Mapping[str, Any] | Part | None = ...,
        film_temperature: Quantity | None = ...,
        recess_oil: Mapping[str, Any] | Part | None = ...,
        load: Quantity | None = ...,
        frequencies: Iterable[Quantity] | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
        pad: Mapping[str, Any] | Part | None = ...,
        gap: Quantity | None = ...,
        speed: Quantity | None = ...,
        sliding_speed: Quantity | None = ...,
    ) -> None: ...

class ThrustRing(Case, HydrostaticThrustRingCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        kind: Literal["hydrostatic_thrust_ring"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["film", "quick"] | Enum | Mapping[str, Any] | Part | None = ...,
        restrictor: Mapping[str, Any] | Part | None = ...,
        restrictors: Iterable[Any] | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        oil: Mapping[str, Any] | Part | None = ...,
        film_temperature: Quantity | None = ...,
        recess_oil: Mapping[str, Any] | Part | None = ...,
        load: Quantity | None = ...,
        frequencies: Iterable[Quantity] | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
        inner_diameter: Quantity | None = ...,
        recess_inner_diameter: Quantity | None = ...,
        recess_outer_diameter: Quantity | None = ...,
        outer_diameter: Quantity | None = ...,
        recesses: Mapping[str, Any] | Part | None = ...,
        moments: Iterable[Quantity] | None = ...,
        gap: Quantity | None = ...,
        tilt: Iterable[Quantity] | None = ...,
        speed: Quantity | None = ...,
    ) -> None: ...

class JackingPocket(Case, JackingPocketCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        accuracy: Literal["draft", "engineering", "reference"] | Enum | None = ...,
        kind: Literal["jacking_pocket"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["film", "quick"] | Enum | Mapping[str, Any] | Part | None = ...,
        diameter: Quantity | None = ...,
        width: Quantity | None = ...,
        clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        pockets: Mapping[str, Any] | Part | None = ...,
        pocket_length: Quantity | None = ...,
        viscosity: Quantity | None = ...,
        load: Quantity | None = ...,
        lift_gap: Quantity | None = ...,
        pump_flow: Quantity | None = ...,
        relief_pressure: Quantity | None = ...,
        pump_efficiency: Quantity | None = ...,
        roughness: Quantity | None = ...,
        own_restrictors: bool | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

class Footstep(Case, FootstepCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        kind: Literal["screw_heel"] | Enum | None = ...,
        name: str | None = ...,
        method: Literal["superposition", "narrow_groove"] | Enum | Mapping[str, Any] | Part | None = ...,
        variants: Literal["both", "smooth", "grooved"] | Enum | None = ...,
        heel: Mapping[str, Any] | Part | None = ...,
        groove: Mapping[str, Any] | Part | None = ...,
        face_gap: Quantity | None = ...,
        clearance: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        oil: Mapping[str, Any] | Part | None = ...,
        wall: Mapping[str, Any] | Part | None = ...,
        speed: Quantity | None = ...,
        ambient_pressure: Quantity | None = ...,
        pressures: Literal["absolute", "gauge"] | Enum | None = ...,
        load_reference: Literal["absolute", "gauge"] | Enum | None = ...,
        eccentricity_ratio: Quantity | None = ...,
        tilt: Quantity | None = ...,
        options: Mapping[str, Any] | Part | None = ...,
        figures: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

class Shaft(Case, ShaftCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        lubricant: Quantity | Mapping[str, Any] | Part | None = ...,
        supply: Mapping[str, Any] | Part | None = ...,
        cooling: Mapping[str, Any] | Part | None = ...,
        materials: Mapping[str, Any] | Part | None = ...,
        kind: Literal["shaft"] | Enum | None = ...,
        name: str | None = ...,
        speed: Quantity | None = ...,
        bearings: Iterable[Any] | None = ...,
        gears: Iterable[Any] | None = ...,
        couplings: Iterable[Any] | None = ...,
        masses: Iterable[Any] | None = ...,
        forces: Iterable[Any] | None = ...,
        shaft: Iterable[Any] | None = ...,
        start: Quantity | None = ...,
        clearance_cases: Literal["mean", "all"] | Enum | None = ...,
        limits: Mapping[str, Any] | Part | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

class OverhungCoupling(Case, OverhungCouplingCase):
    model: ClassVar[type[CaseFile]]
    default_name: ClassVar[str]
    def __init__(
        self,
        *,
        babbitt: Literal[1] | Enum | None = ...,
        kind: Literal["overhung_coupling"] | Enum | None = ...,
        name: str | None = ...,
        mesh_force: Quantity | None = ...,
        mesh_angle: Quantity | None = ...,
        mesh_direction: Literal["upward", "downward"] | Enum | None = ...,
        bearing_distance: Quantity | None = ...,
        gear_mass: Quantity | None = ...,
        coupling_mass: Quantity | None = ...,
        flange_distance: Quantity | None = ...,
        coupling_length: Quantity | None = ...,
        assumptions: Iterable[Any] | None = ...,
        notes: str | None = ...,
        source: str | None = ...,
    ) -> None: ...

PUBLIC: Mapping[type[CaseFile], type[Case]]

def public_case(case: CaseFile) -> CaseFile: ...
