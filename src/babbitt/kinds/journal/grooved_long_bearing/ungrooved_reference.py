"""The grooved bearing compared with the ungrooved one: at the same gap, and under the same load.

A bearing cut into two segments has two mean temperatures in place of one, which by itself makes it colder. What a
groove does is therefore compared with the ungrooved film cut at the same angle, besides the ungrooved film itself.
"""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentFilm
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState


@dataclass(frozen=True)
class UngroovedReference:
    """Ungrooved films to compare a grooved one with; None where there is no such film.

    Attributes
    ----------
    same_gap, cut_same_gap : SegmentFilmState or None
        At the eccentricity (or profile) of the grooved film: in one segment, and cut at the angle of the groove.
    same_load, cut_same_load : SegmentFilmState or None
        Under the load of the grooved film.
    """

    same_gap: SegmentFilmState | None
    cut_same_gap: SegmentFilmState | None
    same_load: SegmentFilmState | None
    cut_same_load: SegmentFilmState | None


def ungrooved_films(asked: SegmentFilm, state: SegmentFilmState) -> UngroovedReference:
    """The ungrooved films to compare a grooved one with.

    At the same gap the film is cut where the groove lies in it; under the same load the journal moves, and a
    groove that keeps its place in the bush has that place there, too.

    Parameters
    ----------
    asked : SegmentFilm
        The grooved film as the case has it.
    state : SegmentFilmState
        Its equilibrium.
    """
    film, eccentricity = state.film, state.eccentricity_ratio
    return UngroovedReference(
        _at(film.without_groove(), eccentricity),
        _at(film.cut(), eccentricity),
        None if film.profile else _under(asked.without_groove(), state.load),
        None if film.profile else _under(asked.cut(), state.load),
    )


def _at(film: SegmentFilm, eccentricity_ratio: float) -> SegmentFilmState | None:
    try:
        found = film_at_eccentricity(film, eccentricity_ratio)
    except NoFilmError:
        return None
    return found if found.converged else None


def _under(film: SegmentFilm, load: float) -> SegmentFilmState | None:
    try:
        found = film_under_load(film, load)
    except NoFilmError:
        return None
    return found if found.converged else None
