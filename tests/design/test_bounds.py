"""Checks of values that flatter the bearing: a miss is certain, a pass is none."""

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design.bounds import certain, undecided

KEPT = Check("C101", "minimum_film_thickness", 20e-6, 9e-6, Bound.AT_LEAST, "test")
MISSED = Check("C102", "minimum_film_thickness", 5e-6, 9e-6, Bound.AT_LEAST, "test")
OTHER = Check("C110", "film_reynolds_number", 10.0, 1000.0, Bound.AT_MOST, "test")
BOUNDS = {code: Notice(code, "prescribed_cooler") for code in ("C101", "C102")}


def test_a_kept_limit_is_left_out_with_its_reason_and_a_missed_one_stays():
    assert certain([KEPT, MISSED, OTHER], BOUNDS) == (MISSED, OTHER)
    assert undecided([KEPT, MISSED, OTHER], BOUNDS) == (BOUNDS["C101"],)


def test_without_bounds_every_check_stays():
    assert certain([KEPT, MISSED], {}) == (KEPT, MISSED)
    assert undecided([KEPT, MISSED], {}) == ()
