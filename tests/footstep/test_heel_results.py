"""From a case file of a footstep to results: states, warnings, status without a steady state, conventions."""

import json
from dataclasses import replace

import pytest
from heels import STUDY

from babbitt.case import parse_case
from babbitt.core.result import Outcome
from babbitt.report.export import to_json, write_json
from babbitt.reynolds.equilibrium import position
from babbitt.solving import solve

TEXT = STUDY


def solved(**changes):
    text = TEXT
    for old, new in changes.values():
        assert old in text
        text = text.replace(old, new, 1)
    return solve(parse_case(text))


def codes(result):
    return {notice.code for notice in result.warnings}


def test_all_states_of_the_pump():
    machine = solved()
    names = [result.name for result in machine.results]
    assert names == [f"Pump footstep ({state})" for state in ("smooth heel", "hot state", "cold state")]
    assert len(machine.problems) == 3
    smooth, hot, cold = machine.results
    assert hot.load == pytest.approx(829.1176, rel=1e-5)
    assert hot.load_ratio_to_smooth == pytest.approx(hot.load / smooth.load, rel=1e-12)
    assert hot.friction_ratio_to_smooth == pytest.approx(66.63353 / 35.08568, rel=1e-5)
    assert hot.critical_clearance == pytest.approx(10.482e-6, abs=1e-9)
    assert [result.settings["stable"] for result in machine.results] == ["yes", "no", "yes"]
    assert [result.checks[0].ok for result in machine.results] == [True, False, True]
    for result in machine.results:
        (gain,) = [check for check in result.checks if check.code == "C130"]
        assert gain.value == result.values["thermal_loop_gain"]
        assert gain.advisory
        assert (gain.value < gain.limit == 1.0) == gain.ok == (result.settings["stable"] == "yes")
    assert "W160" in codes(hot)
    assert "W166" in codes(cold)
    assert "W160" not in codes(cold)
    assert "W167" in codes(smooth)
    assert "W168" in codes(hot)
    assert "W168" not in codes(smooth)
    assert all("W171" in codes(result) for result in machine.results)
    assert hot.groove_reynolds_number == pytest.approx(38.25, abs=0.01)
    assert smooth.recess_reynolds_number == pytest.approx(416.0, abs=0.5)


def test_no_steady_state_says_why():
    machine = solved(gap=("face_gap: 20 um", "face_gap: 12 um"), clearance=("mean: 20 um", "mean: 10 um"))
    smooth, grooved = machine.results
    assert smooth.outcome.solved
    assert grooved.outcome is Outcome.NO_STEADY_STATE
    assert grooved.outcome.code == "S020"
    assert not machine.solved
    assert "receives more oil than the clearance carries away" in grooved.message
    assert "10.48 µm" in grooved.message
    assert "drains the rim instead there is a stable state: 0.4509 MPa" in grooved.message
    assert "lower speed" not in grooved.message  # it only makes the groove weaker
    record = to_json(machine)["bearings"][1]
    assert record["status"] == "no_steady_state"
    assert record["results"] == {}
    assert record["last_state"]["fold_clearance"] == pytest.approx(10.482e-6, abs=1e-9)
    assert record["verdict"] == "no_solution"


def test_a_weak_groove_drains_the_rim():
    """Cold oil at 400 rpm: closed form 6.1 holds with a negative groove flow, p1 - p_a = 0.2937 MPa."""
    machine = solved(speed=("speed: 1450 rpm", "speed: 400 rpm"), oil=("exponent: 0.026 1/K", "exponent: 0 1/K"))
    (draining,) = machine.results[1:]
    assert draining.outcome.solved
    assert draining.rim_pressure == pytest.approx(0.3947e6, rel=1e-4)
    assert draining.heel_groove_flow < 0.0
    assert draining.load < machine.results[0].load
    assert "W178" in codes(draining)


def test_states_that_are_no_operating_point_have_no_verdict():
    from babbitt.core.notices import explanations
    from babbitt.core.notices.explanation import Effect

    smooth, hot, cold = solved().results
    for result in (smooth, hot, cold):  # friction would warm the oil by 787, 285 and 110 K
        assert any(explanations()[code].effect is Effect.NO_VERDICT for code in codes(result))
    assert explanations()["W160"].effect is Effect.NO_VERDICT
    metal = solved(method=("method: superposition", "method: narrow_groove"), wall=("# wall:", "wall:"))
    for result in metal.results:
        assert not any(explanations()[code].effect is Effect.NO_VERDICT for code in codes(result))


def test_balances_are_results():
    for result in solved().results:
        assert result.mass_balance_error < 1e-10
        assert 0.9 < result.energy_balance_error < 1.0  # the shear of heel and lands warms nothing
    for result in solved(
        method=("method: superposition", "method: narrow_groove"), wall=("# wall:", "wall:")
    ).results:
        assert result.mass_balance_error < 1e-10
        assert result.energy_balance_error < 0.02


def test_options_of_the_study_are_refused_with_narrow_grooves():
    from babbitt.case import CaseError

    text = TEXT.replace("method: superposition", "method: narrow_groove") + "options: {speed_reduction: 0.25}\n"
    with pytest.raises(CaseError, match="speed_reduction"):
        parse_case(text)


def test_gauge_pressures_are_the_same_footstep():
    absolute = solved()
    gauge = solved(
        kind=("pressures: absolute", "pressures: gauge"),
        p=("  pressure: 0.63 MPa", "  pressure: 0.529 MPa"),
    )
    for one, other in zip(absolute.results, gauge.results, strict=True):
        assert other.load == pytest.approx(one.load, rel=1e-9)


def test_the_load_may_count_pressures_above_ambient():
    above = solved(load=("load_reference: absolute", "load_reference: gauge"))
    assert above.results[0].load == pytest.approx(833.5885 - 142.86, rel=1e-4)


@pytest.mark.parametrize(
    ("code", "old", "new"),
    [
        ("W161", "face_gap: 20 um", "face_gap: 5 um"),
        ("W162", "  depth: 0.3 mm", "  depth: 55 um"),
        ("W163", "ambient_pressure: 0.101 MPa", "ambient_pressure: 40 kPa"),
        ("W164", "  recess_depth: 5 mm", "  recess_depth: 30 mm"),
        ("W165", "  starts: 5\n", "  starts: 6\n  accept_misfit: true\n"),
    ],
)
def test_doubts(code, old, new):
    assert code not in codes(solved().results[1])
    assert code in codes(solved(change=(old, new)).results[-2])


def test_narrow_grooves_in_metal():
    machine = solved(
        method=("method: superposition", "method: narrow_groove"), wall=("# wall:", "wall:")
    )  # 10 W/K, 25 °C
    smooth, grooved = machine.results
    assert grooved.load == pytest.approx(941.16, abs=0.05)
    assert smooth.load == pytest.approx(824.12, abs=0.05)
    assert "W169" in codes(grooved)
    assert not {"W168", "W171"} & (codes(grooved) | codes(smooth))
    assert grooved.clearance_film_temperature == grooved.maximum_temperature
    assert "critical_clearance" not in grooved.values


def test_an_eccentric_heel_is_pushed_and_leaks_more():
    machine = solved(eccentric=("# eccentricity_ratio: 0.3", "eccentricity_ratio: 0.3"))
    smooth, hot, _ = machine.results
    assert smooth.leak_factor == pytest.approx(1.135, rel=1e-12)
    assert smooth.leakage_side_force == 0.0
    assert smooth.heel_force_along < 0.0 < smooth.heel_force_across  # a journal bearing pushes back and across
    assert "heel_force_along" not in hot.values
    assert "W170" in codes(hot)


def test_a_heel_without_a_film_of_its_own_tells_no_force_of_it(monkeypatch):
    def unsolved(film, position):
        return replace(solve_at(film, position), outcome=Outcome.NOT_CONVERGED)

    solve_at = position.film_at_position
    monkeypatch.setattr(position, "film_at_position", unsolved)
    smooth, *_ = solved(eccentric=("# eccentricity_ratio: 0.3", "eccentricity_ratio: 0.3")).results
    assert not {"heel_force_along", "heel_force_across"} & set(smooth.values)
    assert set(smooth.missing) == {"heel_force_along", "heel_force_across"}
    assert "has not been solved" in smooth.missing["heel_force_along"]


def test_variants():
    assert [r.name for r in solved(v=("variants: both", "variants: smooth")).results] == [
        "Pump footstep (smooth heel)"
    ]
    assert len(solved(v=("variants: both", "variants: grooved")).results) == 2


def test_json_is_finite_and_names_are_known():
    from babbitt.core.quantities import QUANTITIES

    machine = solved()
    assert json.loads(write_json(machine))["bearings"][1]["settings"]["state"] == "hot"
    for result in machine.results:
        assert set(result.values) <= set(QUANTITIES)


@pytest.mark.parametrize(("gap", "clearance", "told"), [(20, 20, False), (236, 0.553, False), (1000, 0.5, True)])
def test_a_balance_of_the_rim_that_stays_open_is_told(gap, clearance, told):
    """Beside a face gap 2000 times the clearance the rim has the pressure of the recess but for round-off."""
    smooth = solved(
        gap=("face_gap: 20 um", f"face_gap: {gap} um"),
        clearance=("mean: 20 um", f"mean: {clearance} um"),
    ).results[0]
    assert (smooth.mass_balance_error > 1e-6) is told
    assert ("W177" in codes(smooth)) is told
    if told:
        assert smooth.verdict.value == "no verdict"
