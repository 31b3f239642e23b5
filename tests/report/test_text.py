"""Text from a case file is shown as typed, less what moves a cursor or turns the writing."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.report.symbols import symbol_node
from babbitt.report.text import needs_system_fonts, plain_text


@given(st.text())
def test_no_control_character_survives_and_cleaning_twice_changes_nothing(text):
    cleaned = plain_text(text)
    assert plain_text(cleaned) == cleaned
    assert not {unicodedata.category(character) for character in cleaned} & {"Cc", "Cs", "Zl", "Zp"}


@given(st.text(alphabet=st.characters(min_codepoint=33, max_codepoint=126)))
def test_visible_characters_stay(text):
    assert plain_text(text) == text


@pytest.mark.parametrize("text", ["Gleitlager Größe 5 µm", "Реверс-редуктор", "שלום", "≤ 5 × 10⁻³ °C → Ω"])
def test_common_writing_needs_no_system_font(text):
    assert not needs_system_fonts(text)


@pytest.mark.parametrize("text", ["轴承", "베어링", "😀", "軸受"])
def test_other_writing_asks_for_one(text):
    assert needs_system_fonts(text)


@pytest.mark.parametrize(
    ("symbol", "node"),
    [
        ("h_lim,1", ["sym", "h", "lim,1", "", False]),
        ("ψ₂₀", ["sym", "ψ", "20", "", False]),
        ("Q_p*", ["sym", "Q", "p", "*", False]),
        ("Re_cr", ["sym", "Re", "cr", "", False]),
        ("So", ["sym", "So", "", "", False]),
    ],
)
def test_symbols_are_taken_apart(symbol, node):
    assert symbol_node(symbol) == node
