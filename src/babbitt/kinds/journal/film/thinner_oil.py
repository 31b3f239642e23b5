"""The film of a journal whose gap is narrowed at places, with thinner oil."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.film.isothermal import FilmState, resolution_of
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of

__all__ = ["film_over_viscosity"]


def film_over_viscosity(case: FilmCase, state: FilmState) -> Callable[[float], float] | None:
    """Least film thickness in m over a factor of the viscosity; 0 where no film is found.

    Tilt, a crowned bore and one that is out of round take the same length from the film however thick it is:
    ``h_min = c (1 - ε) - |slope| B/2`` at the edge of a tilted journal. The same change of ε takes a larger share
    of what is left, so that the film must be solved again. None for a gap without them, whose film goes at most
    with the viscosity, and for a prescribed position.

    Parameters
    ----------
    case : FilmCase
    state : FilmState
        Its film; clearance, supply pressures and the bore, as it has given way, are kept.
    """
    bearing, duty = case.bearing, case.duty
    narrowed = bearing.misalignment != (0.0, 0.0) or bearing.crowning or bearing.displacement
    if not narrowed or not isinstance(duty, PrescribedLoad):
        return None
    film, load, place = state.solution.film, load_vector(case, duty.load), place_of(state.solution)

    def thickness(factor: float) -> float:
        thin = replace(film, viscosity=factor * film.viscosity)
        found = converged_film(thin, load, resolution_of(case), place)
        return found.minimum_film_thickness if found.outcome.solved else 0.0

    return thickness
