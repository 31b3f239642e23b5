"""Every place where a journal can be in equilibrium under its load: a film can have more than one.

Over the room that the bore leaves the journal, the force of film and load together is a field in the plane. Its
zeros are the equilibria. Around each cell of a mesh the direction of the field turns by a whole number of turns,
the sum of the indices of the zeros inside; a cell with a turn is a start for a root finder with the exact
stiffness. The index of a zero is the sign of det K, and where contact pushes inward all around, the indices sum to
one (Poincaré-Hopf): an equilibrium more comes with a saddle more, and a sum that is not one tells that something
was missed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.film.field import clearance_outline
from babbitt.reynolds.equilibrium.many_positions import FilmPositions
from babbitt.reynolds.equilibrium.nearby import SAME_PLACE, equilibrium_near
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import DRAFT, JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.stability.routh import StableMasses, stable_masses

__all__ = ["EquilibriumPoint", "EquilibriumPoints", "find_equilibria", "same_place"]

Array = NDArray[np.float64]

DIRECTIONS = 16
"""Rays of the mesh."""

DEPTHS = (0.2, 0.4, 0.6, 0.8, 0.93, 0.985, 0.998)
"""Rings of the mesh: shares of the way from the centre to contact."""


STEEP = 0.5 * math.pi
"""Turn of the force along one side of a cell, in rad, beyond which its sense is not certain."""


@dataclass(frozen=True, eq=False)
class EquilibriumPoint:
    """An equilibrium of the journal.

    Attributes
    ----------
    film : FilmSolution
        There.
    """

    film: FilmSolution

    @property
    def position(self) -> tuple[float, float]:
        """Of the journal centre, m."""
        x, y = self.film.position
        return float(x), float(y)

    @property
    def index(self) -> int:
        """Sign of det K: 1 for a place the journal can hold or circle, -1 for a saddle that it always leaves."""
        return 1 if np.linalg.det(self.film.stiffness) > 0.0 else -1

    @property
    def stable_masses(self) -> StableMasses:
        """Masses of a rigid rotor that stays here, kg."""
        return stable_masses(self.film.stiffness, self.film.damping)

    @property
    def holds(self) -> bool:
        """Whether a journal of very little mass comes back."""
        return self.stable_masses.least == 0.0

    @property
    def may_hold(self) -> bool:
        """Whether a journal of some mass comes back."""
        return math.isfinite(self.stable_masses.least)


@dataclass(frozen=True, eq=False)
class EquilibriumPoints:
    """All equilibria found, and whether their indices sum to one, as they must if none was missed."""

    places: tuple[EquilibriumPoint, ...]

    @property
    def complete(self) -> bool:
        """Whether the indices sum to one."""
        return sum(place.index for place in self.places) == 1


def find_equilibria(
    film: JournalFilm,
    load: tuple[float, float],
    resolution: Resolution = DRAFT,
    known: tuple[FilmSolution, ...] = (),
) -> EquilibriumPoints:
    """Look for every equilibrium of a journal under a load.

    Parameters
    ----------
    film : JournalFilm
        With stiffness: not half-Sommerfeld.
    load : tuple of float
        Force on the journal, N.
    resolution : Resolution
        Of the equilibria; the field is seen in `DRAFT`.
    known : tuple of FilmSolution
        Equilibria found already; they come first.

    Returns
    -------
    EquilibriumPoints
        Empty where nothing carries the load. Equilibria nearer to contact than the last of `DEPTHS` are found only
        if known, or if `babbitt.reynolds.equilibrium.solve.solve_journal` finds them.
    """
    places = [EquilibriumPoint(one) for one in known]

    def add(found: FilmSolution | None) -> None:
        if found is not None and not any(same_place(film, found, place.film) for place in places):
            places.append(EquilibriumPoint(found))

    coarse = _Mesh.of(film, np.asarray(load), DIRECTIONS)
    add_from = partial(_add_from, film, load, resolution, add)
    add_from(coarse.turning())
    if EquilibriumPoints(tuple(places)).complete:
        return EquilibriumPoints(tuple(places))
    carried = solve_journal(film, load, resolution)  # it looks closer to contact, on the loaded side
    add(carried if carried.outcome.solved else None)
    fine = _Mesh.of(film, np.asarray(load), 2 * DIRECTIONS)
    for starts in (fine.turning(), fine.steep(), coarse.everywhere() if places else ()):
        if not EquilibriumPoints(tuple(places)).complete:
            add_from(starts)
    return EquilibriumPoints(tuple(places))


def _add_from(
    film: JournalFilm,
    load: tuple[float, float],
    resolution: Resolution,
    add: Callable[[FilmSolution | None], None],
    starts: Iterable[Array],
) -> None:
    for x, y in starts:
        add(equilibrium_near(film, load, (float(x), float(y)), resolution))


def same_place(film: JournalFilm, one: FilmSolution, other: FilmSolution) -> bool:
    """Whether two equilibria are one."""
    return math.hypot(*(one.position - other.position)) < SAME_PLACE * film.clearance


@dataclass(frozen=True, eq=False)
class _Mesh:
    """Force of film and load over the room of the journal, shape (1 + depths, directions, 2) like its nodes."""

    nodes: Array
    force: Array

    @classmethod
    def of(cls, film: JournalFilm, load: Array, directions: int) -> _Mesh:
        """Where no film is found the journal touches, and contact pushes it inward."""
        towards_load = math.atan2(load[1], load[0])  # rays as the load has them, not the frame
        angles = towards_load + np.arange(directions) * (2.0 * math.pi / directions)
        outline = clearance_outline(film, np.asarray(angles, dtype=np.float64))
        rays = outline[:, None] * np.stack((np.cos(angles), np.sin(angles)), axis=1)
        nodes = np.multiply.outer((0.0, *DEPTHS), rays)
        places = np.concatenate((nodes[0, :1], nodes[1:].reshape(-1, 2)))
        found = FilmPositions(film, DRAFT).forces(np.hstack((places, np.zeros_like(places))))
        pushed = np.where(found.settled[:, None], found.force + load, -places)
        force = np.concatenate((np.broadcast_to(pushed[0], nodes[:1].shape), pushed[1:].reshape(nodes[1:].shape)))
        return cls(nodes, force)

    @property
    def turns(self) -> Array:
        """Angles in rad, within half a turn, by which the force turns along the four sides of each cell, shape
        (4, depths, directions): along the inner side, outward, back along the outer side, inward."""
        towards = np.arctan2(self.force[..., 1], self.force[..., 0])
        after = np.roll(towards, -1, axis=1)
        corners = np.stack((towards[:-1], after[:-1], after[1:], towards[1:], towards[:-1]))
        return np.asarray(np.remainder(np.diff(corners, axis=0) + math.pi, 2.0 * math.pi) - math.pi)

    @property
    def middles(self) -> Array:
        """Of the cells, m."""
        along = self.nodes + np.roll(self.nodes, -1, axis=1)
        return np.asarray(0.25 * (along[:-1] + along[1:]))

    def turning(self) -> Array:
        """Middles of the cells around which the force turns."""
        return np.asarray(self.middles[np.abs(self.turns.sum(axis=0)) > math.pi])

    def steep(self) -> Array:
        """Middles of the other cells along a side of which the force turns so far that a turn may be missed."""
        whole = np.abs(self.turns.sum(axis=0)) > math.pi
        return np.asarray(self.middles[(np.abs(self.turns).max(axis=0) > STEEP) & ~whole])

    def everywhere(self) -> Array:
        """All nodes, those next to contact first."""
        return np.asarray(self.nodes[:0:-1].reshape(-1, 2))
