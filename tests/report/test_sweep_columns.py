"""The columns of a sweep are those of the kind of case."""

from __future__ import annotations

import pytest

from babbitt.case import kinds, parse_case, template
from babbitt.core.kind import find_kind
from babbitt.core.quantities import QUANTITIES
from babbitt.report.machine_table import columns_of
from babbitt.report.sweep_columns import SUPPLIED, panels_of, sweep_columns
from babbitt.report.view import find_view, view_of
from babbitt.solving import solve


@pytest.mark.parametrize("kind", [name for name in kinds() if find_kind(name).views])
def test_key_results_are_quantities(kind):
    for method in find_kind(kind).views:
        assert set(find_view(kind, method).sweep) <= QUANTITIES.keys()


@pytest.mark.parametrize("kind", ["overhung_coupling", "thrust"])
def test_a_kind_has_columns_of_its_own_and_they_are_filled(kind):
    results = solve(parse_case(template(kind))).results
    names = [name for name in view_of(results[0]).sweep if name in results[0].values]
    assert len(names) >= 5
    columns = sweep_columns(results)
    assert [column.heading for column in columns] == [QUANTITIES[name].symbol for name in names]
    assert panels_of(results) == tuple((name,) for name in names[:4])


@pytest.mark.parametrize("kind", ["journal", "hydrostatic_pad"])
def test_other_kinds_have_those_of_the_table_of_a_machine(kind):
    results = solve(parse_case(template(kind))).results
    table = columns_of(results)
    assert sweep_columns(results)[: len(table)] == table
    flows = sweep_columns(results)[len(table) :]
    assert flows == ((SUPPLIED,) if kind == "journal" else ())
    for flow in flows:
        supplied, needed = flow.cells(results)[0].split(" / ")
        check = next(check for check in results[0].checks if check.code == "C117")
        assert (float(supplied), float(needed)) == pytest.approx((6e4 * check.value, 6e4 * check.limit), abs=0.051)
    assert panels_of(results)[0] == ("minimum_film_thickness", "load")


def test_the_plot_of_a_sweep_has_the_limits_and_the_flow_that_is_needed(tmp_path):
    pytest.importorskip("matplotlib")
    from babbitt.case.variation import case_variation
    from babbitt.report.sweep_plot import sweep_figure
    from babbitt.study.case_sweep import sweep_case
    from babbitt.study.sweep_values import values_of

    (tmp_path / "case.yaml").write_text(template("journal"))
    sweep = sweep_case([(case_variation(tmp_path / "case.yaml", "load"), values_of("6 kN, 12 kN, 24 kN"))])
    film, _, warm, flow = sweep_figure(sweep).axes
    said = [{text.get_text() for text in panel.texts} for panel in (film, warm, flow)]
    assert {"C101"} <= said[0]
    assert {"C104"} <= said[1]
    assert {"supplied", "needed"} <= said[2]
    limits = [check.limit for _, result in sweep.rows() for check in result.limits if check.code == "C104"]
    lines = [line.get_ydata() for line in warm.get_lines() if len(line.get_ydata()) == 3]
    assert any(line == pytest.approx([limit - 273.15 for limit in limits]) for line in lines)


def test_the_plot_of_a_sweep_has_a_panel_for_each_result_that_is_chosen(tmp_path):
    pytest.importorskip("matplotlib")
    from babbitt.case.variation import case_variation
    from babbitt.report.drawing import axis_label
    from babbitt.report.sweep_plot import sweep_figure
    from babbitt.study.case_sweep import sweep_case
    from babbitt.study.sweep_values import values_of

    (tmp_path / "case.yaml").write_text(template("journal"))
    sweep = sweep_case([(case_variation(tmp_path / "case.yaml", "load"), values_of("6 kN, 12 kN"))])
    chosen = ("friction_power", "total_flow", "outlet_temperature", "minimum_film_thickness", "eccentricity_ratio")
    figure = sweep_figure(sweep, chosen)
    drawn = [panel for panel in figure.axes if panel.get_lines()]
    assert [panel.get_ylabel() for panel in drawn] == [axis_label(QUANTITIES[name]) for name in chosen]
    assert [panel.get_xlabel() for panel in drawn] == [*[""] * 3, *["load in kN"] * 2]
