"""The form of every kind: drawn from the schema, and what is set in it is read back as the same case."""

import json

import pytest

from babbitt.app.document import CaseDocument, with_changed
from babbitt.app.form import NONE, TEXT, Choice, Entry, Group, Rows, as_text, form_of, quantities, sections_of
from babbitt.app.form_view import path_of
from babbitt.app.link import case_of, link_of
from babbitt.app.slider import Slider
from babbitt.app.studies import axes_of
from babbitt.app.units import in_unit, split
from babbitt.app.words import sections, word
from babbitt.case import parse_case
from babbitt.core.kind import kinds

TEMPLATES = {name: kind.read_template() for name, kind in kinds().items()}


def entries(items):
    """Every field with a value of its own."""
    for item in items:
        if isinstance(item, Entry):
            yield item
        elif isinstance(item, Rows):
            for row in item.rows:
                yield from entries(row)
        else:
            yield from entries(item.items)


def choices(items):
    """Paths of all parts that may be given in several ways."""
    for item in items:
        if isinstance(item, Choice):
            yield item.path
        if isinstance(item, Choice | Group):
            yield from choices(item.items)
        elif isinstance(item, Rows):
            for row in item.rows:
                yield from choices(row)


def value_at(given, path):
    for step in path:
        if isinstance(given, str):
            return None  # a part that is given by a word has the defaults of its fields
        given = given.get(step) if isinstance(given, dict) else given[step]
        if given is None:
            return None
    return given


@pytest.mark.parametrize("kind", TEMPLATES)
def test_the_form_shows_what_the_case_gives(kind):
    given = CaseDocument(TEMPLATES[kind]).given
    found = list(entries(form_of(given)))
    assert len({entry.path for entry in found}) == len(found) > 10
    for entry in found:
        assert entry.value == value_at(given, entry.path), entry.path
        if entry.units and entry.value is not None and not isinstance(entry.value, list):
            number, unit = split(as_text(entry.value), entry.units)
            assert unit or not number.replace(".", "").isdecimal(), entry


@pytest.mark.parametrize("kind", TEMPLATES)
def test_every_value_that_is_given_has_a_control(kind):
    """No field of the template is out of reach of the form, whatever kind of bearing it is."""
    given = CaseDocument(TEMPLATES[kind]).given
    items = form_of(given)
    shown = {entry.path for entry in entries(items)} | set(choices(items))

    def leaves(value, path):
        if isinstance(value, dict):
            for name, one in value.items():
                yield from leaves(one, (*path, name))
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            for number, one in enumerate(value):
                yield from leaves(one, (*path, number))
        else:
            yield path

    chosen = {"kind"}
    for path in leaves(given, ()):
        if path[-1] not in chosen and path != ("babbitt",):
            assert path in shown or any(path[: len(one)] == one for one in shown), path


@pytest.mark.parametrize("kind", TEMPLATES)
def test_a_value_that_is_set_again_leaves_the_same_case(kind):
    document = CaseDocument(TEMPLATES[kind])
    before = parse_case(document.text)
    entry = next(one for one in entries(form_of(document.given)) if one.units and isinstance(one.value, str))
    document.change(entry.path, entry.value)
    assert parse_case(document.text) == before


def test_fields_of_other_methods_do_not_show():
    document = CaseDocument(TEMPLATES["journal"])
    document.change(("method",), {"kind": "film"})
    film = {entry.path for entry in entries(form_of(document.given)) if entry.path[0] == "method"}
    document.change(("method",), {"kind": "iso7902"})
    standard = {entry.path for entry in entries(form_of(document.given)) if entry.path[0] == "method"}
    assert ("method", "thermal") in film
    assert standard == {("method", "characteristics")}


def test_fields_that_a_method_does_not_read_show_where_they_are_given():
    given = CaseDocument(TEMPLATES["journal"]).given
    standard, film = ({item.path for item in form_of(given | {"method": name})} for name in ("iso7902", "film"))
    assert standard < film
    assert film - standard >= {("bore",), ("grooves",), ("misalignment",)}
    assert ("bore",) in {item.path for item in form_of(given | {"bore": {"kind": "round"}})}


def test_a_field_has_the_symbol_of_its_quantity():
    """Where the results have one of this name; the width of a housing is another one."""
    document = CaseDocument(TEMPLATES["journal"])
    document.change(("cooling",), {"housing": {"kind": "cylinder", "diameter": "300 mm", "width": "90 mm"}})
    found = {entry.path: entry.symbol for entry in entries(form_of(document.given))}
    assert (found["diameter",], found["load",], found["limits", "specific_load"]) == ("D", "F", "p̄")
    assert found["cooling", "housing", "width"] == ""


def test_an_empty_field_begins_in_the_unit_of_what_it_holds():
    """A roughness in micrometres, a diameter in millimetres; its example is one that it takes."""
    shown = {entry.path: entry for entry in entries(form_of(CaseDocument(TEMPLATES["journal"]).given))}
    roughness = shown["surfaces", "roughness_bearing"]
    assert (roughness.units[0], roughness.example) == ("um", "10 um")
    assert shown["limits", "minimum_film_thickness"].units[0] == "um"
    assert shown["diameter",].units[0] == "mm"


def test_a_part_that_is_not_given_can_be_chosen():
    film = CaseDocument(TEMPLATES["journal"]).given | {"method": "film"}
    (bore,) = (one for one in form_of(film) if one.path == ("bore",))
    assert isinstance(bore, Choice)
    assert bore.way == NONE
    assert "lobes" in bore.ways
    (supply,) = (one for one in form_of(CaseDocument(TEMPLATES["journal"]).given) if one.path == ("supply",))
    assert isinstance(supply, Group)
    assert supply.is_given


@pytest.mark.parametrize(
    ("given", "way", "shown"),
    [
        ("{kind: relative, mean: 1.5 permille}", "radial", {"mean": "90 um"}),
        ("{kind: radial, mean: 90 um}", "relative", {"mean": "1.5 permille"}),
        (
            "{kind: radial, mean: 60 um, minimum: 50 um, maximum: 70 um}",
            "diametral",
            {"mean": "120 um", "minimum": "100 um", "maximum": "140 um"},
        ),
        ("H7/e8", "diametral", {"mean": "116.5 um", "minimum": "72 um", "maximum": "161 um"}),
        ("H7/e8", "limits", {"bore": ["120 mm", "120.035 mm"], "journal": ["119.874 mm", "119.928 mm"]}),
        (
            "{kind: limits, bore: [120 mm, 120.035 mm], journal: [119.874 mm, 119.928 mm]}",
            "deviations",
            {"bore": ["0 um", "35 um"], "journal": ["-126 um", "-72 um"]},
        ),
        ("{kind: radial, mean: 90 um}", "fit", {}),
        ("{kind: radial, mean: 90 um}", "limits", {}),
        ("{kind: radial, mean: about 90}", "relative", {}),
    ],
)
def test_a_clearance_given_in_another_way_is_the_same_gap(given, way, shown):
    document = CaseDocument(f"kind: journal\ndiameter: 120 mm\nclearance: {given}\n")
    document.choose(("clearance",), way)
    assert document.given["clearance"] == {"kind": way, **shown}


def test_a_fit_in_short_is_that_of_its_classes():
    document = CaseDocument("kind: journal\ndiameter: 120 mm\nclearance: {kind: fit, bore: H7, journal: e8}\n")
    document.choose(("clearance",), TEXT)
    assert document.given["clearance"] == "H7/e8"
    document.choose(("clearance",), "fit")
    assert document.given["clearance"] == {"kind": "fit", "bore": "H7", "journal": "e8"}
    document.choose(("lubricant",), TEXT)
    assert document.given["lubricant"] == ""


def test_the_way_back_keeps_every_letter():
    """Compressed: also what no text may hold, which the reader refuses."""
    texts = ["kind: journal  # ψ, µm\n", "name: \ud800\n", ""]
    document = CaseDocument(texts[0])
    for text in texts[1:]:
        document.write(text)
    for text in reversed(texts):
        assert document.text == text
        document.undo()


def test_a_method_in_short_is_its_name():
    """It was no word at all, which no method is called."""
    document = CaseDocument("kind: journal\nmethod: {kind: film, thermal: full}\n")
    document.choose(("method",), TEXT)
    assert document.given["method"] == "film"


def test_sizes_of_a_large_bearing_come_back_as_they_were():
    given = {"kind": "deviations", "bore": ["0 um", "35.5 um"], "journal": ["-72.25 um", "-60.75 um"]}
    document = CaseDocument(json.dumps({"kind": "journal", "diameter": "1200 mm", "clearance": given}))
    document.choose(("clearance",), "limits")
    document.choose(("clearance",), "deviations")
    assert document.given["clearance"] == given


def test_a_gap_needs_no_diameter_to_be_given_on_the_other_one():
    document = CaseDocument("kind: journal\nclearance: {kind: radial, mean: 45 um}\n")
    document.choose(("clearance",), "relative")
    assert document.given["clearance"] == {"kind": "relative"}
    document.change(("clearance",), {"kind": "radial", "mean": "45 um"})
    document.choose(("clearance",), "diametral")
    assert document.given["clearance"] == {"kind": "diametral", "mean": "90 um"}


def test_a_switch_that_is_not_given_stands_as_its_default():
    document = CaseDocument(TEMPLATES["journal"])
    document.change(("method",), "film")
    switches = {entry.path: entry for entry in entries(form_of(document.given)) if entry.is_switch}
    assert switches["method", "limiting_speeds"].value is None
    assert switches["method", "limiting_speeds"].is_on
    assert not switches["method", "error_estimate"].is_on


def test_lists_are_read_as_lists_before_they_are_given():
    document = CaseDocument("kind: journal\ndiameter: 120 mm\nclearance: {kind: limits}\n")
    of_sizes = [entry for entry in entries(form_of(document.given)) if entry.path[-1] in ("bore", "journal")]
    assert [entry.is_list for entry in of_sizes] == [True, True]


def test_every_section_names_fields_of_some_kind():
    known = {item.path[0] for text in TEMPLATES.values() for item in form_of(CaseDocument(text).given)}
    headings = sections_of(form_of(CaseDocument(TEMPLATES["journal"]).given), sections(), word("section_other"))
    assert next(iter(headings)) == "Geometry"
    for heading, names in sections().items():
        assert set(names) & known, heading


def test_the_way_back_and_forth():
    document = CaseDocument("kind: journal\nload: 10 kN\n")
    document.change(("load",), "12 kN")
    document.slide(("load",), "13 kN")
    document.slide(("load",), "14 kN")
    document.keep()
    assert document.given["load"] == "14 kN"
    document.undo()
    assert document.given["load"] == "12 kN"  # one movement is one step
    for _ in range(3):  # no further than to the beginning
        document.undo()
    assert document.given["load"] == "10 kN"
    for _ in range(3):
        document.redo()
    assert document.given["load"] == "14 kN"
    document.undo()
    document.change(("load",), "20 kN")
    document.redo()
    assert document.given["load"] == "20 kN"


def test_lists_grow_and_shrink():
    given = with_changed({}, ("grooves", 0, "angle"), "90 deg")
    assert given == {"grooves": [{"angle": "90 deg"}]}
    given = with_changed(given, ("grooves", 1), {})
    assert with_changed(given, ("grooves", 0), None) == {"grooves": [{}]}


def test_units_are_converted():
    assert float(in_unit("1", "in", "mm")) == pytest.approx(25.4)
    assert float(in_unit("20", "degC", "degF")) == pytest.approx(68.0)
    assert split("3000 rpm", ("rpm", "1/s")) == ("3000", "rpm")
    assert split("H7/e7", ("mm",)) == ("H7/e7", "")


@pytest.mark.parametrize("kind", TEMPLATES)
def test_a_link_holds_the_whole_case(kind):
    assert case_of("#" + link_of(TEMPLATES[kind])) == TEMPLATES[kind]


@pytest.mark.parametrize(
    "fragment", ["", "#", "#case=", "#case=%%%", "#case=AAAA", "#other=1", "#case=" + "A" * 4001]
)
def test_a_link_without_a_case_is_refused(fragment):
    assert case_of(fragment) is None


def test_a_link_that_unpacks_to_gigabytes_is_refused():
    assert case_of("#" + link_of("x" * 3_000_000)) is None


def test_places_of_faults():
    assert path_of("bearings[1 'Output wheel'].supply.pressure") == ("bearings", 1, "supply", "pressure")
    assert path_of("grooves[0].angle") == ("grooves", 0, "angle")
    assert path_of("") == ()


def test_going_back_while_a_slider_moves_leads_to_where_it_began():
    document = CaseDocument(TEMPLATES["journal"])
    before = document.text
    document.slide(("load",), "13 kN")
    document.slide(("load",), "14 kN")
    document.undo()
    assert document.text == before
    document.keep()  # the slider comes to rest later
    assert document.text == before
    document.redo()
    assert document.given["load"] == "14 kN"


def test_a_change_while_a_slider_moves_is_one_of_its_own():
    document = CaseDocument(TEMPLATES["journal"])
    document.slide(("load",), "14 kN")
    document.change(("diameter",), "130 mm")
    document.keep()
    document.undo()
    assert (document.given["load"], document.given["diameter"]) == ("14 kN", "120 mm")
    document.undo()
    assert document.text == TEMPLATES["journal"]


def test_a_number_in_permille_is_a_quantity_and_a_plain_one_is_none():
    """A relative clearance has a slider and a study; a preload stays a number."""
    document = CaseDocument(TEMPLATES["journal"])
    document.change(("clearance",), {"kind": "relative", "mean": "1.5 permille"})
    document.change(("width_ratio",), 0.5)
    found = {entry.path: entry for entry in quantities(document.items)}
    assert found["clearance", "mean"].units[0] in ("permille", "%")
    assert "permille" in found["clearance", "mean"].units
    assert ("width_ratio",) not in found
    assert "clearance.mean" in axes_of(document, "size")


def test_a_drag_that_pauses_is_one_step_to_take_back():
    """While the hand holds the slider its movement has not ended."""
    document = CaseDocument(TEMPLATES["journal"])
    before = document.text
    slider = Slider.__new__(Slider)
    slider.document, slider._stopped, slider._moved = document, lambda moved: None, {("load",)}
    slider._held = True
    for load in ("13 kN", "14 kN"):
        document.slide(("load",), load)
        slider._stood_still()
    slider._held = False
    slider._stood_still()
    document.undo()
    assert document.text == before
