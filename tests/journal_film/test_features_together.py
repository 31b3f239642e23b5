"""Features of the film method that meet in one bearing: balances close, and each still says what it says alone."""

import pytest
from film_bearings import answer

POCKETS = [{"angle": f"{angle} deg", "extent": "20 deg", "width": "80 mm"} for angle in (0, 180)]
GIVEN_FLOW = {"temperature": "45 degC", "flow": "3 L/min"}
TOGETHER = {
    "prescribed position, tilt": {
        "load": None,
        "position": {"x": "40 um", "y": "-60 um"},
        "tilt_coefficients": True,
    },
    "starved pockets, all equilibria": {
        "grooves": None,
        "pockets": POCKETS,
        "supply": GIVEN_FLOW,
        "equilibria": "all",
    },
    "half-Sommerfeld": {
        "grooves": None,
        "supply": None,
        "cavitation": "half_sommerfeld",
        "effective_temperature": "60 degC",
    },
}


@pytest.mark.parametrize("name", TOGETHER)
def test_the_grid_error_is_small_whatever_the_film_is(name):
    found = answer(**TOGETHER[name], error_estimate=True)
    place = ["load_error"] if "position" in TOGETHER[name] else ["minimum_film_thickness_error", "position_error"]
    coefficients = [] if name == "half-Sommerfeld" else ["stiffness_error", "damping_error"]
    errors = {key: value for key, value in found.values.items() if key in (*place, *coefficients)}
    assert sorted(errors) == sorted([*place, *coefficients])
    assert all(0.0 <= value < 0.01 for value in errors.values()), errors
    assert not any(notice.code == "W125" for notice in found.warnings)
    if not coefficients:
        return  # a film without flow has no heat balance
    assert abs(found.energy_balance_error) < 1e-6
    assert found.mass_balance_error < 1e-9
