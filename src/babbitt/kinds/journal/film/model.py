"""What a film design check needs to know: SI numbers and chosen methods, nothing of files or units."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from enum import Enum

from babbitt.core.notices import Notice
from babbitt.design.asperity_contact import AsperityContact
from babbitt.design.conditions import (
    HousingCooling,
    Limits,
    LoadSpec,
    OilSupply,
    PrescribedLoad,
    Proportions,
    Surfaces,
)
from babbitt.kinds.journal.film.bore import Bore, RoundBore
from babbitt.kinds.journal.film.changing_load import ChangingLoad
from babbitt.kinds.journal.film.heat_model import HeatModel
from babbitt.properties.lubricants import Lubricant
from babbitt.properties.materials import BearingMetal, LoadCharacter
from babbitt.reynolds.deformation.compliance import Compliance
from babbitt.reynolds.model import DRAFT, ENGINEERING, REFERENCE, Cavitation, FilmStart, Resolution, Step
from babbitt.reynolds.model import Field as FieldOfFilm
from babbitt.reynolds.oil.piezoviscosity import Barus, PressureViscosity, Roelands
from babbitt.reynolds.oil.turbulence import TurbulenceLaw

__all__ = ["Accuracy", "FilmBearing", "FilmCase", "FeedSize", "Rotation", "Search"]


WHOLE_TURN = 2.0 * math.pi * (1.0 - 1e-9)
"""Extent of a feed, rad, from which it parts the bearing."""


class Accuracy(Enum):
    """How fine the grid of the film is."""

    DRAFT = "draft"
    ENGINEERING = "engineering"
    REFERENCE = "reference"

    @property
    def resolution(self) -> Resolution:
        """Grid of the film engine."""
        return {"draft": DRAFT, "engineering": ENGINEERING, "reference": REFERENCE}[self.value]


class Rotation(Enum):
    """Sense in which the journal turns, seen against the z axis (x right, y up)."""

    COUNTER_CLOCKWISE = "counter_clockwise"
    CLOCKWISE = "clockwise"

    @property
    def sense(self) -> float:
        """1 or -1."""
        return 1.0 if self is Rotation.COUNTER_CLOCKWISE else -1.0


class Search(Enum):
    """Whether further equilibria of the journal are looked for."""

    AUTO = "in lobed bores, and between grooves whose pressure rivals that of the wedge"
    ALL = "always"
    FIRST = "never"


class PressureLaw(Enum):
    """How the viscosity grows with pressure."""

    BARUS = "barus"
    ROELANDS = "roelands"


@dataclass(frozen=True)
class OilUnderPressure:
    """Law of viscosity and pressure with its slope alpha = d ln mu / dp at ambient pressure, 1/Pa."""

    law: PressureLaw
    coefficient: float

    def at(self, viscosity: float) -> PressureViscosity:
        """Law at an ambient viscosity in Pa s."""
        if self.law is PressureLaw.BARUS:
            return Barus(self.coefficient)
        return Roelands(self.coefficient, viscosity)


@dataclass(frozen=True)
class FeedSize:
    """A groove, pocket or hole that feeds the film.

    Attributes
    ----------
    angle, extent : float
        Of the centre and around the bore, rad, counter-clockwise from +x.
    width : float or None
        Along the shaft, m; None reaches over the whole bearing (axial groove).
    axial_position : float
        Of the centre from the mid-plane, m.
    pressure : float or None
        Gauge, Pa; None is that of the oil supply behind its losses.
    flow : float or None
        m3/s in place of a pressure; 0 closes a feed narrower than the bearing.
    bore_hole : float or None
        Diameter in m of a round hole, through which the oil comes; None for grooves and pockets.
    """

    angle: float
    extent: float
    width: float | None = None
    axial_position: float = 0.0
    pressure: float | None = None
    flow: float | None = None
    bore_hole: float | None = None

    @property
    def is_closed(self) -> bool:
        """Whether nothing feeds it: it stands at the pressure at which its net flow vanishes."""
        return self.flow == 0.0

    @classmethod
    def hole(
        cls,
        angle: float,
        diameter: float,
        bore: float,
        axial_position: float = 0.0,
        pressure: float | None = None,
        flow: float | None = None,
    ) -> FeedSize:
        """A round hole as a square of the same area; ``bore`` is the diameter of the bearing, all m."""
        side = 0.5 * math.sqrt(math.pi) * diameter
        return cls(angle, 2.0 * side / bore, side, axial_position, pressure, flow, diameter)


@dataclass(frozen=True)
class FilmBearing(Proportions):
    """A journal bearing as the film sees it; lengths in m, clearance at 20 °C.

    `misalignment` holds the slopes dx/dz and dy/dz of the journal axis in rad. `clearance_tolerance` holds the
    least and the greatest relative clearance where a tolerance is known. `steps`, `crowning`, `displacement` and
    `side_pressures` are those of `babbitt.reynolds.model.JournalFilm`; steps that belong to the bore stand there.
    `displacement_start` is the angle of the first row of `displacement`, rad; `own_form` says what form of the
    bore the displacement is, empty where it is none.
    `compliance` is what the bore gives way by (`babbitt.reynolds.deformation.compliance`); all of it adds up.
    """

    diameter: float
    width: float
    relative_clearance: float
    expansion_bearing: float
    expansion_journal: float
    feeds: tuple[FeedSize, ...] = ()
    bore: Bore = field(default_factory=RoundBore)
    film_start: FilmStart = FilmStart.GROOVE
    misalignment: tuple[float, float] = (0.0, 0.0)
    steps: tuple[Step, ...] = ()
    crowning: tuple[float, ...] = ()
    displacement: FieldOfFilm = ()
    displacement_start: float = 0.0
    own_form: str = ""
    compliance: tuple[Compliance, ...] = ()
    side_pressures: tuple[float, float] = (0.0, 0.0)
    surfaces: Surfaces | None = None
    metal: BearingMetal | None = None
    load_character: LoadCharacter = LoadCharacter.CALM
    clearance_tolerance: tuple[float, float] | None = None
    mean_clearance: float | None = None

    @property
    def is_narrowed(self) -> bool:
        """Whether tilt of the journal or the form of the bore narrows the gap by a length of its own."""
        return self.misalignment != (0.0, 0.0) or bool(self.crowning) or bool(self.displacement)

    @property
    def loaded_width(self) -> float:
        """Width in m over which the film carries: that of the lands beside grooves around the whole bore."""
        around = (one.width for one in self.feeds if one.extent > WHOLE_TURN and one.width is not None)
        return self.width - sum(around)


@dataclass(frozen=True)
class FilmCase:
    """One bearing at one operating point with all choices made.

    Speeds in rad/s, positive counter-clockwise; `load_angle` in rad from +x. At least one of `oil_supply`
    and `cooling` carries the heat away, unless `effective_temperature` (K) is prescribed. `rotor_mass` (kg) is the
    part of a rotor that this bearing carries, `shaft_stiffness` (N/m) the stiffness of the shaft between that mass
    and the journal; None is rigid. Without `turbulence` the film is laminar whatever its Reynolds number.
    `tilt_coefficients` asks for stiffness and damping against tilt, too, `error_estimate` for the error of the
    grid, `limiting_speeds` for those at which friction becomes mixed and the rotor whirls; the latter, which no
    limit knows, is not looked for either without `whirl_speed`.
    `changing_load` acts in addition to the load of the duty; `moving_mass` (kg) then moves with the journal.
    `warnings` arose while the case was made and ride along.
    With a model of its `heat` the film has its own temperatures; without, one temperature, and `fuller` is the
    model with which it would have its own, where these can be computed.
    `asperities` ask for the Stribeck curve with its mixed branch. `clearance_limits` are relative
    clearances at 20 °C at which no other case of the bearing is: what keeps its limits is solved there, too.
    """

    name: str
    bearing: FilmBearing
    duty: LoadSpec
    journal_speed: float
    lubricant: Lubricant
    oil_supply: OilSupply | None = None
    cooling: HousingCooling | None = None
    bearing_speed: float = 0.0
    load_angle: float = -math.pi / 2.0
    cavitation: Cavitation = Cavitation.MASS_CONSERVING
    cavitation_pressure: float = 0.0
    accuracy: Accuracy = Accuracy.ENGINEERING
    effective_temperature: float | None = None
    friction_factor: float = 1.0
    rotor_mass: float | None = None
    shaft_stiffness: float | None = None
    error_estimate: bool = False
    limiting_speeds: bool = True
    whirl_speed: bool = True
    changing_load: ChangingLoad | None = None
    moving_mass: float = 0.0
    search: Search = Search.AUTO
    tilt_coefficients: bool = False
    limits: Limits = field(default_factory=Limits)
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    kind: str = "journal"
    turbulence: TurbulenceLaw | None = None
    pressure_viscosity: OilUnderPressure | None = None
    heat: HeatModel | None = None
    fuller: HeatModel | None = None
    asperities: AsperityContact | None = None
    clearance_limits: tuple[float, float] | None = None

    def with_own_temperatures(self) -> FilmCase | None:
        """The case with a film that conserves its oil and has its own temperatures, and nothing besides it.

        None where that is not known, as beside an unloaded journal.
        """
        unloaded = isinstance(self.duty, PrescribedLoad) and self.duty.load == 0.0
        if self.fuller is None or unloaded:
            return None
        return replace(
            self, heat=self.fuller, fuller=None, cavitation=Cavitation.MASS_CONSERVING, changing_load=None,
            asperities=None, tilt_coefficients=False, error_estimate=False, limiting_speeds=False,
            friction_factor=1.0, clearance_limits=None,
        )  # fmt: skip

    def fed_by(self, supply: OilSupply) -> FilmCase:
        """The bearing with another supply."""
        return replace(self, oil_supply=supply)

    def at_clearance(self, relative: float) -> FilmCase:
        """The bearing with another clearance over diameter at 20 °C, and without limits of it."""
        return replace(self, bearing=replace(self.bearing, relative_clearance=relative), clearance_limits=None)

    @property
    def assumed_of_lubricant(self) -> tuple[str, ...]:
        """What is assumed of the oil, so far as these films use it."""
        if self.heat is not None:
            return self.lubricant.assumptions
        return self.lubricant.assumptions_but_of_conduction

    @property
    def rotation(self) -> Rotation:
        """Sense in which the film is sheared."""
        turns = self.journal_speed + self.bearing_speed
        return Rotation.COUNTER_CLOCKWISE if turns >= 0.0 else Rotation.CLOCKWISE
