"""Design cases carry the words of the case that their numbers came from."""

import pytest

from babbitt.case import case_from_dict
from babbitt.properties.fits import Clearance, Deviations, SizeLimits

JOURNAL = {
    "kind": "journal",
    "name": "Test",
    "diameter": "80 mm",
    "width": "40 mm",
    "clearance": "H7/e8",
    "span": "180 deg",
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
    "load": "6 kN",
    "speed": "2000 rpm",
}


def words(**changes) -> dict[str, str]:
    given = {name: value for name, value in (JOURNAL | changes).items() if value is not None}
    (only,) = case_from_dict(given).problems()
    assert len(dict(only.given)) == len(only.given)
    assert all(text.isprintable() and len(label) < 25 for label, text in only.given)
    return dict(only.given)


def test_a_fit_is_told_with_its_sizes():
    told = words()
    # ISO 286-2: H7 0/+30 um and e8 -106/-60 um for 80 mm.
    assert told["Clearance"] == "Fit H7/e8: bore 80.000 to 80.030 mm, journal 79.894 to 79.940 mm"
    assert told["Diametral clearance"] == "mean 98 µm, minimum 60 µm, maximum 136 µm"
    assert told["Relative clearance"] == "mean 1.225 ‰, minimum 0.75 ‰, maximum 1.7 ‰"
    assert told["Clearance case"] == "mean"


@pytest.mark.parametrize(
    ("clearance", "said"),
    [
        (
            {"kind": "limits", "bore": ["80 mm", "80.0305 mm"], "journal": ["79.894 mm", "79.94 mm"]},
            "Limits of size: bore 80.000 to 80.0305 mm, journal 79.894 to 79.940 mm",
        ),
        (
            {"kind": "deviations", "bore": ["0 um", "30 um"], "journal": ["-106 um", "-60 um"]},
            "Deviations from 80 mm: bore 0 to +30 µm, journal -106 to -60 µm",
        ),
        ({"kind": "relative", "mean": "1.2 permille"}, "Relative to the diameter"),
        ({"kind": "diametral", "mean": "98 um", "minimum": "60 um", "maximum": "136 um"}, "On the diameter"),
    ],
)
def test_every_other_way_of_giving_the_clearance(clearance, said):
    told = words(clearance=clearance)
    assert told["Clearance"] == said
    known = "mean" in clearance and "minimum" not in clearance
    assert ("minimum" not in told["Diametral clearance"]) is known
    assert told["Diametral clearance"].startswith("mean 96 µm" if clearance["kind"] == "relative" else "mean 98")


def test_sizes_told_are_those_computed_with():
    sizes = words()["Clearance"].replace(",", "").split()
    bore = SizeLimits(*(float(sizes[at]) / 1e3 for at in (3, 5)))
    journal = SizeLimits(*(float(sizes[at]) / 1e3 for at in (8, 10)))
    (case,) = case_from_dict(JOURNAL).problems()
    assert Clearance.from_sizes(bore, journal).mean / 0.08 == pytest.approx(case.bearing.relative_clearance)
    deviations = Clearance.from_deviations(0.08, Deviations(0.0, 30e-6), Deviations(-106e-6, -60e-6))
    assert case.bearing.clearance_tolerance == pytest.approx(
        (deviations.minimum / 0.08, deviations.maximum / 0.08)
    )


def test_the_clearance_case_is_told():
    cases = case_from_dict(JOURNAL | {"clearance_cases": "all"}).problems()
    assert [dict(case.given)["Clearance case"] for case in cases] == ["minimum", "mean", "maximum"]
    assert [case.name for case in cases] == [f"Test ({word} clearance)" for word in ("minimum", "mean", "maximum")]


def test_materials_are_named():
    materials = {"bearing": {"thermal_expansion": "23e-6 1/K"}, "journal": "c 45", "bearing_metal": "B83"}
    told = words(materials=materials)
    assert told["Bearing material"] == "expansion 23 × 10⁻⁶/K"
    assert told["Journal material"] == "c 45 (C45), expansion 11.1 × 10⁻⁶/K"
    assert told["Bearing metal"] == "B83, calm load"
    assert words(materials=materials | {"load_character": "shock"})["Bearing metal"] == "B83, shock load"
    assert words()["Bearing material"].startswith("C10, expansion")
    assert "Bearing metal" not in words()


@pytest.mark.parametrize(
    ("cooling", "said"),
    [
        (
            {"housing": {"kind": "pedestal", "height": "200 mm", "width": "120 mm"}, "air_speed": "2 m/s"},
            {"Housing": "pedestal, height 200 mm, width 120 mm", "Air speed": "2 m/s"},
        ),
        (
            {"housing": {"kind": "cylinder", "diameter": "160 mm", "width": "60 mm"}},
            {"Housing": "cylinder, diameter 160 mm, width 60 mm"},
        ),
        ({"housing": {"kind": "in_machine", "factor": 18}}, {"Housing": "within a machine, surface 18 B D"}),
        (
            {"surface": "0.3 m2", "heat_transfer_coefficient": "15 W/(m2 K)"},
            {"Housing surface": "0.3 m²", "Heat transfer": "15 W/(m² K)"},
        ),
    ],
)
def test_cooling_is_told_as_given(cooling, said):
    labels = {"Housing", "Housing surface", "Air speed", "Heat transfer"}
    told = words(cooling={"ambient_temperature": "20 degC", **cooling})
    assert {label: text for label, text in told.items() if label in labels} == said
    assert not labels & words().keys()


@pytest.mark.parametrize(
    ("element", "said"),
    [
        ({"kind": "hole", "diameter": "5 mm", "place": "opposite"}, "hole 5 mm, opposite the load"),
        (
            {"kind": "hole", "diameter": "5 mm", "place": "both_sides", "number": 3},
            "3 holes 5 mm, at both sides of the load",
        ),
        (
            {"kind": "slot", "length": "30 mm", "width": "6 mm", "place": "side"},
            "slot 30 mm x 6 mm, at one side of the load",
        ),
        ({"kind": "pocket", "width": "30 mm", "place": "side"}, "pocket 30 mm wide, at one side of the load"),
        ({"kind": "groove_360", "width": "5 mm"}, "groove 5 mm wide around the whole circumference"),
        ({"kind": "groove_180", "width": "5 mm"}, "groove 5 mm wide around the unloaded half"),
    ],
)
def test_supply_elements_are_told_before_they_are_converted(element, said):
    assert words(supply_element=element)["Supply element"] == said


def test_uneven_pockets_are_told_with_their_angles_at_each_point():
    angles = {"entry_angle": "75 deg", "exit_angle": "104 deg", "extent": "20 deg"}
    uneven = {"kind": "uneven_pockets", "width": "30 mm", **angles}
    given = JOURNAL | {
        "span": None,
        "supply_element": uneven,
        "operating_points": [
            {"name": "ahead"},
            {"name": "astern", "supply_element": uneven | {"entry_angle": "104 deg", "exit_angle": "75 deg"}},
        ],
    }
    ahead, astern = (dict(case.given) for case in case_from_dict(given).problems())
    told = "pockets centred {} before and {} behind the load, 30 mm wide, 20° long each"
    assert ahead["Supply element"] == told.format("75°", "104°")
    assert astern["Supply element"] == told.format("104°", "75°")
    assert (ahead["Operating point"], astern["Operating point"]) == ("ahead", "astern")
    assert "Operating point" not in words()


def test_derived_numbers_are_told_as_they_were_given():
    told = words(width=None, width_ratio=0.5, load=None, specific_load="2 MPa", speed=None, surface_speed="12 m/s")
    assert (told["Width"], told["Load"]) == ("0.5 of the diameter", "2 MPa on the projected area")
    assert told["Surface speed"] == "12 m/s"
    assert not {"Width", "Load", "Speed"} & words().keys()


def test_form_tolerances_of_the_drawing():
    drawing = {
        "kind": "drawing",
        "roughness_bearing": "4 um",
        "roughness_journal": "2 um",
        "profile_tolerance_bearing": "7 um",
        "profile_tolerance_journal": "5 um",
        "roundness_tolerance_bearing": "5 um",
        "roundness_tolerance_journal": "3.5 um",
    }
    told = words(surfaces=drawing)
    assert told["Profile tolerance TFP"] == "bore 7 µm, journal 5 µm"
    assert told["Roundness tolerance TFR"] == "bore 5 µm, journal 3.5 µm"


def test_what_a_machine_shares_is_told_of_each_bearing():
    bearing = {name: value for name, value in JOURNAL.items() if name != "materials"}
    machine = {"kind": "machine", "name": "M", "materials": JOURNAL["materials"], "bearings": [bearing]}
    (case,) = case_from_dict(machine).problems()
    assert dict(case.given)["Journal material"] == words()["Journal material"]
