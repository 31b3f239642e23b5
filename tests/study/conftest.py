"""A kind that only the tests of studies have."""

from __future__ import annotations

from dataclasses import replace

import plane_slider
import pytest
from registration import forget_words

from babbitt.core import kind as registry
from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.study import many_rows
from babbitt.study.rows import solved_one_by_one


@pytest.fixture
def sliders():
    """Register the plane slider; rows are solved as arrays."""
    yield from _registered(replace(plane_slider.KIND, solve_many="slider_cases:many_sliders"))


@pytest.fixture
def single_sliders():
    """Register the plane slider; rows are solved one by one."""
    yield from _registered(plane_slider.KIND)


def _registered(kind):
    registry.kinds()
    tables = (registry._REGISTERED, QUANTITIES)
    before = [set(table) for table in tables]
    registry.register(kind)
    yield
    for table, names in zip(tables, before, strict=True):
        for name in set(table) - names:
            del table[name]
    forget_words()


@pytest.fixture
def one_by_one(monkeypatch):
    """Rows that were left to the way of one bearing."""
    left = []

    def counted(task, rows):
        left.extend(rows["row"].tolist())
        return solved_one_by_one(task, rows)

    monkeypatch.setattr(many_rows, "solved_one_by_one", counted)
    return left
