"""Files that the page hands out are those of the commands."""

import json
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

from babbitt.app.answer import answer, read
from babbitt.app.answer_markup import cards_markup, findings_markup, verdict_markup
from babbitt.app.coefficients import Speeds, coefficient_file, first_speeds
from babbitt.app.document import CaseDocument
from babbitt.app.maps import fields_file
from babbitt.core.kind import kinds
from babbitt.core.notices import InputError
from babbitt.solving import solve

JOURNAL = kinds()["journal"].read_template()
SVG = "{http://www.w3.org/2000/svg}"


def film(**changes):
    document = CaseDocument(JOURNAL)
    document.change(("method",), {"kind": "film", "accuracy": "draft", "limiting_speeds": False})
    document.change(("supply_element",), None)
    document.change(("grooves",), [{"angle": f"{angle} deg", "extent": "20 deg"} for angle in (0, 180)])
    for name, value in changes.items():
        document.change((name,), value)
    return document.text


def test_the_speeds_begin_about_that_of_the_case():
    document = CaseDocument(film(speed="-1500 rpm"))
    assert first_speeds(document) == Speeds("750 rpm", "2250 rpm")


def test_coefficients_are_those_of_the_command(tmp_path):
    (tmp_path / "case.yaml").write_text(film())
    asked = ["export", "case.yaml", "--format", "json", "--speeds", "500 rpm:1500 rpm:5", "-o", "out.json"]
    subprocess.run([sys.executable, "-m", "babbitt", *asked], cwd=tmp_path, check=True, capture_output=True)
    found = coefficient_file(film(), None, Speeds("500 rpm", "1500 rpm", 5), "json", str(tmp_path / "progress"))
    assert not found.faults
    assert found.name == "coefficients.json"
    assert json.loads(found.content) == json.loads((tmp_path / "out.json").read_text())
    assert found.remarks[0].startswith("5 speeds; ")
    (table,) = found.tables
    place = table.heads.index("k_xy MN/m")
    stiffness = np.array(json.loads(found.content)["tables"][0]["stiffness_N_per_m"])
    assert [1e6 * float(row[place]) for row in table.rows] == pytest.approx(stiffness[:, 0, 1], rel=1e-3)


def test_a_clockwise_journal_is_seen_from_the_other_end(tmp_path):
    found = coefficient_file(
        film(speed="-1500 rpm"), None, Speeds("500 rpm", "1500 rpm", 5), "ross3", str(tmp_path / "progress")
    )
    assert not found.faults
    assert any("from the other end" in one for one in found.remarks)


@pytest.mark.parametrize(
    ("text", "speeds", "says"),
    [
        (JOURNAL, Speeds("500 rpm", "1500 rpm"), "method: film"),
        (film(), Speeds("500 kg", "1500 rpm"), "speeds"),
        (film(), Speeds("1500 rpm", "500 rpm"), "do not rise"),
        (film(), Speeds("500 rpm", "1500 rpm", 2), "at least 5"),
        ("kind: journal\n", Speeds("500 rpm", "1500 rpm"), ""),
    ],
)
def test_what_gives_no_coefficients_says_why(text, speeds, says, tmp_path):
    found = coefficient_file(text, None, speeds, "csv", str(tmp_path / "progress"))
    assert found.faults
    assert not found.content
    assert says in " ".join(one.message for one in found.faults)


def test_fields_are_those_of_the_film(tmp_path):
    xarray = pytest.importorskip("xarray")
    (tmp_path / "fields.nc").write_bytes(fields_file(film()))
    (solution,) = solve(read(film())).solutions
    with xarray.open_dataset(tmp_path / "fields.nc", engine="h5netcdf") as found:
        assert float(found["pressure"].max()) == pytest.approx(solution.result.maximum_pressure, rel=1e-3)


def test_a_case_without_film_has_no_fields():
    with pytest.raises(InputError, match="method: film"):
        fields_file(JOURNAL)


def test_the_journal_goes_along_its_orbit():
    load = {"kind": "rotating", "magnitude": "3 kN", "speed_ratio": 1, "moving_mass": "0 kg"}
    text = film(dynamic_load=load)
    (shown,) = answer(text).bearings
    assert shown.moves
    (result,) = solve(read(text)).results
    orbit = np.array(result.arrays["orbit"])
    moved = ElementTree.fromstring(shown.picture).find(f".//{SVG}animateTransform")
    places = np.array([[float(one) for one in place.split()] for place in moved.get("values").split(";")])
    times = [float(one) for one in moved.get("keyTimes").split(";")]
    assert (times[0], times[-1]) == (0.0, 1.0)
    assert np.array_equal(places[0], places[-1])
    path = places[:-1] * [1.0, -1.0]
    assert path == pytest.approx(orbit[:, 1:3] * (np.ptp(path[:, 0]) / np.ptp(orbit[:, 1])), rel=1e-3, abs=1e-4)


def test_no_text_of_a_case_is_markup():
    name = "<img src=x onerror=alert(1)>\"'&"
    found = answer(film(name=name))
    (shown,) = found.bearings
    made = verdict_markup(shown, found) + cards_markup(shown.cards) + findings_markup(shown.findings)
    assert "<img" not in made + shown.picture


def test_a_kept_design_stands_under_each_card():
    first, other = answer(film()), answer(film(load="20 kN"))
    made = ElementTree.fromstring(f"<div>{cards_markup(other.bearings[0].cards, first.bearings[0])}</div>")
    kept = [one.text for one in made.iter() if one.get("class") == "small kept"]
    assert kept == [f"A: {card.value}" for card in first.bearings[0].cards]


def test_symbols_of_cards_have_subscripts():
    (card, *_) = (
        one for one in answer(kinds()["journal"].read_template()).bearings[0].cards if one.symbol == "h_min,st"
    )
    made = ElementTree.fromstring(cards_markup([card]))
    (lower,) = made.iter("sub")
    assert lower.text == "min,st"
    assert f"hmin,st = {card.value}" in "".join(made.itertext())
