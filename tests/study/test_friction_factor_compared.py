"""A factor on friction in a comparison: methods that know it have it, the others say that they leave it out."""

import pytest

from babbitt import parse_case
from babbitt.case import CaseError
from babbitt.kinds.journal.case.build import iso7902_cases, long_films_of
from babbitt.kinds.journal.compare.thermal_variants import left_out_of_thermal_variants, thermal_variants
from babbitt.kinds.journal.iso7902 import DesignCase, check
from babbitt.study.comparison import compare_methods

BEARING = """
kind: journal
name: Factor
diameter: 120 mm
width: 60 mm
clearance: {kind: fit, bore: H7, journal: e7}
span: 180 deg
supply_element: {kind: pocket, width: 42 mm, place: both_sides}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing_metal: SnSb8Cu4, bearing: EN-GJL-250, journal: C45}
load: 12 kN
speed: 2000 rpm
"""
SAID = "without the factor 1.25 on friction, which ISO 7902 and films of one temperature know"


def test_thermal_films_are_compared_without_the_factor_and_say_so():
    case = parse_case(BEARING + "friction: {factor: 1.25}\n")
    assert left_out_of_thermal_variants(case, case) == ""
    (films,) = thermal_variants(case, case)
    own = [one for one in films if one.case.heat is not None]
    assert [one.label for one in own] == ["adiabatic film", "full thermal film"]
    for one in films:
        known = one.case.heat is None
        assert one.case.friction_factor == (1.25 if known else 1.0)
        assert (SAID in one.remark) is not known
        assert any("multiplied by 1.25" in said for said in one.case.assumptions) is known


def test_the_other_methods_compute_as_with_and_without_it():
    plain, case = parse_case(BEARING), parse_case(BEARING + "friction: {factor: 1.25}\n")
    standard, same = (check(iso7902_cases(one, one)[0]) for one in (case, plain))
    assert standard.friction_power > 1.1 * same.friction_power  # the hotter film takes back a part
    assert long_films_of(case, case)[0] == long_films_of(plain, plain)[0]


def test_the_other_models_of_friction_have_the_factor_too():
    case = parse_case(BEARING + "friction: {factor: 1.5}\n")
    (found,) = compare_methods(case)
    standard = [one.solution.problem for one in found.variants if isinstance(one.solution.problem, DesignCase)]
    assert len(standard) == 3
    assert [design.friction_factor for design in standard] == [1.5] * 3
    powers = {one.label: one.result.friction_power for one in found.variants}
    assert powers["film on the arc"] > 0.6 * powers["ISO 7902"]  # 812 of 1638 W without the factor


@pytest.mark.parametrize("width", ["120 mm", "11 mm"])
def test_a_width_beyond_the_closed_forms_leaves_them_out_alone(width):
    text = BEARING.replace("span: 180 deg", "span: 360 deg").replace("width: 60 mm", f"width: {width}")
    text = text.replace("diameter: 120 mm", "diameter: 100 mm").replace("12 kN", "0.5 kN")
    text = text.replace("{kind: pocket, width: 42 mm, place: both_sides}", "{kind: groove_180, width: 2 mm}")
    case = parse_case(text)
    (found,) = compare_methods(case)
    assert found.asked.label == "ISO 7902"
    assert found.asked.result.outcome.solved
    assert "closed forms" not in [one.label for one in found.variants]
    assert "closed forms are left out: they hold for B/D 0.125 to 1" in found.left_out
    with pytest.raises(CaseError, match="closed forms of DIN 31652 hold"):
        parse_case(text + "characteristics: closed_form\n")
