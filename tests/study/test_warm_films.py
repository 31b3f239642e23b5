"""Studies of films with their own temperatures: row by row what is solved for one bearing, whoever solves them."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose
from studied_cases import block
from test_many_films import DUTY, FILM, HEATED
from test_study_engine import same, with_chunks

from babbitt.case.loading import case_from_dict
from babbitt.case.part import Part
from babbitt.core.notices import InputError
from babbitt.solving import solve
from babbitt.study import grids
from babbitt.study.patched_case import PatchedCases, patched
from babbitt.study.plan import plan
from babbitt.study.rows import RowTask, solved_one_by_one
from babbitt.study.study import run_study
from babbitt.study.workers import Processes

WARM = {key: value for key, value in FILM.items() if key != "effective_temperature"} | HEATED
WARM |= {
    "supply": {"temperature": "45 degC", "pressure": "0 Pa"},
    "method": {"kind": "film", "accuracy": "draft", "thermal": "adiabatic"},
}
TOLERANCE = {
    "load": {"uniform": ["5 kN", "60 kN"]},
    "speed": {"uniform": ["600 rpm", "4000 rpm"]},
    "clearance": {"fit": "H7/e7"},
    "lubricant": {"scatter": "vg"},
    "supply.temperature": {"normal": ["45 degC", "2 K"]},
}


def planned(samples, vary=TOLERANCE, **options):
    return plan(case_from_dict(WARM), block(kind="tolerance", vary=vary, samples=samples, **options))


def rows_of(made, samples):
    values, groups = grids.joint_sample(made.task.inputs, made.block)
    return {"row": np.arange(samples), "group": groups, **values}


@pytest.fixture(scope="module")
def table():
    made = planned(50)
    rows = rows_of(made, 50)
    return made.task, rows, solved_one_by_one(made.task, rows)


@pytest.mark.solves_anew
def test_fifty_random_rows_are_those_of_one_bearing(table):
    """Each case read anew and solved as `babbitt solve` does, all limiting speeds included."""
    task, rows, found = table
    for place in range(50):
        (result,) = solve(task.case({name: column[place] for name, column in rows.items()})).results
        assert found["status"][place] == "converged"
        for name in task.outputs:
            assert_allclose(found[name][place], result.values.get(name, np.nan), rtol=1e-12, err_msg=name)
        margins = {check.code: check.margin for check in result.checks}
        assert found["margin_C101"][place] == margins["C101"]


@pytest.mark.solves_anew
def test_a_row_does_not_depend_on_its_company(table):
    task, rows, found = table
    some = {name: column[17:23] for name, column in rows.items()}
    alone = solved_one_by_one(task, some)
    for name, column in alone.items():
        np.testing.assert_array_equal(column, found[name][17:23], err_msg=name)


@pytest.mark.slow
def test_two_processes_give_the_table_of_one():
    made = with_chunks(planned(24, DUTY), 8)
    same(run_study(made).columns, run_study(made, workers=Processes(2)).columns)


def test_rows_without_the_speed_of_whirl_are_the_same_but_for_it(table):
    task, rows, found = table
    kept = [name for name in task.outputs if name != "threshold_speed"]
    lean = solved_one_by_one(planned(50, outputs=kept).task, rows)
    assert np.isfinite(found["threshold_speed"]).any()
    assert set(found) - set(lean) == {"threshold_speed"}
    for name, column in lean.items():
        np.testing.assert_array_equal(column, found[name], err_msg=name)


def test_a_film_is_not_asked_for_a_speed_that_no_column_has(table):
    (one,) = table[0].case({name: column[0] for name, column in table[1].items()}).calculations()
    assert one.only(("threshold_speed",)).problem == one.problem
    (found,) = one.only(("friction_power",)).solve()
    assert "threshold_speed" not in found.result.values
    assert found.result.checks == one.solve()[0].result.checks


def counted(monkeypatch):
    read, before = [], RowTask.case

    def case(task, values):
        read.append(int(values["row"]))
        return before(task, values)

    monkeypatch.setattr(RowTask, "case", case)
    return read


def test_a_case_is_read_twice_for_all_its_rows(table, monkeypatch):
    task, rows, _ = table
    wanted = [task.case({name: column[place] for name, column in rows.items()}) for place in range(6)]
    read, cases = counted(monkeypatch), PatchedCases(task)
    for place, case in enumerate(wanted):
        found = cases.case({name: column[place] for name, column in rows.items()})
        assert found == case
        assert found.calculations()[0].problem == case.calculations()[0].problem
    assert read == [0, 1]


def test_a_number_that_the_case_does_not_take_is_refused_as_when_it_is_read(table):
    task, rows, _ = table
    cases = PatchedCases(task)
    for place in range(3):
        cases.case({name: column[place] for name, column in rows.items()})
    wrong = {name: column[4] for name, column in rows.items()} | {"load": -1.0}
    with pytest.raises(InputError) as raised:
        cases.case(wrong)
    with pytest.raises(InputError) as alone:
        task.case(wrong)
    assert raised.value.message == alone.value.message


def test_cases_whose_numbers_stand_elsewhere_too_are_read_one_by_one(table, monkeypatch):
    """As where a rule of reading would make another field of the number: the second row tells."""
    task, rows, _ = table
    monkeypatch.setattr("babbitt.study.patched_case.patched", lambda case, numbers: patched(case, {}))
    read, cases = counted(monkeypatch), PatchedCases(task)
    for place in range(4):
        values = {name: column[place] for name, column in rows.items()}
        assert cases.case(values).load == values["load"]
    assert read == [0, 1, 2, 3]


def test_rules_are_asked_of_a_patched_case(table):
    case = table[0].case({name: column[0] for name, column in table[1].items()})
    assert isinstance(case, Part)
    assert patched(case, {("width",): 0.13}) is not None
    assert patched(case, {("width",): -0.13}) is None
    assert patched(case, {("clearance", "mean"): 2.0}) is None
