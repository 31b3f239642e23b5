"""Other equilibrium positions of the journal, as the result of a bearing reports them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS, NO_BOUNDS, Bounds
from babbitt.design.checks import film_checks
from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.film.bore import LobedBore
from babbitt.kinds.journal.film.isothermal import FilmState, equilibrium_near_position
from babbitt.kinds.journal.film.layout import closed_pockets, load_vector
from babbitt.kinds.journal.film.load_slope import with_bore
from babbitt.kinds.journal.film.model import FilmCase, Search
from babbitt.kinds.journal.film.stable_equilibrium import is_saddle
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.equilibria import EquilibriumPoint, EquilibriumPoints
    from babbitt.reynolds.solution import FilmSolution

SUPPLY_SHARE = 0.5
"""Supply pressure over η ω (R/c)² from which further equilibria are sought. Assumption: two opposite grooves make
them from 5 on."""

SAME_FILM = 0.01
"""Share by which the film elsewhere must be thinner to be reported: less is the accuracy of a grid."""

__all__ = [
    "warnings_about_equilibria",
    "flattered_by_equilibrium",
    "equilibrium_checks",
    "equilibrium_points",
    "equilibrium_values",
]


def equilibrium_points(case: FilmCase, state: FilmState) -> EquilibriumPoints | None:
    """All equilibria under the load of a case, that of the operating point first; None where they are not
    sought."""
    film = state.solution.film
    wanted = case.search is Search.ALL or (
        case.search is Search.AUTO and (state.left_saddle or _likely(case, film))
    )
    if not (wanted and isinstance(case.duty, PrescribedLoad)) or film.cavitation is Cavitation.HALF_SOMMERFELD:
        return None
    from babbitt.kinds.journal.film.equilibria import find_equilibria

    load = load_vector(case, case.duty.load)
    found = find_equilibria(film, load, case.accuracy.resolution, (state.solution,))
    if len(found.places) == 1 or not (case.bearing.compliance or film.is_starved or closed_pockets(case)):
        return found
    return _each_with_its_own(case, state, found)


def _each_with_its_own(case: FilmCase, state: FilmState, found: EquilibriumPoints) -> EquilibriumPoints:
    """The places of a film whose bore or supplies answer to it: sought with those of the first place, and settled
    each with its own. What does not converge leaves the indices incomplete."""
    from babbitt.kinds.journal.film.equilibria import EquilibriumPoint, EquilibriumPoints, same_place

    first, *others = found.places
    places = [first]
    for other in others:
        again = equilibrium_near_position(case, state, other.position)
        if again is None:
            continue
        if not any(same_place(state.solution.film, again, known.film) for known in places):
            places.append(EquilibriumPoint(with_bore(case, again)))
    return EquilibriumPoints(tuple(places))


def _likely(case: FilmCase, film: JournalFilm) -> bool:
    """Whether further equilibria are worth the time: in lobes, and where supply pressure rivals that of the
    wedge."""
    if film.film_start is FilmStart.WIDEST_GAP:
        return False
    wedge = film.viscosity * abs(film.angular_speed) * (0.5 * film.diameter / film.clearance) ** 2
    supply = max(
        *(max(land.start_pressure, land.end_pressure) for land in film.lands),
        *(pocket.pressure for pocket in film.pockets),
        0.0,
    )
    return isinstance(case.bearing.bore, LobedBore) or supply > SUPPLY_SHARE * wedge


def equilibrium_values(found: EquilibriumPoints | None) -> dict[str, float]:
    """Number of equilibria, and the thinnest film where a journal may stay if it is not the one shown."""
    if found is None:
        return {}
    values = {"equilibria": float(len(found.places))}
    shown = found.places[0].film.minimum_film_thickness
    least = min((one.film.minimum_film_thickness for one in found.places if one.may_hold), default=shown)
    return values | ({"least_resting_film": least} if least < (1.0 - SAME_FILM) * shown else {})


def equilibrium_checks(case: FilmCase, values: Mapping[str, float]) -> Iterator[Check]:
    """Limits of the film thickness, compared with the thinnest film at any equilibrium position."""
    if "least_resting_film" in values:
        for check in film_checks(case, values):
            yield replace(check, quantity="least_resting_film", value=values["least_resting_film"])


def flattered_by_equilibrium(case: FilmCase, shown: FilmSolution) -> Bounds:
    """Checks that the film at a saddle flatters."""
    if not isinstance(case.duty, PrescribedLoad) or not is_saddle(shown):
        return NO_BOUNDS
    return {code: Notice(code, "saddle") for code in FILM_CHECKS}


def warnings_about_equilibria(shown: FilmSolution, found: EquilibriumPoints | None) -> Iterator[Notice]:
    """Further equilibria, and an operating point that the journal leaves by itself."""
    if is_saddle(shown):
        yield Notice("W132", "not_looked_for" if found is None else "not_found")
    if found is None:
        return
    others = found.places[1:]
    if others:
        yield Notice("W131", "others", {"others": len(others), "places": tuple(map(_described, others))})
    if not found.complete:
        yield Notice("W134", values={"found": len(found.places)})


def _described(place: EquilibriumPoint) -> Notice:
    """An equilibrium as a clause of the warning about it."""
    x, y = place.position
    eccentricity, direction = place.film.eccentricity_ratio, math.atan2(y, x)
    return Notice("W131", "place", {
        "eccentricity_ratio": eccentricity, "direction": direction, "stays": _stays(place),
    })  # fmt: skip


def _stays(place: EquilibriumPoint) -> Notice:
    """Whether the journal stays at an equilibrium."""
    if place.holds:
        return Notice("W131", "stays")
    if place.index < 0:
        return Notice("W131", "never_stays")
    least = place.stable_masses.least
    if math.isinf(least):
        return Notice("W131", "whirls")
    return Notice("W131", "whirls_unless", {"critical_mass": least})
