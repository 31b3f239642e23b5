"""The page in German and Russian: words, fields, answers and tables, with the numbers of the English page."""

import re
import tomllib
from importlib.resources import files

import pytest
from page_cases import FILM, JOURNAL, TEMPLATES, changed

from babbitt.app.answer import answer, compared, report_of
from babbitt.app.answer_markup import cards_markup
from babbitt.app.catalogue import metals, oils
from babbitt.app.designs import side_by_side
from babbitt.app.document import CaseDocument
from babbitt.app.form import Rows, form_of
from babbitt.app.in_language import InLanguage
from babbitt.app.maps import chart_of, maps_of
from babbitt.app.published import published
from babbitt.app.solver import Questions
from babbitt.app.studies import Axis, asked_text, block_of, studied
from babbitt.app.words import field_name, path_name, sections, word
from babbitt.core.kind import kinds
from babbitt.core.language import LANGUAGES, phrases, written_in
from babbitt.export import FORMATS

OTHERS = [one for one in LANGUAGES if one != "en"]
ENGLISH = re.compile(r"\b(the|of|and|with|is|are|not|for|from|by|which|that|only|at|to|load|pass|fail|missed)\b")
"""Words that no German or Russian sentence has."""


def told(found):
    """Everything that a bearing shows."""
    yield from (found.name, found.method, found.verdict, found.governing)
    for card in found.cards:
        yield from (card.label, card.value, card.limit, card.margin)
    for finding in found.findings:
        yield from (finding.title, finding.message, finding.remedy)
    for row in found.rows:
        yield from row
    yield from re.findall(r'>([^<]+)<|aria-label="([^"]*)"', found.picture)


def names_in(items):
    """Names of all fields of a form that are words."""
    for item in items:
        if len(name := str(item.path[-1])) > 1 and not name.isdecimal():
            yield name
        for inside in item.rows if isinstance(item, Rows) else [getattr(item, "items", ())]:
            yield from names_in(inside)


def left(said):
    """What is English, or has a decimal point."""
    return [one for one in map(str, said) if ENGLISH.search(one) or re.search(r"\d\.\d", one)]


@pytest.mark.parametrize("language", OTHERS)
def test_every_word_of_the_page_is_there(language):
    catalogue = tomllib.loads(files("babbitt.app").joinpath("page.toml").read_text(encoding="utf-8"))
    wanted = {*catalogue.pop("sections"), *catalogue.values()}
    wanted |= {kind.description for kind in kinds().values()} | {one.meaning for one in FORMATS.values()}
    assert wanted - phrases(language).keys() == set()


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("kind", TEMPLATES)
def test_the_fields_of_a_form_have_names(kind, language):
    with written_in(language):
        shown = {name: field_name(name) for name in names_in(form_of(CaseDocument(TEMPLATES[kind]).given))}
    lacking = [name for name, said in shown.items() if said == name.replace("_", " ").capitalize()]
    assert [name for name in lacking if f"field {name}" not in phrases(language)] == []  # Radius is Radius


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("kind", TEMPLATES)
def test_an_answer_has_no_english_left_and_the_same_numbers(kind, language):
    english = answer(TEMPLATES[kind])
    with written_in(language) as missing:
        found = answer(TEMPLATES[kind])
    assert not list(missing)
    assert found.bearings
    for ours, theirs in zip(found.bearings, english.bearings, strict=True):
        assert left(told(ours)) == []
        assert (ours.key, ours.verdict_key) == (theirs.key, theirs.verdict_key)
        assert [row[2].replace(",", ".") for row in ours.rows] == [row[2].replace(",", "") for row in theirs.rows]


@pytest.mark.parametrize("language", OTHERS)
def test_tables_of_tabs_have_no_english_left(language, tmp_path):
    block = block_of("sweep", [Axis("speed", "1000 rpm", "2000 rpm", 3)])
    with written_in(language) as missing:
        tables = [*compared(JOURNAL), *side_by_side(JOURNAL, changed(JOURNAL, load="15 kN"))[1]]
        study = studied(asked_text(CaseDocument(JOURNAL).given, block), str(tmp_path / "progress"))
        published()
        heads = [*oils().heads, *metals().heads]
        fields = maps_of(FILM)
    assert not list(missing)
    said = [text for one in tables for row in (one.heads, *one.rows, one.remarks) for text in row]
    own = {"load", "12 kN", "15 kN"}  # as the case has them
    assert left(set(said) - own) == []
    assert left([study.overview, *heads, *(one.meaning for one in fields)]) == []
    assert not ENGLISH.search(study.tables[0].title)
    titles = {chart_of(one, False)["layout"]["coloraxis"]["colorbar"]["title"]["text"] for one in fields}
    assert not {one for one in titles if re.search("pressure|thickness|fraction", one)}


def test_words_are_those_of_the_language_that_is_written():
    assert word("rows_done", done=1, rows=2) == "1 of 2"
    assert field_name("load_angle") == "Load angle"
    with written_in("de"):
        assert word("rows_done", done=1, rows=2) == "1 von 2"
        assert next(iter(sections())) == "Geometrie"
        assert field_name("no_such_field") == "No such field"
        assert path_name(["supply", "temperature"]) == "Zuführung, Temperatur"
        assert path_name(["grooves", 0, "angle"]).split(", ")[1] == "1"
        cards = cards_markup(answer(JOURNAL).bearings[0].cards)
    assert ">bestanden<" in cards
    assert 'class="card pass"' in cards


class Asked(Questions):
    """Answers at once, in this process."""

    def start(self, function, *given, longest=0.0):
        return function(*given)


def test_questions_of_a_page_are_answered_in_its_language():
    assert InLanguage(Asked(), "de").start(answer, JOURNAL).bearings[0].verdict == "bestanden"
    assert InLanguage(Asked(), "en").start(answer, JOURNAL).bearings[0].verdict == "pass"


def test_a_report_is_in_the_language_of_the_page_unless_the_case_says_another():
    with written_in("de"):
        assert "Kleinste Schmierfilmdicke" in report_of(JOURNAL, "html").decode()
        english = report_of(changed(JOURNAL, document={"language": "en"}), "html").decode()
    assert "Kleinste Schmierfilmdicke" not in english
