"""The text of a case: the same by both libraries of YAML, and read back to what was written."""

import pytest
import yaml

from babbitt.case import template
from babbitt.case.with_units import case_text

GIVEN = {
    "name": "Lager 1: Größe µm, ядро # 2",
    "load": "10 kN",
    "notes": "a long line " * 20,
    "pads": {"number": 4, "each": [{"preload": 0.45}, {"extent": "70 deg", "width": 1.5e-07}]},
}


@pytest.mark.parametrize(
    "given", [GIVEN, *(yaml.safe_load(template(kind)) for kind in ("journal", "tilting_pad_journal", "thrust"))]
)
def test_a_text_is_the_same_without_the_c_library(given, monkeypatch):
    text = case_text(given)
    monkeypatch.delattr(yaml, "CSafeDumper", raising=False)
    assert case_text(given) == text
    assert yaml.safe_load(text) == given
