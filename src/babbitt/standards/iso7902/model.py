"""What the ISO 7902 procedure needs to know: SI numbers and chosen methods, nothing of files or units."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from babbitt.design.conditions import (
    GivenEccentricity,
    GivenLoad,
    HousingCooling,
    Limits,
    OilSupply,
    Proportions,
    Surfaces,
)
from babbitt.lubricants import Lubricant
from babbitt.materials import BearingMetal, LoadCharacter
from babbitt.notices import Notice
from babbitt.standards.iso7902.supply import SupplyElement

__all__ = [
    "Bearing",
    "Curves",
    "DesignCase",
    "Friction",
    "GivenEccentricity",
    "GivenLoad",
    "HousingCooling",
    "Limits",
    "OilSupply",
    "Surfaces",
]


class Friction(Enum):
    """Where the film rubs.

    FULL: film around the whole circumference (default). ARC: film on the loaded arc only.
    CURVE360: friction number of the full bearing at the same eccentricity, as a published gearbox study has it.
    """

    FULL = "full"
    ARC = "arc"
    CURVE360 = "curve360"


class Curves(Enum):
    """Which characteristics: our own Reynolds solutions, or the closed forms of DIN 31652 (360° only)."""

    COMPUTED = "computed"
    CLOSED_FORM = "closed_form"


@dataclass(frozen=True)
class Bearing(Proportions):
    """A circular cylindrical bearing; lengths in m, clearance at 20 °C, span in degrees of a tabulated arc.

    `clearance_tolerance` holds the least and the greatest relative clearance where a tolerance is known.
    """

    diameter: float
    width: float
    relative_clearance: float
    span: int
    expansion_bearing: float
    expansion_journal: float
    supply_element: SupplyElement | None = None
    surfaces: Surfaces | None = None
    metal: BearingMetal | None = None
    load_character: LoadCharacter = LoadCharacter.CALM
    clearance_tolerance: tuple[float, float] | None = None


@dataclass(frozen=True)
class DesignCase:
    """One bearing at one operating point with all choices made.

    Speeds in rad/s. At least one of `oil_supply` and `cooling` carries the heat away, unless the effective
    temperature (K) is prescribed. `given` holds names and
    words of the case that these numbers came from (a fit, a material), for the report. `doubts` arose while the
    case was made and ride along to the result.
    """

    name: str
    bearing: Bearing
    duty: GivenLoad | GivenEccentricity
    journal_speed: float
    lubricant: Lubricant
    oil_supply: OilSupply | None = None
    cooling: HousingCooling | None = None
    bearing_speed: float = 0.0
    friction: Friction = Friction.FULL
    friction_factor: float = 1.0
    curves: Curves = Curves.COMPUTED
    limits: Limits = field(default_factory=Limits)
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    doubts: tuple[Notice, ...] = ()
    kind: str = "journal"
    effective_temperature: float | None = None
    load_angle: float | None = None
