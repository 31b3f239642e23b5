"""A lubricant joins its laws, whichever viscosity they give."""

import dataclasses

import numpy as np
import pytest
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import ConstantProperty, LinearProperty, Lubricant, Vogel, Walther, lubricant

DENSITY = LinearProperty(895.0, 293.15, -0.63)
HEAT_CAPACITY = LinearProperty(1942.0, 323.15, 3.9)


def oil(law, **more):
    return Lubricant(
        "oil", law, DENSITY, HEAT_CAPACITY, ConstantProperty(0.13), law.temperature_range, "test", **more
    )


KINEMATIC = oil(Walther.through((313.15, 63.5e-6), (373.15, 8.0e-6)))
DYNAMIC = oil(Vogel(6e-5, 1000.0, 175.0))


@pytest.mark.parametrize("fluid", [KINEMATIC, DYNAMIC], ids=["kinematic law", "dynamic law"])
def test_dynamic_is_kinematic_times_density(fluid):
    kelvin = np.linspace(283.15, 393.15, 12)
    assert_allclose(
        fluid.dynamic_viscosity(kelvin), fluid.kinematic_viscosity(kelvin) * fluid.density(kelvin), rtol=1e-14
    )
    for t in (300.0, 350.0):
        assert fluid.dynamic_viscosity(t) == pytest.approx(
            fluid.kinematic_viscosity(t) * fluid.density(t), rel=1e-14
        )


def test_each_law_gives_its_own_viscosity_untouched():
    assert KINEMATIC.kinematic_viscosity(323.15) == KINEMATIC.viscosity_law(323.15)
    assert DYNAMIC.dynamic_viscosity(323.15) == DYNAMIC.viscosity_law(323.15)


def test_volumetric_heat_capacity_is_the_product_unless_fixed():
    assert KINEMATIC.volumetric_heat_capacity(333.15) == pytest.approx((895 - 0.63 * 40) * (1942 + 3.9 * 10))
    fixed = dataclasses.replace(KINEMATIC, fixed_volumetric_heat_capacity=1.8e6)
    assert fixed.volumetric_heat_capacity(333.15) == 1.8e6
    assert_allclose(fixed.volumetric_heat_capacity(np.array([300.0, 350.0])), [1.8e6, 1.8e6], rtol=0)
    assert fixed.heat_capacity(333.15) == KINEMATIC.heat_capacity(333.15)


def test_conductivity_and_density_follow_their_laws():
    assert KINEMATIC.conductivity(350.0) == 0.13
    assert KINEMATIC.density(293.15) == 895.0


def test_covers_the_closed_range():
    fluid = lubricant("TP-46")
    assert fluid.temperature_range == pytest.approx((273.15, 423.15))
    lower, upper = fluid.temperature_range
    assert fluid.covers(lower)
    assert fluid.covers(upper)
    assert not fluid.covers(lower - 0.01)
    assert not fluid.covers(upper + 0.01)


@pytest.mark.parametrize(
    ("field", "value"),
    [("temperature_range", (400.0, 300.0)), ("fixed_volumetric_heat_capacity", 0.0)],
)
def test_impossible_fields_are_refused(field, value):
    with pytest.raises(InputError, match=field) as caught:
        dataclasses.replace(KINEMATIC, **{field: value})
    assert caught.value.code == "E003"
