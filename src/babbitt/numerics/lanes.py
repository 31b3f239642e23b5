"""Many values at once through formulas with branches that were written for one.

Values of many bearings stand in an array of the class `Lanes`. Arithmetic goes lane by lane as in any array. Where
a formula asks whether something holds (``if eccentricity > limit``) and the lanes agree, it goes on; where they
differ, `in_branches` runs it again for those for which it holds and for the others. Every formula thus stands in
one place, for one bearing and for thousands, and all lanes of a run take the same branches.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.picklable_error import PicklableError

__all__ = [
    "DividedLanesError",
    "Lanes",
    "assembled",
    "chooser",
    "holds_lanes",
    "in_branches",
    "lanes_at",
    "lanes_of",
]

Index = NDArray[np.intp]
Answer = TypeVar("Answer")

MOST_FAILURES = 200
"""Runs that may break off before the lanes that are left are given up."""


class DividedLanesError(PicklableError):
    """A question that the lanes answer differently.

    Attributes
    ----------
    holds : ndarray of bool, shape (n,)
        The answer of each.
    """

    def __init__(self, holds: NDArray[np.bool_]) -> None:
        super().__init__(f"{int(holds.sum())} of {holds.size} lanes")
        self.holds = holds


class Lanes(np.ndarray[Any, Any]):
    """A value for each of many bearings, shape (n,), that takes the place of one number in a formula."""

    def __bool__(self) -> bool:
        """Whether something holds, where all lanes agree."""
        holds = np.asarray(self, bool)
        if holds.all():
            return True
        if not holds.any():
            return False
        raise DividedLanesError(holds)

    def __hash__(self) -> int:  # type: ignore[override]
        """By identity, as of any object: remarks with values are told apart."""
        return id(self)

    def __format__(self, form: str) -> str:
        """No number that could be taken for the one of a bearing."""
        return "many values"

    def __round__(self, digits: int = 0) -> Lanes:
        """Lane by lane."""
        return np.asarray(self).round(digits).view(Lanes)


def lanes_of(values: NDArray[np.float64]) -> Any:
    """An array as lanes, for where a formula has one number."""
    return np.asarray(values, float).view(Lanes)


def lanes_at(value: Answer, index: Index) -> Answer:
    """The same for some of the lanes, in their order; as `chooser`, for one choice."""
    return chooser(value)(index)


def chooser(value: Answer) -> Callable[[Index], Answer]:
    """What gives the same for some of the lanes, in their order.

    Parameters
    ----------
    value : object
        Lanes, or what holds some: dataclasses, tuples, lists and dictionaries. What holds none stays.
    """
    found = _chooser(value)
    return found if found is not None else lambda index: value


def holds_lanes(value: Any) -> bool:
    """Whether a value is lanes, or holds some.

    >>> holds_lanes((1.0, {"a": lanes_of(np.ones(2))})), holds_lanes((1.0, "a"))
    (True, False)
    """
    return _chooser(value) is not None


def _chooser(value: Any) -> Callable[[Index], Any] | None:
    """What chooses lanes of a value; None where it holds none."""
    if isinstance(value, Lanes):
        return lambda index: value[index]
    if isinstance(value, tuple | list):
        return _chooser_of(dict(enumerate(value)), lambda made: type(value)(made.values()))
    if isinstance(value, dict):
        return _chooser_of(value, lambda made: made)
    if not is_dataclass(value) or isinstance(value, type):
        return None
    held = {one.name: getattr(value, one.name) for one in fields(value)}
    choosers = {name: choose for name, old in held.items() if (choose := _chooser(old)) is not None}
    if not choosers:
        return None
    return lambda index: _with(value, {name: choose(index) for name, choose in choosers.items()})


def _chooser_of(held: dict[Any, Any], make: Callable[[dict[Any, Any]], Any]) -> Callable[[Index], Any] | None:
    choosers = {key: choose for key, old in held.items() if (choose := _chooser(old)) is not None}
    if not choosers:
        return None
    return lambda index: make(held | {key: choose(index) for key, choose in choosers.items()})


def assembled(parts: Sequence[tuple[Index, Any]]) -> Any:
    """One value of those of several groups of lanes, as if their branches had never parted.

    Parameters
    ----------
    parts : sequence of (ndarray of int, object)
        Numbers of lanes, each in one group, from 0 on, and the value of the group.

    Raises
    ------
    ValueError
        Where the values differ in more than numbers.
    """
    values = [value for _, value in parts]
    first = values[0]
    if all(one is first for one in values):
        return first
    if all(isinstance(one, float | Lanes) for one in values):
        return _assembled_numbers(parts)
    if any(type(one) is not type(first) for one in values):
        raise ValueError("they differ in more than numbers")
    if isinstance(first, tuple | list | dict):
        if any(len(one) != len(first) for one in values):
            raise ValueError("they differ in length")
        keys = first if isinstance(first, dict) else range(len(first))
        made = {key: assembled([(index, value[key]) for index, value in parts]) for key in keys}
        return made if isinstance(first, dict) else type(first)(made.values())
    if is_dataclass(first):
        names = [one.name for one in fields(first)]
        return _with(first, {name: assembled([(i, getattr(value, name)) for i, value in parts]) for name in names})
    if any(one != first for one in values):
        raise ValueError("they differ in more than numbers")
    return first


def _assembled_numbers(parts: Sequence[tuple[Index, Any]]) -> Any:
    first = parts[0][1]
    if not any(isinstance(one, Lanes) for _, one in parts) and all(one == first for _, one in parts):
        return first
    made = np.empty(sum(index.size for index, _ in parts), np.result_type(*(np.asarray(one) for _, one in parts)))
    for index, value in parts:
        made[index] = value
    return made.view(Lanes)


def _with(value: Any, changes: dict[str, Any]) -> Any:
    """A copy of a frozen dataclass with other fields, which were found valid before."""
    made = copy.copy(value)
    for name, new in changes.items():
        object.__setattr__(made, name, new)
    return made


def in_branches(formula: Callable[[Index], Answer], lanes: Index) -> Iterator[tuple[Index, Answer | None]]:
    """Run a formula for groups of lanes that take the same branches.

    Parameters
    ----------
    formula : callable
        From the numbers of some lanes to their answer; asked again for fewer of them where they differ.
    lanes : ndarray of int
        Numbers of all lanes.

    Yields
    ------
    index : ndarray of int
        Lanes that went the same way.
    answer : object or None
        None for lanes with which the formula breaks off: what it raises for one of them, it says for that one
        when it is asked for it alone.
    """
    waiting = [lanes] if lanes.size else []
    failures = 0
    while waiting:
        index = waiting.pop()
        try:
            answer = formula(index)
        except DividedLanesError as divided:
            waiting += [index[~divided.holds], index[divided.holds]]
            continue
        except Exception:  # whatever these lanes break off with; each of them says so when it is asked for alone
            failures += 1
            if index.size == 1 or failures > MOST_FAILURES:
                yield index, None
            else:  # one of them is to blame, and the others are not
                half = index.size // 2
                waiting += [index[half:], index[:half]]
            continue
        yield index, answer
