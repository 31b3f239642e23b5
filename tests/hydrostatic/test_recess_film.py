"""The film between recesses: closed forms, reciprocity, derivatives, symmetries, convergence."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hydrostatic_bearings import (
    ANNULAR,
    CAPILLARY,
    CIRCULAR,
    CLEARANCE,
    RING,
    RING_FEEDING,
    SPEED,
    down,
    feeding,
    journal,
    journal_film,
    ring_film,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.geometry import RectangularPad
from babbitt.kinds.hydrostatic.impedance import Compressibility, damping_loss, impedance, static_coefficients
from babbitt.kinds.hydrostatic.lines import DRAFT, ENGINEERING, REFERENCE, Grid
from babbitt.kinds.hydrostatic.lumped import centred_stiffness, land_interaction, lumped_at
from babbitt.kinds.hydrostatic.lumps import journal_lumps
from babbitt.kinds.hydrostatic.restrictors import Capillary, ConstantFlow
from babbitt.kinds.hydrostatic.state import state_at
from babbitt.kinds.hydrostatic.supply import FixedPressure, Pump
from babbitt.kinds.hydrostatic.surfaces import FilmOil, journal_surface, pad_surface
from babbitt.reynolds.recess.recess_film import RecessFilm

LOOSE = Grid(48, 4)


@pytest.mark.parametrize("eps", [0.0, 0.5, 0.9])
def test_recess_all_around(eps):
    """Flow of a concentric slot times 1 + 1.5 eps^2, and no force."""
    bearing = journal()
    made = journal_surface(bearing, FilmOil(0.02, 0.0, 5e6), DRAFT)
    recess = np.where(made.mesh.nodes <= 0.7 + 1e-9, 0, np.where(made.mesh.nodes == 1.0, -2, -1))
    recess = np.repeat(recess[None, :], made.recess.shape[0], axis=0)
    surface = made.surface._replace(held=recess != -1)
    ring = replace(made, recess=recess, count=1, core=np.zeros((2, 1)), surface=surface)
    response = RecessFilm.on(ring).evaluate(down(eps), np.array([2e6]))
    flow = math.pi * 0.1 * CLEARANCE**3 * 2e6 / (6.0 * 0.02 * 0.015) * (1.0 + 1.5 * eps**2)
    assert response.outflow[0] == pytest.approx(flow, rel=1e-12)
    assert np.abs(response.force).max() < 1e-9 * 2e6 * 0.01


@pytest.mark.parametrize("shape", [CIRCULAR, ANNULAR])
def test_round_pads_are_their_closed_forms(shape):
    lands = lands_of(shape)
    response = RecessFilm.on(ring_film(shape)(DRAFT)).evaluate(np.zeros(3), np.array([1e6]))
    assert response.outflow[0] / 1e6 == pytest.approx(lands.conductance(50e-6, 0.02), rel=1e-8)
    assert response.force[0] / 1e6 == pytest.approx(lands.effective_area, rel=1e-8)
    assert response.area[0, 0] == pytest.approx(lands.effective_area, rel=1e-8)
    assert response.damping[0, 0] == pytest.approx(lands.squeeze_damping(50e-6, 0.02), rel=1e-6)
    assert response.opening[0, 0] == pytest.approx(3.0 * response.outflow[0] / 50e-6, rel=1e-8)


def rectangle(pad, grid):
    response = RecessFilm.on(pad_surface(pad, 50e-6, FilmOil(0.02, 0.0, 1e6), grid)).evaluate(
        np.zeros(1), np.array([1e6])
    )
    return np.array([12.0 * 0.02 / (50e-6) ** 3 * response.outflow[0] / 1e6, response.force[0] / 1e6 / pad.area])


def extrapolated(pad):
    """Flow and area factors by Richardson: lines of second order, polynomials of high degree across."""
    fine, coarse = (rectangle(pad, Grid(lines, 18)) for lines in (384, 192))
    return fine + (fine - coarse) / 3.0


@pytest.mark.parametrize(("length", "land"), [(2.0, 0.1), (2.0, 0.2), (3.0, 0.25)])
def test_rectangle_with_equal_lands(length, land):
    pad = RectangularPad(0.1 * length, 0.1, 0.1 * (length - 2.0 * land), 0.1 * (1.0 - 2.0 * land))
    lands = lands_of(pad)
    closed = lands.flow_factor, lands.effective_area / pad.area
    assert extrapolated(pad) == pytest.approx(closed, rel=2e-5)
    assert rectangle(pad, REFERENCE) == pytest.approx(closed, rel=1e-4)


TABLE = {  # sides 1:1, 2:1, 3:1
    0.3: (5.6328, 0.37033, 6.7077, 0.34472, 8.3570, 0.31195),
    0.4: (7.5616, 0.45204, 9.1709, 0.43166, 11.6987, 0.40295),
    0.5: (10.2341, 0.53620, 12.5500, 0.52148, 16.2675, 0.49875),
    0.6: (14.2349, 0.62317, 17.5692, 0.61360, 23.0122, 0.59780),
    0.7: (20.9016, 0.71304, 25.9072, 0.70763, 34.1578, 0.69841),
    0.8: (34.2350, 0.80579, 42.5742, 0.80339, 56.3872, 0.79926),
    0.9: (74.2351, 0.90145, 92.5744, 0.90085, 123.054, 0.89982),
}


@pytest.mark.parametrize("ratio", TABLE)
@pytest.mark.parametrize("sides", [1, 2, 3])
def test_rectangles_of_equal_side_ratio(ratio, sides):
    """Prototype in finite volumes, extrapolated; good to about 3e-5."""
    known = TABLE[ratio][2 * sides - 2 : 2 * sides]
    pad = RectangularPad(0.1 * sides, 0.1, 0.1 * sides * ratio, 0.1 * ratio)
    assert rectangle(pad, ENGINEERING) == pytest.approx(known, rel=1e-3)
    assert extrapolated(pad) == pytest.approx(known, rel=1e-4)


def test_conductance_is_symmetric_and_reciprocal():
    film = RecessFilm.on(journal_film(journal(), SPEED)(LOOSE))
    at, p = np.array([0.3, -0.4]) * CLEARANCE, np.array([3e6, 2e6, 1.5e6, 2.5e6])
    response = film.evaluate(at, p)
    assert response.conductance == pytest.approx(response.conductance.T, rel=1e-12)
    off = response.conductance - np.diag(np.diag(response.conductance))
    assert (off <= 0.0).all()
    assert (np.linalg.eigvalsh(response.conductance) > 0.0).all()
    for k in range(4):  # superposition: unit steps of the pressures
        step = np.zeros(4)
        step[k] = 1e3
        other = RecessFilm.on(journal_film(journal(), SPEED)(LOOSE)).evaluate(at, p + step)
        assert (other.outflow - response.outflow) / 1e3 == pytest.approx(
            response.conductance[:, k], rel=1e-6, abs=1e-6 * response.conductance[k, k]
        )
        assert (other.force - response.force) / 1e3 == pytest.approx(response.area[:, k], rel=1e-6, abs=1e-9)


def test_opening_is_the_slope_of_the_flow():
    at, p, step = np.array([0.3, -0.4]) * CLEARANCE, np.array([3e6, 2e6, 1.5e6, 2.5e6]), 1e-10
    film = RecessFilm.on(journal_film(journal(), SPEED)(LOOSE))
    response = film.evaluate(at, p)
    for d in range(2):
        move = np.zeros(2)
        move[d] = step
        change = film.evaluate(at + move, p).outflow - film.evaluate(at - move, p).outflow
        assert change / (2.0 * step) == pytest.approx(response.opening[:, d], rel=1e-5)


@pytest.mark.parametrize("eps", [0.3, 0.75])
def test_stiffness_is_the_slope_of_the_force(eps):
    """Full film, and ruptured film with a standing rupture."""
    build, fed, at, step = journal_film(journal(), SPEED), feeding(), down(eps), 1e-9
    state = state_at(build, fed, at, DRAFT)
    assert (state.dry_share > 0.0) == (eps > 0.5)
    stiffness, _ = static_coefficients(state.response, state.network)
    for d in range(2):
        move = np.zeros(2)
        move[d] = step
        change = state_at(build, fed, at + move, DRAFT).force - state_at(build, fed, at - move, DRAFT).force
        assert -change / (2.0 * step) == pytest.approx(stiffness[:, d], rel=2e-6, abs=1e3)


def test_concentric_bearing_is_isotropic():
    for number in (3, 4, 6):
        bearing, fed = journal(number=number, land=25.0), feeding(number=number)
        state = state_at(journal_film(bearing), fed, np.zeros(2), LOOSE)
        assert np.ptp(state.network.pressures) < 1e-9 * state.network.pressures.max()
        stiffness, damping = static_coefficients(state.response, state.network)
        for matrix in (stiffness, damping):
            assert matrix == pytest.approx(matrix[0, 0] * np.eye(2), abs=2e-9 * matrix[0, 0])


def test_film_at_rest_does_not_rupture_and_has_no_cross_stiffness():
    state = state_at(journal_film(journal()), feeding(), down(0.8), DRAFT)
    assert state.dry_share == 0.0
    stiffness, damping = static_coefficients(state.response, state.network)
    assert abs(stiffness[0, 1]) + abs(stiffness[1, 0]) < 1e-9 * stiffness[1, 1]
    assert damping == pytest.approx(damping.T, abs=1e-9 * damping[1, 1])
    assert (np.linalg.eigvalsh(damping) > 0.0).all()


@pytest.mark.parametrize("eps", [0.4, 0.8])
def test_damping_of_a_turning_journal_is_symmetric_and_positive(eps):
    state = state_at(journal_film(journal(), SPEED), feeding(), down(eps), DRAFT)
    _, damping = static_coefficients(state.response, state.network)
    assert damping == pytest.approx(damping.T, abs=1e-9 * damping[1, 1])
    assert (np.linalg.eigvalsh(damping) > 0.0).all()


def test_pattern_and_load_turn_together():
    turn = math.radians(37.0)
    matrix = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    first = state_at(journal_film(journal(), SPEED), feeding(), down(0.5), DRAFT)
    second = state_at(journal_film(journal(-53.0), SPEED), feeding(), matrix @ down(0.5), DRAFT)
    assert second.force == pytest.approx(matrix @ first.force, rel=1e-8)
    assert second.network.pressures == pytest.approx(first.network.pressures, rel=1e-8)


def test_clockwise_is_the_mirror_image():
    first = state_at(journal_film(journal(), SPEED), feeding(), down(0.7), DRAFT)
    second = state_at(journal_film(journal(), -SPEED), feeding(), down(0.7), DRAFT)
    assert first.dry_share > 0.0
    assert second.force == pytest.approx(first.force * [-1.0, 1.0], rel=1e-7)
    assert second.network.pressures[[0, 3, 2, 1]] == pytest.approx(first.network.pressures, rel=1e-7)


@settings(max_examples=12)
@given(
    plane=st.floats(0.3, 3.0), gap=st.floats(0.3, 3.0), pressure=st.floats(0.3, 3.0), viscosity=st.floats(0.3, 3.0)
)
def test_scaling(plane, gap, pressure, viscosity):
    """Force as pressure times area, flow as pressure times gap^3 over viscosity, at equal speed number."""
    first = state_at(journal_film(journal(), SPEED), feeding(), down(0.6), LOOSE)
    own = journal()
    big = replace(own, diameter=own.diameter * plane, width=own.width * plane, clearance=own.clearance * gap,
                  recess_length=own.recess_length * plane)  # fmt: skip
    speed = SPEED * pressure * gap**2 / (viscosity * plane**2)
    tube = Capillary(CAPILLARY.diameter * gap**0.75, CAPILLARY.length, 0.02 * viscosity)
    oil = FilmOil(0.02 * viscosity, speed, 5e6 * pressure)
    second = state_at(
        lambda grid: journal_surface(big, oil, grid), feeding(tube, supply=FixedPressure(5e6 * pressure)),
        down(0.6) * gap, LOOSE,
    )  # fmt: skip
    assert second.force == pytest.approx(first.force * pressure * plane**2, rel=1e-7)
    assert second.network.flows == pytest.approx(first.network.flows * pressure * gap**3 / viscosity, rel=1e-7)
    assert second.mass_balance_error < 1e-9


@settings(max_examples=15)
@given(eps=st.floats(0.0, 0.85), angle=st.floats(0.0, 6.28), speed=st.floats(-2.0, 2.0))
def test_oil_balances_wherever_the_journal_stands(eps, angle, speed):
    at = eps * CLEARANCE * np.array([math.cos(angle), math.sin(angle)])
    state = state_at(journal_film(journal(), speed * SPEED), feeding(), at, LOOSE)
    assert state.solved
    assert state.mass_balance_error < 1e-9
    edges = state.film.work.row[state.film.of.recess == -2].sum() * state.film.of.scales.flow
    lost = (
        state.film.work.row[(state.film.of.recess == -1) & ~state.film.work.wet].sum() * state.film.of.scales.flow
    )
    assert -edges == pytest.approx(state.network.flows.sum() + lost, rel=1e-7)


def test_lower_cavitation_pressure_changes_a_ruptured_film_only():
    for eps, changes in ((0.3, False), (0.8, True)):
        forces = []
        for pressure in (0.0, -0.09e6):
            oil = FilmOil(0.02, SPEED, 5e6, pressure)
            state = state_at(
                lambda grid, oil=oil: journal_surface(journal(), oil, grid), feeding(), down(eps), LOOSE
            )
            forces.append(state.force)
            assert state.film.pressures().min() >= pressure - 1.0
        assert (np.abs(forces[1] - forces[0]).max() > 1.0) == changes


def test_wide_restrictors_hold_the_supply_pressure():
    huge = Capillary(100e-3, 0.1, 0.02)
    state = state_at(journal_film(journal()), feeding(huge), down(0.5), LOOSE)
    assert state.network.pressures == pytest.approx(np.full(4, 5e6), rel=1e-4)
    stiffness, _ = static_coefficients(state.response, state.network)
    own = state.response.stiffness
    assert stiffness == pytest.approx(own, rel=1e-3, abs=1e-4 * np.abs(own).max())


def test_capillary_with_endless_supply_is_a_pump():
    flow = 1.25e-5
    tight = Capillary(0.8e-3, 1e4, 0.02)
    high = flow / tight.conductance
    by_pump = state_at(journal_film(journal()), feeding(ConstantFlow(flow)), down(0.4), LOOSE)
    by_tube = state_at(journal_film(journal()), feeding(tight, supply=FixedPressure(high)), down(0.4), LOOSE)
    assert by_tube.force[1] == pytest.approx(by_pump.force[1], rel=1e-3)


def test_manifold_volume_is_slow_supply():
    """A huge manifold behind a pump acts as a fixed supply pressure on fast motion, and not on slow motion."""
    fed = feeding(supply=Pump(5e-5, 1e-12))
    state = state_at(journal_film(journal()), fed, down(0.5), LOOSE)
    fixed = state_at(
        journal_film(journal()), feeding(supply=FixedPressure(state.network.supply_pressure)), down(0.5), LOOSE
    )
    for volume, same in ((1e3, True), (0.0, False)):
        oil = Compressibility(0.0, 1e9, volume)
        found = impedance(state.response, state.network, oil, 100.0)[0][1, 1]
        wanted = impedance(fixed.response, fixed.network, oil, 100.0)[0][1, 1]
        assert (abs(found / wanted - 1.0) < 1e-6) == same


@pytest.mark.parametrize("hertz", [1e-3, 0.1])
def test_slow_motion_is_the_limit(hertz):
    state = state_at(journal_film(journal(), SPEED), feeding(), down(0.4), LOOSE)
    oil = Compressibility(3.7e-6, 1e9)
    slow, limit = (impedance(state.response, state.network, oil, f) for f in (2.0 * math.pi * hertz, 0.0))
    assert slow[0] == pytest.approx(limit[0], rel=1e-5, abs=1e3)
    assert slow[1] == pytest.approx(limit[1], rel=1e-5, abs=1e2)


def test_film_converges_with_second_order():
    errors = []
    for lines in (96, 192, 384):
        state = state_at(journal_film(journal()), feeding(), down(0.5), Grid(lines, 12))
        errors.append(abs(state.network.flows.sum() / 5.0479e-5 - 1.0))
    assert errors[0] > 2.8 * errors[1]
    assert errors[1] > 2.8 * errors[2]


def test_lumped_lands_meet_their_closed_form():
    bearing = journal()
    lumps, fed = journal_lumps(bearing, 0.02, 0.0), feeding()
    centred = lumped_at(lumps, fed, np.zeros(2))
    beta = centred.network.pressures[0] / 5e6
    assert (beta, land_interaction(bearing)) == pytest.approx((0.4796003331, 0.6200856439), rel=1e-9)
    assert centred_stiffness(bearing, 5e6, beta) == pytest.approx(6.1264365e8, rel=1e-7)
    assert static_coefficients(centred.response, centred.network)[0][1, 1] == pytest.approx(6.1264365e8, rel=1e-7)
    for first in (-90.0, -45.0, -70.0):
        own = lumped_at(journal_lumps(journal(first), 0.02, 0.0), fed, down(1e-4))
        assert own.response.force[1] / (1e-4 * CLEARANCE) == pytest.approx(6.1264365e8, rel=1e-7)


@pytest.mark.parametrize(
    ("first", "eps", "load", "flow"),
    [(-90.0, 0.5, 15224.448, 5.2813842e-5), (-45.0, 0.5, 14013.363, 5.2914721e-5), (-90.0, 0.7, 20313.219, None),
     (-45.0, 0.7, 18146.050, None)],
)  # fmt: skip
def test_lumped_lands_of_the_prototype(first, eps, load, flow):
    state = lumped_at(journal_lumps(journal(first), 0.02, 0.0), feeding(), down(eps))
    assert state.response.force[1] == pytest.approx(load, rel=1e-6)
    assert flow is None or state.network.flows.sum() == pytest.approx(flow, rel=1e-6)


def test_interaction_softens_and_compressible_oil_undamps():
    bearings = [journal(land=land) for land in (60.0, 45.0, 30.0, 15.0, 8.0)]
    assert (np.diff([land_interaction(bearing) for bearing in bearings]) > 0.0).all()
    assert (np.diff([centred_stiffness(bearing, 5e6, 0.5) for bearing in bearings]) < 0.0).all()
    state = state_at(journal_film(journal(), SPEED), feeding(), down(0.4), LOOSE)
    volumes = (0.0, 1e-6, 3e-6, 1e-5, 1e-4)
    losses = [damping_loss(state.response, state.network, Compressibility(volume, 1e9)) for volume in volumes]
    assert losses[0] == 0.0
    assert (np.diff(losses) > 0.0).all()


def test_level_ring_forgets_the_speed():
    """At zero tilt the surface drags no oil into or out of the film."""
    states = [state_at(ring_film(RING, speed=s), RING_FEEDING, np.zeros(3), LOOSE) for s in (0.0, 100.0)]
    assert states[0].force == pytest.approx(states[1].force, rel=1e-9, abs=1e-9)
    stiffness, _ = static_coefficients(states[1].response, states[1].network)
    assert stiffness[1, 2] == pytest.approx(-stiffness[2, 1], rel=1e-6)
    assert stiffness[1, 2] > 0.0


def test_accuracies_are_ordered():
    assert DRAFT.per_turn < ENGINEERING.per_turn < REFERENCE.per_turn
