"""The report as PDF and HTML: complete, equal for equal input, and deaf to what a name tries to say."""

from __future__ import annotations

import datetime
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from html.parser import HTMLParser
from io import BytesIO

import gear_cases
import pytest
from hand_made import PUBLISHED, HandMadeMachine, HandMadeProblem, hand_made_result

from babbitt.core.files import writing
from babbitt.core.limited_flow import quantity_held
from babbitt.core.notices import InputError
from babbitt.core.report_level import Level
from babbitt.core.result import Outcome, Result
from babbitt.core.result_name import ResultName
from babbitt.core.solution import Solution
from babbitt.kinds.journal.iso7902 import DesignCase, check
from babbitt.kinds.journal.iso7902.model import PrescribedLoad
from babbitt.report.chapters import chapters
from babbitt.report.check_content import compared_checks, sources_of
from babbitt.report.content import content
from babbitt.report.document import report as typeset_report
from babbitt.report.document import typeset, write_report
from babbitt.report.title_block import title_content

pytest.importorskip("typst")
pytest.importorskip("matplotlib")

report = partial(typeset_report, level=Level.FULL)


@dataclass(frozen=True)
class Solved:
    """What a report reads of a machine."""

    name: str
    problems: tuple[object, ...]
    results: tuple[Result, ...]
    case_hash: str = "ab" * 32
    version: str = "0.1.0"
    case_text: str = ""
    source: str = ""
    notes: str = ""
    own_words: tuple[str, ...] = ()
    title_block: None = None
    given: Mapping[str, frozenset[str]] = field(default_factory=dict)

    @property
    def solutions(self) -> tuple[Solution, ...]:
        return tuple(Solution(*pair) for pair in zip(self.problems, self.results, strict=True))


def solved(name: str, *cases: DesignCase) -> Solved:
    return Solved(name, cases, tuple(check(case) for case in cases))


class Reader(HTMLParser):
    """What a browser would see: the elements, their attributes, the text."""

    def __init__(self, page: bytes) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(page.decode())
        self.close()

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data):
        self.text += data

    def all(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]


def on_page_and_paper(machine: Solved, level: Level = Level.FULL) -> tuple[Reader, bytes]:
    """Both forms of a report, whose figures are drawn once."""
    data = content(machine, level) | {"title": title_content(None, datetime.date(2026, 1, 31))}
    return Reader(typeset(data, "report.typ", "html")), typeset(data, "report.typ", "pdf")


GEAR = gear_cases.gear()
HOSTILE = (
    "<script>alert(1)</script>",
    '#eval("1+1")',
    '#read("/etc/passwd")',
    "$x^2$ \\ * _ ] [ { } ` ~ @ref <label>",
    "</style></head><img src=x onerror=alert(1)>",
    "null",
    "NaN",
    "W" * 400,
    "שלום مرحبا 😀 轴承",
    "/* */ // --- === - + 1.",
    "&lt;b&gt; &amp; &#60;",
    '" onmouseover="alert(1)',
)


@pytest.fixture(scope="module")
def one_page():
    return Reader(report(solved("One bearing", GEAR[0]), "html"))


def test_the_report_has_all_its_parts_in_order(one_page):
    headings = [
        "Operating point",
        "Inputs",
        "Assumptions",
        "Calculation",
        "Checks",
        "Information",
        "Figures",
    ]
    before = one_page.text.partition("Checker's page")[0]
    places = [before.rindex(heading) for heading in headings]
    assert places == sorted(places)
    for said in ("Prepared", "Checked", "Approved", "0.1.0", "ab" * 32, "TP-46 STO upper", "Rotordynamic".lower()):
        assert said in one_page.text


def test_the_page_needs_nothing_else(one_page):
    assert len(one_page.all("img")) == 5
    for image in one_page.all("img"):
        assert image["src"].startswith("data:image/svg+xml;base64,")
        assert len(image["alt"]) > 20
    assert one_page.all("link") == []
    assert one_page.all("script") == []
    assert len(one_page.all("math")) > 50


@pytest.mark.usefixtures("no_figures")
def test_every_bearing_of_the_summary_leads_to_its_part():
    page = Reader(report(solved("Gear", *GEAR[:3]), "html"))
    targets = [link["href"].removeprefix("#") for link in page.all("a")]
    assert len(targets) == 3
    assert set(targets) <= {attributes.get("id") for attributes in page.all("h2")}


@pytest.mark.usefixtures("no_figures")
def test_the_bearings_of_a_machine_stand_side_by_side_as_in_the_published_tables():
    machine = solved("Gear", *GEAR[:3])
    page = Reader(report(machine, "html")).text
    told = page[page.index("side by side") :]
    for result in machine.results:
        row = told[told.index(result.name) :]
        held = result.values.get("starved_effective_temperature")  # of the film that the limits are held against
        celsius = f"{(held or result.effective_temperature) - 273.15:.1f}{'*' if held else ''}"
        shown = [f"{result.empirical_film_limit * 1e6:.1f}", celsius]
        shown += [f"{value * 1e3:.3f}" for value in (result.recommended_relative_clearance,)]
        shown += [f"{result.stability_relative_clearance * 1e3:.3f}"]
        places = [row.index(text) for text in shown]
        assert places == sorted(places), shown
    alone = Reader(report(solved("One", GEAR[0]), "html")).text
    assert "side by side" not in alone


def test_the_numbers_are_those_of_the_result(one_page):
    result = check(GEAR[0])
    for film in (result.minimum_film_thickness, result.starved_minimum_film_thickness):
        assert f"{film * 1e6:.1f}" in one_page.text
    for outlet in (result.outlet_temperature, result.starved_outlet_temperature):
        assert f"{outlet - 273.15:.1f}" in one_page.text
    assert f"{result.starved_outlet_temperature - 273.15:.1f} °C" in one_page.text  # held against the limit


@pytest.fixture
def no_figures(monkeypatch):
    """Figures carry no text of a case; leaving them out saves most of the time."""
    monkeypatch.setattr("babbitt.kinds.journal.report.iso7902_figures.draw", lambda *_: ())


def assert_only_shown(machine, words, times, level):
    """Every text stands on the page so often, and neither page nor paper takes it for more than text."""
    page, paper = on_page_and_paper(machine, level)
    counts = {said: page.text.count(said) for said in words}
    assert {said: count for said, count in counts.items() if count < times} == {}
    assert page.all("script") == []
    assert all(image["src"].startswith("data:image/svg+xml") for image in page.all("img"))
    assert not [key for _, attributes in page.elements for key in attributes if key.startswith("on")]
    assert paper.startswith(b"%PDF-")


@pytest.mark.usefixtures("no_figures")
def test_names_are_shown_as_they_stand():
    bearings = [replace(GEAR[0], name=name, assumptions=(name,)) for name in HOSTILE]
    assert_only_shown(solved("null", *bearings), HOSTILE, 3, Level.STANDARD)


@pytest.mark.usefixtures("no_figures")
@pytest.mark.parametrize("name", HOSTILE)
def test_the_name_of_a_machine_is_shown_as_it_stands(name):
    problem, result = HandMadeProblem("Bearing"), hand_made_result(PUBLISHED[0])
    assert_only_shown(Solved(name, (problem,), (result,)), (name,), 1, Level.SUMMARY)


@pytest.mark.usefixtures("no_figures")
def test_words_of_the_case_file_are_shown_as_they_stand():
    given = tuple((f"Clearance {number}", said) for number, said in enumerate(HOSTILE))
    machine = solved("Words", replace(GEAR[0], given=given))
    lines = "\n".join(f"name: {said}\n  # {said}" for said in HOSTILE)
    together = " ".join(HOSTILE)
    machine = replace(machine, source=together, notes=together, case_text=lines)
    assert_only_shown(machine, HOSTILE, 5, Level.FULL)


@pytest.mark.usefixtures("no_figures")
def test_control_characters_go_and_the_rest_stays():
    name = "a\x1b[2Jb\x00c\u202ed\ne"
    page = Reader(report(solved(name, replace(GEAR[0], name=name)), "html"))
    assert "a[2Jbcd e" in page.text


@pytest.mark.usefixtures("no_figures")
def test_names_of_every_kind_reach_the_report_as_strings_only():
    for name in HOSTILE:
        data = content(solved(name, replace(GEAR[0], name=name, assumptions=(name,))))
        assert data["name"] == name
        assert name in data["bearings"][0]["assumptions"]


@pytest.mark.solves_anew
def test_equal_input_gives_equal_bytes():
    one, other = (content(solved("Twice", GEAR[0]), Level.FULL) for _ in range(2))
    assert one == other
    titled = {"title": title_content(None, datetime.date(2026, 1, 31))}
    for report_format in ("pdf", "html"):
        made = [typeset(data | titled, "report.typ", report_format) for data in (one, other)]
        assert made[0] == made[1]


def test_an_unsolved_bearing_shows_why_and_no_operating_point():
    too_much = replace(GEAR[0], name="Too much", duty=PrescribedLoad(5e7))
    machine = solved("Gear", too_much, GEAR[1])
    assert machine.results[0].outcome is Outcome.OVERLOADED
    page, paper = on_page_and_paper(machine)
    assert "No solution" in page.text
    assert "S001" in page.text
    assert len(page.all("img")) == 5
    part = page.text[page.text.rindex("Too much") :]
    assert "Operating point" not in part[: part.index("First-stage wheel")]
    assert paper.startswith(b"%PDF-")


def test_a_result_without_a_film_has_a_report_of_its_own(monkeypatch):
    monkeypatch.setattr("babbitt.kinds.shaft.report.picture.coupling_picture", lambda _: None)
    values = {"reaction_1": 380.3e3, "reaction_2": 363.8e3, "wall_time": 0.1}
    statics = Result("Output shaft", "overhung_coupling", "statics", Outcome.CONVERGED, values)
    machine = Solved("Output shaft", (HandMadeProblem("Output shaft"),), (statics,))
    page = Reader(report(machine, "html"))
    assert "380.3" in page.text
    assert "wall" not in page.text.lower()
    assert report(machine, "pdf").startswith(b"%PDF-")


@pytest.mark.usefixtures("no_figures")
@pytest.mark.parametrize("name", gear_cases.varied_cases())
def test_every_way_through_the_procedure_can_be_printed(name):
    case = gear_cases.varied_cases()[name]
    page = Reader(report(solved(name, case), "html"))
    assert "Calculation" in page.text
    assert "–e" not in page.text


@pytest.mark.usefixtures("no_figures")
def test_eleven_bearings_on_paper(tmp_path):
    path = tmp_path / "gear.pdf"
    write_report(solved("Marine reverse gear", *GEAR), path)
    assert path.read_bytes().startswith(b"%PDF-")
    assert [file.name for file in tmp_path.iterdir()] == ["gear.pdf"]


# -- what was given, what was not, and what is on the first page -------------------------------------------------


@pytest.mark.usefixtures("no_figures")
def test_inputs_begin_with_the_words_of_the_case():
    words = (("Clearance", "Fit H7/e7"), ("Journal material", "C45"))
    page = Reader(report(solved("Fit", replace(GEAR[0], given=words)), "html"))
    inputs = page.text[page.text.index("Inputs") :]
    places = [inputs.index(said) for said in ("As given", "Fit H7/e7", "C45", "Geometry")]
    assert places == sorted(places)


@pytest.mark.usefixtures("no_figures")
def test_the_case_file_is_an_annex_line_by_line():
    text = "kind: journal\r\n\tname: x\n    speed: 1\x1b[31m rpm\n"
    page = Reader(report(replace(solved("Annex", GEAR[0]), case_text=text), "html"))
    annex = page.text[page.text.index("Case file as read") :]
    assert "kind: journal\n    name: x\n    speed: 1[31m rpm" in annex
    assert "ab" * 32 in annex
    assert len(page.all("pre")) == 1


@pytest.mark.usefixtures("no_figures")
def test_without_a_case_file_there_is_no_annex(one_page):
    assert "Case file as read" not in one_page.text


@pytest.mark.usefixtures("no_figures")
def test_checks_that_could_not_be_made_stand_on_the_first_page_and_with_the_checks():
    bare = replace(GEAR[0], bearing=replace(GEAR[0].bearing, surfaces=None, metal=None))
    machine = solved("Bare", bare, GEAR[1])
    lacking = machine.results[0].not_checked
    assert len(lacking) > 3
    page = Reader(report(machine, "html"))
    first, *rest = page.text.split("Prepared")
    chapter, _ = rest[0].split(GEAR[1].name, 1)
    for part in (first, chapter):
        told = part[part.index("Not checked") :]
        assert all(notice.code in told and notice.message in told for notice in lacking)
    assert f"{len(lacking)} checks not made" in chapter
    assert "that could be checked" in first
    assert "that could be checked" not in Reader(report(solved("Full", GEAR[3]), "html")).text


@pytest.mark.usefixtures("no_figures")
def test_the_first_page_names_every_bearing_that_misses_an_advice():
    """One line for the outlets of the standard, one for those with the limited flow."""
    machine = solved("Gear", *GEAR)
    missing: dict[str, list[str]] = {}
    for result in machine.results:
        for one in result.checks:
            if one.code == "C109" and not one.ok:
                missing.setdefault(one.quantity, []).append(result.name)
    page = Reader(report(machine, "html"))
    lines = [line.split("C1")[0] for line in page.text.split("C109")[1:]]
    everyone = {row[0] for row in gear_cases.GEAR}

    def names(line, those):
        if "all 11 bearings but" in line:
            return all((name in line) != (name in those) for name in everyone)
        return "more" not in line and all(name in line for name in those)

    assert 2 < sum(map(len, missing.values())) < len(GEAR)
    for those in missing.values():
        assert any(names(line, those) for line in lines)


@pytest.mark.usefixtures("no_figures")
def test_the_first_page_sums_up_a_machine():
    machine = solved("Gear", *GEAR[:2])
    flow = 6e4 * sum(result.values[quantity_held(result, "total_flow")] for result in machine.results)
    first = Reader(report(machine, "html")).text.split("Prepared")[0]
    assert f"{flow:.1f}\xa0L/min" in first.split("Total of 2 bearings")[1]
    assert "Total" not in Reader(report(solved("One", GEAR[0]), "html")).text.split("Prepared")[0]


def clearances(case):
    for which, factor in (("minimum", 0.8), ("mean", 1.0), ("maximum", 1.2)):
        bearing = replace(case.bearing, relative_clearance=factor * case.bearing.relative_clearance)
        yield replace(case, name=ResultName(case.name, clearance=which), bearing=bearing)


def test_clearances_stand_side_by_side_and_the_rest_once():
    machine = solved("Gear", *clearances(GEAR[0]), GEAR[1])
    page, paper = on_page_and_paper(machine)
    assert [attributes["id"] for attributes in page.all("h2")] == [
        "bearing-1",
        "bearing-2",
        "checker",
        "references",
    ]
    assert {link["href"] for link in page.all("a")} == {"#bearing-1", "#bearing-2"}
    assert len(page.all("img")) == 2 * 5
    chapter = page.text.split("Prepared")[1].split(GEAR[1].name)[0]
    assert chapter.count("Inputs") == 1
    for result in machine.results[:3]:
        assert f"{result.minimum_film_thickness * 1e6:.1f}" in chapter
        outlet = result.starved_outlet_temperature - 273.15
        assert f"{outlet:.1f} {'≤' if outlet <= 100.0 else '>'} 100.0" in chapter
    rows = compared_checks(chapters(machine.solutions)[0], sources_of(machine.results[:3]))
    for place, result in enumerate(machine.results[:3]):
        assert [row["code"] for row in rows if row["compared"][place]["governs"]] == [result.governing_check.code]
    assert paper.startswith(b"%PDF-")


@pytest.mark.usefixtures("no_figures")
def test_a_clearance_without_operating_point_says_so_beside_the_others():
    *narrow, wide = clearances(GEAR[0])
    stuck = replace(wide, bearing=replace(wide.bearing, relative_clearance=1e-5))
    machine = solved("Gear", *narrow, stuck)
    assert not machine.results[2].outcome.solved
    chapter = Reader(report(machine, "html")).text.split("Prepared")[1]
    assert "Maximum clearance: " in chapter
    assert "No solution" in chapter
    assert f"{machine.results[1].minimum_film_thickness * 1e6:.1f}" in chapter


@pytest.mark.usefixtures("no_figures")
def test_a_narrow_window_scrolls_tables_and_not_the_page(one_page):
    html = report(solved("One", GEAR[0]), "html").decode()
    assert 'name="viewport"' in html
    assert html.count("<table") == html.count('<div class="wide"><table')
    assert ".wide { overflow-x: auto; }" in html
    for who in ("Prepared", "Checked", "Approved"):
        assert f"{who}: name, date, signature" in one_page.text


# -- where it goes ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["report.doc", "report", "report.pdf.txt", ".pdf"])
def test_an_unknown_suffix_is_refused_with_what_is_allowed(tmp_path, name):
    with pytest.raises(InputError, match=r"\.pdf or \.html") as refused:
        write_report(solved("x", GEAR[0]), tmp_path / name)
    assert refused.value.code == "E007"
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_does_not_exist_is_named(tmp_path):
    with pytest.raises(InputError, match=re.escape(str(tmp_path / "no"))) as refused:
        write_report(solved("x", GEAR[0]), tmp_path / "no" / "report.pdf")
    assert refused.value.code == "E007"
    assert list(tmp_path.iterdir()) == []


def test_a_folder_is_no_file(tmp_path):
    (tmp_path / "report.pdf").mkdir()
    with pytest.raises(InputError, match="it is a folder"):
        write_report(solved("x", GEAR[0]), tmp_path / "report.pdf")


def test_a_failure_leaves_what_was_there(tmp_path, monkeypatch):
    path = tmp_path / "report.html"
    path.write_text('<!DOCTYPE html><html><head><meta name="generator" content="Babbitt 0.1.0"></head>')
    before = path.read_text()

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(writing.Path, "replace", full)
    with pytest.raises(InputError, match="No space left"):
        writing.write_file(path, b"after")
    assert path.read_text() == before
    assert [file.name for file in tmp_path.iterdir()] == ["report.html"]


def test_a_written_file_has_ordinary_permissions(tmp_path):
    path, ordinary = tmp_path / "a.html", tmp_path / "b.html"
    writing.write_file(path, b"x")
    ordinary.write_bytes(b"x")
    assert path.stat().st_mode == ordinary.stat().st_mode


@pytest.mark.parametrize("package", ["typst", "matplotlib"])
def test_a_missing_extra_is_named_with_the_cure(tmp_path, monkeypatch, package):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(InputError, match=re.escape("pip install '.[report]' in a clone")) as refused:
        write_report(solved("x", GEAR[0]), tmp_path / "report.pdf")
    assert refused.value.code == "E007"
    assert package in refused.value.message
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("share", "named"), [(1.0 + 1e-10, "a"), (1.0 - 1e-10, "a"), (1.0 + 1e-6, "b")])
def test_of_equal_margins_the_first_is_named_whatever_round_off_says(share, named):
    first = hand_made_result(PUBLISHED[2])
    second = hand_made_result((PUBLISHED[3][0], PUBLISHED[2][1] * share, *PUBLISHED[3][2:]))
    shown = content(HandMadeMachine("Two pinions", (first, second)))["worst"]
    load = next(one for one in shown if one["quantity"] == "Specific load")
    assert load["bearing"] == f"Second-stage pinion ({named})"


def test_the_rule_below_the_title_of_a_study_stands_clear_of_its_letters():
    """Rows of pixels: no letter, of a name with descenders, touches the widest dark one."""
    image = pytest.importorskip("matplotlib.image")
    data = {
        "name": "Typography", "language": "en", "words": {}, "version": "1", "hash": "0" * 16, "overview": "",
        "source": "", "notes": "",
        "tables": [], "figures": [], "text": "",
    }  # fmt: skip
    shade = image.imread(BytesIO(typeset(data, "study.typ", "png")))[:, :, :3].mean(axis=2)
    rule = int((shade < 0.5).sum(axis=1).argmax())
    millimetre = shade.shape[0] / 210.0
    assert (shade[rule] < 0.5).mean() > 0.8
    above = [row for row in range(rule) if (shade[row] < 0.5).any()]
    gap = rule - max(row for row in above if row < rule - 1)
    assert gap > 0.4 * millimetre
    assert gap < 4.0 * millimetre
