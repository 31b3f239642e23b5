"""Reports of footsteps in German and Russian: no word is lacking, numbers are those of the English report."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from heels import STUDY
from test_languages import OTHERS, numbers, texts

import babbitt
from babbitt.case import parse_case, template
from babbitt.core.language import written_in
from babbitt.core.notices import Notice
from babbitt.kinds.footstep.report import figures
from babbitt.kinds.footstep.report.words import FOOTSTEP_WORDS
from babbitt.report.bearing_content import calculation_content
from babbitt.report.chapters import chapters
from babbitt.report.content import content
from babbitt.report.drawing import style
from babbitt.report.figure_words import translate_figure
from babbitt.report.labels import label
from babbitt.report.meanings import meaning
from babbitt.solving import solve

EXAMPLES = Path(babbitt.__file__).parents[2] / "examples"

UNUSUAL = """
eccentricity_ratio: 0.2
options: {friction_viscosity: mixed, face_outlet: printed, backflow_viscosity: groove, local_loss_coefficient: 1,
  speed_reduction: 0.5}
figures: {map_points: 3}
"""

LIMITS = "mean: 40 um, minimum: 30 um, maximum: 45 um}"

CASES = {
    "template": template("screw_heel"),
    "example": (EXAMPLES / "pump_footstep.yaml").read_text(encoding="utf-8"),
    "metal": (EXAMPLES / "pump_footstep_metal.yaml").read_text(encoding="utf-8"),
    "unusual": STUDY + UNUSUAL,
    "smooth": STUDY.replace("variants: both ", "variants: smooth "),
    "draining": STUDY.replace("1450 rpm", "100 rpm").replace("pressures: absolute ", "pressures: gauge "),
    "fast": STUDY.replace("1450 rpm", "60000 rpm").replace(
        "mean: 20 um}", "mean: 40 um, minimum: 30 um, maximum: 50 um}"
    ),
    "without a state": STUDY.replace("0.63 MPa", "1 MPa"),
    "no metal": template("screw_heel").replace("\nwall:", "\n# wall:").replace("0.101 MPa", "20 kPa"),
}

NAMED = ("bearing", "bearings", "references", "verdict", "level", "words", "case_text")
"""What holds names and publications, or is no text of a report."""


@pytest.fixture(scope="module", autouse=True)
def _few_points():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(figures, "POINTS", 5)
        patch.setattr("matplotlib.figure.Figure.savefig", lambda *_, **__: None)
        yield


@pytest.fixture(scope="module", params=CASES)
def heel(request):
    return solve(parse_case(CASES[request.param]))


@pytest.fixture(scope="module")
def english(heel):
    return dict(texts(content(heel)))


@pytest.mark.parametrize("language", OTHERS)
def test_footsteps_lack_no_word_and_have_the_same_numbers(heel, english, language):
    with written_in(language) as missing:
        theirs = dict(texts(content(heel)))
    assert not list(missing)
    assert english.keys() == theirs.keys()
    for path, text in english.items():
        if path[-1] != "remedy" and heel.results[-1].outcome.solved:  # advice may be shorter
            assert numbers(text) == numbers(theirs[path]), path
    if language == "ru":
        words = [path for path, text in english.items() if re.search("[A-Za-z]{4}", text) and text == theirs[path]]
        assert {english[path] for path in words if not set(path) & set(NAMED)} <= set(own_texts(heel))


def own_texts(heel) -> Iterator[str]:
    yield from (heel.name, heel.source, heel.notes, *heel.own_words)


@pytest.mark.parametrize("language", OTHERS)
def test_quantities_of_footsteps_have_names(heel, language):
    with written_in(language) as missing:
        for name in {name for result in heel.results for name in result.values} - {"wall_time"}:
            label(name, "screw_heel")
            meaning(name, "screw_heel")
        for one in FOOTSTEP_WORDS:
            label(one.name, "screw_heel")
    assert not list(missing)


def test_names_of_states_are_translated():
    machine = solve(parse_case(STUDY))
    (chapter,) = chapters(machine.solutions)
    with written_in("de"):
        titles = [section["title"] for section in calculation_content(chapter)]
        said = content(machine)
    assert titles[3:5] == ["Heißer Zustand: Nut", "Heißer Zustand: Tasche und Stirnspalt"]
    assert said["worst"][0]["bearing"] == "Pump footstep (heißer Zustand)"
    assert said["bearings"][0]["sketch"]["caption"].startswith("Pump footstep (glatter Spurzapfen): Spurzapfen")


def test_a_heel_alone_has_headings_without_a_state():
    (chapter,) = chapters(solve(parse_case(CASES["smooth"])).solutions)
    titles = [section["title"] for section in calculation_content(chapter)]
    assert titles == ["Recess and face gap", "Clearance and balance", "Friction power"]


def test_curves_of_a_draining_groove_have_a_name():
    (case,) = (one.problem for one in solve(parse_case(CASES["draining"])).solutions if one.problem.is_grooved)
    with style(), written_in("de"):
        figure = figures._over_gap(case)
        translate_figure(figure)
    said = {text.get_text() for panel in figure.axes for text in panel.texts}
    assert {"glatt", "Abfluss"} <= said <= {"glatt", "Abfluss", "heiß", "kalt"}


def test_numbers_with_a_comma_stand_apart_by_semicolons_and_fields_stay():
    eccentric = Notice("W170", values={"eccentricities": (0.25, 0.3)})
    unread = Notice("W183", "smooth_heel", {"fields": ("groove", "options.friction_viscosity")})
    assert eccentric.message.endswith("0.25, 0.3")
    with written_in("de"):
        assert eccentric.message.endswith("0,25; 0,3")
        assert unread.message.startswith("groove, options.friction_viscosity: ")
