"""What every random bearing must do: end with a status, balance, and be the same in other axes, order and units.

A family is a generator of cases and the ways in which its cases can be written differently. `faults_of` draws one
case, solves it and names what is wrong; nothing is wrong with a case that is refused or has no solution, as long
as every way of writing it ends alike.
"""

from __future__ import annotations

import math
import random
import re
import time
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from typing import Any

import numpy as np

from babbitt.case import CaseFile, case_from_dict
from babbitt.case.problems import CaseError
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome as Ending
from babbitt.core.result import Result
from babbitt.reynolds.stability.whirl_checks import JUMPS, LOST
from babbitt.solving import solve

__all__ = ["Family", "Outcome", "faults_of", "in_other_units", "reordered"]

Case = dict[str, Any]
Rewriting = Callable[[Case, random.Random], Case]

BALANCE = 1e-6
"""Bound on the balance errors of mass and heat; beyond it a warning must tell."""
OPEN = {
    "mass_balance_error": {"W122", "W211", "W177", "W324"},
    "energy_balance_error": {"W146", "W211", "W325"},
}
"""Warnings that tell of a balance that does not close."""
SAME, SAME_WARM, SAME_UNITS = 1e-9, 1e-6, 1e-6
"""Bounds on what a turn, the mirror or another order changes, of isothermal and thermal films, and on what other
units change, whose conversions differ in the last digits. Bores that give way are held to that of thermal films:
film and displacement agree to 1e-7 of the least gap, and where the search stands still its last steps enlarge
round-off (8e-7 in 1 of 75)."""
SLOWEST = 60.0
"""s of the processor: other work on the machine does not count."""
OF_AXES = ("_x", "_y", "_xx", "_xy", "_yx", "_yy", "angle")
"""Ends of the names of results that belong to the axes."""
SIGNED = ("angular_speed",)
"""Of results whose sign tells the sense of rotation."""
SHARED = 1e-5
"""Bound on what pads miss of the load: faces that lean settle to 1e-6 of their heights, films
with temperatures of their own to 1e-4 K. The moment on the collar is a difference of such loads."""
FLICKERING = 2e-4
"""The same of films with temperatures of their own whose rupture goes to and fro between two lines
(`babbitt.kinds.thrust.thermal`); 1.4e-5 of the load in 1 of 94."""
SEARCHED = {"threshold_speed": 1e-4, "transition_speed": 1e-4, "friction_torque_without_streamers": 1e-7}
"""Results that are searched for to a tolerance of their own, or leave out nodes that are nearly dry."""
BY_DIFFERENCES = {
    **{f"stiffness {part}": 1e-4 for part in ("size", "trace", "skew")},
    **{f"damping {part}": 2e-3 for part in ("size", "trace", "skew")},
    **dict.fromkeys(("critical_mass", "least_stable_mass", "whirl_frequency_ratio"), 1e-2),
    "threshold_speed": 5e-2,
    "inlet_flow": 3e-5,
}
"""Of bores that give way: differences of films, in which a node more or less is wet (damping by 1.4e-3 of one of
94 on draft grids, the flow into where the film begins by 1.2e-5); confirmed to a hundredth.
Where the reserve of stability that they give crosses zero moves by more (1.2 % in 1 of 190 on draft grids; this
bound is that of thermal films, `OF_THERMAL_FILMS`)."""
OF_THERMAL_FILMS = {"threshold_speed": 5e-2}
"""Settled to a ten-thousandth; far from the speed of a case the reserve of stability on draft grids goes in steps
of single nodes, of which such a difference takes one or the next (289.6 and 299.8 rad/s, found from 80)."""
OF_TURBULENT_FILMS = 2e-4
"""Two neighbouring sets of wet nodes may both satisfy a turbulent film; they differ by up to this on draft grids
(flow 8e-5), and which is found turns on the last digits of the input."""
OF_WET_NODES = {"friction_torque_without_streamers": 2e-3, "turbulent_share": 2e-3}
"""The node of which two such sets differ counts in them or not."""
TURNING = 1e-12
"""Moment on the collar, over load times radius, that is round-off of loads which are alike."""
AMPLIFIED, AMPLIFICATION = ("critical_mass", "whirl_frequency_ratio", "threshold_speed"), 100.0
"""Results of stability are differences of nearly equal stiffnesses: their bound is so many times wider."""
BEYOND_VALIDITY = {"W127", "W128"}
"""Warnings that a film is beyond what its method knows of heat: such a one of 0.08 um in a bore that gives way was
found in one frame, and did not converge in the other (1 of 190)."""
OF_RUN = ("iterations", "wall_time", "balance_error", "inconsistency")
"""Of results that tell how the solution went."""


@dataclass(frozen=True)
class Family:
    """Random bearings of one kind.

    Attributes
    ----------
    draw : callable
        Case of a random generator.
    rewritings : mapping
        Ways to write the same bearing differently, by name.
    same : float
        Bound on the relative change of every value but angles; units have their own.
    wider : mapping
        Bounds of single values, in place of that where they are wider.
    alike : frozenset of Outcome
        Ends without a solution that count as one.
    """

    draw: Callable[[random.Random], Case]
    rewritings: Mapping[str, Rewriting] = field(default_factory=dict)
    same: float = SAME
    wider: Mapping[str, float] = field(default_factory=dict)
    alike: frozenset[Ending] = frozenset()


@dataclass(frozen=True)
class Outcome:
    """How one case went: what is wrong with it, how it ended, and how long it took in s."""

    faults: tuple[str, ...]
    status: str
    seconds: float


def faults_of(family: Family, seed: int | str) -> Outcome:
    """Draw a case by a seed, solve it and its rewritings, and name what is wrong."""
    rng = random.Random(seed)
    case = family.draw(rng)
    start = time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            given = read(case)
            found = answers(given)
            seconds = time.process_time() - start
            faults = (
                [] if isinstance(found, str) else [one for result in found for one in imbalances(result, case)]
            )
            for name, rewrite in family.rewritings.items():
                bound = max(SAME_UNITS, family.same) if name == "units" else family.same
                other = read(rewrite(case, rng))
                if other != given:  # what is read as the same case is not solved again
                    faults += [f"{name}: {one}" for one in changes(found, answers(other), bound, family)]
    except Exception as error:  # any traceback is a fault
        return Outcome((f"{type(error).__name__}: {error}",), "traceback", time.process_time() - start)
    return Outcome(tuple(faults), status_of(found), seconds)


def read(case: Case) -> CaseFile | str:
    """The case as the program reads it, or why it is refused."""
    try:
        return case_from_dict(case)
    except CaseError as error:
        return refusal(error)


def refusal(error: CaseError) -> str:
    """The fields that a refusal names."""
    return "; ".join(sorted({re.sub(r"\[\d+\]", "", problem.field) for problem in error.problems}))


def answers(given: CaseFile | str) -> tuple[Result, ...] | str:
    """Results of all bearings of a case, or why it is refused."""
    if isinstance(given, str):
        return given
    try:
        return solve(given).results
    except CaseError as error:
        return refusal(error)
    except InputError as error:  # told by `check`, too, which makes the one solution that it needs
        return error.code


def status_of(found: tuple[Result, ...] | str) -> str:
    """How a case ended, in a word."""
    if isinstance(found, str):
        return "refused"
    return "solved" if all(result.outcome.solved for result in found) else found[0].outcome.code


def imbalances(result: Result, case: Case) -> Iterator[str]:
    """Balances that do not close and of which no warning tells, and a load that is not carried."""
    if not result.outcome.solved:
        return
    told = {notice.code for notice in result.warnings}
    conserving = case.get("cavitation", "mass_conserving") == "mass_conserving"
    for name, codes in OPEN.items():
        error = abs(result.values.get(name, 0.0))
        if error > BALANCE and (conserving or name[0] == "e") and not told & codes:
            yield f"{name} {error:.2g}"
    given = case.get("load")
    if isinstance(given, str) and given.endswith(" kN") and "load" in result.values:
        load = 1e3 * abs(float(given.split()[0]))
        if abs(result.values["load"] - load) > BALANCE * load:
            yield f"load {result.values['load']:.9g} N of {load:.9g} N"
    if "pad_load" in result.arrays:
        carried = sum(result.arrays["pad_load"][0])
        shared = FLICKERING if case.get("thermal") in ("adiabatic", "full") else SHARED
        if abs(carried - result.values["load"]) > shared * carried:
            yield f"pads carry {carried:.9g} N of {result.values['load']:.9g} N"
    if not all(math.isfinite(value) for value in result.values.values()):
        yield "a value is not finite"


def changes(
    one: tuple[Result, ...] | str, other: tuple[Result, ...] | str, bound: float, family: Family
) -> Iterator[str]:
    """What differs between two answers of a family by more than a bound."""
    if isinstance(one, str) or isinstance(other, str):
        if one != other:
            told = [f"refused for {part}" if isinstance(part, str) else status_of(part) for part in (one, other)]
            yield " became ".join(told)
        return
    wider = {**SEARCHED, **family.wider}
    for first, second in zip(one, other, strict=True):
        if first.outcome is not second.outcome:
            if not ({first.outcome, second.outcome} <= family.alike or lost_beyond_validity(first, second)):
                yield f"{first.outcome.name} became {second.outcome.name}"
            continue
        if not first.outcome.solved or unsettled(first) or unsettled(second):
            continue
        numbers, others = invariants(first), invariants(second)
        for name in sorted(numbers.keys() | others.keys()):
            if name not in numbers or name not in others:
                if not left_open(name, first, second):
                    yield f"{name} is missing in one"
            elif not close(
                numbers[name],
                others[name],
                max(bound * (AMPLIFICATION if name in AMPLIFIED else 1.0), wider.get(name, 0.0)),
                scale_of(name, numbers),
            ):
                yield f"{name} {numbers[name]:.12g} became {others[name]:.12g}"


def left_open(name: str, *results: Result) -> bool:
    """Whether one of the results says that films leave a speed open.

    In a bore that gives way its search met a film that is off its neighbours, or found none, at a speed at which
    the other did not look (1 of 60); in others it may not.
    """
    gives_way = all("maximum_displacement" in one.values for one in results)
    return gives_way and any(one.missing.get(name) in (JUMPS, LOST) for one in results)


def lost_beyond_validity(first: Result, second: Result) -> bool:
    """Whether one of two did not converge and the other, which did, is told to be beyond its validity."""
    ended = {one.outcome: one for one in (first, second)}
    if ended.keys() != {Ending.CONVERGED, Ending.NOT_CONVERGED}:
        return False
    return any(notice.code in BEYOND_VALIDITY for notice in ended[Ending.CONVERGED].warnings)


def unsettled(result: Result) -> bool:
    """Whether a warning tells that the heat balance was left open: the values are right to about that share."""
    return any(notice.code in OPEN["energy_balance_error"] for notice in result.warnings)


def close(one: float, other: float, bound: float, scale: float) -> bool:
    """Whether two values are the same within a bound of their size or of a scale; two that are nothing are."""
    return abs(one - other) <= bound * max(abs(one), abs(other), scale) + 1e-15


def scale_of(name: str, numbers: Mapping[str, float]) -> float:
    """What a value is a part of: the friction power of heats, the whole flow of flows."""
    for part, whole in (("heat", "friction_power"), ("flow", "total_flow")):
        if part in name:
            return abs(numbers.get(whole, 0.0))
    if "moment" in name:
        return TURNING / SAME_WARM * abs(numbers.get("load", 0.0))
    return 0.0


def invariants(result: Result) -> dict[str, float]:
    """Values that no choice of axes changes: all but angles, components and senses."""
    found = {
        name: abs(value) if name in SIGNED else value for name, value in result.values.items()
        if not name.endswith(OF_AXES) and not name.endswith(OF_RUN)
    }  # fmt: skip
    for name in ("stiffness", "damping"):
        if name in result.arrays:
            matrix = np.array(result.arrays[name])
            size = float(np.linalg.norm(matrix))
            found[f"{name} size"] = size
            found[f"{name} trace"] = 1.0 + float(np.trace(matrix)) / size if size else 0.0
            found[f"{name} skew"] = 1.0 + abs(float(matrix[0, 1] - matrix[1, 0])) / size if size else 0.0
    return found


def reordered(case: Case, rng: random.Random) -> Case:
    """The same with every mapping and every list of supplies in another order."""

    def mixed(value: Any, name: str = "") -> Any:
        if isinstance(value, dict):
            names = list(value)
            rng.shuffle(names)
            return {key: mixed(value[key], key) for key in names}
        if isinstance(value, list) and name in ("grooves", "pockets", "holes"):
            return [mixed(one) for one in value[::-1]]
        return value

    return dict(mixed(case))


OTHER = {
    "mm": ("m", "0.001"), "um": ("mm", "0.001"), "kN": ("N", "1000"), "MPa": ("bar", "10"), "kPa": ("Pa", "1000"),
    "m/s": ("mm/s", "1000"), "W/(m K)": ("mW/(mm K)", "1"), "permille": ("%", "0.1"), "deg": ("deg", "1"),
}  # fmt: skip
"""Another unit for the same quantity, and how many of it one is."""


def in_other_units(case: Case, _rng: random.Random) -> Case:
    """The same numbers in other units, converted in decimals; degrees Celsius become kelvins."""

    def converted(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: converted(one) for key, one in value.items()}
        if isinstance(value, list):
            return [converted(one) for one in value]
        number, _, unit = value.partition(" ") if isinstance(value, str) else ("", "", "")
        if unit == "degC":
            return f"{Decimal(number) + Decimal('273.15')} K"
        if unit in OTHER:
            other, factor = OTHER[unit]
            return f"{Decimal(number) * Decimal(factor):f} {other}"
        return value

    return dict(converted(case))
