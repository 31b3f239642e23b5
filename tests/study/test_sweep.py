"""A sweep in Python goes through the case: all that follows from a field follows, and a gap stops nothing."""

from __future__ import annotations

import math

import numpy as np
import pytest

from babbitt.case import CaseError, case_from_dict, load_case, parse_case, template
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.solving import solve
from babbitt.study.sweep import sweep

TEXT = """\
kind: journal
name: Fan
diameter: 120 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5 permille}
supply_element: {kind: hole, diameter: 5 mm, place: opposite}
span: 360 deg
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing: C10, journal: 42CrMo4, bearing_metal: PbSb15SnAs}
surfaces: {kind: direct, roughness_bearing: 2 um, roughness_journal: 1 um, tilt_offset: 2 um, waviness: 1 um}
load: 12 kN
speed: 2000 rpm
"""


def test_each_point_is_the_case_that_says_so():
    found = sweep(parse_case(TEXT), "load", [6e3, 24e3])
    alone = solve(parse_case(TEXT.replace("load: 12 kN", "load: 24 kN"))).results[0]
    assert found["minimum_film_thickness"][1] == alone.minimum_film_thickness
    assert found.outcomes[1] is alone.outcome
    assert found["minimum_film_thickness"][0] > found["minimum_film_thickness"][1]


def test_a_specific_load_takes_the_place_of_the_load():
    loads = sweep(parse_case(TEXT), "specific_load", [1e6, 2e6])["load"]
    assert loads == pytest.approx([1e6 * 0.12 * 0.06, 2e6 * 0.12 * 0.06])


def test_a_load_given_by_pressure_follows_the_width():
    by_pressure = parse_case(TEXT.replace("load: 12 kN", "specific_load: 1.5 MPa"))
    loads = sweep(by_pressure, "width", [0.05, 0.06])["load"]
    assert loads == pytest.approx([1.5e6 * 0.12 * 0.05, 1.5e6 * 0.12 * 0.06])


def test_the_recommended_clearance_is_held_against_the_clearance_of_the_point():
    """C114 and the cooling surface are derived by the case, and follow."""
    case = parse_case(TEXT)
    wide = parse_case(TEXT.replace("1.5 permille", "2.5 permille"))
    found = sweep(case, "clearance.mean", [1.5e-3, 2.5e-3])
    answer = solve(wide).results[0]
    for name, value in (answer.values | {"wall_time": found["wall_time"][1]}).items():
        assert found[name][1] == pytest.approx(value, rel=1e-12, nan_ok=True), name


def test_spans_are_varied_in_radians():
    found = sweep(parse_case(TEXT), "span", [math.radians(150.0), math.radians(180.0)])
    assert found["angular_span"] == pytest.approx(np.radians([150.0, 180.0]))
    assert found.solved.all()


def test_factors_are_not_rounded():
    arc = TEXT.replace("speed: 2000 rpm", "speed: 2000 rpm\nfriction: {factor: 1}")
    friction = sweep(parse_case(arc), "friction.factor", [1.0, 1.2, 1.4])["friction_torque"]
    assert np.all(np.diff(friction) > 0)


def test_a_refused_point_is_a_gap_with_its_reason():
    found = sweep(parse_case(TEXT), "width", [0.06, -0.06, 0.08])
    assert found.solved.tolist() == [True, False, True]
    assert found.outcomes[1] is None
    assert list(found.refused) == [1]
    assert "width" in found.refused[1]
    assert math.isnan(found["minimum_film_thickness"][1])


def test_what_cannot_be_solved_is_a_gap_with_its_outcome():
    found = sweep(parse_case(TEXT), "load", [12e3, 5e6])
    assert found.outcomes[1] is Outcome.OVERLOADED
    assert not found.refused


def test_nothing_usable_is_an_error():
    with pytest.raises(CaseError, match="did you mean 'load'"):
        sweep(parse_case(TEXT), "laod", [1e3])
    with pytest.raises(InputError, match="names no field"):
        sweep(parse_case(TEXT), "load.", [1e3])


def test_one_of_several_results_is_named():
    points = "operating_points:\n  - {name: slow, speed: 500 rpm}\n  - {name: fast, speed: 2000 rpm}\n"
    case = parse_case(TEXT + points)
    with pytest.raises(InputError, match=r"name one of them: .*slow.*fast"):
        sweep(case, "load", [6e3, 12e3])
    names = [result.name for result in solve(case).results]
    assert sweep(case, "load", [6e3], names[1])["angular_speed"] == pytest.approx(2000 * math.pi / 30)
    with pytest.raises(InputError, match="no result 'middle'; there are"):
        sweep(case, "load", [6e3], "middle")


def test_files_that_a_case_names_are_found_from_its_folder(tmp_path):
    (tmp_path / "journal.yaml").write_text(template("journal"))
    assert sweep(load_case(tmp_path / "journal.yaml"), "load", [5e3]).solved.all()
    assert sweep(case_from_dict({"kind": "journal"} | _plain()), "load", [5e3]).solved.all()


def _plain():
    import yaml

    return yaml.safe_load(TEXT)


def test_only_a_case_as_it_was_read_can_be_varied():
    case = parse_case(TEXT)
    with pytest.raises(TypeError, match="a case, not DesignCase"):
        sweep(case.problems()[0], "load", [5e3])
    with pytest.raises(InputError, match="changed after it was read"):
        sweep(case.model_copy(update={"load": 5e3}), "width", [0.06])
