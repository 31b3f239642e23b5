"""Films with temperatures of their own that keep a limit by less than they can tell."""

import pytest

from babbitt import parse_case
from babbitt.core.result import Verdict
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.uncertainty import UNCERTAIN, UNCERTAIN_SHARE
from babbitt.solving import solve

FULL = """
kind: journal
name: A
method: {kind: film, thermal: full}
accuracy: draft
diameter: 120 mm
width: 80 mm
clearance: {kind: relative, mean: 1.5 permille}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
surfaces: {kind: direct, roughness_bearing: 1 um, roughness_journal: 1 um}
load: 15 kN
speed: 3000 rpm
"""


def solved(**limits):
    given = ", ".join(f"{name}: {value}" for name, value in limits.items())
    found = solve(parse_case(FULL + (f"limits: {{{given}}}\n" if given else "")))["A"]
    return found, [one.message for one in found.warnings if one.code == "W172"]


@pytest.fixture(scope="module")
def free():
    found, messages = solved()
    assert found.verdict is not Verdict.FAIL
    assert not messages  # C108 is kept by far
    return found


def test_a_film_is_asked_for_what_tilting_pads_are(free):
    """6 K, or a fifth of the rise where that is more; advice and misses are none."""
    hottest = free.maximum_bush_temperature
    asked = max(UNCERTAIN, UNCERTAIN_SHARE * (hottest - ZERO_CELSIUS - 45.0))
    for spare, questioned in ((asked - 0.1, True), (asked + 0.1, False), (-1.0, False)):
        found, messages = solved(temperature=f"{hottest - ZERO_CELSIUS + spare:.4f} degC")
        assert bool(messages) is questioned
        if questioned:
            assert "(C104)" in messages[0]
            assert f"within {asked:.1f} K" in messages[0]
            assert found.verdict is Verdict.REMARKS


@pytest.mark.parametrize(("share", "questioned"), [(1.019, True), (1.021, False), (0.99, False)])
def test_a_film_limit_is_kept_by_more_than_the_grid_may_miss(free, share, questioned):
    thin = free.minimum_film_thickness
    found, messages = solved(minimum_film_thickness=f"{1e6 * thin / share:.5f} um")
    assert bool(messages) is questioned
    if questioned:
        assert "(C101)" in messages[0]
        assert "within 2.0 %" in messages[0]
        assert found.verdict is Verdict.REMARKS
