"""Dams, steps, crowning, displacement, side pressures and tilt, from the case to the result."""

import math

import numpy as np
import pytest
from film_bearings import GROOVES, answer, film

from babbitt.case import CaseError, case_from_dict, load_case
from babbitt.kinds.journal.film.layout import film_of
from babbitt.reynolds.model import Step

AT = {"effective_temperature": "55 degC", "load": "8 kN"}
DAM = {"kind": "pressure_dam", "angle": "135 deg", "extent": "120 deg", "width": "90 mm", "depth": "0.45 mm"}
TRACK = {"angle": "-90 deg", "extent": "160 deg", "width": "30 mm", "depth": "0.5 mm"}


def layout(**given):
    return film_of(film(**given), 1.5e-3, 0.02, 1e5)


@pytest.mark.parametrize(
    ("speed", "dam", "middle"), [("3000 rpm", "135 deg", 75.0), ("-3000 rpm", "45 deg", 105.0)]
)
def test_the_recess_lies_before_its_dam_in_the_sense_of_rotation(speed, dam, middle):
    recess, track = layout(bore=DAM | {"relief": TRACK, "angle": dam}, speed=speed).steps
    assert math.degrees(recess.centre_angle) == pytest.approx(middle)
    assert (recess.axial_length, recess.depth) == pytest.approx((0.09, 4.5e-4))
    assert track == Step(pytest.approx(-math.pi / 2), pytest.approx(math.radians(160)), 0.03, 5e-4)


@pytest.mark.parametrize(
    ("given", "speed", "says"),
    [
        ({}, "-3000 rpm", r"runs over grooves\[1\] onto another land, as the journal turns clockwise"),
        ({"extent": "150 deg"}, "3000 rpm", r"runs over grooves\[0\].* up to 145 deg"),
        ({"angle": "175 deg"}, "3000 rpm", r"the dam lies in grooves\[1\]"),
    ],
)
def test_a_recess_stays_on_its_land(given, speed, says):
    film(bore=DAM | {"extent": "145 deg"})  # as far as to the groove
    with pytest.raises(CaseError, match=says):
        film(bore=DAM | given, speed=speed)


def test_a_pressure_dam_pushes_the_journal_deeper_and_against_whirl():
    light = AT | {"load": "2 kN"}
    plain, dam = answer(**light), answer(**light, bore=DAM)
    relieved = answer(**light, bore=DAM | {"relief": TRACK})
    assert plain.eccentricity_ratio < dam.eccentricity_ratio < relieved.eccentricity_ratio
    assert dam.critical_mass > 3.0 * plain.critical_mass
    assert relieved.whirl_frequency_ratio == 0.0  # it cannot whirl
    assert relieved.mass_balance_error < 1e-10


def test_a_dam_for_the_other_sense_is_its_mirror_image():
    # the mirror x -> -x of a bearing with grooves at both sides under a load downward
    one = answer(**AT, bore=DAM)
    two = answer(**AT, bore=DAM | {"angle": "45 deg"}, speed="-3000 rpm")
    for name in ("eccentricity_ratio", "attitude_angle", "total_flow", "stiffness_xx", "critical_mass"):
        assert two.values[name] == pytest.approx(one.values[name], rel=2e-4), name
    assert two.stiffness_xy == pytest.approx(-one.stiffness_xy, rel=2e-3, abs=1e4)


def test_crowning_is_read_in_every_form():
    width = 0.12
    z = np.linspace(-1.0, 1.0, 161)
    np.testing.assert_allclose(
        layout(crowning={"kind": "parabolic", "drop": "10 um"}).crowning, 1e-5 * z**2, atol=1e-12
    )
    edges = np.array(layout(crowning={"kind": "edges", "drop": "10 um", "length": "12 mm"}).crowning)
    assert edges[0] == edges[-1] == pytest.approx(1e-5)
    assert not edges[np.abs(z) * width / 2 < width / 2 - 0.012].any()
    table = layout(crowning={"kind": "table", "drops": ["4 um", "0 um", "8 um"]}).crowning
    assert table == pytest.approx((4e-6, 0.0, 8e-6))


def test_a_displacement_is_read_inline_and_from_a_table_of_any_order(tmp_path):
    angles, places = range(0, 360, 30), (-40, 0, 40)
    values = [[2.0 * math.cos(math.radians(2 * a)) + 0.01 * z for z in places] for a in angles]
    inline = {
        "angles": [f"{a} deg" for a in angles],
        "places": [f"{z} mm" for z in places],
        "values": [[f"{v} um" for v in row] for row in values],
    }
    lines = [f"{a},{z},{values[i][j]}" for i, a in enumerate(angles) for j, z in enumerate(places)]
    lines += [f"360,{z},{values[0][j]}" for j, z in enumerate(places)]
    (tmp_path / "moved.csv").write_text("angle [deg],z [mm],displacement [um]\n" + "\n".join(reversed(lines)))
    case = tmp_path / "case.yaml"
    case.write_text("{kind: journal, name: B, method: film, diameter: 200 mm, width: 120 mm, "
        "clearance: {kind: relative, mean: 1.5 permille}, materials: {bearing: C10, journal: C45}, "
        "lubricant: ISO VG 46, supply: {temperature: 45 degC, pressure: 0.1 MPa}, "
        "grooves: [{angle: 0 deg, extent: 20 deg}], load: 30 kN, speed: 3000 rpm, "
        "displacement: {file: moved.csv}}")  # fmt: skip
    read = load_case(case).displacement.field(0.12)
    given = film(displacement=inline).bearing.displacement
    np.testing.assert_allclose(read, given, atol=1e-15)
    field = np.array(given)
    assert field.shape == (360, 41)
    assert field[30, 20] == pytest.approx(1e-6, rel=1e-9)  # 2 um cos 60 deg, in the mid-plane
    assert field[15, 20] == pytest.approx(1.5e-6, rel=1e-9)  # linear between 0 and 30 deg
    assert field[0, 0] == pytest.approx(1.6e-6, rel=1e-9)  # level beyond the outermost place


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("angle,z,displacement\n", "no heading"),
        ("angle [deg],z [mm],displacement [um]\n0,0,one\n", "line 2"),
        ("angle [deg],z [mm],displacement [um]\n0,0,1\n0,0,2\n", "repeats"),
        ("angle [deg],z [mm],displacement [um]\n0,0,1\n45,0,1\n45,10,1\n", "2 places"),
        ("angle [deg],z [mm],displacement [um]\n" + "".join(f"{a},0,{a}\n" for a in range(0, 361, 45)), "close"),
    ],
)
def test_tables_of_displacement_that_cannot_be_used(tmp_path, text, says):
    (tmp_path / "moved.csv").write_text(text)
    (tmp_path / "case.yaml").write_text("{kind: journal, name: B, displacement: {file: moved.csv}}")
    with pytest.raises(CaseError, match=says):
        load_case(tmp_path / "case.yaml")


def test_a_displacement_that_is_the_same_everywhere_is_clearance():
    wider = {
        "angles": [f"{a} deg" for a in range(0, 360, 45)],
        "places": ["0 mm"],
        "values": [["15 um"]] * 8,
    }
    moved = answer(**AT, displacement=wider)
    psi = moved.operating_relative_clearance
    plain = answer(**AT, clearance={"kind": "relative", "mean": 1.5e-3 + 2 * 15e-6 / 0.2})
    assert moved.minimum_film_thickness == pytest.approx(plain.minimum_film_thickness, rel=2e-3)
    assert psi < plain.operating_relative_clearance


def test_a_side_under_pressure_sends_oil_through_the_bearing():
    open_ = answer(**AT)
    pressed, other = (answer(**AT, side_pressures=sides) for sides in (["0 MPa", "1 MPa"], ["1 MPa", "0 MPa"]))
    assert pressed.total_flow > 1.2 * open_.total_flow
    assert other.total_flow == pytest.approx(pressed.total_flow, rel=1e-9)
    assert pressed.mass_balance_error < 1e-10
    assert any("as warm as" in said for said in pressed.assumptions)


def test_grooves_stand_beside_pockets_and_tilt():
    both = answer(
        **AT, pockets=[{"angle": "90 deg", "extent": "30 deg", "width": "60 mm"}], misalignment={"y": "0.1 mrad"}
    )
    assert both.mass_balance_error < 1e-10
    assert any("2.5 %" in said for said in both.assumptions)
    assert "W121" in {notice.code for notice in both.warnings}
    draft = answer(**AT, accuracy="draft", misalignment={"y": "0.1 mrad"})
    fine = answer(**AT, accuracy="engineering", misalignment={"y": "0.1 mrad"})
    assert draft.supply_flow == pytest.approx(fine.supply_flow, rel=0.06)


def test_coefficients_of_tilt_are_results():
    plain, tilted = answer(**AT), answer(**AT, tilt_coefficients=True)
    assert "tilt_stiffness" not in plain.arrays
    stiffness = np.array(tilted.arrays["tilt_stiffness"])
    assert stiffness.shape == (4, 4)
    np.testing.assert_allclose(stiffness[:2, :2], tilted.stiffness, rtol=0.02)
    assert tilted.tilt_stiffness_yy == stiffness[3, 3]
    # rings of the width side by side: the tilt stiffness is about the stiffness times the square of the arm
    arm = math.sqrt(tilted.tilt_stiffness_yy / tilted.stiffness_yy) / tilted.width
    assert 0.1 < arm < 0.29
    assert tilted.film_moment_y == 0.0
    askew = answer(**AT, tilt_coefficients=True, misalignment={"y": "0.2 mrad"})
    assert askew.film_moment_y < 0.0  # it rights the journal
    assert askew.film_moment_y == pytest.approx(-0.2e-3 * tilted.tilt_stiffness_yy, rel=0.25)


def test_the_standard_knows_none_of_it():
    given = {"kind": "journal", "name": "B", "diameter": "200 mm", "width": "120 mm", "span": "360 deg",
             "clearance": {"kind": "relative", "mean": "1.5 permille"},
             "materials": {"bearing": "C10", "journal": "C45"}, "lubricant": "ISO VG 46",
             "supply": {"temperature": "45 degC", "pressure": "0.1 MPa"}, "load": "30 kN",
             "speed": "3000 rpm"}  # fmt: skip
    assert case_from_dict(given)
    for more in ({"side_pressures": ["0 kPa", "1 kPa"]}, {"tilt_coefficients": True}, {"bore": DAM}):
        with pytest.raises(CaseError, match="ISO 7902 knows"):
            case_from_dict(given | more)
    with pytest.raises(CaseError, match="widest gap"):
        case_from_dict(
            given
            | {"method": "film", "film_start": "widest_gap", "cavitation": "reynolds", "tilt_coefficients": True}
        )


def test_a_groove_around_the_middle_halves_the_bearing():
    """Two halves carry less than one bearing of double their width; the pressure of the groove pushes nowhere."""
    whole = answer(**AT | {"load": "4 kN"}, grooves=GROOVES)
    split = answer(
        **AT | {"load": "4 kN"}, grooves=None, pockets=[{"angle": "0 deg", "extent": "360 deg", "width": "10 mm"}]
    )
    assert split.eccentricity_ratio > whole.eccentricity_ratio
    assert split.mass_balance_error < 1e-10
