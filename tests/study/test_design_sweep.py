"""Sweeps of a design follow the physics, and a point without a solution is a gap."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from film_bearings import film

from babbitt.core.result import Outcome
from babbitt.core.solution import Calculation
from babbitt.kinds.journal.film.check import film_check
from babbitt.kinds.journal.iso7902 import check
from babbitt.kinds.journal.iso7902.model import Bearing, Curves, DesignCase, OilSupply, PrescribedLoad
from babbitt.kinds.journal.iso7902.supply import Arrangement, Holes
from babbitt.kinds.journal.methods import METHODS, Iso7902
from babbitt.kinds.journal.study.design_sweep import sweep_design, varied
from babbitt.properties.lubricants import lubricant

CASE = DesignCase(
    "swept",
    Bearing(0.120, 0.060, 1.5e-3, 360, 11e-6, 11e-6, Holes(0.005, Arrangement.OPPOSITE)),
    PrescribedLoad(20e3),
    209.4,
    lubricant("ISO VG 46"),
    OilSupply(323.15, 0.2e6),
)


def test_each_point_is_the_check_of_that_case():
    loads = [10e3, 20e3, 30e3]
    swept = sweep_design(Calculation(CASE, METHODS["iso7902"]), "duty.load", loads)
    assert swept.points.tolist() == loads
    for place, load in enumerate(loads):
        alone = check(varied(CASE, "duty.load", load))
        assert swept["minimum_film_thickness"][place] == alone.minimum_film_thickness
        assert swept.outcomes[place] is alone.outcome


def test_a_point_is_not_held_against_the_film_of_the_bearing_as_it_is(monkeypatch):
    """Figures of a report took a minute, and the film had the load, speed and clearance of the case."""
    own, held = Iso7902.solve, []

    def seen(self, problem):
        held.append(problem.fuller_film)
        return own(self, problem)

    monkeypatch.setattr(Iso7902, "solve", seen)
    sweep_design(Calculation(replace(CASE, fuller_film=film()), Iso7902()), "duty.load", [10e3, 20e3])
    assert held == [None, None]


def test_more_load_thins_the_film_and_more_speed_thickens_it():
    by_load = sweep_design(Calculation(CASE, METHODS["iso7902"]), "duty.load", np.linspace(5e3, 60e3, 12))
    assert np.all(np.diff(by_load["minimum_film_thickness"]) < 0)
    assert np.all(np.diff(by_load["eccentricity_ratio"]) > 0)
    by_speed = sweep_design(Calculation(CASE, METHODS["iso7902"]), "journal_speed", np.linspace(50.0, 250.0, 9))
    assert np.all(np.diff(by_speed["minimum_film_thickness"]) > 0)
    assert np.all(np.diff(by_speed["outlet_temperature"]) > 0)


def test_what_cannot_be_solved_is_a_gap():
    swept = sweep_design(Calculation(CASE, METHODS["iso7902"]), "duty.load", [20e3, 5e6])
    assert swept.solved.tolist() == [True, False]
    assert swept.outcomes[1] is Outcome.OVERLOADED
    assert math.isfinite(swept["minimum_film_thickness"][0])
    assert math.isnan(swept["minimum_film_thickness"][1])


def test_a_clearance_that_closes_is_a_gap():
    swept = sweep_design(Calculation(CASE, METHODS["iso7902"]), "bearing.relative_clearance", [1.5e-3, -1e-4])
    assert swept.outcomes[1] is Outcome.NO_CLEARANCE
    assert math.isnan(swept["eccentricity_ratio"][1])


def test_spans_stay_whole_and_nothing_else_changes():
    swept = sweep_design(Calculation(CASE, METHODS["iso7902"]), "bearing.span", [360.0, 180.0, 90.0])
    assert swept.solved.all()
    assert np.all(np.diff(swept["eccentricity_ratio"]) > 0)
    changed = varied(CASE, "bearing.span", 180.0)
    assert changed.bearing.span == 180
    assert isinstance(changed.bearing.span, int)
    assert CASE.bearing.span == 360


def test_a_whole_number_where_the_design_has_a_real_one_does_not_round():
    whole = replace(CASE, friction_factor=1)
    power = sweep_design(Calculation(whole, METHODS["iso7902"]), "friction_factor", [1.0, 1.2, 1.4])[
        "friction_coefficient"
    ]
    assert np.all(np.diff(power) > 0)


def test_a_refused_point_is_a_gap():
    forms = replace(CASE, curves=Curves.CLOSED_FORM)
    swept = sweep_design(Calculation(forms, METHODS["iso7902"]), "bearing.width", [0.060, 0.300])
    assert swept.solved.tolist() == [True, False]
    assert "1" in swept.refused[1]
    assert swept.outcomes[1] is None


def test_an_absent_result_is_all_gaps():
    assert np.isnan(
        sweep_design(Calculation(CASE, METHODS["iso7902"]), "duty.load", [1e4, 2e4])["transition_speed"]
    ).all()


@pytest.mark.parametrize(
    "path", ["duty.strength", "speed", "cooling.surface", "name", "lubricant", "bearing.span.x"]
)
def test_a_number_that_the_case_does_not_have_is_an_error(path):
    with pytest.raises(ValueError, match="case"):
        sweep_design(Calculation(CASE, METHODS["iso7902"]), path, [1.0])


def test_a_film_is_swept_as_a_standard_bearing_is():
    case = film(effective_temperature="60 degC")
    found = sweep_design(Calculation(case, METHODS["film"]), "duty.load", [10e3, 30e3, 9e10])
    assert found.solved.tolist() == [True, True, False]
    assert found["minimum_film_thickness"][1] == pytest.approx(film_check(case).minimum_film_thickness)
    assert found["minimum_film_thickness"][0] > found["minimum_film_thickness"][1]
    assert np.isnan(found["stiffness_xx"][2])
    assert varied(case, "bearing.width", 0.1).bearing.width == 0.1
