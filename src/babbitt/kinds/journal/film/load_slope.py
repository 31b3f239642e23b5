"""Coefficients of a bearing that are the slope of its own load, and what is said where they are not."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import Notice
from babbitt.core.result import Outcome
from babbitt.kinds.journal.film.isothermal import FilmState, resolution_of
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.reynolds.model import Cavitation, Resolution

if TYPE_CHECKING:
    from babbitt.reynolds.solution import FilmSolution
    from babbitt.reynolds.stability.load_slope import SlopeCheck

__all__ = [
    "confirmed_film",
    "confirmed_state",
    "warnings_about_slope",
    "slope_not_asked",
    "with_bore",
    "with_known_slope",
]


def confirmed_state(case: FilmCase, state: FilmState) -> tuple[FilmState, SlopeCheck | None]:
    """State whose coefficients its own load confirms, at temperatures that stay as they are."""
    thermal = state.thermal
    if not state.solution.outcome.solved or (thermal is None and not state.solution.film.is_surface):
        return state, None
    from babbitt.reynolds.stability.load_slope import confirmed_coefficients

    nodes = thermal.nodes if thermal is not None else None
    solution, check = confirmed_coefficients(state.solution, resolution_of(case), nodes, bore_gain_of(case))
    if thermal is not None:
        thermal = replace(thermal, film=solution)
    return replace(state, solution=solution, thermal=thermal), check


def with_bore(case: FilmCase, found: FilmSolution) -> FilmSolution:
    """A film whose coefficients count how the bore of the case gives way; the same where it is rigid."""
    return confirmed_film(case, found, case.accuracy.resolution) if case.bearing.compliance else found


def with_known_slope(case: FilmCase, found: FilmSolution) -> FilmSolution:
    """As `with_bore`; not converged where the slope of the load in a bore that gives way was not found."""
    if not (case.bearing.compliance and found.outcome.solved and found.film.is_surface):
        return found
    from babbitt.reynolds.stability.load_slope import confirmed_coefficients

    solution, check = confirmed_coefficients(found, case.accuracy.resolution, None, bore_gain_of(case))
    lost = check is not None and not (check.confirmed or check.settled)
    return replace(solution, outcome=Outcome.NOT_CONVERGED) if lost else solution


def confirmed_film(case: FilmCase, found: FilmSolution, grid: Resolution) -> FilmSolution:
    """A film of one temperature with coefficients that its own load confirms, the bore counted."""
    if not (found.outcome.solved and found.film.is_surface):
        return found
    from babbitt.reynolds.stability.load_slope import confirmed_coefficients

    return confirmed_coefficients(found, grid, None, bore_gain_of(case))[0]


def bore_gain_of(case: FilmCase) -> Callable[[FilmSolution], NDArray[np.float64]] | None:
    """How the bore of a case gives way under the pressure of a film; None where it is rigid."""
    if not case.bearing.compliance:
        return None
    from babbitt.kinds.journal.film.elastic_film import displacement_under

    return partial(displacement_under, case.bearing.compliance)


def slope_not_asked(state: FilmState, check: SlopeCheck | None) -> Iterator[Notice]:
    """Why the coefficients were not held against the slope of the load, where they differ from it now and then."""
    film = state.solution.film
    exact = state.thermal is None and not film.is_surface
    if check is not None or exact or film.cavitation is Cavitation.HALF_SOMMERFELD:
        return
    if any(pocket.closed for pocket in film.pockets):
        yield Notice("C122", "closed_pockets")
    else:
        yield Notice("C122", "not_found")


def warnings_about_slope(case: FilmCase, check: SlopeCheck | None) -> Iterator[Notice]:
    """What the slope of the load tells of the coefficients, where it does not confirm them."""
    if check is None:
        if case.bearing.compliance and case.cavitation is not Cavitation.HALF_SOMMERFELD:
            yield Notice("W135", "rigid_bore")
        return
    if check.confirmed:
        return
    if check.settled:
        yield Notice("W136", values={"stiffness": check.stiffness, "damping": check.damping})
    else:
        yield Notice("W135", "differ", {"stiffness": check.stiffness, "damping": check.damping})
