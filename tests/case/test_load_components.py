"""A load by its components is the load of its size and direction, in every kind that has that direction."""

import math

import pytest
import yaml

import babbitt as bb
from babbitt.case import CaseError, case_from_dict, case_hash, template

SIZE, ANGLE = math.hypot(22e3, 35e3), math.atan2(-35e3, 22e3)
COMPONENTS = {"x": "22 kN", "y": "-35 kN"}
KINDS = ("journal", "tilting_pad_journal", "hydrostatic_journal")


def given(kind, **fields):
    base = yaml.safe_load(template(kind))
    base.pop("operating_points", None)
    return {name: value for name, value in (base | fields).items() if name != "load_angle" or name in fields}


def refusal(fields):
    with pytest.raises(CaseError) as caught:
        case_from_dict(fields)
    (problem,) = caught.value.problems
    return problem.field, problem.message


@pytest.mark.parametrize("kind", KINDS)
def test_components_are_size_and_direction(kind):
    by_components = case_from_dict(given(kind, load=COMPONENTS))
    assert (by_components.load, by_components.load_angle) == pytest.approx((SIZE, ANGLE), rel=1e-15)
    by_size = case_from_dict(given(kind, load=f"{SIZE} N", load_angle=f"{ANGLE} rad"))
    assert by_components == by_size
    assert case_hash(by_components) == case_hash(by_size)


@pytest.mark.parametrize("kind", KINDS)
def test_one_component_is_a_load_along_its_axis(kind):
    case = case_from_dict(given(kind, load={"x": "-30 kN"}))
    assert (case.load, case.load_angle) == pytest.approx((30e3, math.pi))


@pytest.mark.parametrize("kind", KINDS)
def test_another_direction_is_refused_and_the_same_is_not(kind):
    assert refusal(given(kind, load=COMPONENTS, load_angle="-90 deg"))[0] == "load_angle"
    assert case_from_dict(given(kind, load=COMPONENTS, load_angle=f"{ANGLE} rad")).load == pytest.approx(SIZE)


@pytest.mark.parametrize(
    ("load", "says"),
    [
        ({"x": "22 kN", "z": "3 kN"}, "z is no component of a load"),
        ({"x": "22 kN", "y": -35}, "y: -35 has no unit"),
        ({"x": "22 kN", "y": "35 mm"}, "y: '35 mm' is a length"),
        ({"x": "0.2 N", "y": "0.2 N"}, "too small"),
        ({}, "the load has no component"),
    ],
)
def test_what_is_no_load_is_refused_at_its_field(load, says):
    field, message = refusal(given("journal", load=load))
    assert field == "load"
    assert says in message


def test_python_takes_components_in_newtons():
    bearing = bb.parse_case(template("journal")).replace(load={"x": 22e3, "y": -35e3})
    assert (bearing.load, bearing.load_angle) == pytest.approx((SIZE, ANGLE))
    assert bearing.replace({"load.y": "-22 kN"}).load_angle == pytest.approx(-0.25 * math.pi)


def test_a_load_along_the_shaft_has_no_components():
    assert refusal(given("thrust", load=COMPONENTS))[0] == "load"


@pytest.mark.parametrize("kind", ["journal", "tilting_pad_journal"])
def test_an_operating_point_has_components_of_its_own(kind):
    points = [{"name": "ahead", "load": COMPONENTS}, {"name": "astern", "load": {"x": "-22 kN", "y": "-35 kN"}}]
    fields = given(kind, operating_points=points, load_angle="-90 deg")
    del fields["load"]
    if kind == "journal":
        fields["method"] = "film"
    ahead, astern = (one.problem for one in case_from_dict(fields).calculations())
    assert ahead.load_angle == pytest.approx(ANGLE)
    assert astern.load_angle == pytest.approx(-math.pi - ANGLE)
    assert ahead.duty.load == astern.duty.load == pytest.approx(SIZE)
