"""Oils from a user's own numbers: what is given is kept, what is assumed is said."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import (
    Exponential,
    OilProperties,
    lubricant,
    lubricant_from_law,
    lubricant_from_points,
    lubricant_from_viscosity_index,
    viscosity_index,
)

COLD, WARM = (313.15, 46e-6), (373.15, 6.8e-6)


def test_two_points_are_kept():
    oil = lubricant_from_points("mine", COLD, WARM)
    assert oil.kinematic_viscosity(COLD[0]) == pytest.approx(COLD[1], rel=1e-12)
    assert oil.kinematic_viscosity(WARM[0]) == pytest.approx(WARM[1], rel=1e-12)
    assert oil.name == "mine"


def test_what_is_not_known_is_assumed_and_said():
    oil = lubricant_from_points("mine", COLD, WARM)
    assert len(oil.assumptions) == 3
    assert oil.density(288.15) == 880.0
    known_density = lubricant_from_points(
        "mine", COLD, WARM, OilProperties(density=870.0, density_temperature=293.15)
    )
    assert known_density.density(293.15) == pytest.approx(870.0)
    assert known_density.density(323.15) == pytest.approx(870.0 - 0.63 * 30.0)
    assert any("falls by 0.63" in text for text in known_density.assumptions)


def test_what_is_known_is_not_assumed():
    known = OilProperties(
        density=870.0,
        density_slope=-0.7,
        heat_capacity=2000.0,
        heat_capacity_slope=4.0,
        conductivity=0.14,
    )
    oil = lubricant_from_points("mine", COLD, WARM, known, source="data sheet 7")
    assert oil.assumptions == ()
    assert oil.source == "data sheet 7"
    assert oil.density(298.15) == pytest.approx(870.0 - 7.0)
    assert oil.heat_capacity(333.15) == pytest.approx(2040.0)
    assert oil.conductivity(333.15) == 0.14


def test_a_given_volumetric_heat_capacity_replaces_the_product():
    known = OilProperties(density=870.0, volumetric_heat_capacity=1.8e6)
    oil = lubricant_from_points("mine", COLD, WARM, known)
    assert oil.volumetric_heat_capacity(350.0) == 1.8e6
    assert not any("Heat capacity" in text for text in oil.assumptions)


@given(st.floats(10.0, 700.0), st.floats(40.0, 200.0))
def test_viscosity_index_is_kept(nu40, index):
    oil = lubricant_from_viscosity_index("mine", nu40 * 1e-6, index)
    nu100 = oil.kinematic_viscosity(373.15)
    assert oil.kinematic_viscosity(313.15) == pytest.approx(nu40 * 1e-6, rel=1e-10)
    # Within a gap between two ranges of the standard (0.2 % of nu100) no oil has exactly this index.
    assert viscosity_index(nu40 * 1e-6, nu100) == pytest.approx(index, abs=0.6)


def test_any_law_makes_a_lubricant_with_its_range():
    law = Exponential.through((313.15, 0.04), (343.15, 0.015))
    oil = lubricant_from_law("mine", law)
    assert oil.temperature_range == (313.15, 343.15)
    assert oil.dynamic_viscosity(313.15) == 0.04


def test_own_numbers_of_a_catalogue_oil_are_that_oil():
    known = OilProperties(density=895.0, density_temperature=293.15, heat_capacity=1942.0)
    own = lubricant_from_points("mine", (313.15, 63.5e-6), (373.15, 8e-6), known)
    shipped = lubricant("TP-46")
    for kelvin in (300.0, 330.0, 380.0):
        assert own.dynamic_viscosity(kelvin) == pytest.approx(shipped.dynamic_viscosity(kelvin), rel=1e-12)
        assert own.volumetric_heat_capacity(kelvin) == pytest.approx(shipped.volumetric_heat_capacity(kelvin))


@pytest.mark.parametrize(
    ("build", "code", "says"),
    [
        (lambda: lubricant_from_points("mine", WARM, (373.15, 46e-6)), "E006", "differ in temperature"),
        (lambda: lubricant_from_points("mine", (313.15, 6.8e-6), (373.15, 46e-6)), "E006", "exchanged"),
        (lambda: lubricant_from_points("mine", COLD, WARM, OilProperties(density=-1.0)), "E003", "value"),
        (
            lambda: lubricant_from_points("mine", COLD, WARM, OilProperties(density=870.0, density_slope=0.5)),
            "E003",
            "density_slope",
        ),
        (
            lambda: lubricant_from_points("mine", COLD, WARM, OilProperties(density_slope=-0.5)),
            "E004",
            "density_slope",
        ),
        (
            lambda: lubricant_from_points("mine", COLD, WARM, OilProperties(heat_capacity_slope=3.0)),
            "E004",
            "heat_capacity_slope",
        ),
        (lambda: lubricant_from_viscosity_index("mine", 46.0, 95.0), "E003", "m2/s"),
    ],
)
def test_unusable_numbers_are_refused(build, code, says):
    with pytest.raises(InputError, match=says) as caught:
        build()
    assert caught.value.code == code
