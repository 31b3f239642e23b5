"""The shaft line from the propeller to the collar, and what the thrust block stands on."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError

__all__ = ["Rod", "Seating", "ShaftLine"]


@dataclass(frozen=True)
class Rod:
    """A uniform piece of shaft.

    Attributes
    ----------
    length, area : float
        m, m2.
    modulus : float
        E, Pa.
    density : float
        kg/m3.
    """

    length: float
    area: float
    modulus: float
    density: float

    def __post_init__(self) -> None:
        _require_positive("rod", length=self.length, area=self.area, modulus=self.modulus, density=self.density)

    @property
    def mass(self) -> float:
        """kg."""
        return self.density * self.area * self.length

    @property
    def stiffness(self) -> float:
        """E A/l, N/m."""
        return self.modulus * self.area / self.length

    @property
    def transit_time(self) -> float:
        """l/a: time a longitudinal wave takes, s."""
        return self.length * math.sqrt(self.density / self.modulus)


@dataclass(frozen=True)
class Seating:
    """What carries the housing: stiffness (N/m) and damping (N s/m) to the hull, mass of the housing (kg)."""

    stiffness: float
    damping: float = 0.0
    housing_mass: float = 0.0

    def __post_init__(self) -> None:
        _require_positive("seating", stiffness=self.stiffness)
        _require_not_negative("seating", damping=self.damping, housing_mass=self.housing_mass)


@dataclass(frozen=True)
class ShaftLine:
    """Masses and rods from the propeller (first) to the collar (last).

    Attributes
    ----------
    propeller_mass : float
        m1 with entrained water, kg; 0 for the free end of a shaft without propeller.
    propeller_damping : float
        b0, N s/m.
    rods : tuple of Rod
        In series; empty for a rigid shaft.
    joint_masses : tuple of float
        kg, at the joints between the rods; one less than the rods, or empty for none.
    collar_mass : float
        m2 with all that is axially rigid to it, kg.
    seating : Seating or None
        None: rigid.
    """

    propeller_mass: float
    propeller_damping: float
    rods: tuple[Rod, ...]
    collar_mass: float
    joint_masses: tuple[float, ...] = ()
    seating: Seating | None = None

    def __post_init__(self) -> None:
        _require_positive("shaft line", collar_mass=self.collar_mass)
        _require_not_negative(
            "shaft line", propeller_mass=self.propeller_mass, propeller_damping=self.propeller_damping
        )
        if self.joint_masses and len(self.joint_masses) != len(self.rods) - 1:
            raise InputError(
                "E203",
                f"{len(self.joint_masses)} joint masses are given for {len(self.rods)} rods; "
                "allowed: one less than the rods.",
            )

    @property
    def shaft_mass(self) -> float:
        """m3, kg."""
        return sum(rod.mass for rod in self.rods) + sum(self.joint_masses)

    @property
    def masses(self) -> tuple[float, ...]:
        """Point masses at the joints from the propeller to the collar, kg; the only one of a rigid shaft."""
        if not self.rods:
            return (self.propeller_mass + self.collar_mass,)
        between = self.joint_masses or (0.0,) * (len(self.rods) - 1)
        return (self.propeller_mass, *between, self.collar_mass)

    def rigid(self) -> ShaftLine:
        """The same line with all its mass in the collar (stages 1 and 2)."""
        return replace(self, rods=(), joint_masses=(), collar_mass=self.collar_mass + self.shaft_mass)


def _require_positive(what: str, **values: float) -> None:
    for name, value in values.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError("E203", f"{name} of the {what} is {value:g}; it must be a positive number.")


def _require_not_negative(what: str, **values: float) -> None:
    for name, value in values.items():
        if not (math.isfinite(value) and value >= 0.0):
            raise InputError("E203", f"{name} of the {what} is {value:g}; it must be 0 or more.")
