"""Coefficients that a warning questions say so, in files and on the terminal."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from coefficient_tables import table

from babbitt.core.notices import InputError
from babbitt.export import (
    CoefficientTable,
    mirrored,
    read_csv,
    read_json,
    read_ross,
    read_xltrc2,
    write_csv,
    write_json,
    write_ross,
    write_xltrc2,
)
from babbitt.export.numbers import RPM, rounded_rpm
from babbitt.report.questioned_coefficients import warnings_lines
from babbitt.study.speed_range import speeds_of

SPEEDS = np.array([1000.0, 6000.0, 11000.0, 20000.0, 22500.0]) * RPM
CODES = ((), (), ("W404",), ("W407", "W127", "W128"), ("W407",))


def questioned(codes=CODES):
    k = np.full((5, 2, 2), 1e8)
    return CoefficientTable("Pads", SPEEDS, k, 1e-3 * k, warnings=codes)


@pytest.mark.parametrize(
    ("write", "read", "name"),
    [
        (write_csv, lambda path: read_csv(path)[0], "t.csv"),
        (write_json, lambda path: read_json(path)[0], "t.json"),
        (lambda one, path: write_ross(one, path, version=3), lambda path: read_ross(path, version=3), "t.json"),
        (lambda one, path: write_ross(one, path, version=2), lambda path: read_ross(path, version=2), "t.toml"),
        (write_xltrc2, read_xltrc2, "t.csv"),
        (write_xltrc2, read_xltrc2, "t.xlsx"),
    ],
)
@pytest.mark.parametrize("codes", [CODES, CODES[::-1]], ids=["at the end", "at the beginning"])
def test_the_codes_of_every_speed_come_back(tmp_path, write, read, name, codes):
    write(questioned(codes), tmp_path / name)
    back = read(tmp_path / name)
    assert back.warnings == codes
    assert back.speeds == pytest.approx(SPEEDS, rel=1e-15)


def test_a_table_without_warnings_says_nothing_of_them(tmp_path):
    assert table(warnings=((),) * 8).warnings == ()
    assert list(warnings_lines(table())) == []
    write_csv(table(), tmp_path / "t.csv")
    assert "warnings" not in (tmp_path / "t.csv").read_text()


def test_the_terminal_names_speeds_and_what_the_codes_say():
    lines = list(warnings_lines(questioned()))
    assert lines[:3] == ["11000 rpm: W404", "20000 rpm: W407 W127 W128", "22500 rpm: W407"]
    assert [line.split()[0] for line in lines[3:]] == ["W404", "W407", "W127", "W128"]
    assert lines[4].endswith("(no verdict)")


def test_seen_from_the_other_end_the_warnings_stay():
    assert mirrored(questioned()).warnings == CODES


@pytest.mark.parametrize(("wrong", "words"), [((("W407",),), "1 speeds of 8"), ((("W407 !",),) * 8, "codes such")])
def test_warnings_that_make_no_table(wrong, words):
    with pytest.raises(InputError, match=words):
        table(warnings=wrong)


@pytest.mark.parametrize("rpm", [6000.0, 3000.0, 12345.6, 0.1, 1234.5678901234567])
def test_a_speed_in_rpm_brings_back_the_same_speed(rpm):
    assert rounded_rpm(rpm * RPM) == pytest.approx(rpm, rel=1e-15)
    spaced = [rounded_rpm(speed) for speed in speeds_of("1800 rpm:9000 rpm:9")]  # differ by their round-off
    assert spaced == [900.0 * turn for turn in range(2, 11)]
    assert rounded_rpm(math.pi) * RPM == pytest.approx(math.pi, rel=1e-15)
    assert len(str(rounded_rpm(6000.0 * RPM))) == len("6000.0")


@pytest.mark.parametrize(
    ("write", "read", "name"), [(write_csv, read_csv, "t.csv"), (write_json, read_json, "t.json")]
)
def test_speeds_that_a_table_lacks_come_back_from_files(tmp_path, write, read, name):
    for lacking in ((), (0.0, 12.5)):
        write(replace(questioned(), unsolved_speeds=lacking), tmp_path / name)
        (back,) = read(tmp_path / name)
        assert back.unsolved_speeds == lacking
        assert ("unsolved" in (tmp_path / name).read_text()) == bool(lacking)


def test_speeds_that_a_table_lacks_are_finite_numbers():
    with pytest.raises(InputError, match="unsolved_speeds"):
        replace(questioned(), unsolved_speeds=(math.nan,))
