"""What a review found: coefficients at a velocity, torques, flows drawn in, films that leave their place."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Resolution, grooved_bore
from babbitt.reynolds.oil.piezoviscosity import Barus
from babbitt.reynolds.stability.routh import critical_mass

FILM = JournalFilm(0.1, 0.05, 50e-6, 0.02, 314.0, grooved_bore((0.0, math.pi), math.radians(20.0)))
SURFACE = replace(FILM, axial_viscosity=(1.0, 1.0))
PLACE, MOVING = (1e-5, -2.8e-5), (2e-3, 1e-3)
RING = JournalFilm(0.1, 0.05, 50e-6, 0.02, 314.0, (Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC,
                   cavitation=Cavitation.HALF_SOMMERFELD)  # fmt: skip


@pytest.mark.parametrize("film", [FILM, SURFACE], ids=["lands", "surface"])
def test_coefficients_of_a_moving_journal_are_near_those_of_a_fine_grid(film):
    fine = film_at_position(film, PLACE, MOVING, Resolution(6, 384, 48))
    usual = film_at_position(film, PLACE, MOVING)
    for name in ("stiffness", "damping"):
        coarse, reference = getattr(usual, name), getattr(fine, name)
        assert np.abs(coarse - reference).max() < 0.006 * np.abs(reference).max()


def test_torques_of_a_half_sommerfeld_film_differ_by_the_moment_of_its_force():
    found = film_at_position(RING, (3e-5, 0.0))
    moment = 3e-5 * found.force[1]
    assert found.friction_torque - found.bearing_torque == pytest.approx(abs(moment), rel=1e-9)
    assert abs(moment) > 0.01 * found.friction_torque


def test_half_sommerfeld_equilibrium_carries_the_load():
    found = solve_journal(RING, (0.0, -5e3))
    assert found.force == pytest.approx((0.0, 5e3), abs=2e-3 * 5e3)


def test_streamers_of_a_piezoviscous_film_are_sheared_at_ambient_viscosity():
    """The torque of the shear is between that of the films of constant viscosity at least and most."""
    soft = replace(SURFACE, pressure_viscosity=Barus(1e-12))
    plain, thick = (film_at_position(film, PLACE) for film in (SURFACE, soft))
    assert thick.friction_torque == pytest.approx(plain.friction_torque, rel=1e-5)
    stiff = film_at_position(replace(SURFACE, pressure_viscosity=Barus(2e-8)), (1.2e-5, -4.2e-5))
    bare = film_at_position(SURFACE, (1.2e-5, -4.2e-5))
    void = stiff.void[0, :, 0] > 0.0
    assert void.any()
    # at one place both films void alike where they are ruptured: more torque comes from the full film alone
    assert stiff.friction_torque > bare.friction_torque


@pytest.mark.parametrize("film", [FILM, SURFACE], ids=["lands", "surface"])
def test_sides_above_cavitation_draw_in_and_what_leaves_is_not_netted(film):
    flooded = film_at_position(replace(film, cavitation_pressure=-1e5), PLACE)
    assert flooded.side_inflow > 0.1 * flooded.leaving_flow
    net = flooded.end_flows.sum()
    assert flooded.leaving_flow == pytest.approx(net + flooded.side_inflow, rel=1e-12)
    assert flooded.supply_flow.sum() == pytest.approx(net, rel=1e-9)
    assert film_at_position(film, PLACE).side_inflow == pytest.approx(0.0, abs=1e-12)


def test_oil_from_nowhere_is_counted_alike_by_both_engines():
    errors = [
        film_at_position(replace(film, cavitation=Cavitation.REYNOLDS), PLACE).mass_balance_error
        for film in (FILM, SURFACE)
    ]
    assert errors[1] == pytest.approx(errors[0], rel=0.25)
    assert errors[0] > 0.05


def test_a_journal_that_leaves_its_place_has_no_critical_mass():
    damping = np.diag([1e5, 2e5])
    assert critical_mass(np.diag([1e8, -1e8]), damping) == 0.0
    assert critical_mass(-1e8 * np.eye(2), damping) == 0.0
    assert critical_mass(np.diag([1e8, 2e8]), damping) == math.inf


def test_a_start_at_the_widest_gap_is_for_plain_bearings():
    with pytest.raises(InputError, match="plain bearings"):
        replace(FILM, lands=(Land(0.0, 2.0 * math.pi),), cavitation=Cavitation.REYNOLDS,
                film_start=FilmStart.WIDEST_GAP, axial_viscosity=(1.0, 1.0))  # fmt: skip
