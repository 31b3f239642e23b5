"""A thermal film runs away only where it does: not where a round of its clearance ends hot on the way."""

import pytest

from babbitt.case import case_from_dict
from babbitt.core.result import Outcome, Result
from babbitt.solving import solve

CEILING = 573.15


def hot_film(specific_load: float, load_angle: float = -90.0) -> Result:
    """Adiabatic film of some 0.2 um at a specific load in MPa; its grooves stand beside the load."""
    diameter, width = 50.0, 30.0
    case = {
        "babbitt": 1, "kind": "journal", "name": "Hot film", "method": "film", "thermal": "adiabatic",
        "accuracy": "draft", "diameter": f"{diameter} mm", "width": f"{width} mm",
        "clearance": {"kind": "relative", "mean": "1.2 permille"}, "lubricant": "ISO VG 32",
        "supply": {"temperature": "80 degC", "pressure": "0.2 MPa"}, "speed": "431 rpm",
        "materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"},
        "load": f"{specific_load * diameter * width * 1e-3} kN", "load_angle": f"{load_angle} deg",
        "grooves": [{"angle": f"{load_angle + turn} deg", "extent": "20 deg"} for turn in (90.0, -90.0)],
    }  # fmt: skip
    (result,) = solve(case_from_dict(case)).results
    return result


def test_hotter_than_the_ceiling_is_said_only_of_films_that_are() -> None:
    """Temperatures rise smoothly with the load up to the ceiling; the next load would pass it."""
    warm, hot, hotter = (hot_film(load) for load in (9.2, 9.5, 9.8))
    assert all(result.outcome.solved for result in (warm, hot, hotter))
    first, second, third = (result.values["maximum_temperature"] for result in (warm, hot, hotter))
    assert first < second < third < CEILING
    assert third - second == pytest.approx(second - first, rel=0.2)
    assert third + (third - second) > CEILING
    assert hot_film(10.1).outcome is Outcome.THERMAL_RUNAWAY


def test_a_turned_hot_film_ends_alike() -> None:
    for load in (9.8, 50.0):
        one, other = hot_film(load), hot_film(load, 17.0)
        assert other.outcome is one.outcome
        warmth = one.values["maximum_temperature"]
        assert other.values["maximum_temperature"] == pytest.approx(warmth, rel=1e-6)
