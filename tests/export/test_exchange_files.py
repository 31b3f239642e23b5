"""Every format: what is written is what is read, and what is wrong in a file is said."""

import math
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from coefficient_tables import assert_same, table
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.export import (
    FORMATS,
    Frame,
    Rotation,
    export,
    mirrored,
    read_ansys,
    read_csv,
    read_json,
    read_ross,
    read_xltrc2,
    rotated,
    write_ansys,
    write_csv,
    write_json,
    write_xltrc2,
)
from babbitt.export.ansys import ansys_text
from babbitt.export.frame import declaration, declared, settled

MASS = np.linspace(-30.0, 90.0, 32).reshape(8, 2, 2)
AWKWARD = [
    "Drive end",
    'pinion 2", "outer"; é',
    "bulb in inches, 3000 rpm",
    "=1+1",
    "-2+3",
    "@x",
    "'",
    "'=a",
    "+1",
]


@pytest.mark.parametrize("name", AWKWARD)
@pytest.mark.parametrize(("write", "read"), [(write_csv, read_csv), (write_json, read_json)])
def test_own_formats_keep_every_digit(tmp_path, write, read, name):
    tables = [
        table(name=name),
        rotated(table(name="turned", mass=MASS), 0.3),
        mirrored(table(name="clockwise", method="")),
        table(name="load unknown", frame=Frame(load_angle=None), static={}),
    ]
    write(tables, tmp_path / "file")
    for one, other in zip(read(tmp_path / "file"), tables, strict=True):
        assert_same(one, other)


def test_one_table_needs_no_list(tmp_path):
    write_csv(table(), tmp_path / "t.csv")
    write_json(table(), tmp_path / "t.json")
    assert_same(read_csv(tmp_path / "t.csv")[0], read_json(tmp_path / "t.json")[0])


@pytest.mark.parametrize("name", AWKWARD)
@pytest.mark.parametrize("mass", [None, MASS])
def test_the_table_with_units_row_comes_back(tmp_path, name, mass):
    write_xltrc2(table(name=name, mass=mass), tmp_path / "t.csv")
    assert_same(read_xltrc2(tmp_path / "t.csv"), table(name=name, mass=mass), rtol=1e-15, static=False)


@pytest.mark.parametrize(
    ("units", "scale"),
    [
        (("kN s/m", "N/m", "kg"), (1e-3, 1.0, 1.0)),
        (("N-s/mm", "MN/m", "t"), (1e-3, 1e-6, 1e-3)),
        (("Ns/m", "n/m", "N-s^2/m"), (1.0, 1.0, 1.0)),
        (("lb-sec/in", "N/m", "lbf-s2/in"), (1.0 / 175.126835246, 1.0, 1.0 / 175.126835246)),
    ],
)
def test_every_column_is_read_in_its_own_unit(tmp_path, units, scale):
    """The same table told in other units, those of stiffness, damping and mass mixed."""
    told = table(name="b", mass=MASS)
    parts = zip(("damping", "stiffness", "mass"), scale, strict=True)
    write_xltrc2(replace(told, **{part: getattr(told, part) * by for part, by in parts}), tmp_path / "t.csv")
    text = (tmp_path / "t.csv").read_text()
    for ours, theirs in zip(("N-s/m", "N/m", "kg"), units, strict=True):
        text = text.replace(f",{ours}", f",<{ours}>").replace(f"<{ours}>", theirs)
    (tmp_path / "t.csv").write_text(text)
    assert_same(read_xltrc2(tmp_path / "t.csv"), told, rtol=1e-9, static=False)


def test_the_workbook_comes_back(tmp_path):
    pytest.importorskip("openpyxl")
    write_xltrc2(table(name="bulb", mass=MASS), tmp_path / "t.xlsx")
    assert_same(read_xltrc2(tmp_path / "t.xlsx"), table(name="bulb", mass=MASS), rtol=1e-15, static=False)


def test_without_its_library_the_workbook_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "openpyxl", None)
    for call in (lambda path: write_xltrc2(table(), path), read_xltrc2):
        with pytest.raises(InputError, match="pip install openpyxl"):
            call(tmp_path / "t.xlsx")


def test_ansys_comes_back_to_its_digits(tmp_path):
    write_ansys(table(), tmp_path / "t.txt")
    assert_same(read_ansys(tmp_path / "t.txt"), table(), rtol=5.1e-8, static=False)


def test_ansys_fields_stand_in_their_columns(tmp_path):
    write_ansys(table(name="n" * 100), tmp_path / "t.txt")
    lines = (tmp_path / "t.txt").read_text().splitlines()
    assert [len(line) for line in lines[:4]] == [80, len(declaration(table().frame)), len(table().method), 30]
    assert lines[3].split() == ["8", "0", "0"]
    assert len(lines) == 4 + 3 * 8
    for at in range(4, len(lines), 3):
        assert [len(line) for line in lines[at : at + 3]] == [20, 60, 60]


def test_ansys_keys_convert_and_count_when_absent(tmp_path):
    si = table(name="b", speeds=1, static={})
    write_ansys(si, tmp_path / "si.txt")
    text = (tmp_path / "si.txt").read_text()
    # the definitions: 1 lb = 0.45359237 kg, g = 9.80665 m/s2, 1 in = 0.0254 m; 60 rpm = one turn a second
    pound_per_inch = 0.45359237 * 9.80665 / 0.0254
    for keys in ("         1         1", "", "         1"):
        (tmp_path / "us.txt").write_text(text.replace("         1         0         0", "         1" + keys))
        us = read_ansys(tmp_path / "us.txt")
        np.testing.assert_allclose(us.stiffness, si.stiffness * pound_per_inch, rtol=1e-7)
        np.testing.assert_allclose(us.damping, si.damping * pound_per_inch, rtol=1e-7)
        np.testing.assert_allclose(us.speeds, si.speeds * 2.0 * math.pi / 60.0, rtol=1e-7)


def test_a_table_in_pounds_and_inches_is_converted(tmp_path):
    (tmp_path / "us.csv").write_text(
        "some heading,,\n\nSpeed,KXX,Kxy,Kyx,Kyy,Cxx,Cxy,Cyx,Cyy\nRPM" + ",lb/in" * 4 + ",lb-s/in" * 4 + "\n"
        "600,1e6,0,-1e6,2e6,1000,0,0,1000\n1200,1e6,0,-1e6,2e6,1000,0,0,1000\n,,\nremark,1,2\n"
    )
    us = read_xltrc2(tmp_path / "us.csv", frame=Frame(load_angle=None))
    np.testing.assert_allclose(us.speeds, [20.0 * math.pi, 40.0 * math.pi], rtol=1e-15)
    # 1 lb/in = 175.126835 N/m (NIST SP 811, B.8, to nine digits)
    np.testing.assert_allclose(us.stiffness[0], [[175.126835e6, 0.0], [-175.126835e6, 350.25367e6]], rtol=3e-9)
    np.testing.assert_allclose(us.damping[1], [[175126.835, 0.0], [0.0, 175126.835]], rtol=3e-9)
    assert us.name == "us"


def test_without_a_declared_frame_nothing_is_guessed(tmp_path):
    write_xltrc2(table(), tmp_path / "t.csv")
    bare = "".join((tmp_path / "t.csv").read_text().splitlines(keepends=True)[3:])
    (tmp_path / "bare.csv").write_text(bare)
    with pytest.raises(InputError, match="which frame"):
        read_xltrc2(tmp_path / "bare.csv")
    assert read_xltrc2(tmp_path / "bare.csv", frame=Frame()).frame == Frame()
    with pytest.raises(InputError, match="leave out frame=") as refused:
        read_xltrc2(tmp_path / "t.csv", frame=Frame(rotation=Rotation.CLOCKWISE))
    assert refused.value.code == "E004"


@given(st.sampled_from(Rotation), st.none() | st.floats(-3.1, 3.1), st.floats(-3.1, 3.1))
def test_the_line_that_declares_a_frame_can_be_read_back(rotation, load, axis):
    frame = Frame(rotation=rotation, load_angle=load, x_axis_angle=axis)
    line = declaration(frame)
    back = declared("Frame: " + line)
    level = replace(frame, x_axis_angle=0.0)
    assert len(declaration(level)) <= 80  # an Ansys title, whose axes are turned back to the horizontal
    assert back.rotation is rotation
    assert math.isclose(back.x_axis_angle, axis, rel_tol=0.0, abs_tol=1e-12)
    assert (back.load_angle is None) == (load is None)
    if load is not None:
        assert math.isclose(back.load_angle, load, rel_tol=0.0, abs_tol=1e-12)
    assert settled("file", back, None) is back


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda text: text.replace("kxx_N_per_m", "kxx"), "no column kxx_N_per_m"),
        (lambda text: text.replace("counter-clockwise", "left"), "allowed: counter-clockwise, clockwise"),
        (lambda text: text.replace("60.0,", "sixty,", 1), "'sixty' is not a number"),
        (lambda text: text.replace("60.0,", '"60,0",', 1), "with a point"),
        (lambda text: text.replace("counter-clockwise", "clockwise", 1), "differ in rotation"),
        (lambda text: text.splitlines()[0], "no row"),
        (lambda text: "", "no column"),
        (lambda text: text.replace("Drive end", '"Drive end', 1), "comma-separated"),
    ],
)
def test_what_is_wrong_in_a_csv_is_said(tmp_path, edit, words):
    write_csv(table(), tmp_path / "t.csv")
    text = (tmp_path / "t.csv").read_text()
    (tmp_path / "t.csv").write_text(edit(text))
    with pytest.raises(InputError, match=words):
        read_csv(tmp_path / "t.csv")


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda text: text[:-5], "not JSON"),
        (lambda text: "[1, 2]", "babbitt_coefficients"),
        (lambda text: text.replace("babbitt_coefficients", "coefficients"), "babbitt_coefficients"),
        (lambda text: '{"babbitt_coefficients": 1, "tables": []}', "no list of tables"),
        (lambda text: '{"babbitt_coefficients": 1, "tables": [3]}', "not an object"),
        (lambda text: text.replace("damping_N_s_per_m", "damping"), "lacks damping_N_s_per_m"),
        (lambda text: text.replace("counter-clockwise", "left"), "rotation"),
        (lambda text: text.replace("60.0,", '"sixty",', 1), "speed_rad_per_s is not an array"),
        (lambda text: text.replace("60.0,", "NaN,", 1), "NaN"),
    ],
)
def test_what_is_wrong_in_a_json_is_said(tmp_path, edit, words):
    write_json(table(), tmp_path / "t.json")
    text = (tmp_path / "t.json").read_text()
    (tmp_path / "t.json").write_text(edit(text))
    with pytest.raises(InputError, match=words):
        read_json(tmp_path / "t.json")


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda text: text.replace("Kxx", "K"), "no row of names"),
        (lambda text: text.replace("Cyx", "C"), "no column cyx"),
        (lambda text: text.replace("rpm", "Hz"), "the unit of speed is 'Hz'"),
        (lambda text: text.replace("N/m", "N/km"), "the unit of Kxx is 'N/km'"),
        (lambda text: text.replace("N-s/m", "N/m", 1), "the unit of Cxx is 'N/m'"),
        (lambda text: text.replace("N-s/m", "", 4), "the unit of Cxx is ''"),
        (lambda text: text.rsplit(",", 1)[0], "is not a number"),
    ],
)
def test_what_is_wrong_in_a_units_row_table_is_said(tmp_path, edit, words):
    write_xltrc2(table(), tmp_path / "t.csv")
    (tmp_path / "t.csv").write_text(edit((tmp_path / "t.csv").read_text()))
    with pytest.raises(InputError, match=words):
        read_xltrc2(tmp_path / "t.csv")


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda lines: lines[:3], "three title lines"),
        (lambda lines: lines[:-1], "8 speeds need 28 lines"),
        (lambda lines: [*lines[:3], "         0", *lines[4:]], "0 speeds"),
        (lambda lines: [*lines[:4], lines[4].replace(".", ""), *lines[5:]], "decimal point"),
        (lambda lines: [*lines[:5], lines[5][:45], *lines[6:]], "four coefficients"),
        (lambda lines: [*lines[:5], "x" * 60, *lines[6:]], "line 6, field 1"),
        (lambda lines: [lines[0], "no frame", *lines[2:]], "which frame"),
    ],
)
def test_what_is_wrong_in_an_ansys_file_is_said(tmp_path, edit, words):
    write_ansys(table(), tmp_path / "t.txt")
    (tmp_path / "t.txt").write_text("\n".join(edit((tmp_path / "t.txt").read_text().splitlines())))
    with pytest.raises(InputError, match=words):
        read_ansys(tmp_path / "t.txt")


@pytest.mark.parametrize("speed", [0.0, 94.2, 999.999999, 1000.0, 12345.678, 999999.99])
def test_number_and_speed_are_two_words_for_ansys(speed):
    line = ansys_text(replace(table(speeds=1), speeds=np.array([speed]), static={})).splitlines()[4]
    assert len(line) == 20
    step, told = line.split()
    assert step == "1"
    assert float(told) == pytest.approx(speed, rel=1e-7, abs=1e-6)


def test_a_speed_too_high_for_ansys_is_refused(tmp_path):
    with pytest.raises(InputError, match="ten columns"):
        write_ansys(replace(table(speeds=1), speeds=np.array([1e8]), static={}), tmp_path / "t.txt")


@pytest.mark.parametrize("read", [read_csv, read_json, read_ansys, read_xltrc2])
def test_files_that_are_not_there_or_not_text(tmp_path, read):
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00\x81")
    for path in (tmp_path / "none.csv", tmp_path / "binary.csv"):
        with pytest.raises(InputError) as refused:
            read(path)
        assert refused.value.code == "E001"


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_by_its_name(tmp_path, name):
    path = tmp_path / f"table{FORMATS[name].suffixes[0]}"
    export(table(), path, name)
    assert path.stat().st_size > 500
    with pytest.raises(InputError) as refused:
        export(table(), Path(tmp_path, "no folder", path.name), name)
    assert refused.value.code == "E007"


FOLLOWING = "stiffness following, damping frozen"
READERS = {
    "ross2": partial(read_ross, version=2),
    "ross3": partial(read_ross, version=3),
    "xltrc2": read_xltrc2,
    "ansys": read_ansys,
    "csv": lambda path: read_csv(path)[0],
    "json": lambda path: read_json(path)[0],
}


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("said", ["frozen", FOLLOWING, ""])
def test_every_file_says_for_which_temperatures_it_holds(tmp_path, name, said):
    for suffix in FORMATS[name].suffixes:
        if suffix == ".xlsx":
            pytest.importorskip("openpyxl")
        path = tmp_path / f"table{suffix}"
        export(table(temperatures=said), path, name)
        assert_same(READERS[name](path), table(temperatures=said), rtol=1e-6, static=False)
        text = path.read_text() if suffix != ".xlsx" else f"Temperatures {said}"
        assert ("emperatures" in text and said in text) if said else "emperatures" not in text or suffix == ".xlsx"


def test_an_ansys_title_cuts_the_method_between_its_parts_and_keeps_the_temperatures(tmp_path):
    method = "Babbitt film, mass conserving cavitation, heat balance at each speed"
    for said, left in (("frozen", method.rpartition(", ")[0]), (FOLLOWING, "Babbitt film"), ("", method)):
        write_ansys(table(temperatures=said, method=method), tmp_path / "t.txt")
        back = read_ansys(tmp_path / "t.txt")
        assert (back.temperatures, back.method) == (said, left)


def test_an_unknown_format_names_the_known(tmp_path):
    with pytest.raises(InputError, match="ross2, ross3"):
        export(table(), tmp_path / "t.json", "ross")


def test_wrong_suffixes_and_same_names_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"\.csv or \.xlsx"):
        write_xltrc2(table(), tmp_path / "t.txt")
    with pytest.raises(InputError, match="Drive end"):
        write_csv([table(), table()], tmp_path / "t.csv")


@pytest.mark.parametrize("write", [write_ansys, write_xltrc2])
def test_rotor_formats_turn_the_axes_back_and_refuse_clockwise(tmp_path, write):
    write(table(), tmp_path / "a.csv")
    write(rotated(rotated(table(), 0.5), -0.5), tmp_path / "b.csv")
    read = read_ansys if write is write_ansys else read_xltrc2
    assert_same(read(tmp_path / "a.csv"), read(tmp_path / "b.csv"), rtol=1.1e-7, static=False)
    with pytest.raises(InputError, match="clockwise"):
        write(mirrored(table()), tmp_path / "c.csv")
