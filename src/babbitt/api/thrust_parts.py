"""Parts of a thrust bearing and of a shaft line on it.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.shaft_line.case import shaft_line
from babbitt.kinds.thrust.case import runout, thrust_oil, thrust_pads

__all__ = [
    "FilmHeatBalance",
    "FilmTemperature",
    "FilmViscosity",
    "FixedPad",
    "LineLimits",
    "PadMaterials",
    "Pads",
    "Propeller",
    "Runout",
    "Seating",
    "ShaftPiece",
    "SpeedRange",
    "StepFace",
    "Taper",
    "ThrustRipple",
    "Tilt",
    "TiltingPivot",
]


class TiltingPivot(OwnPart, thrust_pads.TiltingPivot):
    """A pad that tilts without friction about a point, or about a line along the radius."""


class FixedPad(OwnPart, thrust_pads.FixedPad):
    """A pad that does not tilt."""


class Taper(OwnPart, thrust_pads.TaperFace):
    """A taper before a land."""


class StepFace(OwnPart, thrust_pads.StepFace):
    """A step before a land."""


class Pads(OwnPart, thrust_pads.ThrustPads):
    """Equal pads on a ring."""


class PadMaterials(OwnPart, thrust_pads.PadMaterials):
    """What the pads are made of."""


class Tilt(OwnPart, thrust_pads.Tilt):
    """Tilt of the housing against the collar."""


class FilmViscosity(OwnPart, thrust_oil.PrescribedViscosity):
    """The viscosity of the films is known."""


class FilmTemperature(OwnPart, thrust_oil.OilAtTemperature):
    """The effective temperature of the films is known."""


class FilmHeatBalance(OwnPart, thrust_oil.OilByBalance):
    """The effective temperature follows from friction and flow."""


class Runout(OwnPart, runout.Runout):
    """Runout or waviness of the collar face."""


class Propeller(OwnPart, shaft_line.Propeller):
    """The propeller."""


class ShaftPiece(OwnPart, shaft_line.ShaftPiece):
    """A uniform piece of shaft."""


class Seating(OwnPart, shaft_line.SeatingInput):
    """What carries the housing of the thrust block."""


class ThrustRipple(OwnPart, shaft_line.ThrustRipple):
    """One harmonic of the thrust."""


class SpeedRange(OwnPart, shaft_line.SpeedRange):
    """Speeds at which the line is solved, with a Campbell map."""


class LineLimits(OwnPart, shaft_line.LineLimits):
    """Admissible values of the motion."""
