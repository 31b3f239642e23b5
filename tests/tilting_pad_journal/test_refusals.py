"""Every unusable input of a tilting-pad bearing is one message that names pad and field."""

import pytest
from pad_journals import pad_case

from babbitt.case import CaseError, case_from_dict
from babbitt.core.notices import InputError, Subject
from babbitt.core.result import Verdict
from babbitt.solving import refusal_of, solve

RADIAL = {"kind": "radial", "mean": "148 um"}
ANGLES = {"pads.number": None, "pads.first_pivot": None}
OFFSET = {"kind": "rigid", "fraction": 0.6}
POINT = {"kind": "point", "pivot_radius": "100 mm", "housing_radius": "102 mm"}
LINE = {
    "kind": "line",
    "pivot_radius": "70 mm",
    "housing_radius": "70.5 mm",
    "depth": "20 mm",
    "housing_depth": "20 mm",
}

GROWN = {
    "thermal": "full",
    "walls": {"pads": {}},
    "deformation": ["growth"],
    "reference_temperature": "20 degC",
    "materials.pads": {"thermal_expansion": "12e-6 1/K"},
}
"""Pads that grow."""

REFUSED = {
    "diameter of nothing": ({"diameter": "0 mm"}, "diameter", "1 mm to 3 m"),
    "no width": ({"pads.width": "-70 mm"}, "pads.width", "0.1 mm"),
    "no thickness": ({"pads.thickness": "0 mm"}, "pads.thickness", "0.1 mm"),
    "no clearance": ({"pads.clearance.mean": "0 um"}, "pads.clearance.mean", "0.05 um"),
    "no speed": ({"speed": "0 rpm"}, "speed", "0.1 rpm"),
    "speed left out": ({"speed": None}, "speed", "missing"),
    "no load": ({"load": None}, "", "exactly one of load, position"),
    "load of nothing": ({"load": "0 kN"}, "load", "1 N"),
    "load of no number": ({"load": 0}, "load", "as of a vertical shaft, has position"),
    "pressure of the supply": (
        {"feed": "leading_edge_groove", "supply.pressure": "0.1 MPa"},
        "supply.pressure",
        "groove_pressure",
    ),
    "load and position": ({"position": {"x": "0 um", "y": "-9 um"}}, "position", "together with load"),
    "no viscosity": (
        {"lubricant": {"kind": "constant", "name": "Oil", "dynamic_viscosity": "0 mPa s"}},
        "lubricant.dynamic_viscosity",
        "too small",
    ),
    "no density": (
        {
            "lubricant": {
                "kind": "constant",
                "name": "Oil",
                "dynamic_viscosity": "9 mPa s",
                "density": "-870 kg/m3",
            }
        },
        "lubricant.density",
        "too small",
    ),
    "preload of one": ({"pads.preload": 1.0}, "pads.preload", "-0.5 to 0.99"),
    "preload far below zero": ({"pads.preload": -0.6}, "pads.preload", "-0.5 to 0.99"),
    "clearances exchanged": (
        {"pads.preload": None, "pads.assembled_clearance": {"kind": "radial", "mean": "300 um"}},
        "pads.assembled_clearance",
        "pad 1: an assembled clearance of 300 um",
    ),
    "three that disagree": (
        {"pads.assembled_clearance": {"kind": "radial", "mean": "90 um"}},
        "pads.preload",
        "pad 1: preload 0.47 does not follow",
    ),
    "one of three": ({"pads.preload": None}, "pads", "only clearance of clearance, preload"),
    "none of three": ({"pads.preload": None, "pads.clearance": None}, "pads", "none of clearance"),
    "a pad's own that replaces neither": (
        {"pads.each": [{"assembled_clearance": RADIAL}, {}, {}, {}]},
        "pads.each[0].assembled_clearance",
        "pad 1: assembled_clearance alone",
    ),
    "own preload far below zero": ({"pads.each": [{}, {"preload": -0.7}, {}, {}]}, "pads.each[1].preload", "-0.5"),
    "pivot at the leading edge": (
        {"pads.pivot": {"kind": "rigid", "fraction": 0.2}},
        "pads.pivot.fraction",
        "0.3 to 0.8",
    ),
    "pivot at the trailing edge": (
        {"pads.pivot": {"kind": "rigid", "fraction": 0.9}},
        "pads.pivot.fraction",
        "0.3",
    ),
    "pads that overlap": ({"pads.extent": "95 deg"}, "pads.extent", "covers 95 degrees, but pad"),
    "one pad that is too long": (
        {"pads.each": [{}, {"extent": "120 deg"}, {}, {}]},
        "pads.extent",
        "pads must not overlap",
    ),
    "angles out of order": (
        ANGLES | {"pads.pivot_angles": ["45 deg", "225 deg", "135 deg", "315 deg"]},
        "pads.pivot_angles[2]",
        "pad 3: its pivot angle 135 deg lies before",
    ),
    "an angle twice": (
        ANGLES | {"pads.pivot_angles": ["45 deg", "45 deg", "225 deg", "315 deg"]},
        "pads.pivot_angles[1]",
        "pad 2: its pivot angle 45 deg is that of the pad before",
    ),
    "angles around twice": (
        ANGLES | {"pads.pivot_angles": ["-45 deg", "45 deg", "225 deg", "315 deg"]},
        "pads.pivot_angles",
        "more than once",
    ),
    "one pad": ({"pads.number": 1}, "pads.number", "2 to 24"),
    "one angle": (ANGLES | {"pads.pivot_angles": ["-90 deg"]}, "pads.pivot_angles", "two pads or more"),
    "number and angles": (
        {"pads.pivot_angles": ["-90 deg", "90 deg"]},
        "pads.pivot_angles",
        "with number",
    ),
    "no first pivot": ({"pads.first_pivot": None}, "pads.first_pivot", "load on a pad"),
    "lists of two lengths": ({"pads.each": [{}, {}]}, "pads.each", "2 entries are given for 4 pads"),
    "spring of nothing": (
        {"pads.pivot": {"kind": "spring", "stiffness": "0 N/m"}},
        "pads.pivot.stiffness",
        "1 kN/m",
    ),
    "own spring of nothing": (
        {"pads.each": [{}, {}, {"pivot": {"kind": "spring", "stiffness": "-5 MN/m"}}, {}]},
        "pads.each[2].pivot.stiffness",
        "1 kN/m",
    ),
    "negative inertia": ({"pads.inertia": "-0.1 kg m2"}, "pads.inertia", "0 kg m2"),
    "negative mass": ({"pads.each": [{"mass": "-1 kg"}, {}, {}, {}]}, "pads.each[0].mass", "0 kg"),
    "centre of gravity beside the pad": (
        {"pads.each": [{}, {"mass_offset": "40 mm"}, {}, {}]},
        "pads.each[1].mass_offset",
        "pad 2: its centre of gravity",
    ),
    "inertia below that of the mass": (
        {"pads.mass": "2 kg", "pads.mass_inset": "10 mm", "pads.inertia": "0.0001 kg m2"},
        "pads.inertia",
        "pad 1: 0.0001 kg m2 about the pivot",
    ),
    "inertia of one pad below that of its mass": (
        {"pads.each": [{}, {"mass": "2 kg", "mass_offset": "10 mm", "inertia": "0.0001 kg m2"}, {}, {}]},
        "pads.each[1].inertia",
        "pad 2",
    ),
    "carry-over above one": ({"carry_over": 1.2}, "carry_over", "0 to 1"),
    "ball larger than its hollow": (
        {"pads.pivot": POINT | {"housing_radius": "99 mm"}},
        "pads.pivot.housing_radius",
        "does not fit",
    ),
    "cylinder larger than its hollow": (
        {"pads.each": [{}, {}, {}, {"pivot": LINE | {"housing_radius": "70 mm"}}]},
        "pads.each[3].pivot.housing_radius",
        "does not fit",
    ),
    "table that falls": (
        {
            "pads.pivot": {
                "kind": "table",
                "points": [{"load": "9 kN", "displacement": "9 um"}, {"load": "10 kN", "displacement": "8 um"}],
            }
        },
        "pads.pivot.points",
        "must both rise",
    ),
    "web that is damped and rigid": (
        {"pads.pivot": {"kind": "flexure", "rotational_stiffness": "40 kN m/rad", "damping": "5 N s/m"}},
        "pads.pivot.damping",
        "stiffness besides it",
    ),
    "journal in a pad": (
        {"load": None, "position": {"x": "-60 um", "y": "-60 um"}},
        "position",
        "the journal touches pad 3",
    ),
    "no temperature": ({"supply": None}, "supply", "missing"),
    "hotter than the data": ({"supply.temperature": "195 degC"}, "supply.temperature", "outside the data"),
    "an unknown thermal model": ({"thermal": "warm"}, "thermal", "allowed: isothermal, global, adiabatic, full"),
    "deformation of cold pads": (
        {"deformation": ["growth"], "reference_temperature": "20 degC"},
        "deformation",
        "thermal: full",
    ),
    "deformation twice": (GROWN | {"deformation": ["growth", "growth"]}, "deformation", "one word twice"),
    "deformation of insulated pads": (GROWN | {"walls": None}, "walls", "pads that conduct, such as {}"),
    "growth from no temperature": (GROWN | {"reference_temperature": None}, "reference_temperature", "20 degC"),
    "growth without expansion": (
        GROWN | {"materials.pads": {"elastic_modulus": "210 GPa"}, "deformation": ["growth", "bending"]},
        "materials.pads.thermal_expansion",
        "missing",
    ),
    "bending without modulus": (
        GROWN | {"materials.pads": {"thermal_expansion": "12e-6 1/K"}, "deformation": ["growth", "bending"]},
        "materials.pads.elastic_modulus",
        "210 GPa",
    ),
    "an unknown steel": (GROWN | {"materials.pads": "unobtainium"}, "materials.pads", "unobtainium"),
    "journal given and balanced": (
        {"thermal": "full", "walls": {"journal": {"temperature": "50 degC", "shaft_conductance": "2 W/K"}}},
        "walls.journal.shaft_conductance",
        "remove one",
    ),
    "surroundings of a shaft that conducts no heat": (
        {"thermal": "full", "walls": {"journal": {"ambient_temperature": "20 degC"}}},
        "walls.journal.ambient_temperature",
        "shaft_conductance",
    ),
    "surroundings of a journal of a given temperature": (
        {"thermal": "full", "walls": {"journal": {"temperature": "50 degC", "ambient_temperature": "20 degC"}}},
        "walls.journal.ambient_temperature",
        "leave it out",
    ),
    "alarm above the trip": (
        {"thermal": "full", "limits": {"probe_alarm": "110 degC", "probe_trip": "100 degC"}},
        "limits.probe_alarm",
        "up to 100 degC",
    ),
    "pads that give off no heat": (
        {
            "thermal": "full",
            "walls": {"pads": {"heat_transfer_coefficient": "0 W/(m2 K)", "edge_coefficient": "0 W/(m2 K)"}},
        },
        "walls.pads",
        "give off no heat leave walls out",
    ),
    "turbulent films with their own temperatures": (
        {"method": {"kind": "film", "thermal": "full", "turbulence": "ng_pan"}, "accuracy": None},
        "method.turbulence",
        "full films, which have their own temperatures, are laminar",
    ),
    "growth of films of one temperature": (
        {"method": {"kind": "film", "thermal": "global", "deformation": ["growth"]}, "accuracy": None},
        "method.deformation",
        "pads grow by the temperatures of full thermal films",
    ),
    "bending of insulated pads": (
        {"method": {"kind": "film", "thermal": "adiabatic", "deformation": ["bending"]}, "accuracy": None},
        "method.deformation",
        "leave them rigid",
    ),
    "bending of no material": (
        {"method": {"kind": "film", "thermal": "global", "deformation": ["bending"]}, "accuracy": None},
        "materials",
        "bending of pads needs their material",
    ),
    "a probe beside the pad": ({"pads.probe_fraction": 1.2}, "pads.probe_fraction", "0 to 1"),
    "ratios that fall": ({"whirl_ratios": [0.5, 0.2]}, "whirl_ratios[1]", "0.2 is not above 0.5"),
    "a shaft without rotor": ({"shaft_stiffness": "200 MN/m"}, "shaft_stiffness", "rotor_mass"),
    "cross-coupling without rotor": (
        {"anticipated_cross_coupling": "4 MN/m"},
        "anticipated_cross_coupling",
        "rotor_mass",
    ),
    "a line longer than its pad": (
        {"pads.pivot": LINE | {"length": "200 mm"}},
        "pads.pivot.length",
        "pad 1: its pivot, 200 mm long, is longer than the pad is wide; allowed: up to 70 mm",
    ),
    "a rocker longer than its own pad": (
        {"pads.each": [{}, {"width": "50 mm", "pivot": {"kind": "rocker", "length": "60 mm"}}, {}, {}]},
        "pads.each[1].pivot.length",
        "up to 50 mm",
    ),
    "inertia of a larger pad": (
        {"pads.mass": "1 kg", "pads.inertia": "1 kg m2"},
        "pads.inertia",
        "a radius of gyration of 1000 mm about the pivot",
    ),
    "log decrement without rotor": ({"limits": {"log_decrement": 0.3}}, "limits.log_decrement", "rotor_mass"),
    "cross-coupling that damps": (
        {"rotor_mass": "1 t", "anticipated_cross_coupling": "-4 MN/m"},
        "anticipated_cross_coupling",
        "1 N/m",
    ),
    "a pedestal that does not hold": (
        {"pedestal": {"stiffness_x": "0 N/m", "stiffness_y": "1 GN/m"}},
        "pedestal.stiffness_x",
        "1 kN/m",
    ),
    "a pedestal that holds along x alone": (
        {"pedestal": {"stiffness_x": "1 GN/m"}},
        "pedestal.stiffness_y",
        "missing",
    ),
    "limits that are not there": ({"clearance_cases": "all"}, "pads.clearance", "limits of a clearance"),
    "faster than a bullet": ({"speed": "90000 rpm"}, "speed", "up to 200 m/s"),
    "points of one name": (
        {"operating_points": [{"name": "A"}, {"name": "A", "load": "9 kN"}]},
        "operating_points[1 'A'].name",
        "each name once",
    ),
    "journal in a pad at a point": (
        {"operating_points": [{"name": "A", "position": {"x": "90 um", "y": "90 um"}}]},
        "operating_points[0 'A'].position",
        "the journal touches pad 1",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_one_message_names_pad_and_field(name):
    changes, field, words = REFUSED[name]
    with pytest.raises(CaseError) as caught:
        case_from_dict(pad_case(changes))
    assert len(caught.value.problems) == 1, caught.value
    (problem,) = caught.value.problems
    assert problem.field == field
    assert words in problem.message


def test_the_bearing_itself_is_accepted():
    case_from_dict(pad_case())
    case_from_dict(pad_case({"pads.assembled_clearance": {"kind": "radial", "mean": "78.44 um"}}))


def test_a_supply_below_the_side_flow_is_refused_by_check_and_solve():
    case = case_from_dict(pad_case({"supply.flow": "1 L/min"}))
    refused = refusal_of(case)
    assert refused is not None
    assert refused.code == "E101"
    assert "supply.flow is 1 L/min" in refused.message
    with pytest.raises(InputError, match="they starve"):
        solve(case)
    assert refusal_of(case_from_dict(pad_case({"supply.flow": "30 L/min"}))) is None


STEEL = {"elastic_modulus": "210 GPa", "thermal_expansion": "12e-6 1/K"}
NOT_READ = {
    "temperature given and sought": (
        {"thermal": "global", "effective_temperature": "60 degC"},
        ("effective_temperature",),
    ),
    "walls of turbulent films": (
        {
            "turbulence": "ng_pan",
            "walls": {"pads": {"edge_coefficient": "50 W/(m2 K)"}, "journal": {"shaft_conductance": "2 W/K"}},
        },
        ("walls.pads.edge_coefficient", "walls.journal.shaft_conductance"),
    ),
    "probes of films of one temperature": (
        {"pads.probe_fraction": 0.6, "pads.each": [{"probe_fraction": 0.7}, {}, {}, {}]},
        ("pads.probe_fraction", "pads.each (pad 1).probe_fraction"),
    ),
    "Poisson's ratio of beams": (
        {
            "materials": {"pads": {"poisson_ratio": 0.3}},
            "pads.each": [{"material": {"poisson_ratio": 0.2}}, {}, {}, {}],
        },
        ("materials.pads.poisson_ratio", "pads.each (pad 1).material.poisson_ratio"),
    ),
    # what the fuller model makes of the bearing depends on all these (W422)
    "all that grows": (
        {
            "thermal": "global",
            "walls": {"pads": {}, "housing": {"temperature": "50 degC"}},
            "reference_temperature": "20 degC",
            "materials": {"pads": "C45", "journal": "42CrMo4", "housing": "C45"},
        },
        (),
    ),
    "modulus of pads that do not bend": (GROWN | {"materials.pads": STEEL}, ()),
    "expansion of rigid pads": (
        {"thermal": "full", "walls": {"pads": {}}, "materials.pads": {"thermal_expansion": "12e-6 1/K"}}, (),
    ),
    "expansion of pads of one temperature": (
        {"thermal": "global", "deformation": ["bending"], "materials": {"pads": STEEL}}, (),
    ),
    "a plate that does not bend": ({"pad_bending": "plate"}, ()),
    "a material of a rigid pad": ({"pads.each": [{"material": "C45"}, {}, {}, {}]}, ()),
}  # fmt: skip
"""Data of another thermal model or deformation, and the paths that are named as not used."""


@pytest.mark.parametrize("name", NOT_READ)
def test_data_of_another_thermal_model_are_listed_as_not_used(name):
    changes, paths = NOT_READ[name]
    (problem,) = case_from_dict(pad_case(changes)).problems()
    assert paths == tuple(
        one for notice in problem.warnings if notice.code == "W183" for one in notice.values["fields"]
    )


def test_what_only_deformation_reads_changes_no_film():
    changes, _ = NOT_READ["all that grows"]
    bare, given = (solve(case_from_dict(pad_case(one))).results[0] for one in ({"thermal": "global"}, changes))
    assert dict(bare.values) | {"wall_time": 0.0} == dict(given.values) | {"wall_time": 0.0}


def test_limits_of_probes_that_nothing_tells_are_listed_as_not_checked():
    limits = {"limits": {"probe_alarm": "90 degC", "probe_trip": "100 degC"}}
    (result,) = solve(case_from_dict(pad_case(limits, materials={"bearing_metal": "B83"}))).results
    assert {"C404", "C405"} <= {one.code for one in result.not_checked}
    assert result.lacking == (Subject.PROBE_TEMPERATURE,)
    assert result.verdict is Verdict.NO_VERDICT
    assert solve(case_from_dict(pad_case(materials={"bearing_metal": "B83"}))).results[0].within_limits


@pytest.mark.parametrize(("load_angle", "across"), [("-90 deg", 10e3), ("-30 deg", 5e3)])
def test_two_pads_on_one_line_are_told_that_they_hold_nothing_across_it(load_angle, across):
    two = {"pads.number": 2, "pads.first_pivot": "0 deg"}
    (result,) = solve(case_from_dict(pad_case(two, load_angle=load_angle))).results
    assert result.failure.values["across"] == pytest.approx(across)
    assert "cannot hold the journal across it" in result.message
    assert "supply pressure" not in result.message
    assert [one.variant for one in result.warnings if one.code == "W410"] == ["line"]


def test_pads_without_a_place_are_not_advised_a_supply_pressure():
    beside = {"pads.number": None, "pads.first_pivot": None, "pads.pivot_angles": ["10 deg", "170 deg"]}
    (result,) = solve(case_from_dict(pad_case(beside))).results
    assert result.verdict is Verdict.NO_SOLUTION
    assert "Try: less load" in result.message
    assert "supply pressure" not in result.message
