"""Parts of a tilting-pad journal bearing.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.tilting_pad_journal.case import bearing, pads, pivots

__all__ = [
    "FlexurePivot",
    "JournalPads",
    "LinePivot",
    "OnePad",
    "PadJournalLimits",
    "PadLining",
    "PadOilSupply",
    "PadOperatingPoint",
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


class PadLining(OwnPart, bearing.PadLining):
    """What the pads are lined with."""


class PadJournalLimits(OwnPart, bearing.PadJournalLimits):
    """Limits in place of those by experience."""


class PadOperatingPoint(OwnPart, bearing.PadOperatingPoint):
    """One of several operating points. What it does not give is taken from the bearing."""
