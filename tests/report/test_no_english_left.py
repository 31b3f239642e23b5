"""Reports in German and Russian: sentences of the program are in the language, those of the case as given."""

from __future__ import annotations

import math
import re
from types import SimpleNamespace

import pytest

from babbitt.case import parse_case
from babbitt.core.language import LANGUAGES, translated_if_known, written_in
from babbitt.core.notices import Notice
from babbitt.core.notices.words import words
from babbitt.core.report_level import Level
from babbitt.kinds.journal.report import film_inputs
from babbitt.report.bearing_content import bearing_content
from babbitt.report.chapters import chapters
from babbitt.report.comparison_page import comparison_page
from babbitt.report.comparison_table import told_left_out
from babbitt.report.content import content
from babbitt.report.names import shown_name
from babbitt.report.study_values import reason_text
from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN
from babbitt.solving import solve
from babbitt.study.comparison import compare_methods

OTHERS = [one for one in LANGUAGES if one != "en"]
ENGLISH = re.compile(
    r"\b(the|of|and|with|is|are|not|for|from|by|which|that|only|at|to|long|wide|deep|after|closed|tube|journal)\b"
)
"""Words that no German or Russian sentence has."""

FILM = """
kind: journal
name: Pinion
method: {kind: film, accuracy: draft, TURBULENCE}
diameter: 120 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5 permille}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
materials: {bearing_metal: SnSb8Cu4, bearing: C10, journal: C45}
surfaces: {kind: direct, roughness_bearing: 4 um, roughness_journal: 2 um}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 50 kPa}
load: 12 kN
speed: 1500 rpm
"""
OWN = (
    "Bush, housing and shaft are not published: sizes are those of an ordinary gearbox.",
    "The housing conducts heat as the bush does.",
    "Load of the left side, weight",
)
"""Of a case: in the form of a known sentence, a known sentence, in the form of a known label."""


def film(more: str, turbulence: str = "turbulence: laminar"):
    said = "".join(f'\n  - "{one}"' for one in OWN)
    return parse_case(f"{FILM.replace('TURBULENCE', turbulence)}{more}\nassumptions:{said}\n")


def english_left(lines) -> list[str]:
    titles = r"(Ng, Pan, |Constantinescu, ).*"  # of publications
    return [one for one in lines if ENGLISH.search(re.sub(titles, "", one))]


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize(
    ("more", "turbulence"),
    [
        ("bore: {kind: lobes, preload: 0.4}", "turbulence: ng_pan"),
        ("bore: {kind: taper_land, depth: 30 um, share: 0.8}\nmixed_friction: {}", "turbulence: laminar"),
        ("", "thermal: full"),
    ],
    ids=["lobes and turbulence", "tapers and asperities", "heat"],
)
def test_inputs_and_assumptions_of_films_have_words(more, turbulence, language, no_images):
    machine = solve(film(more, turbulence))
    (part,) = chapters(machine.solutions)
    with written_in(language) as missing:
        made = bearing_content(part, own_words=OWN)
    assert not list(missing)
    assumed = made["assumptions"]
    assert [one for one in assumed if one in OWN] == list(OWN)
    rows = [text for group in made["inputs"] for row in group["rows"] for text in (row["label"], row["value"])]
    assert not english_left([one for one in assumed if one not in OWN] + rows)


@pytest.mark.parametrize("language", OTHERS)
def test_what_a_case_assumes_stays_in_its_words(language, no_images):
    machine = solve(film(""))
    with written_in(language):
        made = content(machine, Level.STANDARD)
        page = comparison_page(compare_methods(film("misalignment: {x: 0.1 mrad, y: 0.1 mrad}")))
    assert set(OWN) <= {*made["bearings"][0]["assumptions"], *made["shared_assumptions"]}
    for one in OWN:
        assert one in page


NAMES = ("laminar film", "oil film too hot", "film, Reynolds", "ISO VG 46; general value")
"""Of oils and sources: texts of the program, or in their form."""


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("name", NAMES)
def test_the_name_and_the_source_of_an_oil_stay(language, name, no_images):
    oil = f'{{kind: two_points, name: "{name}", nu40: 46 mm2/s, nu100: 6.8 mm2/s, source: "{name}"}}'
    machine = solve(
        parse_case(FILM.replace("TURBULENCE", "").replace("lubricant: ISO VG 46", f"lubricant: {oil}"))
    )
    with written_in(language):
        groups = content(machine, Level.STANDARD)["bearings"][0]["inputs"]
        assert [row["value"] for group in groups for row in group["rows"]].count(name) == 2
        assert translated_if_known("laminar film") != "laminar film"  # outside the report of this case


STEP = SimpleNamespace(centre_angle=math.pi, axial_centre=5e-3, extent=1.0, axial_length=0.02, depth=5e-5)
FEEDS = [
    SimpleNamespace(angle=1.0, extent=0.3, is_closed=closed, pressure=pressure, width=width, axial_position=place)
    for closed, pressure in ((False, None), (True, None), (False, 6e4))
    for width, place in ((None, 0.0), (0.03, 0.0), (0.03, 5e-3))
]
TEXTS = [
    *(text for feed in FEEDS for text in film_inputs.describe_feed(feed)),
    film_inputs.describe_step(STEP),
    *map(film_inputs.describe_flow, (None, NG_PAN, CONSTANTINESCU)),
    *(film_inputs.describe_bore(bore) for bore in (
        film_inputs.LobedBore(0.4, 0.5), film_inputs.TaperedBore(3e-5, 0.8), film_inputs.WornBore(3e-5, 1.0),
    )),
    "2 tubes in parallel, each tube d = 8 mm, l = 1 m, ζ = 1.5",
    "Liner of 20 um/MPa: every spot of it gives way by itself.",
    "Elastic ring up to 200 mm, free outside, in plane strain under the mean pressure over the width; positions "
    "of the journal count from the shifted centre of its bore.",
    "Viscosity grows with pressure after Barus, 20 1/GPa at ambient pressure.",
]  # fmt: skip


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("text", dict.fromkeys(TEXTS))
def test_every_form_of_an_input_has_words(text, language):
    with written_in(language):
        said = translated_if_known(text)
    assert said != text or text == "laminar" or not re.search("[A-Za-z]{4}", text)
    assert not english_left([said])


REASONS = [
    "ISO 7902 is left out: it knows round bores only, not lobes",
    "long film is left out: it knows laminar films only",
    "ISO 7902 is left out: it needs the angular span of the loaded arc; give span, such as 'span: 180 deg'",
]


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("line", REASONS)
def test_the_reason_why_a_method_is_left_out_is_told(line, language):
    with written_in(language):
        said = told_left_out(line)
    assert "(" in said
    assert not english_left([said])
    assert told_left_out(line) == line


def test_a_reason_without_words_is_not_told_in_english():
    with written_in("de"):
        assert told_left_out("ISO 7902 is left out: no such reason") == "ausgelassen: ISO 7902"


def test_the_oil_system_has_a_name_in_the_language():
    with written_in("de"):
        assert shown_name("Oil system of Gear") == "Ölsystem von Gear"
    assert shown_name("Oil system of Gear") == "Oil system of Gear"


REFUSALS = [
    "case: diameter: -0.001 is too small; allowed: 1 mm to 3 m [E003]",
    "case: speed: 0.0 is too small; allowed: 0.1 rpm to 1000000 rpm, with either sign [E003]",
    "case: width: width 1 mm is 0.00833 of the diameter; allowed: 12 mm to 180 mm (B/D 0.1 to 1.5) [E004] "
    "case: supply_element.width: the pocket reaches outside the bearing: 40 mm in a width of 1 mm; allowed: less "
    "than 1 mm [E004]",
    "case: supply.temperature: the supply, 200 degC, is not cooler than the end of the data of ISO VG 46, "
    "120 degC; allowed: less than 120 degC [E004]",
    "case: lubricant: a sentence that is not known [E005]",
]


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("message", REFUSALS)
def test_a_row_that_is_refused_says_why(message, language):
    with written_in(language):
        said = reason_text(message, "", "refused")
    assert not english_left([said])
    assert re.findall(r"\[E\d+\]", said) == re.findall(r"\[E\d+\]", message)
    assert reason_text(message, "", "refused") == message


def test_a_row_without_a_solution_says_why():
    values = dict.fromkeys(words().placeholders("S001", "carries"), 0.25)
    with written_in("de"):
        said = reason_text(Notice("S001", "carries", values).sentence(), "S001", "overloaded")
        assert said == Notice("S001", "carries", values).message
    assert not english_left([said])
