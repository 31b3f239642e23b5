"""Every kind that ships is a class in Python, and the same case as in YAML."""

from __future__ import annotations

import pickle

import pytest
from pydantic import Field

import babbitt as bb
from babbitt import case as case_language
from babbitt.api.bearings import PUBLIC, public_case
from babbitt.case import KINDS, case_hash, kinds, template
from babbitt.solving import solve

NAMES = {
    "journal": "JournalBearing",
    "machine": "Machine",
    "shaft": "Shaft",
    "overhung_coupling": "OverhungCoupling",
    "screw_heel": "Footstep",
    "hydrostatic_pad": "HydrostaticPad",
    "hydrostatic_thrust_ring": "ThrustRing",
    "hydrostatic_journal": "HydrostaticJournal",
    "jacking_pocket": "JackingPocket",
    "thrust": "ThrustBearing",
    "thrust_line": "ThrustLine",
    "tilting_pad_journal": "TiltingPadBearing",
}


@pytest.fixture(params=NAMES)
def kind(request):
    return request.param


def test_every_kind_that_ships_has_a_class():
    assert {*NAMES} == {*kinds()}
    assert {*PUBLIC} == {*KINDS.values()}


def test_a_case_of_python_is_the_case_of_yaml(kind):
    written = case_language.parse_case(template(kind))
    read = bb.parse_case(template(kind))
    made = getattr(bb, NAMES[kind])(**read.given)
    assert type(read) is type(made) is getattr(bb, NAMES[kind])
    assert read == made == written
    assert case_hash(read) == case_hash(made) == case_hash(written)
    assert case_hash(case_language.parse_case(made.to_yaml())) == case_hash(written)


def test_an_object_is_pickled_hashed_and_shown(kind):
    read = bb.parse_case(template(kind))
    copied = pickle.loads(pickle.dumps(read))
    assert copied == read
    assert hash(copied) == hash(read)
    assert len(repr(read).splitlines()) < 25
    assert {"solve", "sweep", "replace", "missing"} <= {*dir(read)}


def test_an_empty_object_says_what_is_missing(kind):
    empty = getattr(bb, NAMES[kind])()
    assert empty.missing
    with pytest.raises(bb.CaseError):
        empty.to_yaml()
    with pytest.raises(TypeError):
        getattr(bb, NAMES[kind])("100 mm")


@pytest.mark.parametrize("kind", ["journal", "hydrostatic_pad", "screw_heel", "jacking_pocket"], indirect=True)
def test_the_result_is_that_of_the_file(kind):
    case = bb.parse_case(template(kind))
    made = getattr(bb, NAMES[kind])(**case.given)
    ours = made.solve()
    results = getattr(ours, "results", None) or (ours,)
    for one, other in zip(results, solve(case_language.parse_case(template(kind))).results, strict=True):
        assert {**one.values, "wall_time": 0.0} == {**other.values, "wall_time": 0.0}


def test_a_machine_takes_bearings_as_objects():
    supply, materials = {"temperature": "50 degC", "pressure": "0.1 MPa"}, {"bearing": "C10", "journal": "C45"}
    parts = {"lubricant": "ISO VG 46", "supply": supply, "materials": materials}
    bearing = bb.JournalBearing(
        diameter="100 mm", width="50 mm", clearance="H7/e8", span="360 deg", load="10 kN", speed="1500 rpm"
    )
    gear = bb.Machine(bearings=[bearing, bearing.replace(name="Pinion")], **parts)
    assert gear.missing == ()
    assert [one.name for one in gear.bearings] == ["Bearing 1", "Pinion"]
    assert bearing.missing == ("lubricant", "supply", "materials")
    assert gear.replace(bearings=[bearing]).bearings == gear.bearings[:1]
    hotter = gear.replace({"bearings.1.load": 12e3})
    assert [one.load for one in hotter.bearings] == [10e3, 12e3]


@pytest.mark.parametrize("made", [bb.parse_case, lambda text: bb.Machine(**bb.parse_case(text).given)])
def test_a_bearing_of_a_machine_is_solved_by_itself_as_in_it(made):
    gear = made(template("machine"))
    results = bb.solve(gear)
    assert {type(one) for one in gear.bearings} == {bb.JournalBearing}
    for bearing in gear.bearings:
        assert bearing.missing == ()
        alone = tuple(bb.solve(bearing))
        assert alone == tuple(one for one in results if one.name.bearing == bearing.name)
        assert bb.parse_case(bearing.to_yaml()) == bearing
    warmer = gear.bearings[0].replace({"supply.temperature": "60 degC"})
    assert warmer.solve().minimum_film_thickness < results["Pinion"].minimum_film_thickness


def test_a_bearing_keeps_what_differs_from_its_machine():
    shared = {"supply": {"temperature": "50 degC", "pressure": "0.1 MPa"}, "clearance_cases": "all"}
    gear = bb.Machine(
        bearings=[{"diameter": "1 m", "method": "film", "supply": {"flow": "3 L/min"}}, {}],
        **shared,
        assumptions=["a"],
    )
    first, second = gear.bearings
    assert (first.supply.temperature, first.supply.pressure, first.supply.flow) == (323.15, None, 5e-5)
    assert second.given["supply"] == shared["supply"]
    assert (second.clearance_cases, second.assumptions) == ("all", ("a",))
    assert "diameter" in second.missing
    assert "lubricant" in first.missing
    with pytest.raises(AttributeError, match="bearings is missing in this Machine"):
        _ = bb.Machine().bearings


def test_a_case_of_no_registered_kind_stays_as_it_is():
    class Other(case_language.CaseFile):
        kind: str = Field("other", description="Name of the kind.")

        def calculations(self):
            return ()

    case = Other()
    assert public_case(case) is case
