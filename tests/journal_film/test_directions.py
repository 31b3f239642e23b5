"""Directions in the results of a film: the narrowest gap and the sense of rotation."""

import math

import pytest
from film_bearings import answer

from babbitt.kinds.journal.film.field import narrowest_gap_angle
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import Cavitation, JournalFilm, Land, grooved_bore

QUICK = {"accuracy": "draft", "effective_temperature": "60 degC"}


@pytest.mark.parametrize("direction", [-100.0, -20.0, 170.0])
def test_the_gap_of_a_round_bore_is_narrowest_along_the_line_of_centres(direction):
    where = math.radians(direction)
    film = JournalFilm(0.1, 0.05, 1e-4, 0.02, 300.0, grooved_bore((0.5, 0.5 + math.pi), 0.3), Cavitation.REYNOLDS)
    found = film_at_position(film, (6e-5 * math.cos(where), 6e-5 * math.sin(where)))
    assert narrowest_gap_angle(found) == pytest.approx(where, abs=1e-4)


def test_the_gap_of_a_centred_lemon_is_narrowest_in_the_middle_of_a_lobe():
    half, depth = 0.5 * math.pi, 1e-4
    lobes = tuple(
        Land(at - half + 0.15, at + half - 0.15, 2e-4, (-depth * math.cos(at), -depth * math.sin(at)))
        for at in (half, -half)
    )
    film = JournalFilm(0.1, 0.05, 1e-4, 0.02, 300.0, lobes, Cavitation.REYNOLDS)
    found = film_at_position(film, (1e-5, -2e-5))
    assert narrowest_gap_angle(found) == pytest.approx(math.atan2(-depth - 2e-5, 1e-5), abs=1e-4)


def test_a_clockwise_journal_has_a_negative_speed_and_the_mirrored_gap():
    there, back = answer(**QUICK), answer(**QUICK, speed="-3000 rpm")
    assert there.angular_speed == pytest.approx(100.0 * math.pi)
    assert back.angular_speed == pytest.approx(-100.0 * math.pi)
    assert back.hydrodynamic_speed == there.hydrodynamic_speed
    assert back.attitude_angle == pytest.approx(there.attitude_angle, abs=1e-6)
    assert there.narrowest_gap_angle == pytest.approx(there.load_angle + there.attitude_angle, abs=1e-4)
    assert back.narrowest_gap_angle == pytest.approx(back.load_angle - back.attitude_angle, abs=1e-4)


@pytest.mark.parametrize("speed", ["3000 rpm", "-3000 rpm"])
def test_a_groove_of_given_flow_may_break_the_film_at_any_pressure(speed):
    """-10 psi has more digits than the frame keeps in which a film is solved."""
    grooves = [
        {"angle": f"{angle} deg", "extent": "20 deg", "flow": flow}
        for angle, flow in ((0, "8 L/min"), (180, "0.5 L/min"))
    ]
    result = answer(
        grooves=grooves, cavitation_pressure="-10 psi", load="10 kN", speed=speed, accuracy="draft",
        diameter="100 mm", width="80 mm",
    )  # fmt: skip
    assert result.minimum_film_thickness > 10e-6
