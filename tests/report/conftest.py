"""Fixtures: results built by hand."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import pytest
from hand_made import KIND, PUBLISHED, HandMadeMachine, hand_made_result

from babbitt.core import kind
from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Outcome, Result

FAR = Notice("S001", "carries_little", {"reached": 330.0, "asked": ""})
"""How far the bearing without an operating point came."""


@pytest.fixture(autouse=True)
def hand_made_kind() -> Iterator[None]:
    """The kind of results built by hand."""
    kind.find_kind("journal")
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(kind._REGISTERED, KIND.name, KIND)
        yield


@pytest.fixture
def reverse_gear() -> HandMadeMachine:
    """Eleven bearings, all limits kept."""
    return HandMadeMachine("Marine reverse gear", tuple(hand_made_result(row) for row in PUBLISHED))


@pytest.fixture
def good() -> Result:
    """One bearing that keeps its limits."""
    return hand_made_result(PUBLISHED[0])


@pytest.fixture
def violated(good: Result) -> Result:
    """One bearing with a film below its limit."""
    thin = Check("C101", "minimum_film_thickness", 12e-6, 16e-6, Bound.AT_LEAST, "surface geometry")
    values = {**good.values, "minimum_film_thickness": 12e-6}
    return replace(good, name="Thin film", values=values, checks=(thin, *good.checks[1:]))


@pytest.fixture
def unsolved(good: Result) -> Result:
    """One bearing without an operating point; 31.4 µm is the last state of its iteration."""
    return replace(
        good,
        name="Overloaded",
        outcome=Outcome.OVERLOADED,
        values={"minimum_film_thickness": 31.4e-6, "side_flow": math.nan},
        checks=(),
        failure=Notice("S001", "tried", {"far": FAR}),
    )
