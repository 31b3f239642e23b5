"""Parts of a tilting-pad journal bearing.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.tilting_pad_journal.case import bearing, heat, materials, pads, pedestal, pivots

__all__ = [
    "ConductingPads",
    "FlexurePivot",
    "JournalPads",
    "LinePivot",
    "OnePad",
    "PadHousing",
    "PadJournalLimits",
    "PadJournalMaterials",
    "PadJournalWalls",
    "PadOilSupply",
    "PadOperatingPoint",
    "PadPedestal",
    "PadStructure",
    "PivotPoint",
    "PointPivot",
    "RigidPivot",
    "RockerPivot",
    "SpringPivot",
    "TablePivot",
]


class JournalPads(OwnPart, pads.JournalPads):
    """Pads around a journal."""


class OnePad(OwnPart, pads.OnePad):
    """What one pad has of its own."""


class RigidPivot(OwnPart, pivots.RigidPivotInput):
    """A pivot that does not give way."""


class SpringPivot(OwnPart, pivots.SpringPivotInput):
    """A pivot of constant stiffness."""


class PointPivot(OwnPart, pivots.PointPivotInput):
    """A ball in a hollow, or a button on a plane: a contact of points."""


class LinePivot(OwnPart, pivots.LinePivotInput):
    """A cylinder along the pad in a hollow one: a contact of lines."""


class RockerPivot(OwnPart, pivots.RockerPivotInput):
    """A steel rocker by an empirical law."""


class TablePivot(OwnPart, pivots.TablePivotInput):
    """A pivot that was measured."""


class PivotPoint(OwnPart, pivots.PivotPoint):
    """One point of a measured pivot."""


class FlexurePivot(OwnPart, pivots.FlexureInput):
    """A web that carries the pad and bends with its tilt."""


class PadOilSupply(OwnPart, bearing.PadOilSupply):
    """Fresh oil of the pads."""


class PadJournalMaterials(OwnPart, materials.PadJournalMaterials):
    """What pads, their lining, journal and housing are made of."""


class PadStructure(OwnPart, materials.PadStructure):
    """Material of the pads behind their lining: a name of the catalogue, or numbers."""


class PadJournalWalls(OwnPart, heat.PadJournalWalls):
    """Pads, housing and journal, which take heat from full thermal films."""


class ConductingPads(OwnPart, heat.ConductingPadsInput):
    """The pads, which conduct heat from the films to their backs and edges."""


class PadHousing(OwnPart, heat.PadHousingInput):
    """The housing around the pads, which makes room as it grows."""


class PadJournalLimits(OwnPart, bearing.PadJournalLimits):
    """Limits in place of those by experience."""


class PadPedestal(OwnPart, pedestal.PedestalInput):
    """Pedestal and housing that give way under the bearing."""


class PadOperatingPoint(OwnPart, bearing.PadOperatingPoint):
    """One of several operating points. What it does not give is taken from the bearing."""
