"""What a thrust bearing is computed from, with all choices made, and its operating point."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.film.turbulence import TurbulenceLaw
from babbitt.lubricants import Lubricant
from babbitt.notices import Notice
from babbitt.thrust.bearing import ThrustBearing
from babbitt.thrust.carrying import Carrying, carrying
from babbitt.thrust.heat import HeatBalance, Temperatures, balanced
from babbitt.thrust.sharing import Share, share_of
from babbitt.thrust.state import PadState

__all__ = ["GivenFilm", "GivenThrust", "Oil", "ThrustDesign", "ThrustState", "operating_state", "warm_films"]


@dataclass(frozen=True)
class GivenThrust:
    """The thrust in N is given, the film is found."""

    thrust: float


@dataclass(frozen=True)
class GivenFilm:
    """The mean film at the pivots in m is given, the thrust is found; without tilt and with a rigid ring exact."""

    film: float


@dataclass(frozen=True)
class Oil:
    """Viscosity of the films: as given, at a temperature, or by the heat balance.

    Attributes
    ----------
    lubricant : Lubricant
        Of a given viscosity a constant law.
    effective_temperature : float or None
        K, prescribed.
    supply_temperature : float or None
        K, for the heat balance.
    carry_over : float
        Share of hot oil that enters the next pad.
    """

    lubricant: Lubricant
    effective_temperature: float | None = None
    supply_temperature: float | None = None
    carry_over: float = 0.0

    @property
    def balance(self) -> HeatBalance | None:
        """The heat balance; None where the viscosity is fixed."""
        if self.supply_temperature is None:
            return None
        return HeatBalance(self.lubricant, self.supply_temperature, self.carry_over)

    @property
    def fixed_viscosity(self) -> float:
        """Pa s at the prescribed temperature, or at the supply where the balance begins."""
        at = self.effective_temperature if self.effective_temperature is not None else self.supply_temperature
        return float(self.lubricant.dynamic_viscosity(at if at is not None else 313.15))


@dataclass(frozen=True)
class ThrustDesign:
    """One thrust bearing with all choices made.

    Attributes
    ----------
    name : str
    bearing : ThrustBearing
        Its ``sense`` is that of the speed; pads are mirrored already.
    duty : GivenThrust or GivenFilm
    speed : float
        Magnitude, rad/s.
    oil : Oil
    runout : float
        Amplitude of the face at the pivot radius, m.
    film_limit : float
        Least film permitted, m.
    film_limit_source : str
    turbulence : TurbulenceLaw or None
    given, assumptions, doubts
        As of `babbitt.bearings.model.FilmCase`.
    """

    name: str
    bearing: ThrustBearing
    duty: GivenThrust | GivenFilm
    speed: float
    oil: Oil
    runout: float = 0.0
    film_limit: float = 10e-6
    film_limit_source: str = ""
    turbulence: TurbulenceLaw | None = None
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    doubts: tuple[Notice, ...] = ()
    kind: str = "thrust"

    @property
    def lubricant(self) -> Lubricant:
        """The oil."""
        return self.oil.lubricant


@dataclass(frozen=True, eq=False)
class ThrustState:
    """Operating point: films of one pad, their share of the thrust, temperatures where a balance was made."""

    films: Carrying
    share: Share
    temperatures: Temperatures | None


def operating_state(design: ThrustDesign) -> ThrustState:
    """Films, share and temperatures of a bearing.

    Raises
    ------
    InputError
        E202 where the pads do not balance.
    ThermalRunawayError
    """
    films, temperatures = warm_films(design, design.bearing, design.speed, design.duty)
    return ThrustState(films, _share(films, design.bearing, design.duty), temperatures)


def warm_films(
    design: ThrustDesign, bearing: ThrustBearing, speed: float, duty: GivenThrust | GivenFilm
) -> tuple[Carrying, Temperatures | None]:
    """Films of one pad in the oil of the design at a speed and a duty."""
    films = carrying(bearing.pad, design.oil.fixed_viscosity, speed)
    balance = design.oil.balance
    if balance is None:
        return films, None

    def pads_on(in_oil: Carrying) -> tuple[PadState, ...]:
        return _share(in_oil, bearing, duty).states

    return balanced(balance, films, speed, pads_on)


def _share(films: Carrying, bearing: ThrustBearing, duty: GivenThrust | GivenFilm) -> Share:
    if isinstance(duty, GivenThrust):
        return share_of(films, bearing, duty.thrust)
    from dataclasses import replace

    import numpy as np

    level = replace(bearing, ring_stiffness=math.inf)
    heights = duty.film + level.departures()
    thrust = float(films.load(np.maximum(heights, 1e-9)).sum())
    return share_of(films, bearing, thrust)
