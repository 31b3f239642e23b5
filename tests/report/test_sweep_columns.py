"""The columns of a sweep are those of the kind of case."""

from __future__ import annotations

import pytest

from babbitt.cases import kinds, parse_case, template
from babbitt.quantities import QUANTITIES
from babbitt.report.sweep_columns import KEY_RESULTS, panels_of, sweep_columns
from babbitt.solving import solve


def test_the_key_results_are_quantities_of_known_kinds():
    assert KEY_RESULTS.keys() <= kinds().keys()
    assert {name for names in KEY_RESULTS.values() for name in names} <= QUANTITIES.keys()


@pytest.mark.parametrize(
    "kind", ["hydrostatic_pad", "jacking_pocket", "overhung_coupling", "screw_heel", "thrust"]
)
def test_a_kind_has_columns_of_its_own_and_they_are_filled(kind):
    results = solve(parse_case(template(kind))).results
    names = [name for name in KEY_RESULTS[kind] if name in results[0].values]
    assert len(names) >= 5
    columns = sweep_columns(results)
    assert columns is not None
    assert [column.heading for column in columns] == [QUANTITIES[name].symbol for name in names]
    assert panels_of(results) == tuple((name,) for name in names[:4])


def test_journal_bearings_have_those_of_their_table():
    results = solve(parse_case(template("journal"))).results
    assert sweep_columns(results) is None
    assert panels_of(results)[0] == ("minimum_film_thickness",)
