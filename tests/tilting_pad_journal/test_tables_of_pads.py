"""What tables show of every case: probe temperatures, stiffness and damping, each matrix in one unit."""

import pytest
from pad_journals import FILLON_OIL, HEATED, pad_case, result_of

from babbitt.case import case_from_dict
from babbitt.case.parts.study import StudyBlock
from babbitt.core.quantities import AXES, QUANTITIES, displayed_in
from babbitt.report.bearing_table import bearing_table
from babbitt.report.content import content
from babbitt.report.machine_table import columns_of
from babbitt.report.table import console
from babbitt.report.units_of_matrices import suited_among
from babbitt.report.view import view_of
from babbitt.solving import solve
from babbitt.study.plan import plan


def shown(table):
    """Lines of a table on the terminal."""
    to = console(160)
    with to.capture() as caught:
        to.print(table)
    return caught.get().splitlines()


ASKEW = {"load_angle": "-89.99 deg"}
"""Cross terms of some kN/m beside hundreds of MN/m."""


@pytest.fixture(scope="module")
def askew():
    result = result_of(**ASKEW)
    assert 1e4 < abs(result.values["stiffness_xy"]) < 1e-3 * result.values["stiffness_yy"]
    return result


@pytest.mark.parametrize("name", ["stiffness", "damping", "static_stiffness"])
def test_entries_of_one_matrix_have_one_unit(askew, name):
    units = {suited_among(f"{name}_{axes}", askew.values).display.label for axes in AXES}
    assert len(units) == 1
    symbols = {suited_among(f"{name}_{axes}", askew.values).symbol for axes in AXES}
    lines = [line for line in shown(bearing_table(askew)) if any(f" {symbol} " in line for symbol in symbols)]
    assert len(lines) == 4
    (unit,) = units
    assert all(line.rstrip().endswith(unit) for line in lines)


def test_entries_of_one_matrix_have_one_unit_on_paper():
    report = str(content(solve(case_from_dict(pad_case(**ASKEW)))))
    assert "MN/m" in report
    assert "kN/m" not in report


def test_the_table_of_cases_has_probes_stiffness_and_damping():
    points = [{"name": "slow", "speed": "2000 rpm"}, {"name": "fast"}]
    case = pad_case(lubricant=FILLON_OIL, operating_points=points, **HEATED["B"])
    results = solve(case_from_dict(case)).results
    cells = {column.heading: column.cells(results) for column in columns_of(results)}
    for place, result in enumerate(results):
        assert cells["T_probe"][place] == f"{result.values['probe_temperature'] - 273.15:.1f}"
        assert float(cells["k_yy"][place]) == pytest.approx(result.values["stiffness_yy"] / 1e6, rel=1e-3)
        assert float(cells["c_xx"][place]) == pytest.approx(result.values["damping_xx"] / 1e3, rel=1e-3)


def test_a_study_keeps_stiffness_damping_and_log_decrement():
    asked = {"kind": "tolerance", "vary": {"pads.preload": {"values": [0.45, 0.49]}}, "samples": 2}
    block = StudyBlock.model_validate(asked)
    kept = plan(case_from_dict(pad_case(rotor_mass="1 t")), block).task.outputs
    assert {"stiffness_yy", "damping_xy", "log_decrement", "minimum_film_thickness"} <= set(kept)


DRIVEN = {"rotor_mass": "1 t", "shaft_stiffness": "150 MN/m", "anticipated_cross_coupling": "4 MN/m"}


def tables_of(result):
    """Tables of the report by their titles."""
    return {one["title"]: one for one in view_of(result).tables(result)}


@pytest.mark.parametrize("title", ["Coefficients over the whirl ratio", "Cross-coupling of the rotor"])
def test_tables_of_coefficients_speak_the_units_of_the_us(title):
    result = result_of(**DRIVEN)
    si = tables_of(result)[title]
    with displayed_in("us"):
        us = tables_of(result)[title]
    inch = {"MN/m": 1e3 / 175.12683524647636, "kN s/m": 1e3 / 175.12683524647636}
    for place, (metric, shown) in enumerate(zip(si["columns"], us["columns"], strict=True)):
        if metric["unit"] in inch:
            assert shown["unit"] == {"MN/m": "klbf/in", "kN s/m": "lbf s/in"}[metric["unit"]]
            for row, other in zip(si["rows"], us["rows"], strict=True):
                assert float(other[place]) == pytest.approx(float(row[place]) * inch[metric["unit"]], rel=6e-3)
    assert "MN/m" not in str(us)
    assert " kg" not in str(us)


def test_the_table_of_cross_coupling_is_that_of_the_result():
    result = result_of(**DRIVEN)
    (full, synchronous) = tables_of(result)["Cross-coupling of the rotor"]["rows"]
    for prefix, row in (("", full), ("synchronous_", synchronous)):
        names = ("log_decrement", "log_decrement_anticipated", "critical_cross_coupling", "cross_coupling_ratio")
        shown = [result.values[f"{prefix}{name}"] for name in names]
        shown[2] *= 1e-6
        assert [float(one) for one in row[1:]] == pytest.approx(shown, rel=6e-3)
    assert "Q_A" not in str(tables_of(result)["Cross-coupling of the rotor"]["note"])


def test_motions_on_lines_are_straight_and_the_slower_stands_first():
    """Load on a pad, no cross terms: the rotor swings up and down, and across; neither motion whirls."""
    result = result_of({"pads.first_pivot": "-90 deg"}, rotor_mass="2 t")
    rows = tables_of(result)["Free motions of rotor and pads"]["rows"]
    assert {row[3] for row in rows if float(row[4]) > 20.0} == {"straight"}
    values = result.values
    assert values["whirl_frequency_forward"] < values["whirl_frequency_backward"]
    assert "backward" not in str([QUANTITIES[name].meaning for name in values if "ward" in name])


def test_motions_that_whirl_say_how():
    result = result_of({"pads.inertia": "0.05 kg m2"}, rotor_mass="200 kg", load_angle="-70 deg")
    for row, mode in zip(tables_of(result)["Free motions of rotor and pads"]["rows"], result.arrays["rotor_modes"],
                         strict=True):  # fmt: skip
        whirl = mode[3]
        assert row[3] == ("straight" if abs(whirl) < 0.1 else "forward" if whirl > 0.0 else "backward")


def test_words_of_the_report_have_no_underscores():
    (bearing,) = content(solve(case_from_dict(pad_case(**DRIVEN))))["bearings"]
    assert bearing["checks"]
    for part in ("checks", "not_checked", "warnings", "tables", "sources"):
        assert "Q_" not in str(bearing[part]), part
