"""The methods of journal bearings. Heavy libraries are imported when the first problem is solved."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.core.result import Result
    from babbitt.kinds.journal.film.coefficients_over_speed import SpeedRun
    from babbitt.kinds.journal.film.model import FilmCase
    from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
    from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
    from babbitt.kinds.journal.iso7902.model import DesignCase
    from babbitt.kinds.journal.oil_balance.model import OilSystemProblem

__all__ = ["METHODS", "Film", "GroovedLongBearing", "InfinitelyLongBearing", "Iso7902", "OilBalance"]


WHIRL_SPEEDS = {"threshold_speed", "threshold_speed_elastic"}
"""What a search through many films tells, and no limit is held against."""


@dataclass(frozen=True)
class Iso7902(Method):
    """The design procedure of ISO 7902."""

    name: ClassVar[str] = "iso7902"

    def solve(self, problem: DesignCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve by the tables of characteristics and the heat balance of the standard.

        A bearing that keeps its limits by less than films with temperatures of their own may differ, whose housing
        is cooled, or through whose gap the supply presses much oil, is held against such a film, too. What keeps
        its limits at a mean clearance is solved at the limits of that.
        """
        from babbitt.kinds.journal.limits_of_clearance import held_at_limits

        return (Solution(problem, held_at_limits(problem, _held_against_film(problem), _held_against_film)),)

    def only(self, problem: DesignCase, quantities: Collection[str]) -> DesignCase:
        """The procedure of the standard alone: of many bearings margins are asked in place of a film of each."""
        return replace(problem, fuller_film=None)


def _held_against_film(problem: DesignCase) -> Result:
    """The procedure of the standard at one clearance, and what the film of the bearing misses of its limits."""
    from babbitt.kinds.journal.iso7902.procedure import check
    from babbitt.kinds.journal.one_temperature import may_be_pressed

    result, film = check(problem), problem.fuller_film
    sure = tuple(one for one in result.warnings if one.code != "W191")
    near = problem.cooling is not None or sure != result.warnings
    if film is None or not result.keeps_all_limits or not (near or may_be_pressed(result.values)):
        return result
    from babbitt.kinds.journal.film.check import beside_fuller_film
    from babbitt.kinds.journal.film.fuller_film import misses_a_limit

    # What the film keeps is not questioned any more, and what it misses is known.
    held = beside_fuller_film(replace(result, warnings=sure), film)
    return held if near or misses_a_limit(held) else result


@dataclass(frozen=True)
class Film(Method):
    """The film in two dimensions, of one temperature or with its own."""

    name: ClassVar[str] = "film"

    def solve(self, problem: FilmCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve the film; `progress` follows the cycles of an orbit. The solution keeps the film."""
        from babbitt.kinds.journal.film.check import film_solution

        return (film_solution(problem, progress),)

    def only(self, problem: FilmCase, quantities: Collection[str]) -> FilmCase:
        """The film without the speed at which the rotor whirls unless it is asked for."""
        return problem if WHIRL_SPEEDS & set(quantities) else replace(problem, whirl_speed=False)

    def coefficients_over_speed(self, problem: FilmCase, speeds: Iterable[float]) -> SpeedRun:
        """Solve at several speeds, the heat balance anew at each."""
        from babbitt.kinds.journal.film.coefficients_over_speed import run_over_speed

        return run_over_speed(problem, speeds)

    def is_clockwise(self, problem: FilmCase) -> bool:
        """Whether the journal turns clockwise, seen against z."""
        return problem.rotation.sense < 0.0


@dataclass(frozen=True)
class InfinitelyLongBearing(Method):
    """The infinitely long film with heat exchange through journal and bush."""

    name: ClassVar[str] = "long_film"

    def solve(self, problem: LongFilmCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve the film of one dimension and the network of its heat."""
        from babbitt.kinds.journal.infinitely_long_bearing.check import long_film_check

        return (Solution(problem, long_film_check(problem)),)


@dataclass(frozen=True)
class GroovedLongBearing(Method):
    """The heat balance by segments of an infinitely long film with a groove in the loaded zone."""

    name: ClassVar[str] = "segments"

    def solve(self, problem: SegmentCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve the films before and behind the groove."""
        from babbitt.kinds.journal.grooved_long_bearing.check import segments_check

        return (Solution(problem, segments_check(problem)),)


@dataclass(frozen=True)
class OilBalance(Method):
    """Pump, lines and bearings of a machine in balance."""

    name: ClassVar[str] = "oil_balance"

    def solve(self, problem: OilSystemProblem, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the pressure of the header; the solution of the system, then those of the bearings."""
        from babbitt.kinds.journal.oil_balance.check import oil_balance_solutions

        return oil_balance_solutions(problem)


METHODS: dict[str, Method] = {
    one.name: one for one in (Iso7902(), Film(), InfinitelyLongBearing(), GroovedLongBearing())
}
"""By the name that a case file gives."""
