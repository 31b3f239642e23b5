"""What a thrust bearing is computed from, with all choices made, and its operating point."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace

from babbitt.core.notices import Notice
from babbitt.design.pad_heat import HeatBalance, PadTemperatures, Temperatures
from babbitt.kinds.thrust.balanced_films import BalancedFilms, temperatures_together
from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.failures import ConcavePadError, NoPadFilmError
from babbitt.kinds.thrust.fed_pads import share_of_fed_pads
from babbitt.kinds.thrust.heat import balanced
from babbitt.kinds.thrust.load_curve import LoadCurve, carrying
from babbitt.kinds.thrust.neighbours import SETTLED, share_with_neighbours
from babbitt.kinds.thrust.pad_attitude import PadAttitude, attitude_at_rest
from babbitt.kinds.thrust.runout import RunoutHarmonic
from babbitt.kinds.thrust.sharing import Share, exactly_shared, share_at_film, share_of
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.tabulated import TabulatedFilms
from babbitt.kinds.thrust.temperature_limits import TemperatureLimits
from babbitt.kinds.thrust.thermal import PadOil
from babbitt.kinds.thrust.thermal_films import ThermalLoadCurve, own_temperatures, thermal_load_curve
from babbitt.properties.lubricants import Lubricant
from babbitt.reynolds.oil.turbulence import TurbulenceLaw

__all__ = [
    "PrescribedFilm",
    "PrescribedThrust",
    "Oil",
    "USUAL_FILM_LIMIT",
    "USUAL_FILM_SOURCE",
    "ThrustDesign",
    "ThrustState",
    "bearing_state",
    "exact_state",
    "operating_state",
    "share_on",
    "temperatures_of_share",
    "films_in_oil",
]

USUAL_FILM_LIMIT, USUAL_FILM_SOURCE = 10e-6, "assumption: 10 µm"
"""Least film in m where the case gives none (an assumption)."""

NEARLY = 1e-5
"""Change of heights and inlets (0.01 K) that ends the search at a place of a turning collar. Pads whose
temperatures vary across them settle to about 1e-6, and a closer search would take twice the rounds."""


@dataclass(frozen=True)
class PrescribedThrust:
    """The thrust in N is given, the film is found."""

    thrust: float


@dataclass(frozen=True)
class PrescribedFilm:
    """The mean film at the pivots in m is given, the thrust is found."""

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
    own_temperatures : bool
        Whether films have their own temperatures instead of that of the balance.
    resolved : bool
        Whether these vary across the pads, too.
    """

    lubricant: Lubricant
    effective_temperature: float | None = None
    supply_temperature: float | None = None
    carry_over: float = 0.0
    own_temperatures: bool = False
    resolved: bool = False

    @property
    def assumed_of_lubricant(self) -> tuple[str, ...]:
        """What is assumed of the oil, so far as these films use it."""
        if self.own_temperatures:
            return self.lubricant.assumptions
        return self.lubricant.assumptions_but_of_conduction

    @property
    def thermal(self) -> PadOil | None:
        """The oil of films with their own temperatures; None for films of one viscosity."""
        if self.supply_temperature is None or not self.own_temperatures:
            return None
        return PadOil(self.lubricant, self.supply_temperature, self.carry_over, self.resolved)

    @property
    def balance(self) -> HeatBalance | None:
        """The heat balance; None where the viscosity is fixed or varies in the film."""
        if self.supply_temperature is None or self.own_temperatures:
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
    duty : PrescribedThrust or PrescribedFilm
    speed : float
        Magnitude, rad/s.
    oil : Oil
    runouts : tuple of RunoutHarmonic
        Runout and waves of the face of the collar.
    film_limit : float
        Least film permitted, m.
    film_limit_source : str
    temperatures : TemperatureLimits
    turbulence : TurbulenceLaw or None
    given, assumptions, warnings
        As of `babbitt.kinds.journal.film.model.FilmCase`.
    """

    name: str
    bearing: ThrustBearing
    duty: PrescribedThrust | PrescribedFilm
    speed: float
    oil: Oil
    runouts: tuple[RunoutHarmonic, ...] = ()
    film_limit: float = 10e-6
    film_limit_source: str = ""
    temperatures: TemperatureLimits = TemperatureLimits()  # noqa: RUF009
    turbulence: TurbulenceLaw | None = None
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    kind: str = "thrust"

    @property
    def lubricant(self) -> Lubricant:
        """The oil."""
        return self.oil.lubricant


@dataclass(frozen=True, eq=False)
class ThrustState:
    """Operating point: films of one pad, their share of the thrust, temperatures where a balance was made."""

    films: LoadCurve
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
    films, together = films_in_oil(design, design.bearing, design.speed, design.duty)
    share = _share(films, design.bearing, design.duty)
    if isinstance(films, TabulatedFilms) and isinstance(design.duty, PrescribedThrust):
        share = exactly_shared(films, share)
    if together is not None and attitude_at_rest(design.bearing).is_even:
        return ThrustState(films, share, together)
    return ThrustState(films, share, temperatures_of_share(films, share))


def exact_state(design: ThrustDesign) -> ThrustState:
    """As `operating_state`; pads whose oil warms carry the thrust exactly, too.

    Raises
    ------
    InputError
        E202 where the pads do not balance.
    ThermalRunawayError
    """
    state = operating_state(design)
    warmed = isinstance(state.films, ThermalLoadCurve | BalancedFilms)
    if not warmed or not isinstance(design.duty, PrescribedThrust):
        return state
    share = exactly_shared(state.films, state.share)
    return ThrustState(state.films, share, temperatures_of_share(state.films, share))


def temperatures_of_share(films: LoadCurve, share: Share) -> Temperatures | None:
    """Temperatures of pads that take in what their like sends off; None where the viscosity is fixed."""
    if isinstance(films, ThermalLoadCurve):
        return own_temperatures(films.oil, share.states)
    if isinstance(films, BalancedFilms):
        return temperatures_together(films, share.states)
    return None


def bearing_state(design: ThrustDesign) -> ThrustState:
    """As `operating_state`; pads with temperatures that differ take in the oil of their neighbour.

    Raises
    ------
    InputError
        E202 where the pads do not balance.
    NoPadFilmError
    """
    state = operating_state(design)
    bearing = state.share.bearing
    films = state.films
    if attitude_at_rest(bearing).is_even:
        return state
    film = design.duty.film if isinstance(design.duty, PrescribedFilm) else None
    share = _fed_by_neighbours(films, state.share, attitude_at_rest(bearing), film)
    if isinstance(films, ThermalLoadCurve):
        return ThrustState(films, share, own_temperatures(films.oil, share.states, bearing.sense))
    if isinstance(films, BalancedFilms):
        return ThrustState(films, share, temperatures_together(films, share.states, bearing.sense))
    return state


def share_on(films: LoadCurve, near: Share, standing: PadAttitude) -> Share:
    """The share of pads that stand otherwise; those with temperatures take in the oil of the pad before.

    Parameters
    ----------
    films : LoadCurve
    near : Share
        Of pads that stand nearly so, from which the search begins.
    standing : PadAttitude
        How the pads stand to the collar.

    Raises
    ------
    NoPadFilmError
    """
    if isinstance(films, ThermalLoadCurve | BalancedFilms):
        with suppress(NoPadFilmError):
            return _fed_by_neighbours(films, near, standing, tolerance=NEARLY)
    begin = share_of(films, near.bearing, near.thrust, standing)
    return _fed_by_neighbours(films, begin, standing, tolerance=NEARLY)


def _fed_by_neighbours(
    films: LoadCurve,
    share: Share,
    standing: PadAttitude,
    mean_film: float | None = None,
    tolerance: float = SETTLED,
) -> Share:
    """The same share where films have no temperature."""
    if isinstance(films, ThermalLoadCurve):
        return share_with_neighbours(films, share, mean_film, standing, tolerance)
    if isinstance(films, BalancedFilms):
        return share_of_fed_pads(films, share, mean_film, standing)
    return share


def films_in_oil(
    design: ThrustDesign, bearing: ThrustBearing, speed: float, duty: PrescribedThrust | PrescribedFilm
) -> tuple[LoadCurve, Temperatures | None]:
    """Films of one pad in the oil of the design at a speed and a duty; temperatures of pads that share evenly."""
    if (oil := design.oil.thermal) is not None:
        begin = carrying(bearing.pad, oil.fresh_viscosity, speed)
        if isinstance(duty, PrescribedFilm):
            return thermal_load_curve(bearing.pad, oil, speed, duty.film), None
        mean = duty.thrust / bearing.number
        return thermal_load_curve(bearing.pad, oil, speed, begin.height_for(mean), mean), None
    films = carrying(bearing.pad, design.oil.fixed_viscosity, speed)
    balance = design.oil.balance
    if balance is None:
        return films, None

    even = replace(bearing, tilt=HousingTilt(), height_errors=())

    def pads_on(in_oil: LoadCurve) -> tuple[PadState, ...]:
        return _share(in_oil, even, duty).states

    try:
        found, together = balanced(balance, films, speed, pads_on)
    except ConcavePadError as failure:
        raise _concave(balance, films, bearing, speed, duty) or failure from None
    middle = replace(
        pads_on(found)[0], balance=PadTemperatures(together.inlet, together.trailing - together.inlet)
    )
    capacity = float(design.lubricant.volumetric_heat_capacity(together.effective))
    return BalancedFilms(found, balance, middle, capacity), together


def _concave(
    balance: HeatBalance,
    films: LoadCurve,
    bearing: ThrustBearing,
    speed: float,
    duty: PrescribedThrust | PrescribedFilm,
) -> ConcavePadError | None:
    """What concave pads carry at most, at the temperature of the thinnest film on which they balance."""
    if not isinstance(films, TabulatedFilms) or not isinstance(duty, PrescribedThrust):
        return None
    thinnest, _ = films.thinnest
    at_most, _ = balanced(balance, films, speed, lambda in_oil: (in_oil.state(thinnest),))
    load = at_most.state(thinnest).load
    return ConcavePadError(bearing.pad.crown, load, duty.thrust, bearing.number)


def _share(films: LoadCurve, bearing: ThrustBearing, duty: PrescribedThrust | PrescribedFilm) -> Share:
    if isinstance(duty, PrescribedThrust):
        return share_of(films, bearing, duty.thrust)
    return share_at_film(films, bearing, duty.film)
