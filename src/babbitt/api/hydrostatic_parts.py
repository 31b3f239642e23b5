"""Parts of hydrostatic bearings.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.hydrostatic.case import pad_shapes, recess_parts, restrictors, supply

__all__ = [
    "AnnularPad",
    "Capillary",
    "CircularPad",
    "ConstantFlow",
    "FlowValve",
    "HydrostaticOil",
    "HydrostaticSupply",
    "MembraneValve",
    "MeteredFlow",
    "Orifice",
    "RecessOil",
    "RecessRow",
    "RectangularPad",
    "Slot",
]


class Capillary(OwnPart, restrictors.CapillaryInput):
    """A round tube before every recess."""


class Orifice(OwnPart, restrictors.OrificeInput):
    """A sharp-edged hole before every recess."""


class Slot(OwnPart, restrictors.SlotInput):
    """A flat slot before every recess."""


class ConstantFlow(OwnPart, restrictors.ConstantFlowInput):
    """A pump for every recess."""


class MeteredFlow(OwnPart, restrictors.MeteredFlowInput):
    """A metering stage before every recess, fed by the common supply."""


class FlowValve(OwnPart, restrictors.FlowValveInput):
    """A pressure-compensating valve before every recess: more oil where the recess pressure rises."""


class MembraneValve(OwnPart, restrictors.MembraneValveInput):
    """A membrane valve before every recess: its gap opens with the recess pressure."""


class HydrostaticSupply(OwnPart, supply.HydrostaticSupply):
    """Oil before the restrictors: at a fixed pressure, or from one pump."""


class HydrostaticOil(OwnPart, recess_parts.HydrostaticOil):
    """The oil: its numbers, or a lubricant at a temperature."""


class RecessOil(OwnPart, recess_parts.RecessOil):
    """Depth of the recesses and the oil that gives way in them."""


class RecessRow(OwnPart, recess_parts.RecessRow):
    """Equal recesses around the axis."""


class CircularPad(OwnPart, pad_shapes.CircularInput):
    """A round pad with a round recess in the middle."""


class AnnularPad(OwnPart, pad_shapes.AnnularInput):
    """A ring with an annular recess."""


class RectangularPad(OwnPart, pad_shapes.RectangularInput):
    """A rectangle with a rectangular recess in the middle."""
