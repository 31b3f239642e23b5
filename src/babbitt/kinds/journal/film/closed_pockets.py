"""Closed pockets and holes: nothing feeds them, and they stand at the pressure at which their net flow vanishes.

Newton's method on the pressures p with the net flows q(p) of whole films (journal at rest, temperatures
included); the derivatives come from one more film for every pocket at first, then from the steps after Broyden
(Math. Comp. 19 (1965) 577). Films that follow each other closely, as with clearance or bore, go on with the
pressures and derivatives of the last one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.film.field import pressure_on
from babbitt.reynolds.model import FilmStart, JournalFilm

if TYPE_CHECKING:
    from babbitt.reynolds.solution import FilmSolution

__all__ = ["ClosedPressures", "closed_film"]

Array = NDArray[np.float64]
SolutionT = TypeVar("SolutionT")

CLOSED = 3e-7
"""Net flow of a closed pocket over all that leaves by the sides, up to which it counts as none."""
MOST_FILMS = 60
"""Films after which the search gives up."""
FIRST_STEP, LONGEST_STEP = 0.02, 0.5
"""Of a pressure, over the highest pressure of the film: the step that tells the first derivative, and any step."""
TRUSTED, TAMED = 2e-4, 5.0
"""Of a step, over the highest pressure of the film, from which it tells derivatives (films closer together differ
by how closely their temperatures have converged), and the factor by which that of a pocket may change at once."""
CALM = 300.0
"""Net flows over those that count as none, below which steps are shortened while the flows do not shrink."""
PATIENT, NEARLY = 15, 9e-7
"""Films after which a net flow that hardly shrinks may be this large."""
HALVINGS = 6
"""Of a step that leads to no film."""
PLACES = 9
"""Around and along a pocket at which the pressure of the film without it is looked at."""


@dataclass
class ClosedPressures:
    """What a search knows of the last film with closed pockets: gauge pressures, Pa, and derivatives of their net
    flows by them, m3/(s Pa)."""

    pressures: Array | None = None
    slopes: Array | None = None


def closed_film(
    film: JournalFilm,
    closed: Sequence[int],
    settle: Callable[[JournalFilm], SolutionT],
    film_in: Callable[[SolutionT], FilmSolution],
    with_outcome: Callable[[SolutionT, Outcome], SolutionT],
    known: ClosedPressures,
    without: Callable[[JournalFilm], FilmSolution],
) -> SolutionT:
    """Film with pockets whose net flow vanishes.

    Parameters
    ----------
    film : JournalFilm
        The pressures of its closed pockets do not count.
    closed : sequence of int
        Numbers of the closed ones among its pockets.
    settle : callable
        Solves a film, at its load or position.
    film_in, with_outcome : callable
        The film in a solution of `settle`, and the solution with another outcome.
    known : ClosedPressures
        Where to start; holds the answer afterwards.
    without : callable
        Solves the film without the closed pockets: its pressure at their places is where the first search starts.

    Returns
    -------
    SolutionT
        With the outcome of the film; `Outcome.STARVED_RECESS` where a closed pocket would send off more than it
        takes even at the cavitation pressure, `Outcome.NOT_CONVERGED` where the pressures were not found.
    """
    return _Search(film, _alike(film, closed), settle, film_in, with_outcome).run(known, without)


def _alike(film: JournalFilm, closed: Sequence[int]) -> list[list[int]]:
    """Closed pockets by themselves, or with their image in the mid-plane: both must keep the same pressure, for a
    film whose halves differ is another."""
    emptied = _with(film, [(number,) for number in closed], np.zeros(len(closed)))
    if not emptied.is_symmetric:
        return [[number] for number in closed]
    groups: dict[tuple[float, float, float, float], list[int]] = {}
    for number in closed:
        one = film.pockets[number]
        key = (one.centre_angle, one.extent, one.axial_length, abs(one.axial_centre))
        groups.setdefault(key, []).append(number)
    return list(groups.values())


def _with(film: JournalFilm, groups: Sequence[Sequence[int]], pressures: Array) -> JournalFilm:
    """Film whose closed pockets stand at some pressures."""
    pockets = list(film.pockets)
    for group, pressure in zip(groups, pressures, strict=True):
        for number in group:
            pockets[number] = replace(pockets[number], pressure=float(pressure))
    return replace(film, pockets=tuple(pockets))


@dataclass(frozen=True, eq=False)
class _At(Generic[SolutionT]):
    """A solution, its pressures and net flows."""

    found: SolutionT
    pressures: Array
    flows: Array
    scale: float
    highest: float


@dataclass(frozen=True, eq=False)
class _Search(Generic[SolutionT]):
    film: JournalFilm
    groups: list[list[int]]
    settle: Callable[[JournalFilm], SolutionT]
    film_in: Callable[[SolutionT], FilmSolution]
    with_outcome: Callable[[SolutionT, Outcome], SolutionT]

    def run(self, known: ClosedPressures, without: Callable[[JournalFilm], FilmSolution]) -> SolutionT:
        lowest = self.film.cavitation_pressure
        start = self._from_outside(without) if known.pressures is None else known.pressures
        found = self.settle(_with(self.film, self.groups, np.maximum(start, lowest)))
        if not self.film_in(found).outcome.solved:
            return found
        here = self._seen(found, np.maximum(start, lowest))
        slopes, share, before = known.slopes, 1.0, np.inf
        for films in range(MOST_FILMS):
            nothing = (CLOSED if films < PATIENT else NEARLY) * here.scale
            starved = (here.pressures <= lowest) & (here.flows > nothing)
            free = ~starved
            if (np.abs(here.flows[free]) <= nothing).all():
                known.pressures, known.slopes = here.pressures, slopes
                return self.with_outcome(here.found, Outcome.STARVED_RECESS) if starved.any() else here.found
            if slopes is None:
                slopes = self._probed(here, lowest)
                if slopes is None:
                    break
            move = np.zeros(free.size)
            try:
                move[free] = -np.linalg.solve(slopes[np.ix_(free, free)], here.flows[free])
            except np.linalg.LinAlgError:
                break
            off = float(np.abs(here.flows[free]).max())
            if off < CALM * nothing:
                share = max(0.5 * share, 0.1) if off > 0.7 * before else min(1.0, 1.5 * share)
            there = self._moved(here, share * move, lowest)
            if there is None:
                break
            slopes, before = _learnt(slopes, here, there), off
            here = there
        return self.with_outcome(here.found, Outcome.NOT_CONVERGED)

    def _probed(self, here: _At[SolutionT], lowest: float) -> Array | None:
        """Derivatives of the net flows, from one more film for every pocket; None where one leads nowhere."""
        columns = []
        for number in range(here.flows.size):
            move = np.zeros(here.flows.size)
            move[number] = FIRST_STEP * here.highest * (1.0 if here.flows[number] < 0.0 else -1.0)
            if here.pressures[number] + move[number] <= lowest:
                move[number] = FIRST_STEP * here.highest
            there = self._moved(here, move, lowest)
            if there is None:
                return None
            column = (there.flows - here.flows) / (there.pressures[number] - here.pressures[number])
            if not column[number] > 0.0:
                return None
            columns.append(column)
        return np.array(columns).T

    def _moved(self, here: _At[SolutionT], move: Array, lowest: float) -> _At[SolutionT] | None:
        """The film at other pressures, or less far away where there is none; None where none is near."""
        move = np.clip(move, -LONGEST_STEP * here.highest, LONGEST_STEP * here.highest)
        for _ in range(HALVINGS):
            pressures = np.maximum(here.pressures + move, lowest)
            try:
                found = self.settle(_with(self.film, self.groups, pressures))
            except NoFilmError:
                found = None
            if found is not None and self.film_in(found).outcome.solved:
                return self._seen(found, pressures)
            move = 0.5 * move
        return None

    def _seen(self, found: SolutionT, pressures: Array) -> _At[SolutionT]:
        solution = self.film_in(found)
        first = solution.supply_flow.size - len(self.film.pockets)
        flows = np.array([sum(solution.supply_flow[first + number] for number in group) for group in self.groups])
        return _At(found, pressures, flows, solution.leaving_flow, solution.maximum_pressure)

    def _from_outside(self, without: Callable[[JournalFilm], FilmSolution]) -> Array:
        """Mean pressure, at the place of every closed pocket, of the film without them; ambient if it has none."""
        closed = {number for group in self.groups for number in group}
        others = tuple(one for number, one in enumerate(self.film.pockets) if number not in closed)
        ambient = np.zeros(len(self.groups))
        if not others and self.film.film_start is FilmStart.PERIODIC:
            return ambient
        try:
            found = without(replace(self.film, pockets=others))
        except NoFilmError:
            return ambient
        if not found.outcome.solved:
            return ambient
        across = np.linspace(-0.5, 0.5, PLACES)
        means = []
        for number, *_ in self.groups:
            one = self.film.pockets[number]
            theta, z = one.centre_angle + one.extent * across, one.axial_centre + one.axial_length * across
            means.append(float(pressure_on(found, theta, z).mean()))
        return np.array(means)


def _learnt(slopes: Array, here: _At[SolutionT], there: _At[SolutionT]) -> Array:
    """Derivatives of the net flows after one more film."""
    moved, changed = there.pressures - here.pressures, there.flows - here.flows
    if np.abs(moved).max() < TRUSTED * here.highest:
        return slopes
    better = np.asarray(slopes + np.outer(changed - slopes @ moved, moved) / float(moved @ moved))
    ratio = np.diag(better) / np.diag(slopes)
    return better if (ratio > 1.0 / TAMED).all() and (ratio < TAMED).all() else slopes
