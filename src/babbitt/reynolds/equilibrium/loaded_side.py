"""Search for an equilibrium from the loaded side: the journal pushed along its load, deeper and deeper.

Between supplies under pressure, or with a load that points at the edge of a groove, the force of the film along
the load's direction first falls with growing eccentricity and rises only close to contact. A search that starts
in the middle can then leave the film although one carries the load: before an overload is stated, the places where
the film reaches the load on this side are tried.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.equilibrium.cavitating_film import equilibrium_from
from babbitt.reynolds.equilibrium.nearby import equilibrium_near
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import DRAFT, JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.unwrapped_mesh import axial_gain, bore_gap

__all__ = ["from_loaded_side"]

Array = NDArray[np.float64]

REMAINING = (0.5, 0.3, 0.2, 0.1, 0.05, 0.03, 0.02, 0.01, 5e-3, 3e-3, 2e-3, 1e-3)
"""Shares of the way from the centre to contact that are left, in the order in which they are tried."""

HALVINGS = 4
"""Of the last step on the way, towards the place at which the film just carries the load."""

MOST_STARTS = 3
"""Depths from which an equilibrium is sought."""

PLACES = 1440
"""Angles around the bore at which contact is looked for, in addition to the edges of the lands."""


def from_loaded_side(
    film: JournalFilm, load: tuple[float, float], resolution: Resolution, max_steps: int, lost: FilmSolution
) -> FilmSolution:
    """Equilibrium found from the loaded side; ``lost``, the end of a search from the middle, where there is none.

    Parameters
    ----------
    film : JournalFilm
    load : tuple of float
        Force on the journal, N; not zero.
    resolution : Resolution
        Of the answer; the places to start from are sought on a draft grid.
    max_steps : int
    lost : FilmSolution
    """
    begun = time.perf_counter() - lost.wall_time
    for start in islice(carrying_films(film, np.asarray(load)), MOST_STARTS):
        place = start.position
        for grid in (DRAFT, resolution):
            closer = equilibrium_near(film, load, (float(place[0]), float(place[1])), grid)
            if closer is None:
                break
            place = closer.position
        else:
            found = equilibrium_from(film, load, resolution, max_steps, (float(place[0]), float(place[1])))
            if found.outcome.solved:
                return replace(found, wall_time=time.perf_counter() - begun)
    return lost


def carrying_films(film: JournalFilm, load: Array) -> Iterator[FilmSolution]:
    """Films that carry at least the load in its direction, on the way to contact; the thickest one first."""
    size = math.hypot(*load)
    towards = load / size
    room = way_to_contact(film, towards) * film.clearance

    def carried(remaining: float) -> FilmSolution | None:
        x, y = (1.0 - remaining) * room * towards
        found = film_at_position(film, (float(x), float(y)), resolution=DRAFT)
        return found if found.outcome.solved and -float(found.force @ towards) >= size else None

    before = 1.0
    for remaining in REMAINING:
        found = carried(remaining)
        if found is not None:
            yield nearest(carried, before, remaining, found)
        before = remaining


def nearest(
    carried: Callable[[float], FilmSolution | None], wide: float, narrow: float, found: FilmSolution
) -> FilmSolution:
    """Film between two depths that just carries the load; ``found`` is the deeper one, which does."""
    for _ in range(HALVINGS):
        middle = math.sqrt(wide * narrow)
        better = carried(middle)
        if better is None:
            wide = middle
        else:
            narrow, found = middle, better
    return found


def way_to_contact(film: JournalFilm, towards: Array) -> float:
    """How far the journal can move in a direction before it touches, in clearances."""
    edges = [edge for land in film.lands for edge in (land.start_angle, land.end_angle)]
    angle = np.concatenate((np.linspace(0.0, 2.0 * math.pi, PLACES, endpoint=False), edges))
    gap = bore_gap(film, angle)
    if not film.is_straight:
        gap += axial_gain(film, angle, np.array([-0.5, 0.0, 0.5]) * film.width).min(axis=1) / film.clearance
    approach = towards[0] * np.cos(angle) + towards[1] * np.sin(angle)
    near = approach > 1e-9
    return max(float((gap[near] / approach[near]).min()), 0.0)
