"""A kind that only the tests of studies have."""

from __future__ import annotations

from dataclasses import replace

import plane_slider
import pytest
from registration import forget_words

from babbitt.core import kind as registry
from babbitt.core.quantities import QUANTITIES


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
