"""Tables, plots, studies and their files read of one film: that against which the limits are held."""

from __future__ import annotations

import numpy as np
import pytest
from studied_cases import JOURNAL, block, journal

from babbitt.case.loading import case_from_dict
from babbitt.case.variation import variation_of
from babbitt.core.limited_flow import is_limited, limited, may_be_short, quantity_held, value_kept
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.report.columns import footnote
from babbitt.report.content import content
from babbitt.report.study_content import overview, study_tables
from babbitt.report.sweep_columns import sweep_columns
from babbitt.solving import solve
from babbitt.study.case_sweep import sweep_case
from babbitt.study.plan import plan
from babbitt.study.study import run_study
from babbitt.study.sweep_values import values_of

LOADS = "5 kN, 20 kN, 47 kN"
"""Of the first the supply delivers what the film wants; of the others less."""


@pytest.fixture(scope="module")
def sweep():
    return sweep_case([(variation_of(journal(), "load"), values_of(LOADS))])


def cells_of(columns, results):
    return {column.quantity or column.heading: column.cells(results) for column in columns}


def test_a_sweep_shows_the_film_that_the_limits_of_a_row_are_held_against(sweep):
    results = [result for _, result in sweep.rows()]
    assert [any(is_limited(one.quantity) for one in result.limits) for result in results] == [False, True, True]
    columns = sweep_columns(results)
    cells = cells_of(columns, results)
    for name in ("friction_power", "eccentricity_ratio"):
        for result, cell in zip(results, cells[name], strict=True):
            held = quantity_held(result, name)
            assert cell.removesuffix("*") == QUANTITIES[name].format(result.values[held])
            assert cell.endswith("*") == is_limited(held)
    assert [cell.split(" / ")[0].endswith("*") for cell in cells["minimum_film_thickness"]] == [False, True, True]
    assert "with the flow that the supply delivers" in footnote(columns, results)
    fails = results[2].governing_check
    film = cells["minimum_film_thickness"][2]
    assert not fails.ok
    assert float(film.split("*")[0]) < float(film.split(" / ")[1])  # the row shows why it fails


def test_the_plot_of_a_sweep_draws_that_film_and_says_so(sweep):
    pytest.importorskip("matplotlib")
    from babbitt.report.sweep_plot import LESS_OIL, sweep_figure

    figure = sweep_figure(sweep)
    drawn = figure.axes[0].get_lines()[0].get_ydata()
    held = [result.values[quantity_held(result, "minimum_film_thickness")] for _, result in sweep.rows()]
    assert drawn == pytest.approx([1e6 * one for one in held])
    assert [text.get_text() for text in figure.texts] == [LESS_OIL]
    enough = sweep_case([(variation_of(journal(), "load"), values_of("4 kN, 5 kN"))])
    assert not sweep_figure(enough).texts


def test_the_films_side_by_side_in_a_report_are_those_of_the_verdict():
    shared = ("lubricant", "supply", "materials")
    alone = {name: value for name, value in JOURNAL.items() if name not in ("name", *shared)}
    bearings = [alone | {"name": name, "load": load} for name, load in (("enough", "5 kN"), ("short", "45 kN"))]
    machine = {"kind": "machine", "name": "Two"} | {name: JOURNAL[name] for name in shared}
    found = solve(case_from_dict(machine | {"bearings": bearings}))
    shown = content(found)["overview"]
    enough, short = (row["cells"] for row in shown["rows"])
    assert not any("*" in cell for cell in enough)
    assert (
        QUANTITIES["minimum_film_thickness"].format(found.results[1].starved_minimum_film_thickness) + "*" in short
    )
    assert "with the flow that the supply delivers" in shown["footnote"]


def test_a_study_keeps_both_films_though_its_nominal_bearing_lacks_no_oil():
    study = run_study(plan(journal(load="5 kN"), block(kind="sweep", vary={"load": ["5 kN", "20 kN", "45 kN"]})))
    for name in ("minimum_film_thickness", "friction_power", "effective_temperature"):
        full, held = study.columns[name], study.columns[limited(name)]
        assert full[0] == held[0]
        assert np.all(full[1:] != held[1:])
    (lines, _) = study_tables(study)
    power = [row[[name for name, _ in lines.columns].index("P_f")] for row in lines.rows]
    assert [cell.endswith("*") for cell in power] == [False, True, True]
    assert power[2] == QUANTITIES["friction_power"].format(study.columns["starved_friction_power"][2]) + "*"
    assert not any(name.endswith(",st") for name, _ in lines.columns)
    assert "In 2 rows the supply delivers less oil" in overview(study)
    enough = run_study(plan(journal(load="5 kN"), block(kind="sweep", vary={"load": ["4 kN", "5 kN"]})))
    assert "supply delivers" not in overview(enough)


def test_the_margin_of_a_temperature_is_in_kelvin_and_codes_stand_beside_the_verdict():
    loads = ["0.5 kN", "24 kN", "80 kN"]
    study = run_study(plan(journal(), block(kind="sweep", vary={"load": loads})))
    (lines, *_) = study_tables(study)
    place = {name: at for at, (name, _) in enumerate(lines.columns)}
    for load, row in zip(loads, lines.rows, strict=True):
        (result,) = solve(journal(load=load), only=()).results
        governing = result.governing_check
        margin = row[place["margin"]]
        if governing.code == "C104":
            assert margin == f"{governing.limit - governing.value:+.1f} K"
        else:
            assert margin == f"{governing.margin:+.1%}"
        codes = [check.code for check in result.limits if not check.ok] or list(result.questioning_codes)
        assert row[place["codes"]] == " ".join(codes)
    assert {str(one).split()[0] for one in study.columns["codes"] if one} >= {"W198", "C101"}


@pytest.mark.parametrize("pressure", ["0.05 MPa", "0.5 MPa", "5 MPa"])
def test_every_film_with_less_oil_is_of_a_supply_whose_capacity_is_known(pressure):
    """Pockets at the ends of a short arc give less than the standard has them."""
    supply = {**JOURNAL["supply"], "pressure": pressure}
    (result,) = solve(journal(span="120 deg", supply=supply)).results
    assert result.values["supply_flow_at_place"] < result.values["supply_flow"]
    assert "starved_total_flow" in result.values
    assert result.values["supply_capacity"] > result.values["supply_flow_at_place"]
    assert may_be_short([result], "friction_power")
    assert not may_be_short([result], "load")


def test_what_has_no_limit_is_read_of_one_film():
    """Of a film short of oil nothing is read of the other, though that alone has a speed of transition."""
    values = {"outlet_temperature": 340.0, "starved_outlet_temperature": 350.0, "minimum_film_thickness": 2e-5,
              "starved_minimum_film_thickness": 2.1e-5, "friction_power": 900.0, "starved_friction_power": 800.0,
              "transition_speed": 20.0, "load": 1e4}  # fmt: skip
    hot = Check("C104", "starved_outlet_temperature", 350.0, 360.0, Bound.AT_MOST, "")
    thin = Check("C101", "minimum_film_thickness", 2e-5, 1e-5, Bound.AT_LEAST, "")
    result = Result("b", "journal", "iso7902", Outcome.CONVERGED, values, (hot, thin))
    read = {name: value_kept(result, limited(name)) for name in values if not is_limited(name)}
    assert np.isnan(read.pop("transition_speed"))
    kept = {"outlet_temperature": 350.0, "minimum_film_thickness": 2e-5, "friction_power": 800.0, "load": 1e4}
    assert read == kept
