"""Pads and bearings that cannot be."""

from dataclasses import replace

import pytest
from scaled_pads import one_pad, pad

from babbitt.core.notices import InputError


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"pads": ()}, "pads"),
        ({"viscosity": 0.0}, "viscosity"),
        ({"angular_speed": 0.0}, "angular_speed"),
        ({"groove_pressure": -1.0}, "groove_pressure"),
        ({"pads": (pad(0.0, 80.0), pad(70.0, 80.0))}, "pad 1 covers 80 degrees"),
    ],
)
def test_impossible_bearings_are_refused(change, word):
    with pytest.raises(InputError, match=word):
        replace(one_pad(), **change)


@pytest.mark.parametrize(
    "change",
    [{"extent": 0.0}, {"assembled_clearance": 0.0}, {"pivot_fraction": 1.0}, {"mass": -1.0}, {"inertia": -1.0}],
)
def test_impossible_pads_are_refused(change):
    with pytest.raises(InputError, match=next(iter(change))):
        replace(pad(0.0, 80.0), **change)
