"""A limit that the case sets is printed beside the value that would hold without it."""

import re

import pytest
from test_left_out import SAID

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.language import LANGUAGES, written_in
from babbitt.core.quantities import displayed_in
from babbitt.report.content import content
from babbitt.solving import solve

OWN = "limits: {minimum_film_thickness: 4 um, temperature: 105 degC, specific_load: 3 MPa}\n"


def checks(text):
    (result,) = solve(parse_case(text)).results
    return {check.code: check for check in result.checks}


def test_a_limit_of_the_case_knows_what_it_stands_for():
    own, general = checks(SAID + OWN), checks(SAID)
    for code in ("C101", "C103", "C104"):
        assert own[code].general == (general[code].limit, general[code].source)
        assert own[code].limit != general[code].limit
        assert general[code].general is None


def test_the_oil_that_leaves_is_told_apart_from_the_hottest_place():
    film = SAID.replace(
        "kind: journal\n", "kind: journal\nmethod: {kind: film, accuracy: draft, thermal: adiabatic}\n"
    )
    film = re.sub("(?m)^(span|supply_element).*\n", "", film) + "grooves: [{angle: 0 deg, extent: 20 deg}]\n"
    found = checks(film + OWN)["C104"]
    assert found.quantity != "outlet_temperature"
    assert found.general[0] == pytest.approx(373.15)
    assert found.general[1].endswith("for the oil that leaves")


def test_a_thrust_bearing_has_the_general_temperature_beside_that_of_the_case():
    given = template("thrust").replace("number: 8", "number: 4").replace("load: 500 kN", "load: 250 kN")
    found = checks(re.sub(r"(?m)^limits:.*$", "limits: {temperature: 110 degC}", given))["C104"]
    assert found.general[0] == pytest.approx(373.15)


@pytest.mark.usefixtures("no_images")
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_prints_both(language):
    machine = solve(parse_case(SAID + OWN))
    with written_in(language) as missing:
        first, *_ = content(machine)["bearings"][0]["sources"]
    assert not list(missing)
    assert ("9.0 µm" if language == "en" else "9,0 µm") in first
    with displayed_in("us"):
        assert "0.354 mil" in content(machine)["bearings"][0]["sources"][0]
