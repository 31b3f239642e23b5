"""How far a bearing moves with what is assumed of its heat: carry-over, heat transfer on the backs, housing."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError, Notice
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Matrix, Result
from babbitt.design.missed_limit import missed_limit
from babbitt.kinds.tilting_pad_journal.model import PadCase, Thermal

__all__ = ["ASSUMED", "MOVED", "Assumption", "assumptions", "end_in_words", "with_sensitivity", "worse"]

STARVED = "W405"
"""Of pads that get less oil than they draw in: their numbers are those of films with all of it."""

CARRIED, TRANSFER, WARMER = 0.2, 3.0, 10.0
"""By how much carry-over (a share), heat transfer on the backs (a factor) and the temperature of the housing (K)
are varied: as far as published values of one bearing lie apart."""

MOVED = (
    "maximum_temperature",
    "effective_temperature",
    "minimum_film_thickness",
    "friction_power",
    "stiffness_yy",
    "damping_yy",
)
"""What the assumptions are asked about."""

ASSUMED = {
    "assumed_carry_over": "Carry-over",
    "assumed_back_coefficient": "Heat transfer on the backs",
    "assumed_housing_temperature": "Housing",
}
"""What is assumed, by the names of its low, base and high number."""


@dataclass(frozen=True)
class Assumption:
    """One number that is assumed, or given and known no better.

    Attributes
    ----------
    name : str
        Of `ASSUMED`.
    low, base, high : float
        SI; ``low`` and ``high`` are nan where there is no less or no more.
    at : callable
        The problem with another number.
    """

    name: str
    low: float
    base: float
    high: float
    at: Callable[[float], PadCase]

    @property
    def label(self) -> str:
        """In words."""
        return ASSUMED[self.name]

    def written(self, *values: float, between: str = ", ") -> str:
        """Numbers as they are printed, with their unit."""
        return written(self.name, *values, between=between)


def written(name: str, *values: float, between: str = ", ") -> str:
    """Numbers of something assumed as they are printed, with their unit."""
    quantity = QUANTITIES[name]
    return f"{between.join(f'{quantity.shown(one):.3g}' for one in values)} {quantity.display.label}".rstrip()


def end_in_words(name: str, value: float, base: float) -> str:
    """What is changed, by its name in `ASSUMED`: ``Carry-over: 1 in place of 0.8``."""
    return f"{ASSUMED[name]}: {written(name, value, base, between=' in place of ')}"


def assumptions(case: PadCase) -> Iterator[Assumption]:
    """What of the heat of a bearing may be otherwise, given or not; nothing of films at a given temperature."""
    if case.thermal is Thermal.ISOTHERMAL:
        return
    share, heat, supply = case.feed.carry_over, case.heat, case.oil_supply
    low, high = max(share - CARRIED, 0.0), min(share + CARRIED, 1.0)
    yield Assumption(
        "assumed_carry_over",
        low if low < share else math.nan,
        share,
        high if high > share else math.nan,
        lambda value: replace(case, feed=replace(case.feed, carry_over=value)),
    )
    walls, growth = heat.walls, heat.growth
    if walls is not None:
        base = walls.back_coefficient
        yield Assumption(
            "assumed_back_coefficient",
            base / TRANSFER,
            base,
            base * TRANSFER,
            lambda value: replace(case, heat=replace(heat, walls=replace(walls, back_coefficient=value))),
        )
    if growth is not None and supply is not None:
        base = supply.temperature if growth.housing_temperature is None else growth.housing_temperature
        yield Assumption(
            "assumed_housing_temperature",
            base - WARMER,
            base,
            base + WARMER,
            lambda value: replace(case, heat=replace(heat, growth=replace(growth, housing_temperature=value))),
        )


@dataclass(frozen=True)
class End:
    """A bearing with less or more of what is assumed.

    Attributes
    ----------
    assumption : Assumption
    value : float
        SI; nan where there is no less or no more.
    result : Result or None
        None without a value, and where the bearing is refused.
    refusal : str
        Why, where it is: the supply does not even make up for what leaves by the sides of the pads.
    """

    assumption: Assumption
    value: float
    result: Result | None
    refusal: str = ""

    @property
    def moved(self) -> dict[str, float]:
        """Those of `MOVED` that hold; none without a film, nor of pads that starve."""
        found = self.result
        if found is None or not found.outcome.solved or STARVED in found.invalidating_codes:
            return {}
        return {name: found.values[name] for name in MOVED if name in found.values}


def with_sensitivity(case: PadCase, result: Result, solve: Callable[[PadCase], Result]) -> Result:
    """A result with low, base and high of every assumption, of what it moves, and what that questions.

    Parameters
    ----------
    case : PadCase
        Solved anew with less and with more of everything that is assumed.
    result : Result
        Of it: the base.
    solve : callable
        One bearing, by its method.

    Returns
    -------
    Result
        With the arrays ``assumed_carry_over`` and the like, one row (low, base, high) each, and of each of `MOVED`
        a matrix ``sensitivity_of_...`` with a row (low, base, high) for each assumption, in order of `ASSUMED`;
        nan where there is no such number, the bearing is not solved with it, or its pads starve. W419 where a
        verdict hangs on an assumption.
    """
    assumed = tuple(assumptions(case))
    ends = [(end_of(one, one.low, solve), end_of(one, one.high, solve)) for one in assumed]
    rows: dict[str, Matrix] = {one.name: ((one.low, one.base, one.high),) for one in assumed}
    for name in MOVED:
        if assumed and name in result.values:
            rows[f"sensitivity_of_{name}"] = tuple(
                (low.moved.get(name, math.nan), result.values[name], high.moved.get(name, math.nan))
                for low, high in ends
            )
    told = about_assumptions(result, [one for pair in ends for one in pair])
    return replace(result, warnings=(*result.warnings, *told), arrays={**result.arrays, **rows})


def end_of(assumption: Assumption, value: float, solve: Callable[[PadCase], Result]) -> End:
    """The bearing with another number of an assumption."""
    if math.isnan(value):
        return End(assumption, value, None)
    try:
        return End(assumption, value, solve(replace(assumption.at(value), assumption_sensitivity=False)))
    except InputError as error:
        return End(assumption, value, None, error.message)


def about_assumptions(result: Result, ends: Sequence[End]) -> Iterator[Notice]:
    """Ends of assumptions without film or verdict, or that miss a limit which the bearing as calculated keeps."""
    said: list[Notice] = []
    for one in ends:
        if not math.isnan(one.value):
            changed = Notice("W419", one.assumption.name, {"value": one.value, "base": one.assumption.base})
            said += worse(result, changed, one.result, one.refusal)
    if said:
        yield Notice("W419", "ends", {"ends": tuple(said)})


OWN_LIMITS = "W219"
"""Of limits by experience that are missed, where the case sets others."""


def worse(base: Result, said: Notice, found: Result | None, refusal: str) -> Iterator[Notice]:
    """What of a bearing is worse otherwise than as calculated: limits missed that were kept, or not checked.

    Parameters
    ----------
    base : Result
        As calculated.
    said : Notice
        What is otherwise.
    found : Result or None
        With that. None where it is refused.
    refusal : str
        Why, where it is.
    """
    if found is None:
        yield Notice("W419", "refused", {"end": said, "why": refusal.removeprefix(f"{base.name}: ")})
        return
    if not found.outcome.solved:
        yield Notice("W419", "unsolved", {"end": said, "outcome": found.outcome.value})
        return
    missed = [one for one in found.limits if not one.ok]
    there = {one.code for one in base.limits} | {one.code for one in base.not_checked}
    kept = there - {one.code for one in base.limits if not one.ok}
    lost = tuple(missed_limit(one, "W419") for one in missed if one.code in kept)
    if lost:
        yield Notice("W419", "missed", {"end": said, "limits": lost})
    own = next((one for one in found.warnings if one.code == OWN_LIMITS), None)
    if own is not None and OWN_LIMITS not in base.questioning_codes:
        yield Notice("W419", "own", {"end": said, "own": own})
    if codes := tuple(one for one in found.invalidating_codes if one not in base.invalidating_codes):
        yield Notice("W419", "no_verdict", {"end": said, "codes": codes})
