"""The film in a bore that gives way or is distorted by heat: film and displacement settle beside each other.

The displacement is a fixed point: the film is solved with it, and its pressure (and temperature) gives the
displacement again. A soft bore answers by more than it was moved, so plain repetition swings; the steps are
damped, and joined after Anderson (J. ACM 12 (1965) 547; as in Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715,
type II) to meet in few films.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.kinds.journal.film.field import pressure_on
from babbitt.reynolds.deformation.compliance import BoreGrid, Compliance, as_field, joined_step, total_displacement
from babbitt.reynolds.surface.unwrapped_mesh import field_at

if TYPE_CHECKING:
    from babbitt.reynolds.heat.thermal_growth import RingGrowth
    from babbitt.reynolds.heat.thermal_solution import ThermalFilm
    from babbitt.reynolds.model import JournalFilm
    from babbitt.reynolds.solution import FilmSolution

__all__ = [
    "CLOSENESS",
    "ElasticFilm",
    "bore_grid",
    "displacement_under",
    "distortion_by",
    "elastic_film",
    "elastic_thermal_film",
    "warm_displacement",
]

Array = NDArray[np.float64]
SolutionT = TypeVar("SolutionT")

CLOSENESS = 1e-3
"""Share of the least gap to which film and displacement agree."""
MOST_FILMS, MOST_HALVINGS = 60, 8
"""Films, and halvings of a step towards films that carry nothing, until the displacement is not settled."""
DAMPING = 0.6
"""Share of a displacement's change that is taken at first."""
LEAST_DAMPING = 0.05
MEMORY = 8
"""Steps that are joined."""
ROOM = 0.3
"""Change of the displacement at most, in clearances, or one least gap: beyond it the film is another."""
GROWS = 1.5
"""Growth of the mismatch by which a step counts as too bold."""


@dataclass(frozen=True, eq=False)
class ElasticFilm(Generic[SolutionT]):
    """A film and the displacement of its bore.

    Attributes
    ----------
    outcome : Outcome
        Read this first: of the film, or not converged where the displacement did not settle beside it.
    solution : FilmSolution or ThermalFilm
        The last film. Its coefficients hold for a bore that does not follow the motion (frozen displacement).
    bore : BoreGrid
    displacement : ndarray, shape (rows, columns)
        By pressure and temperature, without what was given; m, on ``bore``.
    films : int
        Films that were solved.
    mismatch : float
        Between the displacement of the film and that by its own pressure, over the least gap.
    """

    outcome: Outcome
    solution: SolutionT
    bore: BoreGrid
    displacement: Array
    films: int
    mismatch: float


def bore_grid(film: JournalFilm) -> BoreGrid:
    """Grid on which the bore of a film gives way."""
    return BoreGrid(0.5 * film.diameter, film.width, start=film.field_start)


def displacement_under(compliances: Sequence[Compliance], found: FilmSolution) -> Array:
    """Gain of the gap by the pressure of a film, m, shape (rows, columns) of ``bore_grid``."""
    bore = bore_grid(found.film)
    return total_displacement(compliances, bore, pressure_on(found, bore.theta, bore.z))


def distortion_by(growth: RingGrowth, found: ThermalFilm) -> Array:
    """Gain of the gap by the uneven temperature of a film's bush, m, shape (rows, columns) of ``bore_grid``."""
    bore, lines = bore_grid(found.film.film), found.film.angles.ravel()
    around = np.interp(bore.theta, lines, found.bush_temperature[: lines.size], period=2.0 * np.pi)
    return growth.distortion(bore, around)


def warm_displacement(compliances: Sequence[Compliance], growth: RingGrowth | None, found: ThermalFilm) -> Array:
    """Gain of the gap by pressure and uneven temperature of a film, m, shape (rows, columns) of ``bore_grid``."""
    total = displacement_under(compliances, found.film)
    return total if growth is None else total + distortion_by(growth, found)


def elastic_film(
    film: JournalFilm,
    compliances: Sequence[Compliance],
    solve: Callable[[JournalFilm], FilmSolution],
    closeness: float = CLOSENESS,
    start: Array | None = None,
) -> ElasticFilm[FilmSolution]:
    """Film in a bore that gives way under its pressure.

    Parameters
    ----------
    film : JournalFilm
        Its own ``displacement`` is that without pressure.
    compliances : sequence of babbitt.reynolds.deformation.compliance.Compliance
        What the bore is made of; they add up.
    solve : callable
        Solves a film, at its load or position.
    closeness : float
        Share of the least gap to which film and displacement agree.
    start : ndarray or None
        Displacement to begin with, m, on ``bore_grid(film)``.

    Returns
    -------
    ElasticFilm
        Always, with a status. What `solve` raises passes through.
    """
    displaced = partial(displacement_under, compliances)
    return _Settling(film, bore_grid(film), displaced, solve, lambda found: found).run(closeness, start)


def elastic_thermal_film(
    film: JournalFilm,
    compliances: Sequence[Compliance],
    solve: Callable[[JournalFilm], ThermalFilm],
    growth: RingGrowth | None = None,
    closeness: float = CLOSENESS,
    start: Array | None = None,
) -> ElasticFilm[ThermalFilm]:
    """Thermal film in a bore that gives way under its pressure, or is distorted by its temperature, or both.

    Parameters are those of `elastic_film`, without compliances too; `growth` distorts the bore by the temperature
    around it. Its mean growth belongs to the clearance and is not in the displacement.
    """
    displaced = partial(warm_displacement, compliances, growth)
    return _Settling(film, bore_grid(film), displaced, solve, lambda found: found.film).run(closeness, start)


@dataclass(frozen=True, eq=False)
class _Settling(Generic[SolutionT]):
    """A film, what displaces its bore, how it is solved, and where the film stands in a solution."""

    film: JournalFilm
    bore: BoreGrid
    displaced: Callable[[SolutionT], Array]
    solve: Callable[[JournalFilm], SolutionT]
    film_in: Callable[[SolutionT], FilmSolution]

    def run(self, closeness: float, start: Array | None) -> ElasticFilm[SolutionT]:
        here = self._even(np.zeros((self.bore.rows, self.bore.columns)) if start is None else start)
        films, damping = 1, DAMPING
        found = self._solved(here)
        if not self.film_in(found).outcome.solved:
            return self._ended(found, here, films, np.inf, self.film_in(found).outcome)
        steps: list[tuple[Array, Array]] = []  # places and mismatches, the last one at the end
        while True:
            gap = self.film_in(found).minimum_film_thickness
            off = self._even(self.displaced(found)) - here
            mismatch = float(np.abs(off).max()) / gap
            if mismatch <= closeness:
                return self._ended(found, here, films, mismatch, Outcome.CONVERGED)
            if steps and np.abs(off).max() > GROWS * np.abs(steps[-1][1]).max():
                damping, steps = max(0.5 * damping, LEAST_DAMPING), []
            steps = [*steps[-MEMORY:], (here, off)]
            move = joined_step(steps, damping)
            longest = max(gap, ROOM * self.film.clearance)
            move *= min(1.0, longest / float(np.abs(move).max()))
            before, halvings = found, 0
            while True:
                if films >= MOST_FILMS or halvings > MOST_HALVINGS:
                    return self._ended(before, here, films, mismatch, Outcome.NOT_CONVERGED)
                found, films = self._solved(here + move), films + 1
                if self.film_in(found).outcome.solved:
                    break
                move, damping, steps = 0.5 * move, max(0.5 * damping, LEAST_DAMPING), []
                halvings += 1
            here = here + move

    def _solved(self, displacement: Array) -> SolutionT:
        total = displacement
        if self.film.displacement:
            total = total + field_at(self.film, self.film.displacement, self.bore.theta, self.bore.z)
        return self.solve(replace(self.film, displacement=as_field(self._even(total))))

    def _even(self, values: Array) -> Array:
        """Both halves of the width exactly alike where the film's are: else it would be solved over both."""
        return 0.5 * (values + values[:, ::-1]) if self.film.is_symmetric else values

    def _ended(
        self, found: SolutionT, displacement: Array, films: int, mismatch: float, outcome: Outcome
    ) -> ElasticFilm[SolutionT]:
        return ElasticFilm(outcome, found, self.bore, displacement, films, mismatch)
