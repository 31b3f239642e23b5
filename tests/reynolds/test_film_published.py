"""Published journal films: rows as printed, tolerances as the sources support them."""

import math

import numpy as np
import pytest

from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import ENGINEERING, Cavitation, FilmStart, JournalFilm, Land, Resolution, grooved_bore

DIAMETER, CLEARANCE, VISCOSITY, SPEED = 0.1, 1e-4, 0.02, 100.0
RING = (Land(0.0, 2.0 * math.pi),)
FINE = Resolution(6, 192)


def widest_gap(width_ratio, speed=SPEED):
    return JournalFilm(
        DIAMETER,
        width_ratio * DIAMETER,
        CLEARANCE,
        VISCOSITY,
        speed,
        RING,
        Cavitation.REYNOLDS,
        FilmStart.WIDEST_GAP,
    )


# Butenschoen H.-J. (1976), dissertation, Karlsruhe: eps, D/B, So, beta in degrees, Q3 / ((D/2)^3 psi omega)
BUTENSCHOEN = [
    (0.1, 1, 0.1196, 79.41, 0.1603),
    (0.1, 3, 0.0171, 82.299, 0.0648),
    (0.4, 1, 0.6108, 62.571, 0.6318),
    (0.4, 3, 0.0968, 61.382, 0.2592),
    (0.7, 1, 2.0432, 43.859, 1.0888),
    (0.7, 3, 0.4492, 39.756, 0.454),
    (0.9, 1, 8.4352, 26.482, 1.3898),
    (0.9, 3, 3.2201, 22.368, 0.5852),
    (0.97, 1, 33.1297, 15.484, 1.4968),
    (0.97, 3, 19.7034, 12.929, 0.6322),
    (0.99, 1, 107.7868, 9.416, 1.5277),
    (0.99, 3, 81.1597, 8.066, 0.6461),
]


@pytest.mark.parametrize(("eps", "slenderness", "so", "beta", "flow"), BUTENSCHOEN)
def test_butenschoen_rotation(eps, slenderness, so, beta, flow):
    film = film_at_position(widest_gap(1.0 / slenderness), (0.0, -eps * CLEARANCE), resolution=FINE)
    unit = (0.5 * DIAMETER) ** 3 * 2.0 * CLEARANCE / DIAMETER * SPEED
    assert film.sommerfeld_number == pytest.approx(so, rel=6e-3)
    assert math.degrees(film.attitude_angle) == pytest.approx(beta, abs=0.05)
    assert film.side_flow.sum() / unit == pytest.approx(flow, rel=6e-3)


# The same, pure squeeze: signed eccentricity ratio (positive towards the smaller gap), So_V for B/D = 1 and 1/3
SQUEEZE = [
    (-0.9, 0.5518, 0.0663),
    (-0.5, 0.971, 0.1211),
    (0, 2.4076, 0.3355),
    (0.3, 5.0479, 0.8081),
    (0.7, 24.842, 6.0733),
    (0.9, 160.25, 68.484),
]


@pytest.mark.parametrize(("eps", "square", "slender"), SQUEEZE)
def test_butenschoen_squeeze(eps, square, slender):
    lands = (Land(0.0, 2.0 * math.pi),)  # cut behind the journal's path, where the film is ruptured
    for ratio, so in ((1.0, square), (1.0 / 3.0, slender)):
        model = JournalFilm(
            DIAMETER, ratio * DIAMETER, CLEARANCE, VISCOSITY, 0.0, lands, Cavitation.REYNOLDS, FilmStart.PERIODIC
        )
        velocity = 1e-3
        found = film_at_position(model, (0.0, -eps * CLEARANCE), (0.0, -velocity), FINE)
        psi = 2.0 * CLEARANCE / DIAMETER
        number = found.load * psi**2 / (model.width * DIAMETER * VISCOSITY * velocity / CLEARANCE)
        assert number == pytest.approx(so, rel=0.01)


# Raimondi, Boyd (1958), L/D = 1: h0/c, S, attitude angle, Q/(R c N L), Qs/Q
RAIMONDI_BOYD = [
    (0.8, 0.631, 74.02, 3.59, 0.280),
    (0.6, 0.264, 63.10, 3.99, 0.497),
    (0.4, 0.121, 50.58, 4.33, 0.680),
    (0.2, 0.0446, 36.24, 4.62, 0.842),
]


@pytest.mark.parametrize(("thickness", "number", "attitude", "flow", "side"), RAIMONDI_BOYD)
def test_raimondi_boyd(thickness, number, attitude, flow, side):
    film = film_at_position(widest_gap(1.0), (0.0, -(1.0 - thickness) * CLEARANCE), resolution=FINE)
    turns = SPEED / (2.0 * math.pi)
    unit = 0.5 * DIAMETER * CLEARANCE * turns * DIAMETER
    s = VISCOSITY * turns * DIAMETER**2 / film.load * (0.5 * DIAMETER / CLEARANCE) ** 2
    assert s == pytest.approx(number, rel=0.015)  # Butenschoen supports us where they differ by 1.3 %
    assert math.degrees(film.attitude_angle) == pytest.approx(attitude, abs=0.6)
    assert film.inflow.sum() / unit == pytest.approx(flow, rel=0.012)
    assert film.side_flow.sum() / film.inflow.sum() == pytest.approx(side, abs=0.01)


# Lund, Thomsen (1978), two axial grooves of 20 degrees, L/D = 0.5, x along the load, K c / W and B c omega / W
LUND_THOMSEN = [
    (6.430, 0.071, 81.89, 1.55, 14.41, -6.60, 1.88, 28.75, 1.89, 1.89, 13.31),
    (1.656, 0.244, 65.85, 1.69, 5.06, -2.20, 1.95, 9.93, 2.15, 2.15, 4.80),
    (0.580, 0.477, 51.01, 2.67, 3.70, -0.78, 1.75, 6.96, 1.94, 1.94, 2.40),
    (0.244, 0.655, 40.25, 4.21, 3.74, -0.13, 1.64, 6.87, 1.82, 1.82, 1.54),
    (0.086, 0.809, 30.04, 7.51, 4.42, 0.47, 1.59, 8.03, 1.79, 1.79, 1.03),
]


@pytest.mark.parametrize("row", LUND_THOMSEN, ids=lambda row: f"S={row[0]}")
def test_lund_thomsen(row):
    width = 0.5 * DIAMETER
    load = VISCOSITY * SPEED / (2.0 * math.pi) * width * DIAMETER / row[0] * (0.5 * DIAMETER / CLEARANCE) ** 2
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    film = JournalFilm(DIAMETER, width, CLEARANCE, VISCOSITY, SPEED, lands, Cavitation.REYNOLDS)
    found = solve_journal(film, (0.0, -load), ENGINEERING)
    assert found.outcome.solved
    assert found.eccentricity_ratio == pytest.approx(row[1], abs=1e-3)
    assert math.degrees(found.attitude_angle) == pytest.approx(row[2], abs=0.1)
    along = np.array([[0.0, -1.0], [1.0, 0.0]])  # their x is our -y, their y our x
    stiffness = along @ found.stiffness @ along.T * CLEARANCE / load
    damping = along @ found.damping @ along.T * CLEARANCE * SPEED / load
    np.testing.assert_allclose([*stiffness.ravel(), *damping.ravel()], row[3:], atol=0.05)


# Someya (ed.) (1989), Journal-Bearing Databook, table 1: two axial grooves, L/D = 0.5; x along the load; 4 of
# 13. The print does not say how wide the grooves are; of 0, 10, 20, 30, 40 degrees 10 fits eps, angle and
# damping best. Its Kxy and Kyx fit a load curve that turns with the journal, not fixed grooves. That reading
# leaves Kyy unexplained at low load (3.6 against 2.72 at S = 5.96), so Kxx and Kyy are not tested.
SOMEYA = [
    (5.96, 0.075, 82.6, 13.6, -13.1, 27.2, 2.06, 14.9),
    (2.07, 0.2, 71.6, 5.63, -4.41, 11.2, 2.22, 6.43),
    (0.517, 0.5, 51.1, 3.57, -0.924, 6.81, 2.1, 2.6),
    (0.0926, 0.8, 31.2, 4.46, 0.527, 8.17, 2.05, 1.24),
]


def turning_stiffness(solved, lighter, heavier):
    """K over W in axes along and across the load, for a film that turns with the journal."""
    eps, angle = solved.eccentricity_ratio, solved.attitude_angle
    pair = [s.load / solved.load * np.array([-math.cos(s.attitude_angle), math.sin(s.attitude_angle)])
            for s in (lighter, heavier)]  # fmt: skip
    radial = (pair[1] - pair[0]) / (heavier.eccentricity_ratio - lighter.eccentricity_ratio)
    across = np.array([-math.sin(angle), -math.cos(angle)]) / eps
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    return -turn @ np.column_stack((radial, across)) @ turn.T


@pytest.mark.parametrize("row", SOMEYA, ids=lambda row: f"S={row[0]}")
def test_someya_two_grooves(row):
    width = 0.5 * DIAMETER
    load = VISCOSITY * SPEED / (2.0 * math.pi) * width * DIAMETER / row[0] * (0.5 * DIAMETER / CLEARANCE) ** 2
    lands = grooved_bore((0.0, math.pi), math.radians(10.0))
    film = JournalFilm(DIAMETER, width, CLEARANCE, VISCOSITY, SPEED, lands, Cavitation.REYNOLDS)
    lighter, found, heavier = (solve_journal(film, (0.0, -k * load), FINE) for k in (0.999, 1.0, 1.001))
    assert found.eccentricity_ratio == pytest.approx(row[1], abs=1.5e-3)
    assert math.degrees(found.attitude_angle) == pytest.approx(row[2], abs=0.9)
    along = np.array([[0.0, -1.0], [1.0, 0.0]])
    damping = (along @ found.damping @ along.T * CLEARANCE * SPEED / load).ravel()
    np.testing.assert_allclose(damping, [row[5], row[6], row[6], row[7]], rtol=0.10)
    stiffness = turning_stiffness(found, lighter, heavier)
    assert stiffness[0, 1] == pytest.approx(row[3], rel=0.04)
    assert stiffness[1, 0] == pytest.approx(row[4], rel=0.04, abs=0.07)
