"""How far a bearing moves with what is assumed of its heat: carry-over, heat transfer on the backs, housing."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Matrix
from babbitt.kinds.tilting_pad_journal.batch import NUMBERS, answer_of
from babbitt.kinds.tilting_pad_journal.model import PadCase, Thermal

__all__ = ["ASSUMED", "MOVED", "Assumption", "assumptions", "sensitivity_rows", "written"]

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


def sensitivity_rows(case: PadCase, values: Mapping[str, float]) -> dict[str, Matrix]:
    """Low, base and high of every assumption, and of what it moves.

    Parameters
    ----------
    case : PadCase
        Solved anew with less and with more of everything that is assumed.
    values : mapping
        Of its result: the base.

    Returns
    -------
    dict
        ``assumed_carry_over`` and the like, one row (low, base, high) each, and of each of `MOVED` a matrix
        ``sensitivity_of_...`` with a row (low, base, high) for each assumption, in the order of `ASSUMED`; nan
        where there is no such number or the bearing is not solved with it.
    """
    assumed = tuple(assumptions(case))
    if not assumed:
        return {}
    found = [(moved_by(one, one.low), moved_by(one, one.high)) for one in assumed]
    rows: dict[str, Matrix] = {one.name: ((one.low, one.base, one.high),) for one in assumed}
    for name in MOVED:
        if name in values:
            rows[f"sensitivity_of_{name}"] = tuple(
                (low.get(name, math.nan), values[name], high.get(name, math.nan)) for low, high in found
            )
    return rows


def moved_by(assumption: Assumption, value: float) -> dict[str, float]:
    """Those of `MOVED` with another number of an assumption; nothing without one, and without solution."""
    if math.isnan(value):
        return {}
    _, _, numbers = answer_of(assumption.at(value))
    if numbers is None:
        return {}
    named = dict(zip(NUMBERS, numbers, strict=True))
    own = {f"{name}_yy": named.pop(name)[1, 1] for name in ("stiffness", "damping")}  # type: ignore[index]
    return {name: float(one) for name, one in (named | own).items() if name in MOVED}
