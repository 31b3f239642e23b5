"""Files in the words of version 0.1 say what they said: same case, hash and numbers; messages name those words."""

import copy
import re

import pytest
import yaml

from babbitt.case import CaseError, case_from_dict, case_hash, parse_case, template
from babbitt.case.variation import variation_of
from babbitt.solving import solve

OIL_OF_A_PAD = {"lubricant": "ISO VG 46", "supply_temperature": "40 degC", "film_temperature": "45 degC"}

WORDS = {
    "hydrostatic_pad": {
        "oil": (None, OIL_OF_A_PAD),
        "lubricant": ("ISO VG 46", None),
        "film_temperature": ("45 degC", None),
        "supply": ({"pressure": "5 MPa", "temperature": "40 degC"}, {"pressure": "5 MPa"}),
        "limits": ({"minimum_film_thickness": "20 um"}, None),
        "least_gap": (None, "20 um"),
    },
    "hydrostatic_thrust_ring": {
        "limits": ({"minimum_film_thickness": "20 um"}, None),
        "least_gap": (None, "20 um"),
    },
    "hydrostatic_journal": {
        "clearance": ({"kind": "radial", "mean": "50 um"}, None),
        "radial_clearance": (None, "50 um"),
        "limits": ({"minimum_film_thickness": "15 um"}, None),
        "least_gap": (None, "15 um"),
    },
    "jacking_pocket": {
        "clearance": ({"kind": "radial", "mean": "150 um"}, None),
        "radial_clearance": (None, "150 um"),
    },
    "thrust": {
        "load": ("500 kN", None),
        "thrust": (None, "500 kN"),
        "lubricant": ("ISO VG 100", None),
        "supply": ({"temperature": "45 degC"}, None),
        "oil": (
            {"kind": "heat_balance", "carry_over": 0.7},
            {
                "kind": "heat_balance",
                "lubricant": "ISO VG 100",
                "supply_temperature": "45 degC",
                "carry_over": 0.7,
            },
        ),
        "pads.inner_diameter": ("380 mm", None),
        "pads.inner_radius": (None, "190 mm"),
        "pads.outer_diameter": ("750 mm", None),
        "pads.outer_radius": (None, "375 mm"),
        "limits": ({"minimum_film_thickness": "12 um", "temperature": "110 degC"}, None),
        "film_limit": (None, "12 um"),
        "temperature_limit": (None, "110 degC"),
    },
    "thrust_line": {
        "load": ("500 kN", None),
        "thrust": (None, "500 kN"),
        "lubricant": ("ISO VG 100", None),
        "supply": ({"temperature": "45 degC"}, None),
        "oil": (None, {"kind": "heat_balance", "lubricant": "ISO VG 100", "supply_temperature": "45 degC"}),
        "shaft": (
            [{"length": "30 m", "diameter": "360 mm", "inner_diameter": "100 mm"}],
            [{"length": "30 m", "diameter": "360 mm", "bore": "100 mm"}],
        ),
        "limits": (
            {"minimum_film_thickness": "8 um", "axial_amplitude": "200 um"},
            {"axial_amplitude": "200 um"},
        ),
        "film_limit": (None, "8 um"),
    },
    "screw_heel": {
        "heel": (
            {
                "length": "35 mm",
                "diameter": "43.6 mm",
                "recess_diameter": "28 mm",
                "inner_diameter": "10 mm",
                "recess_depth": "5 mm",
            },
            {
                "length": "35 mm",
                "radius": "21.8 mm",
                "recess_radius": "14 mm",
                "bore_radius": "5 mm",
                "recess_depth": "5 mm",
            },
        ),
        "clearance": ({"kind": "radial", "mean": "20 um"}, "20 um"),
        "supply": ({"temperature": "25 degC", "pressure": "0.63 MPa"}, None),
        "supply_pressure": (None, "0.63 MPa"),
        "oil": (
            {"viscosity": "22.5 mPa s", "viscosity_exponent": "0.026 1/K"},
            {"viscosity": "22.5 mPa s", "viscosity_exponent": "0.026 1/K", "temperature": "25 degC"},
        ),
    },
}
"""Of each kind, fields of the template in the words of today and in former ones; None: not there."""

HASHES = {
    "hydrostatic_pad": "45bc34e88d075a8b65c7a6f075877fc99339700eb368c25fe8405f46f326fe4d",
    "hydrostatic_thrust_ring": "fca8c841539a088039398f47f8d8e55e5d25d63be1500147491eab9094505da0",
    "hydrostatic_journal": "f45ff76ed0ef614b5eb4e2fef56dd3066b1446667863080faac5400952dc9391",
    "jacking_pocket": "1609abe39eea781dd84c357f5b3e998984fb98dff81ffa7b58e2b54a43493fbb",
    "thrust": "8baac5851db1f0db5f0ae19c9c7f5c6c39a6fbed6b89141c70d1e3bf81f9574b",
    "thrust_line": "a4362b3a06f79a7686cb3d1b86a748ac0d23a535106f8e349e8f3d814f8cff23",
    "screw_heel": "2a5e41ddac256f04909e07132d7fd61ccd1c2484c8be1af5f6554b5bc96fac55",
}
"""Of the templates as they were in former words: hashes last."""


def given(kind, former):
    """The template of a kind with its fields in the words of today, or in former ones."""
    made = copy.deepcopy(yaml.safe_load(template(kind)))
    for path, ways in WORDS[kind].items():
        *above, last = path.split(".")
        place = made
        for step in above:
            place = place[step]
        place.pop(last, None)
        if ways[former] is not None:
            place[last] = ways[former]
    return made


@pytest.mark.parametrize("kind", WORDS)
def test_both_words_are_one_case_with_one_hash(kind):
    today, former = (case_from_dict(given(kind, one)) for one in (False, True))
    assert given(kind, True) != given(kind, False)
    assert today == former
    assert case_hash(today) == case_hash(former)


@pytest.mark.parametrize("kind", HASHES)
def test_hashes_outlast_the_words(kind):
    assert case_hash(parse_case(template(kind))) == HASHES[kind]


@pytest.mark.slow
@pytest.mark.parametrize("kind", WORDS)
def test_both_words_give_the_same_numbers_to_the_last_bit(kind):
    def numbers(former):
        results = solve(case_from_dict(given(kind, former))).results
        return [{name: one for name, one in result.values.items() if name != "wall_time"} for result in results]

    assert repr(numbers(True)) == repr(numbers(False))


@pytest.mark.parametrize("kind", WORDS)
def test_a_fault_is_told_at_the_word_and_line_of_the_file(kind):
    made = given(kind, True)
    former = [path for path, (_, old) in WORDS[kind].items() if isinstance(old, str)]
    for path in former or ["oil.supply_temperature", "shaft.0.bore"]:
        wrong = copy.deepcopy(made)
        place = wrong
        *above, last = (int(one) if one.isdecimal() else one for one in path.split("."))
        for step in above:
            place = place[step]
        place[last] = "3 weeks"
        text = yaml.safe_dump(wrong, sort_keys=False)
        with pytest.raises(CaseError) as refused:
            parse_case(text)
        (problem,) = refused.value.problems
        assert re.sub(r"\[(\d+)\]", r".\1", problem.field) == path
        assert "3 weeks" in text.splitlines()[problem.line - 1]


@pytest.mark.parametrize(
    ("kind", "former", "today", "value"),
    [
        ("thrust", "thrust", "load", "400 kN"),
        ("thrust", "oil.supply_temperature", "supply.temperature", "50 degC"),
        ("hydrostatic_journal", "radial_clearance", "clearance.mean", "40 um"),
        ("hydrostatic_pad", "least_gap", "limits.minimum_film_thickness", "25 um"),
        ("thrust_line", "shaft.0.bore", "shaft.0.inner_diameter", "50 mm"),
        ("screw_heel", "supply_pressure", "supply.pressure", "0.7 MPa"),
    ],
)
@pytest.mark.parametrize("words", [True, False], ids=["file in former words", "file in those of today"])
def test_a_sweep_takes_paths_in_both_words(kind, former, today, value, words):
    case = case_from_dict(given(kind, words))
    old, new = (variation_of(case, path) for path in (former, today))
    assert old.present == new.present is not None
    assert old.case(value) == new.case(value) != case


def test_a_former_word_of_another_size_is_scaled_in_a_sweep():
    case = case_from_dict(given("thrust", False))
    radius = variation_of(case, "pads.inner_radius")
    assert radius.present == "190.0 mm"
    assert radius.case("180 mm") == variation_of(case, "pads.inner_diameter").case("360 mm")


@pytest.mark.parametrize(
    ("kind", "beside", "said"),
    [
        ("thrust", {"thrust": "500 kN"}, ("thrust", "load")),
        ("thrust", {"oil": {"kind": "heat_balance", "lubricant": "ISO VG 46"}}, ("oil.lubricant", "lubricant")),
        ("hydrostatic_journal", {"radial_clearance": "50 um"}, ("radial_clearance", "clearance")),
        ("screw_heel", {"supply_pressure": "0.63 MPa"}, ("supply_pressure", "supply.pressure")),
    ],
)
def test_both_words_at_once_are_refused(kind, beside, said):
    with pytest.raises(CaseError) as refused:
        case_from_dict(given(kind, False) | beside)
    (problem,) = refused.value.problems
    assert problem.field == said[0]
    assert f"the former word for what {said[1]} says" in problem.says


@pytest.mark.parametrize("kind", ["journal", "hydrostatic_journal", "jacking_pocket"])
@pytest.mark.parametrize("bare", ["30 um", 3e-5, "30"])
def test_a_bare_clearance_is_refused_with_what_to_write(kind, bare):
    with pytest.raises(CaseError) as refused:
        case_from_dict(yaml.safe_load(template(kind)) | {"clearance": bare})
    (problem,) = refused.value.problems
    assert problem.field == "clearance"
    assert "does not say" in problem.says
    assert "{kind: radial, mean: 30 um}" in problem.hint


@pytest.mark.parametrize("kind", ["hydrostatic_journal", "jacking_pocket", "screw_heel"])
def test_a_clearance_may_be_told_in_all_ways(kind):
    """A radial clearance, twice that on the diameter, and that over the diameter are one bearing."""
    base = yaml.safe_load(template(kind))
    radial = case_from_dict(base).radial_clearance()
    diameter = case_from_dict(base).heel.diameter if kind == "screw_heel" else case_from_dict(base).diameter
    for kind_of, mean in (("diametral", 2.0 * radial), ("relative", 2.0 * radial / diameter)):
        unit = "m" if kind_of == "diametral" else ""
        other = case_from_dict(base | {"clearance": {"kind": kind_of, "mean": f"{mean!r} {unit}".strip()}})
        assert other.radial_clearance() == pytest.approx(radial, rel=1e-12)
    fit = case_from_dict(base | {"clearance": "H7/e8"})
    assert any("mean of its tolerances" in one for one in fit.problems()[0].assumptions)
