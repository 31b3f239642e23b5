"""Broken lines in the plot of a sweep of steady states mean that they are not stable."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from babbitt.case.variation import case_variation
from babbitt.report.sweep_plot import sweep_figure
from babbitt.study.case_sweep import sweep_case
from babbitt.study.sweep_values import values_of

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_broken_lines_are_where_states_are_not_stable():
    variation = case_variation(EXAMPLES / "pump_footstep.yaml", "clearance")
    sweep = sweep_case([(variation, values_of("15 um:30 um:6"))])
    stable = {
        (result.name, place): result.settings["stable"] == "yes" for place, result in sweep.rows()
    }  # fmt: skip
    assert set(stable.values()) == {True, False}
    figure = sweep_figure(sweep)
    panel = figure.axes[0]
    for line, name in zip(panel.get_lines(), sweep.names, strict=False):
        assert line.get_linestyle() == "-"
        drawn = np.isfinite(line.get_ydata())
        assert drawn.tolist() == [stable[name, place] for place in range(6)]
    broken = [line for line in panel.get_lines()[len(sweep.names) :] if line.get_linestyle() == "--"]
    broken = [line for line in broken if len(line.get_ydata()) == 6]  # not the mark of the file
    (hot,) = broken
    reach = [place for place in range(6) if np.isfinite(hot.get_ydata()[place])]
    unstable = [place for (name, place), lasts in stable.items() if not lasts]
    assert reach == unstable == list(range(6))  # the hot state, at every clearance
    (legend,) = figure.legends
    assert [text.get_text() for text in legend.get_texts()][-1] == "not stable (broken, open)"


@pytest.mark.parametrize("name", ["pump_footstep_metal.yaml"])
def test_where_all_states_are_stable_the_legend_says_nothing_of_it(name):
    variation = case_variation(EXAMPLES / name, "clearance")
    sweep = sweep_case([(variation, values_of("20 um:30 um:2"))])
    assert all(result.settings["stable"] == "yes" for _, result in sweep.rows())
    for legend in sweep_figure(sweep).legends:
        assert all("stable" not in text.get_text() for text in legend.get_texts())
