"""A rotor on two bearings, driven by cross-coupling and on pedestals: closed forms, both kinds of coefficients."""

import math

import numpy as np
import pytest
from pad_journals import OIL, pad_case, result_of, solution_of

from babbitt.case import case_from_dict
from babbitt.core.result import Verdict
from babbitt.kinds.tilting_pad_journal.cross_coupling import decrements_over_speed
from babbitt.kinds.tilting_pad_journal.level_one import about_synchronous_verdict
from babbitt.reynolds.tilting_pads.dynamics import condensed_at
from babbitt.solving import solve

ISOTHERMAL = {"thermal": "isothermal", "lubricant": OIL}
ROTOR = ISOTHERMAL | {"rotor_mass": "2 t", "anticipated_cross_coupling": "8 MN/m"}
PEDESTAL = {
    "stiffness_x": "600 MN/m", "stiffness_y": "1 GN/m", "damping_x": "20 kN s/m", "damping_y": "50 kN s/m",
    "mass": "300 kg",
}  # fmt: skip
PLACE = ("eccentricity_ratio", "minimum_film_thickness", "friction_power", "total_flow", "journal_y")


def codes(result):
    """Of all warnings."""
    return {one.code for one in result.warnings}


@pytest.fixture(scope="module")
def rigid():
    """Four equal pads with the load between two: stiffness and damping are the same in both directions."""
    return solution_of(**ROTOR)


def test_an_isotropic_bearing_bears_its_damping_times_the_frequency(rigid):
    """Whirl in circles at Q_0: -m w^2 + K(w) + j w C(w) - j Q = 0, each of both bearings with half of Q."""
    found, full = rigid.state.cross_coupling, rigid.state.dynamics.full
    at = condensed_at(full, found.full.frequency / full.speed)
    assert at.stiffness[0, 0] == pytest.approx(at.stiffness[1, 1], rel=1e-6)
    assert found.full.frequency**2 * 2e3 == pytest.approx(at.stiffness[0, 0], rel=1e-5)
    assert found.full.critical == pytest.approx(2.0 * found.full.frequency * at.damping[0, 0], rel=1e-5)


def test_reduced_coefficients_in_closed_form(rigid):
    v = rigid.result.values
    k, c, m = v["stiffness_xx"], v["damping_xx"], 2e3
    assert v["synchronous_critical_cross_coupling"] == pytest.approx(2.0 * c * math.sqrt(k / m), rel=1e-6)
    for cross, name in ((0.0, "synchronous_log_decrement"), (8e6, "synchronous_log_decrement_anticipated")):
        roots = np.roots([m, c, k - 0.5j * cross])
        forward = roots[np.argmax(roots.imag)]
        assert v[name] == pytest.approx(-2.0 * math.pi * forward.real / forward.imag, rel=1e-6)


def test_a_shaft_far_softer_than_the_bearing_decides_alone():
    """Jeffcott rotor whose bearings hardly move: frequency of the shaft, damping c (k_s/K)^2 of the bearings."""
    soft = {"shaft_stiffness": "1 MN/m", "anticipated_cross_coupling": "100 N/m"}
    result = result_of(**ROTOR | soft, whirl_ratios=[0.05, 0.06])
    v, shaft, m = result.values, 1e6, 2e3
    assert v["whirl_frequency_forward"] == pytest.approx(math.sqrt(shaft / m), rel=5e-3)
    slow = result.arrays["dynamic_damping"][0][0]
    borne = 2.0 * math.sqrt(shaft / m) * slow * (shaft / v["static_stiffness_xx"]) ** 2
    assert v["critical_cross_coupling"] == pytest.approx(borne, rel=0.03)


def test_the_curve_ends_at_the_values(rigid):
    result = rigid.result
    crosses, full, synchronous = np.array(result.arrays["decrement_over_cross_coupling"]).T
    assert full[0] == pytest.approx(result.values["log_decrement"])
    for kind, values in (("", full), ("synchronous_", synchronous)):
        zero = np.interp(0.0, values[::-1], crosses[::-1])
        assert zero == pytest.approx(result.values[f"{kind}critical_cross_coupling"], rel=1e-2)
        at = np.interp(8e6, crosses, values)
        assert at == pytest.approx(result.values[f"{kind}log_decrement_anticipated"], rel=1e-2)
    assert np.all(np.diff(full) < 0.0)


def test_decrements_over_speed_are_those_of_every_speed(rigid):
    for speed, row in zip((4000.0, 6000.0), decrements_over_speed(rigid.problem, [
        n * math.pi / 30.0 for n in (4000.0, 6000.0)
    ]), strict=True):  # fmt: skip
        v = result_of(**ROTOR | {"speed": f"{speed} rpm"}).values
        ends = ("log_decrement", "log_decrement_anticipated")
        assert row == pytest.approx([v[kind + end] for kind in ("", "synchronous_") for end in ends], rel=1e-6)


def test_the_result_holds_the_decrements_over_speed(rigid):
    """Those of the case at its own speed; less with what drives the whirl, at every speed."""
    over = np.array(rigid.result.arrays["decrement_over_speed"])
    values = rigid.result.values
    assert over[4, 0] == pytest.approx(4000.0 * math.pi / 30.0)
    ends = ("log_decrement", "log_decrement_anticipated")
    assert over[4, 1:] == pytest.approx([values[kind + end] for kind in ("", "synchronous_") for end in ends])
    assert over[:, 0] / over[4, 0] == pytest.approx([0.5, 0.625, 0.75, 0.875, 1.0, 1.125, 1.25])
    assert np.all(over[:, 2] < over[:, 1])
    assert np.all(over[:, 4] < over[:, 3])


def test_either_sense_of_rotation_is_driven_forward(rigid):
    other = result_of(**ROTOR | {"speed": "-4000 rpm"}).values
    for name in ("critical_cross_coupling", "log_decrement_anticipated", "synchronous_critical_cross_coupling"):
        assert other[name] == pytest.approx(rigid.result.values[name], rel=1e-7)


def test_level_one_at_both_clearances():
    gap = {"kind": "radial", "mean": "148 um", "minimum": "130 um", "maximum": "165 um"}
    given = pad_case({"pads.clearance": gap}, **ROTOR, clearance_cases="all")
    results = solve(case_from_dict(given)).results
    assert len(results) == 3
    borne = []
    for result in results:
        checks = {one.code: one for one in result.checks}
        assert checks["C406"].value == result.values["critical_cross_coupling"] / 8e6
        assert checks["C406"].limit == 2.0
        assert (checks["C407"].value, checks["C407"].limit) == (result.values["log_decrement_anticipated"], 0.1)
        assert "W413" not in codes(result)
        borne.append(checks["C406"].value)
    assert len({round(one, 3) for one in borne}) == 3
    assert "W413" in codes(result_of(**ROTOR))


@pytest.mark.parametrize(("anticipated", "listed"), [("80 MN/m", True), ("8 MN/m", False)])
def test_the_region_of_gas_density_is_listed_below_ten_times(anticipated, listed):
    result = result_of(**ROTOR | {"anticipated_cross_coupling": anticipated})
    assert (result.values["cross_coupling_ratio"] < 10.0) is listed
    assert ("C408" in [one.code for one in result.not_checked]) is listed


def test_a_limit_of_the_case_holds_with_cross_coupling_too():
    checks = {one.code: one for one in result_of(**ROTOR | {"limits": {"log_decrement": 0.3}}).checks}
    assert checks["C407"].limit == 0.3


def test_too_much_cross_coupling_grows():
    result = result_of(**ROTOR | {"anticipated_cross_coupling": "2 GN/m"})
    assert result.values["cross_coupling_ratio"] < 1.0
    assert result.values["log_decrement_anticipated"] < 0.0
    assert result.verdict is Verdict.FAIL


def test_nothing_is_told_without_an_anticipated_cross_coupling():
    result = result_of(**ISOTHERMAL, rotor_mass="2 t")
    assert not any("cross_coupling" in name or "synchronous" in name for name in (*result.values, *result.arrays))
    assert not {"C406", "C407"} & {one.code for one in (*result.checks, *result.not_checked)}


def test_both_kinds_may_come_to_the_other_verdict(rigid):
    """An anticipated cross-coupling of which one kind bears twice as much and the other does not."""
    full, reduced = (rigid.result.values[f"{kind}critical_cross_coupling"] for kind in ("", "synchronous_"))
    between = 0.25 * (full + reduced)
    warned = result_of(**ROTOR | {"anticipated_cross_coupling": f"{between} N/m"}, limits={"log_decrement": 0.0})
    assert "W414" in codes(warned)
    assert "W414" not in codes(rigid.result)


def test_the_other_verdict_is_that_by_the_usual_decrement_too():
    """A case that is content with 0.01 was not told of a decrement beyond 0.1 by reduced coefficients alone."""
    values = {"log_decrement_anticipated": 0.06, "synchronous_log_decrement_anticipated": 0.12}
    assert [one.code for one in about_synchronous_verdict(values, [0.01, 0.1])] == ["W414"]
    assert not list(about_synchronous_verdict(values, [0.01]))


def test_a_stiff_pedestal_changes_nothing(rigid):
    stiff = {"stiffness_x": "1000 GN/m", "stiffness_y": "1000 GN/m"}
    held = result_of(**ROTOR, pedestal=stiff).values
    for name in ("stiffness_yy", "damping_yy", "log_decrement", "critical_cross_coupling", "static_stiffness_xx"):
        assert held[name] == pytest.approx(rigid.result.values[name], rel=5e-3)


def test_a_pedestal_leaves_the_films_and_moves_under_the_load():
    alone, held = (
        solution_of(**ISOTHERMAL, load_angle="-70 deg", **more).result for more in ({}, {"pedestal": PEDESTAL})
    )
    for name in PLACE:
        assert held.values[name] == alone.values[name]
    assert held.values["pedestal_x"] == pytest.approx(1e4 * math.cos(math.radians(-70.0)) / 6e8, rel=1e-5)
    assert held.values["pedestal_y"] == pytest.approx(1e4 * math.sin(math.radians(-70.0)) / 1e9, rel=1e-5)
    assert np.array(held.arrays["bearing_stiffness"]) == pytest.approx(np.array(alone.stiffness))
    assert np.array(held.arrays["bearing_damping"]) == pytest.approx(np.array(alone.damping))


def test_bearing_and_pedestal_in_series():
    """At rest springs in series; at the speed dynamic stiffnesses in series, pads of 2 kg with the housing."""
    held = result_of({"pads.mass": "2 kg"}, **ISOTHERMAL, pedestal=PEDESTAL)
    alone = result_of(**ISOTHERMAL)
    rest = np.linalg.inv(np.array(alone.static_stiffness)) + np.diag([1.0 / 6e8, 1.0 / 1e9])
    assert np.linalg.inv(np.array(held.static_stiffness)) == pytest.approx(rest, rel=1e-9, abs=1e-18)
    w = 4000.0 * math.pi / 30.0
    bearing, both = (np.array(one.stiffness) + 1j * w * np.array(one.damping) for one in (alone, held))
    pedestal = np.diag([6e8 + 2e4j * w, 1e9 + 5e4j * w]) - 308.0 * w**2 * np.eye(2)
    series = np.linalg.inv(bearing) + np.linalg.inv(pedestal)
    assert np.linalg.inv(both) == pytest.approx(series, rel=1e-9, abs=1e-18)
    assert "W183" not in codes(held)
    assert held.settings["motions"].endswith("pedestal x, pedestal y")


def test_without_a_threshold_the_curve_ends_behind_twice_what_is_anticipated():
    pedestal = {"stiffness_x": "700 MN/m", "stiffness_y": "1.1 GN/m", "damping_x": "20 kN s/m",
                "damping_y": "20 kN s/m", "mass": "250 kg"}  # fmt: skip
    result = result_of(anticipated_cross_coupling="0.01 MN/m", rotor_mass="10 kg", pedestal=pedestal)
    assert "critical_cross_coupling" in result.missing
    assert result.arrays["decrement_over_cross_coupling"][-1][0] == pytest.approx(1.25 * 2.0 * 1e4)
