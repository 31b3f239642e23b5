"""Whether the journal could rest elsewhere, as the answer of a bearing tells it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.bearings.bore import LobedBore
from babbitt.bearings.layout import load_vector
from babbitt.bearings.model import FilmCase, Search
from babbitt.bearings.settling import is_saddle
from babbitt.bearings.warm_film import FilmState
from babbitt.design.conditions import GivenLoad
from babbitt.film.model import Cavitation, FilmStart, JournalFilm
from babbitt.notices import Notice

if TYPE_CHECKING:
    from babbitt.bearings.equilibria import RestingPlace, RestingPlaces
    from babbitt.film.solution import FilmSolution

SUPPLY_SHARE = 0.5
"""Supply pressure over η ω (R/c)² from which further equilibria are sought. Assumption: two opposite grooves make
them from 5 on."""

__all__ = ["doubts_about_rest", "resting_places"]


def resting_places(case: FilmCase, state: FilmState) -> RestingPlaces | None:
    """All equilibria under the load of a case, that of the operating point first; None where they are not
    sought."""
    film = state.solution.film
    wanted = case.search is Search.ALL or (
        case.search is Search.AUTO and (state.left_saddle or _likely(case, film))
    )
    if not (wanted and isinstance(case.duty, GivenLoad)) or film.cavitation is Cavitation.HALF_SOMMERFELD:
        return None
    from babbitt.bearings.equilibria import find_equilibria

    load = load_vector(case, case.duty.load)
    return find_equilibria(film, load, case.accuracy.resolution, (state.solution,))


def _likely(case: FilmCase, film: JournalFilm) -> bool:
    """Whether further equilibria are worth the time: in lobes, and where supply pressure rivals that of the
    wedge."""
    if film.film_start is not FilmStart.GROOVE:
        return False
    wedge = film.viscosity * abs(film.angular_speed) * (0.5 * film.diameter / film.clearance) ** 2
    supply = max(max(land.start_pressure, land.end_pressure) for land in film.lands)
    return isinstance(case.bearing.bore, LobedBore) or supply > SUPPLY_SHARE * wedge


def doubts_about_rest(shown: FilmSolution, found: RestingPlaces | None) -> Iterator[Notice]:
    """Further equilibria, and an operating point that the journal leaves by itself."""
    if is_saddle(shown):
        known = "was looked for" if found is None else "was found"
        yield Notice("W132", f"the static stiffness is that of a saddle (det K < 0), and no better place {known}")
    if found is None:
        return
    others = found.places[1:]
    if others:
        yield Notice("W131", f"{len(others)} besides the one shown: " + "; ".join(_said(one) for one in others))
    if not found.complete:
        yield Notice("W134", f"{len(found.places)} found, and their indices do not sum to one")


def _said(place: RestingPlace) -> str:
    x, y = place.position
    direction = math.degrees(math.atan2(y, x))
    return f"e/c = {place.film.eccentricity_ratio:.3f} at {direction:.0f}° from +x, {_stays(place)}"


def _stays(place: RestingPlace) -> str:
    if place.holds:
        return "the journal stays there"
    if place.index < 0:
        return "it never stays"
    least = place.stable_masses.least
    return "it whirls there" if math.isinf(least) else f"it whirls there unless heavier than {least:.4g} kg"
