"""Density, heat capacity and conductivity laws."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import ConstantProperty, LinearProperty, ShiftedLaw

temperatures = st.floats(275.0, 420.0)


def test_density_of_the_study_oil():
    density = LinearProperty(895.0, 293.15, -0.63)
    assert density(293.15) == 895.0
    assert density(323.15) == pytest.approx(895.0 - 0.63 * 30.0, abs=1e-10)


def test_heat_capacity_of_the_study_oil_is_0464_kcal_per_kg_and_kelvin():
    heat_capacity = LinearProperty(1942.0, 323.15, 3.9)
    assert heat_capacity(323.15) / 4186.8 == pytest.approx(0.464, abs=5e-4)
    assert heat_capacity(363.15) == pytest.approx(1942.0 + 3.9 * 40.0, abs=1e-9)


@given(temperatures, temperatures, st.floats(700.0, 1000.0))
def test_shifted_law_meets_its_point_and_keeps_the_slope(known_at, temperature, value):
    reference = LinearProperty(901.0, 293.15, -0.63)
    shifted = ShiftedLaw.through(reference, known_at, value)
    assert shifted(known_at) == pytest.approx(value, rel=1e-14)
    assert shifted(temperature) - reference(temperature) == pytest.approx(shifted.offset, abs=1e-9)


def test_shifting_a_shifted_law_starts_from_the_reference_again():
    reference = LinearProperty(901.0, 293.15, -0.63)
    twice = ShiftedLaw.through(ShiftedLaw.through(reference, 293.15, 905.0), 293.15, 895.0)
    assert twice == ShiftedLaw.through(reference, 293.15, 895.0)
    assert twice.reference is reference


@pytest.mark.parametrize(
    "law",
    [
        ConstantProperty(0.13),
        LinearProperty(895.0, 293.15, -0.63),
        ShiftedLaw(LinearProperty(895.0, 293.15, -0.63), -6.0),
    ],
    ids=lambda law: type(law).__name__,
)
def test_an_array_gives_what_its_elements_give(law):
    kelvin = np.array([[290.0, 313.15], [340.5, 373.15]])
    assert_allclose(law(kelvin), [[law(float(t)) for t in row] for row in kelvin], rtol=1e-14)
    assert isinstance(law(300.0), float)
    with pytest.raises(InputError, match="has no value at"):
        law(math.nan)


@pytest.mark.parametrize(
    ("build", "says"),
    [
        (lambda: ConstantProperty(0.0), "value"),
        (lambda: LinearProperty(-895.0, 293.15, -0.63), "reference_value"),
        (lambda: LinearProperty(895.0, 293.15, math.nan), "slope"),
        (lambda: ShiftedLaw(ConstantProperty(1.0), math.inf), "offset"),
        (lambda: ShiftedLaw.through(ConstantProperty(1.0), 300.0, -2.0), "value"),
    ],
)
def test_numbers_without_a_meaning_are_refused(build, says):
    with pytest.raises(InputError, match=says) as caught:
        build()
    assert caught.value.code == "E003"
