"""Clearances from every kind of input agree with each other and refuse what cannot be."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.properties.fits import (
    LARGEST_RELATIVE_CLEARANCE,
    Clearance,
    Deviations,
    SizeLimits,
    tolerance_limits,
)

diameters = st.floats(0.01, 0.6)
psis = st.floats(1e-5, LARGEST_RELATIVE_CLEARANCE * 0.99)


def um(clearance: Clearance) -> list[float]:
    return [round(value * 1e6, 3) for value in (clearance.minimum, clearance.mean, clearance.maximum)]


def code_of(call) -> str:
    with pytest.raises(InputError) as error:
        call()
    return error.value.code


def test_sizes_by_hand():
    """C_max = D_max - D_J,min, C_min = D_min - D_J,max."""
    clearance = Clearance.from_sizes(SizeLimits(0.250, 0.250046), SizeLimits(0.249591, 0.249637))
    assert um(clearance) == [363, 409, 455]
    psi = clearance.relative(0.250)
    assert psi.mean == pytest.approx((363e-6 + 455e-6) / (2 * 0.250))


def test_fit_by_hand():
    """50 H7/e8: hole +25/0, shaft -50/-89 um."""
    assert um(Clearance.from_fit(0.050, "H7/e8")) == [50, 82, 114]
    assert Clearance.from_fit(0.050, " H7 / e8 ") == Clearance.from_tolerance_classes(0.050, "H7", "e8")


@given(diameters, psis)
def test_one_value_has_no_spread_and_comes_back(diameter, psi):
    clearance = Clearance.from_diametral(psi * diameter, diameter)
    assert clearance.minimum == clearance.mean == clearance.maximum
    assert clearance.relative(diameter).mean == pytest.approx(psi, rel=1e-14)


@given(diameters, psis, psis)
def test_limits_enclose_the_mean(diameter, one, other):
    low, high = sorted((one, other))
    clearance = Clearance.from_diametral_limits(low * diameter, high * diameter, diameter)
    assert clearance.minimum <= clearance.mean <= clearance.maximum
    assert clearance.mean == pytest.approx((low + high) / 2 * diameter, rel=1e-12)


@given(
    st.floats(0.003, 0.5),
    st.sampled_from(["E", "F", "G", "H"]),
    st.sampled_from(["d", "e", "f", "g", "h"]),
    st.integers(5, 8),
    st.integers(5, 8),
)
def test_spread_of_a_fit_is_the_sum_of_both_tolerances(nominal, hole, shaft, hole_grade, shaft_grade):
    bore, journal = f"{hole}{hole_grade}", f"{shaft}{shaft_grade}"
    clearance = Clearance.from_tolerance_classes(nominal, bore, journal)
    tolerances = tolerance_limits(bore, nominal).tolerance + tolerance_limits(journal, nominal).tolerance
    assert clearance.maximum - clearance.minimum == pytest.approx(tolerances, abs=1e-12)
    assert clearance.minimum <= clearance.mean <= clearance.maximum


def test_h_on_h_has_zero_smallest_clearance():
    """Zero is allowed cold: a bearing that expands more than its journal opens."""
    assert Clearance.from_fit(0.050, "H7/h6").minimum == 0.0


def test_deviations_agree_with_sizes():
    bore, journal = Deviations(1e-5, 3e-5), Deviations(-6e-5, -4e-5)
    by_size = Clearance.from_sizes(SizeLimits(0.08001, 0.08003), SizeLimits(0.07994, 0.07996))
    assert um(Clearance.from_deviations(0.080, bore, journal)) == um(by_size)


@pytest.mark.parametrize(
    "contradiction",
    [
        lambda: Clearance.from_sizes(SizeLimits(0.0499, 0.0501), SizeLimits(0.0500, 0.05005)),
        lambda: Clearance.from_fit(0.060, "H7/j6"),
        lambda: Clearance.from_deviations(0.06, Deviations(0.0, 1e-5), Deviations(5e-6, 1e-5)),
        lambda: Clearance(-1e-6, 0.0, 1e-6),
        lambda: Clearance(3e-5, 2e-5, 4e-5),
        lambda: Clearance(0.0, 0.0, 0.0),
        lambda: Clearance.from_diametral(-1e-5, 0.05),
        lambda: Clearance.from_diametral(0.06, 0.05),
        lambda: Clearance.from_diametral(0.0075, 0.05),
        lambda: Clearance.from_sizes(SizeLimits(0.5, 0.5001), SizeLimits(0.05, 0.0501)),
        lambda: Clearance.from_diametral_limits(6e-5, 4e-5, 0.05),
        lambda: Clearance(1e-4, 1e-4, 1e-4).relative(1e-4),
        lambda: SizeLimits(0.051, 0.050),
        lambda: Deviations(1e-5, -1e-5),
    ],
)
def test_contradictions(contradiction):
    assert code_of(contradiction) == "E004"


@pytest.mark.parametrize(
    "unusable",
    [
        lambda: Clearance(math.nan, 1e-5, 2e-5),
        lambda: Clearance.from_diametral(math.nan, 0.05),
        lambda: Clearance.from_diametral(math.inf, 0.05),
        lambda: Clearance.from_diametral(5e-5, 0.0),
        lambda: Clearance.from_diametral(5e-5, math.nan),
        lambda: SizeLimits(0.0, 0.05),
        lambda: SizeLimits(0.05, math.inf),
        lambda: Deviations(math.nan, 0.0),
    ],
)
def test_unusable_numbers(unusable):
    assert code_of(unusable) == "E003"


@pytest.mark.parametrize("fit", ["h7/e8", "H7/E8", "e8/H7", "H7", "H7/", "/e8", "H7e8", "H7/e8/f7", "Z7/e8"])
def test_not_a_fit(fit):
    assert code_of(lambda: Clearance.from_fit(0.05, fit)) == "E005"


def test_message_shows_both_sizes_and_a_way_out():
    with pytest.raises(InputError) as error:
        Clearance.from_sizes(SizeLimits(0.0499, 0.0501), SizeLimits(0.0500, 0.05005))
    assert "49.9 mm" in error.value.message
    assert "50.05 mm" in error.value.message
    assert "enlarge the bore" in error.value.message


def test_slip_of_unit_is_named():
    with pytest.raises(InputError, match=r"larger than the journal of 250 mm; check the unit"):
        Clearance.from_diametral(0.4, 0.25)
