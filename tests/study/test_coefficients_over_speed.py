"""Coefficients over speed: each row is the answer of the bearing at that speed."""

import math

import numpy as np
import pytest
from film_bearings import answer, film
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.export import FORMATS, Rotation, export, mirrored, write_ross
from babbitt.kinds.journal.film import thermal_results as thermal_answer
from babbitt.kinds.journal.film.coefficients_over_speed import run_over_speed
from babbitt.study.speed_range import MOST_SPEEDS, speeds_of

RPM = math.pi / 30.0


def test_each_row_is_the_bearing_at_its_speed():
    table = run_over_speed(film(), [3000.0 * RPM, 1500.0 * RPM]).table()
    assert_allclose(table.speeds, [1500.0 * RPM, 3000.0 * RPM])
    for row, rpm in enumerate((1500, 3000)):
        alone = answer(speed=f"{rpm} rpm")
        assert_allclose(table.stiffness[row], alone.stiffness, rtol=1e-6)
        assert_allclose(table.damping[row], alone.damping, rtol=1e-6)
        for name in ("effective_temperature", "eccentricity_ratio", "total_flow", "friction_power", "load"):
            assert table.static[name][row] == pytest.approx(alone.values[name], rel=1e-6), name
    assert table.static["effective_temperature"][1] > table.static["effective_temperature"][0]  # closed anew
    assert table.frame.rotation is Rotation.COUNTER_CLOCKWISE
    assert table.frame.load_angle == pytest.approx(-math.pi / 2.0)


def test_a_film_with_its_own_temperatures_gives_the_stiffness_that_the_case_asks_for(tmp_path):
    tables = {}
    for kind, said in (("frozen", "frozen"), ("following", "stiffness following, damping frozen")):
        fields = {"thermal": "full", "temperature_coefficients": kind}
        table = tables[kind] = run_over_speed(film(**fields), [3000.0 * RPM]).table()
        alone = answer(**fields)
        assert_allclose(table.stiffness[0], alone.stiffness, rtol=1e-9)
        assert_allclose(table.damping[0], alone.damping, rtol=1e-9)
        assert table.temperatures == mirrored(table).temperatures == said
        for name, one in FORMATS.items():
            path = tmp_path / f"{name}{one.suffixes[0]}"
            if name.startswith("ross"):
                write_ross(table, path, version=int(name[-1]), minimum_speeds=1)
            else:
                export(table, path, name)
            assert said in path.read_text()
    assert_allclose(tables["following"].damping, tables["frozen"].damping, rtol=1e-12)
    assert not np.allclose(tables["following"].stiffness, tables["frozen"].stiffness, rtol=1e-2)
    assert run_over_speed(film(), [200.0]).table().temperatures == "frozen"  # one temperature, kept


def test_a_following_stiffness_that_was_not_found_makes_no_table(monkeypatch):
    monkeypatch.setattr(thermal_answer, "following_stiffness", lambda *_: None)
    run = run_over_speed(film(thermal="full", temperature_coefficients="following"), [300.0])
    assert (run.unsolved, run.unfollowed) == ((), (300.0,))
    with pytest.raises(InputError, match="no stiffness of the kind asked for, at any of the speeds"):
        run.table()


def test_speeds_without_a_film_are_named_in_the_table():
    """At 0.001 rpm no film carries the load."""
    table = run_over_speed(film(), [0.001 * RPM, 3000.0 * RPM]).table()
    assert table.speeds == pytest.approx([3000.0 * RPM])
    assert table.unsolved_speeds == pytest.approx([0.001 * RPM])


def test_the_sense_of_rotation_is_that_of_the_case():
    # the grooves lie evenly about the vertical load: the clockwise bearing is the mirror of the other
    one, other = (run_over_speed(film(speed=speed), [200.0]).table() for speed in ("3000 rpm", "-3000 rpm"))
    assert other.frame.rotation is Rotation.CLOCKWISE
    assert_allclose(mirrored(other).stiffness, one.stiffness, rtol=1e-6)
    assert np.sign(other.stiffness[0, 0, 1]) == -np.sign(one.stiffness[0, 0, 1])


def test_a_speed_without_equilibrium_is_told_and_left_out():
    heavy = film(load="3 MN", effective_temperature="60 degC")
    run = run_over_speed(heavy, [0.01, 300.0])
    assert len(run.solutions) == 2
    assert run.unsolved[0][0] == 0.01
    assert run.table().speeds.tolist() == [300.0]


@pytest.mark.parametrize("speeds", [[], [0.0], [-5.0, 5.0], [math.nan]])
def test_speeds_that_make_no_table(speeds):
    with pytest.raises(InputError, match="positive"):
        run_over_speed(film(), speeds)


def test_speeds_are_read_with_their_units():
    assert_allclose(speeds_of("600 rpm:1200 rpm:3"), np.array([600.0, 900.0, 1200.0]) * RPM)
    assert speeds_of("20 rad/s, 10 rad/s, 20 rad/s") == (10.0, 20.0)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "fast",
        "0 rpm",
        "-100 rpm",
        "5",
        "1 Hz:2 Hz",
        "2 Hz:1 Hz:3",
        "1 Hz:2 Hz:1",
        f"1 Hz:9 Hz:{MOST_SPEEDS + 1}",
        "1 Hz:9 Hz:2.5",
        "5 m",
    ],
)
def test_speeds_that_cannot_be_read(text):
    with pytest.raises(InputError, match="--speeds"):
        speeds_of(text)
