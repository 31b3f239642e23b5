"""A bore of one's own by a function: the film of the same table, its name in reports, and refusals."""

from __future__ import annotations

import math
import pickle
import re
import traceback

import numpy as np
import pytest

import babbitt as bb
from babbitt import case as case_language
from babbitt.case import case_hash
from babbitt.solving import solve

GIVEN = {
    "diameter": "200 mm",
    "width": "120 mm",
    "clearance": bb.relative_clearance("1.5 permille"),
    "grooves": bb.grooves(["0 deg", "180 deg"], extent="20 deg"),
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "45 degC", "pressure": "0.15 MPa"},
    "materials": {"bearing": "C10", "journal": "C45"},
    "method": bb.Film(accuracy="draft"),
    "load": "10 kN",
    "speed": "3000 rpm",
    "effective_temperature": "55 degC",
}
WAVES = bb.Gap(lambda angle, z: 5e-6 * np.cos(2 * angle), describe="two waves of 5 um")
CONE = bb.Gap(lambda angle, z: 1e-4 * z, describe="cone of 0.1 mm/m")
WIDER = bb.Gap(lambda angle, z: np.full_like(z, 15e-6), describe="wider by 15 um")


@pytest.fixture(scope="module")
def round_bore():
    return bb.JournalBearing(**GIVEN)


@pytest.fixture(scope="module")
def wavy():
    return bb.JournalBearing(**GIVEN, bore=WAVES)


def inputs_of(case):
    """Labels and values of the input rows of the report."""
    (problem,) = (calculation.problem for calculation in case.calculations())
    from babbitt.kinds.journal.report.inputs import journal_inputs

    return {row.label: row.value for group in journal_inputs(problem) for row in group.rows}


def test_the_function_is_taken_at_every_second_degree_and_from_side_to_side():
    ramp = bb.Gap(lambda angle, z: 1e-6 * angle + z * 1e-4, describe="ramp")
    table = bb.JournalBearing(width="120 mm", method="film", bore=ramp)
    angles, places, values = (np.array(one) for one in (
        table.displacement.angles, table.displacement.places, table.displacement.values
    ))  # fmt: skip
    assert angles == pytest.approx(np.radians(np.arange(0, 360, 2)), abs=1e-15)
    assert places == pytest.approx(np.linspace(-0.06, 0.06, 9), abs=1e-15)
    assert values == pytest.approx(1e-6 * angles[:, None] + 1e-4 * places, abs=1e-20)


def test_it_is_the_case_of_its_table_to_the_last_bit(wavy):
    written = wavy.to_yaml()
    read = case_language.parse_case(written)
    assert read == wavy
    assert case_hash(read) == case_hash(wavy)
    assert solve(read).results[0].minimum_film_thickness == wavy.solve().minimum_film_thickness
    assert hash(pickle.loads(pickle.dumps(wavy))) == hash(wavy)


def test_replacing_the_bore_is_making_it_so(round_bore, wavy):
    assert round_bore.replace(bore=WAVES) == wavy
    lobed = round_bore.replace(bore=bb.Lobes(preload=0.3))
    assert lobed.replace(bore=WAVES) == wavy
    assert wavy.replace(bore=bb.Lobes(preload=0.3)) == lobed
    assert wavy.replace(bore=None) == round_bore
    assert round_bore.replace(bore=CONE).replace(bore=WAVES) == wavy
    assert round_bore.replace(bore=CONE, width="80 mm").displacement.places[-1] == pytest.approx(0.04)


def test_a_bore_that_is_wider_everywhere_is_clearance(round_bore):
    by_table = round_bore.replace(bore=WIDER).solve().minimum_film_thickness
    by_clearance = round_bore.replace(clearance=bb.relative_clearance(1.5e-3 + 2 * 15e-6 / 0.2)).solve()
    assert by_table == pytest.approx(by_clearance.minimum_film_thickness, rel=2e-3)
    assert abs(by_table / round_bore.solve().minimum_film_thickness - 1) > 0.02


def test_the_film_sees_the_waves(wavy):
    """The gap of the kept film less that of the round bore, at its own position."""
    film = wavy.solve().film
    theta = film.angle
    x, y = film.position
    clearance = film.gap[:, 0] + x * np.cos(theta) + y * np.sin(theta) - 5e-6 * np.cos(2 * theta)
    land = np.abs(np.sin(theta)) > math.sin(math.radians(12))
    assert np.ptp(clearance[land]) < 0.01e-6


def test_the_report_does_not_call_it_round(round_bore, wavy):
    assert inputs_of(round_bore)["Form of the bore"] == "round"
    shown = inputs_of(wavy)
    assert shown["Form of the bore"] == "two waves of 5 um"
    assert shown["Departure of the bore from the circle"] == "-5 to 5"
    assert wavy.solve().settings["bore"] == "two waves of 5 um"


def test_the_written_report_names_it(wavy, tmp_path):
    wavy.solve().write_report(tmp_path / "own.html")
    text = re.sub(r"<[^>]+>", " ", (tmp_path / "own.html").read_text(encoding="utf-8"))
    assert re.search(r"Form of the bore\s+two waves of 5 µm", text)
    assert not re.search(r"Form of the bore\s+round", text)


def test_a_displacement_alone_is_none_of_the_bore(wavy):
    table = {name: value for name, value in wavy.given["displacement"].items() if name != "form"}
    displaced = bb.JournalBearing(**GIVEN, displacement=table, bore=bb.Lobes(preload=0.3))
    shown = inputs_of(displaced)
    assert shown["Form of the bore"].startswith("lobes")
    assert shown["Displacement of the gap"] == "-5 to 5"
    for refused in (lambda: bb.JournalBearing(**GIVEN, displacement=table, bore=WAVES),
                    lambda: displaced.replace(bore=WAVES)):  # fmt: skip
        with pytest.raises(bb.CaseError, match="given with a displacement"):
            refused()


@pytest.mark.parametrize(
    ("gain", "says"),
    [
        (lambda angle, z: 5e-6, r"shape \(\)"),
        (lambda angle, z: np.zeros(9), r"shape \(9,\)"),
        (lambda angle, z: np.where(angle > 3, np.nan, 0.0), "gives nan at angle = 3"),
        (lambda angle, z: 1 / 0, "ZeroDivisionError"),
        (lambda angle: angle, "TypeError"),
        (lambda angle, z: angle + 1j, "fails"),
    ],
)
def test_a_function_that_gives_no_table_is_refused(round_bore, gain, says):
    with pytest.raises(bb.CaseError, match=says) as caught:
        round_bore.replace(bore=bb.Gap(gain, describe="odd"))
    assert len(caught.value.problems) == 1


def test_a_function_of_single_numbers_is_called_place_by_place(round_bore):
    def waves(angle, z):
        return 5e-6 * math.cos(2.0 * angle)

    def rounded(angle, z):
        return 5e-6 * math.cos(2.0 * angle) if angle < 10.0 else 0.0

    expected = round_bore.replace(bore=WAVES)
    for gain in (waves, rounded):
        made = round_bore.replace(bore=bb.Gap(gain, describe=WAVES.describe))
        np.testing.assert_allclose(made.displacement.values, expected.displacement.values, rtol=1e-12, atol=1e-20)


def test_a_failing_function_is_named_in_one_message_without_a_chain(round_bore):
    def leaning(angle, z):
        return {"low": 0.0}["high"]

    with pytest.raises(bb.CaseError) as caught:
        round_bore.replace(bore=bb.Gap(leaning, describe="odd"))
    shown = "".join(traceback.format_exception(caught.value))
    assert "KeyError" in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1
    assert shown.count("Traceback") == 1
    for told in ("leaning", "test_own_bore.py, line", "shape (180, 9)", "in m, for every angle"):
        assert told in str(caught.value)
    with pytest.raises(bb.CaseError, match=r"fails at angle = 0 rad, z = -0\.\d+ m.*not callable"):
        round_bore.replace(bore=bb.Gap(5e-6, describe="no function"))


def test_the_width_is_asked_for():
    with pytest.raises(bb.CaseError, match="width, which is missing"):
        bb.JournalBearing(diameter="200 mm", bore=WAVES)
    by_ratio = bb.JournalBearing(diameter="200 mm", width_ratio=0.6, bore=CONE, method="film")
    assert by_ratio.displacement.places[0] == pytest.approx(-0.06)


def test_the_table_is_the_whole_bore(round_bore):
    """Beyond its ends the table would go on level, which is another bore."""
    cone = round_bore.replace(bore=CONE)
    with pytest.raises(bb.CaseError, match="ends at 60 mm"):
        cone.replace(width="140 mm")
    assert round_bore.replace(bore=WAVES).replace(width="140 mm").width == 0.14
    with pytest.raises(bb.CaseError, match="beside another, lobes"):
        bb.JournalBearing(**GIVEN, bore=bb.Lobes(preload=0.3), displacement=cone.given["displacement"])


def test_other_methods_do_not_take_it_for_round(wavy):
    with pytest.raises(bb.CaseError, match="displacement"):
        wavy.replace(method="iso7902", grooves=None, span="180 deg", accuracy=None, effective_temperature=None)


def test_a_bearing_of_a_machine_has_its_own(wavy):
    machine = bb.Machine(bearings=[{**GIVEN, "bore": WAVES}, wavy])
    first, second = machine.bearings
    assert first.displacement == second.displacement == wavy.displacement
