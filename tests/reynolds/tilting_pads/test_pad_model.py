"""Pads and bearings that cannot be."""

import math
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
    [
        {"extent": 0.0},
        {"assembled_clearance": 0.0},
        {"pivot_fraction": 1.0},
        {"mass": -1.0},
        {"inertia": -1.0},
        {"mass_offset": math.nan},
        {"rest_tilt": math.inf},
        {"profile": (0.0, math.nan)},
        {"inertia": 0.0199, "mass": 2.0, "mass_offset": 0.08, "mass_inset": 0.06},
    ],
)
def test_impossible_pads_are_refused(change):
    with pytest.raises(InputError, match=next(iter(change))):
        replace(pad(0.0, 80.0), **change)


def test_a_pad_that_is_a_point_of_mass_is_allowed():
    assert replace(pad(0.0, 80.0), inertia=0.02, mass=2.0, mass_offset=-0.08, mass_inset=0.06).inertia == 0.02
