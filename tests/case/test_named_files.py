"""Files that a case names: regular ones, of bounded size, in its folder, and shown safely."""

import io
import os
import zipfile

import numpy as np
import pytest

from babbitt.case import CaseError, Reach, load_case, parse_case
from babbitt.core.files.reading import UnreadableFileError, read_regular

FILM = """\
name: Grooved
kind: journal
method: film
diameter: 200 mm
width: 120 mm
clearance: {kind: relative, mean: 1.5 permille}
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.15 MPa}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
speed: 3000 rpm
"""
NAMED = {
    "bore": 'load: 30 kN\nbore: {kind: measured, file: "FILE"}\n',
    "load": 'dynamic_load: {kind: table, file: "FILE", moving_mass: 0 kg}\n',
    "limits": 'load: 30 kN\nlimits: {tables: "FILE"}\n',
    "displacement": 'load: 30 kN\ndisplacement: {file: "FILE"}\n',
    "compliance": 'load: 30 kN\ncompliance: [{kind: file, file: "FILE"}]\n',
}
BORE = "angle [deg],departure [um]\n" + "".join(f"{angle},0\n" for angle in range(0, 360, 30))


def refusals(path, **given) -> str:
    with pytest.raises(CaseError) as refused:
        load_case(path, **given)
    assert all(problem.line > 0 and problem.field for problem in refused.value.problems)
    return refused.value.message


@pytest.fixture
def case(tmp_path):
    """Write a case that names a file in one of its fields; give the path of the case."""
    folder = tmp_path / "case"
    folder.mkdir()

    def write(where: str, name: str):
        path = folder / "case.yaml"
        path.write_text(FILM + NAMED[where].replace("FILE", name))
        return path

    return write


@pytest.mark.parametrize("where", NAMED)
@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("a\\0b.csv", "null character"),
        ("pipe", "is not a regular file"),
        ("folder", "cannot be read"),
        ("large", "is larger than"),
        ("no\\e[31m.csv", "no\\x1b[31m.csv"),
        ("x" * 300, "cannot be read"),
        ("ring", "cannot be read"),
    ],
)
def test_what_is_no_table_is_refused_at_once(case, where, name, words):
    path = case(where, name)
    os.mkfifo(path.parent / "pipe")
    (path.parent / "folder").mkdir()
    (path.parent / "large").write_bytes(b"x" * 1_000_001)
    (path.parent / "ring").symlink_to("ring")
    said = refusals(path)
    assert words.replace("cannot be read", "") in said
    assert all(character.isprintable() for character in said)


@pytest.mark.parametrize("where", NAMED)
@pytest.mark.parametrize("name", ["../other.csv", "/dev/zero", "/etc/passwd", "link.csv"])
def test_a_file_outside_the_folder_of_the_case_is_refused(case, where, name):
    path = case(where, name)
    (path.parent.parent / "other.csv").write_text(BORE)
    (path.parent / "link.csv").symlink_to("../other.csv")
    assert "outside the folder of the case" in refusals(path)
    assert "--allow-outside" in refusals(path)
    if name == "/dev/zero":
        assert "is not a regular file" in refusals(path, reach=Reach.ANYWHERE)


@pytest.mark.parametrize("name", ["../other.csv", "link.csv"])
def test_a_case_that_is_trusted_reads_elsewhere(case, name):
    path = case("bore", name)
    other = path.parent.parent / "other.csv"
    other.write_text(BORE)
    (path.parent / "link.csv").symlink_to(other)
    (taken,) = load_case(path, reach=Reach.ANYWHERE).files
    assert taken.resolve() == other
    text = path.read_text().replace(name, str(other))
    assert parse_case(text, reach=Reach.ANYWHERE).files == (other,)
    with pytest.raises(CaseError, match="outside the folder"):
        parse_case(text)


def test_a_table_below_the_folder_is_read_and_known_as_an_input(case):
    path = case("bore", "tables/bore.csv")
    (path.parent / "tables").mkdir()
    (path.parent / "tables" / "bore.csv").write_text(BORE)
    assert load_case(path).files == (path.parent / "tables" / "bore.csv",)


def test_an_archive_that_unpacks_to_gigabytes_is_refused_before_it_does(case):
    path = case("compliance", "bomb.npz")
    header = io.BytesIO()
    np.lib.format.write_array_header_1_0(header, {"descr": "<f8", "fortran_order": False, "shape": (25_000_000,)})
    with zipfile.ZipFile(path.parent / "bomb.npz", "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        archive.writestr("angles.npy", header.getvalue() + bytes(200_000_000))
    assert (path.parent / "bomb.npz").stat().st_size < 1_000_000
    assert "unpacks to more than 4 MB" in refusals(path)


@pytest.mark.parametrize("dtype", [object, complex, "U3", "M8[s]"])
def test_an_archive_of_other_than_numbers_is_refused(case, dtype):
    path = case("compliance", "a.npz")
    np.savez(path.parent / "a.npz", angles=np.zeros(2).astype(dtype), compliance=np.zeros((2, 2)))
    assert "cannot be read" in refusals(path)


def test_a_header_that_promises_more_than_the_file_holds_is_refused(case):
    path = case("compliance", "a.npz")
    header = io.BytesIO()
    np.lib.format.write_array_header_1_0(header, {"descr": "<f8", "fortran_order": False, "shape": (10**15,)})
    with zipfile.ZipFile(path.parent / "a.npz", "w") as archive:
        archive.writestr("angles.npy", header.getvalue())
        archive.writestr("compliance.npy", header.getvalue())
    assert "cannot be read" in refusals(path)


def test_a_pipe_is_refused_without_waiting_for_a_writer(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(UnreadableFileError, match="not a regular file"):
        read_regular(tmp_path / "pipe", 10)
