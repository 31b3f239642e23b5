"""Key columns of footsteps and hydrostatic bearings in machine and sweep tables."""

import pytest
from heels import STUDY

from babbitt.case import parse_case, template
from babbitt.report.columns import ABSENT
from babbitt.report.machine_table import columns_of
from babbitt.solving import solve


def headings(text):
    results = solve(parse_case(text)).results
    return {column.heading: column.cells(results) for column in columns_of(results)}


def test_footsteps_show_load_and_pressure_of_every_state():
    cells = headings(STUDY)
    assert list(cells)[:3] == ["F", "p₁", "Q₂"]
    assert cells["F"] == ["0.834", "0.829", "1.04"]
    assert cells["F/F_s"][0] == ABSENT
    assert "h_min / h_lim" not in cells


@pytest.mark.parametrize(
    ("kind", "wanted", "never"),
    [("hydrostatic_pad", {"F", "h_m", "β_m", "Q", "K_z"}, {"Re / Re_cr", "ε"}),
     ("hydrostatic_journal", {"F", "ε", "β_m", "Q", "ΔT"}, {"h_m", "Re / Re_cr"}),
     ("jacking_pocket", {"F", "p_j", "Q"}, {"β_m", "P_f"})],
)  # fmt: skip
def test_hydrostatic_bearings_show_pressure_ratio_and_flow(kind, wanted, never):
    cells = headings(template(kind))
    assert wanted <= set(cells)
    assert not never & set(cells)
