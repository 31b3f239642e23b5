"""Viscosity laws against published tables, their closed forms and their limits."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import (
    AstmD341,
    ConstantViscosity,
    Exponential,
    PowerLaw,
    ViscosityKind,
    Vogel,
    Walther,
)

CELSIUS = 273.15


def at(celsius, mm2_per_s):
    return celsius + CELSIUS, mm2_per_s * 1e-6


TEXT_OIL = Walther.through(at(40, 63.5), at(100, 8.0))
STO_OIL = Walther.through(at(40, 50.0), at(100, 6.874))
LAWS = [
    TEXT_OIL,
    Walther.through(at(40, 63.5), at(100, 8.0), additive=0.8),
    AstmD341.through(at(40, 2.4), at(100, 1.0)),
    Vogel(6e-5, 1000.0, 175.0),
    Exponential(0.05, 313.15, 0.03, (313.15, 353.15)),
    PowerLaw(30e-6, 2.2, ViscosityKind.KINEMATIC),
]

temperatures = st.floats(278.0, 420.0)
viscosities_40 = st.floats(4.0, 2000.0)
thinning = st.floats(0.03, 0.6)


@pytest.mark.parametrize(
    ("oil", "celsius", "printed"),
    [
        (TEXT_OIL, 50, "39.80"),
        (TEXT_OIL, 60, "26.50"),
        (TEXT_OIL, 63, "23.70"),
        (TEXT_OIL, 80, "13.56"),
        (STO_OIL, 50, "31.97"),
        (STO_OIL, 60, "21.66"),
        (STO_OIL, 63, "19.46"),
        (STO_OIL, 70, "15.40"),
    ],
)
def test_walther_reproduces_the_marine_gear_study_to_the_digits_printed(oil, celsius, printed):
    assert f"{oil(celsius + CELSIUS) * 1e6:.2f}" == printed


def test_walther_with_additive_06_has_the_constants_of_the_ipm_10_study():
    oil = Walther.through(at(50, 10.5), at(100, 3.0), additive=0.6)
    assert oil.intercept == pytest.approx(11.021695, abs=5e-7)
    assert oil.slope == pytest.approx(4.384485, abs=5e-7)
    celsius = np.array([50, 70, 80, 90, 100, 110, 130.0])
    printed = [10.5, 5.7584, 4.5084, 3.6332, 3.0, 2.5289, 1.8908]
    assert_allclose(oil(celsius + CELSIUS) * 1e6, printed, atol=6e-5)


def test_walther_is_a_straight_line_in_its_own_paper():
    kelvin = np.linspace(280.0, 420.0, 29)
    for additive in (0.6, 0.7, 0.8):
        oil = Walther.through(at(40, 220.0), at(100, 18.7), additive=additive)
        ordinate = np.log10(np.log10(oil(kelvin) * 1e6 + additive))
        assert_allclose(np.diff(ordinate) / np.diff(np.log10(kelvin)), -oil.slope, rtol=1e-9)


def test_the_two_common_additives_agree_between_their_points_and_part_below_2_mm2_per_s():
    seven, eight = LAWS[0], LAWS[1]
    inside = np.linspace(40.0, 100.0, 61) + CELSIUS
    assert 1e-4 < np.max(np.abs(eight(inside) / seven(inside) - 1.0)) < 4e-3
    thin = [Walther.through(at(40, 2.4), at(100, 1.0), additive=a)(150 + CELSIUS) for a in (0.7, 0.8)]
    assert abs(thin[1] / thin[0] - 1.0) > 0.03


@given(viscosities_40, thinning, st.sampled_from([0.6, 0.7, 0.8]))
def test_walther_passes_through_its_points_in_either_order(nu40, ratio, additive):
    colder, warmer = at(40, nu40), at(100, max(nu40 * ratio, 1.1))
    for law in (
        Walther.through(colder, warmer, additive=additive),
        Walther.through(warmer, colder, additive=additive),
    ):
        assert law(colder[0]) == pytest.approx(colder[1], rel=1e-11)
        assert law(warmer[0]) == pytest.approx(warmer[1], rel=1e-11)


@given(st.floats(0.25, 2.0), st.floats(1.05, 50.0))
def test_astm_d341_passes_through_thin_points(nu100, factor):
    colder, warmer = at(20, nu100 * factor), at(100, nu100)
    law = AstmD341.through(colder, warmer)
    assert law(colder[0]) == pytest.approx(colder[1], rel=1e-11)
    assert law(warmer[0]) == pytest.approx(warmer[1], rel=1e-11)


def z_of_the_older_editions(nu):
    """Z with the six terms C to H of ASTM D341-77 to -93."""
    return (
        nu
        + 0.7
        + math.exp(-1.14883 - 2.65868 * nu)
        - math.exp(-0.0038138 - 12.5645 * nu)
        + math.exp(5.46491 - 37.6289 * nu)
        - math.exp(13.0458 - 74.6851 * nu)
        + math.exp(37.4619 - 192.643 * nu)
        - math.exp(80.4945 - 400.468 * nu)
    )


@pytest.mark.parametrize("celsius", [20, 60, 90, 120, 150, 180])
def test_astm_d341_agrees_with_the_terms_c_to_h_of_the_older_editions(celsius):
    law = AstmD341.through(at(20, 2.4), at(100, 0.6))
    nu = law(celsius + CELSIUS) * 1e6
    assert 0.25 < nu < 2.5
    z = 10 ** (10 ** (law.intercept - law.slope * math.log10(celsius + CELSIUS)))
    assert z_of_the_older_editions(nu) == pytest.approx(z, rel=5e-3)


@given(temperatures)
def test_astm_d341_is_walther_for_thick_oils(temperature):
    full = AstmD341.through(at(40, 320.0), at(100, 24.0))
    short = Walther.through(at(40, 320.0), at(100, 24.0))
    assert full(temperature) == pytest.approx(short(temperature), rel=1e-6)


@given(st.floats(1e-6, 1e-3), st.floats(300.0, 1500.0), st.floats(100.0, 200.0))
def test_vogel_is_recovered_from_three_of_its_points(factor, activation, pole):
    law = Vogel(factor, activation, pole)
    points = [(t, law(t)) for t in (353.15, 293.15, 313.15)]
    found = Vogel.through(*points)
    assert found.factor == pytest.approx(factor, rel=1e-6)
    assert found.activation == pytest.approx(activation, rel=1e-7)
    assert found.pole == pytest.approx(pole, rel=1e-8)


@pytest.mark.parametrize(
    ("celsius", "holds"),
    [((20, 30, 40), (15, 50)), ((40, 70, 100), (25, 130)), ((-10, 70, 140), (-20, 150))],
)
def test_vogel_holds_around_its_points(celsius, holds):
    pole = 175.0
    law = Vogel.through(*((t + 273.15, 6e-5 * math.exp(1000.0 / (t + 273.15 - pole))) for t in celsius))
    assert law.temperature_range == pytest.approx([t + 273.15 for t in holds])


@pytest.mark.parametrize("celsius", [(20, 30, 40), (40, 60, 80), (40, 70, 100), (20, 60, 100)])
def test_within_its_range_vogel_meets_an_oil_that_was_read_to_one_per_cent(celsius):
    """Viscosities of a real oil at three temperatures, the middle one read 1 % too high, as in a data sheet."""
    oil = Walther.through(at(40, 46.0), at(100, 6.8))
    for wrong in (0.99, 1.0, 1.01):
        points = [(t + 273.15, oil(t + 273.15) * (wrong if t == celsius[1] else 1.0)) for t in celsius]
        law = Vogel.through(*points)
        coldest, warmest = law.temperature_range
        for kelvin in np.linspace(points[0][0], warmest, 20):
            assert law(kelvin) == pytest.approx(oil(kelvin), rel=0.04)
        assert law(coldest) == pytest.approx(oil(coldest), rel=0.12)


def test_vogel_through_water_meets_the_iapws_viscosity_between_its_points():
    water = Vogel.through((280.0, 1433.7e-6), (320.0, 577.02e-6), (360.0, 326.10e-6))
    kelvin = np.array([290.0, 300.0, 310.0, 330.0, 340.0, 350.0, 370.0])
    iapws = np.array([1084.0, 853.84, 693.54, 489.49, 421.97, 368.77, 291.36]) * 1e-6
    assert_allclose(water(kelvin), iapws, rtol=5e-3)


def test_exponential_halves_every_ln_2_over_beta():
    law = Exponential(0.04, 313.15, 0.035, (303.15, 343.15))
    assert law(313.15) == 0.04
    assert law(313.15 + math.log(2.0) / 0.035) == pytest.approx(0.02, rel=1e-14)


def test_exponential_is_the_tangent_of_walther_when_its_points_close():
    nu = TEXT_OIL(333.15)
    tangent = Exponential.through(
        (333.145, TEXT_OIL(333.145)), (333.155, TEXT_OIL(333.155)), kind=ViscosityKind.KINEMATIC
    )
    # Walther differentiated: d ln(nu)/dT = -(B/T) z ln(z) / nu with z = nu + a.
    z = nu * 1e6 + 0.7
    slope = TEXT_OIL.slope / 333.15 * z * math.log(z) / (nu * 1e6)
    assert tangent.temperature_coefficient == pytest.approx(slope, rel=1e-6)


def test_power_law_falls_by_two_to_the_m_when_the_celsius_temperature_doubles():
    law = PowerLaw(30e-6, 2.2, ViscosityKind.KINEMATIC)
    assert law(323.15) == pytest.approx(30e-6, rel=1e-14)
    assert law(373.15) == pytest.approx(30e-6 / 2**2.2, rel=1e-12)


@given(st.floats(0.005, 0.5), thinning)
def test_power_law_and_exponential_pass_through_their_points(eta, ratio):
    colder, warmer = (313.15, eta), (343.15, eta * ratio)
    for law in (
        PowerLaw.through(warmer, colder, kind=ViscosityKind.DYNAMIC),
        Exponential.through(warmer, colder),
    ):
        assert law.kind is ViscosityKind.DYNAMIC
        assert law(colder[0]) == pytest.approx(colder[1], rel=1e-12)
        assert law(warmer[0]) == pytest.approx(warmer[1], rel=1e-12)


def test_exponential_holds_between_its_points_only():
    assert Exponential.through((343.15, 0.01), (313.15, 0.03)).temperature_range == (313.15, 343.15)


def test_constant_viscosity_is_constant_and_keeps_the_shape():
    law = ConstantViscosity.through((313.15, 0.02))
    assert law(250.0) == law(400.0) == 0.02
    assert_allclose(law(np.full((2, 3), 300.0)), np.full((2, 3), 0.02), rtol=0)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
@given(colder=temperatures, step=st.floats(0.01, 50.0))
def test_every_law_falls_with_temperature(law, colder, step):
    assert 0.0 < law(colder + step) < law(colder)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_an_array_gives_what_its_elements_give(law):
    kelvin = np.array([[290.0, 313.15], [340.5, 373.15]])
    array = law(kelvin)
    assert array.shape == kelvin.shape
    assert_allclose(array, [[law(float(t)) for t in row] for row in kelvin], rtol=1e-13)
    assert isinstance(law(320), float)
    assert isinstance(law(np.float64(320.0)), float)


@pytest.mark.parametrize("law", [*LAWS, ConstantViscosity(0.02)], ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("temperature", [0.0, -40.0, math.nan, math.inf])
def test_no_law_answers_an_impossible_temperature(law, temperature):
    for argument in (temperature, np.array([300.0, temperature])):
        with pytest.raises(InputError, match="has no value at") as caught:
            law(argument)
        assert caught.value.code == "E006"


@pytest.mark.parametrize(
    ("law", "temperature"),
    [
        (TEXT_OIL, 20.0),  # the double power overflows
        (Vogel(6e-5, 1000.0, 175.0), 175.0),
        (Vogel(6e-5, 1000.0, 175.0), 175.0001),
        (PowerLaw(30e-6, 2.2, ViscosityKind.KINEMATIC), 273.15),
    ],
)
def test_a_law_ends_with_a_message_where_its_formula_ends(law, temperature):
    for argument in (temperature, np.array([300.0, temperature])):
        with pytest.raises(InputError, match="kelvin"):
            law(argument)


@pytest.mark.parametrize(
    ("build", "code", "says"),
    [
        (lambda: Walther.through(at(40, 8.0), at(100, 63.5)), "E006", "must fall"),
        (lambda: Walther.through(at(40, 8.0), at(100, 8.0)), "E006", "must fall"),
        (lambda: Walther.through(at(40, 8.0), at(40, 4.0)), "E006", "differ in temperature"),
        (lambda: Walther.through(at(40, 8.0), at(100, 0.2)), "E006", "46e-6"),
        (lambda: Walther.through(at(40, -8.0), at(100, 4.0)), "E003", "viscosity"),
        (lambda: Walther.through(at(40, math.nan), at(100, 4.0)), "E003", "viscosity"),
        (lambda: Walther.through(at(-300, 9.0), at(100, 4.0)), "E003", "temperature"),
        (lambda: Walther(9.0, 3.5, additive=1.2), "E003", "additive"),
        (lambda: Walther(9.0, -3.5), "E003", "slope"),
        (lambda: Walther(9.0, 3.5, temperature_range=(400.0, 300.0)), "E003", "temperature_range"),
        (lambda: AstmD341.through(at(40, 1.0), at(100, 2.0)), "E006", "must fall"),
        (lambda: AstmD341(math.inf, 3.5), "E003", "intercept"),
        (lambda: Vogel(0.0, 1000.0, 175.0), "E003", "factor"),
        (lambda: Vogel.through((300.0, 0.1), (320.0, 0.2), (340.0, 0.05)), "E006", "must fall"),
        (lambda: Vogel.through((300.0, 0.4), (320.0, 0.2), (340.0, 0.1)), "E006", "Exponential"),
        (lambda: Vogel.through((300.0, 0.4), (320.0, 0.3), (340.0, 0.1)), "E006", "above 1"),
        (lambda: Exponential.through((300.0, 0.1), (320.0, 0.2)), "E006", "must fall"),
        (lambda: Exponential(0.1, 300.0, 0.0, (300.0, 320.0)), "E003", "temperature_coefficient"),
        (
            lambda: PowerLaw.through(at(-5, 90.0), at(50, 30.0), kind=ViscosityKind.KINEMATIC),
            "E006",
            "above 0 °C",
        ),
        (lambda: PowerLaw(30e-6, math.nan, ViscosityKind.KINEMATIC), "E003", "exponent"),
        (lambda: ConstantViscosity(-0.1), "E003", "viscosity"),
    ],
)
def test_constants_and_points_without_a_meaning_are_refused(build, code, says):
    with pytest.raises(InputError, match=says) as caught:
        build()
    assert caught.value.code == code
