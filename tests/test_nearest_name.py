"""One way to find what a name may have meant: fields, results, oils, metals, units, codes, published cases."""

from pathlib import Path

import pytest

import babbitt as bb
from babbitt.core.nearest_name import nearest_names, unknown_name
from babbitt.core.notices import InputError
from babbitt.properties.materials.naming import spelling

SOURCES = Path(bb.__file__).parent


def test_likeness_is_measured_in_one_module():
    users = [one.relative_to(SOURCES) for one in SOURCES.rglob("*.py") if "difflib" in one.read_text("utf-8")]
    assert users == [Path("core/nearest_name.py")]


def test_the_likeliest_come_first_and_capitals_count_for_nothing():
    assert nearest_names("STIFNESS", ["damping", "stiffness"]) == ("stiffness",)
    assert nearest_names("speed_", ["load", "speeds", "speed"], most=2) == ("speed", "speeds")
    assert nearest_names("EN GJL-251", ["EN-GJL-250", "C45"], spelled=spelling) == ("EN-GJL-250",)


@pytest.mark.parametrize("name", ["colour", "", "ψ", "x" * 10_000])
def test_what_is_like_nothing_is_answered_by_what_there_is(name):
    assert nearest_names(name, ["stiffness", "damping"]) == ()
    assert unknown_name(name, ["stiffness", "damping"], "a result").endswith("there are: stiffness, damping")


def test_no_published_case_is_suggested_for_a_name_like_none():
    with pytest.raises(InputError) as refused:
        bb.validate("xyzzy")
    assert "did you mean" not in refused.value.message
    assert "lund_thomsen_1978" in refused.value.message
    with pytest.raises(InputError, match="did you mean 'lund_thomsen_1978'"):
        bb.validate("lund_thomson_1978")
