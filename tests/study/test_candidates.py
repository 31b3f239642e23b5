"""How a design stands by its worst clearance, and which of the usual rules it keeps."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from studied_cases import JOURNAL, block

from babbitt.case.loading import case_from_dict
from babbitt.core.limited_flow import quantity_held
from babbitt.kinds.journal.study import first_design
from babbitt.solving import solve
from babbitt.study.candidates import candidates_of, ranked
from babbitt.study.design import designs_of
from babbitt.study.plan import plan
from babbitt.study.rows import advisory_name, margin_name
from babbitt.study.study import case_of, run_study

COLD = {"row": 1, "margin": 0.2, "verdict": "pass", "governing_check": "C104", "codes": "", "surface_speed": 12.0}


def candidate(lines, advisories=()):
    """The one design of some lines, the smallest clearance first."""
    whole = [{**COLD, "friction_power": 1e3, "total_flow": 1e-4, **line} for line in lines]
    columns = {name: np.array([line[name] for line in whole]) for name in whole[0]}
    (made,) = candidates_of(columns, (), advisories, lambda line: iter(()))
    return made


def test_the_speed_over_that_of_transition_is_of_both_speeds_whatever_c111_holds():
    surfaces = {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"}
    bearing = case_from_dict({**JOURNAL, "surfaces": surfaces})
    (result,) = solve(bearing).results
    (check,) = (one for one in result.checks if one.code == "C111")
    assert check.quantity == "hydrodynamic_speed"
    line = {**result.values, margin_name("C111"): check.margin}
    slow = result.starved_transition_speed
    assert first_design._over_transition(line) == pytest.approx(result.hydrodynamic_speed / slow, rel=1e-12)
    assert slow > result.transition_speed  # the film with less oil is hotter and thinner
    by_film = {**COLD, "hydrodynamic_speed": 200.0, margin_name("C111"): 0.5}  # h_min, no speed of transition
    assert math.isnan(first_design._over_transition(by_film))
    assert not list(first_design.departures(by_film))
    assert list(first_design.departures({**by_film, "transition_speed": 100.0})) == ["n/n_tr"]


@pytest.mark.parametrize("margins", list(itertools.permutations((math.nan, -0.5, 0.3))))
def test_a_recommendation_that_one_clearance_does_not_know_is_missed_by_another(margins):
    found = candidate([{advisory_name("C117"): margin} for margin in margins], ["C117"])
    assert found.departures == ("C117",)
    assert found.short == pytest.approx(0.5)
    unknown = candidate([{advisory_name("C117"): math.nan}] * 3, ["C117"])
    assert (unknown.departures, unknown.short) == ((), 0.0)


@pytest.mark.parametrize("slow", list(itertools.permutations((math.nan, 40.0, 20.0))))
def test_the_reasons_name_the_least_known_distance_from_transition(slow):
    ratios = {"width_ratio": 0.5, "relative_clearance": 1e-3, "recommended_relative_clearance": 1e-3}
    flows = {"supply_capacity": math.nan, "side_flow": 1e-4}
    line = {**COLD, **ratios, **flows, "specific_load": 1e6, "hydrodynamic_speed": 200.0}
    said = list(first_design.reasons([{**line, "transition_speed": one} for one in slow], {}))
    assert any("5 times the transition speed" in one for one in said)


def test_designs_are_ranked_by_the_film_that_the_feed_feeds():
    """With all its oil the one needs less power, with what its feed delivers the other does."""
    first = candidate([{"friction_power": 3e3, "starved_friction_power": 2.9e3, "starved_total_flow": 8e-5}] * 3)
    hotter = [{"friction_power": 3.2e3, "starved_friction_power": one, "starved_total_flow": 9e-5}
              for one in (2.5e3, 2.7e3, 2.6e3)]  # fmt: skip
    second = candidate(hotter)
    assert (first.power, first.flow, second.power) == (2.9e3, 8e-5, 2.7e3)
    assert ranked([first, second], 0.1) == [second, first]


def test_a_design_has_the_readings_that_its_limits_are_held_against():
    """Bearings short of oil: the columns of a design study hold power and flow of both films."""
    bearing = {name: value for name, value in JOURNAL.items() if name != "method"}
    vary = {"lubricant": ["ISO VG 46"], "clearance": ["H7/e8"], "supply_element": [JOURNAL["supply_element"]]}
    study = run_study(plan(case_from_dict(bearing), block(kind="design", vary=vary | {"width": ["60 mm"]})))
    (one,) = designs_of(study).tried
    assert {"starved_friction_power", "starved_total_flow"} <= set(study.outputs)
    short = [solved for solved in solve(case_of(study, one.row)).results if "starved_total_flow" in solved.values]
    assert short
    for quantity, found in (("friction_power", one.power), ("total_flow", one.flow)):
        held = [
            solved.values[quantity_held(solved, quantity)] for solved in solve(case_of(study, one.row)).results
        ]
        assert found == pytest.approx(max(held), rel=1e-9)
        assert found < max(solved.values[quantity] for solved in short)
