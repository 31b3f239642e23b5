"""Parts that several kinds of bearings have: clearance, supply, oil, materials, housing, compliance.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.case.parts import choices, clearance, compliance, cooling, lubricant, materials, supply, surfaces

__all__ = [
    "CatalogueLubricant",
    "Column",
    "ComplianceMatrix",
    "ConstantLubricant",
    "Cooling",
    "CylinderHousing",
    "Deviations",
    "DiametralClearance",
    "DrawingSurfaces",
    "ExponentialLubricant",
    "FeedHole",
    "Fit",
    "Friction",
    "HalfSpace",
    "InMachine",
    "IsoVgLubricant",
    "Limits",
    "Materials",
    "Metal",
    "PedestalHousing",
    "PowerLawLubricant",
    "RadialClearance",
    "RelativeClearance",
    "Ring",
    "SizeLimits",
    "Structure",
    "Supply",
    "Surfaces",
    "TableLubricant",
    "Tube",
    "TwoPointLubricant",
    "ViscosityIndexLubricant",
    "VogelLubricant",
    "WaltherLubricant",
]


class RelativeClearance(OwnPart, clearance.RelativeClearance):
    """Diametral clearance over diameter."""


class RadialClearance(OwnPart, clearance.RadialClearance):
    """Radius of the bore minus that of the journal."""


class DiametralClearance(OwnPart, clearance.DiametralClearance):
    """Bore minus journal diameter."""


class Fit(OwnPart, clearance.FitClearance):
    """ISO 286 tolerance classes."""


class SizeLimits(OwnPart, clearance.LimitsClearance):
    """Limits of size as they stand on the drawing."""


class Deviations(OwnPart, clearance.DeviationsClearance):
    """Deviations from the diameter as they stand on the drawing."""


class Supply(OwnPart, supply.Supply):
    """Oil fed under pressure. A bearing may give single fields and take the others from its machine."""


class Tube(OwnPart, supply.Tube):
    """A tube between the supply system and the bearing."""


class FeedHole(OwnPart, supply.FeedHole):
    """A hole through the shell or housing."""


class Cooling(OwnPart, cooling.Cooling):
    """Heat given to the surroundings. A bearing may give single fields and take the others from its machine."""


class CylinderHousing(OwnPart, cooling.CylinderHousing):
    """A cylindrical housing."""


class PedestalHousing(OwnPart, cooling.PedestalHousing):
    """A pedestal bearing."""


class InMachine(OwnPart, cooling.InMachine):
    """A bearing inside a machine."""


class Materials(OwnPart, materials.Materials):
    """Materials. A bearing may give single fields and take the others from its machine."""


class Structure(OwnPart, materials.Structure):
    """Material of a shell or a shaft: a name of the catalogue, or its thermal expansion."""


class Metal(OwnPart, materials.Metal):
    """A bearing metal: a name of the catalogue, or a metal of one's own with its limits."""


class Surfaces(OwnPart, surfaces.DirectSurfaces):
    """Tilt and waviness as they are."""


class DrawingSurfaces(OwnPart, surfaces.DrawingSurfaces):
    """Tilt and waviness from the form tolerances of the drawing."""


class Column(OwnPart, compliance.ColumnInput):
    """A thin liner, of which every spot gives way by itself."""


class Ring(OwnPart, compliance.RingInput):
    """Bush or housing as a thick elastic ring."""


class HalfSpace(OwnPart, compliance.HalfSpaceInput):
    """A massive housing."""


class ComplianceMatrix(OwnPart, compliance.MatrixInput):
    """A matrix of compliance that was calculated or measured elsewhere."""


class Friction(OwnPart, choices.FrictionInput):
    """Where the film rubs."""


class Limits(OwnPart, choices.LimitsInput):
    """Limits in place of those by experience."""


class CatalogueLubricant(OwnPart, lubricant.CatalogueLubricant):
    """A lubricant of the catalogue. Its name alone will do."""


class IsoVgLubricant(OwnPart, lubricant.IsoVgLubricant):
    """An ISO viscosity grade of ISO 3448."""


class ViscosityIndexLubricant(OwnPart, lubricant.ViscosityIndexLubricant):
    """An oil by its viscosity at 40 degC and its viscosity index."""


class TwoPointLubricant(OwnPart, lubricant.TwoPointLubricant):
    """An oil by two kinematic viscosities, at 40 and 100 degC or at other temperatures."""


class WaltherLubricant(OwnPart, lubricant.WaltherLubricant):
    """An oil by the constants of Walther's law, as studies and older data sheets print them."""


class VogelLubricant(OwnPart, lubricant.VogelLubricant):
    """An oil by Vogel's law, through three points or by its constants."""


class ExponentialLubricant(OwnPart, lubricant.ExponentialLubricant):
    """An oil by Reynolds' exponential law through two points, good between them only."""


class TableLubricant(OwnPart, lubricant.TableLubricant):
    """An oil by a table of viscosities, with Andrade's law from point to point."""


class PowerLawLubricant(OwnPart, lubricant.PowerLawLubricant):
    """An oil by the power law nu = nu50 (50/t)^m with t in degC."""


class ConstantLubricant(OwnPart, lubricant.ConstantLubricant):
    """A fluid of the same viscosity at every temperature."""
