"""The best designs: NSGA-II over continuous fields and choices, limits as constraints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.parts.study import StudyBlock
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install, optional_package
from babbitt.core.result import Verdict
from babbitt.study.held_film import column_held
from babbitt.study.inputs import Input
from babbitt.study.laws import Choices, Listed
from babbitt.study.rows import Columns, RowTask, joined

if TYPE_CHECKING:
    from babbitt.study.engine import Engine
    from babbitt.study.study import Study

__all__ = ["KEPT", "Optimum", "designs", "optimum_of", "optimised"]

ADDED = ("friction_power", "total_flow", "side_flow", "supply_flow", "carry_over_flow")
"""Quantities of which a machine has the sum of its bearings; of all others the worst bearing counts."""

KEPT = "within_limits"
"""Column of `designs`: whether all bearings of a design keep their limits."""

NO_SOLUTION = 1e3
"""Violation of the limits that counts where there is no solution: larger than any margin."""

POLISH = 200
"""Designs that the local search of a single objective may compute."""

POLISHED = 1e-4
"""Share of its range to which the local search finds a field."""


@dataclass(frozen=True)
class _Problem:
    """Objectives and constraint of the lines of each row."""

    minimise: tuple[str, ...]
    maximise: tuple[str, ...]

    @property
    def names(self) -> tuple[str, ...]:
        return (*self.minimise, *self.maximise)

    @property
    def signs(self) -> NDArray[np.float64]:
        """Of the objectives as they are minimised."""
        return np.array([1.0] * len(self.minimise) + [-1.0] * len(self.maximise))

    def judged(self, columns: Columns) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Objectives to be minimised, shape (rows, objectives), and violation of the limits, shape (rows,)."""
        _, places = np.unique(columns["row"], return_inverse=True)
        rows = int(places.max()) + 1
        solved = columns["verdict"] != Verdict.NO_SOLUTION.key
        margin = np.where(
            solved & np.isfinite(columns["margin"]), columns["margin"], np.where(solved, 0.0, np.nan)
        )
        worst = np.full(rows, np.inf)
        np.minimum.at(worst, places, np.where(solved, margin, -NO_SOLUTION))
        objectives = np.empty((rows, len(self.names)))
        for place, name in enumerate(self.names):
            value = self.signs[place] * column_held(columns, name)
            if name in ADDED:
                made = np.bincount(places, weights=np.where(np.isfinite(value), value, 0.0), minlength=rows)
            else:
                made = np.full(rows, -np.inf)
                np.maximum.at(made, places, np.where(np.isfinite(value), value, -np.inf))
            unsolved = np.bincount(places, weights=~np.isfinite(value), minlength=rows) > 0
            objectives[:, place] = np.where(unsolved | ~np.isfinite(made), np.inf, made)
        return objectives, np.maximum(-worst, 0.0)


def optimised(task: RowTask, block: StudyBlock, engine: Engine) -> Columns:
    """Compute generation after generation; a single objective is polished by a local search.

    Deterministic by the seed, so that a run that is resumed asks for the rows that are stored.

    Raises
    ------
    InputError
        E007 where pymoo is not installed.
    """
    problem = _Problem(block.minimise, block.maximise)
    parts: list[Columns] = []
    algorithm, variables = _nsga2(task.inputs, block, len(problem.names))
    pymoo = optional_package("pymoo.core.evaluator", "optimisations", INSTALL)
    for generation in range(block.generations):
        asked = algorithm.ask()
        if asked is None or not len(asked):  # of few choices every combination has been computed
            break
        values = _values(task.inputs, [one.X for one in asked])
        found = engine.answers(values, f"generation {generation + 1}")
        parts.append(found)
        objectives, violation = problem.judged(found)
        bounded = np.where(np.isfinite(objectives), objectives, LARGE)
        static = optional_package("pymoo.problems.static", "optimisations", INSTALL)
        pymoo.Evaluator().eval(static.StaticProblem(variables, F=bounded, G=violation[:, None] - FEASIBLE), asked)
        algorithm.tell(infills=asked)
    if len(problem.names) == 1:
        parts += _polished(task, problem, joined(parts), engine)
    return joined(parts)


LARGE = 1e30
"""Objective of what has no solution."""

FEASIBLE = 1e-9
"""Violation that counts as none: the round-off of a margin."""

INSTALL = how_to_install("pymoo", "studies")


def _nsga2(inputs: Sequence[Input], block: StudyBlock, objectives: int) -> tuple[Any, Any]:
    """The algorithm and its problem: NSGA-II whose variation suits numbers and choices alike."""
    mixed = optional_package("pymoo.core.mixed", "optimisations", INSTALL)
    of = optional_package("pymoo.core.variable", "optimisations", INSTALL)
    nsga2 = optional_package("pymoo.algorithms.moo.nsga2", "optimisations", INSTALL)
    problem = optional_package("pymoo.core.problem", "optimisations", INSTALL)
    variables = {
        one.path: of.Integer(bounds=(0, one.listed.size - 1)) if _is_list(one) else of.Real(bounds=(0.0, 1.0))
        for one in inputs
    }
    made = problem.Problem(vars=variables, n_obj=objectives, n_ieq_constr=1)
    algorithm = mixed.MixedVariableGA(pop_size=block.population, survival=nsga2.RankAndCrowding())
    algorithm.setup(made, termination=("n_gen", block.generations), seed=block.seed, verbose=False)
    return algorithm, made


def _is_list(one: Input) -> bool:
    return isinstance(one.law, Listed | Choices)


def _values(inputs: Sequence[Input], designs: Sequence[Mapping[str, Any]]) -> Columns:
    """Designs as columns: of a list the value at a place, of a range from its lowest to its highest value."""
    made: Columns = {}
    for one in inputs:
        own = np.array([design[one.path] for design in designs])
        made[one.path] = one.listed[own.astype(int)] if _is_list(one) else _between(one, own.astype(float))
    return made


def _between(one: Input, share: NDArray[np.float64]) -> NDArray[np.float64]:
    low, high = one.law.support  # type: ignore[union-attr]
    return np.asarray(low + (high - low) * share)


def _polished(task: RowTask, problem: _Problem, found: Columns, engine: Engine) -> list[Columns]:
    """Polish the best design over its continuous fields by COBYLA (Powell 1994), choices held."""
    free = [one for one in task.inputs if not _is_list(one)]
    best = _best(problem, found)
    if not free or best is None:
        return []
    from scipy.optimize import minimize

    start = {one.path: found[one.path][best] for one in task.inputs}
    scale = abs(float(problem.judged(_line(found, best))[0][0, 0])) or 1.0
    parts: list[Columns] = []
    known: dict[tuple[float, ...], tuple[float, float]] = {}

    def judged(share: NDArray[np.float64]) -> tuple[float, float]:
        clipped = np.clip(share, 0.0, 1.0)
        key = tuple(clipped.tolist())
        if key not in known:
            fields: Columns = {one.path: np.array([start[one.path]], _type_of(one)) for one in task.inputs}
            fields |= {one.path: _between(one, clipped[place : place + 1]) for place, one in enumerate(free)}
            parts.append(engine.answers(fields, "local search"))
            objectives, violation = problem.judged(parts[-1])
            value = float(objectives[0, 0]) / scale
            known[key] = (value if np.isfinite(value) else LARGE / scale, float(violation[0]))
        return known[key]

    ends = [one.law.support for one in free]  # type: ignore[union-attr]
    begin = np.array([(start[one.path] - low) / (high - low) for one, (low, high) in zip(free, ends, strict=True)])
    held: list[dict[str, Any]] = [{"type": "ineq", "fun": lambda share: -judged(share)[1]}]
    held += [{"type": "ineq", "fun": lambda share, at=at: share[at]} for at in range(len(free))]
    held += [{"type": "ineq", "fun": lambda share, at=at: 1.0 - share[at]} for at in range(len(free))]
    options = {"rhobeg": 0.05, "tol": POLISHED, "maxiter": POLISH}
    minimize(lambda share: judged(share)[0], begin, method="COBYLA", constraints=held, options=options)
    return parts


def _type_of(one: Input) -> Any:
    return object if one.is_choice else float


def _line(columns: Columns, place: int) -> Columns:
    chosen = columns["row"] == columns["row"][place]
    return {name: column[chosen] for name, column in columns.items()}


def _best(problem: _Problem, found: Columns) -> int | None:
    """Place of the best line that keeps all limits; None where there is none."""
    objectives, violation = problem.judged(found)
    value = np.where(violation <= FEASIBLE, objectives[:, 0], np.inf)
    if not np.isfinite(value.min()):
        return None
    row = np.unique(found["row"])[int(np.argmin(value))]
    return int(np.flatnonzero(found["row"] == row)[0])


@dataclass(frozen=True)
class Optimum:
    """The best designs of an optimisation.

    Attributes
    ----------
    rows : tuple of int
        Of the designs than which no other within the limits is better, in the order of the first objective.
    objectives : tuple of str
    values : ndarray, shape (rows, objectives)
        In SI, as they stand in the results.
    feasible : int
        Designs within all limits, of all that were computed.
    nearest : int or None
        The row that misses the limits least, where none keeps them.
    """

    rows: tuple[int, ...]
    objectives: tuple[str, ...]
    values: NDArray[np.float64]
    feasible: int
    nearest: int | None


def optimum_of(study: Study) -> Optimum:
    """The Pareto set of an optimisation; of a single objective the best design."""
    block = study.block
    problem = _Problem(block.minimise, block.maximise)
    objectives, violation = problem.judged(study.columns)
    numbers = np.unique(study.columns["row"])
    kept = np.flatnonzero((violation <= FEASIBLE) & np.isfinite(objectives).all(axis=1))
    if not kept.size:
        return Optimum((), problem.names, np.empty((0, len(problem.names))), 0, int(numbers[np.argmin(violation)]))
    front = kept[_undominated(objectives[kept])]
    front = front[np.lexsort(objectives[front].T[::-1])]
    _, once = np.unique(objectives[front], axis=0, return_index=True)
    front = front[np.sort(once)]
    if len(problem.names) == 1:
        front = front[:1]
    rows = tuple(int(number) for number in numbers[front])
    return Optimum(rows, problem.names, objectives[front] * problem.signs, int(kept.size), None)


def designs(study: Study) -> Columns:
    """The designs that were computed, a line each: fields, objectives of the whole machine, `KEPT`."""
    problem = _Problem(study.block.minimise, study.block.maximise)
    objectives, violation = problem.judged(study.columns)
    rows, first = np.unique(study.columns["row"], return_index=True)
    values = np.where(np.isfinite(objectives), objectives * problem.signs, np.nan)
    made = {one["path"]: study.columns[one["path"]][first] for one in study.inputs}
    made |= {name: values[:, place] for place, name in enumerate(problem.names)}
    return made | {"row": rows, KEPT: (violation <= FEASIBLE) & np.isfinite(values).all(axis=1)}


def _undominated(objectives: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which points no other is better than in one objective and as good in all others."""
    made = np.ones(len(objectives), bool)
    for place, one in enumerate(objectives):
        better = (objectives <= one).all(axis=1) & (objectives < one).any(axis=1)
        made[place] = not better.any()
    return made


def require_pymoo(block: StudyBlock, inputs: Sequence[Input]) -> None:
    """Refuse an optimisation that lacks pymoo, or fields of a table.

    Raises
    ------
    InputError
    """
    if block.kind != "optimise":
        return
    for one in inputs:
        if one.table:
            raise InputError(
                "E003", f"study.vary.{one.path}: a table of samples cannot be optimised; give its range"
            )
    optional_package("pymoo.core.mixed", "optimisations", INSTALL)
