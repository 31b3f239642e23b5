"""Tables that others wrote cannot exhaust the machine; what is sound is read as before."""

import tomllib
from importlib.resources import files

import pytest

from babbitt.materials import bounded_toml, parse_experience_limits
from babbitt.notices import InputError

SHIPPED = files("babbitt.materials").joinpath("limits.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "text",
    [
        "a = " + "[" * 30_000,
        "a = " + "{a = " * 15_000,
        "[" + ".".join(["a"] * 30_000) + "]",
        ".".join(["a"] * 30_000) + " = 1",
        " . ".join(['"a b"'] * 30_000) + " = 1",
        "x = 1\n" + ".".join(["a"] * 25) + " = 1",
    ],
)
def test_what_nests_without_bound_is_refused(text):
    with pytest.raises(ValueError, match="nested too deeply"):
        bounded_toml.loads(text)
    with pytest.raises(InputError, match="nested too deeply"):
        parse_experience_limits(text)


@pytest.mark.parametrize(
    "text",
    [
        SHIPPED,
        "a = [[1.5, 2.25], [3.125]]\n[b.c]\nd = {e = 1, f.g = 2}",
        "a = '" + "[" * 50 + "'  # " + "[" * 50 + '\nb = """\n' + "{" * 40 + '"""',
        "a = [" + ", ".join(f"{n}.5" for n in range(500)) + "]",
    ],
)
def test_what_is_sound_is_read_as_by_the_standard_library(text):
    assert bounded_toml.loads(text) == tomllib.loads(text)
