"""Bearing elements for ROSS 2 and 3: round trip, refusals, and the real ROSS where it is installed."""

import json
import warnings

import numpy as np
import pytest
from coefficient_tables import assert_same, table
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.export import (
    CoefficientTable,
    Frame,
    RossVersion,
    mirrored,
    read_ross,
    rotated,
    write_ross,
    write_xltrc2,
)

MASS = np.linspace(-30.0, 90.0, 32).reshape(8, 2, 2)
VERSIONS = (2, 3)
SUFFIXES = (".json", ".toml")


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", ["DE", "Drive end", 'pinion.2 "outer" é'])
@pytest.mark.parametrize("mass", [None, MASS])
def test_what_is_written_is_read(tmp_path, version, suffix, name, mass):
    path = tmp_path / f"bearing{suffix}"
    for frame in (Frame(), Frame(load_angle=None)):
        written = table(name=name, mass=mass, frame=frame)
        write_ross(written, path, version=version, node=3)
        assert_same(read_ross(path, version=version), written)


@pytest.mark.parametrize(("version", "axis", "other"), [(2, "frequency", "speed"), (3, "speed", "frequency")])
def test_the_axis_has_the_name_of_its_version(tmp_path, version, axis, other):
    write_ross(table(), tmp_path / "b.json", version=version, node=5)
    (block, element), *rest = json.loads((tmp_path / "b.json").read_text()).items()
    assert (block, rest) == ("BearingElement_Drive end", [])
    assert element["n"] == 5
    assert_allclose(element[axis], table().speeds, rtol=0.0)
    assert other not in element
    assert_allclose(element["kxy"], table().stiffness[:, 0, 1], rtol=0.0)
    assert_allclose(element["cyx"], table().damping[:, 1, 0], rtol=0.0)
    assert "mxx" not in element


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize(("written", "read"), [(2, 3), (3, 2)])
def test_a_file_of_the_other_version_is_refused(tmp_path, suffix, written, read):
    path = tmp_path / f"b{suffix}"
    write_ross(table(), path, version=written)
    with pytest.raises(InputError, match=f"written for ROSS {written}"):
        read_ross(path, version=read)


def test_the_axes_of_files_that_ross_wrote_are_told_apart(tmp_path):
    path = tmp_path / "b.json"
    lists = {name: [1.0, 2.0] for name in ("kxx", "cxx")}
    path.write_text(json.dumps({"BearingElement_A": {"n": 0, "tag": "A", "frequency": [1.0, 2.0], **lists}}))
    assert_allclose(read_ross(path, version=2).speeds, [1.0, 2.0])
    with pytest.raises(InputError, match="whirl frequency"):
        read_ross(path, version=3)
    path.write_text(json.dumps({"BearingElement_A": {"n": 0, "speed": [1.0, 2.0], "frequency": None, **lists}}))
    assert read_ross(path, version=3, load_angle=-1.0).frame == Frame(load_angle=-1.0)
    assert read_ross(path, version=3).name == "A"
    with pytest.raises(InputError, match="version=3"):
        read_ross(path, version=2)


def test_coefficients_left_out_are_what_ross_takes_for_them(tmp_path):
    path = tmp_path / "b.json"
    element = {"n": 0, "speed": [1.0, 2.0], "kxx": [5.0, 6.0], "kyx": -3.0, "cxx": 7.0, "cyy": [8.0, 9.0]}
    path.write_text(json.dumps({"parameters": {}, "BearingElement_A": element, "ShaftElement_0": {}}))
    read = read_ross(path, version=3)
    assert_allclose(read.stiffness, [[[5.0, 0.0], [-3.0, 5.0]], [[6.0, 0.0], [-3.0, 6.0]]])
    assert_allclose(read.damping, [[[7.0, 0.0], [0.0, 8.0]], [[7.0, 0.0], [0.0, 9.0]]])
    assert read.mass is None


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ({}, "there are: none"),
        ({"BearingElement_A": {}, "BearingElement_B": {}}, "there are: A, B"),
        ({"BearingElement_A": {"kxx": 1.0, "cxx": 1.0}}, "no list 'speed'"),
        ({"BearingElement_A": {"speed": [1.0], "kxx": [1.0]}}, "no 'cxx'"),
        ({"BearingElement_A": {"speed": [1.0], "kxx": [1.0, 2.0], "cxx": 1.0}}, "2 values for 1 speed"),
        ([1], "there are: none"),
    ],
)
def test_what_is_wrong_in_a_ross_file_is_said(tmp_path, content, words):
    (tmp_path / "b.json").write_text(json.dumps(content))
    with pytest.raises(InputError, match=words):
        read_ross(tmp_path / "b.json", version=3)


def test_one_of_several_bearings_is_chosen_by_its_tag(tmp_path):
    write_ross(table(name="A"), tmp_path / "a.json", version=2)
    write_ross(table(name="B"), tmp_path / "b.json", version=2)
    both = {**json.loads((tmp_path / "a.json").read_text()), **json.loads((tmp_path / "b.json").read_text())}
    (tmp_path / "both.json").write_text(json.dumps(both))
    assert read_ross(tmp_path / "both.json", version=2, tag="B").name == "B"


def test_damaged_and_foreign_files_are_refused(tmp_path):
    for name in ("b.json", "b.toml"):
        (tmp_path / name).write_text("= {")
        with pytest.raises(InputError, match=r"not (JSON|TOML)"):
            read_ross(tmp_path / name, version=2)
    for call in (lambda path: write_ross(table(), path, version=2), lambda path: read_ross(path, version=2)):
        with pytest.raises(InputError, match=r"use \.json or \.toml"):
            call(tmp_path / "b.yaml")


@pytest.mark.parametrize("version", [1, 4, "3.1", None])
def test_no_other_version_is_accepted(tmp_path, version):
    with pytest.raises(InputError, match="2 or 3"):
        write_ross(table(), tmp_path / "b.json", version=version)
    with pytest.raises(TypeError):
        write_ross(table(), tmp_path / "b.json")


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("speeds", [1, 2, 4])
def test_few_speeds_are_refused_until_they_are_accepted(tmp_path, version, speeds):
    few = table(speeds=speeds)
    with pytest.raises(InputError, match=f"{speeds} speed") as refused:
        write_ross(few, tmp_path / "b.json", version=version)
    assert f"minimum_speeds={speeds}" in refused.value.message
    write_ross(few, tmp_path / "b.json", version=version, minimum_speeds=speeds)
    assert_same(read_ross(tmp_path / "b.json", version=version), few)
    write_ross(table(speeds=5), tmp_path / "b.json", version=version)


def test_clockwise_and_negative_nodes_are_refused_and_axes_turned_back(tmp_path):
    with pytest.raises(InputError, match="clockwise"):
        write_ross(mirrored(table()), tmp_path / "b.json", version=3)
    with pytest.raises(InputError, match="from 0"):
        write_ross(table(), tmp_path / "b.json", version=3, node=-1)
    write_ross(rotated(table(), 1.1), tmp_path / "b.json", version=3)
    assert_same(read_ross(tmp_path / "b.json", version=3), table(), rtol=1e-9)


# -- with ROSS itself ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def ross():
    """The installed ROSS; its import warns about many things that are none of ours."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip("ross")


def version_of(ross):
    """The file version an installed ROSS reads: 3 from 3.0 on."""
    return RossVersion(2 if int(ross.__version__.split(".")[0]) < 3 else 3)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", ["DE", "Drive end", "Lager é"])
def test_ross_loads_the_element_and_finds_the_coefficients(tmp_path, ross, suffix, name):
    ours = table(name=name, speeds=12, mass=np.linspace(-30.0, 90.0, 48).reshape(12, 2, 2))
    path = tmp_path / f"bearing{suffix}"
    write_ross(ours, path, version=version_of(ross), node=2)
    element = ross.BearingElement.load(path)
    assert (element.n, element.tag) == (2, name)
    for i, speed in enumerate(ours.speeds):
        assert_allclose(element.K(speed)[:2, :2], ours.stiffness[i], rtol=1e-6)
        assert_allclose(element.C(speed)[:2, :2], ours.damping[i], rtol=1e-4)
        assert_allclose(element.M(speed)[:2, :2], ours.mass[i], atol=2.0)  # version 2 smooths what is small
    between = 0.5 * (ours.speeds[3] + ours.speeds[4])
    assert_allclose(element.K(between)[1, 0], -1.2e9 - 4e6 * between, rtol=1e-6)
    assert_allclose(element.C(between)[1, 1], 9e9 / between, rtol=5e-3)


@pytest.mark.filterwarnings("ignore")
def test_what_ross_saves_is_read(tmp_path, ross):
    version = version_of(ross)
    ours = table(name="DE")
    lists = {
        letter + name: values[:, i, j]
        for letter, values in (("k", ours.stiffness), ("c", ours.damping))
        for name, i, j in (("xx", 0, 0), ("xy", 0, 1), ("yx", 1, 0), ("yy", 1, 1))
    }
    for suffix in SUFFIXES:
        ross.BearingElement(n=1, tag="DE", **{version.axis: ours.speeds}, **lists).save(tmp_path / f"b{suffix}")
        read = read_ross(tmp_path / f"b{suffix}", version=version)
        assert_allclose(read.stiffness, ours.stiffness, rtol=1e-15)
        assert_allclose(read.damping, ours.damping, rtol=1e-15)
        assert_allclose(read.speeds, ours.speeds, rtol=1e-15)
        assert read.frame == Frame(load_angle=None)


@pytest.mark.filterwarnings("ignore")
def test_in_ross_3_the_dependence_is_on_rotor_speed_and_not_on_whirl_frequency(tmp_path, ross):
    if version_of(ross) is RossVersion.TWO:
        pytest.skip("version 2 knows one axis only")
    ours = table()
    write_ross(ours, tmp_path / "right.json", version=3)
    right = ross.BearingElement.load(tmp_path / "right.json")
    low, high = ours.speeds[[0, -1]]
    assert_allclose(right.K(frequency=high, speed=low)[:2, :2], ours.stiffness[0], rtol=1e-12)
    write_ross(ours, tmp_path / "wrong.json", version=2)
    wrong = ross.BearingElement.load(tmp_path / "wrong.json")  # why the version is never guessed
    assert_allclose(wrong.K(frequency=high, speed=low)[:2, :2], ours.stiffness[-1], rtol=1e-12)


@pytest.mark.filterwarnings("ignore")
def test_ross_reads_the_workbook(tmp_path, ross):
    pytest.importorskip("openpyxl")
    ours = table(name="bulb of 3000 lb")  # the letters that make ROSS convert must not stand on the first sheet
    write_xltrc2(ours, tmp_path / "t.xlsx")
    element = ross.BearingElement.from_table(n=0, file=str(tmp_path / "t.xlsx"))
    for i, speed in enumerate(ours.speeds):
        assert_allclose(element.K(speed)[:2, :2], ours.stiffness[i], rtol=1e-6)
        assert_allclose(element.C(speed)[:2, :2], ours.damping[i], rtol=1e-4)


@pytest.mark.filterwarnings("ignore")
def test_cross_coupling_drives_the_same_whirl_in_ross(tmp_path, ross):
    """Positive k_xy with negative k_yx feeds the whirl in the sense of rotation: x towards y, as in our frame."""
    speeds = np.linspace(50.0, 250.0, 5)
    k = np.broadcast_to(np.array([[1e7, 4e6], [-4e6, 1e7]]), (5, 2, 2))
    c = np.broadcast_to(np.diag([1e3, 1e3]), (5, 2, 2))
    elements = []
    for node in (0, 4):
        driven = CoefficientTable(f"at node {node}", speeds, k, c)  # ROSS wants different tags in a rotor
        write_ross(driven, tmp_path / f"{node}.json", version=version_of(ross), node=node)
        elements.append(ross.BearingElement.load(tmp_path / f"{node}.json"))
    steel = ross.Material(name="steel", rho=7810.0, E=211e9, G_s=81.2e9)
    shaft = [ross.ShaftElement(L=0.25, idl=0.0, odl=0.05, material=steel) for _ in range(4)]
    disk = ross.DiskElement.from_geometry(n=2, material=steel, width=0.07, i_d=0.05, o_d=0.28)
    modal = ross.Rotor(shaft, [disk], elements).run_modal(speed=150.0, num_modes=12)
    whirl = modal.whirl_direction()
    unstable = [whirl[i] for i in range(2) if modal.log_dec[i] < 0.0]
    stable = [whirl[i] for i in range(2) if modal.log_dec[i] > 0.0]
    assert unstable == ["Forward"]
    assert stable == ["Backward"]
