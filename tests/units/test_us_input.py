"""US units at the door, and what is said where one is not known."""

import pytest

from babbitt.core.units import KINDS, QuantityError, read, si


@pytest.mark.parametrize(
    ("text", "unit", "same"),
    [
        ("264.172052358 gpm", "m3/s", "1000 L/min"),
        ("4 mils", "m", "101.6 um"),
        ("1000 lbf*s/in", "N s/m", "175126.83524647 N s/m"),
        ("1 klbf/in", "N/m", "1000 lbf/in"),
        ("9 delta_degF", "K difference", "5 K"),
        ("9 degR", "K difference", "5 delta_degC"),
        ("12 lbf in", "N m", "1 lbf ft"),
        ("1 hp", "W", "745.69987158227 W"),
    ],
)
def test_us_units_are_read(text, unit, same):
    assert read(text, unit) == pytest.approx(read(same, unit), rel=1e-11)


def test_a_mark_for_inches_is_answered_with_in():
    with pytest.raises(QuantityError, match="write '4 in'"):
        read('4.000"', "m")


def test_gauge_pressure_is_answered_with_psi():
    with pytest.raises(QuantityError, match="write 'psi'"):
        read("20 psig", "Pa")


def test_a_bare_temperature_is_offered_both_scales():
    with pytest.raises(QuantityError, match="write '120 degC' or '120 degF'"):
        si("K", "-30 degC", "200 degC").as_written(120)


def test_a_temperature_is_no_difference():
    with pytest.raises(QuantityError, match="'K', 'delta_degC', 'delta_degF' or 'degR'"):
        read("3 degF", "K difference")


def test_guesses_are_units_of_their_kind():
    assert all(set(kind.guesses) <= set(kind.everyday) for kind in KINDS.values())
