"""A film is solved once, whatever is made of it: table, report, plots, fields."""

from __future__ import annotations

import film_bearings
import pytest

from babbitt.kinds.journal.film import check
from babbitt.report.content import content
from babbitt.report.figures import write_plots
from babbitt.report.table import render
from babbitt.solving import solve


def test_an_operating_point_is_solved_once_for_table_report_plots_and_fields(monkeypatch, tmp_path):
    pytest.importorskip("matplotlib")
    pytest.importorskip("xarray")
    from babbitt.report.fields import write_machine_fields

    solved = []
    found = check.film_within_ducts
    monkeypatch.setattr(check, "film_within_ducts", lambda problem: solved.append(problem.name) or found(problem))
    machine = solve(film_bearings.case(accuracy="draft"))
    assert len(solved) == len(machine.solutions)
    render(machine.name, machine.results, 120)
    content(machine)
    write_plots(machine, tmp_path / "plots")
    write_machine_fields(machine, tmp_path / "fields.nc")
    assert len(solved) == len(machine.solutions)
    pressure = machine.solutions[0].state.solution.pressure
    assert pressure.max() == pytest.approx(machine.results[0].maximum_pressure, rel=1e-6)
