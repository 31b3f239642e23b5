"""Film of one groove pitch: exact without depth, conservation, order of convergence, many grooves."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.validation.research.groove_pitch import GroovePitch, pitch_film

PITCH = GroovePitch(21.8e-3, 35e-3, 5, 0.251, math.radians(10.0), 20e-6, 0.3e-3, 0.0225, 3.31)


def test_without_depth_it_is_the_plain_clearance():
    found = pitch_film(replace(PITCH, depth=0.0), 0.5e6, 12, 24)
    exact = -math.pi * 21.8e-3 * (20e-6) ** 3 * 0.5e6 / (6.0 * 0.0225 * 35e-3)
    assert found.flow == pytest.approx(exact, rel=1e-9)
    assert found.pressure == pytest.approx(
        np.broadcast_to(0.5e6 * found.z / 35e-3, found.pressure.shape), rel=1e-9
    )
    couette = 0.0225 * 3.31**2 / 20e-6 * 2.0 * math.pi * 21.8e-3 * 35e-3
    assert found.wall_power == pytest.approx(couette, rel=1e-9)


def test_oil_is_conserved_and_the_film_is_linear():
    none, half, whole = (pitch_film(PITCH, rise, 12, 32) for rise in (0.0, 0.25e6, 0.5e6))
    assert max(abs(found.imbalance) for found in (none, half, whole)) < 1e-10
    assert half.flow == pytest.approx(0.5 * (none.flow + whole.flow), rel=1e-9)


def test_energy():
    """The wall gives more than the flow takes along: heat is positive."""
    found = pitch_film(PITCH, 0.3e6, 12, 32)
    assert found.flow > 0.0
    assert found.wall_power > 2.0 * found.flow * 0.3e6


@pytest.mark.parametrize("angle", [10.0, 30.0, 60.0])
def test_many_grooves_meet_narrow_groove_theory_with_the_first_power_of_the_pitch(angle):
    """Dragged flow and conductance of Vohr and Chow, formulas written out here."""
    share, land, groove = 0.4, 25e-6, 25e-6 + 60e-6
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    s2 = share / groove**2 + (1 - share) / land**2
    s3 = share / groove**3 + (1 - share) / land**3
    around, speed = 2.0 * math.pi * 21.8e-3, 3.31
    dragged = around * 0.5 * speed * sine * cosine * (share * groove + (1 - share) * land - s2 / s3)
    mean = share * groove**3 + (1 - share) * land**3
    conductance = around / (12.0 * 0.0225 * 35e-3) * (mean * sine**2 + cosine**2 / s3)
    misses = []
    for starts in (20, 40):
        pitch = GroovePitch(21.8e-3, 35e-3, starts, share, math.radians(angle), land, 60e-6, 0.0225, speed)
        still, driven = pitch_film(pitch, 0.0), pitch_film(pitch, 1e6)
        assert still.flow == pytest.approx(dragged, rel=0.04)
        misses.append((still.flow - driven.flow) / 1e6 / conductance - 1.0)
        assert abs(misses[-1]) < 0.03
    assert misses[0] / misses[1] == pytest.approx(2.0, rel=0.12)


def test_refinement_converges():
    flows = [pitch_film(PITCH, 0.5e6, n, 3 * n).flow for n in (8, 16, 32)]
    assert abs(flows[2] - flows[1]) < 0.6 * abs(flows[1] - flows[0])
    assert flows[1] == pytest.approx(flows[2], rel=2e-3)


def test_bad_pitches_are_refused():
    for name, value in (("radius", 0.0), ("starts", -1), ("groove_share", 1.0), ("angle", 2.0), ("depth", -1e-6)):
        with pytest.raises(InputError) as caught:
            replace(PITCH, **{name: value})
        assert caught.value.code == "E101"
