"""A shaft from its file to the loads of its bearings and the films in them."""

import math
from copy import deepcopy

import pytest
import yaml

from babbitt.case import CaseError, case_from_dict, template
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.kinds.journal.case.build import film_cases
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.shaft.case.machine import machine_of
from babbitt.kinds.shaft.overhung_coupling import MeshForce, OverhungCoupling, bearing_loads
from babbitt.solving import solve
from babbitt.study.comparison import compare_methods

TEMPLATE = yaml.safe_load(template("shaft"))

# Table 3 of the published gearbox study, as tests/shaft/test_overhung_coupling.py has it.
MESH, ANGLE = 815e3, math.radians(22.4)
OUTPUT_WHEEL = {
    "kind": "shaft",
    "name": "Output wheel",
    "speed": "239 rpm",
    "forces": [
        {
            "name": "Mesh",
            "station": "560 mm",
            "x": f"{MESH * math.sin(ANGLE)} N",
            "y": f"{-MESH * math.cos(ANGLE)} N",
        }
    ],
    "masses": [{"name": "Gear and shaft", "station": "560 mm", "mass": "7.109 t"}],
    "couplings": [{"name": "Coupling", "station": "1900.5 mm", "mass": "775 kg"}],
    "bearings": [
        {"kind": "radial", "name": "Bearing 1", "station": "0 mm"},
        {"kind": "radial", "name": "Bearing 2", "station": "1120 mm"},
    ],
}


def changed(**fields):
    return deepcopy(TEMPLATE) | fields


def shaft_result(given):
    return solve(case_from_dict(given)).results[0]


def loads(given):
    return shaft_result(given).arrays["support_load"][0]


def refusals(given):
    with pytest.raises(CaseError) as caught:
        case_from_dict(given)
    return [(problem.field, problem.says) for problem in caught.value.problems]


def test_the_published_load_share_of_the_reverse_gear():
    """435 kN far from the coupling and 452 kN beside it, with the mesh force downward."""
    assert loads(OUTPUT_WHEEL) == pytest.approx([434.98e3, 452.02e3], abs=10.0)


def test_an_overhung_coupling_is_a_shaft():
    former = bearing_loads(
        OverhungCoupling(815e3, math.radians(22.4), MeshForce.DOWNWARD, 1.12, 7109.0, 1550.0, 0.513, 1.07)
    )
    assert loads(OUTPUT_WHEEL) == pytest.approx([former.reaction_1, former.reaction_2], rel=1e-12)


def test_the_load_of_the_shaft_reaches_the_journal_bearing():
    case = case_from_dict(TEMPLATE)
    of_shaft, of_journal = solve(case).results
    assert (of_shaft.kind, of_journal.kind) == ("shaft", "journal")
    assert of_journal.values["load"] == pytest.approx(of_shaft.arrays["support_load"][0][1], rel=1e-12)
    journal = case.calculations()[1].problem
    assert ("Load and speed", "of the shaft Intermediate shaft at 400 rpm") in journal.given
    assert any("counts in the limit of the film thickness alone" in said for said in journal.assumptions)


def test_a_film_feels_load_direction_speed_and_slope_of_the_shaft():
    given = changed(speed="-400 rpm")
    given["bearings"][1]["method"] = "film"
    case = case_from_dict(given)
    film = case.calculations()[1].problem
    arrays = shaft_result(given).arrays
    assert isinstance(film, FilmCase)
    assert film.load_angle == pytest.approx(arrays["support_load_angle"][0][1], rel=1e-12)
    assert film.journal_speed == pytest.approx(-400.0 * math.pi / 30.0)
    slope = [arrays[f"support_slope_{axis}"][0][1] for axis in "xy"]
    assert film.bearing.misalignment == pytest.approx(slope, rel=1e-12)
    assert math.hypot(*slope) > 0.05e-3
    given["bearings"][1]["misalignment"] = {"x": "0.1 mrad"}
    crooked = case_from_dict(given).calculations()[1].problem
    assert crooked.bearing.misalignment == pytest.approx([slope[0] + 1e-4, slope[1]], rel=1e-12)


def on_slender_shaft(**bearing):
    given = changed(shaft=[{"length": "340 mm", "diameter": "60 mm"}])
    given["bearings"][1] |= bearing
    return given


ROUGH = {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"}


def test_the_slope_of_the_shaft_counts_in_the_limit_of_the_standard():
    """Slope times half the width at an edge, half of the offset of the axis (B_y) of ISO 7902-3."""
    of_shaft, journal = solve(case_from_dict(on_slender_shaft(surfaces=ROUGH))).results
    slope = math.hypot(*(of_shaft.arrays[f"support_slope_{axis}"][0][1] for axis in "xy"))
    assert journal.values["geometric_film_limit"] == pytest.approx(3e-6 + slope * 25e-3, rel=1e-9)
    assert [check.ok for check in journal.checks if check.code == "C102"] == [False]
    assert journal.verdict is Verdict.FAIL
    (touching,) = (one for one in journal.warnings if one.code == "W173")
    assert touching.variant == "touches"


def test_without_roughness_the_slope_alone_can_miss_the_limit_and_never_keep_it():
    journal = solve(case_from_dict(on_slender_shaft())).results[1]
    assert journal.verdict is Verdict.FAIL
    stiff = solve(case_from_dict(TEMPLATE)).results[1]
    assert "C102" not in {check.code for check in stiff.checks}
    assert [one.variant for one in stiff.not_checked if one.code == "C102"] == ["slope_alone"]


def test_a_slope_that_takes_much_of_the_film_questions_the_standard():
    """7.9 um by parallel axes; by the film with its slope, 5.3 um."""
    journal = solve(case_from_dict(TEMPLATE)).results[1]
    assert journal.verdict is Verdict.REMARKS
    assert any(one.code == "W173" and one.variant == "misses" for one in journal.warnings)
    stiff = changed(shaft=[{"length": "340 mm", "diameter": "160 mm"}])
    straight = solve(case_from_dict(stiff)).results[1]
    assert {one.code for one in straight.warnings} & {"W159", "W173"} == {"W159"}


def test_a_shaft_is_compared_by_the_methods_of_its_bearings():
    """The film that stands beside the standard has the slope of the shaft."""
    case = case_from_dict(TEMPLATE)
    machine = machine_of(case, case.answer)
    (film,) = film_cases(machine.bearings[0], machine)
    arrays = shaft_result(TEMPLATE).arrays
    slope = [arrays[f"support_slope_{axis}"][0][1] for axis in "xy"]
    assert film.bearing.misalignment == pytest.approx(slope, rel=1e-12)
    with pytest.raises(InputError, match="no bearing of kind journal"):
        compare_methods(case_from_dict(OUTPUT_WHEEL))


def test_the_balance_of_torques_is_left_to_one_part():
    """30 kW at 400 rpm come in and go out: 716.2 N m between wheel and pinion."""
    found = shaft_result(TEMPLATE)
    assert found.values["largest_torque"] == pytest.approx(30e3 / (400.0 * math.pi / 30.0), rel=1e-12)
    given = changed()
    given["gears"][1] |= {"power": "15 kW"}
    given["couplings"] = [{"name": "Coupling", "station": "340 mm", "mass": "0 kg"}]
    halved = shaft_result(given)
    assert halved.values["largest_torque"] == pytest.approx(found.values["largest_torque"], rel=1e-12)
    # the thrust of the pinion alone is halved
    of_wheel = -2.0 * 716.1972 / 0.3 * math.tan(math.radians(12.0))
    of_pinion = found.values["axial_load"] - of_wheel
    assert halved.values["axial_load"] == pytest.approx(of_wheel + 0.5 * of_pinion, rel=1e-5)


def test_both_senses_of_rotation_push_the_other_way():
    ahead, astern = shaft_result(TEMPLATE), shaft_result(changed(speed="-400 rpm"))
    assert astern.values["axial_load"] == pytest.approx(-ahead.values["axial_load"], rel=1e-12)
    assert astern.arrays["support_load"][0] != pytest.approx(ahead.arrays["support_load"][0], rel=0.01)


def test_teeth_and_module_give_the_pitch_diameter():
    given = changed()
    del given["gears"][0]["pitch_diameter"]
    given["gears"][0] |= {"teeth": 49, "normal_module": "6 mm"}
    assert case_from_dict(given).gears[0].diameter == pytest.approx(49 * 6e-3 / math.cos(math.radians(12.0)))


def test_a_shaft_without_limits_has_no_verdict():
    assert shaft_result(OUTPUT_WHEEL).verdict is Verdict.NO_VERDICT
    assert {one.code for one in shaft_result(OUTPUT_WHEEL).not_checked} == {"C501", "C502", "C503"}


REFUSED = {
    "load of a bearing": ({"bearings": {1: {"load": "3 kN"}}}, "bearings[1 'Bearing B'].load", "the shaft gives"),
    "speed of a bearing": ({"bearings": {1: {"speed": "3 rpm"}}}, "bearings[1 'Bearing B'].speed", "its speed"),
    "thrust without bearing": ({"bearings": {0: {"kind": "radial"}}}, "bearings", "finds no bearing"),
    "one radial bearing": ({"bearings": {0: {"kind": "axial"}}}, "bearings", "carries load across the shaft"),
    "torques left over": ({"gears": {1: {"power": "10 kW"}}}, "gears[1 'Pinion'].torque", "do not balance"),
    "no torque at all": ({"gears": {0: {"power": None}}}, "gears[1 'Pinion'].torque", "neither torque nor power"),
    "role against balance": ({"gears": {1: {"role": "driven"}}}, "gears[1 'Pinion'].role", "a driver part"),
    "outside the shaft": ({"gears": {0: {"station": "900 mm"}}}, "gears[0 'Wheel'].station", "lies outside"),
    "no hand": ({"gears": {0: {"helix": None}}}, "gears[0 'Wheel'].helix", "is missing"),
    "same place": (
        {"bearings": {1: {"station": "10 mm"}}},
        "bearings[1 'Bearing B'].station",
        "stands there, too",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_shaft_that_cannot_be_is_refused_at_its_field(name):
    changes, path, says = REFUSED[name]
    given = changed()
    for group, entries in changes.items():
        for index, fields in entries.items():
            one = given[group][index] | fields
            given[group][index] = {key: value for key, value in one.items() if value is not None}
    assert any(at == path and says in said for at, said in refusals(given)), refusals(given)


def test_three_bearings_need_the_pieces_of_the_shaft():
    given = changed()
    del given["shaft"]
    given["bearings"].append({"kind": "radial", "name": "C", "station": "400 mm"})
    assert [path for path, _ in refusals(given)] == ["shaft"]


def test_what_the_loaded_bearing_cannot_be_is_told_at_the_bearing():
    given = changed(gears=[], masses=[{"name": "Disc", "station": "100 mm", "mass": "1 kg"}])
    given["bearings"][1] |= {"station": "340 mm", "diameter": "400 mm", "width": "300 mm"}
    ((path, said),) = refusals(given)
    assert path == "bearings[1 'Bearing B'].load"
    assert "is a specific load of" in said


def with_thrust_bearing(**fields):
    """The template with the thrust bearing of its own template at the end."""
    pads = {name: value for name, value in yaml.safe_load(template("thrust")).items() if name in THRUST_FIELDS}
    given = changed(start="-100 mm", **fields)
    given["shaft"].insert(0, {"length": "100 mm", "diameter": "80 mm"})
    given["bearings"][0]["kind"] = "radial"
    given["bearings"].append({"kind": "thrust", "name": "Thrust", "station": "-80 mm", "speed": "400 rpm"} | pads)
    return given


THRUST_FIELDS = ("pads", "lubricant", "supply", "oil")


def test_the_thrust_reaches_the_thrust_bearing():
    case = case_from_dict(with_thrust_bearing())
    problem = case.calculations()[-1].problem
    assert problem.kind == "thrust"
    assert problem.duty.thrust == pytest.approx(abs(shaft_result(TEMPLATE).values["axial_load"]), rel=1e-9)
    carried = case.calculations()[0].solve()[0].result.arrays["support_axial_load"][0]
    assert carried == pytest.approx([0.0, 0.0, shaft_result(TEMPLATE).values["axial_load"]])


def test_the_collar_turns_as_the_shaft():
    given = with_thrust_bearing()
    given["bearings"][2]["speed"] = "500 rpm"
    ((path, said),) = refusals(given)
    assert path == "bearings[2 'Thrust'].speed"
    assert "the shaft turns at 400 rpm" in said


def test_a_bearing_of_which_the_load_alone_is_computed_is_listed_as_not_checked():
    """The template has its thrust on a support without a film, beside two journal bearings with one."""
    own = changed()
    alone = [one["name"] for one in own["bearings"] if one["kind"] in ("radial", "axial", "radial_axial")]
    result = shaft_result(own)
    said = {one.code: one.message for one in result.not_checked}
    assert 0 < len(alone) < len(own["bearings"])
    assert said["C503"] == f"{', '.join(alone)}: the load alone is computed"
    assert any("rest on the stiffness of the bearings in the case" in one for one in result.assumptions)
