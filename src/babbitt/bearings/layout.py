"""From a bearing to its film: full-width grooves cut the bore into lands, narrower hollows are pockets."""

from __future__ import annotations

import math
from dataclasses import replace

from babbitt.bearings.bore import Arc, steps_of
from babbitt.bearings.model import FilmCase, Hollow
from babbitt.film.model import FilmStart, JournalFilm, Land, Pocket

__all__ = ["film_of", "load_vector", "without_pressure"]

TURN = 2.0 * math.pi


def film_of(case: FilmCase, relative_clearance: float, viscosity: float, element_pressure: float) -> JournalFilm:
    """Film of a case at one temperature.

    Parameters
    ----------
    case : FilmCase
    relative_clearance : float
        At that temperature.
    viscosity : float
        Pa s.
    element_pressure : float
        Gauge pressure of every hollow that has none of its own, Pa.

    Raises
    ------
    InputError
        E101 for a layout that the film engine refuses.
    """
    bearing = case.bearing
    clearance = 0.5 * relative_clearance * bearing.diameter
    grooves = [hollow for hollow in bearing.hollows if hollow.width is None]
    pockets = [(hollow, hollow.width) for hollow in bearing.hollows if hollow.width is not None]
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
        pockets=tuple(_pocket(hollow, width, element_pressure) for hollow, width in pockets),
        misalignment=bearing.misalignment,
        steps=(*steps_of(bearing.bore, case.rotation.sense), *bearing.steps),
        crowning=bearing.crowning,
        displacement=bearing.displacement,
        side_pressures=bearing.side_pressures,
    )


def load_vector(case: FilmCase, load: float) -> tuple[float, float]:
    """Components of a load in N."""
    return load * math.cos(case.load_angle), load * math.sin(case.load_angle)


def without_pressure(film: JournalFilm) -> JournalFilm:
    """The same film with every groove and pocket full, at ambient pressure; the sides keep theirs."""
    return replace(
        film,
        lands=tuple(replace(land, start_pressure=0.0, end_pressure=0.0) for land in film.lands),
        pockets=tuple(replace(pocket, pressure=0.0) for pocket in film.pockets),
    )


def _start(case: FilmCase, grooves: list[Hollow]) -> FilmStart:
    start = case.bearing.film_start
    return FilmStart.PERIODIC if start is FilmStart.GROOVE and not grooves else start


def _lands(case: FilmCase, grooves: list[Hollow], clearance: float, pressure: float) -> tuple[Land, ...]:
    shaped, sense = case.bearing.bore.shaped, case.rotation.sense
    if not grooves:
        start = case.load_angle - math.pi  # the seam lies opposite the load
        return (shaped(Arc(start, start + TURN, clearance, (0.0, 0.0), sense)),)
    ordered = sorted(grooves, key=lambda groove: groove.angle % TURN)
    lands = []
    for groove, following in zip(ordered, [*ordered[1:], ordered[0]], strict=True):
        between = (following.angle - groove.angle) % TURN or TURN
        start = groove.angle + 0.5 * groove.extent
        end = groove.angle + between - 0.5 * following.extent
        pressures = (_pressure(groove, pressure), _pressure(following, pressure))
        lands.append(shaped(Arc(start, end, clearance, pressures, sense)))
    return tuple(lands)


def _pocket(hollow: Hollow, width: float, pressure: float) -> Pocket:
    return Pocket(hollow.angle, hollow.extent, width, hollow.axial_position, _pressure(hollow, pressure))


def _pressure(hollow: Hollow, pressure: float) -> float:
    return pressure if hollow.pressure is None else hollow.pressure
