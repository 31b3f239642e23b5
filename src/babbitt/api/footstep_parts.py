"""Parts of the footstep of a screw.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.footstep.case import footstep_parts

__all__ = [
    "FigureRanges",
    "Heel",
    "FootstepGroove",
    "FootstepOil",
    "FootstepOptions",
    "FootstepWall",
]


class Heel(OwnPart, footstep_parts.HeelInput):
    """Lengths of the heel and of the recess in its face."""


class FootstepGroove(OwnPart, footstep_parts.GroovePart):
    """The screw groove on the heel."""


class FootstepOil(OwnPart, footstep_parts.FootstepOilInput):
    """Oil whose viscosity falls exponentially: mu = viscosity exp(-exponent (T - temperature))."""


class FootstepWall(OwnPart, footstep_parts.WallPart):
    """Metal that takes heat from the films (`method: narrow_groove`)."""


class FootstepOptions(OwnPart, footstep_parts.FootstepOptionsInput):
    """What the study leaves open, or prints otherwise; the defaults are the consistent choices."""


class FigureRanges(OwnPart, footstep_parts.FigureRanges):
    """Ranges of the curves in report and plots."""
