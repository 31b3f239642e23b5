"""Stiffness and damping of a bearing over its speed, each at the equilibrium of that speed."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.core.solution import Solution
from babbitt.export import CoefficientTable, coefficient_table
from babbitt.kinds.journal.film.check import film_solution
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_results import temperatures_of_coefficients
from babbitt.reynolds.solution import FilmSolution

STATIC = {
    "effective_temperature": "temperature",
    "effective_viscosity": "viscosity",
    "total_flow": "total_flow",
    "friction_power": "friction_power",
}
"""What is carried along of the heat balance: quantity, and its name in the state of the film."""

NOT_FOLLOWED = "W147"
"""Of a result whose stiffness is that of frozen temperatures against its case."""


@dataclass(frozen=True, eq=False)
class SpeedRun:
    """One bearing at several speeds, in rad/s and ascending; everything else stays as in the case."""

    case: FilmCase
    speeds: tuple[float, ...]
    solutions: tuple[Solution, ...]

    @property
    def unsolved(self) -> tuple[tuple[float, Outcome], ...]:
        """Speeds in rad/s without an equilibrium, and how the search ended there."""
        pairs = zip(self.speeds, self.solutions, strict=True)
        return tuple((speed, one.result.outcome) for speed, one in pairs if not one.result.outcome.solved)

    @property
    def unfollowed(self) -> tuple[float, ...]:
        """Speeds in rad/s without the stiffness for following temperatures that the case asks for."""
        pairs = zip(self.speeds, self.solutions, strict=True)
        return tuple(speed for speed, one in pairs if NOT_FOLLOWED in one.result.questioning_codes)

    def table(self) -> CoefficientTable:
        """Give the coefficients over speed, with the equilibria and heat balances they belong to.

        Speeds without equilibrium (`unsolved`) or without the stiffness asked for (`unfollowed`) are left out, as
        the `unsolved_speeds` of the table.

        Raises
        ------
        InputError
            E003 when none is left, E004 when the direction of the load changes with the speed.
        """
        kept = [
            one for one in self.solutions
            if one.result.outcome.solved and NOT_FOLLOWED not in one.result.questioning_codes
        ]  # fmt: skip
        if not kept:
            raise InputError(
                "E003",
                f"{self.case.name}: no equilibrium, or no stiffness of the kind asked for, at any of the speeds",
            )
        states: list[FilmState] = [one.state for one in kept]
        table = coefficient_table(self.case.name, map(_film_of, kept), method_of_coefficients(self.case))
        heat = {name: np.array([getattr(state, own) for state in states]) for name, own in STATIC.items()}
        return replace(
            table,
            static={**table.static, **heat},
            temperatures=temperatures_of_coefficients(self.case),
            warnings=tuple(one.result.questioning_codes for one in kept),
            unsolved_speeds=tuple(sorted({*(speed for speed, _ in self.unsolved), *self.unfollowed})),
        )


def _film_of(solution: Solution) -> FilmSolution:
    """The film of a solution with the stiffness of its result, which the case asks for."""
    film: FilmSolution = solution.state.solution
    own = solution.result.arrays.get("stiffness")
    return film if own is None else replace(film, stiffness=np.array(own))


def run_over_speed(case: FilmCase, speeds: Iterable[float]) -> SpeedRun:
    """Solve a bearing at several speeds, its heat balance anew at each.

    Parameters
    ----------
    case : FilmCase
        Load, oil and supply hold at every speed; the sense of rotation is that of the case.
    speeds : iterable of float
        Of the journal, rad/s, positive.

    Returns
    -------
    SpeedRun
        With a status and warnings at every speed, and the stiffness that the case asks for. What is asked for
        besides (an orbit, stiffness against tilt, the error of the grid, limiting speeds, limits of the clearance)
        is left out.

    Raises
    ------
    InputError
        E003 for a speed that is not positive, E004 for a bearing that turns, too: coefficients over the speed of
        the journal alone do not describe it.
    """
    taken = tuple(sorted(set(speeds)))
    if not taken or not all(math.isfinite(speed) and speed > 0.0 for speed in taken):
        raise InputError("E003", f"{case.name}: give one speed or more, each positive, in rad/s")
    if case.bearing_speed:
        raise InputError(
            "E004", f"{case.name}: the bearing turns, too; no table over the journal speed holds for it"
        )
    sense = case.rotation.sense
    needed = replace(
        case, changing_load=None, tilt_coefficients=False, error_estimate=False, limiting_speeds=False,
        clearance_limits=None,
    )  # fmt: skip
    return SpeedRun(
        case, taken, tuple(film_solution(replace(needed, journal_speed=sense * speed)) for speed in taken)
    )


def method_of_coefficients(case: FilmCase) -> str:
    """How the coefficients of a case are obtained, in a line."""
    if case.heat is not None:
        heat = f"thermal {case.heat.name} at each speed"
    else:
        heat = "heat balance at each speed" if case.effective_temperature is None else "one effective temperature"
    return f"Babbitt film, {case.cavitation.name.lower().replace('_', ' ')} cavitation, {heat}"
