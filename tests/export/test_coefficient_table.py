"""What a coefficient table refuses, and that nobody can change it afterwards."""

import numpy as np
import pytest
from coefficient_tables import table

from babbitt.core.notices import InputError
from babbitt.export import CoefficientTable, Frame

K = np.ones((3, 2, 2))


@pytest.mark.parametrize(
    ("given", "code", "words"),
    [
        ({"speeds": [1.0, 2.0, 2.0]}, "E003", "increase"),
        ({"speeds": [3.0, 2.0, 1.0]}, "E003", "increase"),
        ({"speeds": [-1.0, 2.0, 3.0]}, "E003", "not be negative"),
        ({"speeds": []}, "E003", "one speed or more"),
        ({"speeds": [[1.0, 2.0, 3.0]]}, "E003", "shape"),
        ({"speeds": [1.0, np.nan, 3.0]}, "E003", "NaN"),
        ({"speeds": ["fast", 2.0, 3.0]}, "E003", "not an array of numbers"),
        ({"stiffness": np.full((3, 2, 2), np.inf)}, "E003", "stiffness contains NaN or infinity"),
        ({"damping": K[:2]}, "E004", r"\(2, 2, 2\)"),
        ({"mass": np.ones((3, 4))}, "E004", "mass"),
        ({"static": {"load": [1.0, 2.0]}}, "E004", "load"),
        ({"static": {"weight": [1.0, 2.0, 3.0]}}, "E003", "weight"),
        ({"name": " "}, "E003", "name the bearing"),
        ({"name": "two\nlines"}, "E003", "one line"),
        ({"method": "two\nlines"}, "E003", "one line"),
    ],
)
def test_unusable_tables_are_refused_with_the_field_named(given, code, words):
    usable = {"name": "Gear side", "speeds": [1.0, 2.0, 3.0], "stiffness": K, "damping": K}
    CoefficientTable(**usable)
    with pytest.raises(InputError, match=words) as refused:
        CoefficientTable(**(usable | given))
    assert refused.value.code == code


@pytest.mark.parametrize("angle", [np.nan, np.inf])
def test_a_frame_needs_finite_angles(angle):
    with pytest.raises(InputError, match="finite"):
        Frame(load_angle=angle)


def test_the_arrays_are_copies_and_cannot_be_changed():
    speeds = np.array([1.0, 2.0, 3.0])
    made = CoefficientTable("Gear side", speeds, K, K, static={"load": speeds})
    speeds[0] = 1.5
    assert made.speeds[0] == 1.0
    for values in (made.speeds, made.stiffness, made.damping, made.static["load"]):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 7.0
    with pytest.raises(TypeError):
        made.static["load"] = speeds


def test_the_default_frame_is_the_frame_of_babbitt():
    frame = CoefficientTable("Gear side", [1.0, 2.0, 3.0], K, K).frame
    assert (frame.rotation.value, frame.load_angle, frame.x_axis_angle) == ("counter-clockwise", -np.pi / 2, 0.0)
    assert table().mass is None
