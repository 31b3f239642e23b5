"""How a design stands by its worst clearance, and which of the usual rules it keeps."""

from __future__ import annotations

import math

import pytest
from studied_cases import JOURNAL

from babbitt.case.loading import case_from_dict
from babbitt.kinds.journal.study import first_design
from babbitt.solving import solve
from babbitt.study.rows import margin_name

COLD = {"row": 1, "margin": 0.2, "verdict": "pass", "governing_check": "C104", "codes": "", "surface_speed": 12.0}


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
