"""The columns of a sweep are those of the kind of case."""

from __future__ import annotations

import pytest

from babbitt.case import kinds, parse_case, template
from babbitt.core.kind import find_kind
from babbitt.core.quantities import QUANTITIES
from babbitt.report.machine_table import columns_of
from babbitt.report.sweep_columns import panels_of, sweep_columns
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
    assert sweep_columns(results) == columns_of(results)
    assert panels_of(results)[0] == ("minimum_film_thickness", "load")
