"""What the ISO 7902 procedure needs to know: SI numbers and chosen methods, nothing of files or units."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from babbitt.lubricants import Lubricant
from babbitt.materials import BearingMetal, LoadCharacter
from babbitt.notices import Notice
from babbitt.standards.iso7902.losses import Duct
from babbitt.standards.iso7902.supply import SupplyElement


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
class Surfaces:
    """What keeps the surfaces apart at least: roughness, tilt, deflection, waviness; all in m.

    Attributes
    ----------
    roughness_bearing, roughness_journal : float
        Mean peak-to-valley height Rz.
    tilt_offset : float
        Offset of the journal axis over the bearing width.
    mean_deflection : float
        Of the journal within the bearing.
    waviness : float
        Wave height of both surfaces together.
    wave_factor : float
        Ratio E/G of the functions of effective waviness, which are not public; 1 is an assumption.
    """

    roughness_bearing: float
    roughness_journal: float
    tilt_offset: float = 0.0
    mean_deflection: float = 0.0
    waviness: float = 0.0
    wave_factor: float = 1.0

    @property
    def film_limit(self) -> float:
        """Permissible film thickness ``Rz_B + Rz_J + B_y/2 + y/2 + h_wav,eff`` in m."""
        return (
            self.roughness_bearing
            + self.roughness_journal
            + self.tilt_offset / 2.0
            + self.mean_deflection / 2.0
            + self.waviness * self.wave_factor
        )


@dataclass(frozen=True)
class Bearing:
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

    @property
    def width_ratio(self) -> float:
        """B/D."""
        return self.width / self.diameter

    @property
    def mean_relative_clearance(self) -> float:
        """Relative clearance in the middle of its tolerance, at 20 °C."""
        tolerance = self.clearance_tolerance
        return sum(tolerance) / 2.0 if tolerance else self.relative_clearance


@dataclass(frozen=True)
class GivenLoad:
    """The load in N is given, the position is found."""

    load: float


@dataclass(frozen=True)
class GivenEccentricity:
    """The relative eccentricity is prescribed, the load is found."""

    eccentricity_ratio: float


@dataclass(frozen=True)
class OilSupply:
    """Oil fed under pressure: inlet temperature in K, gauge pressure in Pa, losses on the way.

    `circulation_time` (s, whole oil volume over whole flow) decides which temperature limit holds; None: unknown.
    """

    temperature: float
    pressure: float
    tubes: tuple[Duct, ...] = ()
    holes: tuple[Duct, ...] = ()
    circulation_time: float | None = None


@dataclass(frozen=True)
class HousingCooling:
    """Heat given to the surroundings: ambient temperature in K, W/(m² K), emitting surface in m²."""

    ambient_temperature: float
    heat_transfer_coefficient: float
    surface: float


@dataclass(frozen=True)
class Limits:
    """Limits that the user sets in place of those by experience; None takes the latter."""

    minimum_film_thickness: float | None = None
    specific_load: float | None = None
    temperature: float | None = None
    transition_film_thickness: float | None = None


@dataclass(frozen=True)
class DesignCase:
    """One bearing at one operating point with all choices made.

    Speeds in rad/s. At least one of `oil_supply` and `cooling` carries the heat away. `given` holds names and
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
