"""Reports in German and Russian: no word is lacking, numbers are those of the English report."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import pytest
from matplotlib.text import Text

import babbitt
from babbitt.case import load_case, parse_case
from babbitt.case.kinds import template
from babbitt.case.parts.title_block import TitleBlock
from babbitt.case.study_file import load_study
from babbitt.core.kind import kinds
from babbitt.core.language import LANGUAGES, composed, folders, phrases, plural, read_words, translated, written_in
from babbitt.core.notices import InputError, Notice
from babbitt.core.notices import words as loader
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.shaft_lines import SHAFT_LINES
from babbitt.core.quantities.shafts import SHAFTS
from babbitt.core.quantities.thrust import THRUST
from babbitt.core.report_level import Level
from babbitt.kinds.hydrostatic import sweeps
from babbitt.kinds.hydrostatic.report.words import HYDROSTATIC_WORDS
from babbitt.kinds.journal.report.key_results import KEY_RESULTS
from babbitt.kinds.journal.report.stribeck import stribeck
from babbitt.kinds.journal.report.words import JOURNAL_WORDS
from babbitt.kinds.shaft.report.words import SHAFT_WORDS
from babbitt.kinds.thrust.report.sentences import answers
from babbitt.kinds.thrust.report.words import THRUST_WORDS
from babbitt.kinds.tilting_pad_journal.report.words import PAD_WORDS
from babbitt.kinds.tilting_pad_journal.view import KEY_RESULTS as PAD_RESULTS
from babbitt.report.bearing_content import NOT_FOR_PAPER, calculation_content, figures_content, sketch_content
from babbitt.report.chapters import chapters
from babbitt.report.content import content
from babbitt.report.document import TEMPLATES, report, write_report
from babbitt.report.figure_words import translate_figure
from babbitt.report.labels import SHORT, label
from babbitt.report.study_document import report_content
from babbitt.solving import solve
from babbitt.study.plan import plan
from babbitt.study.study import run_study

EXAMPLES = Path(babbitt.__file__).parents[2] / "examples"
GEAR = EXAMPLES / "marine_reverse_gear.yaml"
OTHER_CASES = {
    "thrust": lambda: babbitt.parse_case(template("thrust")),
    "thrust_line": lambda: babbitt.parse_case(template("thrust_line").replace("# speeds:", "speeds:")),
    "trawler": lambda: load_case(EXAMPLES / "trawler_thrust_line.yaml"),
    "shaft": lambda: babbitt.parse_case(template("shaft")),
    "overhung_coupling": lambda: babbitt.parse_case(template("overhung_coupling")),
}
"""Of other kinds: templates, which say the same as examples of theirs, and examples."""
OTHERS = [one for one in LANGUAGES if one != "en"]
NOT_TEXT = {"svg", "symbol", "formula", "substituted", "number", "words", "hash", "language", "heading", "spoken"}


@pytest.fixture(scope="module")
def gear():
    return babbitt.load_case(GEAR).solve().machine


def said_in(machine, language):
    """The content of the report in a language, what its calculation and figures add, and what is missing."""
    with written_in(language) as missing:
        first, *_ = chapters(machine.solutions)
        made = {
            "report": content(machine, Level.STANDARD),
            "lines": [calculation_content(part) for part in chapters(machine.solutions)],
            "figures": figures_content(first),
            "sketch": sketch_content(first),
        }
    return made, missing


def texts(data, path: tuple = ()) -> Iterator[tuple[tuple, str]]:
    if isinstance(data, str):
        yield path, data
    elif isinstance(data, dict):
        for key, part in data.items():
            if key not in NOT_TEXT:
                yield from texts(part, (*path, key))
    elif isinstance(data, list | tuple):
        for place, part in enumerate(data):
            yield from texts(part, (*path, place))


def lacks_no_word(machine):
    """Hold the texts of every language against the English ones, and look for English inputs in the Russian."""
    ours = dict(texts(said_in(machine, "en")[0]))
    for language in OTHERS:
        made, missing = said_in(machine, language)
        assert not list(missing)
        theirs = dict(texts(made))
        assert ours.keys() == theirs.keys()
        for path, text in ours.items():
            assert numbers(text) == numbers(theirs[path]), path
        if language == "ru":
            of_case = [text for path, text in theirs.items() if {"inputs", "assumptions"} & {*path}]
            assert of_case
            assert not [text for text in of_case if re.search("[A-Za-z]{4,}", text)]


def numbers(text: str) -> Counter[str]:
    plain = text.replace("1/min", "rpm").translate(str.maketrans("²³−", "23-")).replace("\u2009", "")
    return Counter(re.findall(r"\d+(?:\.\d+)?", re.sub(r"(?<=\d),(?=\d)", ".", plain)))


@pytest.fixture(scope="module")
def english(gear):
    return said_in(gear, "en")[0]


def says_the_same(english, machine, language) -> int:
    """Hold a report against the English one; the number of its texts."""
    made, missing = said_in(machine, language)
    assert not list(missing)
    return have_the_same_numbers(english, made)


def have_the_same_numbers(english, made) -> int:
    ours, theirs = dict(texts(english)), dict(texts(made))
    assert ours.keys() == theirs.keys()
    for path, text in ours.items():
        assert numbers(text) == numbers(theirs[path]), path
    return len(ours)


@pytest.mark.parametrize("language", OTHERS)
def test_the_reverse_gear_lacks_no_word_and_has_the_same_numbers(gear, english, language):
    assert says_the_same(english, gear, language) > 2000


@pytest.mark.usefixtures("no_images")
@pytest.mark.parametrize("name", OTHER_CASES)
def test_other_kinds_lack_no_word_and_have_the_same_numbers(name):
    machine = solve(OTHER_CASES[name]())
    own = said_in(machine, "en")[0]
    for language in OTHERS:
        assert says_the_same(own, machine, language) > 30


@pytest.mark.parametrize("language", OTHERS)
def test_answers_of_a_shaft_line_in_every_case_are_known(language):
    (found,) = solve(babbitt.parse_case(template("thrust_line").replace("# speeds:", "speeds:"))).results
    first = 2.0 * math.pi * 9.0
    modes = {"damped_modes": ((0.0, 1.2, 1.0),), "response_peaks": (), "barred_ranges": ()}
    peaks = {"damped_modes": ((1.1 * first, 0.1, 1.0),), "response_peaks": ((first, 3.2, 0.0),)}
    barred = {
        "barred_ranges": ((6.2, 7.0, 4.0), (8.0, 9.0, 4.0), (10.0, 14.7, 8.0)),
        "campbell": ((6.3,), (14.6,)),
    }
    touching = tuple(replace(one, value=-1e-6) if one.code in ("C202", "C203") else one for one in found.checks)
    thin = tuple(replace(one, value=5e-6) if one.code == "C202" else one for one in found.checks)
    axial = replace(found.checks[0], code="C205", quantity="axial_amplitude", limit=1e-3)
    moved = dict.fromkeys(
        ("nonlinear_load_peak", "nonlinear_unload_peak", "nonlinear_minimum_film", "mean_film_shift"), 1e-5
    )
    none = {"admissible_runout": 0.0, "admissible_tilt": 0.0, "frequency_separation": 0.1}
    without = {name: one for name, one in found.values.items() if name not in ("best_ring_loss", *none)}
    open_end = {
        "admissible_runout_ends": "no limit below 100 µm",
        "admissible_tilt_ends": "no limit below 122880 µm",
    }
    cases = (
        found,
        replace(found, arrays={**found.arrays, **modes, "campbell": ()}, checks=touching),
        replace(found, arrays={**found.arrays, **peaks, **barred}, checks=thin),
        replace(found, values={**found.values, **none, **moved}, warnings=(Notice("W205", "outside"),)),
        replace(found, values=without, settings={**found.settings, **open_end}, checks=(*found.checks, axial)),
        replace(found, values={**found.values, "loss_mean_bound": 0.0}),
    )
    for case in cases:
        with written_in(language) as missing:
            said = [translated(sentence) for sentence in answers(case)]
        assert not list(missing)
        assert not [one for one in said if re.search(r"\b(the|is|are|of|pads?|no|that|limit)\b", one)]


RECESSED = ("hydrostatic_pad", "hydrostatic_thrust_ring", "hydrostatic_journal", "jacking_pocket")


@pytest.fixture
def words_alone(no_images):
    """Curves are the same in every language, and pictures take most of the time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sweeps, "over_gap", cache(sweeps.over_gap))
        yield


@pytest.mark.parametrize("method", ["film", "quick"])
@pytest.mark.parametrize("kind", RECESSED)
def test_templates_of_recessed_bearings_lack_no_word(kind, method, words_alone):
    case = re.sub(r"(?m)^method: film", f"method: {method}", kinds()[kind].read_template())
    lacks_no_word(solve(babbitt.parse_case(case)))


@pytest.mark.parametrize("name", ["spindle_bearing", "jacking_pocket", "thrust_pad"])
def test_examples_of_recessed_bearings_lack_no_word(name, words_alone):
    lacks_no_word(solve(babbitt.load_case(EXAMPLES / f"{name}.yaml")))


@pytest.mark.parametrize(
    "restrictor",
    [
        "{kind: capillary, diameter: 0.6 mm, length: 60 mm, tubes: 3, entry_loss: 2.24, check_valve: true}",
        "{kind: orifice, diameter: 0.4 mm, discharge: 0.62}",
        "{kind: slot, width: 10 mm, gap: 0.1 mm, length: 20 mm}",
        "{kind: constant_flow, flow: 0.25 L/min, leakage: 0.001 L/(min MPa)}",
        "{kind: metered_flow, flow: 0.25 L/min}",
        "{kind: flow_valve, flow: 0.2 L/min, gain: 0.01 L/(min MPa), open_conductance: 0.5 L/(min MPa)}",
        "{kind: membrane_valve, conductance: 0.03 L/(min MPa), compliance: 0.2 1/MPa}",
    ],
)
def test_every_restrictor_has_words(restrictor, words_alone):
    case = kinds()["hydrostatic_pad"].read_template().replace("method: film", "method: quick", 1)
    case = re.sub(r"(?m)^restrictor: .*$", f"restrictor: {restrictor}", case)
    lacks_no_word(solve(babbitt.parse_case(case)))


@pytest.mark.parametrize("language", OTHERS)
def test_numbers_in_a_row_are_apart_where_their_sign_is_a_comma(language):
    case = kinds()["hydrostatic_thrust_ring"].read_template().replace("first: 45 deg", "first: 22.5 deg")
    machine = solve(babbitt.parse_case(case.replace("method: film", "method: quick", 1)))
    with written_in(language):
        groups = content(machine, Level.STANDARD)["bearings"][0]["inputs"]
    assert "22,5; 112,5; -157,5; -67,5" in [row["value"] for group in groups for row in group["rows"]]


OF_KINDS = {
    "tilting_pad_journal": (
        "turbine_tilting_pads",
        "compressor_stability",
        "compressor_tilting_pads",
        "flexure_pivot",
    ),
}  # fmt: skip
"""Examples of kinds of bearings beside the reverse gear."""


@pytest.mark.usefixtures("no_images")
@pytest.mark.parametrize(
    ("kind", "example"), [(kind, name) for kind, names in OF_KINDS.items() for name in ("", *names)]
)
def test_templates_and_examples_lack_no_word_and_have_the_same_numbers(kind, example):
    machine = solve(load_case(EXAMPLES / f"{example}.yaml") if example else parse_case(template(kind)))
    english = content(machine, Level.FULL)
    for language in OTHERS:
        with written_in(language) as missing:
            made = content(machine, Level.FULL)
        assert not list(missing)
        have_the_same_numbers(english, made)


OF_STUDIES = {
    "a size over choices": "{kind: size, vary: {clearance: [H7/e7, H7/d8]}, over_tolerance: true}",
    "a size that is not permitted": "{kind: size, vary: {load: {range: [100 kN, 200 kN, 4]}}}",
    "a size that has no solution": "{kind: size, vary: {supply.temperature: [58 degC, 400 degC]}}",
    "a map that is not permitted": "{kind: map, vary: {load: [100 kN, 200 kN], speed: [900 rpm, 1000 rpm]}}",
    "rows that are refused": "{kind: sweep, vary: {span: [360 deg, 400 deg], lubricant: [ISO VG 32]}}",
    "laws": "{kind: tolerance, vary: {surfaces.tilt_offset: {half_normal: 1 um}, "
    "surfaces.roughness_bearing: [4 um, 5 um]}, samples: 9}",
    "a share": "{kind: sweep, vary: {'*.load': {range: [0.2, 1, 3]}}}",
    "a best design": "{kind: optimise, vary: {width: {uniform: [45 mm, 60 mm]}}, "
    "minimise: [friction_power], population: 4, generations: 1}",
}
"""Studies of what the examples have not: choices, what misses or has no answer."""


@pytest.mark.parametrize(
    "study",
    [*sorted(one.stem for one in (EXAMPLES / "studies").glob("*.yaml") if one.stem != "bearing"), *OF_STUDIES],
)
def test_reports_of_studies_lack_no_word_and_have_the_same_numbers(study, words_alone, tmp_path):
    file = EXAMPLES / "studies" / f"{study}.yaml"
    if study in OF_STUDIES:
        case = (EXAMPLES / "studies" / "bearing.yaml").read_text(encoding="utf-8")
        file = tmp_path / "study.yaml"
        file.write_text(f"{case}\nstudy: {OF_STUDIES[study]}\n", encoding="utf-8")
    read = load_study(file)
    found = run_study(plan(read.case, read.study))
    english = report_content(found)
    for language in OTHERS:
        with written_in(language) as missing:
            made = report_content(found)
        assert not list(missing)
        have_the_same_numbers(*(without_reasons(one, english) for one in (english, made)))
        if language == "ru":
            told = [text for path, text in texts(made) if path[0] in ("overview", "tables", "figures")]
            assert not [text for text in told if re.search(ENGLISH_WORDS, text)]


def without_reasons(made, english):
    """What is told in the same numbers; refusals whose sentence a language does not know name field and code."""
    pairs = zip(made["tables"], english["tables"], strict=True)
    kept = [one for one, own in pairs if not own["title"].startswith("Why rows")]
    return made | {
        "tables": [one | {"notes": one["notes"][:1]} if "kind: map" in made["text"] else one for one in kept]
    }


ENGLISH_WORDS = r"\b(the|of|is|are|and|by|within|limit|row|rows|no|not|values?|margin|case|reason|verdict)\b"


@pytest.mark.parametrize("language", OTHERS)
def test_numbers_have_a_decimal_comma_and_speeds_no_english_unit(gear, language):
    made, _ = said_in(gear, language)
    first = made["report"]["bearings"][0]
    assert first["results"][0]["values"] == ["1,24"]
    said = [text for path, text in texts(made) if path[-1] in ("value", "limit", "unit", "margin")]
    assert not [text for text in said if re.fullmatch(r"[+−-]?\d+\.\d+\D*", text) or "rpm" in text]
    assert {text for text in said if "/min" in text}


@pytest.mark.parametrize("language", OTHERS)
def test_templates_lack_no_word(language):
    said = set()
    for file in TEMPLATES.glob("*.typ"):
        said |= set(re.findall(r'say\(\s*"((?:[^"\\]|\\.)*)"', file.read_text(encoding="utf-8")))
    assert len(said) >= 50
    assert said - phrases(language).keys() == set()


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("folder", [one for one in folders() if read_words(one, "de")], ids=lambda one: one.name)
def test_every_notice_has_a_title_a_remedy_and_messages_with_the_same_values(folder, language):
    entries, messages = loader._read(folder, "en")
    own_entries, own_messages = loader._read(folder, language)
    wanted = {code: {"title", "remedy"} & set(texts) for code, texts in entries.items() if code[0] != "E"}
    assert not {code for code, keys in wanted.items() if keys - set(own_entries.get(code, ()))}
    assert own_entries.keys() <= entries.keys()
    assert own_messages.keys() == {key for key in messages if key[0][0] != "E"}
    for key, said in own_messages.items():
        find = loader.PLACEHOLDER.findall
        assert sorted(find(said)) == sorted(find(messages[key])), key


@pytest.mark.parametrize("language", OTHERS)
def test_no_text_is_translated_in_two_ways(language):
    """All folders are one dictionary: which of two stands in a report would go by their order."""
    found = {}
    for folder in folders():
        for table in ("phrases", "composed"):
            for text, said in read_words(folder, language).get(table, {}).items():
                assert found.setdefault((table, text), said) == said


@pytest.mark.parametrize("folder", list(folders()), ids=lambda one: one.name)
def test_all_languages_have_the_same_phrases_with_the_same_placeholders(folder):
    first, *others = (read_words(folder, language) for language in OTHERS)
    for other in others:
        for table in ("phrases", "composed", "plurals"):
            assert first.get(table, {}).keys() == other.get(table, {}).keys(), table
    for words in (first, *others):
        for table in ("phrases", "composed"):
            for text, said in words.get(table, {}).items():
                wanted = {name.partition(":")[0] for name in re.findall(r"\{([\w:]+)\}", text)}
                assert set(re.findall(r"\{(\w+)\}", said)) == wanted, text


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize(
    ("kind", "results", "words"),
    [("journal", KEY_RESULTS, JOURNAL_WORDS), ("tilting_pad_journal", PAD_RESULTS, PAD_WORDS)],
    ids=lambda one: one if isinstance(one, str) else "",
)
def test_quantities_have_names(language, kind, results, words):
    with written_in(language) as missing:
        for name in (*results, *(one.name for one in words)):
            label(name, kind)
    assert not list(missing)


@pytest.mark.parametrize("language", OTHERS)
def test_quantities_of_recessed_bearings_have_names(language):
    with written_in(language) as missing:
        for one in HYDROSTATIC_WORDS:
            label(one.name, "hydrostatic_pad")
        for kind in RECESSED:
            for name in kinds()[kind].load_meanings():
                if name not in NOT_FOR_PAPER:
                    label(name, kind)
    assert not list(missing)


@pytest.mark.parametrize("language", OTHERS)
def test_quantities_of_other_kinds_have_names(language):
    kinds = {"thrust": (*THRUST, *THRUST_WORDS), "thrust_line": SHAFT_LINES, "shaft": (*SHAFTS, *SHAFT_WORDS)}
    with written_in(language) as missing:
        for kind, quantities in kinds.items():
            for one in quantities:
                label(one.name, kind)
    assert not list(missing)


@pytest.mark.parametrize("language", OTHERS)
def test_pdf_is_tagged_in_its_language(gear, language):
    with written_in(language):
        made = report(gear, "pdf", Level.SUMMARY)
    assert b"pdfuaid:part" in made
    assert re.search(rf"/Lang ?\({language}\)".encode(), made)


def test_a_text_without_words_stays_english_and_is_named(gear, tmp_path, monkeypatch):
    known = phrases("de")
    monkeypatch.setattr(
        "babbitt.core.language.phrases",
        lambda language_code: {k: v for k, v in known.items() if k != SHORT["load_capacity"]},
    )
    with written_in("de") as missing:
        assert label("load_capacity") == "Load at the least gap"
    assert list(missing) == ["Load at the least gap"]


def test_language_of_the_case_and_of_the_call(gear, tmp_path):
    german = replace(gear, title_block=TitleBlock(language="de"))
    write_report(german, tmp_path / "a.html", "summary")
    write_report(german, tmp_path / "b.html", "summary", language="ru")
    a, b = ((tmp_path / name).read_text(encoding="utf-8") for name in ("a.html", "b.html"))
    assert "Kleinste Schmierfilmdicke" in a
    assert "Наименьшая толщина плёнки" in b
    with pytest.raises(InputError, match="language"):
        write_report(gear, tmp_path / "c.html", language="fr")
    assert not (tmp_path / "c.html").exists()


def test_plurals_and_composed_texts():
    with written_in("ru"):
        assert [plural("bearing", n) for n in (1, 2, 5, 11, 21, 112)] == [
            "подшипник", "подшипника", "подшипников", "подшипников", "подшипник", "подшипников",
        ]  # fmt: skip
    with written_in("de"):
        assert translated("mean 395.75 µm") == "Mittel 395,75 µm"
    assert all("{" in text for text in composed("de"))


@pytest.mark.parametrize("language", OTHERS)
def test_speeds_in_a_stribeck_curve_have_the_unit_of_the_language(language):
    speeds = [10.0, 30.0, 100.0]
    rows = [(speed, 0.01, 0.005, 0.2, 1e-6) for speed in speeds]
    known = {"angular_speed": 50.0, "mixed_friction_coefficient": 0.01, "asperity_load_share": 0.2}
    known |= {"composite_roughness": 1e-6, "film_parameter": 1.0}
    result = SimpleNamespace(arrays={"stribeck": rows}, values={"transition_speed": 40.0}, **known)
    with written_in(language):
        figure = stribeck(result)
        translate_figure(figure)
    (said,) = figure.axes[0].texts
    assert "382" in said.get_text()
    assert not [one.get_text() for one in figure.findobj(Text) if "rpm" in one.get_text()]


def test_a_notice_is_written_in_the_language_when_it_is_shown():
    notice = Notice("W109", values={"surface_speed": 45.0, "limit": 20.0})
    with written_in("de"):
        assert notice.message == "Gleitgeschwindigkeit 45,00 m/s > 20 m/s"
    assert notice.message == "surface speed 45.00 m/s > 20 m/s"
    assert QUANTITIES["surface_speed"].format(45.5) == "45.50"


def test_letters_without_a_typeface_cost_the_claim_of_the_standard_alone(gear):
    made = report(replace(gear, name="轴承 \U0001f600"), "pdf", Level.SUMMARY)
    assert made.startswith(b"%PDF")
    assert b"/StructTreeRoot" in made


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_reverse_gear_takes_26_pages_at_most(gear, language):
    pytest.importorskip("typst")
    with written_in(language):
        made = report(gear, "pdf", Level.STANDARD)
    assert 20 < len(re.findall(rb"/Type\s*/Page\b", made)) <= 26
