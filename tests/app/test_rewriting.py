"""The text of a case keeps its comments, its order and its way of writing while values in it change."""

from pathlib import Path

import pytest
from hypothesis import given, strategies

from babbitt.app.document import CaseDocument, with_changed
from babbitt.app.rewriting import mapping_in, rewritten
from babbitt.core.kind import kinds

EXAMPLES = Path(__file__).parents[2] / "examples"
TEXTS = {name: kind.read_template() for name, kind in kinds().items()} | {
    path.stem: text for path in EXAMPLES.glob("*.yaml") if "kind" in mapping_in(text := path.read_text("utf-8"))
}

COMMENTED = """\
# Offer 12, second round
kind: journal
name: Fan shaft          # as in the drawing
diameter: 120 mm
supply:
  temperature: 45 degC   # of the tank
  pressure: 2 bar
# from the gear maker
load: 12 kN
"""


@pytest.mark.parametrize("name", TEXTS)
def test_a_new_value_keeps_every_comment_and_says_what_is_given(name):
    text = TEXTS[name]
    given = with_changed(mapping_in(text), ("name",), "Another")
    made = rewritten(text, given)
    assert mapping_in(made) == given
    assert list(mapping_in(made)) == list(given)
    assert made.count("#") == text.count("#")
    assert rewritten(text, mapping_in(text)) == text


def test_the_line_of_a_value_is_the_only_one_that_changes():
    document = CaseDocument(COMMENTED)
    document.change(("supply", "temperature"), "50 degC")
    assert document.text == COMMENTED.replace("45 degC", "50 degC")
    document.change(("load",), None)
    assert document.text == COMMENTED.replace("45 degC", "50 degC").replace("load: 12 kN\n", "")
    document.change(("method",), {"kind": "film", "thermal": "full"})
    assert document.text.endswith("method: {kind: film, thermal: full}\n")


def test_comments_are_back_when_a_slider_stops():
    document = CaseDocument(COMMENTED)
    for load in ("13 kN", "14 kN"):
        document.slide(("load",), load)
    document.keep()
    assert document.text == COMMENTED.replace("12 kN", "14 kN")
    document.undo()
    assert document.text == COMMENTED


def test_a_value_that_a_study_found_keeps_comments_and_another_kind_does_not():
    document = CaseDocument(COMMENTED)
    document.take("kind: journal\nname: Fan shaft\nload: 9 kN\n")
    assert document.given == {"kind": "journal", "name": "Fan shaft", "load": "9 kN"}
    assert "# Offer 12" in document.text
    assert "# from the gear maker" not in document.text
    document.take("kind: thrust\nname: Pad\n")
    assert document.text == "kind: thrust\nname: Pad\n"


@pytest.mark.parametrize(
    "text", ['{"kind": "journal", "load": "12 kN"}', "kind: journal\na: &x [1, 2]\nb: *x\nload: 12 kN\n"]
)
def test_a_text_that_cannot_be_kept_is_written_anew(text):
    given = with_changed(mapping_in(text), ("load",), "13 kN")
    given = with_changed(given, ("a", 0), 7) if "a" in given else given
    assert mapping_in(rewritten(text, given)) == given


VALUES = strategies.recursive(
    strategies.booleans() | strategies.integers(-9, 9) | strategies.text("a:#-{}[], '\"\n0.e1~&*!%", max_size=6),
    lambda inner: strategies.lists(inner, max_size=3)
    | strategies.dictionaries(strategies.text("abc", min_size=1, max_size=2), inner, max_size=3),
    max_leaves=6,
)  # fmt: skip
CASES = strategies.dictionaries(strategies.text("abc", min_size=1, max_size=2), VALUES, max_size=4)


@given(CASES, CASES)
def test_whatever_a_case_becomes_is_read_back_as_it_is(before, after):
    text = "# head\n" + rewritten("", before)
    assert mapping_in(text) == before
    made = rewritten(text, after)
    assert mapping_in(made) == after


@pytest.mark.parametrize("word", ["2024-02-30", "2024-13-45"])
def test_a_word_like_a_day_that_does_not_exist_stays_a_text(word: str) -> None:
    text = rewritten(f"kind: journal\nname: {word}\nload: 10 kN\n", {"name": word, "load": "12 kN"})
    assert mapping_in(text) == {"name": word, "load": "12 kN"}


@pytest.mark.parametrize("key", ["1", "1.5", "true", "2024-01-02"])
def test_a_key_like_a_number_or_a_day_can_be_taken_out(key: str) -> None:
    assert mapping_in(rewritten(f"{key}: a\nb: 2 kN\n", {"b": "2 kN"})) == {"b": "2 kN"}


@pytest.mark.parametrize(
    "line", ["a: 2024-13-45", "1: a", "true: a", "a: 010", "a: 0x1F", "a: 1_000", "a: .5e-3", "a: ~"]
)  # fmt: skip
def test_every_word_stays_as_it_is_written(line: str) -> None:
    """Each is read by the rules of cases; those of YAML 1.1 and 1.2 make days, octal numbers and truth of some."""
    text = f"# head\n{line}  # own\nload: 10 kN  # of the fan\n"
    given = mapping_in(text) | {"load": "12 kN"}
    assert rewritten(text, given) == text.replace("10 kN", "12 kN")


def test_a_number_takes_no_quotes_of_the_text_before() -> None:
    text = 's: "0.7"  # of it\nb: x # too\n'
    assert rewritten(text, {"s": 0.8, "b": "x"}) == "s: 0.8    # of it\nb: x # too\n"


def test_one_and_true_are_two_values() -> None:
    text = "a: 1     # of it\nb: true\n"
    assert rewritten(text, {"a": True, "b": True}) == "a: true  # of it\nb: true\n"
    assert rewritten(text, {"a": 1, "b": 1.0}) == "a: 1     # of it\nb: 1.0\n"
