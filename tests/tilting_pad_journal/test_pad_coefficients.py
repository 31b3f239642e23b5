"""Coefficients of pads over speed and frequency, by run and by sweep."""

import json

import numpy as np
import pytest
from pad_journals import HEATED, OIL, pad_case, result_of

import babbitt as bb
from babbitt.case import case_from_dict
from babbitt.core.notices import InputError
from babbitt.export import FORMATS, export, read_csv
from babbitt.export.frame import declaration
from babbitt.kinds.tilting_pad_journal.methods import PAD_FILM
from babbitt.study.speed_range import speeds_of

RPM = np.pi / 30.0
SPEEDS = [1000.0 * RPM, 2000.0 * RPM, 4000.0 * RPM]
ISOTHERMAL = {"thermal": "isothermal", "lubricant": OIL}
HEAVY = {"pads.inertia": "0.02 kg m2", "pads.first_pivot": "-90 deg"}


def at_speeds(changes=None, **fields):
    (problem,) = case_from_dict(pad_case(changes, **fields)).problems()
    return PAD_FILM.coefficients_over_speed(problem, SPEEDS)


def test_every_row_is_the_bearing_at_its_speed():
    table = at_speeds().table()
    alone = result_of(speed="2000 rpm")
    assert table.stiffness[1] == pytest.approx(np.array(alone.stiffness), abs=1e-6 * 1e8)
    assert table.damping[1] == pytest.approx(np.array(alone.damping), abs=1e-6 * 1e5)
    assert table.static["effective_temperature"][1] == pytest.approx(alone.values["effective_temperature"])
    assert "synchronous" in table.method


def test_the_frequency_of_the_rotation_is_on_the_axis():
    table = at_speeds(HEAVY, **ISOTHERMAL).table()
    over = table.over_frequency
    for i, speed in enumerate(SPEEDS):
        j = int(np.flatnonzero(over.frequencies == speed)[0])
        assert over.stiffness[i, j] == pytest.approx(table.stiffness[i], rel=1e-12)
        assert over.damping[i, j] == pytest.approx(table.damping[i], rel=1e-12)
    assert over.frequencies[0] == pytest.approx(0.2 * SPEEDS[0])
    assert over.frequencies[-1] == pytest.approx(1.2 * SPEEDS[-1])


def test_the_matrices_are_those_of_the_coefficients():
    table = at_speeds(HEAVY, **ISOTHERMAL).table()
    system, i, j = table.systems[2], 2, 3
    w = table.over_frequency.frequencies[j]
    z = system.stiffness + 1j * w * system.damping - w**2 * system.mass
    seen = z[:2, :2] - z[:2, 2:] @ np.linalg.solve(z[2:, 2:], z[2:, :2])
    assert seen.real == pytest.approx(table.over_frequency.stiffness[i, j], rel=1e-9)


def test_a_clockwise_bearing_says_so():
    table = at_speeds(speed="-4000 rpm", **ISOTHERMAL).table()
    assert table.frame.rotation.value == "clockwise"
    ahead = at_speeds(**ISOTHERMAL).table()
    assert table.stiffness == pytest.approx(ahead.stiffness, rel=1e-9, abs=1e-3)


def test_the_warnings_of_every_speed_ride_along():
    (problem,) = case_from_dict(pad_case(**ISOTHERMAL)).problems()
    fast = 36000.0 * RPM
    table = PAD_FILM.coefficients_over_speed(problem, [1000.0 * RPM, fast]).table()
    assert "W407" not in (table.warnings[0] if table.warnings else ())
    assert table.warnings[1] == result_of(speed="36000 rpm", **ISOTHERMAL).questioning_codes
    assert "W407" in table.warnings[1]
    assert declaration(table.frame).endswith("load at -90 deg")  # not what the solver leaves of it


@pytest.mark.parametrize("name", ["ross2", "ross3", "xltrc2", "ansys", "json", "csv"])
@pytest.mark.parametrize(("model", "said"), [("A", "thermal adiabatic"), ("E", "thermal full")])
def test_every_format_names_the_thermal_model(name, model, said, tmp_path):
    (problem,) = case_from_dict(pad_case(**HEATED[model])).problems()
    table = PAD_FILM.coefficients_over_speed(problem, speeds_of("1000 rpm:5000 rpm:5")).table()
    path = tmp_path / f"pads{FORMATS[name].suffixes[0]}"
    export(table, path, name)
    text = path.read_text("utf-8")
    assert f"Babbitt tilting pads, {said}, synchronous" in text
    assert name == "ansys" or ("pads that conduct and bend and grow" in text) is (model == "E")


def test_no_speed_and_no_equilibrium_are_told():
    (problem,) = case_from_dict(pad_case()).problems()
    with pytest.raises(InputError, match="each positive"):
        PAD_FILM.coefficients_over_speed(problem, [0.0])


def test_a_sweep_gives_the_same_table(tmp_path):
    bearing = bb.TiltingPadBearing(**{key: value for key, value in pad_case().items() if key != "kind"})
    found = bearing.sweep({"speed": ["1000 rpm", "2000 rpm", "4000 rpm"]})
    table, own = found.coefficient_table(), at_speeds().table()
    assert table.stiffness == pytest.approx(own.stiffness, rel=1e-9, abs=1e-3)
    assert table.over_frequency.damping == pytest.approx(own.over_frequency.damping, rel=1e-9, abs=1e-3)
    found.export(tmp_path / "pads.csv", "csv")
    assert "frequency_rad_per_s" in (tmp_path / "pads.csv").read_text()


def slow_and_fast():
    """At 0.1 rpm no film carries 150 kN; at 2000 rpm one does."""
    (problem,) = case_from_dict(pad_case(load="150 kN", **ISOTHERMAL)).problems()
    return PAD_FILM.coefficients_over_speed(problem, [0.1 * RPM, 2000.0 * RPM, 4000.0 * RPM])


def test_speeds_without_equilibrium_are_left_out_of_the_table():
    found = slow_and_fast()
    assert [round(speed / RPM, 3) for speed, _ in found.unsolved] == [0.1]
    table = found.table()
    assert table.speeds == pytest.approx([2000.0 * RPM, 4000.0 * RPM])
    assert table.unsolved_speeds == pytest.approx([0.1 * RPM])
    alone = result_of(load="150 kN", speed="2000 rpm", **ISOTHERMAL)
    assert table.stiffness[0] == pytest.approx(np.array(alone.arrays["stiffness"]), rel=1e-6, abs=1.0)


def test_export_names_the_speeds_that_it_leaves_out(run, tmp_path):
    (tmp_path / "pads.yaml").write_text(json.dumps(pad_case(load="150 kN", **ISOTHERMAL)))
    speeds = "0.1 rpm, 2000 rpm, 4000 rpm"
    status, _, err = run("export", "pads.yaml", "--format", "csv", "--speeds", speeds, "-o", "pads.csv")
    assert status == 3
    assert "at 0.1 rpm; left out" in err
    assert "2 speeds" in err
    (table,) = read_csv(tmp_path / "pads.csv")
    assert table.speeds == pytest.approx([2000.0 * RPM, 4000.0 * RPM])
