"""Tables that others wrote cannot exhaust the machine; what is sound is read as before."""

import re
import tomllib
from importlib.resources import files

import pytest

from babbitt.core.files.bounded_text import loads_toml
from babbitt.core.notices import InputError
from babbitt.export.json_file import read_json
from babbitt.export.ross_file import read_blocks
from babbitt.properties.materials import parse_experience_limits

SHIPPED = files("babbitt.properties.materials").joinpath("limits.toml").read_text(encoding="utf-8")


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
        loads_toml(text)
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
    assert loads_toml(text) == tomllib.loads(text)


@pytest.mark.parametrize(
    "text", ["a" * 300_000 + " = 1", 'a = "' + '\\"' * 100_000, 'a = """' + '"' * 2 * 100_000]
)
def test_a_long_word_takes_no_time_that_grows_with_the_square_of_its_length(text):
    """Six hours for the first one, by the square of the 3.5 s that 10 000 letters once took."""
    try:
        expected = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        with pytest.raises(tomllib.TOMLDecodeError, match=re.escape(str(error))):
            loads_toml(text)
    else:
        assert loads_toml(text) == expected


@pytest.mark.parametrize(
    ("name", "read", "text"),
    [
        ("ross.toml", read_blocks, "a = " + "[" * 3000),
        ("ross.json", read_blocks, "[" * 200_000),
        ("table.json", read_json, "[" * 200_000),
    ],
)
def test_coefficient_files_that_nest_without_bound_are_refused(tmp_path, name, read, text):
    (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="nested too deeply"):
        read(tmp_path / name)
