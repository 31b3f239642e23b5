"""Closed (blind) pockets and holes: `flow: 0 L/min`."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest

from babbitt.case import parse_case
from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.film.check import film_check, film_solution
from babbitt.kinds.journal.film.closed_pockets import CLOSED, ClosedPressures, closed_film
from babbitt.kinds.journal.film.field import pressure_on
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.heat.heat_model import FilmHeat
from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at
from babbitt.reynolds.model import JournalFilm, Pocket, Resolution, grooved_bore
from babbitt.study.comparison import compare_methods

TEXT = """
kind: journal
name: Closed pocket
method: film
thermal: full
diameter: 100 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5e-3}
grooves: [{angle: 90 deg, extent: 20 deg}]
pockets: [{angle: 250 deg, extent: 20 deg, width: 24 mm, flow: 0 L/min}]
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.1 MPa}
materials: {bearing: C45, journal: C45}
load: 10 kN
speed: 3000 rpm
accuracy: draft
"""
POCKET = "{angle: 250 deg, extent: 20 deg, width: 24 mm, flow: 0 L/min}"
FINE = Resolution(4, 192)
"""Both films stand on other lines: their grids must not count."""
ANGLE, EXTENT, WIDTH = math.radians(250.0), math.radians(20.0), 0.024


def design(text=TEXT):
    (found,) = parse_case(text).problems()
    return found


def of_model(thermal, text=TEXT):
    return design(text.replace("thermal: full", f"thermal: {thermal}"))


@pytest.fixture(scope="module", params=["adiabatic", "full"])
def heated(request):
    found = film_solution(of_model(request.param))
    return request.param, found.result, found.state


def test_what_reaches_a_closed_pocket_goes_on(heated):
    _, result, state = heated
    assert result.outcome.solved
    assert abs(state.solution.supply_flow[1]) < 1e-6 * result.total_flow
    ((_, fresh),), ((_, back),) = result.arrays["groove_fresh_flows"], result.arrays["groove_returned_flows"]
    assert 0.0 <= fresh < 1e-6 * result.side_flow
    assert 0.0 <= back < 1e-6 * result.side_flow
    assert result.energy_balance_error < 1e-8
    assert result.mass_balance_error < 1e-8


def test_stiffness_with_a_closed_pocket_is_told_as_not_held_against_the_load(heated):
    """The pocket answers a displacement with its pressure, which steps at standing supplies do not know."""
    thermal, result, _ = heated
    unmade = {notice.code: notice.message for notice in result.not_checked}
    assert unmade["C122"] == "closed pockets answer the journal with their pressure"
    assert not {"W135", "W136"} & {notice.code for notice in result.warnings}
    open_one = film_check(of_model(thermal, TEXT.replace("flow: 0 L/min", "pressure: 0.1 MPa")))
    assert "C122" not in {notice.code for notice in open_one.not_checked}


def test_its_pressure_lies_between_those_of_the_film_around_it(heated):
    _, result, state = heated
    ((groove, closed),) = result.arrays["groove_pressures"]
    assert groove == 0.1e6
    before, behind = (ANGLE + side * (0.5 * EXTENT + math.radians(10.0)) for side in (-1.0, 1.0))
    around = pressure_on(state.solution, np.array([before, behind]), np.linspace(-0.5, 0.5, 5) * WIDTH)
    assert around.min() < closed < around.max()
    inside = pressure_on(state.solution, np.array([ANGLE]), np.array([0.0]))
    assert float(inside[0, 0]) == pytest.approx(closed, rel=1e-6)


def test_its_oil_is_that_of_the_film(heated):
    """Neither as cold as fresh oil nor hotter than the film."""
    _, result, _ = heated
    ((groove, closed),) = result.arrays["groove_temperatures"]
    assert groove < closed < result.maximum_temperature
    assert closed > result.supply_temperature + 5.0


def test_the_same_pressure_given_makes_the_same_film_and_more_brings_fresh_oil(heated):
    thermal, result, _ = heated
    closed = result.arrays["groove_pressures"][0][1]

    def fed(pressure, more=""):
        return film_check(of_model(thermal, TEXT.replace("flow: 0 L/min", f"pressure: {pressure} Pa") + more))

    same, more, flushed = fed(closed), fed(1.3 * closed), fed(closed, "carry_over: 0\n")
    assert same.maximum_temperature == pytest.approx(result.maximum_temperature, abs=0.05)
    assert same.minimum_film_thickness == pytest.approx(result.minimum_film_thickness, rel=1e-3)
    assert more.arrays["groove_fresh_flows"][0][1] > 0.01 * result.side_flow
    assert more.arrays["groove_temperatures"][0][1] < result.arrays["groove_temperatures"][0][1] - 1.0
    assert flushed.maximum_temperature < result.maximum_temperature - 1.0


def test_reversed_rotation_mirrors_it(heated):
    thermal, result, _ = heated
    mirrored = film_check(of_model(thermal, TEXT.replace("3000", "-3000").replace("angle: 250", "angle: 290")))
    here, there = result.arrays["groove_pressures"][0], mirrored.arrays["groove_pressures"][0]
    assert there == pytest.approx(here, rel=1e-6)


def test_with_one_viscosity_the_pressure_is_that_of_the_film_of_one_temperature():
    viscosity, position = 0.02, (20e-6, -40e-6)
    film = JournalFilm(
        0.1, 0.06, 75e-6, viscosity, 300.0, grooved_bore((0.5 * math.pi,), 0.35, 1e5),
        pockets=(Pocket(ANGLE, EXTENT, WIDTH),),
    )  # fmt: skip
    heat = FilmHeat(lambda kelvin: np.full(np.shape(kelvin), viscosity), 1.7e6, 0.13, 320.0)
    found, known = [], ClosedPressures()
    for settle, film_in in (
        (lambda one: film_at_position(one, position, resolution=FINE), lambda one: one),
        (lambda one: thermal_film_at(one, heat, position, FINE, 1e-5), lambda one: one.film),
    ):
        known = ClosedPressures()
        solution = closed_film(
            film, [0], settle, film_in, lambda one, _: pytest.fail(f"no film: {one}"), known,
            lambda one, settle=settle, film_in=film_in: film_in(settle(one)),
        )  # fmt: skip
        assert abs(film_in(solution).supply_flow[1]) < CLOSED * film_in(solution).leaving_flow
        found.append(float(known.pressures[0]))
    assert found[1] == pytest.approx(found[0], rel=1e-3)
    assert found[0] > 1e5


def test_stiffness_and_damping_let_the_pressure_follow():
    """As films with closed pockets at places beside, and at velocities; a held pocket is softer."""
    film = JournalFilm(
        0.1, 0.06, 75e-6, 0.02, 300.0, grooved_bore((0.5 * math.pi,), 0.35, 1e5),
        pockets=(Pocket(ANGLE, EXTENT, WIDTH, closed=True),),
    )  # fmt: skip
    place, known = np.array([20e-6, -40e-6]), ClosedPressures()

    def closed(at, velocity=(0.0, 0.0)):
        def settle(one):
            return film_at_position(one, tuple(at), tuple(velocity), resolution=FINE)

        return closed_film(
            film, [0], settle, lambda one: one, lambda one, _: pytest.fail(f"no film: {one}"), known, settle
        )

    found = closed(place)
    for push, axes, coefficient in ((1e-7, 0, found.stiffness), (1e-4, 1, found.damping)):
        columns = []
        for direction in np.eye(2):
            ends = [
                closed(place + sign * push * direction) if axes == 0 else closed(place, sign * push * direction)
                for sign in (1.0, -1.0)
            ]
            columns.append(-(ends[0].force - ends[1].force) / (2.0 * push))
        assert coefficient == pytest.approx(np.array(columns).T, abs=0.02 * np.abs(coefficient).max())
    (pocket,) = found.film.pockets
    held = film_at_position(
        replace(found.film, pockets=(replace(pocket, closed=False),)), tuple(place), resolution=FINE
    )
    assert held.force == pytest.approx(found.force)
    assert found.stiffness[1, 1] > 1.2 * held.stiffness[1, 1]
    assert found.damping[1, 1] > 1.1 * held.damping[1, 1]


def test_temperatures_that_follow_leave_the_pocket_closed():
    following = film_check(design(TEXT + "temperature_coefficients: following\n"))
    assert "W147" not in {one.code for one in following.warnings}
    frozen, moving = (np.array(following.arrays[name]) for name in ("frozen_stiffness", "stiffness"))
    assert moving == pytest.approx(frozen, abs=0.15 * np.abs(frozen).max())


def test_a_small_hole_that_is_closed_takes_the_pressure_of_the_film():
    """And with one temperature, too."""
    hole = "holes: [{angle: 250 deg, diameter: 2 mm, flow: 0 L/min}]"
    plain = TEXT.replace(f"pockets: [{POCKET}]\n", "").replace("draft", "engineering")
    alone = film_solution(of_model("global", plain)).state.solution
    closed = film_check(of_model("global", f"{plain}{hole}\n"))
    expected = float(pressure_on(alone, np.array([ANGLE]), np.array([0.0]))[0, 0])
    assert closed.arrays["groove_pressures"][0][1] == pytest.approx(expected, rel=0.02)
    assert closed.minimum_film_thickness == pytest.approx(alone.minimum_film_thickness, rel=0.01)


def test_several_keep_a_pressure_each_and_images_in_the_mid_plane_the_same():
    others = "{angle: 200 deg, extent: 20 deg, width: 24 mm, flow: 0 L/min}"
    several = film_solution(design(TEXT.replace(POCKET, f"{POCKET}, {others}"))).state
    assert np.abs(several.solution.supply_flow[1:]).max() < 1e-6 * several.total_flow
    first, second = (pocket.pressure for pocket in several.solution.film.pockets)
    assert first > 2.0 * second > 0.0
    image = "{angle: 240 deg, extent: 15 deg, width: 15 mm, axial_position: 15 mm, flow: 0 L/min}"
    twins = film_solution(design(TEXT.replace(POCKET, f"{image}, {image.replace('n: 15', 'n: -15')}"))).state
    first, second = (pocket.pressure for pocket in twins.solution.film.pockets)
    assert first == second > 0.0
    assert twins.solution.film.is_symmetric
    assert np.abs(twins.solution.supply_flow[1:]).max() < 1e-6 * twins.total_flow


@pytest.mark.parametrize(
    "given",
    [("load: 10 kN", "eccentricity_ratio: 0.6"), ("load: 10 kN", "position: {x: 30 um, y: -30 um}")],
    ids=["eccentricity", "position"],
)
def test_a_closed_pocket_under_a_prescribed_place(given):
    result = film_check(of_model("adiabatic", TEXT.replace(*given)))
    assert result.outcome.solved
    assert abs(result.arrays["groove_fresh_flows"][0][1]) < 1e-6 * result.side_flow
    assert result.arrays["groove_pressures"][0][1] > 1e6


def test_a_bore_that_gives_way_keeps_it_closed():
    column = "compliance: [{kind: column, thickness: 2 mm, elastic_modulus: 1 GPa, poisson_ratio: 0.3}]\n"
    state = film_solution(design(TEXT + column)).state
    assert abs(state.solution.supply_flow[1]) < 1e-6 * state.total_flow


@pytest.mark.parametrize("thermal", ["global", "full"])
def test_a_pocket_that_runs_empty_is_no_answer(thermal):
    """In the ruptured film behind the load streamers arrive, and a full gap would leave."""
    result = film_check(of_model(thermal, TEXT.replace("angle: 250", "angle: 20")))
    assert result.outcome is Outcome.STARVED_RECESS
    assert result.outcome.code == "S302"
    assert "runs empty" in result.message
    assert set(result.values) == {"wall_time"}
    assert not result.arrays


def test_a_supply_of_given_flow_and_a_closed_pocket_go_together_at_one_temperature():
    fed = "{angle: 20 deg, extent: 20 deg, width: 24 mm, flow: 0.3 L/min}"
    warm = "isothermal\neffective_temperature: 55 degC"
    result = film_check(of_model(warm, TEXT.replace(POCKET, f"{POCKET}, {fed}")))
    assert result.outcome.solved
    assert result.given_flow == pytest.approx(0.3 / 6e4)
    assert result.arrays["groove_pressures"][0][1] > 1e6


def test_models_of_heat_are_compared_for_it():
    (page,) = compare_methods(parse_case(TEXT))
    labels = {one.label: one.result.outcome for one in page.variants}
    assert labels["adiabatic film"] is labels["full thermal film"] is Outcome.CONVERGED
    assert labels["film, one temperature"] is Outcome.CONVERGED


@dataclass(frozen=True)
class Network:
    """Pockets whose net flows are linear in their pressures, as if they were a film."""

    supply_flow: np.ndarray
    outcome: Outcome = Outcome.CONVERGED
    leaving_flow: float = 1.0
    maximum_pressure: float = 3e6


SLOPES = np.array([[3.0, -1.0, -0.2], [-1.0, 2.0, -0.5], [-0.2, -0.5, 1.0]]) * 1e-7


def closed_network(wanted, most=math.inf):
    """Film of a network whose pressures are to become those wanted; above ``most`` it has no film."""
    film = JournalFilm(
        0.1, 0.06, 75e-6, 0.02, 300.0, grooved_bore((0.5 * math.pi,), 0.35),
        pockets=tuple(Pocket(angle, 0.1, 0.02) for angle in (3.0, 4.0, 5.0)),
    )  # fmt: skip
    seen, known = [], ClosedPressures()

    def settle(one):
        pressures = np.array([pocket.pressure for pocket in one.pockets])
        seen.append(pressures)
        if pressures.max() > most:
            raise NoFilmError(Outcome.OVERLOADED)
        return Network(np.concatenate(([0.5], SLOPES @ (pressures - np.asarray(wanted)))))

    def without(_):
        raise NoFilmError(Outcome.OVERLOADED)

    found = closed_film(
        film, range(3), settle, lambda one: one, lambda one, outcome: replace(one, outcome=outcome), known, without
    )
    return found, known, seen


def test_pockets_that_answer_each_other_are_closed_together():
    found, known, seen = closed_network((2e6, 1e6, 5e5))
    assert found.outcome.solved
    assert known.pressures == pytest.approx((2e6, 1e6, 5e5), rel=1e-5)
    assert len(seen) < 20


def test_pressures_without_film_are_kept_away_from():
    found, known, seen = closed_network((2e6, 1e6, 5e5), most=2.05e6)
    assert found.outcome.solved
    assert known.pressures == pytest.approx((2e6, 1e6, 5e5), rel=1e-5)
    lost, _, _ = closed_network((2e6, 1e6, 5e5), most=1.9e6)
    assert lost.outcome is Outcome.NOT_CONVERGED
    assert len(seen) < 30


def test_one_that_runs_empty_is_told_of_among_others():
    """At cavitation pressure it still gives; the others are closed beside it."""
    found, known, _ = closed_network((2e6, 1e6, -3e6))
    assert found.outcome is Outcome.STARVED_RECESS
    assert known.pressures[2] == 0.0
    assert np.abs(found.supply_flow[1:3]).max() < CLOSED
    assert found.supply_flow[3] > CLOSED


FED_BY_NOTHING = """
kind: journal
name: Blind
method: iso7902
diameter: 100 mm
width: 80 mm
clearance: {kind: relative, mean: 1.5 permille}
lubricant: ISO VG 32
supply: {temperature: 45 degC, pressure: 0.1 MPa}
materials: {bearing: C10, journal: C45}
load: 10 kN
speed: 3000 rpm
pockets: [{angle: 250 deg, extent: 20 deg, width: 24 mm, flow: 0 L/min}]
span: 180 deg
supply_element: {kind: groove_180, width: 8 mm}
accuracy: draft
"""


@pytest.mark.thorough
def test_films_that_nothing_feeds_end_with_a_status_beside_the_standard():
    (found,) = compare_methods(parse_case(FED_BY_NOTHING))
    results = {one.label: one.result for one in found.variants}
    assert results["ISO 7902"].outcome.solved
    assert not results["full thermal film"].outcome.solved
    assert results["full thermal film"].message
