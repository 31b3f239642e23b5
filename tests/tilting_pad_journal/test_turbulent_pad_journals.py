"""Turbulent films of tilting-pad bearings, from the case to the result."""

import math

import pytest
from pad_journals import OIL, pad_case, result_of, solution_of

from babbitt.case import case_from_dict
from babbitt.core.notices import Effect
from babbitt.design.numbers import critical_reynolds_number
from babbitt.kinds.tilting_pad_journal.comparison import compare
from babbitt.kinds.tilting_pad_journal.report.inputs import pad_inputs
from babbitt.report.inputs import Row

FAST = {"lubricant": OIL | {"dynamic_viscosity": "5 mPa s"}, "thermal": "isothermal", "speed": "12000 rpm",
        "load": "3 kN"}  # fmt: skip


def codes(result):
    """Codes of the warnings of a result."""
    return {one.code for one in result.warnings}


@pytest.fixture(scope="module")
def found():
    return {law: result_of(turbulence=law, **FAST) for law in ("laminar", "ng_pan", "constantinescu")}


def test_a_turbulent_film_has_a_verdict_and_names_its_law(found):
    laminar, *turbulent = found.values()
    assert "W407" in codes(laminar)
    assert "turbulent_share" not in laminar.values
    for result, name in zip(turbulent, ("Ng and Pan", "Constantinescu"), strict=True):
        assert "W407" not in codes(result)
        assert result.settings["turbulence"] == name
        assert any(f"Turbulence after {name}" in one for one in result.assumptions)
        assert result.values["friction_power"] > 1.1 * laminar.values["friction_power"]
    assert laminar.settings["turbulence"] == "laminar"


def test_the_share_that_is_turbulent_is_that_of_the_gap(found):
    """Reynolds numbers are those of the gap over the widest clearance, which the result has."""
    values = found["ng_pan"].values
    number, onset = values["film_reynolds_number"], values["critical_reynolds_number"]
    relative = 2.0 * values["largest_pad_clearance"] / values["diameter"]
    assert onset == pytest.approx(critical_reynolds_number(relative))
    assert number * values["minimum_film_thickness"] / values["largest_pad_clearance"] < onset < number
    assert 0.0 < values["turbulent_share"] < 1.0
    slower = result_of(turbulence="ng_pan", **FAST | {"speed": "8000 rpm"})
    assert slower.values["turbulent_share"] < values["turbulent_share"]


def test_coefficients_on_the_assumed_ramp_are_told_of(found):
    """Between the number of vortices and twice it; not below, nor where all loaded films lie above."""
    told = {law: [one for one in result.warnings if one.code == "W420"] for law, result in found.items()}
    assert not told["laminar"]
    (notice,) = told["ng_pan"]
    onset = found["ng_pan"].values["critical_reynolds_number"]
    assert (notice.values["onset"], notice.values["end"]) == pytest.approx((onset, 2.0 * onset))
    assert 0.0 < notice.values["share"] <= 1.0
    assert notice.effect is Effect.INFORMATION
    thin = {"lubricant": OIL | {"dynamic_viscosity": "0.7 mPa s"}, "load": "50 N"}
    slow, fast = (result_of(turbulence="ng_pan", **FAST | other) for other in ({"speed": "1000 rpm"}, thin))
    assert fast.values["turbulent_share"] == pytest.approx(1.0)
    assert not {"W420"} & (codes(slow) | codes(fast))


def test_a_laminar_bearing_does_not_depend_on_the_law():
    plain, lawful = (result_of(turbulence=law, thermal="global") for law in ("laminar", "ng_pan"))
    assert lawful.values["turbulent_share"] == 0.0
    for name, value in plain.values.items():
        if name not in ("wall_time", "iterations"):
            assert lawful.values[name] == pytest.approx(value, rel=1e-10), name


def test_the_heat_of_turbulent_friction_is_in_the_balance():
    fast = FAST | {"thermal": "global", "supply": {"temperature": "40 degC"}}
    turbulent, laminar = (result_of(turbulence=law, **fast).values for law in ("ng_pan", "laminar"))
    assert turbulent["heat_to_oil"] == pytest.approx(turbulent["friction_power"], rel=1e-5)
    assert turbulent["heat_to_oil"] > 1.1 * laminar["heat_to_oil"]


def test_films_with_their_own_temperatures_are_not_compared():
    case = case_from_dict(pad_case(turbulence="ng_pan", **FAST | {"effective_temperature": "40 degC"}))
    (comparison,) = compare(case)
    assert "full is left out: films with their own temperatures are laminar" in comparison.left_out
    assert len(comparison.variants) >= 2


def test_the_report_says_how_the_film_flows():
    solution = solution_of(turbulence="ng_pan", **FAST)
    rows = [row for group in pad_inputs(solution.problem) for row in group.rows]
    assert Row("Flow", "turbulent after Ng and Pan") in rows
    assert math.isfinite(solution.result.values["stiffness_yy"])
