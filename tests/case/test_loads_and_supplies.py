"""Where the load points, what the supply must say and what a prescribed temperature does not ask for."""

import math

import pytest

from babbitt.case import CaseError, case_from_dict
from babbitt.core.notices import explanations
from babbitt.core.notices.explanation import Effect
from babbitt.solving import solve

JOURNAL = {
    "kind": "journal",
    "name": "Test",
    "diameter": "80 mm",
    "width": "40 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "span": "180 deg",
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
    "load": "6 kN",
    "speed": "2000 rpm",
}
POCKETS = {"kind": "uneven_pockets", "width": "20 mm", "extent": "20 deg"}


def solved(**changes):
    given = {name: value for name, value in (JOURNAL | changes).items() if value is not None}
    (result,) = solve(case_from_dict(given)).results
    assert result.outcome.solved, result.message
    return result


def uneven(entry, leaving):
    return POCKETS | {"entry_angle": f"{entry} deg", "exit_angle": f"{leaving} deg"}


def test_the_standard_tells_that_it_does_not_know_the_direction():
    downward, aside = solved(), solved(load_angle="-57.9 deg")
    assert "W182" in [one.code for one in aside.warnings]
    assert explanations()["W182"].effect is Effect.INFORMATION
    assert aside.values["load_angle"] == pytest.approx(math.radians(-57.9))
    assert aside.values["minimum_film_thickness"] == downward.values["minimum_film_thickness"]
    assert "W182" not in [one.code for one in solved(load_angle="-90 deg").warnings]


@pytest.mark.parametrize(
    ("speed", "angle", "entry", "leaving"),
    [
        ("2000 rpm", -57.9, 122.1, 57.9),  # from the pocket at 180 deg, in the sense of rotation, to the load
        ("-2000 rpm", -57.9, 57.9, 122.1),
        ("2000 rpm", -120.0, 60.0, 120.0),
        ("2000 rpm", -30.0, 60.0, 120.0),  # an upright joint
    ],
)
def test_a_load_angle_that_agrees_with_uneven_pockets(speed, angle, entry, leaving):
    case = case_from_dict(
        JOURNAL
        | {
            "speed": speed,
            "load_angle": f"{angle} deg",
            "span": "120 deg",
            "supply_element": uneven(entry, leaving),
        }
    )
    assert len(case.problems()) == 1


@pytest.mark.parametrize(
    ("speed", "angle", "fits"),
    [
        ("2000 rpm", -57.9, "entry_angle 122.1 deg and exit_angle 57.9 deg"),
        ("-2000 rpm", -57.9, "entry_angle 57.9 deg and exit_angle 122.1 deg"),
        ("2000 rpm", 45.0, "leave it out"),
    ],
)
def test_a_load_angle_that_contradicts_uneven_pockets(speed, angle, fits):
    given = JOURNAL | {"speed": speed, "load_angle": f"{angle} deg", "supply_element": uneven(75, 104)}
    with pytest.raises(CaseError, match=f"load_angle: with it the uneven pockets stand .*{fits}"):
        case_from_dict(given)
    case_from_dict(given | {"load_angle": "-90 deg"})
    case_from_dict(given | {"method": "film"})  # whose pockets turn with the load, as its report shows


@pytest.mark.parametrize("method", ["iso7902", "film"])
def test_an_unpressurised_feed(method):
    """Nothing is pressed through the film, and the journal stands about where a hint of pressure leaves it."""
    bath, hint = (
        solved(method=method, accuracy="draft", supply={"temperature": "50 degC", "pressure": pressure})
        for pressure in ("0 Pa", "1 kPa")
    )
    assert bath.values["minimum_film_thickness"] == pytest.approx(hint.values["minimum_film_thickness"], rel=2e-3)
    assert bath.values.get("supply_flow", 0.0) == pytest.approx(0.0, abs=1e-12)
    with pytest.raises(CaseError, match="too small; allowed: 0 or 1 kPa to 50 MPa"):
        case_from_dict(JOURNAL | {"supply": {"temperature": "50 degC", "pressure": "0.2 Pa"}})


@pytest.mark.parametrize("method", ["iso7902", "film"])
def test_a_prescribed_temperature_asks_for_no_materials(method):
    """Without materials the clearance is that of shell and journal that expand alike."""
    plain = {"method": method, "accuracy": "draft", "effective_temperature": "60 degC", "supply": None}
    found, alike = solved(materials=None, **plain), solved(materials={"bearing": "C45", "journal": "C45"}, **plain)
    assert found.values["minimum_film_thickness"] == pytest.approx(
        alike.values["minimum_film_thickness"], rel=1e-9
    )
    assert any("No materials of shell and journal" in said for said in found.assumptions)
    with pytest.raises(CaseError, match=r"materials.journal: is missing"):
        case_from_dict(JOURNAL | {"effective_temperature": "60 degC", "materials": {"bearing": "C10"}})
    with pytest.raises(CaseError, match="materials: is missing"):
        case_from_dict({name: value for name, value in JOURNAL.items() if name != "materials"})


def test_grooves_with_pressures_of_their_own_need_no_supply_pressure():
    grooves = [
        {"angle": "0 deg", "extent": "20 deg", "pressure": "0.2 MPa"},
        {"angle": "180 deg", "extent": "20 deg", "pressure": "0.2 MPa"},
    ]
    film = {"method": "film", "accuracy": "draft", "span": None}
    own = solved(grooves=grooves, supply={"temperature": "50 degC"}, **film)
    shared = [{name: value for name, value in one.items() if name != "pressure"} for one in grooves]
    same = solved(grooves=shared, **film)
    for name in ("minimum_film_thickness", "side_flow", "effective_temperature"):
        assert own.values[name] == pytest.approx(same.values[name], rel=1e-9)
    with pytest.raises(CaseError, match=r"supply.pressure: is missing"):
        case_from_dict(
            JOURNAL
            | film
            | {"span": "180 deg", "grooves": [grooves[0], shared[1]], "supply": {"temperature": "50 degC"}}
        )


def test_a_film_that_hardly_carries_lies_below_the_nodes_of_the_tables():
    light, usual = solved(load="4 N", speed="6000 rpm"), solved()
    assert light.values["eccentricity_ratio"] < 0.01 < usual.values["eccentricity_ratio"]
    assert "W119" in [one.code for one in light.warnings]
    assert "W119" not in [one.code for one in usual.warnings]


def test_a_film_colder_than_the_data_of_its_oil_is_told():
    frost, mild = (
        solved(
            method="film",
            thermal="adiabatic",
            load="2 kN",
            speed="100 rpm",
            supply={"temperature": temperature, "pressure": "0.2 MPa"},
        )
        for temperature in ("-20 degC", "20 degC")
    )
    (said,) = [one.message for one in frost.warnings if one.code == "W145"]
    assert "ISO VG 46 is described from 0.0 °C to 120.0 °C" in said
    assert "W145" not in [one.code for one in mild.warnings]
