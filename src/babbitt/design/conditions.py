"""Under what conditions a bearing runs and what limits it, whatever the method. SI numbers only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from babbitt.design.ducts import Duct
from babbitt.properties.lubricants import Lubricant
from babbitt.properties.materials import BearingMetal, ExperienceLimits, LoadCharacter


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
class PrescribedLoad:
    """The load in N is given, the position is found."""

    load: float


@dataclass(frozen=True)
class PrescribedEccentricity:
    """The relative eccentricity is prescribed, the load is found.

    `attitude_angle` (rad) fixes the direction as well, where the method allows it: the direction of the load is
    then found, too. None: the load keeps its direction.
    """

    eccentricity_ratio: float
    attitude_angle: float | None = None


@dataclass(frozen=True)
class PrescribedPosition:
    """The journal centre stands `x`, `y` from the bearing centre, in m; the load and its direction are found."""

    x: float
    y: float


LoadSpec = PrescribedLoad | PrescribedEccentricity | PrescribedPosition
"""What a bearing carries, or where its journal stands."""


@dataclass(frozen=True)
class OilSupply:
    """Oil fed under pressure: inlet temperature in K, gauge pressure in Pa, losses on the way.

    `flow` (m³/s) in place of a pressure, which is then zero, is what a film that knows starved supplies is given.
    `circulation_time` (s, whole oil volume over whole flow) decides which temperature limit holds; None: unknown.
    """

    temperature: float
    pressure: float
    tubes: tuple[Duct, ...] = ()
    holes: tuple[Duct, ...] = ()
    circulation_time: float | None = None
    flow: float | None = None


@dataclass(frozen=True)
class HousingCooling:
    """Heat given to the surroundings: ambient temperature in K, W/(m² K), emitting surface in m²."""

    ambient_temperature: float
    heat_transfer_coefficient: float
    surface: float


@dataclass(frozen=True)
class Limits:
    """Limits that the user sets in place of those by experience; None takes the latter.

    `tables` replaces the shipped tables of experience themselves.
    """

    minimum_film_thickness: float | None = None
    specific_load: float | None = None
    temperature: float | None = None
    transition_film_thickness: float | None = None
    tables: ExperienceLimits | None = None


class Proportions:
    """What follows from the sizes of a bearing, however it is described further."""

    diameter: float
    width: float
    relative_clearance: float
    clearance_tolerance: tuple[float, float] | None
    mean_clearance: float | None
    axis_slope: float = 0.0
    """Slope of the journal axis in the bearing in rad that the film itself does not count."""

    @property
    def edge_loss(self) -> float:
        """Film thickness in m that the slope takes at an edge: half of the offset B_y over the width."""
        return self.axis_slope * self.width / 2.0

    @property
    def width_ratio(self) -> float:
        """B/D."""
        return self.width / self.diameter

    @property
    def loaded_width(self) -> float:
        """Width in m over which the film carries: all of it, unless a method parts the bearing by a groove."""
        return self.width

    @property
    def mean_relative_clearance(self) -> float:
        """Mean relative clearance of the case at 20 °C; without it that in the middle of the tolerance."""
        if self.mean_clearance is not None:
            return self.mean_clearance
        tolerance = self.clearance_tolerance
        return sum(tolerance) / 2.0 if tolerance else self.relative_clearance


class CheckedBearing(Protocol):
    """What the limits need to know of a bearing of any method."""

    @property
    def diameter(self) -> float: ...  # noqa: D102
    @property
    def width(self) -> float: ...  # noqa: D102
    @property
    def loaded_width(self) -> float: ...  # noqa: D102
    @property
    def surfaces(self) -> Surfaces | None: ...  # noqa: D102
    @property
    def mean_relative_clearance(self) -> float: ...  # noqa: D102
    @property
    def edge_loss(self) -> float: ...  # noqa: D102
    @property
    def metal(self) -> BearingMetal | None: ...  # noqa: D102
    @property
    def load_character(self) -> LoadCharacter: ...  # noqa: D102


class CheckedProblem(Protocol):
    """What heat balance, limits and warnings need to know of a case of any method."""

    @property
    def bearing(self) -> CheckedBearing: ...  # noqa: D102
    @property
    def oil_supply(self) -> OilSupply | None: ...  # noqa: D102
    @property
    def cooling(self) -> HousingCooling | None: ...  # noqa: D102
    @property
    def limits(self) -> Limits: ...  # noqa: D102
    @property
    def lubricant(self) -> Lubricant: ...  # noqa: D102
    @property
    def journal_speed(self) -> float: ...  # noqa: D102
    @property
    def duty(self) -> LoadSpec | None: ...  # noqa: D102
    @property
    def bearing_speed(self) -> float: ...  # noqa: D102
    @property
    def effective_temperature(self) -> float | None: ...  # noqa: D102


Values = Mapping[str, float]
"""Named results in SI."""


def surface_speed(case: CheckedProblem) -> float:
    """Surface speed of the journal in m/s."""
    return abs(case.journal_speed) * case.bearing.diameter / 2.0


def sliding_speed(case: CheckedProblem) -> float:
    """Speed of the journal's surface along that of the bearing, ``|U_J - U_B|`` in m/s."""
    return abs(case.journal_speed - case.bearing_speed) * case.bearing.diameter / 2.0


def contact_film(case: CheckedProblem) -> float | None:
    """Film thickness in m at which mixed friction begins: of the case, else of the surfaces."""
    if case.limits.transition_film_thickness is not None:
        return case.limits.transition_film_thickness
    return case.bearing.surfaces.film_limit if case.bearing.surfaces else None
