"""Babbitt computes and designs fluid-film (plain) bearings.

>>> import babbitt
>>> case = babbitt.parse_case(babbitt.template("journal"))
>>> result = babbitt.solve(case).results[0]
>>> result.solved
True
"""

from __future__ import annotations

TYPE_CHECKING = False  # the module typing takes longer than this one
if TYPE_CHECKING:
    from typing import Any

    from babbitt.api.answers import (
        solve,
    )
    from babbitt.api.batch import (
        solve_batch,
    )
    from babbitt.api.bearings import (
        Footstep,
        HydrostaticJournal,
        HydrostaticPad,
        JackingPocket,
        JournalBearing,
        Machine,
        OverhungCoupling,
        Shaft,
        ThrustBearing,
        ThrustLine,
        ThrustRing,
        TiltingPadBearing,
    )
    from babbitt.api.cases import (
        load_case,
        parse_case,
    )
    from babbitt.api.catalogue import (
        explain,
        lubricants,
        materials,
        published_cases,
        validate,
    )
    from babbitt.api.clearances import (
        diametral_clearance,
        fit,
        grooves,
        radial_clearance,
        relative_clearance,
    )
    from babbitt.api.common_parts import (
        CatalogueLubricant,
        Column,
        ComplianceMatrix,
        ConstantLubricant,
        Cooling,
        CylinderHousing,
        Deviations,
        DiametralClearance,
        DrawingSurfaces,
        ExponentialLubricant,
        FeedHole,
        Fit,
        Friction,
        HalfSpace,
        InMachine,
        IsoVgLubricant,
        Limits,
        Materials,
        Metal,
        PedestalHousing,
        PowerLawLubricant,
        RadialClearance,
        RelativeClearance,
        Ring,
        SizeLimits,
        Structure,
        Supply,
        Surfaces,
        TableLubricant,
        Tube,
        TwoPointLubricant,
        ViscosityIndexLubricant,
        VogelLubricant,
        WaltherLubricant,
    )
    from babbitt.api.designing import (
        design_bearing,
    )
    from babbitt.api.designs import compare
    from babbitt.api.footstep_parts import (
        FigureRanges,
        FootstepGroove,
        FootstepOil,
        FootstepOptions,
        FootstepWall,
        Heel,
    )
    from babbitt.api.hydrostatic_parts import (
        AnnularPad,
        Capillary,
        CircularPad,
        ConstantFlow,
        FlowValve,
        HydrostaticOil,
        HydrostaticSupply,
        MembraneValve,
        MeteredFlow,
        Orifice,
        RecessOil,
        RecessRow,
        RectangularPad,
        Slot,
    )
    from babbitt.api.journal_parts import (
        ConductingBush,
        ConductingHousing,
        ConductingJournal,
        Displacement,
        EdgeCrowning,
        Groove,
        GrooveElement,
        HeatExchange,
        Hole,
        HoleElement,
        Liner,
        LoadTable,
        Lobes,
        MeasuredBore,
        Misalignment,
        MixedFriction,
        OilLine,
        OilPump,
        OilSystem,
        OperatingPoint,
        ParabolicCrowning,
        Pocket,
        PocketElement,
        Position,
        PressureDam,
        PressureViscosity,
        PumpPoint,
        Relief,
        RotatingLoad,
        RoundBore,
        SegmentOptions,
        SlotElement,
        Step,
        TableCrowning,
        TaperedBore,
        UnevenPockets,
        Walls,
        WornBore,
    )
    from babbitt.api.methods import (
        Film,
        Iso7902,
        LongFilm,
        Segments,
    )
    from babbitt.api.own_bore import (
        Gap,
    )
    from babbitt.api.own_viscosity import (
        viscosity_law,
    )
    from babbitt.api.pad_batch import (
        solve_pad_batch,
    )
    from babbitt.api.shaft_parts import (
        Coupling,
        Gear,
        ShaftForce,
        ShaftMass,
        ShaftSupport,
    )
    from babbitt.api.stored_studies import (
        open_study,
    )
    from babbitt.api.thrust_parts import (
        FilmHeatBalance,
        FilmTemperature,
        FilmViscosity,
        FixedPad,
        LineLimits,
        PadMaterials,
        Pads,
        Propeller,
        Runout,
        Seating,
        ShaftPiece,
        SpeedRange,
        StepFace,
        Taper,
        ThrustRipple,
        Tilt,
        TiltingPivot,
    )
    from babbitt.api.tilting_pad_parts import (
        ConductingPads,
        FlexurePivot,
        JournalPads,
        LinePivot,
        OnePad,
        PadHousing,
        PadJournalLimits,
        PadJournalMaterials,
        PadJournalWalls,
        PadOilSupply,
        PadOperatingPoint,
        PadPedestal,
        PadStructure,
        PivotPoint,
        PointPivot,
        RigidPivot,
        RockerPivot,
        SpringPivot,
        TablePivot,
    )
    from babbitt.case import (
        CaseError,
        template,
    )
    from babbitt.core.notices import (
        InputError,
    )
    from babbitt.properties.lubricants import (
        lubricant,
    )

__version__ = "0.2.0"

_NAMES = {
    "babbitt.api.answers": "solve",
    "babbitt.api.batch": "solve_batch",
    "babbitt.api.bearings": (
        "Footstep HydrostaticJournal HydrostaticPad JackingPocket JournalBearing Machine "
        "OverhungCoupling Shaft ThrustBearing ThrustLine ThrustRing TiltingPadBearing"
    ),
    "babbitt.api.cases": "load_case parse_case",
    "babbitt.api.clearances": "diametral_clearance fit grooves radial_clearance relative_clearance",
    "babbitt.api.common_parts": (
        "CatalogueLubricant Column ComplianceMatrix ConstantLubricant Cooling CylinderHousing Deviations "
        "DiametralClearance DrawingSurfaces ExponentialLubricant FeedHole Fit Friction HalfSpace "
        "InMachine IsoVgLubricant Limits Materials Metal PedestalHousing PowerLawLubricant "
        "RadialClearance RelativeClearance Ring SizeLimits Structure Supply Surfaces TableLubricant Tube "
        "TwoPointLubricant ViscosityIndexLubricant VogelLubricant WaltherLubricant"
    ),
    "babbitt.api.designing": "design_bearing",
    "babbitt.api.designs": "compare",
    "babbitt.api.footstep_parts": "FigureRanges Heel FootstepGroove FootstepOil FootstepOptions FootstepWall",
    "babbitt.api.hydrostatic_parts": (
        "AnnularPad Capillary CircularPad ConstantFlow FlowValve HydrostaticOil HydrostaticSupply "
        "MembraneValve MeteredFlow Orifice RecessOil RecessRow RectangularPad Slot"
    ),
    "babbitt.api.journal_parts": (
        "ConductingBush ConductingHousing ConductingJournal Displacement EdgeCrowning Groove "
        "GrooveElement HeatExchange Hole HoleElement Liner LoadTable Lobes MeasuredBore Misalignment "
        "MixedFriction OilLine OilPump OilSystem OperatingPoint ParabolicCrowning Pocket PocketElement Position "
        "PressureDam PressureViscosity PumpPoint Relief RotatingLoad RoundBore SegmentOptions SlotElement Step "
        "TableCrowning TaperedBore UnevenPockets Walls WornBore"
    ),
    "babbitt.api.methods": "Film Iso7902 LongFilm Segments",
    "babbitt.api.catalogue": "explain lubricants materials published_cases validate",
    "babbitt.api.own_bore": "Gap",
    "babbitt.api.own_viscosity": "viscosity_law",
    "babbitt.api.pad_batch": "solve_pad_batch",
    "babbitt.api.shaft_parts": "Coupling Gear ShaftForce ShaftMass ShaftSupport",
    "babbitt.api.stored_studies": "open_study",
    "babbitt.api.thrust_parts": (
        "FilmHeatBalance FilmTemperature FilmViscosity FixedPad LineLimits PadMaterials Pads Propeller "
        "Runout Seating ShaftPiece SpeedRange StepFace Taper ThrustRipple Tilt TiltingPivot"
    ),
    "babbitt.api.tilting_pad_parts": (
        "ConductingPads FlexurePivot JournalPads LinePivot OnePad PadHousing PadJournalLimits "
        "PadJournalMaterials PadJournalWalls PadOilSupply PadOperatingPoint PadPedestal PadStructure PivotPoint "
        "PointPivot RigidPivot RockerPivot SpringPivot TablePivot"
    ),
    "babbitt.case": "CaseError template",
    "babbitt.core.notices": "InputError",
    "babbitt.properties.lubricants": "lubricant",
}
"""What is public, by the module where it stands."""

_HOMES = {name: module for module, names in _NAMES.items() for name in names.split()}

__all__ = [
    "AnnularPad",
    "Capillary",
    "CaseError",
    "CatalogueLubricant",
    "CircularPad",
    "Column",
    "ComplianceMatrix",
    "ConductingBush",
    "ConductingHousing",
    "ConductingJournal",
    "ConductingPads",
    "ConstantFlow",
    "ConstantLubricant",
    "Cooling",
    "Coupling",
    "CylinderHousing",
    "Deviations",
    "DiametralClearance",
    "Displacement",
    "DrawingSurfaces",
    "EdgeCrowning",
    "ExponentialLubricant",
    "FeedHole",
    "FigureRanges",
    "Film",
    "FilmHeatBalance",
    "FilmTemperature",
    "FilmViscosity",
    "Fit",
    "FixedPad",
    "FlexurePivot",
    "FlowValve",
    "Footstep",
    "Friction",
    "Gap",
    "Gear",
    "Groove",
    "GrooveElement",
    "HalfSpace",
    "HeatExchange",
    "Heel",
    "FootstepGroove",
    "FootstepOil",
    "FootstepOptions",
    "FootstepWall",
    "Hole",
    "HoleElement",
    "HydrostaticJournal",
    "HydrostaticOil",
    "HydrostaticPad",
    "HydrostaticSupply",
    "InMachine",
    "InputError",
    "Iso7902",
    "IsoVgLubricant",
    "JackingPocket",
    "JournalBearing",
    "JournalPads",
    "Limits",
    "LineLimits",
    "LinePivot",
    "Liner",
    "LoadTable",
    "Lobes",
    "LongFilm",
    "Machine",
    "Materials",
    "MeasuredBore",
    "MembraneValve",
    "Metal",
    "MeteredFlow",
    "Misalignment",
    "MixedFriction",
    "OilLine",
    "OilPump",
    "OilSystem",
    "OnePad",
    "OperatingPoint",
    "Orifice",
    "OverhungCoupling",
    "PadHousing",
    "PadJournalLimits",
    "PadJournalMaterials",
    "PadJournalWalls",
    "PadMaterials",
    "PadOilSupply",
    "PadOperatingPoint",
    "PadPedestal",
    "PadStructure",
    "Pads",
    "ParabolicCrowning",
    "PedestalHousing",
    "PivotPoint",
    "Pocket",
    "PocketElement",
    "PointPivot",
    "Position",
    "PowerLawLubricant",
    "PressureDam",
    "PressureViscosity",
    "PumpPoint",
    "Propeller",
    "RecessOil",
    "RecessRow",
    "RectangularPad",
    "RadialClearance",
    "RelativeClearance",
    "Relief",
    "RigidPivot",
    "Ring",
    "RockerPivot",
    "RotatingLoad",
    "RoundBore",
    "Runout",
    "Seating",
    "SegmentOptions",
    "Segments",
    "Shaft",
    "ShaftForce",
    "ShaftMass",
    "ShaftPiece",
    "ShaftSupport",
    "SizeLimits",
    "Slot",
    "SlotElement",
    "SpeedRange",
    "SpringPivot",
    "Step",
    "StepFace",
    "Structure",
    "Supply",
    "Surfaces",
    "TableCrowning",
    "TableLubricant",
    "TablePivot",
    "Taper",
    "TaperedBore",
    "ThrustBearing",
    "ThrustLine",
    "ThrustRing",
    "ThrustRipple",
    "Tilt",
    "TiltingPadBearing",
    "TiltingPivot",
    "Tube",
    "TwoPointLubricant",
    "UnevenPockets",
    "ViscosityIndexLubricant",
    "VogelLubricant",
    "Walls",
    "WaltherLubricant",
    "WornBore",
    "__version__",
    "design_bearing",
    "compare",
    "diametral_clearance",
    "explain",
    "fit",
    "grooves",
    "load_case",
    "lubricant",
    "lubricants",
    "materials",
    "open_study",
    "parse_case",
    "published_cases",
    "radial_clearance",
    "relative_clearance",
    "solve",
    "solve_batch",
    "solve_pad_batch",
    "template",
    "validate",
    "viscosity_law",
]


def __getattr__(name: str) -> Any:
    """Import what is public when it is first asked for, so that `import babbitt` stays light."""
    from importlib import import_module

    if name not in _HOMES:
        raise AttributeError(f"module 'babbitt' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    """What is public, asked for before or not."""
    return sorted({*globals(), *__all__})
