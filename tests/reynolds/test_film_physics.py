"""What every film must obey: closed forms, orders, symmetries, balances, consistent derivatives."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.reynolds._structs import LAND_COLUMNS, Bearing
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.lands._equilibrium import evaluate
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._grids import new_film, new_grid, new_lines, uniform_lines
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import (
    ENGINEERING,
    Cavitation,
    FilmStart,
    JournalFilm,
    Land,
    Pocket,
    Resolution,
    grooved_bore,
)

RADIUS, CLEARANCE, VISCOSITY, SPEED = 0.05, 1e-4, 0.02, 200.0
RING = (Land(0.0, 2.0 * math.pi),)
TWO = grooved_bore((0.0, math.pi), 0.3)
UNIT = VISCOSITY * SPEED * (RADIUS / CLEARANCE) ** 2
CONDITIONS = [Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS]
EXACT = Resolution(5, 96, 24, 1e-12)


def bearing(width_ratio=0.8, lands=TWO, cavitation=Cavitation.REYNOLDS, **more):
    return JournalFilm(
        2 * RADIUS, 2 * RADIUS * width_ratio, CLEARANCE, VISCOSITY, SPEED, lands, cavitation, **more
    )


def full_ring(width_ratio):
    return bearing(width_ratio, RING, film_start=FilmStart.PERIODIC, cavitation_pressure=-1e12)


@pytest.mark.parametrize("eps", [0.5, 0.7, 0.9])
def test_long_full_film_is_sommerfelds(eps):
    """Mid-plane pressure up to a constant; t runs from the widest gap."""
    found = film_at_position(full_ring(1e3), (eps * CLEARANCE, 0.0), resolution=Resolution(4, 192))
    t = found.angles[0] - math.pi
    closed = 6 * eps * np.sin(t) * (2 + eps * np.cos(t)) / ((2 + eps**2) * (1 + eps * np.cos(t)) ** 2) * UNIT
    pressure = found.pressure[0, :, 0]
    difference = (pressure - pressure[0]) - (closed - closed[0])
    assert np.abs(difference).max() < 2e-3 * np.abs(closed).max()


@pytest.mark.parametrize("eps", [0.1, 0.5, 0.8])
def test_short_full_film_is_ocvirks(eps):
    ratio = 0.02
    found = film_at_position(full_ring(ratio), (eps * CLEARANCE, 0.0), resolution=Resolution(4, 192))
    closed = math.pi * eps / (2.0 * (1.0 - eps**2) ** 1.5) * (2.0 * ratio) ** 2 * UNIT * RADIUS * found.film.width
    assert found.force[1] == pytest.approx(closed, rel=2e-3)


def test_second_order_in_the_lines():
    at = (0.5 * CLEARANCE, -0.2 * CLEARANCE)
    loads = [film_at_position(bearing(), at, resolution=Resolution(6, n, 24)).force for n in (96, 192, 384, 1536)]
    errors = [np.linalg.norm(load - loads[-1]) for load in loads[:3]]
    assert errors[0] / errors[2] > 10.0
    assert errors[2] < 1e-4 * np.linalg.norm(loads[-1])


def test_spectral_in_the_width():
    at = (0.5 * CLEARANCE, -0.2 * CLEARANCE)
    coarse, fine = (film_at_position(bearing(), at, resolution=Resolution(m, 96)).load for m in (4, 10))
    assert coarse == pytest.approx(fine, rel=3e-4)


@pytest.mark.parametrize("cavitation", CONDITIONS)
@pytest.mark.parametrize("turn", [0.3, 2.7])
def test_turning_the_bearing_turns_everything(cavitation, turn):
    rotation = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    turned = tuple(replace(p, start_angle=p.start_angle + turn, end_angle=p.end_angle + turn) for p in TWO)
    load = np.array([500.0, -4000.0])
    one = solve_journal(bearing(cavitation=cavitation), tuple(load))
    two = solve_journal(bearing(lands=turned, cavitation=cavitation), tuple(rotation @ load))
    assert one.outcome.solved
    np.testing.assert_allclose(two.position, rotation @ one.position, rtol=1e-6)
    np.testing.assert_allclose(two.stiffness, rotation @ one.stiffness @ rotation.T, rtol=1e-6, atol=1.0)


@pytest.mark.parametrize("cavitation", CONDITIONS)
def test_reversal_mirrors(cavitation):
    forward = solve_journal(bearing(cavitation=cavitation), (300.0, -4000.0))
    backward = solve_journal(replace(bearing(cavitation=cavitation), angular_speed=-SPEED), (-300.0, -4000.0))
    # the mirror x -> -x of two symmetric grooves; the engine mirrors y, so this is not its own image
    np.testing.assert_allclose(backward.position, forward.position * [-1.0, 1.0], rtol=1e-6)
    assert backward.attitude_angle == pytest.approx(forward.attitude_angle, rel=1e-6)


@pytest.mark.parametrize("pressure", [0.0, 2e5])
def test_mass_is_conserved(pressure):
    lands = grooved_bore((0.0, math.pi), 0.3, pressure)
    found = solve_journal(bearing(lands=lands, cavitation=Cavitation.MASS_CONSERVING), (0.0, -4000.0))
    assert found.outcome.solved
    assert found.mass_balance_error < 1e-10
    pocketed = bearing(
        lands=RING, cavitation=Cavitation.MASS_CONSERVING, film_start=FilmStart.PERIODIC,
        pockets=(Pocket(0.5 * math.pi, 0.4, 0.04, 0.0, 1e5 + pressure),),
    )  # fmt: skip
    ringed = solve_journal(pocketed, (0.0, -4000.0))
    assert ringed.outcome.solved
    assert ringed.mass_balance_error < 1e-10
    assert ringed.supply_flow.sum() == pytest.approx(ringed.side_flow.sum(), rel=1e-9)


def central_stiffness(model, at, resolution, step=1e-5):
    columns = []
    for axis in range(2):
        shift = np.zeros(2)
        shift[axis] = step * CLEARANCE
        ahead = film_at_position(model, tuple(at + shift), resolution=resolution).force
        behind = film_at_position(model, tuple(at - shift), resolution=resolution).force
        columns.append(-(ahead - behind) / (2.0 * step * CLEARANCE))
    return np.array(columns).T


def test_stiffness_is_the_derivative_of_a_smooth_film():
    """On one fixed grid, all wet: only round-off and the third derivative stand between adjoint and difference."""
    axial = kernel_operator(5)
    lands = np.zeros((2, LAND_COLUMNS))
    lands[:, :3] = [[0.1, 3.0, 1.0], [3.3, 6.2, 1.0]]
    bearing = Bearing(lands, np.zeros((2, 0)), 0.1, 1.0, 100.0, False, False, 1.0)
    grid, film, lines = new_grid(2, 96, 5), new_film(96), new_lines(96, 5)
    uniform_lines(bearing, grid)

    def result_at(x, y):
        result = np.zeros(RESULT_SIZE)
        assert evaluate(axial, bearing, grid, film, lines, x, y, 0.0, 0.0, False, result) == 0
        return result

    at, step = (0.4, -0.3), 1e-4
    found = result_at(*at)[2:6].reshape(2, 2)
    for axis, shift in enumerate(((step, 0.0), (0.0, step))):
        ahead, behind = (
            result_at(at[0] + shift[0], at[1] + shift[1]),
            result_at(at[0] - shift[0], at[1] - shift[1]),
        )
        np.testing.assert_allclose(
            -(ahead[:2] - behind[:2]) / (2.0 * step), found[:, axis], atol=1e-6 * abs(found).max()
        )


@pytest.mark.parametrize("cavitation", CONDITIONS)
def test_stiffness_across_a_moving_rupture(cavitation):
    at = np.array([0.4, -0.35]) * CLEARANCE
    model = bearing(cavitation=cavitation)
    found = film_at_position(model, tuple(at), resolution=Resolution(6, 192))
    reference = central_stiffness(model, at, Resolution(6, 384), step=1e-2)
    np.testing.assert_allclose(found.stiffness, reference, atol=4e-3 * abs(reference).max())


def test_damping_is_the_derivative_in_velocity():
    at, model = np.array([0.4, -0.35]) * CLEARANCE, bearing(cavitation_pressure=-1e12)
    found = film_at_position(model, tuple(at), resolution=ENGINEERING)
    for axis in range(2):
        speed = np.zeros(2)
        speed[axis] = 1e-3
        moved = film_at_position(model, tuple(at), tuple(speed), ENGINEERING)
        np.testing.assert_allclose(
            -(moved.force - found.force) / 1e-3, found.damping[:, axis], atol=1e-9 * abs(found.damping).max()
        )


def test_squeeze_and_rotation_superpose_in_a_full_film():
    at, model = (0.3 * CLEARANCE, 0.2 * CLEARANCE), full_ring(0.8)
    both = film_at_position(model, at, (1e-3, -2e-3)).force
    turning = film_at_position(model, at).force
    squeezed = film_at_position(replace(model, angular_speed=0.0), at, (1e-3, -2e-3)).force
    np.testing.assert_allclose(both, turning + squeezed, rtol=1e-6)


def test_long_full_film_squeezed():
    """p = 6 mu V R^2/c^3 (1/(eps h^2) + const) from dp/dt ~ sin t / h^3, h = 1 + eps cos t (along -y)."""
    eps, velocity = 0.5, 1e-3
    model = replace(full_ring(1e3), angular_speed=0.0)
    found = film_at_position(model, (0.0, -eps * CLEARANCE), (0.0, -velocity), Resolution(4, 192))
    gap = 1.0 + eps * np.sin(found.angles[0])
    closed = 6.0 * VISCOSITY * velocity * RADIUS**2 / CLEARANCE**3 / (eps * gap**2)
    pressure = found.pressure[0, :, 0]
    difference = (pressure - pressure[0]) - (closed - closed[0])
    assert np.abs(difference).max() < 2e-3 * np.ptp(closed)


def test_grooves_of_zero_width_change_nothing_where_the_film_is_ruptured():
    load = (0.0, -4000.0)
    one = solve_journal(bearing(lands=(Land(0.5 * math.pi, 2.5 * math.pi),)), load, Resolution(5, 192))
    extra = (Land(0.5 * math.pi, 0.7 * math.pi), Land(0.7 * math.pi, 2.5 * math.pi))
    two = solve_journal(bearing(lands=extra), load, Resolution(5, 192))
    assert two.eccentricity_ratio == pytest.approx(one.eccentricity_ratio, rel=1e-3)


def test_line_and_surface_kernels_agree():
    for cavitation in CONDITIONS:
        model = bearing(cavitation=cavitation)
        lines = solve_journal(model, (300.0, -4000.0))
        surface = solve_journal(replace(model, axial_viscosity=(1.0, 1.0)), (300.0, -4000.0))
        assert surface.eccentricity_ratio == pytest.approx(lines.eccentricity_ratio, rel=2e-4)
        np.testing.assert_allclose(surface.stiffness, lines.stiffness, atol=3e-3 * abs(lines.stiffness).max())
        np.testing.assert_allclose(surface.damping, lines.damping, atol=5e-3 * abs(lines.damping).max())


def test_a_full_pocket_ring_row_is_a_groove():
    """A pocket as wide as the bearing but for the side edges is a groove."""
    pockets = tuple(Pocket(angle, 0.3, 0.08 * (1 - 1e-9)) for angle in (0.0, math.pi))
    model = bearing(lands=RING, film_start=FilmStart.PERIODIC, pockets=pockets)
    grooved = solve_journal(bearing(), (0.0, -4000.0))
    pocketed = solve_journal(model, (0.0, -4000.0))
    assert pocketed.eccentricity_ratio == pytest.approx(grooved.eccentricity_ratio, rel=1e-3)


def test_torques_balance_the_couple_of_the_load():
    found = solve_journal(bearing(cavitation=Cavitation.MASS_CONSERVING), (0.0, -4000.0), Resolution(5, 192))
    couple = found.load * math.hypot(*found.position) * math.sin(found.attitude_angle)
    assert found.friction_torque - found.bearing_torque == pytest.approx(couple, rel=2e-3)


def test_an_unloaded_journal_rests_in_the_middle():
    found = solve_journal(bearing(), (0.0, 0.0))
    assert found.outcome.solved
    assert found.eccentricity_ratio < 1e-8
