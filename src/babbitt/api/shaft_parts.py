"""Parts of a shaft.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.shaft.case import bearings, parts

__all__ = ["Coupling", "Gear", "ShaftForce", "ShaftMass", "ShaftSupport"]


class Gear(OwnPart, parts.GearInput):
    """An external spur or helical gear on a shaft."""


class Coupling(OwnPart, parts.CouplingInput):
    """A coupling on a shaft, which hands on torque and weighs on it."""


class ShaftMass(OwnPart, parts.MassInput):
    """A mass on a shaft."""


class ShaftForce(OwnPart, parts.ForceInput):
    """A force, or a couple, on a shaft."""


class ShaftSupport(OwnPart, bearings.SupportInput):
    """A bearing of a shaft of which the load alone is asked for."""
