"""What the page shows is what `babbitt solve` prints, and no text of a case becomes markup."""

import math
from dataclasses import replace
from xml.etree import ElementTree

import pytest

from babbitt.app.answer import Finding, answer, read, solved, used_share
from babbitt.app.answer_markup import cards_markup, findings_markup, verdict_markup
from babbitt.app.document import CaseDocument
from babbitt.case import CaseError
from babbitt.core.kind import kinds
from babbitt.core.result import Bound, Check
from babbitt.report.picture import Handle, Picture
from babbitt.report.verdict import worst_verdict
from babbitt.solving import solve

JOURNAL = kinds()["journal"].read_template()
FOOTSTEP = kinds()["screw_heel"].read_template()


def film(**changes):
    document = CaseDocument(JOURNAL)
    document.change(("method",), {"kind": "film", "accuracy": "draft"})
    document.change(("supply_element",), None)
    document.change(
        ("grooves",), [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"}]
    )
    for name, value in changes.items():
        document.change((name,), value)
    return document.text


def test_the_numbers_are_those_of_solve():
    text = film()
    found = answer(text)
    machine = solve(read(text))
    assert found.case_hash == machine.case_hash
    (result,) = machine.results
    (shown,) = found.bearings
    assert shown.verdict == result.verdict.value
    assert {row[1]: row[2] for row in shown.rows}["ε"] == f"{result.eccentricity_ratio:.3f}"
    film_card = next(card for card in shown.cards if card.symbol == "h_min")
    check = min((c for c in result.limits if c.quantity == "minimum_film_thickness"), key=lambda c: c.margin)
    assert film_card.word == "pass"
    assert film_card.share == pytest.approx(check.limit / check.value)


def test_cards_of_a_bearing_short_of_oil_are_of_the_film_that_limits_are_held_against():
    (shown,) = answer(JOURNAL).bearings
    symbols = {card.symbol for card in shown.cards}
    assert symbols >= {"T_ex,st", "h_min,st", "ε_st"}
    assert not symbols & {"T_ex", "h_min", "ε"}


def test_a_quick_answer_is_one_on_the_draft_grid():
    document = CaseDocument(film())
    document.change(("method",), {"kind": "film"})
    fine, quick, draft = answer(document.text), answer(document.text, quick=True), answer(film())
    assert quick.quick
    rows = set(quick.bearings[0].rows)
    assert rows < set(draft.bearings[0].rows)
    assert rows != set(fine.bearings[0].rows)
    left_out = {symbol for _, symbol, _, _ in set(draft.bearings[0].rows) - rows}
    assert left_out == {"N_tr", "N_w"}
    assert quick.bearings[0].verdict == draft.bearings[0].verdict


def test_faults_have_their_fields():
    found = answer("kind: journal\nname: x\ndiameter: 12 kg\n")
    assert not found.bearings
    assert any(fault.field == "diameter" and "is a mass" in fault.message for fault in found.faults)


def test_fields_that_the_method_does_not_read_are_known():
    """Of a part, too."""
    (found,) = answer(film(span="180 deg"), quick=True).bearings
    assert found.unread == ("span", "friction.model")
    assert not answer(JOURNAL).bearings[0].unread


@pytest.mark.parametrize("name", ["bore.csv", "/etc/passwd", "../../secret.csv"])
def test_a_case_names_no_files(name):
    text = film(bore={"kind": "measured", "file": name})
    (fault,) = answer(text).faults
    assert fault.field == "bore.file"
    assert "no files" in fault.message
    with pytest.raises(CaseError):
        solved(text)


def test_markup_in_names_stays_text():
    name = "<script>alert(1)</script>"
    (shown,) = answer(film(name=name)).bearings
    assert "<script" not in shown.picture
    assert ElementTree.fromstring(shown.picture).get("aria-label").startswith(name)


def test_the_drawing_is_that_of_the_film():
    """The journal stands where the film carries it, the load arrow where the case has it."""
    (shown,) = answer(film(load_angle="-60 deg")).bearings
    (result,) = solve(read(film(load_angle="-60 deg"))).results
    root = ElementTree.fromstring(shown.picture)
    space = "{http://www.w3.org/2000/svg}"
    journal = next(one for one in root.iter(f"{space}circle") if one.get("class") == "journal")
    x, y = float(journal.get("cx")), -float(journal.get("cy"))
    assert math.hypot(x, y) / 0.22 == pytest.approx(result.eccentricity_ratio, rel=1e-3)
    turned = math.atan2(y, x) - math.radians(-60.0)
    assert turned == pytest.approx(result.attitude_angle, abs=1e-3)
    load = next(one for one in root.iter(f"{space}path") if one.get("data-field") == "load_angle")
    assert float(load.get("data-angle")) == pytest.approx(-60.0)


def test_of_several_clearances_the_worst_verdict_is_on_top():
    """Tight limits that the smallest clearance keeps and the largest misses."""
    document = CaseDocument(JOURNAL)
    document.change(("clearance_cases",), "all")
    found = answer(document.text)
    tight = 0.5 * sum(
        next(float(row[2]) for row in found.bearings[place].rows if row[1] == "h_min,st") for place in (0, 2)
    )
    document.change(("limits",), {"minimum_film_thickness": f"{tight:.3f} um"})
    found = answer(document.text)
    machine = solve(read(document.text))
    verdicts = [one.verdict for one in machine.results]
    assert len(set(verdicts)) > 1
    assert found.bearings[found.worst].verdict_key == worst_verdict(machine.results).key
    shown = verdict_markup(found.bearings[-1], found)
    assert shown.index(worst_verdict(machine.results).value) < shown.index(found.bearings[-1].name)


def test_missed_limits_say_what_to_do_and_a_missing_check_why_there_is_no_verdict():
    (failed,) = answer(film(load="200 kN")).bearings
    missed = next(one for one in failed.findings if one.code == "C103")
    assert missed.grave
    assert missed.remedy
    (shown, *_) = answer(kinds()["screw_heel"].read_template()).bearings
    assert shown.verdict_key == "no_verdict"
    assert "Nothing is held against a limit" in shown.findings[0].title


def test_what_the_case_does_not_give_has_no_handle():
    """Pockets on both sides of the standard are drawn for the film, too, and are no entries of a list."""
    document = CaseDocument(JOURNAL)
    document.change(("method",), {"kind": "film", "accuracy": "draft"})
    (shown,) = answer(document.text).bearings
    assert 'data-field="pockets' not in shown.picture
    assert 'data-field="load_angle"' in shown.picture


def test_there_is_no_way_back_to_before_the_draft():
    document = CaseDocument(JOURNAL)
    document.begin(film())
    document.undo()
    assert document.text == film()


def test_grooves_are_handles():
    grooves = [{"angle": "20 deg", "extent": "20 deg"}, {"angle": "200 deg", "extent": "20 deg"}]
    (shown,) = answer(film(grooves=grooves)).bearings
    assert 'data-field="grooves.0.angle"' in shown.picture
    assert 'data-field="grooves.1.angle"' in shown.picture


@pytest.mark.parametrize(("bound", "value", "share"), [(Bound.AT_MOST, 3e6, 0.6), (Bound.AT_LEAST, 10e6, 0.5)])
def test_used_share(bound, value, share):
    assert used_share(Check("C103", "specific_load", value, 5e6, bound, "test")) == pytest.approx(share)


def test_used_share_of_a_temperature_counts_in_degrees_celsius():
    check = Check("C104", "outlet_temperature", 273.15 + 80.0, 273.15 + 100.0, Bound.AT_MOST, "test")
    assert used_share(check) == pytest.approx(0.8)


def test_pictures_have_y_upward_and_escape_their_words():
    picture = Picture(1.0, 'a "quoted" <b>')
    picture.arrow((0.0, 0.0), (0.0, 0.5), "load", Handle("load_angle", math.pi / 2))
    picture.text(0.0, 0.0, "<i>&")
    root = ElementTree.fromstring(picture.svg())
    line = root[1].get("d")
    assert line == "M0 -0L0 -0.5"
    assert root.get("aria-label") == 'a "quoted" <b>'


def test_symbols_of_findings_have_their_subscripts_and_names_stay():
    said = "T_ex,st = 3 K, h_min and Q_p > Q; clearance_cases; P_1.yaml; Oil AB_46"
    made = findings_markup([Finding("W1", "ψ_eff <b>", said, "", True)])
    for symbol in (
        "T<sub>ex,st</sub> =",
        "h<sub>min</sub> and",
        "Q<sub>p</sub> &gt;",
        "ψ<sub>eff</sub> &lt;b&gt;",
    ):
        assert symbol in made
    assert made.endswith("clearance_cases; P_1.yaml; Oil AB_46</div></details>")


def test_a_recommendation_that_is_kept_is_called_so():
    """It stood as pass beside the word that nothing is held against a limit."""
    cards = [one for one in answer(FOOTSTEP).bearings[0].cards if one.limit]
    assert cards
    assert all(one.is_advice for one in cards)
    assert cards_markup([replace(cards[0], word="pass")]).count("recommendation kept") == 1
    assert "recommendation" not in cards_markup([replace(cards[0], word="pass", is_advice=False)])
