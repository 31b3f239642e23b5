"""Figures of optimisations, however few fields and choices vary."""

from __future__ import annotations

import pytest
from studied_cases import block, journal

from babbitt import parse_case
from babbitt.core.kind import kinds
from babbitt.core.quantities import QUANTITIES
from babbitt.report import optimum_figures as figures
from babbitt.study.optimum import optimum_of
from babbitt.study.plan import plan
from babbitt.study.study import run_study

pytest.importorskip("matplotlib")
pytest.importorskip("pymoo")

OILS = ["ISO VG 32", "ISO VG 46", "ISO VG 68", "ISO VG 100"]


def optimised(**given):
    return run_study(plan(journal(load="45 kN"), block(kind="optimise", population=8, generations=2, **given)))


def test_one_choice_is_computed_once_each_and_drawn_over_its_words():
    study = optimised(vary={"lubricant": OILS}, minimise=["friction_power"])
    assert sorted(study.columns["lubricant"]) == sorted(OILS)
    ((name, caption, figure),) = figures.optimum_figures(study)
    (panel,) = figure.axes
    assert name == "designs"
    assert "over lubricant" in caption
    assert [one.get_text() for one in panel.get_xticklabels()] == OILS
    kept, beyond, best = (line.get_xdata() for line in panel.get_lines())
    assert sorted([*kept, *beyond]) == [0.0, 1.0, 2.0, 3.0]
    assert [OILS[int(at)] for at in best] == [study.columns["lubricant"][optimum_of(study).rows[0]]]
    assert OILS[int(beyond[0])] == "ISO VG 32"  # the thinnest oil has the least friction and too thin a film


def test_a_field_of_one_value_has_no_axis():
    vary = {"width": {"uniform": ["50 mm", "80 mm"]}, "lubricant": ["ISO VG 46"]}
    (_, caption, figure), *none = figures.optimum_figures(optimised(vary=vary, minimise=["friction_power"]))
    assert not none
    assert "over width" in caption
    assert figure.axes[0].get_xlabel() == "width in mm"
    study = optimised(vary=vary, minimise=["friction_power", "total_flow"])
    *_, (_, caption, figure) = figures.optimum_figures(study)
    assert caption.endswith("have the same: lubricant ISO VG 46.")
    assert figure.axes[0].get_xticklabels()[0].get_text().startswith("width")
    assert len(figure.axes[0].get_xticklabels()) == 3


def test_the_points_of_a_front_are_named_by_the_choice_that_varies():
    (_, _, figure), *_ = figures.optimum_figures(
        optimised(vary={"lubricant": OILS}, minimise=["friction_power", "total_flow"])
    )
    assert {one.get_text() for one in figure.axes[0].texts} <= set(OILS)
    assert len(figure.axes[0].texts) >= 2


def test_a_machine_is_drawn_with_the_friction_and_the_limits_of_all_its_bearings():
    machine = parse_case(kinds()["machine"].read_template())
    asked = block(
        kind="optimise", vary={"lubricant": OILS}, minimise=["friction_power"], population=8, generations=2
    )
    study = run_study(plan(machine, asked))
    ((_, _, figure),) = figures.optimum_figures(study)
    kept, beyond, best = figure.axes[0].get_lines()
    ((least,),) = optimum_of(study).values
    assert best.get_ydata().tolist() == [QUANTITIES["friction_power"].shown(least)]
    failing = study.columns["verdict"] == "fail"
    assert sorted(OILS[int(at)] for at in beyond.get_xdata()) == sorted({*study.columns["lubricant"][failing]})
    assert min(kept.get_ydata()) == best.get_ydata()[0]
