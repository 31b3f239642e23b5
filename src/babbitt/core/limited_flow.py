"""A plain bearing short of oil has two films: with all the oil that it wants, and with what its supply delivers.

Limits are held against the worse of both. Which of them a reading is of is decided here, for tables, plots and
studies alike.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from babbitt.core.quantities import QUANTITIES

if TYPE_CHECKING:
    from babbitt.core.result import Result

__all__ = [
    "LIMITED",
    "is_limited",
    "is_short_of_oil",
    "limited",
    "may_be_short",
    "quantity_held",
    "value_kept",
    "whole",
]

LIMITED = "starved_"
"""How the quantity of a film begins that has no more oil than the supply delivers."""

BALANCED = {"supply_capacity", "heat_to_oil"}
"""What a bearing tells whose film may be balanced with the flow that its supply delivers."""


def limited(quantity: str) -> str:
    """The quantity of the film with the flow that the supply delivers."""
    return f"{LIMITED}{quantity}"


def is_limited(quantity: str) -> bool:
    """Whether a quantity is that of the film with the flow that the supply delivers."""
    return quantity.startswith(LIMITED)


def whole(quantity: str) -> str:
    """The quantity of the film with all the oil that it wants.

    >>> whole("starved_friction_power"), whole("friction_power"), limited("friction_power")
    ('friction_power', 'friction_power', 'starved_friction_power')
    """
    return quantity.removeprefix(LIMITED)


def quantity_held(result: Result, quantity: str) -> str:
    """Of which film a quantity is read: of that against which its limits are held.

    A quantity with limits is read as its check has it, so that a value beside its limit is the one that decides;
    should a film short of oil be the worse at one limit and the better at another, they are of two films, as the
    marks of tables say. Quantities without limits are all of one film: of that short of oil where any limit is
    held against it, and then none is read of what it does not know.
    """
    own = next((check.quantity for check in result.limits if whole(check.quantity) == quantity), None)
    if own is not None:
        return own
    short = limited(quantity)
    return short if short in QUANTITIES and is_short_of_oil(result) else quantity


def is_short_of_oil(result: Result) -> bool:
    """Whether a limit is held against the film with the flow that the supply delivers."""
    return any(is_limited(check.quantity) for check in result.limits)


def value_kept(result: Result, quantity: str) -> Any:
    """What a row of a study keeps of a result, NaN where it has no such quantity.

    Under the name of a film with limited flow stands the reading that limits are held against, so that the column
    has no gaps where the supply delivers enough.
    """
    name = quantity_held(result, whole(quantity)) if is_limited(quantity) else quantity
    return result.values.get(name, float("nan"))


def may_be_short(results: Iterable[Result], quantity: str) -> bool:
    """Whether some result is of a bearing that may be short of oil, and the quantity one of its film.

    Such a bearing has a supply whose capacity is known, and a heat balance that can be closed with it. A capacity
    is known of every film with less oil: elements that give less than the standard has them are holes and pockets,
    which have one.
    """
    known = limited(quantity) in QUANTITIES
    return known and any(one.values.keys() >= BALANCED for one in results)
