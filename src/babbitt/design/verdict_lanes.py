"""Bearings that were solved as lanes, by their verdict."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Check, Result, Verdict
from babbitt.numerics.lanes import chooser, in_branches

__all__ = ["by_verdict"]

Index = NDArray[np.intp]
Found = TypeVar("Found")


def by_verdict(
    found: Found,
    checks: Iterable[Check],
    count: int,
    failed: Callable[[Found], Result],
    with_remarks: Callable[[Found], tuple[Result, Verdict]],
) -> Iterator[tuple[Index, Result, Verdict]]:
    """Bearings by their verdict. One that misses a limit fails, whatever is to be remarked.

    Parameters
    ----------
    found : object
        What is known of all bearings, in lanes.
    checks : iterable of Check
        Theirs.
    count : int
        Bearings.
    failed : callable
        From the bearings that miss a limit their result.
    with_remarks : callable
        From bearings that keep all limits their result and verdict.

    Yields
    ------
    index : ndarray of int
        Bearings of one verdict. Those with which `with_remarks` breaks off are left out.
    result : Result
    verdict : Verdict
    """
    choose = chooser(found)
    fails = np.zeros(count, bool)
    for check in checks:
        if not check.advisory:
            fails |= ~np.broadcast_to(np.asarray(check.kept, bool), (count,))
    if (failing := np.flatnonzero(fails)).size:
        yield failing, failed(choose(failing)), Verdict.FAIL
    for index, answer in in_branches(lambda lanes: with_remarks(choose(lanes)), np.flatnonzero(~fails)):
        if answer is not None:
            yield index, *answer
