"""What is solved stays: table, report, plots and fields of a bearing ask for no equilibrium again."""

from __future__ import annotations

import sys

import film_bearings
import pytest

from babbitt.case import parse_case, template
from babbitt.kinds.hydrostatic import check as hydrostatic_check
from babbitt.kinds.hydrostatic.heat_balance import heated
from babbitt.kinds.journal.film import check as film_check
from babbitt.kinds.journal.film.thermal_film import film_within_ducts
from babbitt.kinds.shaft_line import check as line_check
from babbitt.kinds.shaft_line.answer import line_answer
from babbitt.kinds.thrust import check as thrust_check
from babbitt.kinds.thrust.design import bearing_state, operating_state
from babbitt.kinds.tilting_pad_journal import check as pad_check
from babbitt.kinds.tilting_pad_journal.film import operating_films
from babbitt.report.content import content
from babbitt.report.figures import write_plots
from babbitt.report.table import render
from babbitt.solving import solve

SOLVERS = (
    film_within_ducts,
    heated,
    bearing_state,
    operating_state,
    line_answer,
    operating_films,
)
"""What finds the equilibrium of a bearing; sweeps of figures have entrances of their own."""

pytest.importorskip("matplotlib")


@pytest.fixture
def solved(monkeypatch):
    """Names of what is called to solve, by whichever module."""
    calls = []

    def counted(solver):
        def call(*problem):
            calls.append(solver.__name__)
            return solver(*problem)

        return call

    counters = {solver.__name__: counted(solver) for solver in SOLVERS}
    for module in [one for name, one in sys.modules.items() if name.startswith("babbitt.")]:
        for name, value in list(vars(module).items()):
            if any(value is solver for solver in SOLVERS):
                monkeypatch.setattr(module, name, counters[value.__name__])
    return calls


@pytest.mark.parametrize("kind", ["film", "hydrostatic_pad", "thrust", "thrust_line", "tilting_pad_journal"])
def test_nothing_is_solved_again_for_table_report_and_plots(kind, solved, tmp_path):
    case = film_bearings.case(accuracy="draft") if kind == "film" else parse_case(template(kind))
    machine = solve(case)
    before = list(solved)
    assert before
    render(machine.name, machine.results, 120)
    content(machine)
    write_plots(machine, tmp_path / "plots")
    assert solved == before


def test_nothing_is_solved_again_for_fields(solved, tmp_path):
    pytest.importorskip("xarray")
    from babbitt.report.fields import write_machine_fields

    machine = solve(film_bearings.case(accuracy="draft"))
    before = list(solved)
    write_machine_fields(machine, tmp_path / "fields.nc")
    assert solved == before
    pressure = machine.solutions[0].state.solution.pressure
    assert pressure.max() == pytest.approx(machine.results[0].maximum_pressure, rel=1e-6)


def test_the_checks_ask_what_is_counted():
    """The names counted are those by which the checks solve."""
    asked = (
        film_check.film_within_ducts,
        hydrostatic_check.heated,
        thrust_check.bearing_state,
        line_check.line_answer,
        pad_check.operating_films,
    )
    assert set(asked) <= set(SOLVERS)
