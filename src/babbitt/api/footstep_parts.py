"""Parts of the footstep of a screw.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.footstep.case import footstep_parts

__all__ = [
    "FigureRanges",
    "Heel",
    "HeelGroove",
    "HeelOil",
    "HeelOptions",
    "HeelWall",
]


class Heel(OwnPart, footstep_parts.HeelPart):
    """Lengths of the heel and of the recess in its face."""


class HeelGroove(OwnPart, footstep_parts.GroovePart):
    """The screw groove on the heel."""


class HeelOil(OwnPart, footstep_parts.HeelOilPart):
    """Oil whose viscosity falls exponentially: mu = viscosity exp(-exponent (T - temperature))."""


class HeelWall(OwnPart, footstep_parts.WallPart):
    """Metal that takes heat from the films (`method: narrow_groove`)."""


class HeelOptions(OwnPart, footstep_parts.HeelOptionsPart):
    """What the study leaves open, or prints otherwise; the defaults are the consistent choices."""


class FigureRanges(OwnPart, footstep_parts.FigureRanges):
    """Ranges of the curves in report and plots."""
