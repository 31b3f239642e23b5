"""Results over parameters as arrays, tables and files of coefficients."""

from __future__ import annotations

import pickle
import sys
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from film_bearings import solved
from front_door_cases import UNFED, result_of

from babbitt.api.result_set import ResultSet
from babbitt.api.results import BearingResult
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.export import read_csv, read_ross

SPEEDS = np.array([1000.0, 2000.0, 3000.0, 4000.0, 5000.0]) * np.pi / 30.0


@cache
def at(speed: float, load: str = "30 kN") -> BearingResult:
    rpm = f"{speed * 30.0 / np.pi:.12g} rpm"
    return BearingResult(solved(grooves=UNFED, accuracy="draft", speed=rpm, load=load).solutions[0])


def over_speed(keep: str = "results") -> ResultSet:
    return ResultSet({"speed": SPEEDS}, [at(speed) for speed in SPEEDS], (5,), keep)


def grid() -> ResultSet:
    """A product of which one row is overloaded."""
    loads = ["30 kN", "90 MN"]
    results = [at(speed, load) for load in loads for speed in SPEEDS[1:4]]
    return ResultSet({"load": [30e3, 90e6], "speed": SPEEDS[1:4]}, results, (2, 3))


def test_a_sweep_gives_quantities_and_matrices_as_arrays() -> None:
    table = over_speed()
    assert table["minimum_film_thickness"].tolist() == [at(speed).minimum_film_thickness for speed in SPEEDS]
    assert table["stiffness"].shape == (5, 2, 2)
    assert np.array_equal(table["damping"][3], at(SPEEDS[3]).damping)
    assert np.array_equal(table["speed"], SPEEDS)
    assert np.all(np.diff(table["minimum_film_thickness"]) > 0.0)  # faster journals float higher
    assert table.solved.all()
    with pytest.raises(ValueError, match="read-only"):
        table["stiffness"][0] = 0.0
    with pytest.raises(ValueError, match="read-only"):
        table["speed"][0] = 0.0


def test_unsolved_points_are_not_a_number() -> None:
    table = grid()
    assert table.solved.tolist() == [[True] * 3, [False] * 3]
    assert table.within_limits[1].tolist() == [False] * 3
    assert table.verdicts.shape == (2, 3)
    assert set(table.verdicts[1]) == {Verdict.NO_SOLUTION}
    thickness, stiffness = table["minimum_film_thickness"], table["stiffness"]
    assert thickness.shape == (2, 3)
    assert stiffness.shape == (2, 3, 2, 2)
    assert np.isfinite(thickness[0]).all()
    assert np.isnan(thickness[1]).all()
    assert np.isfinite(stiffness[0]).all()
    assert np.isnan(stiffness[1]).all()


def test_where_nothing_is_solved_a_known_quantity_is_not_a_number() -> None:
    table = ResultSet({"load": [90e6]}, [at(SPEEDS[2], "90 MN")], (1,))
    assert np.isnan(table["minimum_film_thickness"]).all()


def test_an_unknown_name_raises_with_the_nearest() -> None:
    table = over_speed()
    with pytest.raises(KeyError, match="did you mean 'stiffness'"):
        _ = table["stifness"]
    with pytest.raises(KeyError, match="did you mean 'speed'"):
        _ = table["sped"]
    with pytest.raises(KeyError):
        _ = table["hot_spot_angle"]  # known, but not to these results


def test_points_are_found_by_place() -> None:
    table = grid()
    assert table[0, 1] == at(SPEEDS[2])
    assert [one.name for one in table] == [one.name for one in table.results]
    assert len(table) == 6
    assert over_speed()[-1] == at(SPEEDS[-1])
    for place in (0, (0, 3), (0, slice(None))):
        with pytest.raises(IndexError):
            _ = table[place]


def test_parameters_broadcast_or_span_a_product() -> None:
    table = grid()
    assert table["load"].tolist() == [[30e3] * 3, [90e6] * 3]
    assert np.array_equal(table.parameters["speed"], np.tile(SPEEDS[1:4], (2, 1)))
    loads = np.array([[30e3], [90e6]])
    assert np.array_equal(ResultSet({"load": loads}, table.results, (2, 3)).parameters["load"], table["load"])
    with pytest.raises(ValueError, match="has shape"):
        ResultSet({"load": np.zeros(4)}, table.results, (2, 3))
    with pytest.raises(ValueError, match="do not fill"):
        ResultSet({"speed": SPEEDS}, table.results, (5,))


def test_a_sweep_keeps_results_and_no_films() -> None:
    assert all(one.solution.state is None for one in over_speed())
    kept = over_speed("solutions")
    assert kept[0].film.pressure.shape == at(SPEEDS[0]).film.pressure.shape
    assert len(pickle.dumps(over_speed())) < 0.5 * len(pickle.dumps(kept))
    with pytest.raises(ValueError, match="allowed"):
        over_speed("everything")


def test_a_dataset_over_the_parameters() -> None:
    data = grid().to_xarray()
    assert data["minimum_film_thickness"].dims == ("load", "speed")
    assert data["stiffness"].dims == ("load", "speed", "force", "motion")
    assert data["minimum_film_thickness"].attrs["units"] == "m"
    there = data["stiffness"].sel(load=30e3, speed=SPEEDS[2], force="y", motion="x")
    assert float(there) == at(SPEEDS[2]).stiffness[1, 0]
    assert bool(data["solved"].sel(load=90e6).any()) is False
    flat = ResultSet({"load": np.array([[30e3], [90e6]])}, grid().results, (2, 3)).to_xarray()
    assert flat["minimum_film_thickness"].dims == ("axis_0", "axis_1")
    assert flat["load"].shape == (2, 3)


def test_a_frame_with_a_row_for_each_point() -> None:
    pytest.importorskip("pandas")
    frame = grid().to_dataframe()
    assert frame["speed"].tolist() == [*SPEEDS[1:4], *SPEEDS[1:4]]
    assert frame["stiffness_xy"][1] == at(SPEEDS[2]).stiffness[0, 1]
    assert frame["outcome"].tolist() == ["converged"] * 3 + ["overloaded"] * 3


def test_axes_have_units_as_the_quantities_over_them() -> None:
    import babbitt as bb

    pad = bb.parse_case(bb.template("hydrostatic_pad"))
    table = pad.sweep({"load": ["9 kN", "10 kN"], "supply.pressure": [4e6, 5e6]})
    data = table.to_xarray()
    assert data["load"].attrs["units"] == "N"
    assert data["supply.pressure"].attrs["units"] == "Pa"
    assert data["supply.pressure"].attrs["long_name"]
    assert data["load"].values.tolist() == [9e3, 10e3]
    broadcast = pad.solve(load=["9 kN", "10 kN"])
    assert broadcast.to_xarray()["load"].attrs == data["load"].attrs
    pytest.importorskip("pandas")
    units = table.to_dataframe().attrs["units"]
    assert (units["load"], units["supply.pressure"], units["minimum_film_thickness"]) == ("N", "Pa", "m")
    assert over_speed().to_dataframe().attrs["units"]["stiffness_xy"] == "N/m"
    assert "verdict" not in units


def test_coefficients_are_exported_over_speed(tmp_path: Path) -> None:
    table = over_speed()
    table.export(tmp_path / "one.csv", format="csv")
    (read,) = read_csv(tmp_path / "one.csv")
    assert read.speeds == pytest.approx(SPEEDS)
    assert read.stiffness == pytest.approx(table["stiffness"])
    assert read.damping == pytest.approx(table["damping"])
    assert read.frame.load_angle == pytest.approx(-0.5 * np.pi)
    table.export(tmp_path / "one.json", format="ross", version=3)
    assert read_ross(tmp_path / "one.json", version=3).stiffness == pytest.approx(table["stiffness"])


def test_coefficients_are_those_of_the_run_over_speed() -> None:
    """The table of the method film over speeds, which solves each speed by itself."""
    from babbitt.kinds.journal.film.coefficients_over_speed import run_over_speed

    run = run_over_speed(at(SPEEDS[0]).solution.problem, SPEEDS).table()
    ours = over_speed().coefficient_table()
    assert ours.stiffness == pytest.approx(run.stiffness, rel=1e-6)
    assert ours.frame.rotation is run.frame.rotation
    assert (ours.method, ours.temperatures) == (run.method, run.temperatures)
    assert set(ours.static) >= {"load", "eccentricity_ratio"}
    assert ours.static["friction_power"] == pytest.approx(run.static["friction_power"], rel=1e-6)


def test_what_no_table_holds_is_refused(tmp_path: Path) -> None:
    table = over_speed()
    path = tmp_path / "one.csv"
    with pytest.raises(InputError, match="version=2 or version=3"):
        table.export(path, format="ross")
    with pytest.raises(InputError, match="ross"):
        table.export(path, format="csv", version=3)
    with pytest.raises(InputError, match="did you mean 'xltrc2'"):
        table.export(path, format="xltrc")
    with pytest.raises(InputError, match="no equilibrium"):
        grid().export(path, format="csv")
    with pytest.raises(InputError, match="speed alone"):
        ResultSet({"load": [1.0, 2.0]}, [at(SPEEDS[0])] * 2, (2,)).export(path, format="csv")
    with pytest.raises(InputError, match="film has"):
        ResultSet({"load": [1.0]}, [result_of("iso7902")], (1,)).export(path, format="csv")
    assert not path.exists()


def test_without_ross_an_element_names_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ross", None)
    with pytest.raises(InputError, match="pip install ross-rotordynamics"):
        over_speed().to_ross(n=0, tag="DE")


@pytest.mark.parametrize(("version", "axis"), [("2.1.0", "frequency"), ("3.0.0", "speed")])
def test_an_element_speaks_the_version_of_ross(monkeypatch: pytest.MonkeyPatch, version: str, axis: str) -> None:
    made = SimpleNamespace(__version__=version, BearingElement=lambda **given: given)
    monkeypatch.setitem(sys.modules, "ross", made)
    element = over_speed().to_ross(n=4, tag="DE")
    assert (element["n"], element["tag"]) == (4, "DE")
    assert element[axis] == pytest.approx(SPEEDS.tolist())
    assert element["kxy"] == pytest.approx(over_speed()["stiffness"][:, 0, 1].tolist())
    assert "babbitt" not in element


def test_the_element_of_an_installed_ross() -> None:
    ross = pytest.importorskip("ross")
    element = over_speed().to_ross(n=0, tag="DE")
    assert isinstance(element, ross.BearingElement)
    assert element.K(SPEEDS[2])[0, 0] == pytest.approx(at(SPEEDS[2]).stiffness[0, 0], rel=1e-2)


def test_a_set_tells_in_few_lines_what_it_is() -> None:
    text = repr(grid())
    assert len(text.splitlines()) < 25
    assert "load (2), speed (3)" in text
    assert "3 no solution" in text
    assert pickle.loads(pickle.dumps(grid()))["stiffness"].shape == (2, 3, 2, 2)
