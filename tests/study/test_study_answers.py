"""What studies come to, against closed forms: yields, Sobol indices, slopes, means over a spectrum, optima."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats
from slider_cases import slider
from studied_cases import block, journal

from babbitt.case import parse_case, template
from babbitt.report.study_content import study_tables
from babbitt.study.indices import indices_of, slopes_of
from babbitt.study.inputs import inputs_of
from babbitt.study.laws import Normal
from babbitt.study.optimum import optimum_of
from babbitt.study.plan import plan
from babbitt.study.sampling import batch_sizes, sampled
from babbitt.study.spectrum import spectrum_summary
from babbitt.study.study import case_of, run_study
from babbitt.study.yields import tolerance_summary, yield_of

THIN = {"outlet_film": {"normal": ["22 um", "2 um"]}, "viscosity": {"uniform": ["20 mPa s", "40 mPa s"]}}
"""The film of 22 +- 2 um keeps its limit of 20 um where the truncated normal law is above -1 sigma."""


@pytest.mark.parametrize("sampling", ["random", "latin_hypercube", "sobol"])
def test_the_yield_of_a_linear_limit_under_truncated_normal_scatter(sliders, sampling):
    """Share of N(22, 2) truncated at 3 sigma above 20: (Phi(3) - Phi(-1)) / (Phi(3) - Phi(-3))."""
    samples = 100_000
    made = plan(slider(), block(kind="tolerance", vary=THIN, samples=samples, sampling=sampling))
    (found,) = tolerance_summary(run_study(made)).yields
    exact = (stats.norm.cdf(3.0) - stats.norm.cdf(-1.0)) / (stats.norm.cdf(3.0) - stats.norm.cdf(-3.0))
    error = math.sqrt(exact * (1.0 - exact) / samples)
    assert abs(found.share - exact) < 3.0 * error
    assert found.samples == samples
    width = found.high - found.low
    if sampling == "random":
        assert found.low < exact < found.high
        assert width == pytest.approx(2.0 * 1.96 * error, rel=0.05)
    else:  # an even sample knows the share of one field far better than independent samples
        assert width < 0.4 * 2.0 * 1.96 * error


def test_the_binomial_interval_holds_as_often_as_it_says():
    """Clopper and Pearson: at least 95 % of intervals hold the true share."""
    random = np.random.default_rng(1)
    held = 0
    for _ in range(400):
        share, low, high, _ = yield_of(random.random(60) < 0.9, [60], "random")
        assert low <= share <= high
        held += low <= 0.9 <= high
    assert held >= 0.95 * 400 - 3.0 * math.sqrt(400 * 0.05 * 0.95)


@pytest.mark.parametrize("sampling", ["latin_hypercube", "sobol"])
def test_intervals_of_even_samples_hold_as_often_as_they_say(sampling, sliders):
    """Share of the unit square below the hyperbola x y = 1/2, (1 + ln 2)/2, over 150 seeds."""
    vary = {"width": {"uniform": ["1 m", "2 m"]}, "length": {"uniform": ["0.1 m", "0.2 m"]}}
    fields = inputs_of(slider(), block(kind="tolerance", vary=vary))
    exact = 0.5 * (1.0 + math.log(2.0))
    held = 0
    for seed in range(150):
        drawn = sampled(fields, 1000, sampling, seed)
        below = (drawn["width"] - 1.0) * (10.0 * drawn["length"] - 1.0) < 0.5
        _, low, high, _ = yield_of(below, batch_sizes(1000, sampling), sampling)
        held += low <= exact <= high
    assert held == pytest.approx(0.95 * 150, abs=3.0 * math.sqrt(150 * 0.05 * 0.95))


def test_percentiles_corner_and_capability_of_a_film(sliders):
    made = plan(slider(), block(kind="tolerance", vary=THIN, samples=20_000, outputs=["minimum_film_thickness"]))
    found = tolerance_summary(run_study(made))
    (film,) = found.spreads
    law = Normal(22e-6, 2e-6)
    for rank, value in film.percentiles.items():
        assert value == pytest.approx(float(law.quantiles(np.array([rank / 100.0]))[0]), abs=3e-8)
    (thin,) = found.capabilities
    deviation = 2.0 * stats.truncnorm(-3.0, 3.0).std()
    assert thin.cpk == pytest.approx((22.0 - 20.0) / (3.0 * deviation), rel=0.01)
    assert thin.near_normal
    assert found.worst_corner["outlet_film"] == pytest.approx(16e-6)
    assert found.worst_corner["margin"] == pytest.approx(-0.2)
    assert found.worst_sample["margin"] > -0.2
    shares = found.tornado["Slider", "margin"]
    assert shares["outlet_film"] == pytest.approx(1.0)
    assert abs(shares["viscosity"]) < 1e-3


def test_a_falling_result_has_a_negative_bar(sliders):
    vary = {"outlet_film": {"uniform": ["25 um", "28 um"]}, "speed": {"uniform": ["4 m/s", "6 m/s"]}}
    made = plan(slider(), block(kind="tolerance", vary=vary, samples=2000, outputs=["load"]))
    shares = tolerance_summary(run_study(made)).tornado["Slider", "load"]
    assert shares["outlet_film"] < 0.0 < shares["speed"]
    assert abs(shares["outlet_film"]) + shares["speed"] == pytest.approx(1.0, abs=0.05)


def _indices(spreads):
    """First and total Sobol indices of a product of independent factors with variances over squared means."""
    whole = math.prod(1.0 + each for each in spreads) - 1.0
    first = [each / whole for each in spreads]
    total = [1.0 - (math.prod(1.0 + o for k, o in enumerate(spreads) if k != n) - 1.0) / whole for n in range(3)]
    return first, total


def _relative_variance(low, high, power):
    """Var(x^p) / E(x^p)^2 of x uniform between low and high."""

    def moment(order):
        return (high ** (order + 1) - low ** (order + 1)) / ((order + 1) * (high - low))

    def log_safe(order):
        return math.log(high / low) / (high - low) if order == -1 else moment(order)

    return log_safe(2 * power) / log_safe(power) ** 2 - 1.0


def test_sobol_indices_of_a_product_of_powers(sliders):
    """Load of a slider, proportional to eta U L^2 at a given film."""
    vary = {
        "viscosity": {"uniform": ["20 mPa s", "40 mPa s"]},
        "speed": {"uniform": ["4 m/s", "6 m/s"]},
        "length": {"uniform": ["40 mm", "60 mm"]},
    }
    made = plan(slider(), block(kind="sensitivity", vary=vary, samples=4096, outputs=["load"]))
    (found,) = indices_of(run_study(made))
    first, total = _indices(
        [_relative_variance(20, 40, 1), _relative_variance(4, 6, 1), _relative_variance(40, 60, 2)]
    )
    np.testing.assert_allclose(found.first, first, atol=0.02)
    np.testing.assert_allclose(found.total, total, atol=0.02)
    assert found.used == found.base == 4096


@pytest.mark.slow
def test_sobol_indices_of_petroff_friction():
    """ISO 7902 at a prescribed small eccentricity is Petroff: friction power proportional to eta omega^2 / psi."""
    petroff = journal(
        lubricant={"kind": "constant", "dynamic_viscosity": "20 mPa s"},
        effective_temperature="20 degC",
        eccentricity_ratio=0.02,
        load=None,
    )
    vary = {
        "lubricant.dynamic_viscosity": {"uniform": ["15 mPa s", "25 mPa s"]},
        "speed": {"uniform": ["800 rpm", "1200 rpm"]},
        "clearance.mean": {"uniform": ["1.5 permille", "2.5 permille"]},
    }
    made = plan(petroff, block(kind="sensitivity", vary=vary, samples=128, outputs=["friction_power"]))
    study = run_study(made)
    (found,) = indices_of(study)
    first, total = _indices(
        [_relative_variance(15, 25, 1), _relative_variance(800, 1200, 2), _relative_variance(1.5, 2.5, -1)]
    )
    np.testing.assert_allclose(found.first, first, atol=0.05)
    np.testing.assert_allclose(found.total, total, atol=0.05)
    slopes = slopes_of(study)["Textbook bearing", "friction_power"]
    assert [slopes[path][1] for path in vary] == pytest.approx([1.0, 2.0, -1.0], abs=2e-3)


def test_samples_without_a_solution_are_left_out_of_indices(single_sliders):
    vary = {"outlet_film": {"uniform": ["30 um", "62 um"]}, "speed": {"uniform": ["4 m/s", "6 m/s"]}}
    with pytest.raises(Exception, match="does not narrow"):
        plan(slider(), block(kind="sensitivity", vary=vary, samples=64))


def test_a_spectrum_weighs_with_time(sliders):
    cases = [
        {"name": "slow", "share": "25 %", "set": {"speed": "2 m/s", "outlet_film": "30 um"}},
        {"name": "fast", "share": 0.75, "set": {"speed": "6 m/s", "outlet_film": "24 um"}},
    ]
    made = plan(slider(), block(kind="spectrum", load_cases=cases, outputs=["load", "minimum_film_thickness"]))
    (found,) = spectrum_summary(run_study(made))
    assert found.means["minimum_film_thickness"] == pytest.approx(0.25 * 30e-6 + 0.75 * 24e-6)
    assert found.governing_case == "fast"
    assert found.margin == pytest.approx(0.2)
    assert found.worst_margins == pytest.approx({"X102": 0.2})


def test_a_grid_is_the_product_of_its_values(sliders):
    vary = {"speed": {"range": ["2 m/s", "4 m/s", 3]}, "viscosity": {"log_range": ["10 mPa s", "40 mPa s", 3]}}
    found = run_study(plan(slider(), block(kind="sweep", vary=vary, outputs=["load"]))).columns
    assert found["speed"].tolist() == [2.0] * 3 + [3.0] * 3 + [4.0] * 3
    np.testing.assert_allclose(found["viscosity"], [10e-3, 20e-3, 40e-3] * 3, rtol=1e-12)
    np.testing.assert_allclose(found["load"] / (found["speed"] * found["viscosity"]), found["load"][0] / 0.02)


def test_the_axes_of_a_map_follow_from_the_case():
    made = plan(journal(), block(kind="map", outputs=["friction_power"]))
    speed, load = made.task.inputs
    assert (speed.path, load.path) == ("speed", "load")
    assert load.law.support == pytest.approx((0.2 * 24e3, 2.0 * 24e3))
    assert made.rows == 19 * 19


def test_the_largest_load_of_a_slider_is_found(sliders):
    """Cameron: the load number is largest where h_in / h_out = 2.19; the limit of the film does not bind."""
    vary = {"inlet_film": {"uniform": ["35 um", "120 um"]}}
    study = block(kind="optimise", vary=vary, maximise=["load"], population=8, generations=4)
    found = run_study(plan(slider(), study))
    best = optimum_of(found)
    assert len(best.rows) == 1
    case = case_of(found, best.rows[0])
    assert case.inlet_film / case.outlet_film == pytest.approx(2.1887, rel=1e-2)
    assert found.rows > 8 * 4, "a single objective is polished"


def test_limits_bind_an_optimum(sliders):
    """More load with every thinner film: the best design lies at the limit of the film."""
    vary = {"outlet_film": {"uniform": ["10 um", "50 um"]}}
    study = block(kind="optimise", vary=vary, maximise=["load"], population=8, generations=4)
    found = run_study(plan(slider(), study))
    case = case_of(found, optimum_of(found).rows[0])
    assert 20e-6 * (1.0 - 1e-8) <= case.outlet_film < 20e-6 * 1.005


def test_a_pareto_set_has_no_design_that_another_beats(sliders):
    vary = {"outlet_film": {"uniform": ["20 um", "50 um"]}, "width": {"uniform": ["0.1 m", "0.3 m"]}}
    goals = {"maximise": ["load", "minimum_film_thickness"]}
    found = run_study(plan(slider(), block(kind="optimise", vary=vary, population=12, generations=6, **goals)))
    best = optimum_of(found)
    assert len(best.rows) > 3
    order = np.argsort(best.values[:, 0])
    assert (np.diff(best.values[order, 1]) < 0.0).all()
    widths = [case_of(found, row).width for row in best.rows]
    assert np.mean(widths) > 0.24, "a wider slider carries more at the same film; the middle is 0.2 m"


def test_no_design_within_limits_is_said_with_the_nearest(sliders):
    vary = {"outlet_film": {"uniform": ["10 um", "19 um"]}}
    found = run_study(
        plan(slider(), block(kind="optimise", vary=vary, maximise=["load"], population=6, generations=2))
    )
    best = optimum_of(found)
    assert best.rows == ()
    nearest = found.columns["outlet_film"][found.columns["row"] == best.nearest]
    assert nearest == found.columns["outlet_film"].max()


def test_an_optimum_is_the_same_for_the_same_seed(sliders):
    vary = {"inlet_film": {"uniform": ["35 um", "120 um"]}, "speed": ["4 m/s", "5 m/s"]}
    study = block(
        kind="optimise", vary=vary, maximise=["load"], minimise=["film_ratio"], population=6, generations=3
    )
    first, again = (run_study(plan(slider(), study)).columns for _ in range(2))
    assert np.array_equal(first["inlet_film"], again["inlet_film"])
    assert set(first["speed"]) <= {4.0, 5.0}


def test_a_study_keeps_the_value_that_is_judged(tmp_path):
    """The margin of the temperature follows from the film with the oil that the supply delivers, in every row."""
    case = journal(supply={"temperature": "45 degC", "pressure": "0.01 MPa"}, lubricant="ISO VG 32")
    asked = block(kind="sweep", vary={"supply.pressure": ["0.01 MPa", "0.02 MPa", "2 MPa"]})
    made = plan(case, asked)
    assert "starved_outlet_temperature" in made.task.outputs
    found = run_study(made).columns
    (limit,) = {one["limit"] for one in made.checks if one["code"] == "C104"}
    judged, wanted = found["starved_outlet_temperature"], found["outlet_temperature"]
    assert judged[0] > wanted[0] + 0.1
    assert judged[-1] == wanted[-1]
    # Margins of temperatures are shares of the limit in degrees Celsius.
    assert found["margin_C104"] == pytest.approx((limit - judged) / (limit - 273.15), abs=1e-9)


def test_a_margin_that_does_not_scatter_has_a_word_in_place_of_its_cpk():
    """The specific load hangs on the load alone: under a scatter of the oil it stays."""
    study = run_study(plan(journal(), block(kind="tolerance", vary={"lubricant": {"scatter": "vg"}}, samples=40)))
    found = {one.code: one for one in tolerance_summary(study).capabilities}
    assert not found["C103"].varies
    assert math.isnan(found["C103"].cpk)
    assert found["C101"].varies
    assert math.isfinite(found["C101"].cpk)
    (checks,) = (one for one in study_tables(study) if one.title == "Checks")
    (row,) = (row for row in checks.rows if row[0].startswith("C103"))
    assert row[-2:] == ("does not vary", "–")


def test_a_cpk_whose_size_tells_nothing_is_not_written_out():
    """A load that scatters by a millionth moves the specific load by as much."""
    law = {"normal": ["12 kN", "0.01 N"]}
    study = run_study(plan(journal(), block(kind="tolerance", vary={"load": law}, samples=40)))
    (found,) = (one for one in tolerance_summary(study).capabilities if one.code == "C103")
    assert found.cpk > 1e4
    (checks,) = (one for one in study_tables(study) if one.title == "Checks")
    (row,) = (row for row in checks.rows if row[0].startswith("C103"))
    assert row[-2] == "> 100"


def test_stiffness_damping_and_decrement_of_tilting_pads_scatter_with_the_others():
    case = parse_case(template("tilting_pad_journal"))
    study = plan(case, block(kind="tolerance", vary={"load": {"uniform": ["9 kN", "11 kN"]}}, samples=4))
    assert {"stiffness_xx", "damping_yy"} <= set(study.task.outputs)
