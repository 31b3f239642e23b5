"""YAML without its surprises, and with the line of every value."""

import json

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from babbitt.case import CaseError, parse_case
from babbitt.case.document import DEEPEST, LARGEST, DocumentError, read_document
from babbitt.case.scalars import scalar


@pytest.fixture(params=["libyaml", "python"], autouse=True)
def parser(request, monkeypatch):
    """Both parsers: not every wheel of PyYAML has libyaml."""
    if request.param == "python":
        monkeypatch.delattr(yaml, "CSafeLoader", raising=False)


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("1e-3", 0.001),
        ("1E-3", 0.001),
        ("-1.5e3", -1500.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("010", 10),
        ("+7", 7),
        ("no", "no"),
        ("on", "on"),
        ("yes", "yes"),
        ("Off", "Off"),
        ("y", "y"),
        ("true", True),
        ("FALSE", False),
        ("tRue", "tRue"),
        ("null", None),
        ("~", None),
        ("12:30", "12:30"),
        ("1:30:00", "1:30:00"),
        ("2024-01-31", "2024-01-31"),
        ("2024-01-31 12:00:00", "2024-01-31 12:00:00"),
        ("0x1F", "0x1F"),
        ("0o17", "0o17"),
        ("1_000", "1_000"),
        ("1,5", "1,5"),
        ("H7", "H7"),
        (".inf", float("inf")),
        ("inf", "inf"),
        ("9" * 5000, "9" * 5000),
        ("1e99999", "1e99999"),
    ],
)
def test_scalars(word, value):
    found = read_document(f"a: {word}").plain()["a"]
    assert found == value
    assert type(found) is type(value)


@pytest.mark.parametrize("word", ["1e-3", "true", "null", "12", ""])
def test_quoted_words_stay_text(word):
    assert read_document(f"a: '{word}'\nb: \"{word}\"").plain() == {"a": word, "b": word}


WORDS = st.text(
    st.characters(max_codepoint=0xFFFF, exclude_categories=["Cs"], exclude_characters="\x7f"), max_size=12
)
"""JSON writes other characters as pairs of escapes, which YAML does not know."""

NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
VALUES = st.none() | st.booleans() | st.integers(-(2**53), 2**53) | NUMBERS | WORDS


@given(
    st.recursive(
        VALUES,
        lambda inner: st.lists(inner, max_size=4) | st.dictionaries(WORDS, inner, max_size=4),
        max_leaves=15,
    )
)
def test_json_is_read_as_json(value):
    text = json.dumps({"top": value}, ensure_ascii=True)
    assert read_document(text).plain() == _as_read({"top": value})


def _as_read(value):
    """Keys that are no words are shown by their representation."""
    if isinstance(value, dict):
        return {key if key.isprintable() else repr(key): _as_read(inner) for key, inner in value.items()}
    return [_as_read(inner) for inner in value] if isinstance(value, list) else value


def test_lines():
    root = read_document("# comment\n\na: 1\nb:\n  - x\n  - {c: 2,\n     d: 3}\n")
    assert root.line_of(()) == 3
    assert root.line_of(("a",)) == 3
    assert root.line_of(("b",)) == 4
    assert root.line_of(("b", 0)) == 5
    assert root.line_of(("b", 1, "c")) == 6
    assert root.line_of(("b", 1, "d")) == 7
    assert root.line_of(("b", 1, "missing")) == 6
    assert root.line_of(("missing", "below")) == 3


def test_columns():
    assert read_document("a: 1\nb:   {c: 2}").value["b"][1].mark.column == 6


def test_an_alias_is_where_its_anchor_is():
    root = read_document("a: &here\n  x: 1\nb: *here\n")
    assert root.plain() == {"a": {"x": 1}, "b": {"x": 1}}
    assert root.line_of(("b",)) == 3
    assert root.line_of(("b", "x")) == 2


def test_merge_keys_do_not_override():
    text = "base: &base {a: 1, b: 2}\nmore: &more {b: 3, c: 4}\nown: {<<: [*base, *more], a: 9}\n"
    assert read_document(text).plain()["own"] == {"a": 9, "b": 2, "c": 4}


def test_depth_limit_is_exact():
    fits = "[" * DEEPEST + "]" * DEEPEST
    assert read_document(fits).plain()
    with pytest.raises(DocumentError, match="nested too deeply"):
        read_document("[" + fits + "]")


def test_size_limit_counts_aliases_each_time():
    hundred = "a: &a [" + "x, " * 100 + "]\n"
    allowed = (LARGEST - 200) // 101
    assert read_document(hundred + "b: [" + "*a, " * (allowed - 2) + "]")
    with pytest.raises(DocumentError, match="too many values"):
        read_document(hundred + "b: [" + "*a, " * (allowed + 2) + "]")


def test_billion_laughs_ends_at_once():
    lines = ["a0: &a0 [" + "x, " * 10 + "]"]
    lines += [f"a{i}: &a{i} [" + f"*a{i - 1}, " * 10 + "]" for i in range(1, 40)]
    with pytest.raises(DocumentError, match="too many values") as caught:
        read_document("\n".join(lines))
    assert caught.value.line == 5  # ten lists of 11 111 values each


def test_a_megabyte_of_brackets_ends_at_once():
    with pytest.raises(DocumentError, match="nested too deeply"):
        read_document("[" * 1_000_000 + "\t}")  # what is wrong at the end is never reached


@pytest.mark.parametrize("text", ["", " \n", "# only\n", "---\n", "--- # x\n...\n"])
def test_nothing(text):
    if text.startswith("---"):
        assert read_document(text).plain() is None
    else:
        with pytest.raises(DocumentError, match="empty"):
            read_document(text)


@given(st.text(max_size=200))
def test_any_text_is_read_or_refused(text):
    try:
        read_document(text).plain()
    except DocumentError as error:
        assert error.line >= 1  # noqa: PT017


def test_half_a_character_is_refused():
    with pytest.raises(DocumentError):
        read_document('a: "\\ud800"')


def test_a_scalar_alone():
    assert scalar("") is None


def test_long_keys_are_shortened_in_messages():
    long = "k" * 1000  # YAML knows no longer keys
    for text in (f"kind: journal\n{long}: 1", f"{long}: 1\n{long}: 2", f"a: *{long}", f"kind: {long}"):
        with pytest.raises(CaseError) as caught:
            parse_case(text)
        assert "kkk" in caught.value.message
        assert long[:200] not in caught.value.message
