"""Tables of viscosities: their points, Andrade's law between, the error against smooth laws, refusals."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import TabulatedViscosity, ViscosityKind, lubricant

POINTS = ((293.15, 0.1), (323.15, 0.025), (363.15, 0.008), (393.15, 0.0045))


def test_points_are_met_exactly_alone_and_in_arrays():
    law = TabulatedViscosity(POINTS)
    assert [law(kelvin) for kelvin, _ in POINTS] == [viscosity for _, viscosity in POINTS]
    kelvin, viscosity = np.array(POINTS).T
    assert np.array_equal(law(kelvin), viscosity)
    assert law(kelvin.reshape(2, 2)).shape == (2, 2)
    assert law.temperature_range == (293.15, 393.15)
    assert law.kind is ViscosityKind.DYNAMIC


def test_a_fluid_by_andrade_is_met_everywhere_beyond_the_table_too():
    def andrade(kelvin):
        return 2e-6 * np.exp(3200.0 / kelvin)

    law = TabulatedViscosity(tuple((kelvin, float(andrade(kelvin))) for kelvin in (283.15, 300.0, 350.0, 380.0)))
    everywhere = np.linspace(250.0, 430.0, 181)
    np.testing.assert_allclose(law(everywhere), andrade(everywhere), rtol=1e-12)
    assert [law(float(kelvin)) for kelvin in everywhere] == pytest.approx(law(everywhere), rel=1e-14)


def test_between_two_points_it_is_the_geometric_mean_at_the_harmonic_mean():
    law = TabulatedViscosity(POINTS)
    middle = 2.0 / (1.0 / 323.15 + 1.0 / 363.15)
    assert law(middle) == pytest.approx(math.sqrt(0.025 * 0.008), rel=1e-12)


@pytest.mark.parametrize("name", ["ISO VG 32", "ISO VG 46", "ISO VG 320"])
def test_an_oil_by_walther_is_met_with_the_square_of_the_step(name):
    oil = lubricant(name)
    everywhere = np.linspace(273.15, 393.15, 4001)

    def error(step):
        at = np.arange(273.15, 393.15 + 0.5 * step, step)
        law = TabulatedViscosity(
            tuple(zip(at.tolist(), oil.kinematic_viscosity(at).tolist(), strict=True)), ViscosityKind.KINEMATIC
        )
        return np.abs(law(everywhere) / oil.kinematic_viscosity(everywhere) - 1.0).max()

    assert error(5.0) < 3e-3
    assert error(10.0) / error(5.0) == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize(
    ("points", "code"),
    [
        (POINTS[:2], "E006"),
        (POINTS[::-1], "E006"),
        ((*POINTS[:3], (370.0, 0.008)), "E006"),
        ((*POINTS[:3], (363.15, 0.007)), "E006"),
        ((*POINTS[:3], (380.0, -0.001)), "E003"),
        ((*POINTS[:3], (380.0, math.nan)), "E003"),
    ],
)
def test_what_is_no_table_is_refused(points, code):
    with pytest.raises(InputError) as caught:
        TabulatedViscosity(points)
    assert caught.value.code == code


def test_temperatures_without_a_viscosity_are_refused():
    for kelvin in (0.0, -5.0, math.nan, 1.0):
        with pytest.raises(InputError):
            TabulatedViscosity(POINTS)(kelvin)


def test_it_is_a_value():
    law = TabulatedViscosity(POINTS)
    law(300.0)
    assert pickle.loads(pickle.dumps(law)) == law
    assert hash(law) == hash(TabulatedViscosity(POINTS))
