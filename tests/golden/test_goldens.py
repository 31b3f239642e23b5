"""Answers and reports of every template and example are those of the goldens."""

import pytest

from babbitt.core.quantities import QUANTITIES
from golden import CASES, answer, differences, same_text, solved, stored, tolerance_of

NOT_PASSED = {
    "trawler_thrust_line",
    "grooved",
    "long_film",
    "pump_footstep",
    "pump_footstep_metal",
    "output_wheel_load_share",
}
"""Examples: a bearing that breaks a limit, as its source says; films of one dimension, whose thickness keeps no
limit; a heel with an unstable state; a heel and a shaft in statics, of which nothing is held against a limit."""


LONG = (
    "example_reverse_gear_film",
    "example_starved_journal",
    "example_helical_gear_shaft",
    "example_unbalanced_fan",
)
"""Cases that take longer than five seconds; shorter ones of their kinds are always compared."""


def cases():
    """Each case; the long ones are left to `make test-thorough`."""
    return [pytest.param(name, marks=[pytest.mark.thorough] * (name in LONG)) for name in CASES]


@pytest.mark.parametrize("name", cases())
def test_answer_is_that_of_the_golden(name):
    """And examples have an operating point, a verdict, and a record of known quantities."""
    machine = solved(name)
    kept, now = stored(name), answer(machine)
    found = list(differences(kept, now, tolerance_of(kept)))
    assert not found, "\n".join(found[:20])
    if example := name.partition("example_")[2]:
        assert machine.within_limits is (example not in NOT_PASSED)
        assert all(one["results"] for one in now["results"]["bearings"])
        assert all(set(one.values) <= set(QUANTITIES) for one in machine.results)


def test_texts_may_differ_in_the_last_digit_alone():
    assert same_text("h = 24.31 µm at 45 °C", "h = 24.32 µm at 45 °C")
    assert not same_text("h = 24.31 µm at 45 °C", "h = 24.33 µm at 45 °C")
    assert not same_text("h = 24.31 µm", "h = 24.31 mm")
    assert same_text("5.57e-13", "5.40e-13")  # round-off of a balance
    assert not same_text("5.57e-9", "5.40e-9")


def test_a_changed_number_or_a_lost_entry_is_found():
    assert list(differences({"a": 1.0}, {"a": 1.0 + 1e-6}, 1e-7))
    assert list(differences({"a": 1.0, "b": 2}, {"a": 1.0}, 1e-7))
    assert not list(differences({"stiffness": 1.0}, {"stiffness": 1.0 + 1e-6}, 1e-7))


def test_round_off_is_told_from_numbers_by_the_size_of_what_they_measure():
    matrix = {"tilt_stiffness": [[1e8, -3e-9], [0.0, 1e8]]}
    assert not list(differences(matrix, {"tilt_stiffness": [[1e8, 2e-9], [0.0, 1e8]]}, 1e-7))
    assert list(differences(matrix, {"tilt_stiffness": [[1e8, 1.0], [0.0, 1e8]]}, 1e-7))
    assert not list(differences({"friction_power": -2.427e-8}, {"friction_power": -2.426e-8}, 1e-7))
    assert list(differences({"friction_power": 2.427}, {"friction_power": 2.426}, 1e-7))
    assert list(differences({"minimum_film_thickness": 2e-6}, {"minimum_film_thickness": 2.00001e-6}, 1e-7))
