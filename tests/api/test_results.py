"""A result as an object: what it says, what it refuses to say, and what it can be turned into."""

from __future__ import annotations

import copy
import dataclasses
import json
import math
import pickle
from pathlib import Path

import numpy as np
import pint
import pytest
from film_bearings import solved
from front_door_cases import ISO7902, machine_of, result_of

from babbitt.api.machine_results import MachineResults
from babbitt.api.results import BearingResult
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Outcome, Verdict
from babbitt.core.units.pint_quantity import pint_quantity
from babbitt.report.export import to_json


def test_named_quantities_are_those_of_the_engine() -> None:
    one, (engine,) = result_of("grooved"), machine_of("grooved").results
    assert one.solved
    assert one.outcome is Outcome.CONVERGED
    for name, value in engine.values.items():
        assert getattr(one, name) == value == one.values[name]
        assert type(getattr(one, name)) is float
    assert one.stiffness.shape == (2, 2)
    assert one.stiffness.tolist() == [list(row) for row in engine.stiffness]
    assert one.governing_check == engine.governing_check
    assert one.verdict is engine.verdict
    assert one.checks == engine.checks
    assert one.missing == engine.missing


def test_no_quantity_hides_behind_an_attribute() -> None:
    own = {name for name in dir(BearingResult) if not name.startswith("_")}
    own |= {field.name for field in dataclasses.fields(BearingResult)}
    assert not own & set(QUANTITIES)


def test_an_overloaded_bearing_is_not_within_limits() -> None:
    one = result_of("overloaded")
    assert not one.solved
    assert one.within_limits is False
    assert one.verdict is Verdict.NO_SOLUTION
    assert one.governing_check is None
    assert one.message
    assert not one.values
    assert not one.arrays
    assert not one.checks
    with pytest.raises(AttributeError, match="no operating point"):
        _ = one.minimum_film_thickness
    with pytest.raises(AttributeError, match="no operating point"):
        one.quantity("stiffness")
    with pytest.raises(AttributeError, match="no film without an operating point"):
        _ = one.film
    assert "message" in repr(one)


def test_an_unknown_name_tells_the_nearest() -> None:
    one = result_of("grooved")
    with pytest.raises(AttributeError, match="minimum_film_thickness"):
        _ = one.minimum_film_thicknes
    with pytest.raises(AttributeError, match="stiffness"):
        one.quantity("stifness")
    with pytest.raises(AttributeError, match="does not give hot_spot_angle"):
        _ = one.hot_spot_angle
    assert not hasattr(one, "__array_interface__")


def test_what_could_not_be_found_tells_why() -> None:
    one = result_of("grooved")
    answer = dataclasses.replace(one.result, missing={"critical_mass": "the whirl was not followed"}, values={})
    lacking = BearingResult(dataclasses.replace(one.solution, result=answer))
    with pytest.raises(AttributeError, match="the whirl was not followed"):
        _ = lacking.critical_mass


def test_a_result_cannot_be_changed() -> None:
    one = result_of("grooved")
    with pytest.raises(AttributeError):
        one.solution = None  # type: ignore[misc]
    with pytest.raises(AttributeError):
        one.minimum_film_thickness = 1.0
    with pytest.raises(TypeError):
        one.values["load"] = 1.0  # type: ignore[index]
    with pytest.raises(ValueError, match="read-only"):
        one.stiffness[0, 0] = 0.0
    with pytest.raises(ValueError, match="read-only"):
        one.film.pressure[0, 0] = 0.0


@pytest.mark.parametrize("name", ["grooved", "iso7902", "overloaded"])
def test_a_result_survives_pickling_and_copying(name: str) -> None:
    one = result_of(name)
    for again in (pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one)):
        assert again == one
        assert hash(again) == hash(one)
        assert repr(again) == repr(one)


def test_results_are_equal_by_content_and_not_by_time() -> None:
    one = result_of("iso7902")
    slower = dataclasses.replace(one.result, values={**one.result.values, "wall_time": 1e3})
    other = dataclasses.replace(one.result, values={**one.result.values, "load": 1.0})
    assert BearingResult(dataclasses.replace(one.solution, result=slower)) == one
    assert BearingResult(dataclasses.replace(one.solution, result=other)) != one
    assert one != result_of("grooved")
    assert one != 1


def test_quantities_have_their_unit_in_the_registry_of_the_application() -> None:
    one = result_of("grooved")
    thickness = one.quantity("minimum_film_thickness")
    assert thickness.to("um").magnitude == pytest.approx(1e6 * one.minimum_film_thickness)
    assert thickness.check("[length]")
    stiffness = one.quantity("stiffness").to("MN/m")
    assert stiffness.magnitude[1, 1] == pytest.approx(1e-6 * one.stiffness[1, 1])
    ours = pint.get_application_registry().Quantity(1.0, "mm")
    assert (thickness + ours).to("m").magnitude == pytest.approx(1e-3 + one.minimum_film_thickness)
    assert one.quantity("outlet_temperature").to("degC").magnitude == pytest.approx(
        one.outlet_temperature - 273.15
    )
    with pytest.raises(ValueError, match="several units"):
        result_of("moving").quantity("orbit")


@pytest.mark.parametrize("unit", sorted({one.unit for one in QUANTITIES.values()} - {"SI"}))
def test_pint_knows_the_unit_of_every_quantity(unit: str) -> None:
    assert math.isclose(pint_quantity(2.0, unit).to_base_units().magnitude, 2.0)


def test_dir_lists_what_there_is() -> None:
    listed = dir(result_of("grooved"))
    assert {"minimum_film_thickness", "stiffness", "plot", "to_dict", "film"} <= set(listed)
    assert not [name for name in listed if name.startswith("_")]
    assert all(hasattr(result_of("grooved"), name) for name in listed)
    assert "stiffness" not in dir(result_of("overloaded"))


@pytest.mark.parametrize("name", ["grooved", "iso7902", "overloaded", "moving"])
def test_the_text_of_a_result_is_short_and_tells_what_matters(name: str) -> None:
    one = result_of(name)
    text = repr(one)
    assert len(text.splitlines()) < 25
    assert one.verdict.value in text
    assert one.name in text
    if one.solved:
        assert f"{1e6 * one.checked_value('minimum_film_thickness'):.1f} µm" in text
        assert one.governing_check is not None
        assert one.governing_check.code in text
    page = one._repr_html_()
    assert page.startswith("<table")
    assert one.verdict.value in page


def test_markup_in_a_name_is_text_in_a_notebook() -> None:
    one = result_of("grooved")
    named = dataclasses.replace(one.result, name="<b>Gear</b>")
    page = BearingResult(dataclasses.replace(one.solution, result=named))._repr_html_()
    assert "<b>" not in page
    assert "&lt;b&gt;Gear" in page


@pytest.mark.parametrize("name", ["grooved", "overloaded"])
def test_a_dictionary_and_json_are_those_of_the_machine(name: str) -> None:
    (record,) = to_json(machine_of(name))["bearings"]
    assert result_of(name).to_dict() == record
    assert json.loads(result_of(name).to_json()) == record


def test_a_dataset_holds_values_and_matrices_with_units() -> None:
    one = result_of("grooved")
    data = one.to_xarray()
    assert float(data["minimum_film_thickness"]) == one.minimum_film_thickness
    assert data["minimum_film_thickness"].attrs["units"] == "m"
    assert float(data["stiffness"].sel(force="x", motion="y")) == one.stiffness[0, 1]
    assert "wall_time" not in data


def test_a_table_has_one_row() -> None:
    pytest.importorskip("pandas")
    one = result_of("grooved")
    (row,) = one.to_dataframe().to_dict("records")
    assert row["verdict"] == one.verdict.key
    assert row["stiffness_yx"] == one.stiffness[1, 0]
    assert row["damping_xy"] == one.damping[0, 1]
    assert result_of("overloaded").to_dataframe()["outcome"].tolist() == ["overloaded"]


def test_without_pandas_a_table_names_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "pandas", None)
    with pytest.raises(InputError, match="pip install pandas"):
        result_of("grooved").to_dataframe()


def test_a_report_is_written(tmp_path: Path) -> None:
    pytest.importorskip("typst")
    path = tmp_path / "bearing.html"
    result_of("iso7902").write_report(path)
    assert "Bearing" in path.read_text(encoding="utf-8")


def test_fields_are_on_the_grid_of_the_film() -> None:
    one = result_of("grooved")
    assert np.array_equal(one.fields["pressure"], one.film.pressure)
    assert np.array_equal(one.fields["theta"], one.film.angle)
    assert one.fields["pressure"].attrs["units"] == "Pa"
    with pytest.raises(InputError, match="film"):
        _ = result_of("iso7902").fields
    with pytest.raises(AttributeError, match="not kept"):
        _ = one.without_state().fields


@pytest.mark.parametrize("what", ["pressure", "gap", "polar"])
def test_pictures_are_drawn_on_the_axes_that_are_given(what: str) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    figure, axes = pyplot.subplots()
    one = result_of("grooved")
    assert getattr(one.plot, what)(ax=axes) is axes
    assert axes.has_data()
    own = getattr(one.plot, what)()
    assert own.has_data()
    assert own is not axes
    pyplot.close(figure)
    pyplot.close(own.figure)


@pytest.mark.parametrize(("name", "what"), [("grooved", "pressure"), ("moving", "orbit")])
def test_a_result_has_a_picture_of_its_own(name: str, what: str) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    figure, (one, other) = pyplot.subplots(1, 2)
    assert result_of(name).plot(one) is one
    getattr(result_of(name).plot, what)(ax=other)
    assert one.get_xlabel() == other.get_xlabel()
    assert len(one.lines) == len(other.lines)
    assert [text.get_text() for text in one.texts] == [text.get_text() for text in other.texts]
    pyplot.close(figure)
    with pytest.raises(AttributeError, match="the method film has one"):
        result_of("iso7902").plot()


def test_the_pressure_that_is_drawn_is_that_of_the_film() -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    one = result_of("grooved")
    axes = one.plot.pressure()
    assert f"{1e-6 * one.film.pressure.max():.3g}" in [text.get_text() for text in axes.texts]
    pyplot.close(axes.figure)


def test_an_orbit_is_drawn_where_there_is_one() -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    moving = result_of("moving")
    axes = moving.plot.orbit()
    longest = max((line.get_xydata() for line in axes.lines[1:]), key=len)  # the first is the bore
    clearance = moving.solution.state.solution.film.clearance
    assert np.allclose(longest[:-1], moving.orbit[:, 1:3] / clearance)
    pyplot.close(axes.figure)
    with pytest.raises(InputError, match="dynamic_load"):
        result_of("grooved").plot.orbit()
    with pytest.raises(AttributeError, match="the method film has one"):
        result_of("iso7902").plot.pressure()


def test_temperatures_need_a_film_that_has_them() -> None:
    with pytest.raises(InputError, match="thermal: adiabatic"):
        result_of("grooved").plot.temperature()
    with pytest.raises(AttributeError, match="effective_temperature"):
        _ = result_of("grooved").film.temperature


@pytest.mark.slow
def test_temperatures_of_a_thermal_film() -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    one = result_of("thermal")
    assert one.film.temperature.shape == one.film.pressure.shape
    assert one.film.temperature.max() <= one.maximum_temperature + 1e-9
    assert one.film.temperature.min() >= 318.15 - 1e-6  # the oil is fed at 45 degrees and only warms
    axes = one.plot.temperature()
    assert axes.has_data()
    pyplot.close(axes.figure)


def several() -> MachineResults:
    points = [
        {"name": "half", "load": "10 kN", "speed": "1500 rpm"},
        {"name": "full", "load": "30 kN", "speed": "3000 rpm"},
    ]
    limits = {"kind": "relative", "minimum": "1.3 permille", "mean": "1.5 permille", "maximum": "1.7 permille"}
    given = {
        "operating_points": points,
        "load": None,
        "speed": None,
        "clearance": limits,
        "clearance_cases": "all",
    }
    return MachineResults(solved(**(ISO7902 | given)))


def test_a_machine_is_asked_by_bearing_point_and_clearance() -> None:
    found = several()
    assert len(found) == len(found.machine.solutions) == 6
    assert [one.name for one in found] == [one.name for one in found.machine.results]
    one = found.sel(bearing="Bearing", point="full", clearance="minimum")
    assert one == found[one.name]
    assert one.load == pytest.approx(30e3)
    assert one.relative_clearance == pytest.approx(1.3e-3)
    with pytest.raises(KeyError, match="3 results are meant"):
        found.sel(point="full")
    with pytest.raises(KeyError, match="6 results are meant"):
        _ = found["Bearing"]
    with pytest.raises(KeyError, match="did you mean 'full'"):
        found.sel(point="ful")
    with pytest.raises(KeyError, match="did you mean 'Bearing'"):
        _ = found["Bering"]


def test_the_result_of_a_bearing_alone_is_found_by_its_name() -> None:
    found = MachineResults(machine_of("iso7902"))
    assert found["Bearing"].name == "Bearing"
    assert found.solved
    assert found.within_limits is machine_of("iso7902").within_limits


def test_a_machine_as_tables_and_text() -> None:
    found = several()
    assert found.to_dict() == to_json(found.machine)
    assert json.loads(found.to_json()) == found.to_dict()
    text = repr(found)
    assert len(text.splitlines()) == 7
    assert all(one.name in text for one in found)
    assert found._repr_html_().count("<tr>") == 6
    assert pickle.loads(pickle.dumps(found)).to_dict() == found.to_dict()


def test_a_machine_as_a_frame() -> None:
    pytest.importorskip("pandas")
    found = several()
    frame = found.to_dataframe()
    assert frame["point"].tolist() == ["half"] * 3 + ["full"] * 3
    assert frame["load"].tolist() == pytest.approx([10e3] * 3 + [30e3] * 3)


def test_a_machine_is_asked_by_place_and_judged_by_its_worst() -> None:
    found = several()
    assert found[0] == found.results[0]
    assert found[-1] == found.results[-1]
    with pytest.raises(IndexError):
        _ = found[6]
    gravest = list(Verdict)
    assert found.verdict is max((one.verdict for one in found), key=gravest.index)
    assert MachineResults(machine_of("overloaded")).verdict is Verdict.NO_SOLUTION
    assert found.totals == {}


def test_the_totals_of_a_machine_are_the_sums_over_its_bearings() -> None:
    import babbitt as bb

    gear = bb.parse_case(bb.template("machine")).replace({"bearings.1.operating_points": None})
    found = bb.solve(gear)
    assert {"total_flow", "friction_power"} <= set(found.totals)
    assert found.totals["pump_flow"] == sum(one.total_flow for one in found), "what the films want"
    assert found.totals["pump_flow"] > found.totals["total_flow"], "what supplies deliver"
    for name in found.totals.keys() - {"pump_flow"}:
        assert found.totals[name] == sum(
            one.result.values.get(f"starved_{name}", getattr(one, name)) for one in found
        )
    with pytest.raises(TypeError):
        found.totals["total_flow"] = 0.0  # type: ignore[index]


def test_a_machine_as_a_dataset() -> None:
    found = several()
    data = found.to_xarray()
    assert data.sizes["result"] == 6
    assert data["load"].values.tolist() == [one.load for one in found]
    assert data["load"].attrs["units"] == "N"
    assert data["point"].values.tolist() == ["half"] * 3 + ["full"] * 3
    full = data.isel(result=(data["point"] == "full") & (data["clearance"] == "minimum"))
    assert (
        full["minimum_film_thickness"].item()
        == found.sel(point="full", clearance="minimum").minimum_film_thickness
    )


def test_many_results_are_shown_in_few_lines() -> None:
    """Of a machine of forty bearings, and of a sweep of hundreds of points."""
    import babbitt as bb

    one = bb.parse_case(bb.template("journal"))
    bearings = [one.replace(name=f"Bearing {number}") for number in range(40)]
    machine = bb.solve(bb.Machine(bearings=bearings))
    table = one.sweep({"load": np.linspace(5e3, 8e3, 20), "speed": [100.0, 200.0]})
    for shown in (machine, table, table.results[0], bb.Machine(bearings=bearings)):
        assert len(repr(shown).splitlines()) < 25
        assert max(map(len, repr(shown).splitlines())) < 200


@pytest.mark.solves_anew
def test_the_same_case_solved_twice_gives_equal_results() -> None:
    assert BearingResult(solved(**ISO7902).solutions[0]) == result_of("iso7902")


def test_a_checked_value_is_that_of_the_film_against_which_limits_are_held():
    import babbitt as bb

    short = bb.parse_case(bb.template("journal")).solve(
        supply_element=bb.PocketElement(width="30 mm", place="both_sides")
    )
    assert any(one.quantity == "starved_outlet_temperature" for one in short.checks)
    assert short.checked_value("outlet_temperature") == short.starved_outlet_temperature > short.outlet_temperature
    assert "Outlet temperature with the limited flow" in repr(short)
    fed = bb.parse_case(bb.template("journal")).solve(supply={"temperature": "45 degC", "pressure": "3 MPa"})
    assert fed.checked_value("outlet_temperature") == fed.outlet_temperature
    assert "limited flow" not in repr(fed)
    with pytest.raises(AttributeError, match="among the results"):
        fed.checked_value("outlet_temperatur")
