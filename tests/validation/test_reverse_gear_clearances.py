"""The clearances of the reverse gear cost temperature and margin, but no limit and no yield."""

from __future__ import annotations

import pytest

from babbitt.validation.published.reverse_gear_clearances import real, recommended, shortfall


def test_limits_are_kept_at_both_clearances_and_by_all_samples():
    for answers in (real(), recommended()):
        assert len(answers.results) == 11
        assert all(result.within_limits for result in answers.results.values())
        assert set(answers.yields.values()) == {1.0}


def test_more_clearance_lets_more_oil_through_which_stays_cooler():
    for name, now in real().results.items():
        then = recommended().results[name]
        assert shortfall(then) == pytest.approx(0.0, abs=1e-9)
        wider = shortfall(now) > 0.0
        assert (then.outlet_temperature < now.outlet_temperature) is wider
        assert (then.side_flow > now.side_flow) is wider
        temperatures = {"outlet_temperature", "starved_outlet_temperature"}
        if wider and now.governing_check.quantity in temperatures:
            assert then.margin > now.margin
    assert sum(shortfall(now) > 0.0 for now in real().results.values()) == 10
