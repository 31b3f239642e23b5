"""Figures of tilting pads: entries that coincide stay visible, motions without meaning stay away."""

import json
import math

import numpy as np
import pytest
from pad_journals import OIL, pad_case, result_of, solution_of

from babbitt.case.variation import case_variation
from babbitt.kinds.tilting_pad_journal.dynamics import swinging
from babbitt.kinds.tilting_pad_journal.report import plots
from babbitt.report.drawing import style
from babbitt.report.sweep_plot import sweep_figure
from babbitt.reynolds.tilting_pads.rotor import Mode
from babbitt.study.case_sweep import sweep_case
from babbitt.study.sweep_values import values_of


@pytest.fixture(scope="module")
def solution():
    """Load between pads: k_xx = k_yy, and pads with motions of their own."""
    spring = {"kind": "spring", "stiffness": "500 MN/m"}
    return solution_of(
        {"pads.inertia": "0.002 kg m2", "pads.mass": "2 kg", "pads.pivot": spring},
        thermal="isothermal", lubricant=OIL, rotor_mass="2 t", shaft_stiffness="150 MN/m",
    )  # fmt: skip


def test_equal_entries_are_drawn_narrow_and_dark_on_broad_and_pale(solution):
    figure = plots.coefficients_over_whirl(solution.problem, solution.state.dynamics)
    lines = {
        line.get_label(): line for line in figure.axes[1].lines if line.get_label() in ("xx", "yy", "xy", "yx")
    }
    assert lines["xx"].get_ydata() == pytest.approx(lines["yy"].get_ydata(), rel=1e-3)
    for below, above in (("xx", "yy"), ("xy", "yx")):
        assert lines[below].get_linewidth() > 2.0 * lines[above].get_linewidth()
        assert lines[below].get_color() != lines[above].get_color()
    assert lines["xx"].get_linestyle() != lines["xy"].get_linestyle()


def test_the_locus_has_the_rotor_and_what_outlasts_a_cycle(solution):
    dynamics = solution.state.dynamics
    (panel,) = plots.root_locus(solution.problem, dynamics).axes
    points = np.array([
        (x, y) for line in panel.lines if line.get_marker() == "."
        for x, y in zip(line.get_xdata(), line.get_ydata(), strict=True)
    ])  # fmt: skip
    assert len(points) > 2 * plots.MASSES.size - 10
    assert (-points[:, 0] / points[:, 1] < 2.0 * math.pi).all()
    marked = [line.get_ydata()[0] for line in panel.lines if line.get_marker() == "o"]
    for mode in dynamics.motions.of_the_rotor:
        assert min(abs(one - mode.frequency / math.tau) for one in marked) < 1e-9


def test_two_equal_motions_that_do_not_swing_have_no_frequency():
    still, slow = (Mode(-4272.0, frequency, 0.0, 0.0) for frequency in (0.63, 63.0))
    assert swinging((still, slow)) == (slow,)


def test_a_legend_of_long_names_stays_on_the_page(tmp_path):
    limits = {"kind": "radial", "mean": "148 um", "minimum": "140 um", "maximum": "160 um"}
    case = pad_case({"pads.clearance": limits}, name="Turbine bearing 2 of the high-pressure rotor, stability",
                    clearance_cases="all")  # fmt: skip
    (tmp_path / "case.yaml").write_text(json.dumps(case))
    variation = case_variation(tmp_path / "case.yaml", "load")
    with style():
        figure = sweep_figure(sweep_case([(variation, values_of("5 kN, 10 kN"))]))
        (legend,) = figure.legends
        figure.canvas.draw()
        box = legend.get_window_extent()
    assert box.x1 <= figure.bbox.x1
    assert len(legend.get_texts()) == 3


def test_starved_points_of_a_sweep_are_crossed_out(tmp_path):
    """Less than the pads draw in is no verdict."""
    drawn = result_of(carry_over=0.5).values["total_flow"] * 6e4
    (tmp_path / "case.yaml").write_text(json.dumps(pad_case({"supply.flow": f"{drawn} L/min"}, carry_over=0.5)))
    flows = values_of(f"{0.9 * drawn:.3f} L/min, {1.1 * drawn:.3f} L/min, {1.3 * drawn:.3f} L/min")
    with style():
        figure = sweep_figure(sweep_case([(case_variation(tmp_path / "case.yaml", "supply.flow"), flows)]))
    for panel in figure.axes[:2]:
        (crosses,) = [line.get_ydata() for line in panel.lines if line.get_marker() == "x"]
        assert list(np.isfinite(crosses)) == [True, False, False]
    assert [one.get_text() for one in figure.texts] == ["×: the model does not hold there (W405)."]
