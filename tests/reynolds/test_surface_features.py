"""Steps, crowning, displacement, side pressures and open grooves under pressure: closed forms and symmetries."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import (
    DRAFT,
    ENGINEERING,
    Cavitation,
    FilmStart,
    JournalFilm,
    Land,
    Pocket,
    Resolution,
    Step,
    grooved_bore,
)

DIAMETER, WIDTH, CLEARANCE, VISCOSITY, SPEED = 0.1, 0.08, 1e-4, 0.02, 200.0
TURN = 2.0 * math.pi
RING = (Land(0.0, TURN),)
TWO = grooved_bore((0.0, math.pi), 0.3)
AT = np.array([3e-5, -5e-5])
ROWS = 24


def bearing(lands=TWO, width=WIDTH, **more):
    return JournalFilm(DIAMETER, width, CLEARANCE, VISCOSITY, SPEED, lands, **more)


def closed_ring(width=WIDTH, **more):
    given = {"cavitation": Cavitation.REYNOLDS, "film_start": FilmStart.PERIODIC}
    return bearing(RING, width, **(given | more))


def waves(turn=0.0, sense=1.0, flip=1.0):
    """A displacement of both angle and width, of the bearing turned or seen in a mirror."""
    angles = sense * (np.arange(ROWS) * TURN / ROWS) - turn
    z = flip * np.linspace(-1.0, 1.0, 5)
    return tuple(tuple(row) for row in 1e-5 * (1.5 + np.cos(2 * angles + 0.4)[:, None] * (1.0 + 0.3 * z)))


def featured(turn=0.0, mirror=False, flip=1.0):
    """A bearing with every feature, turned by an angle, or in the mirror x -> -x, or with its sides exchanged."""
    sense = -1.0 if mirror else 1.0

    def at(angle):
        return (math.pi - angle if mirror else angle) + turn

    def land(start, end, centre, first, last):
        x, y = sense * centre[0], centre[1]
        c, s = math.cos(turn), math.sin(turn)
        ends, edges = (at(start), at(end)), (first, last)
        if mirror:
            ends, edges = ends[::-1], edges[::-1]
        return Land(*ends, 1.1 * CLEARANCE, (c * x - s * y, s * x + c * y), *edges)

    lean = np.array([sense * 1e-4, -2e-4])
    lean = flip * np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]]) @ lean
    field = (
        waves(turn, 1.0, flip)
        if not mirror
        else tuple(waves(0.0, 1.0, flip)[(ROWS // 2 - k) % ROWS] for k in range(ROWS))
    )
    return bearing(
        (land(0.1, 2.9, (1e-5, -5e-6), 1e5, 2e5), land(3.2, 6.2, (-5e-6, 8e-6), 2e5, 1e5)),
        pockets=(Pocket(at(1.2), 0.3, 0.02, flip * 0.01, 3e5),),
        steps=(Step(at(4.0), 1.0, 0.03, 6e-5, flip * -0.012), Step(at(2.2), 0.5, WIDTH, 2e-5)),
        misalignment=tuple(lean), displacement=field, crowning=(1e-5, 2e-6, 0.0, 2e-6, 6e-6)[:: int(flip)],
        side_pressures=(2e4, 5e4)[:: int(flip)],
    )  # fmt: skip


def derivative(model, at, step, resolution):
    """Central differences of the force over x and y."""
    columns = []
    for axis in range(2):
        shift = np.zeros(2)
        shift[axis] = step * CLEARANCE
        ahead, behind = (film_at_position(model, tuple(at + s * shift), resolution=resolution) for s in (1, -1))
        columns.append(-(ahead.force - behind.force) / (2.0 * step * CLEARANCE))
    return np.array(columns).T


@pytest.mark.parametrize("depth", [3e-5, 8.66e-5, 2e-4])
def test_infinitely_wide_step_is_rayleighs(depth):
    """p = 6 mu U (h1 - h2) / (h1^3/L1 + h2^3/L2) at the step."""
    lands = (Land(0.0, 2.0), Land(2.1, TURN - 0.1))
    model = bearing(lands, width=50.0, steps=(Step(0.7, 1.4, 50.0, depth),))
    found = film_at_position(model, (0.0, 0.0), resolution=Resolution(3, 64))
    deep, entry, exit_ = CLEARANCE + depth, 1.4 * 0.5 * DIAMETER, 0.6 * 0.5 * DIAMETER
    speed = SPEED * 0.5 * DIAMETER
    closed = 6.0 * VISCOSITY * speed * depth / (deep**3 / entry + CLEARANCE**3 / exit_)
    assert found.maximum_pressure == pytest.approx(closed, rel=1e-4)
    line = found.pressure[0, :, 0]
    at = np.mod(found.angles[0], TURN)
    inside = at < 2.0
    tent = closed * np.where(at < 1.4, at / 1.4, (2.0 - at) / 0.6)
    np.testing.assert_allclose(line[inside], tent[inside], atol=1e-3 * closed)


def test_pressure_dam_pushes_its_land():
    """The dam between its end lands, infinitely wide but for them: pressure where the relief ends, zero before."""
    dam = Step(math.pi / 4 + math.radians(10), math.radians(100), 0.06, 1.5e-4)
    one = film_at_position(bearing(steps=(dam,)), (0.0, 0.0))
    none = film_at_position(bearing(), (0.0, 0.0))
    assert none.load == pytest.approx(0.0, abs=1e-3 * one.load)
    angle = math.atan2(-one.force[1], -one.force[0])  # from where the pressure comes
    assert math.degrees(angle) == pytest.approx(105.0, abs=15.0)  # the dam ends there, the journal arriving at it
    peak = np.unravel_index(one.pressure[0].argmax(), one.pressure[0].shape)
    assert math.degrees(one.angles[0, peak[0]]) % 360 == pytest.approx(105.0, abs=0.1)


@pytest.mark.parametrize("sides", [(0.0, 3e5), (2e5, 0.0)])
def test_flow_through_an_annulus(sides):
    model = closed_ring(side_pressures=sides)
    found = film_at_position(model, (0.0, 0.0))
    flow = math.pi * DIAMETER * CLEARANCE**3 * (sides[0] - sides[1]) / (12.0 * VISCOSITY * WIDTH)
    np.testing.assert_allclose(found.end_flows, [-flow, flow], rtol=1e-9)
    middle = np.interp(0.0, found.axial_positions, found.pressure[0, 5])
    assert middle == pytest.approx(0.5 * sum(sides), rel=1e-9)


def test_a_groove_around_the_middle_makes_two_bearings():
    wide, groove, pressure = 0.08, 0.008, 2e5
    whole = closed_ring(wide, pockets=(Pocket(0.0, TURN, groove, 0.0, pressure),))
    half = closed_ring(0.5 * (wide - groove), side_pressures=(pressure, 0.0))
    one, two = (film_at_position(model, tuple(AT), resolution=Resolution(6, 96)) for model in (whole, half))
    np.testing.assert_allclose(one.force, 2.0 * two.force, rtol=5e-4)
    np.testing.assert_allclose(one.stiffness, 2.0 * two.stiffness, atol=6e-3 * abs(one.stiffness).max())
    full = (replace(model, cavitation_pressure=-1e9) for model in (whole, half))
    one, two = (film_at_position(model, tuple(AT), resolution=Resolution(6, 96)) for model in full)
    assert one.end_flows[1] == pytest.approx(two.end_flows[1], rel=1e-3)
    assert one.supply_flow[0] == pytest.approx(-2.0 * two.end_flows[0], rel=1e-3)


@pytest.mark.parametrize("cavitation", [Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS])
def test_nothing_added_changes_nothing(cavitation):
    plain = bearing(cavitation=cavitation)
    line = film_at_position(plain, tuple(AT), resolution=Resolution(5, 192))
    for more in (
        {"displacement": ((0.0,) * 3,) * 4},
        {"crowning": (0.0, 0.0, 0.0)},
        {"steps": (Step(4.0, 1.0, 0.04, 0.0),)},
    ):
        found = film_at_position(replace(plain, **more), tuple(AT), resolution=Resolution(5, 192))
        np.testing.assert_allclose(found.force, line.force, rtol=1e-3)
        np.testing.assert_allclose(found.stiffness, line.stiffness, atol=5e-3 * abs(line.stiffness).max())
        np.testing.assert_allclose(found.supply_flow, line.supply_flow, atol=2e-3 * line.inflow.max())
        np.testing.assert_allclose(found.outflow, line.outflow, rtol=2e-3)


def test_the_mirror_image_turns_the_other_way():
    one = film_at_position(featured(), tuple(AT))
    two = film_at_position(replace(featured(mirror=True), angular_speed=-SPEED), tuple(AT * [-1.0, 1.0]))
    mirror = np.diag([-1.0, 1.0])
    assert one.outcome.solved
    np.testing.assert_allclose(two.force, mirror @ one.force, rtol=1e-4)
    np.testing.assert_allclose(
        two.stiffness, mirror @ one.stiffness @ mirror, atol=1e-3 * abs(one.stiffness).max()
    )
    np.testing.assert_allclose(two.damping, mirror @ one.damping @ mirror, atol=1e-3 * abs(one.damping).max())
    np.testing.assert_allclose(two.end_flows, one.end_flows, rtol=1e-4)
    np.testing.assert_allclose(two.supply_flow, one.supply_flow[[1, 0, 2]], rtol=1e-4)


@pytest.mark.parametrize("quarter", [1, 2])
def test_turning_the_bearing_turns_everything(quarter):
    turn = quarter * math.pi / 2.0
    rotation = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    one = film_at_position(featured(), tuple(AT))
    two = film_at_position(featured(turn=turn), tuple(rotation @ AT))
    np.testing.assert_allclose(two.force, rotation @ one.force, rtol=1e-4)
    np.testing.assert_allclose(
        two.stiffness, rotation @ one.stiffness @ rotation.T, atol=1e-3 * abs(one.stiffness).max()
    )
    assert two.supply_flow.sum() == pytest.approx(one.supply_flow.sum(), rel=1e-4)


def test_exchanging_the_sides_exchanges_their_flows():
    one, two = (film_at_position(featured(flip=flip), tuple(AT)) for flip in (1.0, -1.0))
    np.testing.assert_allclose(two.force, one.force, rtol=1e-9)
    np.testing.assert_allclose(two.end_flows, one.end_flows[::-1], rtol=1e-9)


def test_every_supply_and_side_is_in_the_balance():
    for speed in (SPEED, -SPEED):
        found = film_at_position(replace(featured(), angular_speed=speed), tuple(AT))
        assert found.mass_balance_error < 1e-10
        assert found.supply_flow.shape == (3,)
        assert found.supply_flow.sum() == pytest.approx(found.end_flows.sum(), rel=1e-9)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_both_engines_give_each_groove_its_flow(sense):
    lands = (Land(2.3, 4.4), Land(0.2, 2.0), Land(4.4, 6.2))
    plain = replace(bearing(lands), angular_speed=sense * SPEED)
    line = film_at_position(plain, tuple(AT), resolution=Resolution(5, 96))
    askew = film_at_position(replace(plain, misalignment=(1e-12, 0.0)), tuple(AT), resolution=Resolution(5, 96))
    np.testing.assert_allclose(askew.supply_flow, line.supply_flow, rtol=5e-3)
    np.testing.assert_allclose(askew.inflow, line.inflow, rtol=2e-3)
    np.testing.assert_allclose(askew.outflow, line.outflow, rtol=2e-3)
    np.testing.assert_allclose(askew.end_flows, line.end_flows, rtol=5e-3)
    # the groove between the lands that meet at 4.4 rad comes second: behind the land that starts at 2.3
    gives = line.inflow[2] - line.outflow[0] if sense > 0.0 else line.inflow[0] - line.outflow[2]
    assert line.supply_flow[1] == pytest.approx(gives, rel=1e-12)


def test_stiffness_of_a_full_film_with_every_feature():
    model = replace(featured(), cavitation=Cavitation.REYNOLDS, cavitation_pressure=-1e9)
    found = film_at_position(model, tuple(AT), resolution=ENGINEERING)
    reference = derivative(model, AT, 1e-3, ENGINEERING)
    np.testing.assert_allclose(found.stiffness, reference, atol=3e-4 * abs(reference).max())
    for axis in range(2):
        rate = np.zeros(2)
        rate[axis] = 1e-3
        moved = film_at_position(model, tuple(AT), tuple(rate), ENGINEERING)
        np.testing.assert_allclose(
            -(moved.force - found.force) / 1e-3, found.damping[:, axis], atol=1e-8 * abs(found.damping).max()
        )


@pytest.mark.parametrize("cavitation", [Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS])
def test_stiffness_across_a_moving_rupture(cavitation):
    model = replace(featured(), cavitation=cavitation, side_pressures=(0.0, 0.0))
    fine = Resolution(4, 192)
    found = film_at_position(model, tuple(AT), resolution=fine)
    reference = derivative(model, AT, 1e-2, fine)
    np.testing.assert_allclose(found.stiffness, reference, atol=6e-3 * abs(reference).max())


def test_displacement_of_the_form_of_lobes_makes_lobes():
    lobes = tuple(
        replace(land, clearance=1.5 * CLEARANCE, centre=(0.0, dy))
        for land, dy in zip(TWO, (-5e-5, 5e-5), strict=True)
    )
    angles = np.arange(360) * TURN / 360
    rows = 0.5 * CLEARANCE - 5e-5 * np.abs(np.sin(angles))
    formed = bearing(displacement=tuple((row, row) for row in rows))
    one = film_at_position(bearing(lobes), tuple(0.5 * AT), resolution=Resolution(4, 192))
    two = film_at_position(formed, tuple(0.5 * AT), resolution=Resolution(4, 192))
    np.testing.assert_allclose(two.force, one.force, rtol=2e-3)
    np.testing.assert_allclose(two.stiffness, one.stiffness, atol=4e-3 * abs(one.stiffness).max())
    assert two.minimum_film_thickness == pytest.approx(one.minimum_film_thickness, rel=1e-3)


def test_crowning_is_a_displacement_that_is_the_same_all_around():
    drop = (2e-5, 5e-6, 0.0, 5e-6, 2e-5)
    one = film_at_position(bearing(crowning=drop), tuple(AT))
    two = film_at_position(bearing(displacement=(drop,) * 6), tuple(AT))
    np.testing.assert_allclose(two.force, one.force, rtol=1e-12)
    assert one.load < film_at_position(bearing(), tuple(AT)).load  # it gives away gap
    np.testing.assert_allclose(one.end_flows, one.end_flows[::-1], rtol=1e-12)


def test_second_order_in_the_lines_with_steps():
    model = bearing(steps=(Step(4.2, 1.0, 0.05, 6e-5),))
    loads = [film_at_position(model, tuple(AT), resolution=Resolution(4, n, 24)).force for n in (48, 96, 192, 768)]
    errors = [np.linalg.norm(load - loads[-1]) for load in loads[:3]]
    assert errors[0] / errors[2] > 8.0
    assert errors[2] < 2e-4 * np.linalg.norm(loads[-1])


def test_flow_from_open_grooves_converges():
    lands = grooved_bore((0.0, math.pi), 0.3, 2e5)
    flows = [
        film_at_position(bearing(lands), tuple(AT), resolution=Resolution(m, n)).supply_flow.sum()
        for m, n in ((4, 96), (6, 192), (8, 384))
    ]
    assert flows[0] == pytest.approx(flows[2], rel=0.02)
    assert flows[1] == pytest.approx(flows[2], rel=0.006)


@pytest.mark.parametrize(("diameter", "place"), [(3e-3, 0.0), (5e-3, 0.0), (5e-3, 0.015), (10e-3, 0.0)])
def test_flow_from_small_holes_does_not_depend_on_the_grid(diameter, place):
    hole = Pocket.hole(0.5 * math.pi, diameter, DIAMETER, place, 2e5)
    model = bearing(RING, film_start=FilmStart.PERIODIC, pockets=(hole,))
    fine, usual, draft = (
        film_at_position(model, tuple(AT), resolution=grid).supply_flow[0]
        for grid in (Resolution(8, 384), ENGINEERING, DRAFT)
    )
    assert usual == pytest.approx(fine, rel=0.03)
    assert draft == pytest.approx(fine, rel=0.06)


def test_holes_alike_on_both_sides_are_solved_in_half_the_width():
    holes = [Pocket.hole(1.5, 0.005, DIAMETER, z, 2e5) for z in (0.02, -0.02)]
    both = bearing(RING, film_start=FilmStart.PERIODIC, pockets=tuple(holes))
    assert both.is_symmetric
    halved = film_at_position(both, tuple(AT))
    whole = film_at_position(replace(both, misalignment=(1e-14, 0.0)), tuple(AT))
    assert halved.axial_positions[0] == 0.0
    np.testing.assert_allclose(halved.force, whole.force, rtol=5e-3)
    np.testing.assert_allclose(halved.supply_flow, whole.supply_flow, rtol=5e-3)
    assert halved.supply_flow[0] == pytest.approx(halved.supply_flow[1], rel=1e-12)


def test_an_equilibrium_with_every_feature():
    found = solve_journal(featured(), (500.0, -4000.0))
    assert found.outcome.solved
    np.testing.assert_allclose(found.force, (-500.0, 4000.0), atol=0.01)
    assert found.mass_balance_error < 1e-10


@pytest.mark.parametrize(
    "more",
    [
        {"steps": (Step(1.0, 0.0, 0.04, 1e-5),)},
        {"steps": (Step(1.0, 1.0, 0.04, 1e-5, 0.03),)},
        {"side_pressures": (0.0, -1e4)},
    ],
)
def test_what_no_film_can_have_is_refused(more):
    with pytest.raises(InputError, match=r"step|side_pressures"):
        bearing(**more)
