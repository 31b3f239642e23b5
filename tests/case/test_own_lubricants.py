"""Lubricants given in the case give the viscosities they were given by."""

import math

import pytest
from pydantic import TypeAdapter, ValidationError

from babbitt.case.parts.lubricant import LubricantInput

ADAPTER = TypeAdapter(LubricantInput)


def made(given):
    return ADAPTER.validate_python(given).lubricant()


def points(*pairs, of="dynamic_viscosity"):
    return [{"temperature": temperature, of: viscosity} for temperature, viscosity in pairs]


def test_by_name():
    assert made("iso vg46").name == made({"kind": "catalogue", "name": "VG 46"}).name == "ISO VG 46"


def test_catalogue_with_the_usual_heat_capacity():
    oil = made({"kind": "catalogue", "name": "ISO VG 46", "volumetric_heat_capacity": "1.8 MJ/(m3 K)"})
    assert oil.volumetric_heat_capacity(330.0) == 1.8e6
    assert not any("heat capacity" in said.lower() for said in oil.assumptions)


def test_two_points():
    for given in (
        {"nu40": "63.5 mm2/s", "nu100": "8 mm2/s"},
        {"points": points(("40 degC", "63.5 cSt"), ("100 degC", "8 cSt"), of="kinematic_viscosity")},
    ):
        oil = made({"kind": "two_points", "name": "mine", "density": "895 kg/m3", **given})
        assert oil.name == "mine"
        assert oil.kinematic_viscosity(313.15) == pytest.approx(63.5e-6)
        assert oil.kinematic_viscosity(323.15) == pytest.approx(39.80e-6, rel=1e-3)
        assert oil.density(288.15) == pytest.approx(895.0)


def test_two_points_by_the_full_law_for_thin_oils():
    thin = {"kind": "two_points", "nu40": "2.4 mm2/s", "nu100": "1 mm2/s"}
    full, short = made(thin | {"form": "astm_d341"}), made(thin)
    assert made(thin | {"form": "walther"}).kinematic_viscosity(423.15) == short.kinematic_viscosity(423.15)
    for oil in (full, short):
        assert oil.kinematic_viscosity(313.15) == pytest.approx(2.4e-6)
        assert oil.kinematic_viscosity(373.15) == pytest.approx(1.0e-6)
    # ASTM D341 above 2 mm2/s is Walther's law; below, its terms count
    assert abs(full.kinematic_viscosity(423.15) / short.kinematic_viscosity(423.15) - 1.0) > 0.02
    thick = {"kind": "two_points", "nu40": "46 mm2/s", "nu100": "6.8 mm2/s"}
    assert made(thick | {"form": "astm_d341"}).kinematic_viscosity(333.15) == pytest.approx(
        made(thick).kinematic_viscosity(333.15), rel=1e-6
    )


def test_viscosity_index_and_grade():
    oil = made({"kind": "viscosity_index", "nu40": "50 mm2/s", "viscosity_index": 90})
    assert oil.kinematic_viscosity(373.15) == pytest.approx(6.874e-6, rel=1e-3)
    grade = made({"kind": "iso_vg", "grade": 100})
    assert grade.name == "ISO VG 100"
    assert grade.kinematic_viscosity(313.15) == pytest.approx(100e-6)


def test_vogel_by_points_and_by_constants():
    pairs = (("20 degC", "100 mPa s"), ("50 degC", "25 mPa s"), ("90 degC", "8 mPa s"))
    oil = made({"kind": "vogel", "points": points(*pairs)})
    assert [oil.dynamic_viscosity(t) for t in (293.15, 323.15, 363.15)] == pytest.approx([0.1, 0.025, 0.008])
    constants = {"factor": "0.1 mPa s", "activation": "900 K", "pole": "-95 degC"}
    law = made({"kind": "vogel", **constants})
    assert law.dynamic_viscosity(323.15) == pytest.approx(1e-4 * math.exp(900.0 / 145.0))


def test_exponential_power_law_and_constant():
    oil = made({"kind": "exponential", "points": points(("40 degC", "40 mPa s"), ("60 degC", "20 mPa s"))})
    assert oil.dynamic_viscosity(323.15) == pytest.approx(math.sqrt(0.04 * 0.02))
    power = made({"kind": "power_law", "nu50": "30 mm2/s", "exponent": 2.0})
    assert power.kinematic_viscosity(373.15) == pytest.approx(7.5e-6)
    assert made({"kind": "constant", "dynamic_viscosity": "20 mPa s"}).dynamic_viscosity(400.0) == pytest.approx(
        0.02
    )
    thin = made({"kind": "constant", "kinematic_viscosity": "20 mm2/s", "density": 1000, "density_slope": 0})
    assert thin.kinematic_viscosity(350.0) == pytest.approx(20e-6)


def test_known_properties_are_not_assumed():
    known = {
        "density": 876,
        "density_slope": "-0.6 kg/(m3 K)",
        "heat_capacity": "2 kJ/(kg K)",
        "conductivity": 0.14,
    }
    oil = made({"kind": "two_points", "nu40": 46e-6, "nu100": 6.8e-6, "heat_capacity_slope": 4.0, **known})
    assert oil.assumptions == ()
    assert oil.density(298.15) == pytest.approx(870.0)
    assert oil.heat_capacity(333.15) == pytest.approx(2040.0)


TWO = points(("40 degC", "46 cSt"), ("100 degC", "6 cSt"), of="kinematic_viscosity")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"kind": "two_points", "nu40": "46 cSt", "nu100": "46 cSt"}, "not below nu40"),
        ({"kind": "two_points", "nu40": "46 cSt", "nu100": "6 cSt", "points": TWO}, "given together with points"),
        ({"kind": "two_points"}, "nu40 and nu100, or points"),
        ({"kind": "vogel", "factor": 1e-4}, "all its constants"),
        ({"kind": "vogel"}, "none of points, factor"),
        ({"kind": "constant"}, "none of dynamic_viscosity"),
        ({"kind": "constant", "dynamic_viscosity": 0.02, "density_slope": -0.6}, "without density"),
        ({"kind": "mystery"}, "catalogue, iso_vg, viscosity_index"),
        (46, "a mapping with kind"),
    ],
)
def test_what_makes_no_oil(given, words):
    with pytest.raises(ValidationError) as caught:
        ADAPTER.validate_python(given)
    if isinstance(given, dict) and given["kind"] != "mystery":
        told = [error["ctx"] for error in caught.value.errors()]
        assert any(words in f"{context['says']} {context['allowed']}" for context in told), told
