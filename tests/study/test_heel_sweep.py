"""Steady states on a grid of face gaps and clearances."""

import math

import numpy as np
import pytest
from heels import STUDY

from babbitt.case import parse_case
from babbitt.kinds.footstep.states import StateName
from babbitt.kinds.footstep.study.sweep import sweep_heel

FOOTSTEP = parse_case(STUDY).problems()[1].footstep


def test_grid_of_states():
    seen = []

    def watch(places):
        seen.extend(places)
        return places

    sweep = sweep_heel(FOOTSTEP, (12e-6, 20e-6), (10e-6, 15e-6, 20e-6), watch=watch)
    assert seen == list(range(6))
    assert sweep.counts.tolist() == [[0, 2, 2], [2, 2, 2]]
    loads = sweep.values("load", StateName.HOT)
    assert loads.shape == (2, 3)
    assert math.isnan(loads[0, 0])
    assert loads[1, 2] == pytest.approx(829.1176, rel=1e-5)
    assert sweep.values("stable", StateName.HOT)[1].tolist() == [0.0, 0.0, 0.0]
    assert sweep.values("stable", StateName.COLD)[1].tolist() == [1.0, 1.0, 1.0]
    assert sweep.names == (StateName.HOT, StateName.COLD)


def test_loads_fall_with_the_clearance():
    loads = sweep_heel(FOOTSTEP, (20e-6,), np.linspace(11e-6, 40e-6, 8)).values("load", StateName.HOT)[0]
    assert (np.diff(loads) < 0.0).all()


def test_both_methods_side_by_side():
    from babbitt.report.comparison_table import print_comparison
    from babbitt.study.comparison import compare_methods

    (comparison,) = compare_methods(parse_case(STUDY))
    labels = [variant.label for variant in comparison.variants]
    assert labels == [
        "study, smooth heel", "study, hot state", "study, cold state", "narrow grooves, smooth heel",
        "narrow grooves, grooved heel",
    ]  # fmt: skip
    smooth = [variant.result for variant in comparison.variants if "smooth" in variant.label]
    assert smooth[0].load == pytest.approx(
        smooth[1].load, rel=1e-3
    )  # without metal only the heat of the face differs
    assert print_comparison((comparison,))
