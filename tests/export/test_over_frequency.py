"""Coefficients over speed and frequency: what is written is read, turned with the axes, and condensed alike."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.export import (
    CoefficientTable,
    Frame,
    OverFrequency,
    Rotation,
    SystemMatrices,
    mirrored,
    read_csv,
    read_json,
    read_ross,
    rotated,
    write_ansys,
    write_csv,
    write_json,
    write_ross,
    write_xltrc2,
)

SPEEDS = np.array([100.0, 200.0, 300.0, 400.0, 500.0])
FREQUENCIES = np.array([50.0, 100.0, 200.0, 300.0, 400.0, 500.0, 600.0])
LABELS = ("x", "y", "pad 1 tilt", "pad 1 pivot", "pad 2 tilt")


def system(seed):
    """Matrices of a journal among two pads; stiffness and damping of no symmetry."""
    rng = np.random.default_rng(seed)
    size = len(LABELS)
    stiffness = rng.normal(size=(size, size)) * 1e7 + np.diag([1e9] * size)
    damping = rng.normal(size=(size, size)) * 1e4 + np.diag([1e6] * size)
    return SystemMatrices(LABELS, stiffness, damping, np.diag([0.0, 0.0, 3.0, 2.0, 3.0]))


def reduced(matrices, frequency):
    """Complex stiffness that the journal sees at a frequency, pads eliminated."""
    z = matrices.stiffness + 1j * frequency * matrices.damping - frequency**2 * matrices.mass
    return z[:2, :2] - z[:2, 2:] @ np.linalg.solve(z[2:, 2:], z[2:, :2])


def table(rotation=Rotation.COUNTER_CLOCKWISE):
    """A table whose coefficients are those of the matrices behind them."""
    systems = tuple(system(seed) for seed in range(SPEEDS.size))
    z = np.array([[reduced(one, w) for w in FREQUENCIES] for one in systems])
    at_speed = np.array([reduced(one, w) for one, w in zip(systems, SPEEDS, strict=True)])
    return CoefficientTable(
        name="Pads",
        speeds=SPEEDS,
        stiffness=at_speed.real,
        damping=at_speed.imag / SPEEDS[:, None, None],
        frame=Frame(rotation=rotation, load_angle=-1.5),
        static={"load": np.full(SPEEDS.size, 1e4)},
        method="made up",
        temperatures="frozen",
        over_frequency=OverFrequency(FREQUENCIES, z.real, z.imag / FREQUENCIES[:, None, None]),
        systems=systems,
    )


def same(one, other, exact=True):
    """Whether two tables hold the same numbers."""
    tight = {"rtol": 0.0 if exact else 1e-12}
    assert_allclose(one.stiffness, other.stiffness, **tight)
    assert_allclose(one.damping, other.damping, **tight)
    assert_allclose(one.over_frequency.frequencies, other.over_frequency.frequencies, **tight)
    assert_allclose(one.over_frequency.stiffness, other.over_frequency.stiffness, **tight)
    assert_allclose(one.over_frequency.damping, other.over_frequency.damping, **tight)


@pytest.mark.parametrize(
    ("write", "read", "suffix"), [(write_json, read_json, "json"), (write_csv, read_csv, "csv")]
)
def test_json_and_csv_keep_everything(tmp_path, write, read, suffix):
    path = tmp_path / f"pads.{suffix}"
    write(table(), path)
    (found,) = read(path)
    same(found, table())
    for one, other in zip(found.systems, table().systems, strict=True):
        assert one.labels == other.labels
        for name in ("stiffness", "damping", "mass"):
            assert_allclose(getattr(one, name), getattr(other, name), rtol=0.0)
    assert_allclose(found.static["load"], 1e4)


@pytest.mark.parametrize("suffix", ["json", "toml"])
def test_ross_3_has_both_axes_and_a_row_for_each_speed(tmp_path, suffix):
    path = tmp_path / f"pads.{suffix}"
    write_ross(table(), path, version=3)
    found = read_ross(path, version=3)
    same(found, table(), exact=False)
    if suffix == "json":
        element = json.loads(path.read_text())["BearingElement_Pads"]
        assert element["speed"] == SPEEDS.tolist()
        assert element["frequency"] == FREQUENCIES.tolist()
        assert np.array(element["kxy"]).shape == (SPEEDS.size, FREQUENCIES.size)
        assert element["kxy"][1][3] == table().over_frequency.stiffness[1, 3, 0, 1]


def test_ross_2_has_the_synchronous_coefficients(tmp_path):
    path = tmp_path / "pads.json"
    write_ross(table(), path, version=2)
    element = json.loads(path.read_text())["BearingElement_Pads"]
    assert element["frequency"] == SPEEDS.tolist()
    assert element["cyy"] == table().damping[:, 1, 1].tolist()
    assert read_ross(path, version=2).over_frequency is None


@pytest.mark.parametrize(("write", "suffix"), [(write_ansys, "txt"), (write_xltrc2, "csv")])
def test_other_formats_hold_the_synchronous_coefficients(tmp_path, write, suffix):
    path = tmp_path / f"pads.{suffix}"
    write(table(), path)
    assert path.read_text().count("\n") > SPEEDS.size


def test_turned_matrices_condense_to_turned_coefficients():
    for turned in (rotated(table(), 0.7), mirrored(table())):
        for system_of_one, speed, k, c in zip(
            turned.systems, SPEEDS, turned.stiffness, turned.damping, strict=True
        ):
            z = reduced(system_of_one, speed)
            assert_allclose(z.real, k, rtol=1e-9)
            assert_allclose(z.imag / speed, c, rtol=1e-9)
        i, j = 2, 4
        z = reduced(turned.systems[i], FREQUENCIES[j])
        assert_allclose(z.real, turned.over_frequency.stiffness[i, j], rtol=1e-9)


def test_mirroring_twice_gives_the_table_back():
    again = mirrored(mirrored(table()))
    same(again, table(), exact=False)
    assert_allclose(again.systems[0].stiffness, table().systems[0].stiffness)


@pytest.mark.parametrize(
    ("frequencies", "shape", "words"),
    [
        ([2.0, 1.0], (5, 2, 2, 2), "must increase"),
        ([-1.0, 1.0], (5, 2, 2, 2), "not be negative"),
        ([1.0, 2.0], (5, 3, 2, 2), "has shape"),
        ([1.0, 2.0], (4, 2, 2, 2), "4 speeds"),
        ([], (5, 0, 2, 2), "one or more"),
    ],
)
def test_what_does_not_fit_is_refused(frequencies, shape, words):
    base = table()
    with pytest.raises(InputError, match=words):
        CoefficientTable(
            "A",
            base.speeds,
            base.stiffness,
            base.damping,
            over_frequency=OverFrequency(np.array(frequencies), np.ones(shape), np.ones(shape)),
        )


def test_matrices_that_do_not_fit_are_refused():
    base = table()
    with pytest.raises(InputError, match="for 2 labels"):
        SystemMatrices(("x", "y"), np.eye(3), np.eye(2), np.eye(2))
    with pytest.raises(InputError, match="1 systems"):
        CoefficientTable("A", base.speeds, base.stiffness, base.damping, systems=base.systems[:1])
