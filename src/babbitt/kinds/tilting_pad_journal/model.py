"""A tilting-pad journal bearing at one operating point and clearance: SI numbers, all choices made."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum

from babbitt.core.notices import Notice
from babbitt.design.conditions import (
    HousingCooling,
    Limits,
    OilSupply,
    PrescribedLoad,
    PrescribedPosition,
    Proportions,
    Surfaces,
)
from babbitt.properties.lubricants import Lubricant
from babbitt.properties.materials import BearingMetal, LoadCharacter
from babbitt.reynolds.heat.heat_model import JournalHeat
from babbitt.reynolds.model import DRAFT, ENGINEERING, Resolution
from babbitt.reynolds.oil.turbulence import FilmTurbulence, TurbulenceLaw
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_heat import THERMAL_PADS, PadBending, PadGrowth, PadMaterial, PadWalls
from babbitt.reynolds.tilting_pads.pedestal import Pedestal

__all__ = [
    "Accuracy", "Feed", "HeatChoices", "LIGHT", "PadBearing", "PadCase", "SAME_LINE", "Thermal", "WHIRL_RATIOS",
    "on_one_line",
]  # fmt: skip

LIGHT = 0.05
"""Share of the load that a pad may carry at its fold and still be left without (assumption).

More than the 2 % (`margins.LIGHTLY_LOADED`) below which a loaded pad is reported: offset pads of the bearings
tried carry up to 3.5 % at their folds, and between a speed at which such a pad carries and one at which it does
not there is no other answer. A removal is never silent: W417 always reports it, with what differs in films of one
temperature. A heated pad that stays unloaded at the temperatures of the state without it is in equilibrium; W401
reports it."""

WHIRL_RATIOS = (0.2, 0.4, 0.6, 0.8, 1.0, 1.2)
"""Frequencies over the speed at which coefficients are given where the case names none."""

FINE = Resolution(6, 192, tolerance=1e-9)
"""Grid of the accuracy ``reference``, on every pad."""

COARSE_HEAT, FINE_HEAT = Resolution(4, 24), Resolution(4, 192)
"""Grids of ``draft`` and ``reference`` of films with their own temperatures: within 0.2 K, and 0.03 K."""


class Accuracy(Enum):
    """How fine the grid of a pad is."""

    DRAFT = "draft"
    ENGINEERING = "engineering"
    REFERENCE = "reference"

    @property
    def resolution(self) -> Resolution:
        """Grid of the film engine."""
        return {"draft": DRAFT, "engineering": ENGINEERING, "reference": FINE}[self.value]

    @property
    def thermal_resolution(self) -> Resolution:
        """Grid of films with their own temperatures."""
        return {"draft": COARSE_HEAT, "engineering": THERMAL_PADS, "reference": FINE_HEAT}[self.value]


class Thermal(Enum):
    """How the temperature of the films is found."""

    ISOTHERMAL = "isothermal"
    GLOBAL = "global"
    ADIABATIC = "adiabatic"
    FULL = "full"

    @property
    def is_resolved(self) -> bool:
        """Whether films have temperatures of their own."""
        return self in (Thermal.ADIABATIC, Thermal.FULL)


@dataclass(frozen=True)
class HeatChoices:
    """What takes heat from films with their own temperatures, and what it deforms.

    Attributes
    ----------
    journal : JournalHeat or None
        None: it takes no heat.
    walls : PadWalls or None
        None: the pads take no heat.
    bending : PadBending or None
    growth : PadGrowth or None
    materials : tuple of PadMaterial
        Of every pad what it has of its own; empty: all are alike.
    """

    journal: JournalHeat | None = None
    walls: PadWalls | None = None
    bending: PadBending | None = None
    growth: PadGrowth | None = None
    materials: tuple[PadMaterial, ...] = ()


@dataclass(frozen=True)
class Feed:
    """How oil reaches the pads.

    Attributes
    ----------
    kind : str
        ``flooded``, ``leading_edge_groove`` or ``spray_bar``.
    carry_over : float
        Share of the oil that leaves a pad over its trailing edge and enters the next one.
    """

    kind: str
    carry_over: float


@dataclass(frozen=True)
class PadBearing(Proportions):
    """Pads around a journal with what holds them to limits; lengths in m.

    Attributes
    ----------
    diameter, width : float
        Of the journal, and of the pads that have no width of their own.
    pads : tuple of TiltingPad
        Their viscosity is that of the film.
    groove_pressure : float
        Gauge pressure of the oil between the pads, Pa.
    surfaces : Surfaces or None
    metal : BearingMetal or None
    load_character : LoadCharacter
    """

    diameter: float
    width: float
    pads: tuple[TiltingPad, ...]
    groove_pressure: float = 0.0
    surfaces: Surfaces | None = None
    metal: BearingMetal | None = None
    load_character: LoadCharacter = LoadCharacter.CALM

    @property
    def assembled_clearance(self) -> float:
        """Smallest assembled clearance of the pads, m."""
        return min(pad.assembled_clearance for pad in self.pads)

    @property
    def pad_clearance(self) -> float:
        """Largest machined clearance of the pads, m."""
        return max(pad.clearance for pad in self.pads)

    @property
    def relative_clearance(self) -> float:  # type: ignore[override]
        """Assembled clearance over the radius."""
        return 2.0 * self.assembled_clearance / self.diameter

    @property
    def mean_relative_clearance(self) -> float:
        """As `relative_clearance`."""
        return self.relative_clearance

    @property
    def pad_relative_clearance(self) -> float:
        """Largest machined clearance of the pads over the radius, to which the Reynolds number belongs."""
        return 2.0 * self.pad_clearance / self.diameter

    def film(
        self, viscosity: float, angular_speed: float, turbulence: FilmTurbulence | None = None
    ) -> TiltingPadBearing:
        """The bearing of the film engine: viscosity in Pa s, speed in rad/s."""
        return TiltingPadBearing(
            self.diameter, self.width, viscosity, angular_speed, self.pads, self.groove_pressure, turbulence
        )


@dataclass(frozen=True)
class PadCase:
    """One tilting-pad bearing at one operating point with all choices made.

    Speed in rad/s, positive counter-clockwise; `load_angle` in rad from +x. With the thermal model `ISOTHERMAL`
    the films have the `effective_temperature` (K), else it is None and found from friction and fresh oil; `heat`
    counts for films with their own temperatures, whose bores at the probes `probe_alarm` and `probe_trip` (K)
    limit; `fuller` has all of that, bending and growth, whether the films count them or not, and is asked whether
    the limits are kept with it (None: it is not). Without `turbulence` films are laminar whatever their Reynolds
    number.
    `given_clearances` names the two of clearance, assembled_clearance and preload that the case gives of every
    pad, empty where they are not known.
    `rotor_mass` (kg) is the part of a rotor that this bearing carries, `shaft_stiffness` (N/m) that of the shaft
    between that mass and the journal; None is rigid. `anticipated_cross_coupling` (N/m) drives the whole rotor, on
    two such bearings, forward; the housing stands on the `pedestal`, None: a rigid one. Coefficients are given at
    the `whirl_ratios`, frequencies over the speed.
    """

    name: str
    bearing: PadBearing
    duty: PrescribedLoad | PrescribedPosition
    journal_speed: float
    lubricant: Lubricant
    thermal: Thermal
    feed: Feed
    oil_supply: OilSupply | None = None
    effective_temperature: float | None = None
    heat: HeatChoices = HeatChoices()
    fuller: HeatChoices | None = None
    turbulence: TurbulenceLaw | None = None
    load_angle: float = -0.5 * math.pi
    accuracy: Accuracy = Accuracy.ENGINEERING
    whirl_ratios: tuple[float, ...] = WHIRL_RATIOS
    rotor_mass: float | None = None
    shaft_stiffness: float | None = None
    anticipated_cross_coupling: float | None = None
    pedestal: Pedestal | None = None
    limits: Limits = field(default_factory=Limits)
    least_log_decrement: float | None = None
    probe_alarm: float | None = None
    probe_trip: float | None = None
    assumption_sensitivity: bool = False
    given_clearances: tuple[tuple[str, ...], ...] = ()
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    kind: str = "tilting_pad_journal"
    cooling: HousingCooling | None = None
    bearing_speed: float = 0.0

    @property
    def assumed_of_lubricant(self) -> tuple[str, ...]:
        """What is assumed of the oil, so far as these films use it."""
        if self.thermal.is_resolved:
            return self.lubricant.assumptions
        return self.lubricant.assumptions_but_of_conduction

    @property
    def sense(self) -> float:
        """Sense of rotation: 1 counter-clockwise, -1 clockwise."""
        return math.copysign(1.0, self.journal_speed)


SAME_LINE = 1e-6
"""Angle in rad by which pivots may lie beside a line through the centre."""


def on_one_line(angles: Sequence[float]) -> bool:
    """Whether pivots at some angles (rad) stand on one line through the centre, across which they hold nothing.

    >>> on_one_line([0.5, 0.5 + math.pi]), on_one_line([0.5, 2.0])
    (True, False)
    """
    return all(abs(math.sin(one - angles[0])) < SAME_LINE for one in angles)
