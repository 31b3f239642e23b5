"""A clearance, and the heat that oil holds, that follow the temperatures of a film while the film is sought.

On a ring lengths across the film are counted in clearances: in a round bore another clearance is another unit, and
the ring stays. A load W over mu omega (R/c)^2 R B goes with c^2, pressures of supplies likewise, the rise of
temperature mu omega R^2 / (rho c_p c^2) and conduction k / (rho c_p omega c^2) with c^-2, flows with c.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
from babbitt.reynolds.model import JournalFilm

__all__ = ["FollowingClearance", "WarmClearance", "keeps_its_ring", "with_clearance"]


@dataclass(frozen=True)
class WarmClearance:
    """What the temperatures of a film make of its clearance and its oil.

    Attributes
    ----------
    clearance : float
        Radial, m.
    temperature : float
        At which the oil has the properties that follow, K.
    volumetric_heat_capacity : float
        J/(m3 K).
    conductivity : float
        W/(m K).
    """

    clearance: float
    temperature: float
    volumetric_heat_capacity: float
    conductivity: float


@dataclass(eq=False)
class FollowingClearance:
    """Clearance of a film that is sought, from pass to pass.

    Attributes
    ----------
    law : callable
        What the temperatures of a film make of it; None where they make nothing that is a film.
    start, now : WarmClearance
        At the begin of the search, and as it stands.
    """

    law: Callable[[ThermalFilmState], WarmClearance | None]
    start: WarmClearance
    now: WarmClearance = field(init=False)

    def __post_init__(self) -> None:
        self.begin()

    def begin(self) -> None:
        """Stand at the start, as a ring drawn anew does."""
        self.now = self.start

    def follow(self, thermal: ThermalFilmState) -> float:
        """Let a film have the clearance and the oil of its temperatures; that clearance over the last one."""
        last, warm = self.now, self.law(thermal)
        if warm is None:
            return 1.0
        self.now = warm
        if (warm.volumetric_heat_capacity, warm.conductivity) != (
            last.volumetric_heat_capacity,
            last.conductivity,
        ):
            thermal.heat = replace(
                thermal.heat,
                volumetric_heat_capacity=warm.volumetric_heat_capacity,
                conductivity=warm.conductivity,
            )
        wider = warm.clearance / last.clearance
        heavier = warm.volumetric_heat_capacity / last.volumetric_heat_capacity
        better, walls = warm.conductivity / last.conductivity, thermal.walls
        thermal.rise /= heavier * wider**2
        thermal.walls = walls._replace(
            conduction=walls.conduction * better / (heavier * wider**2),
            flow_heat=walls.flow_heat * heavier * wider,
        )
        thermal.sample.ring.surface.held_pressure[:] *= wider**2
        return wider


def keeps_its_ring(film: JournalFilm) -> bool:
    """Whether the ring of a film is the same at every clearance, but for its unit."""
    absolute = film.misalignment != (0.0, 0.0) or film.crowning or film.displacement or film.steps
    by_pressure = film.cavitation_pressure != 0.0 or film.side_pressures != (0.0, 0.0) or film.pressure_viscosity
    return film.is_round and not (absolute or by_pressure or film.turbulence)


def with_clearance(film: JournalFilm, clearance: float) -> JournalFilm:
    """A film that `keeps_its_ring` with another radial clearance, m."""
    lands = tuple(land if land.clearance is None else replace(land, clearance=clearance) for land in film.lands)
    return replace(film, clearance=clearance, lands=lands)
