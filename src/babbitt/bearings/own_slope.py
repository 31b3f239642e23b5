"""Coefficients of a bearing that are the slope of its own load, and what is said where they are not."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.bearings.model import FilmCase
from babbitt.bearings.warm_film import FilmState, resolution_of
from babbitt.notices import Notice

if TYPE_CHECKING:
    from babbitt.film.own_slope import SlopeCheck

__all__ = ["confirmed_state", "doubts_about_slope"]


def confirmed_state(case: FilmCase, state: FilmState) -> tuple[FilmState, SlopeCheck | None]:
    """State whose coefficients its own load confirms; films with their own temperatures stay as they are."""
    if case.heat is not None or not state.solution.outcome.solved or not state.solution.film.is_surface:
        return state, None
    from babbitt.film.own_slope import confirmed_coefficients

    solution, check = confirmed_coefficients(state.solution, resolution_of(case))
    return replace(state, solution=solution), check


def doubts_about_slope(check: SlopeCheck | None) -> Iterator[Notice]:
    """What the slope of the load tells of the coefficients, where it does not confirm them."""
    if check is None or check.confirmed:
        return
    measured = f"stiffness by {check.stiffness:.1%}, damping by {check.damping:.1%}"
    if check.settled:
        yield Notice("W136", f"the derivative with frozen ends of the film differs from the slope: {measured}")
    else:
        yield Notice("W135", f"they differ from the slope of the film's own load: {measured}")
