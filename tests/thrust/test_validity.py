"""What lies outside the validity of the model of a thrust bearing has no verdict; oil and heat are balanced."""

import math
from dataclasses import replace

import pytest
from trawler_pads import PAD, SPEED, VISCOSITY

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.notices import Effect, explanations
from babbitt.core.result import Verdict
from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.design import bearing_state
from babbitt.kinds.thrust.face import SteppedFace, TaperedFace
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import Pivot
from babbitt.kinds.thrust.sharing import share_of
from babbitt.kinds.thrust.warnings import sharing_warnings
from babbitt.solving import solve

BASE = template("thrust")


def result(*changes):
    text = BASE
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return solve(parse_case(text)).results[0]


@pytest.mark.parametrize("face", [SteppedFace(40e-6, 0.6), TaperedFace(40e-6, 0.7)])
def test_tilted_fixed_pads_conserve_their_oil(face):
    """Films that break up behind the land of a pad that diverges: 2.6 % of the oil was made under Reynolds."""
    pad = replace(PAD, face=face, pivot=Pivot.FIXED)
    tilted = ThrustBearing(pad, 8, 2e9, tilt=HousingTilt(60e-6, 0.3))
    share = share_of(carrying(pad, VISCOSITY, SPEED), tilted, 300e3)
    assert any((state.film.liquid_fraction < 1.0).any() for state in share.states)
    for state in share.states:
        net = state.leading_flow - state.trailing_flow - state.inner_flow - state.outer_flow
        assert abs(net) < 1e-10 * state.leading_flow
        assert state.mass_balance_error < 1e-10


def test_oil_and_heat_are_results():
    found = result()
    assert found.mass_balance_error < 1e-10
    assert found.energy_balance_error < 1e-6


def test_oil_or_heat_that_is_lost_and_damping_below_zero_have_no_verdict(monkeypatch):
    """Bounds: 1e-6 of the oil that passes a pad, 1e-3 of the friction power."""
    (design,) = parse_case(BASE).problems()
    state = bearing_state(design)

    def told(found):
        return {notice.code for notice in sharing_warnings(design, found)} & {"W211", "W212"}

    def losing(share):
        pads = tuple(replace(pad, leading_flow=pad.leading_flow * (1.0 + share)) for pad in state.share.states)
        return replace(state, share=replace(state.share, states=pads))

    def open_by(error):
        return replace(state, temperatures=replace(state.temperatures, error=error))

    assert told(state) == told(losing(2e-7)) == told(open_by(5e-4)) == set()
    assert told(losing(1e-5)) == told(open_by(-2e-3)) == told(open_by(math.nan)) == {"W211"}
    monkeypatch.setattr("babbitt.kinds.thrust.warnings.condensed", lambda *given: -1j)
    assert told(state) == {"W212"}
    assert all(explanations()[code].effect is Effect.NO_VERDICT for code in ("W211", "W212"))


def test_one_pad_that_carries_all_has_no_verdict():
    found = result(
        ("tilt: {offset: 30 um,", "tilt: {offset: 5 mm,"), ("ring_stiffness: 20 GN/m", "#"), ("runout: 5 um", "#")
    )
    assert found.verdict in (Verdict.NO_VERDICT, Verdict.FAIL, Verdict.NO_SOLUTION)
    assert not found.within_limits
    light = result(
        ("tilt: {offset: 30 um,", "tilt: {offset: 5 mm,"), ("ring_stiffness: 20 GN/m", "#"), ("runout: 5 um", "#"),
        ("load: 500 kN", "load: 5 kN"),
    )  # fmt: skip
    assert light.pad_load_ratio > 7.0
    assert light.verdict is Verdict.NO_VERDICT
    assert "W213" in [notice.code for notice in light.warnings]


def test_oil_that_friction_would_boil_has_no_verdict():
    """Of a given viscosity nothing follows the heat: what it would do to the oil is told."""
    start, end = BASE.index("lubricant:"), BASE.index("# method:")
    text = BASE[:start] + "oil: {kind: viscosity, viscosity: 45 mPa s}\n" + BASE[end:]
    found = solve(parse_case(text.replace("125 rpm", "6000 rpm").replace("500 kN", "20 MN"))).results[0]
    assert found.temperature_rise > 100.0
    assert "W127" in [notice.code for notice in found.warnings]
    assert found.verdict in (Verdict.NO_VERDICT, Verdict.FAIL)
    assert math.isfinite(found.load)
