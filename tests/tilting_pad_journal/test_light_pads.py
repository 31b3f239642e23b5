"""Offset pads that would have to carry less than they can, but little of the load."""

import math

import numpy as np
import pytest
from pad_journals import result_of

from babbitt.core.result import Outcome

TURBINE = {
    "diameter": "280 mm",
    "pads": {
        "number": 5, "first_pivot": "-54 deg", "extent": "56 deg", "width": "168 mm", "thickness": "45 mm",
        "assembled_clearance": {"kind": "radial", "mean": "210 um"}, "preload": 0.25,
        "pivot": {"kind": "rocker", "fraction": 0.55}, "mass": "9.4 kg", "inertia": "0.027 kg m2",
    },
    "load": "60 kN", "load_angle": "-90 deg", "supply": {"temperature": "50 degC"}, "feed": "spray_bar",
    "thermal": "global", "accuracy": "engineering",
}  # fmt: skip
"""Load between the lower pads; the upper one unloads near 3500 rpm."""


def light_notices(result):
    """What is said of pads that are left without load."""
    return [one for one in result.warnings if one.code == "W417"]


def test_a_pad_that_flutters_under_little_load_is_left_without():
    """The other pads alone balance the load; neighbours in speed have nearly the same stiffness."""
    slower, found, faster = (result_of(**TURBINE, speed=f"{speed} rpm") for speed in (3400, 3500, 3600))
    assert found.outcome is Outcome.CONVERGED
    (notice,) = light_notices(found)
    assert not light_notices(slower) + light_notices(faster)
    assert 0.0 < notice.values["need"] < notice.values["least"] <= 0.02 * found.values["load"]
    (loads,), (angles,) = found.arrays["pad_load"], found.arrays["pad_pivot_angle"]
    assert loads[notice.values["pad"] - 1] == 0.0
    force = np.array([[math.cos(angle), math.sin(angle)] for angle in angles]).T @ loads
    assert force == pytest.approx([0.0, -60e3], abs=60.0)
    for one in (slower, faster):
        assert found.values["stiffness_yy"] == pytest.approx(one.values["stiffness_yy"], rel=0.05)
    assert notice.values["stiffness"] < 0.05
    assert notice.values["film"] < 0.01
