"""What the ISO 7902 procedure needs to know: SI numbers and chosen methods, nothing of files or units."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum
from typing import TYPE_CHECKING

from babbitt.core.notices import Notice
from babbitt.design.conditions import (
    HousingCooling,
    Limits,
    OilSupply,
    PrescribedEccentricity,
    PrescribedLoad,
    Proportions,
    Surfaces,
)
from babbitt.kinds.journal.iso7902.supply import CircumferentialGroove, SupplyElement
from babbitt.properties.lubricants import Lubricant
from babbitt.properties.materials import BearingMetal, LoadCharacter

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.model import FilmCase

__all__ = [
    "Bearing",
    "Curves",
    "DesignCase",
    "FreeArc",
    "Friction",
    "PrescribedEccentricity",
    "PrescribedLoad",
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

    `clearance_tolerance` holds the least and the greatest relative clearance where a tolerance is known. A groove
    around the whole circumference parts the bearing: the standard takes it for two half bearings side by side,
    each with half the load.
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
    mean_clearance: float | None = None
    axis_slope: float = 0.0

    @property
    def parts(self) -> int:
        """Bearings side by side that share the load: two half ones beside a circumferential groove, else one."""
        return 2 if isinstance(self.supply_element, CircumferentialGroove) else 1

    @property
    def loaded_width(self) -> float:
        """Width of all parts together in m: that of the bearing less that of a groove which parts it."""
        if isinstance(self.supply_element, CircumferentialGroove):
            return self.width - self.supply_element.width
        return self.width

    @property
    def part_width(self) -> float:
        """Width of one part in m."""
        return self.loaded_width / self.parts

    @property
    def part_width_ratio(self) -> float:
        """Width of one part over the diameter, for which the characteristics are taken."""
        return self.part_width / self.diameter


@dataclass(frozen=True)
class FreeArc:
    """Centred arc in rad that pockets or grooves leave to the loaded film, and which ones, in words.

    `certain` where the case says the places for this method alone: an arc too short for the tables has no verdict.
    """

    extent: float
    left_by: str
    certain: bool = True


@dataclass(frozen=True)
class DesignCase:
    """One bearing at one operating point with all choices made.

    Speeds in rad/s. `free_arcs` are those that pockets and grooves leave about the load, where known. At least
    one of `oil_supply` and `cooling` carries the heat away, unless the effective temperature (K) is
    prescribed. `given` holds names and words of the case that these numbers came from (a fit, a material), for
    the report. `warnings` arose while the case was made and ride along to the result. `clearance_limits` are
    relative clearances at 20 °C at which no other case of the bearing is: what keeps its limits is solved there,
    too. `fuller_film` has temperatures of its own and must keep the limits of the same bearing; None where it is
    not known, or not asked for.
    """

    name: str
    bearing: Bearing
    duty: PrescribedLoad | PrescribedEccentricity
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
    warnings: tuple[Notice, ...] = ()
    kind: str = "journal"
    effective_temperature: float | None = None
    load_angle: float | None = None
    free_arcs: tuple[FreeArc, ...] = ()
    rotor_mass: float | None = None
    clearance_limits: tuple[float, float] | None = None
    fuller_film: FilmCase | None = field(default=None, compare=False)

    def fed_by(self, supply: OilSupply) -> DesignCase:
        """The bearing with another supply, and the film that it is held against."""
        film = self.fuller_film
        return replace(self, oil_supply=supply, fuller_film=None if film is None else film.fed_by(supply))

    def at_clearance(self, relative: float) -> DesignCase:
        """The bearing with a clearance over diameter at 20 °C, and the film that it is held against."""
        film = self.fuller_film
        return replace(
            self,
            bearing=replace(self.bearing, relative_clearance=relative),
            clearance_limits=None,
            fuller_film=None if film is None else film.at_clearance(relative),
        )
