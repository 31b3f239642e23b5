"""Many bearings of one layout, from arrays to arrays: the scatter of clearance, preload, load and speed.

Every bearing is solved as it would be by itself, to the last bit; the kernels release the interpreter, so bearings
run on all cores. What a report needs besides (margins, checks, words) is left out.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.arrays import numbers, positive, require_one_count, require_workers
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.tilting_pad_journal.dynamics import bounded_decrement, chain_of, decisive, with_pedestal
from babbitt.kinds.tilting_pad_journal.film import operating_films
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.values import eccentricity_ratio
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.rotor import rotor_modes

__all__ = ["Band", "PadBatch", "solve_pad_batch"]

Array = NDArray[np.float64]

CLEARANCES = ("clearance", "assembled_clearance", "preload")
LEAST_PRELOAD = -0.5
"""Of a pad, as of a bearing by itself."""
ROUND_OFF = 1e-12
"""Of the quotient of clearances that a preload becomes."""


@dataclass(frozen=True, eq=False)
class Band:
    """How a number scatters over the bearings that are solved; each of the shape that it has of one bearing.

    Attributes
    ----------
    mean, low, high : float or ndarray
        Mean and two quantiles.
    count : int
        Bearings that have the number. With none all are nan.
    """

    mean: float | Array
    low: float | Array
    high: float | Array
    count: int


@dataclass(frozen=True, eq=False, repr=False)
class PadBatch:
    """Bearings of a batch; every array has them as its first axis. Those not solved have nan.

    Attributes
    ----------
    solved : ndarray of bool, shape (bearings,)
        Read this first.
    outcomes : tuple of Outcome
        How every search ended.
    starved : ndarray of bool, shape (bearings,)
        Whether the oil that is supplied is less than what leaves by the sides of the pads: converged, not solved.
    position : ndarray, shape (bearings, 2)
        m.
    eccentricity_ratio, minimum_film_thickness, maximum_pressure : ndarray, shape (bearings,)
        Over the assembled clearance, m, Pa.
    effective_temperature, maximum_temperature : ndarray, shape (bearings,)
        Of the films, and the highest in films and bores, K; the latter is nan where films have one temperature.
    friction_power, total_flow : ndarray, shape (bearings,)
        W, and fresh oil, m3/s.
    pad_load : ndarray, shape (bearings, pads)
        N.
    stiffness, damping : ndarray, shape (bearings, 2, 2)
        Synchronous, N/m and N s/m.
    log_decrement : ndarray, shape (bearings,)
        Of the rotor; nan without ``rotor_mass``.
    """

    solved: NDArray[np.bool_]
    outcomes: tuple[Outcome, ...]
    starved: NDArray[np.bool_]
    position: Array
    eccentricity_ratio: Array
    minimum_film_thickness: Array
    maximum_pressure: Array
    effective_temperature: Array
    maximum_temperature: Array
    friction_power: Array
    total_flow: Array
    pad_load: Array
    stiffness: Array
    damping: Array
    log_decrement: Array

    def band(self, name: str, low: float = 0.05, high: float = 0.95) -> Band:
        """Mean and quantiles of a number, element by element of a matrix.

        Parameters
        ----------
        name : str
            Of an array above.
        low, high : float
            Shares of the bearings below the lower and the upper end.

        Raises
        ------
        InputError
            E005 for a name that is no number of the bearings, E101 for shares that do not rise within 0 to 1.
        """
        if name not in NUMBERS:
            raise InputError("E005", f"{name!r} has no band; allowed: {', '.join(NUMBERS)}")
        if not 0.0 <= low < high <= 1.0:
            raise InputError("E101", f"low and high are {low} and {high}; give 0 <= low < high <= 1.")
        values = getattr(self, name)
        known = values[np.isfinite(values.reshape(len(values), -1)).all(axis=1)]
        if not len(known):
            none = np.full(values.shape[1:], math.nan)
            return Band(none, none, none, 0)
        below, above = np.quantile(known, (low, high), axis=0)
        return Band(known.mean(axis=0), below, above, len(known))

    def __repr__(self) -> str:
        shapes = ", ".join(f"{name} {getattr(self, name).shape}" for name in NUMBERS)
        return f"{len(self.solved)} bearings, {np.count_nonzero(self.solved)} solved\n  {shapes}"


NUMBERS = tuple(one.name for one in fields(PadBatch) if one.name not in ("solved", "outcomes", "starved"))
"""Of a batch, what has a mean and quantiles."""


def solve_pad_batch(
    case: PadCase,
    *,
    clearance: ArrayLike | None = None,
    assembled_clearance: ArrayLike | None = None,
    preload: ArrayLike | None = None,
    load: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> PadBatch:
    """Solve bearings that differ from a case in clearances, load and speed.

    Parameters
    ----------
    case : PadCase
    clearance, assembled_clearance, preload : array_like, optional
        Machined and assembled clearance on the radius, m, and 1 less the latter over the former; scalars, one for
        each bearing, or (bearings, pads). Two of them at most. With one alone the other that the case gives of
        a pad is held, as in a sweep of that field: of pads given by assembled clearance and preload, a preload
        moves the machined clearance. Where the case gives the other two the machined clearance is held, or beside
        it the preload.
    load : array_like, optional
        Its magnitude, N, in the direction of the case.
    speed : array_like, optional
        Of the journal without its sign, rad/s, in the sense of the case.
    workers : int, optional
        Threads; by default as many as there are cores. The answer does not depend on it.
    progress : callable, optional
        Called with how many bearings are done, and how many there are.

    Returns
    -------
    PadBatch

    Raises
    ------
    InputError
        E101, with the name of the argument, for text and quantities, for what is not positive and finite (preload:
        -0.5 to below 1), numbers of bearings or pads that do not fit each other, three clearances, and a load
        where the case prescribes the position.
    """
    require_workers(workers)
    pads = clearance_arrays(case, clearance, assembled_clearance, preload)
    duties = duty_arrays(case, load, speed)
    count = require_one_count({name: one.shape for name, one in {**pads, **duties}.items() if one.ndim})
    machined, assembled = two_clearances(case, pads)
    shape = (count, len(case.bearing.pads))
    machined, assembled = np.broadcast_to(machined, shape), np.broadcast_to(assembled, shape)
    spread = {name: np.broadcast_to(one, (count,)) for name, one in duties.items()}
    cases = [
        one_case(case, machined[row], assembled[row], {name: float(one[row]) for name, one in spread.items()})
        for row in range(count)
    ]
    return collected(case, list(answers_of(cases, workers, progress)))


def clearance_arrays(case: PadCase, *given: ArrayLike | None) -> dict[str, Array]:
    """Those of `CLEARANCES` that are given, checked, with the pads as their last axis."""
    count, found = len(case.bearing.pads), {}
    for name, values in zip(CLEARANCES, given, strict=True):
        if values is None:
            continue
        if name == "preload":
            array = numbers(name, "1", values)
            if not (np.isfinite(array) & (array >= LEAST_PRELOAD) & (array < 1.0)).all():
                raise InputError("E101", f"preload must be {LEAST_PRELOAD:g} to below 1 everywhere")
        else:
            array = positive(name, "m", values, ("bearings", "pads"))
        if array.ndim == 2 and array.shape[1] not in (1, count):
            raise InputError("E101", f"{name} has shape {array.shape}; its second axis are the {count} pads")
        if array.ndim > 2:
            raise InputError("E101", f"{name} has shape {array.shape}; give (bearings,) or (bearings, pads)")
        found[name] = array if array.ndim == 2 else array[..., None]
    if len(found) == 3:
        raise InputError("E101", f"{', '.join(CLEARANCES)} are given; the third follows from two of them")
    return found


def duty_arrays(case: PadCase, load: ArrayLike | None, speed: ArrayLike | None) -> dict[str, Array]:
    """Load and speed that are given, checked."""
    found = {}
    if speed is not None:
        found["speed"] = positive("speed", "rad/s", speed, why="; the sense of rotation is that of the case")
    if load is not None:
        if not isinstance(case.duty, PrescribedLoad):
            raise InputError("E101", "load is given of a case that prescribes the position of the journal")
        found["load"] = positive("load", "N", load, why="; its direction is that of the case")
    return found


def two_clearances(case: PadCase, given: dict[str, Array]) -> tuple[Array, Array]:
    """Machined and assembled clearances, m, the pads as the last axis."""
    machined = np.array([pad.clearance for pad in case.bearing.pads])
    assembled = np.array([pad.assembled_clearance for pad in case.bearing.pads])
    if len(given) == 1:
        (name,) = given
        machined, assembled = with_one(name, given[name], held_beside(case, name), machined, assembled)
    elif len(given) == 2:
        machined = given.get("clearance", np.asarray(math.nan))
        assembled = given.get("assembled_clearance", np.asarray(math.nan))
        if "preload" in given and "clearance" in given:
            assembled = machined * (1.0 - given["preload"])
        elif "preload" in given:
            machined = assembled / (1.0 - given["preload"])
    if not (assembled <= (1.0 - LEAST_PRELOAD) * machined * (1.0 + ROUND_OFF)).all():
        raise InputError("E101", f"{' and '.join(given)} makes a preload below {LEAST_PRELOAD:g}")
    return machined, assembled


def held_beside(case: PadCase, name: str) -> Array:
    """Number in `CLEARANCES` of what every pad keeps while one of them is varied alone, shape (pads,).

    That which the case gives beside it, as in a sweep of the field; of a case that gives the other two, or does
    not say what it gives, the machined clearance, and of that the preload.
    """
    usual = "preload" if name == "clearance" else "clearance"
    pairs = case.given_clearances or ((),) * len(case.bearing.pads)
    held = [
        next(one for one in pair if one != name) if len(pair) == 2 and name in pair else usual for pair in pairs
    ]
    return np.array([CLEARANCES.index(one) for one in held])


def with_one(name: str, values: Array, held: Array, machined: Array, assembled: Array) -> tuple[Array, Array]:
    """Machined and assembled clearances where one of `CLEARANCES` is varied and what is ``held`` stays."""
    clearance, _, preload = range(len(CLEARANCES))
    if name == "preload":
        own = np.where(held == clearance, machined, assembled / (1.0 - values))
        return own, np.where(held == clearance, machined * (1.0 - values), assembled)
    if name == "clearance":
        return values, np.where(held == preload, values * (assembled / machined), assembled)
    return np.where(held == preload, values * (machined / assembled), machined), values


def one_case(case: PadCase, machined: Array, assembled: Array, duty: dict[str, float]) -> PadCase:
    """The case with the numbers of one bearing."""
    pads = tuple(
        replace(pad, clearance=float(own), assembled_clearance=float(gap))
        for pad, own, gap in zip(case.bearing.pads, machined, assembled, strict=True)
    )
    return replace(
        case,
        bearing=replace(case.bearing, pads=pads),
        duty=PrescribedLoad(duty["load"]) if "load" in duty else case.duty,
        journal_speed=case.sense * duty["speed"] if "speed" in duty else case.journal_speed,
    )


Answer = tuple[Outcome, bool, tuple[Array | float, ...] | None]
"""How a search ended, whether the pads starve, and the numbers in the order of `NUMBERS`."""


def answers_of(
    cases: list[PadCase], workers: int | None, progress: Callable[[int, int], None] | None
) -> Iterator[Answer]:
    """Every bearing, in order."""
    count = len(cases)
    tell = progress or (lambda done, of: None)
    yield answer_of(cases[0])  # compiles, where that is still to be done, before the threads start
    tell(1, count)
    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        for done, answer in enumerate(pool.map(answer_of, cases[1:]), 2):
            yield answer
            tell(done, count)


def answer_of(case: PadCase) -> Answer:
    """One bearing."""
    found = operating_films(case)
    films = found.film
    if films is None or not found.outcome.solved:
        return found.outcome, False, None
    flow = None if case.oil_supply is None else case.oil_supply.flow
    if flow is not None and flow < films.solution.side_flow:
        return found.outcome, True, None
    return found.outcome, False, numbers_of(case, films)


def numbers_of(case: PadCase, films: PadFilms) -> tuple[Array | float, ...]:
    """In the order of `NUMBERS`."""
    solution, thermal = films.solution, films.thermal
    full = with_pedestal(case, full_coefficients(solution), solution)
    synchronous, decrement = condensed_at(full, 1.0), math.nan
    if case.rotor_mass is not None:
        decrement = bounded_decrement(decisive(rotor_modes(chain_of(case, full), case.rotor_mass)))
    return (
        solution.position,
        eccentricity_ratio(case, solution),
        solution.minimum_film_thickness,
        solution.maximum_pressure,
        films.temperature,
        math.nan if thermal is None else thermal.maximum_temperature,
        films.friction_power,
        films.total_flow,
        np.array([pad.load for pad in solution.pads]),
        synchronous.stiffness,
        synchronous.damping,
        decrement,
    )


def collected(case: PadCase, answers: list[Answer]) -> PadBatch:
    """Arrays of all answers."""
    shapes = {"position": (2,), "pad_load": (len(case.bearing.pads),), "stiffness": (2, 2), "damping": (2, 2)}
    arrays = {name: np.full((len(answers), *shapes.get(name, ())), math.nan) for name in NUMBERS}
    for row, (_, _, found) in enumerate(answers):
        for name, value in zip(NUMBERS, found or (), strict=found is not None):
            arrays[name][row] = value
    return PadBatch(
        solved=np.array([found is not None for _, _, found in answers]),
        outcomes=tuple(outcome for outcome, _, _ in answers),
        starved=np.array([starved for _, starved, _ in answers]),
        **arrays,
    )
