"""From a bearing to its film: full-width grooves cut the bore into lands, narrower feeds are pockets."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.core.notices import InputError
from babbitt.design.conditions import PrescribedPosition
from babbitt.design.heat_balance import NoFilmError
from babbitt.design.turbulence import film_turbulence
from babbitt.kinds.journal.film.bore import Arc, steps_of
from babbitt.kinds.journal.film.model import FeedSize, FilmCase
from babbitt.reynolds.equilibrium.starved import PrescribedFlow
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Pocket
from babbitt.reynolds.oil.turbulence import FilmTurbulence

if TYPE_CHECKING:
    from babbitt.reynolds.solution import FilmSolution

__all__ = [
    "closed_pockets",
    "fed_all_around",
    "film_of",
    "flow_of_the_system",
    "feeds_itself",
    "given_flows",
    "load_vector",
    "pressed_flow",
    "supply_numbers",
    "with_flow_of_ducts",
    "without_pressure",
]

TURN = 2.0 * math.pi
ALL_AROUND = TURN * (1.0 - 1e-9)


def film_of(
    case: FilmCase,
    relative_clearance: float,
    viscosity: float,
    element_pressure: float,
    density: float | None = None,
) -> JournalFilm:
    """Film of a case at one temperature.

    Parameters
    ----------
    case : FilmCase
    relative_clearance : float
        At that temperature.
    viscosity : float
        Pa s.
    element_pressure : float
        Gauge pressure of every feed that has none of its own, Pa.
    density : float or None
        kg/m3; only a turbulent film needs it.

    Raises
    ------
    InputError
        E101 for a layout that the film engine refuses.
    """
    bearing = case.bearing
    clearance = 0.5 * relative_clearance * bearing.diameter
    grooves = [feed for feed in bearing.feeds if feed.width is None]
    pockets = [(feed, feed.width) for feed in bearing.feeds if feed.width is not None]
    return JournalFilm(
        diameter=bearing.diameter,
        width=bearing.width,
        clearance=clearance,
        viscosity=viscosity,
        angular_speed=case.journal_speed + case.bearing_speed,
        lands=_lands(case, grooves, clearance, element_pressure),
        cavitation=case.cavitation,
        film_start=_start(case, grooves),
        cavitation_pressure=case.cavitation_pressure,
        pockets=tuple(_pocket(feed, width, element_pressure) for feed, width in pockets),
        misalignment=bearing.misalignment,
        turbulence=_turbulence(case, relative_clearance, density),
        pressure_viscosity=case.pressure_viscosity.at(viscosity) if case.pressure_viscosity is not None else None,
        steps=(*steps_of(bearing.bore, case.rotation.sense), *bearing.steps),
        crowning=bearing.crowning,
        displacement=bearing.displacement,
        field_start=bearing.displacement_start if bearing.displacement else _towards(case),
        side_pressures=bearing.side_pressures,
    )


def supply_numbers(case: FilmCase, film: JournalFilm) -> tuple[int, ...]:
    """Which supply of the film (see ``FilmSolution.supply_flow``) each feed of the bearing is."""
    feeds = case.bearing.feeds
    grooves = _ordered_grooves(case)
    behind = [grooves[(land + 1) % len(grooves)] for land in film.land_order if grooves]
    pockets = [feed for feed in feeds if feed.width is not None]
    return tuple(
        behind.index(feed) if feed.width is None else len(grooves) + pockets.index(feed) for feed in feeds
    )


def given_flows(case: FilmCase, film: JournalFilm) -> tuple[PrescribedFlow, ...]:
    """Flows that the supplies of a film are given: their own, and that of the oil supply shared by all others."""
    numbered = list(zip(case.bearing.feeds, supply_numbers(case, film), strict=True))
    given = [PrescribedFlow((number,), feed.flow) for feed, number in numbered if feed.flow]
    if case.oil_supply is not None and case.oil_supply.flow is not None:
        members = tuple(number for feed, number in numbered if feed.pressure is None and feed.flow is None)
        given += [PrescribedFlow(members, case.oil_supply.flow)] if members else []
    return tuple(given)


def with_flow_of_ducts(case: FilmCase, flow: float) -> FilmCase | None:
    """The case fed with the flow in m3/s that its tubes and holes pass at most, where its film can be starved.

    None for films with their own temperatures, orbits, and films that conserve no oil or are fed nowhere.
    """
    supply = case.oil_supply
    counted = case.cavitation is Cavitation.MASS_CONSERVING and case.heat is None and case.changing_load is None
    fed = bool(case.bearing.feeds) and not feeds_itself(case)
    if supply is None or not (counted and fed) or case.bearing.film_start is FilmStart.WIDEST_GAP or flow <= 0.0:
        return None
    return replace(case, oil_supply=replace(supply, pressure=0.0, flow=flow, tubes=(), holes=()))


def feeds_itself(case: FilmCase) -> bool:
    """Whether every groove, pocket and hole has a pressure or flow of its own: no one takes that of the supply."""
    feeds = case.bearing.feeds
    return bool(feeds) and all(one.pressure is not None or one.flow is not None for one in feeds)


def fed_all_around(case: FilmCase) -> bool:
    """Whether nothing but grooves around the whole bore feeds the film: they send no oil into it by shear."""
    fed = [feed for feed in case.bearing.feeds if not feed.is_closed]
    return bool(fed) and all(feed.extent >= ALL_AROUND for feed in fed)


def flow_of_the_system(case: FilmCase, solution: FilmSolution) -> float:
    """Oil in m3/s that comes to a film through tubes and holes of the oil supply.

    What leaves the film less the net flow of feeds that have a pressure or flow of their own.
    """
    numbered = zip(case.bearing.feeds, supply_numbers(case, solution.film), strict=True)
    own = [number for feed, number in numbered if feed.pressure is not None or feed.flow is not None]
    return max(float(solution.side_flow.sum() - solution.supply_flow[own].sum()), 0.0)


def pressed_flow(case: FilmCase, film_at: Callable[[float], FilmSolution]) -> Callable[[float], float | None]:
    """`flow_of_the_system` over the pressure at the supply in Pa; ``film_at`` solves the film at one.

    Grooves around the whole bore press oil into the film and shear none into it: None below the whole pressure of
    the supply where no film of theirs lives, so that none flows.
    """

    def flow_at(pressure: float) -> float | None:
        try:
            return flow_of_the_system(case, film_at(pressure))
        except NoFilmError:
            if case.oil_supply is not None and pressure < case.oil_supply.pressure and fed_all_around(case):
                return None
            raise

    return flow_at


def closed_pockets(case: FilmCase) -> tuple[int, ...]:
    """Which of the pockets of a film (`JournalFilm.pockets`) are closed: nothing feeds them."""
    pockets = [feed for feed in case.bearing.feeds if feed.width is not None]
    return tuple(number for number, feed in enumerate(pockets) if feed.is_closed)


def _towards(case: FilmCase) -> float:
    """Direction of the load, or of the prescribed position: fields are laid from it, for they know no axes."""
    if isinstance(case.duty, PrescribedPosition):
        return math.atan2(case.duty.y, case.duty.x)
    return case.load_angle


def load_vector(case: FilmCase, load: float) -> tuple[float, float]:
    """Components of a load in N."""
    return load * math.cos(case.load_angle), load * math.sin(case.load_angle)


def without_pressure(film: JournalFilm, closed: tuple[int, ...] = ()) -> JournalFilm:
    """The same film without supply pressure above that of the surroundings; closed pockets keep theirs."""
    return replace(
        film,
        lands=tuple(
            replace(land, start_pressure=min(land.start_pressure, 0.0), end_pressure=min(land.end_pressure, 0.0))
            for land in film.lands
        ),
        pockets=tuple(
            pocket if number in closed else replace(pocket, pressure=min(pocket.pressure, 0.0))
            for number, pocket in enumerate(film.pockets)
        ),
    )


def _turbulence(case: FilmCase, relative_clearance: float, density: float | None) -> FilmTurbulence | None:
    if case.turbulence is None:
        return None
    if density is None:
        raise InputError("E101", "a turbulent film needs the density of the oil.")
    return film_turbulence(case.turbulence, relative_clearance, density)


def _ordered_grooves(case: FilmCase) -> list[FeedSize]:
    grooves = [feed for feed in case.bearing.feeds if feed.width is None]
    return sorted(grooves, key=lambda groove: groove.angle % TURN)


def _start(case: FilmCase, grooves: list[FeedSize]) -> FilmStart:
    start = case.bearing.film_start
    return FilmStart.PERIODIC if start is FilmStart.GROOVE and not grooves else start


def _lands(case: FilmCase, grooves: list[FeedSize], clearance: float, pressure: float) -> tuple[Land, ...]:
    shaped, sense = case.bearing.bore.shaped, case.rotation.sense
    if not grooves:
        start = case.load_angle - math.pi  # the seam lies opposite the load
        return (shaped(Arc(start, start + TURN, clearance, (0.0, 0.0), sense)),)
    ordered = _ordered_grooves(case)
    lands = []
    for groove, following in zip(ordered, [*ordered[1:], ordered[0]], strict=True):
        between = (following.angle - groove.angle) % TURN or TURN
        start = groove.angle + 0.5 * groove.extent
        end = groove.angle + between - 0.5 * following.extent
        pressures = (_pressure(groove, pressure), _pressure(following, pressure))
        lands.append(shaped(Arc(start, end, clearance, pressures, sense)))
    return tuple(lands)


def _pocket(feed: FeedSize, width: float, pressure: float) -> Pocket:
    place = feed.angle, feed.extent, width, feed.axial_position
    return Pocket(*place, _pressure(feed, pressure), closed=feed.is_closed)


def _pressure(feed: FeedSize, pressure: float) -> float:
    if feed.flow is not None:
        return 0.0  # until the film tells how far its flow fills it, or at which pressure none passes
    return pressure if feed.pressure is None else feed.pressure
