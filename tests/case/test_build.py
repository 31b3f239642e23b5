"""Cases become design cases: numbers in SI, machine and bearing merged, assumptions told."""

import math
from pathlib import Path

import pytest
import yaml

from babbitt.case import CaseError, case_from_dict, case_hash, load_case, parse_case, template
from babbitt.design.cooling import STILL_AIR_COEFFICIENT
from babbitt.kinds.journal.iso7902 import check
from babbitt.kinds.journal.iso7902.model import (
    Curves,
    DesignCase,
    Friction,
    HousingCooling,
    OilSupply,
    PrescribedEccentricity,
    PrescribedLoad,
)
from babbitt.kinds.journal.iso7902.supply import Arrangement, CircumferentialGroove, Holes, Pockets
from babbitt.properties.fits import Clearance
from babbitt.properties.lubricants import lubricant
from babbitt.properties.materials import LoadCharacter, bearing_metal, structural_material

JOURNAL = {
    "kind": "journal",
    "name": "Test",
    "diameter": "200 mm",
    "width": "100 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "span": "180 deg",
    "materials": {"bearing": {"thermal_expansion": "23e-6 1/K"}, "journal": {"thermal_expansion": "11e-6 1/K"}},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
    "load": "40 kN",
    "speed": "3000 rpm",
}


def built(**changes) -> DesignCase:
    given = {name: value for name, value in (JOURNAL | changes).items() if value is not None}
    (only,) = case_from_dict(given).problems()
    return only


def test_the_numbers():
    case = built(load_angle="-90 deg", bearing_speed="100 rpm", friction={"model": "arc", "factor": 1.1})
    assert (case.name, case.kind) == ("Test", "journal")
    assert (case.bearing.diameter, case.bearing.width, case.bearing.span) == (0.2, 0.1, 180)
    assert case.bearing.relative_clearance == pytest.approx(1.5e-3, rel=1e-14)
    assert (case.bearing.expansion_bearing, case.bearing.expansion_journal) == (23e-6, 11e-6)
    assert case.duty == PrescribedLoad(40e3)
    assert case.journal_speed == pytest.approx(100.0 * math.pi)
    assert case.bearing_speed == pytest.approx(10.0 * math.pi / 3.0)
    assert case.oil_supply == OilSupply(323.15, 0.2e6)
    assert case.cooling is None
    assert case.lubricant == lubricant("ISO VG 46")
    assert (case.friction, case.friction_factor, case.curves) == (Friction.ARC, 1.1, Curves.COMPUTED)


def test_ways_of_saying_the_same_are_the_same():
    reference = built()
    assert built(width=None, width_ratio=0.5).bearing == reference.bearing
    assert built(load=None, specific_load="2 MPa").duty.load == pytest.approx(40e3)
    assert built(speed=None, surface_speed=f"{math.pi * 10.0} m/s").journal_speed == pytest.approx(
        reference.journal_speed
    )
    assert built(clearance={"kind": "diametral", "mean": "0.3 mm"}).bearing.relative_clearance == pytest.approx(
        1.5e-3
    )
    named = {"bearing": "AlSi10Mg", "journal": "42CrMo4"}
    bearing = built(materials=named).bearing
    assert bearing.expansion_bearing == structural_material("AlSi10Mg").thermal_expansion
    assert bearing.expansion_journal == structural_material("42CrMo4").thermal_expansion


def test_a_fit_in_short():
    assert built(clearance="H7/d8") == built(clearance={"kind": "fit", "bore": "H7", "journal": "d8"})
    assert built(clearance=" H7 / d8 ").bearing == built(clearance="H7/d8").bearing


@pytest.mark.parametrize(
    ("given", "opposite"),
    [
        ({"speed": "3000 rpm"}, {"speed": "-3000 rpm"}),
        ({"speed": None, "surface_speed": "20 m/s"}, {"speed": None, "surface_speed": "-20 m/s"}),
        (
            {"speed": "3000 rpm", "bearing_speed": "-500 rpm"},
            {"speed": "-3000 rpm", "bearing_speed": "500 rpm"},
        ),
    ],
)
def test_the_design_check_does_not_depend_on_the_sense_of_rotation(given, opposite):
    case, mirrored = built(**given), built(**opposite)
    assert mirrored.journal_speed == -case.journal_speed < 0.0
    assert mirrored.bearing_speed == -case.bearing_speed
    results = [check(one) for one in (case, mirrored)]
    values = [{name: value for name, value in one.values.items() if name != "wall_time"} for one in results]
    assert values[1].pop("angular_speed") == -values[0].pop("angular_speed")
    assert values[0] == values[1]
    assert results[0].checks == results[1].checks
    assert [one.code for one in results[0].warnings] == [one.code for one in results[1].warnings]


@pytest.mark.parametrize(("journal", "bearing"), [(3000, -3000), (-3000, 3000), (3000, -4000), (-3000, 4000)])
def test_a_bearing_that_turns_back_the_film_is_refused(journal, bearing):
    why = "is zero" if journal + bearing == 0 else "in whose sense friction and places before the load count"
    with pytest.raises(CaseError, match=f"the speeds build no film: .*{why}"):
        built(speed=f"{journal} rpm", bearing_speed=f"{bearing} rpm")


def test_speeds_exchanged_make_the_same_film():
    """What the refusal of a film that turns against the journal recommends: the film knows the sum alone."""
    with pytest.raises(CaseError, match="speed: -5000 rpm with bearing_speed: 3000 rpm has the same film"):
        built(speed="3000 rpm", bearing_speed="-5000 rpm")
    exchanged, alone = (
        check(built(speed=speed, bearing_speed=bearing, effective_temperature="60 degC"))
        for speed, bearing in (("-5000 rpm", "3000 rpm"), ("-2000 rpm", "0 rpm"))
    )
    for name in ("hydrodynamic_speed", "eccentricity_ratio", "minimum_film_thickness", "side_flow"):
        assert exchanged.values[name] == pytest.approx(alone.values[name], rel=1e-12)


@pytest.mark.parametrize("speed", ["0 rpm", "-0.01 rpm", "-2e6 rpm"])
def test_the_range_of_a_speed_is_that_of_its_magnitude(speed):
    with pytest.raises(CaseError, match="with either sign"):
        built(speed=speed)


def test_prescribed_eccentricity():
    assert built(load=None, eccentricity_ratio=0.6).duty == PrescribedEccentricity(0.6)


@pytest.mark.parametrize(
    "given",
    [
        {"kind": "fit", "bore": "H7", "journal": "d8"},
        {"kind": "limits", "bore": ["200 mm", "200.046 mm"], "journal": ["199.758 mm", "199.830 mm"]},
        {"kind": "deviations", "bore": ["0 um", "46 um"], "journal": ["-242 um", "-170 um"]},
        {"kind": "diametral", "mean": "0.229 mm", "minimum": "0.17 mm", "maximum": "0.288 mm"},
        {"kind": "relative", "mean": "1.145 permille", "minimum": "0.85 permille", "maximum": "1.44 permille"},
    ],
)
def test_clearance_of_h7_d8_in_five_ways(given):
    expected = Clearance.from_fit(0.2, "H7/d8").relative(0.2)
    cases = case_from_dict(JOURNAL | {"clearance": given, "clearance_cases": "all"}).problems()
    assert [case.name for case in cases] == [f"Test ({word} clearance)" for word in ("minimum", "mean", "maximum")]
    found = [case.bearing.relative_clearance for case in cases]
    assert found == pytest.approx([expected.minimum, expected.mean, expected.maximum], rel=1e-9)
    assert built(clearance=given).bearing.relative_clearance == pytest.approx(expected.mean, rel=1e-9)


HOLE = 5.0 / 200.0
"""Half of the angle in rad that a hole of 5 mm takes of the bore of `JOURNAL`."""


@pytest.mark.parametrize(
    ("given", "element"),
    [
        (
            {"kind": "hole", "diameter": "5 mm", "place": "opposite"},
            Holes(0.005, Arrangement.OPPOSITE, 1.0, math.pi - HOLE, 0.005),
        ),
        (
            {"kind": "hole", "diameter": "5 mm", "place": "side", "number": 3},
            Holes(0.005, Arrangement.SIDE, 3.0, math.pi / 2.0 - HOLE, 0.015),
        ),
        (
            {"kind": "pocket", "width": "70 mm", "place": "both_sides"},
            Pockets(0.07, Arrangement.BOTH_SIDES, math.radians(80.0), math.radians(20.0)),
        ),
        (
            {"kind": "pocket", "width": "70 mm", "place": "opposite", "extent": "60 deg"},
            Pockets(0.07, Arrangement.OPPOSITE, math.radians(150.0), math.radians(60.0)),
        ),
        ({"kind": "groove_360", "width": "5 mm"}, CircumferentialGroove(0.005)),
    ],
)
def test_supply_elements(given, element):
    assert built(span="360 deg", supply_element=given).bearing.supply_element == element


def test_pockets_at_both_sides_end_where_the_arc_begins():
    """As in the film of the same case."""
    given = {"kind": "pocket", "width": "70 mm", "place": "both_sides"}
    assert built(span="120 deg", supply_element=given).bearing.supply_element.edge == pytest.approx(math.pi / 3.0)


def test_a_slot_is_equivalent_holes():
    case = built(supply_element={"kind": "slot", "length": "50 mm", "width": "12 mm", "place": "side"})
    element = case.bearing.supply_element
    assert isinstance(element, Holes)
    assert (element.diameter, element.number) == (
        pytest.approx(19.355e-3, abs=1e-6),
        pytest.approx(2.0393, abs=1e-4),
    )
    assert any("2.039 holes of 19.355 mm" in text for text in case.assumptions)


def uneven(entry, leaving, extent, **more):
    angles = {"entry_angle": f"{entry} deg", "exit_angle": f"{leaving} deg", "extent": f"{extent} deg"}
    return {"kind": "uneven_pockets", "width": "70 mm", **angles, **more}


@pytest.mark.parametrize(
    ("pockets", "span", "word"),
    [
        (uneven(75, 104, 20), 120, "130 deg (entry side alone"),
        (uneven(75, 104, 20, rounding="nearest"), 120, "130 deg"),
        (uneven(82, 104, 20, rounding="nearest"), 150, "144 deg"),
        (uneven(82, 104, 20), 120, "144 deg"),
        (uneven(100, 65, 20), 90, "110 deg (pockets)"),
        (uneven(50, 104, 20), 90, "flatters"),
    ],
)
def test_uneven_pockets_set_the_span(pockets, span, word):
    case = built(span=None, supply_element=pockets)
    assert case.bearing.span == span
    edge = math.radians(float(pockets["entry_angle"].split()[0]) - 10.0)
    assert case.bearing.supply_element == Pockets(
        0.07,
        Arrangement.BOTH_SIDES,
        pytest.approx(edge),
        pytest.approx(math.radians(20.0)),
        pytest.approx(math.radians(float(pockets["exit_angle"].split()[0]))),
    )
    assert any(word in text for text in case.assumptions)
    warnings = {notice.code for notice in case.warnings}
    assert warnings == ({"W104", "W105"} if word == "flatters" else {"W104"})


def test_a_span_given_beside_uneven_pockets_wins_and_is_told():
    case = built(span="150 deg", supply_element=uneven(75, 104, 20))
    assert case.bearing.span == 150
    assert any("150 deg was given" in text for text in case.assumptions)


def test_surfaces_from_the_drawing():
    rough = {"roughness_bearing": "4 um", "roughness_journal": "2 um"}
    drawing = {"profile_tolerance_bearing": "7 um", "profile_tolerance_journal": "5 um"}
    drawing |= {"roundness_tolerance_bearing": "5 um", "roundness_tolerance_journal": "3 um"}
    surfaces = built(surfaces={"kind": "drawing", **rough, **drawing}).bearing.surfaces
    assert surfaces.film_limit == pytest.approx(4e-6 + 2e-6 + 12e-6 / 2.0 + 8e-6 / 2.0)
    direct = {"kind": "direct", **rough, "tilt_offset": "12 um", "waviness": "4 um"}
    assert built(surfaces=direct).bearing.surfaces.film_limit == pytest.approx(surfaces.film_limit)


def test_supply_path_and_limits():
    supply = {**JOURNAL["supply"], "circulation_time": "8 min", "holes": [{"diameter": "8 mm"}]}
    supply["tubes"] = [{"diameter": "24 mm", "length": "3 m", "loss_coefficient": 2, "number": 2}]
    case = built(supply=supply, limits={"temperature": "90 degC", "minimum_film_thickness": "10 um"})
    (tube,), (hole,) = case.oil_supply.tubes, case.oil_supply.holes
    assert (tube.diameter, tube.length, tube.loss_coefficient, tube.number) == (0.024, 3.0, 2.0, 2.0)
    assert (hole.diameter, hole.length, hole.loss_coefficient, hole.number) == (0.008, 0.0, 1.5, 1.0)
    assert case.oil_supply.circulation_time == 480.0
    assert case.limits.temperature == pytest.approx(363.15)
    assert case.limits.minimum_film_thickness == pytest.approx(10e-6)
    assert not any("losses" in text or "circulation time" in text for text in case.assumptions)


@pytest.mark.parametrize(
    ("cooling", "coefficient", "surface"),
    [
        ({"surface": "0.3 m2"}, STILL_AIR_COEFFICIENT, 0.3),
        ({"surface": "0.3 m2", "air_speed": "1 m/s"}, STILL_AIR_COEFFICIENT, 0.3),
        ({"surface": "0.3 m2", "air_speed": "4 m/s"}, 31.0, 0.3),
        ({"surface": "0.3 m2", "heat_transfer_coefficient": "15 W/(m2 K)"}, 15.0, 0.3),
        ({"housing": {"kind": "in_machine"}}, STILL_AIR_COEFFICIENT, 15.0 * 0.02),
        (
            {"housing": {"kind": "pedestal", "height": "400 mm", "width": "100 mm"}},
            STILL_AIR_COEFFICIENT,
            math.pi * 0.4 * 0.3,
        ),
        (
            {"housing": {"kind": "cylinder", "diameter": "400 mm", "width": "100 mm"}},
            STILL_AIR_COEFFICIENT,
            math.pi / 2.0 * (0.16 - 0.04) + math.pi * 0.04,
        ),
    ],
)
def test_cooling_without_oil_supply(cooling, coefficient, surface):
    case = built(supply=None, cooling={"ambient_temperature": "20 degC", **cooling})
    assert case.oil_supply is None
    assert isinstance(case.cooling, HousingCooling)
    assert case.cooling.ambient_temperature == pytest.approx(293.15)
    assert case.cooling.heat_transfer_coefficient == pytest.approx(coefficient)
    assert case.cooling.surface == pytest.approx(surface)
    told = any("Heat transfer coefficient" in text for text in case.assumptions)
    assert told is ("heat_transfer_coefficient" not in cooling)


def test_operating_points_override():
    given = JOURNAL | {
        "load": None,
        "specific_load": "2 MPa",
        "supply_element": {"kind": "pocket", "width": "70 mm", "place": "both_sides"},
        "operating_points": [
            {"name": "base"},
            {"name": "slow", "speed": "100 rpm", "supply_temperature": "60 degC", "supply_pressure": "3 bar"},
            {"name": "turned", "load": "10 kN", "supply_element": uneven(75, 104, 20)},
            {"name": "fixed", "eccentricity_ratio": 0.5, "surface_speed": "20 m/s", "span": "90 deg"},
        ],
    }
    base, slow, turned, fixed = case_from_dict(given).problems()
    assert [case.name for case in (base, slow)] == ["Test [base]", "Test [slow]"]
    assert (base.duty, base.bearing.span) == (PrescribedLoad(40e3), 180)
    assert slow.journal_speed == pytest.approx(100.0 * math.pi / 30.0)
    assert (slow.oil_supply.temperature, slow.oil_supply.pressure) == (pytest.approx(333.15), 3e5)
    assert (turned.duty, turned.bearing.span, turned.journal_speed) == (
        PrescribedLoad(10e3),
        120,
        base.journal_speed,
    )
    assert (fixed.duty, fixed.bearing.span, fixed.journal_speed) == (PrescribedEccentricity(0.5), 90, 200.0)


def test_operating_points_and_clearances_together():
    given = JOURNAL | {"clearance": {"kind": "fit", "bore": "H7", "journal": "d8"}, "clearance_cases": "all"}
    given["operating_points"] = [{"name": "full"}, {"name": "half", "load": "20 kN"}]
    names = [case.name for case in case_from_dict(given).problems()]
    assert names[:2] == ["Test [full] (minimum clearance)", "Test [full] (mean clearance)"]
    assert len(names) == len(set(names)) == 6


def machine(shared, **own):
    bearing = {name: value for name, value in JOURNAL.items() if name not in ("lubricant", "supply", "materials")}
    other = bearing | {"name": "Other"} | own
    return {"kind": "machine", "name": "Machine", **shared, "bearings": [bearing, other]}


SHARED = {name: JOURNAL[name] for name in ("lubricant", "supply", "materials")}


def test_a_bearing_takes_single_fields_from_its_machine():
    shared = SHARED | {
        "cooling": {"ambient_temperature": "20 degC", "heat_transfer_coefficient": 15, "surface": "1 m2"}
    }
    first, other = case_from_dict(
        machine(
            shared,
            lubricant="ISO VG 32",
            supply={"pressure": "3 bar"},
            materials={"bearing_metal": "B83", "load_character": "shock", "bearing": "C10"},
            cooling={"air_speed": "4 m/s", "housing": {"kind": "in_machine"}},
        )
    ).problems()
    assert (first.lubricant.name, other.lubricant.name) == ("ISO VG 46", "ISO VG 32")
    assert (first.oil_supply.pressure, other.oil_supply.pressure) == (2e5, 3e5)
    assert first.oil_supply.temperature == other.oil_supply.temperature == 323.15
    assert (first.bearing.metal, other.bearing.metal) == (None, bearing_metal("B83"))
    assert other.bearing.load_character is LoadCharacter.SHOCK
    assert other.bearing.expansion_bearing == structural_material("C10").thermal_expansion
    assert other.bearing.expansion_journal == first.bearing.expansion_journal == 11e-6
    assert (first.cooling.heat_transfer_coefficient, first.cooling.surface) == (15.0, 1.0)
    assert (other.cooling.heat_transfer_coefficient, other.cooling.surface) == (31.0, pytest.approx(0.3))


def test_clearance_cases_of_a_machine_and_of_one_bearing():
    shared = SHARED | {"clearance_cases": "all"}
    fit = {"kind": "fit", "bore": "H7", "journal": "d8"}
    given = machine(shared, clearance=fit, clearance_cases="mean")
    given["bearings"][0]["clearance"] = fit
    names = [case.name for case in case_from_dict(given).problems()]
    assert names == [f"Test ({word} clearance)" for word in ("minimum", "mean", "maximum")] + ["Other"]


def test_assumptions_of_machine_bearing_and_oil_are_carried_along():
    given = machine(SHARED | {"assumptions": ["of the machine"]}, assumptions=["of the bearing"])
    first, other = case_from_dict(given).problems()
    assert first.assumptions[0] == other.assumptions[0] == "of the machine"
    assert "of the bearing" in other.assumptions
    assert "of the bearing" not in first.assumptions
    oil = set(lubricant("ISO VG 46").assumptions_but_of_conduction)
    assert oil <= set(check(first).assumptions)
    assert len(set(check(first).assumptions)) == len(check(first).assumptions)
    assert any("No losses on the way" in text for text in first.assumptions)
    assert any("No bearing metal" in text for text in first.assumptions)


def test_statics_are_one_problem():
    case = parse_case(template("overhung_coupling"))
    (problem,) = case.problems()
    assert problem.shaft == case.shaft()
    assert case.shaft().coupling_arm == pytest.approx(0.350 + 0.700 / 4.0)


def test_hash_knows_numbers_not_layout():
    text = template("machine")
    same = text.replace("160 mm", "0.16 m").replace("babbitt: 1", "").replace("3000 rpm", "50 Hz")
    as_json = yaml.safe_load(text)
    assert case_hash(parse_case(text)) == case_hash(parse_case(same)) == case_hash(case_from_dict(as_json))
    assert case_hash(parse_case(text)) != case_hash(parse_case(text.replace("160 mm", "161 mm")))
    assert len(case_hash(parse_case(text))) == 64


def test_hash_is_the_same_tomorrow():
    # A change here means that the results of old files are no longer found again by their hash.
    assert case_hash(case_from_dict(JOURNAL))[:16] == "e1ee58cb5243a322"


def test_reverse_gear(request):
    cases = load_case(Path(request.config.rootpath, "examples", "marine_reverse_gear.yaml")).problems()
    assert len(cases) == len({case.name for case in cases}) == 11
    assert [case.bearing.span for case in cases] == [180, 180, 120, *[180] * 8]
    for case in cases:
        assert case.bearing.expansion_bearing - case.bearing.expansion_journal == pytest.approx(-2.6e-6)
        assert case.bearing.surfaces.film_limit == pytest.approx(16e-6)
        assert (case.friction, case.friction_factor) == (Friction.CURVE360, 1.10)
        assert case.lubricant.name == "TP-46 STO upper"
        assert len([text for text in case.assumptions if "inferred" in text]) >= 3
        if isinstance(case.bearing.supply_element, Pockets):
            assert case.bearing.supply_element.width / case.bearing.width == pytest.approx(
                0.82 if case.name == "Output wheel" else 0.73
            )
        else:
            assert case.bearing.supply_element.width / case.bearing.width == pytest.approx(0.05)
    left, right = (case for case in cases if case.name.startswith("MRP pinion"))
    assert left.bearing == right.bearing


def test_hash_forgives_what_a_change_of_units_leaves_behind():
    def of(**changes):
        return case_hash(case_from_dict(JOURNAL | changes))

    assert 0.1 + 0.2 != 0.3
    assert of(diameter=f"{0.1 + 0.2!r} m") == of(diameter="0.3 m") == of(diameter="300 mm")
    assert of(load_angle=f"{-90.0 * (1.0 + 1e-15)!r} deg") == of()  # a hair from the default is the default
    assert of(diameter="300.000001 mm") != of(diameter="300 mm")


@pytest.mark.parametrize(
    ("element", "words"),
    [
        ({"kind": "hole", "diameter": "5 mm", "place": "opposite"}, "the supply element is ignored"),
        (
            {
                "kind": "uneven_pockets",
                "width": "60 mm",
                "entry_angle": "100 deg",
                "exit_angle": "100 deg",
                "extent": "20 deg",
            },
            "the pockets set the span and are ignored otherwise",
        ),
    ],
)
def test_a_supply_element_without_supply_is_told(element, words):
    cooled = {"ambient_temperature": "20 degC", "heat_transfer_coefficient": 20.0, "surface": "1 m2"}
    case = built(supply=None, cooling=cooled, supply_element=element)
    assert any(words in text for text in case.assumptions)
    assert not any("ignored" in text for text in built(supply_element=element).assumptions if "supply el" in text)


def test_several_holes_do_not_interact():
    def told(number):
        element = {"kind": "hole", "diameter": "5 mm", "place": "opposite", "number": number}
        return any("not interacting" in text for text in built(supply_element=element).assumptions)

    assert told(3)
    assert not told(1)


def doubts_of_a(**changes):
    return {notice.code: notice.message for notice in built(**changes).warnings}


def test_a_span_wider_than_a_half_groove_leaves_is_told():
    groove = {"kind": "groove_180", "width": "6 mm"}
    assert "W188" in doubts_of_a(supply_element=groove, span="360 deg")
    for span in ("180 deg", "120 deg"):
        assert "W188" not in doubts_of_a(supply_element=groove, span=span)
    assert "W188" not in doubts_of_a(supply_element=groove | {"kind": "groove_360"}, span="360 deg")


def test_a_load_into_a_pocket_that_the_standard_does_not_read_is_told():
    pockets = [{"angle": f"{angle} deg", "extent": "20 deg", "width": "40 mm"} for angle in (0, 180)]
    assert "into pockets.1" in doubts_of_a(pockets=pockets, load_angle="172 deg")["W143"]
    assert "W143" not in doubts_of_a(pockets=pockets, load_angle="-90 deg")
