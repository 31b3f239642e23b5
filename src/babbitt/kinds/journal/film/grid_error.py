"""How far the grid may be wrong: the same film on a finer grid, and what that leaves over by Richardson."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.film.isothermal import FilmState, resolution_of
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.load_slope import confirmed_film
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of
from babbitt.kinds.journal.film.unloaded import is_unloaded
from babbitt.reynolds.model import Resolution

if TYPE_CHECKING:
    from babbitt.reynolds.solution import FilmSolution

__all__ = ["finer", "grid_errors"]

REFINEMENTS, FINEST = (4, 2), 768
"""The finer grids have so many times as many intervals; none has more than this, unless twice as many as the grid
of the case are."""

COEFFICIENTS = ("stiffness_error", "damping_error")

MORE_UNKNOWNS, MOST_UNKNOWNS = 4, 12
"""And so many more unknowns across half the width, whose error falls faster than any power."""


def finer(grid: Resolution, times: int = REFINEMENTS[0]) -> Resolution:
    """A finer grid with which one is compared.

    >>> from babbitt.reynolds.model import ENGINEERING
    >>> finer(ENGINEERING).intervals, finer(ENGINEERING).axial_unknowns
    (384, 8)
    """
    return replace(
        grid,
        intervals=max(2 * grid.intervals, min(times * grid.intervals, FINEST)),
        axial_unknowns=min(grid.axial_unknowns + MORE_UNKNOWNS, MOST_UNKNOWNS),
    )


def grid_errors(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Estimated errors by the grid, as shares of what they belong to.

    Parameters
    ----------
    case : FilmCase
    state : FilmState
        Its film, at the accuracy of the case; clearance, viscosity and supply pressures are kept.

    Returns
    -------
    dict
        ``minimum_film_thickness_error`` over the film thickness and ``position_error`` (distance of the journal
        centres) over the clearance, or, where the case prescribes the position, ``load_error`` over the load;
        ``stiffness_error`` and ``damping_error`` as the Frobenius norm of the difference over that of the matrix.
        Empty where no finer film has an answer.

    Notes
    -----
    The circumferential error falls with the square of the interval h. With the film f(h) and a grid r times as
    fine, ``|f(h) - f(0)| = |f(h/r) - f(h)| r² / (r² - 1)``. Source: Roache P.J. (1994), Perspective: a method for
    uniform reporting of grid refinement studies, J. Fluids Engineering 116, 405-413. The finer grid is finer
    across the width, too, and the share of that direction in the difference is enlarged along with the rest. The
    film boundaries jump from line to line, so that the coefficients approach their limit less evenly than the
    position: for them the larger of the estimates with r = 2 and 4 counts.
    """
    grid = resolution_of(case)
    estimates = []
    for fine in {finer(grid, times): None for times in REFINEMENTS}:
        better = _on_grid(case, state, fine)
        if better.outcome.solved:
            rest = _whole_over_removed(fine.intervals / grid.intervals)
            estimates.append({name: rest * off for name, off in _differences(case, state, better)})
    if not estimates:
        return {}
    largest = {name: max(one[name] for one in estimates) for name in COEFFICIENTS}
    return estimates[0] | largest


def _whole_over_removed(ratio: float) -> float:
    """The whole error over the part of it that a grid so many times as fine removes."""
    return ratio**2 / (ratio**2 - 1.0)


def _on_grid(case: FilmCase, state: FilmState, grid: Resolution) -> FilmSolution:
    from babbitt.reynolds.equilibrium.position import film_at_position

    film = state.solution.film
    if isinstance(case.duty, PrescribedLoad):
        found = converged_film(film, load_vector(case, case.duty.load), grid, place_of(state.solution))
    else:
        x, y = state.solution.position
        found = film_at_position(film, (x, y), resolution=grid)
    return confirmed_film(case, found, grid)


def _differences(case: FilmCase, state: FilmState, better: FilmSolution) -> Iterator[tuple[str, float]]:
    found = state.solution
    if isinstance(case.duty, PrescribedLoad):
        thickness = better.minimum_film_thickness
        yield "minimum_film_thickness_error", abs(thickness - found.minimum_film_thickness) / thickness
        yield "position_error", float(np.hypot(*(better.position - found.position))) / found.film.clearance
    elif not is_unloaded(case, state):
        yield "load_error", _share(better.force - found.force, better.force)
    yield "stiffness_error", _share(better.stiffness - found.stiffness, better.stiffness)
    yield "damping_error", _share(better.damping - found.damping, better.damping)


def _share(difference: object, whole: object) -> float:
    return float(np.linalg.norm(np.asarray(difference)) / np.linalg.norm(np.asarray(whole)))
