"""Whether the journal could rest elsewhere, as the answer of a bearing tells it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.bearings.layout import load_vector
from babbitt.bearings.model import FilmCase, Search
from babbitt.bearings.warm_film import FilmState
from babbitt.design.conditions import GivenLoad
from babbitt.film.model import Cavitation
from babbitt.notices import Notice

if TYPE_CHECKING:
    from babbitt.bearings.equilibria import RestingPlace, RestingPlaces

__all__ = ["doubts_about_rest", "resting_places"]


def resting_places(case: FilmCase, state: FilmState) -> RestingPlaces | None:
    """All equilibria under the load of a case, that of the operating point first; None where they are not
    sought."""
    film = state.solution.film
    cheap = not film.differs_across_width and len(film.lands) > 1
    wanted = case.search is Search.ALL or (case.search is Search.AUTO and cheap)
    if not (wanted and isinstance(case.duty, GivenLoad)) or film.cavitation is Cavitation.HALF_SOMMERFELD:
        return None
    from babbitt.bearings.equilibria import find_equilibria

    load = load_vector(case, case.duty.load)
    return find_equilibria(film, load, case.accuracy.resolution, (state.solution,))


def doubts_about_rest(found: RestingPlaces) -> Iterator[Notice]:
    """Further equilibria, and an operating point that the journal leaves by itself."""
    first, *others = found.places
    if others:
        yield Notice("W131", f"{len(others)} besides the one shown: " + "; ".join(_said(one) for one in others))
    if first.index < 0:
        yield Notice("W132", "the static stiffness of the film is that of a saddle (det K < 0)")
    if not found.complete:
        yield Notice("W134", f"{len(found.places)} found, and their indices do not sum to one")


def _said(place: RestingPlace) -> str:
    x, y = place.position
    direction = math.degrees(math.atan2(y, x))
    kind = "the journal stays there" if place.holds else "it whirls there" if place.index > 0 else "it never stays"
    return f"e/c = {place.film.eccentricity_ratio:.3f} at {direction:.0f}° from +x, {kind}"
