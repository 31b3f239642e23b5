"""Viscosity index against published values and the reference table, and its inverses against each other."""

import itertools
import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import nu40_from_viscosity_index, nu100_from_viscosity_index, viscosity_index
from babbitt.properties.lubricants.viscosity_index import REFERENCE_OILS

MM2 = 1e-6
# nu100, L, H in mm2/s: lines of table 1 of ASTM D2270 as held by the MIT-licensed package `chemicals` 1.5.2.
TABLE = [
    (2, 7.994, 6.394),
    (3.5, 20.09, 15.66),
    (4.2, 27.75, 21.21),
    (5, 40.23, 28.49),
    (6.7, 71.29, 45.33),
    (8, 100.0, 59.6),
    (10, 147.7, 82.87),
    (14, 263.3, 135.4),
    (16, 331.9, 164.6),
    (20, 493.2, 229.5),
    (25, 736.5, 320.9),
    (30, 1023.0, 421.7),
    (50, 2618.0, 919.6),
    (60, 3676.0, 1222.0),
    (70, 4905.0, 1558.0),
]

indices = st.floats(-60.0, 300.0)
nu100s = st.floats(2.0, 150.0)


@pytest.mark.parametrize(
    ("nu40", "nu100", "printed"),
    [(63.5, 8.0, "90.33"), (73.30, 8.86, "92.43")],
)
def test_published_examples(nu40, nu100, printed):
    assert f"{viscosity_index(nu40 * MM2, nu100 * MM2):.2f}" == printed


def test_example_of_method_b_in_astm_d2270():
    # The standard finds 156.37 with H rounded to 28.97 and reports 156; the quadratic gives H = 28.979.
    assert viscosity_index(22.83 * MM2, 5.05 * MM2) == pytest.approx(156.37, abs=0.1)
    n = (math.log10(28.97) - math.log10(22.83)) / math.log10(5.05)
    assert nu40_from_viscosity_index(100 + (10**n - 1) / 0.00715, 5.05 * MM2) == pytest.approx(
        22.83 * MM2 * 28.97887 / 28.97, rel=1e-5
    )


def test_published_inverses():
    assert f"{nu40_from_viscosity_index(90.0, 8.0 * MM2) / MM2:.2f}" == "63.63"
    assert f"{nu100_from_viscosity_index(90.0, 50.0 * MM2) / MM2:.3f}" == "6.874"


@pytest.mark.parametrize(("nu100", "low", "high"), TABLE)
def test_reference_oils_meet_the_table_of_the_standard(nu100, low, high):
    assert nu40_from_viscosity_index(0.0, nu100 * MM2) / MM2 == pytest.approx(low, rel=1.1e-3)
    assert nu40_from_viscosity_index(100.0, nu100 * MM2) / MM2 == pytest.approx(high, rel=1.1e-3)


@pytest.mark.parametrize(("nu100", "low", "high"), TABLE)
def test_index_of_the_reference_oils_is_0_and_100(nu100, low, high):
    assert viscosity_index(low * MM2, nu100 * MM2) == pytest.approx(0.0, abs=0.3)
    assert viscosity_index(high * MM2, nu100 * MM2) == pytest.approx(100.0, abs=0.4)


@given(indices, nu100s)
def test_index_comes_back_from_nu40(index, nu100):
    nu40 = nu40_from_viscosity_index(index, nu100 * MM2)
    assert viscosity_index(nu40, nu100 * MM2) == pytest.approx(index, abs=1e-9 * (1.0 + abs(index)))


@given(indices, nu100s)
def test_nu100_from_nu40_is_an_oil_of_that_index(index, nu100):
    nu40 = nu40_from_viscosity_index(index, nu100 * MM2)
    found = nu100_from_viscosity_index(index, nu40)
    assert nu40_from_viscosity_index(index, found) == pytest.approx(nu40, rel=1e-10)
    # Adjoining ranges of the standard overlap by up to 0.2 %, where two answers are right.
    assert found == pytest.approx(nu100 * MM2, rel=2e-3)


@given(nu100s)
def test_the_two_methods_meet_at_index_100(nu100):
    seam = nu40_from_viscosity_index(100.0, nu100 * MM2)
    assert nu40_from_viscosity_index(100.0 + 1e-9, nu100 * MM2) == pytest.approx(seam, rel=1e-9)
    assert viscosity_index(seam * (1 + 1e-12), nu100 * MM2) == pytest.approx(100.0, abs=1e-8)
    assert viscosity_index(seam * (1 - 1e-12), nu100 * MM2) == pytest.approx(100.0, abs=1e-8)
    assert nu100_from_viscosity_index(100.0 + 1e-9, seam) == pytest.approx(
        nu100_from_viscosity_index(100.0, seam), rel=2e-3
    )


@given(nu100s, st.floats(1.3, 12.0), st.floats(1.001, 1.2))
def test_a_larger_drop_of_viscosity_is_a_smaller_index(nu100, ratio, more):
    nu40 = nu100 * ratio
    assume(nu40 * more > nu100 * 1.3)
    assert viscosity_index(nu40 * more * MM2, nu100 * MM2) < viscosity_index(nu40 * MM2, nu100 * MM2)


@pytest.mark.parametrize("index", [0.0, 50.0, 140.0])
def test_between_two_ranges_that_do_not_meet_the_limit_is_the_answer(index):
    gaps = 0
    for before, after in itertools.pairwise(REFERENCE_OILS):
        limit = after.lower
        end = nu40_from_viscosity_index(index, math.nextafter(limit, 0.0) * MM2)
        start = nu40_from_viscosity_index(index, limit * MM2 * (1 + 1e-15))
        assert before.upper == limit
        assert start == pytest.approx(end, rel=2e-3)
        if start > end * (1 + 1e-6):
            gaps += 1
            assert nu100_from_viscosity_index(index, (start + end) / 2) == pytest.approx(limit * MM2, rel=1e-12)
    assert gaps > 0


@pytest.mark.parametrize(
    ("call", "code", "says"),
    [
        (lambda: viscosity_index(8.0e-6, 8.0e-6), "E006", "must be smaller than nu40"),
        (lambda: viscosity_index(8.0e-6, 63.5e-6), "E006", "exchanged"),
        (lambda: viscosity_index(6.0e-6, 1.99e-6), "E006", "from nu100 = 2 mm2/s"),
        (lambda: viscosity_index(63.5, 8.0), "E003", "nu40 is in m2/s"),
        (lambda: viscosity_index(math.nan, 8.0e-6), "E003", "nu40"),
        (lambda: viscosity_index(63.5e-6, -8.0e-6), "E003", "nu100"),
        (lambda: nu40_from_viscosity_index(95.0, 1.5e-6), "E006", "from nu100 = 2"),
        (lambda: nu40_from_viscosity_index(math.inf, 8e-6), "E003", "index"),
        (lambda: nu40_from_viscosity_index(1e5, 8e-6), "E006", "no oil"),
        (lambda: nu100_from_viscosity_index(95.0, 5e-6), "E006", "no oil with nu40 = 5"),
        (lambda: nu100_from_viscosity_index(1e5, 46e-6), "E006", "no oil with nu40 = 46"),
        (lambda: nu100_from_viscosity_index(150.0, 1.5e-6), "E006", "no oil"),
        (lambda: nu100_from_viscosity_index(95.0, math.nan), "E003", "nu40"),
    ],
)
def test_what_the_standard_does_not_define_is_refused(call, code, says):
    with pytest.raises(InputError, match=says) as caught:
        call()
    assert caught.value.code == code
