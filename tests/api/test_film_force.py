"""The force of a film at a place, against the solution that it belongs to and against its own derivatives."""

from __future__ import annotations

import math

import numpy as np
import pytest
from front_door_cases import result_of

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.many_positions import FilmPositions
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import (
    DRAFT,
    ENGINEERING,
    Cavitation,
    FilmStart,
    JournalFilm,
    Land,
    Pocket,
    grooved_bore,
)
from babbitt.reynolds.surface import surface_solution

LANDS = grooved_bore((0.0, math.pi), math.radians(20.0))
FILMS = {
    "grooved": JournalFilm(0.2, 0.12, 150e-6, 0.02, 300.0, LANDS),
    "clockwise": JournalFilm(0.2, 0.12, 150e-6, 0.02, -300.0, LANDS, Cavitation.REYNOLDS),
    "suction": JournalFilm(0.2, 0.12, 150e-6, 0.02, 300.0, LANDS, cavitation_pressure=-5e4),
    "pressure-fed": JournalFilm(
        0.2, 0.12, 150e-6, 0.02, 300.0, grooved_bore((0.0, math.pi), math.radians(20.0), 1e5)
    ),
    "widest gap": JournalFilm(
        0.2, 0.12, 150e-6, 0.02, 300.0, (Land(-math.pi, math.pi),), Cavitation.REYNOLDS, FilmStart.WIDEST_GAP
    ),
    "lemon": JournalFilm(
        0.2, 0.12, 150e-6, 0.02, 300.0,
        (Land(0.2, 2.9, 200e-6, (0.0, -60e-6)), Land(3.3, 6.1, 200e-6, (0.0, 60e-6))),
    ),
}  # fmt: skip
BY_LOOP = {"grooved", "clockwise", "suction", "lemon"}


@pytest.mark.parametrize("name", FILMS)
def test_many_positions_are_those_of_single_films(name: str) -> None:
    film = FILMS[name]
    positions = FilmPositions(film, DRAFT)
    assert positions.by_loop == (name in BY_LOOP)
    places = np.array([[2e-5, -6e-5, 0.0, 0.0], [-3e-5, 1e-5, 2e-3, -1e-3], [0.0, -9e-5, 0.0, 4e-3]])
    forces, found = positions.forces(places), positions.coefficients(places)
    for row, (x, y, vx, vy) in enumerate(places):
        one = film_at_position(film, (x, y), (vx, vy), DRAFT)
        assert found.settled[row] == forces.settled[row] == one.outcome.solved
        assert found.force[row] == pytest.approx(one.force, rel=1e-9, abs=1e-6)
        assert forces.force[row] == pytest.approx(one.force, rel=2e-3, abs=2e-3 * one.load)
        assert found.stiffness[row] == pytest.approx(one.stiffness, rel=1e-9)
        assert found.damping[row] == pytest.approx(one.damping, rel=1e-9)


FED = grooved_bore((0.0, math.pi), math.radians(20.0), 1e5)
BY_NODES = {
    "pressure-fed": FILMS["pressure-fed"],
    "clockwise": JournalFilm(0.2, 0.12, 150e-6, 0.02, -300.0, FED, Cavitation.REYNOLDS),
    "tilted": JournalFilm(0.2, 0.12, 150e-6, 0.02, 300.0, LANDS, misalignment=(1e-4, -2e-4)),
    "closed pocket": JournalFilm(
        0.2, 0.12, 150e-6, 0.02, 300.0, FED, pockets=(Pocket(-1.5, 0.3, 0.03, pressure=2e6, closed=True),)
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", BY_NODES)
def test_node_by_node_a_force_is_found_without_the_rest_of_a_solution(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    film = BY_NODES[name]
    places = np.array([[2e-5, -6e-5, 0.0, 0.0], [-3e-5, 1e-5, 2e-3, -1e-3], [2e-5, -6e-5, 0.0, 0.0]])
    single = [film_at_position(film, tuple(place[:2]), tuple(place[2:]), DRAFT) for place in places]
    monkeypatch.setattr(surface_solution, "solution_of", None)
    found = FilmPositions(film, DRAFT).coefficients(places)
    for row, one in enumerate(single):
        assert np.array_equal(found.force[row], one.force)
        assert found.stiffness[row] == pytest.approx(one.stiffness, rel=1e-13)
        assert found.damping[row] == pytest.approx(one.damping, rel=1e-13)
    assert found.settled.all()
    assert FilmPositions(film, DRAFT).forces(np.array([[1e-3, 0.0, 0.0, 0.0]])).outside.all()


@pytest.mark.parametrize("name", ["grooved", "clockwise", "lemon", "pressure-fed"])
def test_the_film_at_its_place_of_rest_carries_the_load(name: str) -> None:
    one = result_of(name)
    force = one.film.force(*one.film.position)
    load = one.load * np.array([math.cos(one.load_angle), math.sin(one.load_angle)])
    assert force + load == pytest.approx(np.zeros(2), abs=1e-4 * one.load)
    stiffness, damping = one.film.linearise(*one.film.position)
    assert np.abs(stiffness - one.stiffness).max() < 2e-3 * np.abs(one.stiffness).max()
    assert np.abs(damping - one.damping).max() < 2e-3 * np.abs(one.damping).max()


@pytest.mark.parametrize("name", ["elastic", "starved"])
def test_bore_and_supplies_stay_as_they_were_solved(name: str) -> None:
    one = result_of(name)
    assert one.film.force(*one.film.position) == pytest.approx([0.0, one.load], abs=1e-3 * one.load)


@pytest.mark.parametrize("name", ["grooved", "clockwise", "lemon", "pressure-fed"])
def test_stiffness_and_damping_are_derivatives_of_the_force(name: str) -> None:
    film = result_of(name).film
    (x, y), step, rate = film.position + np.array([4e-6, 7e-6]), 2e-7, 1e-4
    stiffness, damping = film.linearise(x, y)
    moves = np.array([[step, 0.0], [0.0, step]])
    by_move = np.array([film.force(x + dx, y + dy) - film.force(x - dx, y - dy) for dx, dy in moves]).T / (
        2.0 * step
    )
    along = np.array([[rate, 0.0], [0.0, rate]])
    by_rate = np.array([film.force(x, y, vx, vy) - film.force(x, y, -vx, -vy) for vx, vy in along]).T / (
        2.0 * rate
    )
    assert np.abs(stiffness + by_move).max() < 0.03 * np.abs(stiffness).max()  # the draft grid rounds the rupture
    assert np.abs(damping + by_rate).max() < 0.03 * np.abs(damping).max()


def test_a_symmetric_bearing_answers_mirrored_motion_with_mirrored_force() -> None:
    """Turning a bearing with opposite grooves by half a turn changes nothing."""
    film = result_of("grooved").film
    here, opposite = film.force(2e-5, -5e-5, 1e-3, 2e-3), film.force(-2e-5, 5e-5, -1e-3, -2e-3)
    assert here == pytest.approx(-opposite, rel=1e-6)


def test_squeezing_the_film_adds_to_its_force() -> None:
    film = result_of("grooved").film
    rest, squeezed = film.force(0.0, -5e-5), film.force(0.0, -5e-5, 0.0, -1e-2)
    assert squeezed[1] > rest[1] > 0.0


def whirling(film: JournalFilm, count: int, eccentricity: float = 0.95, growth: float = 0.3) -> np.ndarray:
    """Random places and velocities of a journal that whirls at -0.2 to 1 of its speed, and moves in and out."""
    draw, c, omega = np.random.default_rng(7), film.clearance, film.angular_speed
    distance, angle = c * draw.uniform(0.05, eccentricity, count), draw.uniform(0.0, 2.0 * np.pi, count)
    along, out = draw.uniform(-0.2, 1.0, count) * omega * distance, growth * c * omega * draw.normal(size=count)
    cos, sin = np.cos(angle), np.sin(angle)
    return np.stack((distance * cos, distance * sin, out * cos - along * sin, out * sin + along * cos), axis=1)


@pytest.mark.parametrize("name", sorted(BY_LOOP))
def test_a_journal_that_whirls_anyhow_finds_its_film(name: str) -> None:
    """Where a groove feeds a gap that converges while it opens, lines behind it were full if dry and dry if full.

    The force changes with the place by its stiffness, which fine grids know: without jumps from one wet set to
    another.
    """
    film = FILMS[name]
    places = whirling(film, 3000, 0.85 if name == "lemon" else 0.95)  # its walls stand closer
    loop = FilmPositions(film, ENGINEERING)
    here = loop.forces(places)
    assert here.settled.all()
    step = 1e-5 * np.array([1.0, -1.0, 1.0, -1.0]) * film.clearance * np.array([1.0, 1.0, 300.0, 300.0])
    apart = np.linalg.norm(loop.forces(places + step).force - here.force, axis=1)
    assert apart.max() < 5e-3 * np.linalg.norm(here.force, axis=1).max()
    assert np.median(apart / np.linalg.norm(here.force, axis=1)) < 2e-4


@pytest.mark.parametrize("name", ["pressure-fed", "tilted"])
def test_node_by_node_a_journal_that_whirls_anyhow_finds_its_film(name: str) -> None:
    film = BY_NODES[name]
    assert FilmPositions(film, DRAFT).forces(whirling(film, 60, 0.7)).settled.all()


def test_a_film_born_by_squeeze_holds_its_conditions() -> None:
    """Eccentricity 0.70, whirl 0.55 of the speed: no suction, no more oil than fits, and oil is conserved."""
    x, y, vx, vy = 1.923e-5, -1.0305e-4, 1.849e-2, -1.308e-4
    found = film_at_position(FILMS["grooved"], (x, y), (vx, vy), ENGINEERING)
    assert found.outcome.solved
    assert found.pressure.min() >= -1e-9 * found.pressure.max()
    assert found.void.min() >= 0.0
    assert (found.pressure * found.void).max() == 0.0
    assert found.mass_balance_error < 1e-6


def test_arrays_broadcast_and_agree_with_single_calls() -> None:
    film = result_of("grooved").film
    x, y = np.linspace(-5e-5, 5e-5, 3)[:, None], np.linspace(-8e-5, 0.0, 4)
    found = film.force(x, y, 0.0, 1e-3)
    assert found.shape == (3, 4, 2)
    for place in np.ndindex(3, 4):
        assert np.array_equal(found[place], film.force(x[place[0], 0], y[place[1]], 0.0, 1e-3))
    assert film.force(0.0, -5e-5).shape == (2,)
    assert film.force(np.zeros(0), 0.0).shape == (0, 2)
    stiffness, damping = film.linearise(x, y)
    assert stiffness.shape == damping.shape == (3, 4, 2, 2)


@pytest.mark.parametrize("name", ["grooved", "pressure-fed"])
def test_a_place_outside_the_clearance_is_told(name: str) -> None:
    film = result_of(name).film
    with pytest.raises(InputError, match="outside the clearance"):
        film.force(0.0, -1e-3)
    with pytest.raises(InputError, match=r"y = -1000 µm"):
        film.force([0.0, 0.0], [0.0, -1e-3])
    with pytest.raises(InputError, match="outside the clearance"):
        film.linearise(0.0, -1e-3)


def test_contact_takes_over_outside_the_clearance() -> None:
    film = result_of("grooved").film

    def wall(x: np.ndarray, y: np.ndarray, vx: np.ndarray, vy: np.ndarray) -> np.ndarray:
        assert x.shape == (1,)
        return -1e9 * np.stack((x, y), axis=-1)

    found = film.force([0.0, 0.0], [-5e-5, -1e-3], contact=wall)
    assert found[0] == pytest.approx(film.force(0.0, -5e-5))
    assert found[1] == pytest.approx([0.0, 1e6])


@pytest.mark.parametrize("bad", [math.nan, math.inf])
@pytest.mark.parametrize("name", ["grooved", "pressure-fed"])
def test_a_place_that_is_no_number_is_refused(name: str, bad: float) -> None:
    film = result_of(name).film
    for place in ((bad, 0.0), (0.0, bad), (0.0, 0.0, bad), (0.0, 0.0, 0.0, bad)):
        with pytest.raises(InputError, match="not a finite number"):
            film.force(*place)
    with pytest.raises(InputError, match="not a finite number"):
        film.linearise(bad, 0.0)


@pytest.mark.parametrize("name", FILMS)
def test_the_engine_refuses_a_position_that_is_no_number(name: str) -> None:
    with pytest.raises(InputError, match="must be finite"):
        film_at_position(FILMS[name], (math.nan, 0.0), resolution=DRAFT)
    with pytest.raises(InputError, match="must be finite"):
        film_at_position(FILMS[name], (0.0, 0.0), (0.0, math.nan), resolution=DRAFT)


def test_fields_are_those_of_the_solution() -> None:
    one = result_of("grooved")
    film, solution = one.film, one.solution.state.solution
    assert film.pressure.shape == (film.angle.size, film.z.size) == film.gap.shape
    assert film.angle[-1] - film.angle[0] == pytest.approx(2.0 * math.pi)
    assert film.pressure.max() == pytest.approx(solution.maximum_pressure, rel=1e-3)
    assert np.nanmin(film.film_thickness) == pytest.approx(one.minimum_film_thickness, rel=1e-3)
    assert np.isnan(film.film_thickness).any()
    bare = np.isnan(film.gap).all(axis=1)  # over axial grooves, of which nodes at their edges tell
    assert bare.sum() <= 4
    assert np.isfinite(film.gap[~bare]).all()
    assert film.gap[~bare].max() < 2.0 * film.gap[~bare].mean()
    assert film.liquid_fraction.min() >= 0.0
    assert film.liquid_fraction.max() == 1.0
    # the pressure carries the load: integrated over the bore
    radius = 0.5 * one.diameter
    axial = np.trapezoid(film.pressure, film.z, axis=1) * radius
    force = [-np.trapezoid(axial * wave(film.angle), film.angle) for wave in (np.cos, np.sin)]
    assert math.hypot(*force) == pytest.approx(one.load, rel=2e-2)


def test_a_method_without_film_says_which_has_one() -> None:
    assert not hasattr(result_of("iso7902"), "film")
    with pytest.raises(AttributeError, match="iso7902 has no film to show; the method film has one"):
        _ = result_of("iso7902").film
    with pytest.raises(AttributeError, match="keep='solutions'"):
        _ = result_of("grooved").without_state().film


def test_what_there_is_of_a_film_is_listed() -> None:
    film = result_of("grooved").film
    assert {"pressure", "force", "linearise", "angle"} <= set(dir(film))
    assert "pressure" in repr(film)
    assert len(repr(film).splitlines()) < 25


@pytest.mark.slow
def test_a_thermal_film_keeps_its_viscosity_where_it_moves() -> None:
    one = result_of("thermal")
    assert one.film.force(*one.film.position) == pytest.approx([0.0, one.load], abs=1e-3 * one.load)
    stiffness, damping = one.film.linearise(*one.film.position)
    assert np.abs(stiffness - one.stiffness).max() < 2e-2 * np.abs(one.stiffness).max()
    assert np.abs(damping - one.damping).max() < 2e-2 * np.abs(one.damping).max()
    again = one.film.force(*one.film.position)
    one.film.force(0.0, -2e-5)
    assert np.array_equal(one.film.force(*one.film.position), again)  # the solution is not worked upon


def test_a_place_where_the_film_does_not_settle_is_not_a_number(monkeypatch: pytest.MonkeyPatch) -> None:
    film = result_of("grooved").film
    here = film.force(0.0, -5e-5)
    forces = FilmPositions.forces

    def one_lost(positions: FilmPositions, places: np.ndarray) -> object:
        found = forces(positions, places)
        found.settled[0] = False
        return found

    monkeypatch.setattr(FilmPositions, "forces", one_lost)
    with pytest.warns(RuntimeWarning, match=r"1 of 2 places, the first at x = 0 µm, y = -50 µm with vx = 0 mm/s"):
        found = film.force([0.0, 0.0], [-5e-5, -5e-5])
    assert np.isnan(found[0]).all()
    assert found[1] == pytest.approx(here)


def test_the_force_of_closed_pockets_is_refused() -> None:
    """Their pressures follow the journal; held, the slope of the force is half the stiffness or less."""
    film = result_of("closed pocket").film
    with pytest.raises(InputError, match="closed pockets"):
        film.force(0.0, -1e-5)
