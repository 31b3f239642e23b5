"""The film in a bore that gives way or is distorted by heat: film and displacement are solved together.

The displacement is a fixed point: the film is solved with it, and its pressure (and temperature) gives the
displacement again. A soft bore answers by more than it was moved, so plain repetition swings; the steps are
damped, and combined (`babbitt.numerics.anderson`) to meet in few films.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.kinds.journal.film.field import pressure_on
from babbitt.numerics.anderson import AndersonOptions, fixed_point
from babbitt.numerics.secants import RecycledSecants
from babbitt.reynolds.deformation.compliance import BoreGrid, Compliance, as_field, total_displacement
from babbitt.reynolds.surface.unwrapped_mesh import field_at

if TYPE_CHECKING:
    from babbitt.reynolds.heat.thermal_growth import RingGrowth
    from babbitt.reynolds.heat.thermal_solution import ThermalFilm
    from babbitt.reynolds.model import JournalFilm
    from babbitt.reynolds.solution import FilmSolution

__all__ = [
    "CLOSENESS",
    "ElasticFilm",
    "KnownBore",
    "bore_grid",
    "displacement_under",
    "distortion_by",
    "elastic_film",
    "elastic_thermal_film",
    "thermal_displacement",
]

Array = NDArray[np.float64]
SolutionT = TypeVar("SolutionT")

CLOSENESS = 1e-3
"""Share of the least gap to which film and displacement agree."""
SETTLING = AndersonOptions(most_evaluations=60, damping=0.6, astray=5.0, most_failures=8)
"""How the displacement is sought, in films."""
FROM_KNOWN = replace(SETTLING, most_evaluations=30)
"""How it is sought first from what films before tell."""
ROOM = 0.3
"""Change of the displacement at most, in clearances, or one least gap: beyond it the film is another."""


LESSONS = 6
"""Films that tell of a bore. Those after them begin alike: what they answer must not depend on the film before."""


@dataclass(eq=False)
class KnownBore:
    """What films before tell of a bore: where it converged, m, on ``bore_grid``, and how films answer to it."""

    lessons: int = 0
    displacement: Array | None = None
    secants: RecycledSecants = field(default_factory=lambda: RecycledSecants(SETTLING.damping, SETTLING.astray))


@dataclass(frozen=True, eq=False)
class ElasticFilm(Generic[SolutionT]):
    """A film and the displacement of its bore.

    Attributes
    ----------
    outcome : Outcome
        Read this first: of the film, or not converged where the displacement did not converge with it.
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


def thermal_displacement(
    compliances: Sequence[Compliance], growth: RingGrowth | None, found: ThermalFilm
) -> Array:
    """Gain of the gap by pressure and uneven temperature of a film, m, shape (rows, columns) of ``bore_grid``."""
    total = displacement_under(compliances, found.film)
    return total if growth is None else total + distortion_by(growth, found)


def elastic_film(
    film: JournalFilm,
    compliances: Sequence[Compliance],
    solve: Callable[[JournalFilm], FilmSolution],
    closeness: float = CLOSENESS,
    start: Array | None = None,
    known: KnownBore | None = None,
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
    known : KnownBore or None
        From films of this bore that differ little, in place of ``start`` where it knows one; it learns.

    Returns
    -------
    ElasticFilm
        Always, with a status. What `solve` raises passes through.
    """
    displaced = partial(displacement_under, compliances)
    search = partial(_Settling, film, bore_grid(film), displaced, solve, lambda found: found)
    if known is None:
        return search().run(closeness, start)
    found = None
    if known.displacement is not None:
        found = search(known.secants).run(closeness, known.displacement)
        if found.outcome.solved and known.lessons < LESSONS:
            known.lessons, known.displacement = known.lessons + 1, found.displacement
        else:
            known.secants.undo()
    if found is None or not found.outcome.solved:  # the bore of another film may leave this one none
        found = search().run(closeness, start)
        if known.displacement is not None and not found.outcome.solved:  # nor the bore without pressure
            found = search().run(closeness, known.displacement)
        if found.outcome.solved and known.displacement is None:
            known.displacement = found.displacement
    return found


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
    displaced = partial(thermal_displacement, compliances, growth)
    return _Settling(film, bore_grid(film), displaced, solve, lambda found: found.film).run(closeness, start)


@dataclass(eq=False)
class _Settling(Generic[SolutionT]):
    """A film, what displaces its bore, how it is solved, and where the film stands in a solution.

    As it is settled: films that were solved, the last of them, the last one that is a film, and its mismatch.
    """

    film: JournalFilm
    bore: BoreGrid
    displaced: Callable[[SolutionT], Array]
    solve: Callable[[JournalFilm], SolutionT]
    film_in: Callable[[SolutionT], FilmSolution]
    secants: RecycledSecants | None = None
    last: SolutionT | None = None
    found: SolutionT | None = None
    mismatch: float = np.inf

    def run(self, closeness: float, start: Array | None) -> ElasticFilm[SolutionT]:
        begin = self._even(np.zeros((self.bore.rows, self.bore.columns)) if start is None else start)
        ended = fixed_point(
            self._off, lambda _, off: self.mismatch <= closeness, begin.ravel(),
            SETTLING if self.secants is None else FROM_KNOWN, self._bounded,
            secants=self.secants,
        )  # fmt: skip
        solution, outcome = self.found, Outcome.CONVERGED if ended.converged else Outcome.NOT_CONVERGED
        if solution is None:
            assert self.last is not None  # a search looks at its start
            solution, outcome = self.last, self.film_in(self.last).outcome
        displacement = ended.state.reshape(begin.shape)
        return ElasticFilm(outcome, solution, self.bore, displacement, ended.evaluations, self.mismatch)

    def _off(self, displacement: Array) -> Array | None:
        """Between the displacement by a film's own pressure and the one that it has; None where it is no film."""
        here = displacement.reshape(self.bore.rows, self.bore.columns)
        self.last = self._solved(here)
        if not self.film_in(self.last).outcome.solved:
            return None
        self.found = self.last
        off = self._even(self.displaced(self.found)) - here
        self.mismatch = float(np.abs(off).max()) / self._gap
        return off.ravel()

    def _bounded(self, _: Array, move: Array) -> Array:
        longest = max(self._gap, ROOM * self.film.clearance)
        return np.asarray(move * min(1.0, longest / float(np.abs(move).max())))

    @property
    def _gap(self) -> float:
        assert self.found is not None
        return self.film_in(self.found).minimum_film_thickness

    def _solved(self, displacement: Array) -> SolutionT:
        total = displacement
        if self.film.displacement:
            total = total + field_at(self.film, self.film.displacement, self.bore.theta, self.bore.z)
        return self.solve(replace(self.film, displacement=as_field(self._even(total))))

    def _even(self, values: Array) -> Array:
        """Both halves of the width exactly alike where the film's are: else it would be solved over both."""
        return 0.5 * (values + values[:, ::-1]) if self.film.is_symmetric else values
